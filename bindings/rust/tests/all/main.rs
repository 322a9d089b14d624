//! The tests of the crate; scenes.txt is read where it lies in contdyn's sources.
mod arrays;
mod conformance;
mod every_function;
mod functions;
mod lifetime;
mod scene_calls;

use contdyn::{Result, Status};

/// The call must fail with this status, and its message must have these words.
pub fn refused<T: std::fmt::Debug>(result: Result<T>, status: Status, words: &str) {
    let error = result.expect_err(words);
    assert_eq!(error.status(), Some(status), "{error}");
    assert!(error.message().contains(words), "{error}: {words}");
    assert_eq!(error.to_string(), error.message());
}
