//! Slices in and out, lengths that do not fit, whole fields, views.
use crate::refused;
use contdyn::*;

fn rope(precision: Precision) -> (Chain, Vec<f64>) {
    let mut made = Chain::new(2, 3, 2, precision).unwrap();
    let positions: Vec<f64> = (1..=16).map(|k| f64::from(k) / 8.0).collect();
    made.write(Field::Position, &positions).unwrap();
    (made, positions)
}

#[test]
fn reads_give_what_was_written() {
    for precision in Precision::ALL {
        let (made, positions) = rope(precision);
        assert_eq!(made.read::<f64>(Field::Position).unwrap(), positions);
        let singles: Vec<f32> = positions.iter().map(|x| *x as f32).collect();
        assert_eq!(made.read::<f32>(Field::Position).unwrap(), singles);
        let mut part = [0.0; 4];
        made.read_f64(Field::Position, 1, 1, 2, 2, &mut part).unwrap();
        assert_eq!(part, positions[12..]);
        let mut other = Chain::new(2, 3, 2, precision).unwrap();
        other.write(Field::Position, &singles).unwrap();
        assert_eq!(other.hash().unwrap(), made.hash().unwrap());
    }
}

macro_rules! every_field_is_read_whole {
    ($made:expr, $checked:expr) => {
        for field in Field::ALL {
            match $made.enable_field(field) {
                Ok(()) => {
                    let values = $made.read::<f64>(field).unwrap();
                    assert!(!values.is_empty());
                    assert_eq!(values.len(), $made.get_size(field).unwrap());
                    $checked += 1;
                }
                Err(error) => {
                    let none = matches!(error.status(), Some(Status::ErrorUnsupported | Status::ErrorEnum));
                    assert!(none, "{error}");
                }
            }
        }
    };
}

#[test]
fn sizes_of_whole_fields_are_those_that_the_library_has() {
    let mut checked = 0;
    for variant in 0..3 {
        let mut chain = Chain::new(2, 5, 3, Precision::Float64).unwrap();
        let mut sheet = Membrane::new(4, 3, 3, Precision::Float64).unwrap();
        let mut pool = Water::new(5, 4, 0.5, 0.25, Precision::Float64).unwrap();
        if variant == 1 {
            chain.set_ring(true).unwrap();
            sheet.set_ring(true, true).unwrap();
        }
        if variant == 2 {
            chain.set_rest_length(1.0).unwrap();
            sheet.set_rest_length(1.0, 1.0).unwrap();
        }
        every_field_is_read_whole!(chain, checked);
        every_field_is_read_whole!(sheet, checked);
        every_field_is_read_whole!(pool, checked);
    }
    assert!(checked > 60);
    let (made, _) = rope(Precision::Float64);
    refused(made.get_size(Field::Depth), Status::ErrorEnum, "cd_chain_read_f64");
    refused(made.read::<f32>(Field::Depth), Status::ErrorEnum, "cd_chain_read_f32");
}

#[test]
fn sizes_of_rings_ropes_and_faces() {
    let mut chain = Chain::new(2, 5, 3, Precision::Float64).unwrap();
    let mut sheet = Membrane::new(4, 3, 3, Precision::Float64).unwrap();
    let pool = Water::new(5, 4, 1.0, 1.0, Precision::Float64).unwrap();
    let of_chain = |made: &Chain| [Field::Position, Field::Mass, Field::Stiffness].map(|f| made.get_size(f).unwrap());
    let of_sheet =
        |made: &Membrane| [Field::Position, Field::StiffnessU, Field::StiffnessV].map(|f| made.get_size(f).unwrap());
    assert_eq!(of_chain(&chain), [36, 6, 5]);
    assert_eq!(chain.get_size(Field::Bend), Ok(6));
    chain.set_ring(true).unwrap();
    assert_eq!(of_chain(&chain), [36, 6, 6]);
    chain.set_ring(false).unwrap();
    chain.set_rest_length(1.0).unwrap();
    assert_eq!(of_chain(&chain), [36, 12, 10]);
    assert_eq!(of_sheet(&sheet), [60, 16, 15]);
    sheet.set_ring(true, false).unwrap();
    assert_eq!(of_sheet(&sheet), [60, 20, 15]);
    sheet.set_ring(false, true).unwrap();
    assert_eq!(of_sheet(&sheet), [60, 16, 20]);
    let sizes = [Field::Depth, Field::VelocityX, Field::VelocityY].map(|f| pool.get_size(f).unwrap());
    assert_eq!(sizes, [20, 24, 25]);
}

#[test]
fn results() {
    let (mut made, _) = rope(Precision::Float64);
    made.set_gravity(&[0.0, -9.81]).unwrap();
    let mut gravity = [0.0; 2];
    made.get_gravity(&mut gravity).unwrap();
    assert_eq!(gravity, [0.0, -9.81]);
    let ChainEnergy { kinetic, elastic, .. } = made.get_energy().unwrap();
    assert!(kinetic == 0.0 && elastic > 0.0);
    let mut pool = Water::new(4, 4, 1.0, 1.0, Precision::Float64).unwrap();
    pool.write(Field::Depth, &[2.0; 16]).unwrap();
    let (mut depth, mut normal) = ([0.0; 2], [0.0; 6]);
    pool.sample(&[1.0, 1.0, 2.0, 2.5], Outside::Refused, None, Some(&mut depth), Some(&mut normal), None).unwrap();
    assert_eq!(depth, [2.0; 2]);
    assert_eq!(normal, [0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let mut vertices = [0u8; 16 * 12];
    pool.write_vertices(&mut vertices, 12, 0, usize::MAX, usize::MAX).unwrap();
    assert!(vertices.iter().any(|byte| *byte != 0));
}

#[test]
fn lengths_that_do_not_fit() {
    let (mut made, _) = rope(Precision::Float64);
    refused(made.set_gravity(&[1.0; 3]), Status::ErrorRange, "cd_chain_set_gravity: count is 3");
    refused(made.write(Field::Position, &[1.0; 3]), Status::ErrorRange, "cd_chain_write_f64");
    let plane = made.set_plane(0, &[0.0; 2], &[1.0, 0.0, 0.0], 0.0);
    refused(plane, Status::ErrorRange, "normal has 3 numbers, must have 2");
    let pool = Water::new(4, 4, 1.0, 1.0, Precision::Float64).unwrap();
    let odd = pool.sample(&[1.0; 3], Outside::Refused, None, None, None, None);
    refused(odd, Status::ErrorRange, "at has 3 numbers, must be a multiple of 2");
    let long = pool.sample(&[1.0; 2], Outside::Nearest, None, Some(&mut [0.0; 3]), None, None);
    refused(long, Status::ErrorRange, "out_depth has 3 numbers, must have 1");
}

#[test]
fn views_show_what_reads_give() {
    for precision in Precision::ALL {
        let (mut made, _) = rope(precision);
        made.set_gravity(&[0.0, -1.0]).unwrap();
        for _ in 0..3 {
            let copy = made.read::<f64>(Field::Position).unwrap();
            let at = made.view(Field::Position).unwrap();
            assert_eq!((at.extents(), at.precision()), ([2, 4, 2], precision));
            for strand in 0..2 {
                for node in 0..4 {
                    for component in 0..2 {
                        assert_eq!(at.at(strand, node, component), copy[strand * 8 + node * 2 + component]);
                    }
                }
            }
            for (i, j, k) in [(2, 0, 0), (0, 4, 0), (0, 0, 2), (usize::MAX, 0, 0)] {
                assert_eq!(at.get(i, j, k), None);
            }
            made.step(0.5, 1).unwrap();
        }
    }
    let mut sheet = Membrane::new(4, 2, 1, Precision::Float32).unwrap();
    sheet.write_f64(Field::Position, 3, 1, 1, 1, &[5.0]).unwrap();
    assert_eq!(sheet.view(Field::Position).unwrap().at(3, 1, 0), 5.0);
    let mut pool = Water::new(4, 3, 1.0, 1.0, Precision::Float32).unwrap();
    pool.write_f32(Field::Depth, 3, 2, 1, 1, &[7.0]).unwrap();
    assert_eq!(pool.view(Field::Depth).unwrap().at(3, 2, 0), 7.0);
    assert!(pool.view(Field::Surface).is_err());
}

#[test]
#[should_panic(expected = "no place (0, 9, 0) in 2 x 4 x 2")]
fn a_place_outside_a_view() {
    rope(Precision::Float64).0.view(Field::Position).unwrap().at(0, 9, 0);
}
