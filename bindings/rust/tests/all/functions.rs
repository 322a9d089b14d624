//! Every method is called, with success; getters tell what setters were given.
use crate::every_function::*;
use contdyn::*;

pub struct Call<T> {
    pub name: &'static str,
    pub may_fail: bool,
    pub call: fn(&mut T, &T, &[u8]) -> Result<()>,
    /// Whether the getter tells what the setter was given.
    pub told: fn(&T) -> bool,
}

fn sweep<T>(calls: &[Call<T>], make: fn() -> T, lengthen: fn(&mut T), save: fn(&T) -> Vec<u8>) {
    for entry in calls {
        let other = make();
        let saved = save(&other);
        let mut object = make();
        let mut result = (entry.call)(&mut object, &other, &saved);
        let status = result.as_ref().err().and_then(Error::status);
        if matches!(status, Some(Status::ErrorUnsupported | Status::ErrorRange)) {
            object = make(); // some are of ropes, cloth, colliders and hulls only
            lengthen(&mut object);
            result = (entry.call)(&mut object, &other, &saved);
        }
        match result {
            Ok(()) => assert!((entry.told)(&object), "{} is not told", entry.name),
            Err(error) => assert!(
                entry.may_fail && matches!(error.status(), Some(Status::ErrorUnsupported | Status::ErrorNull)),
                "{}: {error}",
                entry.name
            ),
        }
    }
}

#[test]
fn chains() {
    let lengthen = |o: &mut Chain| o.set_rest_length(1.0).and_then(|_| o.set_colliders(1)).and_then(|_| o.set_loads(true)).unwrap();
    sweep(&CHAIN, make_chain, lengthen, |o| o.save().unwrap());
}

#[test]
fn membranes() {
    let lengthen = |o: &mut Membrane| {
        o.set_rest_length(1.0, 1.0).and_then(|_| o.set_colliders(1)).and_then(|_| o.set_loads(true)).unwrap();
    };
    sweep(&MEMBRANE, make_membrane, lengthen, |o| o.save().unwrap());
}

#[test]
fn waters() {
    sweep(&WATER, make_water, |o| o.set_hulls(1, 1, 1).and_then(|_| o.set_disc(0, 1.0, 1.0)).unwrap(), |o| o.save().unwrap());
}

#[test]
fn functions_of_no_object() {
    for status in Status::ALL {
        let name = status_name(status).replace("CD_", "").replace('_', "").to_lowercase();
        assert_eq!(name, format!("{status:?}").to_lowercase());
    }
    assert_eq!(kernels_name(Kernels::Avx512), "AVX-512");
    assert_eq!(runnable_kernels() & 1, 1);
    let saved = Chain::new(3, 4, 2, Precision::Float64).unwrap().save().unwrap();
    let of = saved_shape(&saved).unwrap();
    assert_eq!((of.kind, of.first, of.second, of.components), (Kind::Chain, 3, 4, 2));
    assert_eq!(saved_shape(&saved[1..]).unwrap_err().status(), Some(Status::ErrorFormat));
    assert!(build_info().contains("objects: "));
    let number = version();
    let text = format!("{}.{}.{}", number / 1_000_000, number / 1000 % 1000, number % 1000);
    assert_eq!(version_string(), text);
    assert_eq!(text, env!("CARGO_PKG_VERSION"));
    let mut rope = Chain::new(1, 2, 2, Precision::Float64).unwrap();
    rope.set_mass(-1.0).unwrap_err();
    assert!(error_message().contains("mass is -1"));
}
