//! What the methods in api.rs are made with: errors, lengths of slices, ranges of whole fields, views.
use crate::{sys, Precision, Status};
use std::ffi::CStr;
use std::fmt;
use std::marker::PhantomData;
use std::os::raw::c_char;

/// Why a call failed: its status, and the library's message, which names the function, the argument and its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    code: i32,
    message: String,
}

pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    pub(crate) fn new(status: Status, message: String) -> Error {
        Error { code: status as i32, message }
    }

    /// The status; `None` for one that this crate does not know.
    pub fn status(&self) -> Option<Status> {
        Status::from_raw(self.code)
    }

    /// The status as C's number.
    pub fn code(&self) -> i32 {
        self.code
    }

    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

/// # Safety
/// `text` must be a C string, valid for the call.
pub(crate) unsafe fn string_of(text: *const c_char) -> String {
    unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned()
}

pub(crate) fn check(status: sys::cd_status) -> Result<()> {
    if status == sys::CD_OK {
        return Ok(());
    }
    let message = unsafe { string_of(sys::cd_error_message()) };
    Err(Error { code: status, message })
}

/// That the library is the one that sys.rs was made for: before 1.0 every minor version may change the API.
pub(crate) fn check_version() -> Result<()> {
    let found = unsafe { sys::cd_version() };
    let wanted = sys::CD_VERSION_MAJOR * 1_000_000 + sys::CD_VERSION_MINOR * 1000;
    if found / 1000 == wanted / 1000 {
        return Ok(());
    }
    let version = unsafe { string_of(sys::cd_version_string()) };
    let message = format!(
        "the library is contdyn {version}, and this crate is written for {}.{}",
        sys::CD_VERSION_MAJOR, sys::CD_VERSION_MINOR
    );
    Err(Error::new(Status::ErrorUnsupported, message))
}

pub(crate) fn known<T>(value: Option<T>, raw: i32, function: &str) -> Result<T> {
    value.ok_or_else(|| {
        Error::new(Status::ErrorEnum, format!("{function}: the library gives {raw}, which this crate does not know"))
    })
}

// ---- slices ---------------------------------------------------------------------------------------------------------

/// How many places a slice is for, `each` numbers for one.
pub(crate) fn count_of(length: usize, each: usize, function: &str, name: &str) -> Result<usize> {
    if length % each == 0 {
        return Ok(length / each);
    }
    let message = format!("{function}: {name} has {length} numbers, must be a multiple of {each}");
    Err(Error::new(Status::ErrorRange, message))
}

pub(crate) fn same(length: Option<usize>, wanted: Option<usize>, function: &str, name: &str) -> Result<()> {
    match length {
        Some(length) if Some(length) != wanted => {
            let wanted = wanted.unwrap_or(usize::MAX);
            let message = format!("{function}: {name} has {length} numbers, must have {wanted}");
            Err(Error::new(Status::ErrorRange, message))
        }
        _ => Ok(()),
    }
}

/// What fields are read and written in: `f32` or `f64`.
pub trait Number: sealed::Sealed + Copy + Default {}

impl Number for f32 {}
impl Number for f64 {}

pub(crate) mod sealed {
    pub trait Sealed {
        const SINGLE: bool;
    }
    impl Sealed for f32 {
        const SINGLE: bool = true;
    }
    impl Sealed for f64 {
        const SINGLE: bool = false;
    }
}

// ---- whole fields ---------------------------------------------------------------------------------------------------

/// How many places a field has along the two directions of its range: for each which size counts it, 0 for none, how
/// many more there are, and which flag of a ring adds one, 0 for none.
pub(crate) struct FieldRow {
    pub field: crate::Field,
    pub extents: [usize; 6],
    pub components: bool,
    pub one_but_in_ropes: bool,
}

/// Extents of a whole field, and how many values a place has; all 0 for a field that the object has not, which the
/// library then tells.
#[derive(Clone, Copy, Default)]
pub(crate) struct Whole {
    pub a: usize,
    pub b: usize,
    pub values: usize,
}

impl Whole {
    pub fn new(row: &FieldRow, sizes: &[usize], ring: &[bool], is_rope: bool, components: usize) -> Whole {
        let extent = |at: usize| {
            let [size, more, flag] = [row.extents[at], row.extents[at + 1], row.extents[at + 2]];
            more + if size > 0 { sizes[size - 1] } else { 0 } + usize::from(flag > 0 && ring[flag - 1])
        };
        Whole {
            a: if row.one_but_in_ropes && !is_rope { 1 } else { extent(0) },
            b: extent(3),
            values: if row.components { components } else { 1 },
        }
    }

    pub fn count(&self) -> usize {
        self.a * self.b * self.values
    }

    /// The four numbers of its range, in the order of the object's reads and writes.
    pub fn range(&self, alternates: bool) -> [usize; 4] {
        if alternates {
            [0, self.a, 0, self.b]
        } else {
            [0, 0, self.a, self.b]
        }
    }
}

/// A field where it lies in the object's memory; while it is there the object cannot be changed.
#[derive(Clone, Copy)]
pub struct View<'a> {
    data: *const u8,
    strides: [usize; 3],
    extents: [usize; 3],
    precision: Precision,
    object: PhantomData<&'a ()>,
}

impl View<'_> {
    pub(crate) fn new(data: *const u8, strides: [usize; 3], whole: Whole, precision: Precision) -> View<'static> {
        View { data, strides, extents: [whole.a, whole.b, whole.values], precision, object: PhantomData }
    }

    /// How many places there are along its two directions, and how many values each has.
    pub fn extents(&self) -> [usize; 3] {
        self.extents
    }

    /// What its numbers are stored in.
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// The bytes between neighbours, along its two directions and between the values of a place.
    pub fn strides(&self) -> [usize; 3] {
        self.strides
    }

    /// Where its first number lies, for what reads a whole row of them.
    pub fn as_ptr(&self) -> *const u8 {
        self.data
    }

    /// The number at a place, such as strand, node and component; `None` outside.
    pub fn get(&self, i: usize, j: usize, k: usize) -> Option<f64> {
        if i >= self.extents[0] || j >= self.extents[1] || k >= self.extents[2] {
            return None;
        }
        let offset = i * self.strides[0] + j * self.strides[1] + k * self.strides[2];
        // The library keeps the numbers of every place at these strides, and 'a keeps the object as it is.
        unsafe {
            let at = self.data.add(offset);
            Some(match self.precision {
                Precision::Float32 => f64::from(at.cast::<f32>().read_unaligned()),
                Precision::Float64 => at.cast::<f64>().read_unaligned(),
            })
        }
    }

    /// The number at a place. Panics outside, as indexing a slice does.
    pub fn at(&self, i: usize, j: usize, k: usize) -> f64 {
        let [a, b, c] = self.extents;
        self.get(i, j, k).unwrap_or_else(|| panic!("no place ({i}, {j}, {k}) in {a} x {b} x {c}"))
    }
}
