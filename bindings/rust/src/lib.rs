//! contdyn: ropes, hair, sheets, drums and water on regular lattices, that never blow up.
//!
//! [`Chain`], [`Membrane`] and [`Water`] own one object of the C library each. Every C function is a method under its
//! name less the prefix: `cd_chain_set_mass(chain, 2)` is `rope.set_mass(2.0)?`. See README.md.
//!
//! Objects are `Send` and not `Sync`: each may be used from any thread, by one at a time.

#![deny(unsafe_op_in_unsafe_fn)]

mod api;
mod support;
#[allow(non_camel_case_types)]
pub mod sys;

pub use api::*;
pub use support::{Error, Number, Result, View};

/// A view keeps its object from being changed:
///
/// ```compile_fail,E0502
/// # fn main() -> contdyn::Result<()> {
/// let mut rope = contdyn::Chain::new(1, 4, 2, contdyn::Precision::Float64)?;
/// let at = rope.view(contdyn::Field::Position)?;
/// rope.step(0.01, 1)?;
/// at.at(0, 0, 0);
/// # Ok(())
/// # }
/// ```
///
/// and objects are not shared between threads:
///
/// ```compile_fail,E0277
/// fn shared<T: Sync>(_: T) {}
/// shared(contdyn::Chain::new(1, 4, 2, contdyn::Precision::Float64));
/// ```
#[doc(hidden)]
pub struct WhatTheCompilerRefuses;
