//! What calls cost, in nanoseconds: the C function and the method that calls it by turns, the least of many rounds.
//!
//!     cargo run --release --example calls
use contdyn::*;
use std::time::Instant;

const ROUNDS: usize = 100;
const CALLS: usize = 10_000;

fn least(mut run: impl FnMut()) -> f64 {
    let rounds = (0..ROUNDS).map(|_| {
        let begin = Instant::now();
        (0..CALLS).for_each(|_| run());
        begin.elapsed().as_nanos() as f64 / CALLS as f64
    });
    rounds.fold(f64::INFINITY, f64::min)
}

fn row(name: &str, bare: f64, method: f64) {
    println!("| {name} | {bare:.1} | {method:.1} |");
}

fn main() -> Result<()> {
    let mut rope = Chain::new(1, 10, 3, Precision::Float64)?;
    let handle = rope.as_ptr();
    let (mut mass, gravity) = (0.0, [0.0; 3]);
    row(
        "`get_mass`",
        least(|| assert_eq!(unsafe { sys::cd_chain_get_mass(handle, &mut mass) }, 0)),
        least(|| assert_eq!(rope.get_mass(), Ok(1.0))),
    );
    row(
        "`set_gravity`",
        least(|| assert_eq!(unsafe { sys::cd_chain_set_gravity(handle, gravity.as_ptr(), 3) }, 0)),
        least(|| rope.set_gravity(&gravity).unwrap()),
    );
    row(
        "`step` of 11 nodes, 3 components",
        least(|| assert_eq!(unsafe { sys::cd_chain_step(handle, 1e-3, 1) }, 0)),
        least(|| rope.step(1e-3, 1).unwrap()),
    );
    let at = rope.view(Field::Position)?;
    let mut node = 0;
    let number = least(|| {
        node = (node + 1) % 11;
        assert_eq!(at.at(0, node, 1), 0.0);
    });
    println!("| one number of a view | | {number:.1} |");
    Ok(())
}
