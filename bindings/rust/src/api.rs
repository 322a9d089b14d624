//! The library's objects. Made by generate.py from ../api.json: do not edit.
use crate::support::{check, check_version, count_of, known, same, string_of, FieldRow, Whole};
use crate::{sys, Number, Result, View};
use std::ptr::NonNull;

/// cd_status.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Status {
    Ok = 0,
    /// a pointer that may not be null is null
    ErrorNull = 1,
    /// the handle is of another kind of object
    ErrorHandle = 2,
    /// a number outside its valid range, or NaN or infinity where it has no meaning
    ErrorValue = 3,
    /// not one of the enumeration's values
    ErrorEnum = 4,
    /// an index, a range or a buffer length that does not fit the object
    ErrorRange = 5,
    /// a size that cannot be represented in memory
    ErrorSize = 6,
    /// the allocator returned null
    ErrorMemory = 7,
    /// the field is not switched on: see cd_\*_enable_field
    ErrorDisabled = 8,
    /// what this object cannot do, or what was left out of this build: see cd_build_info
    ErrorUnsupported = 9,
    /// the state left the finite range during a step, or has not come back to it
    ErrorDiverged = 10,
    /// the bytes to load are damaged, or of a later version or another kind
    ErrorFormat = 11,
    /// the two objects, or the object and the bytes, differ in shape or precision
    ErrorMismatch = 12,
    /// steps were made, but an iterative solve ended short of its tolerance
    ErrorTolerance = 13,
    /// steps were made, but a callback gave numbers that it may not
    ErrorCallback = 14,
}

impl Status {
    /// Every one of them.
    pub const ALL: [Status; 15] = [
        Status::Ok,
        Status::ErrorNull,
        Status::ErrorHandle,
        Status::ErrorValue,
        Status::ErrorEnum,
        Status::ErrorRange,
        Status::ErrorSize,
        Status::ErrorMemory,
        Status::ErrorDisabled,
        Status::ErrorUnsupported,
        Status::ErrorDiverged,
        Status::ErrorFormat,
        Status::ErrorMismatch,
        Status::ErrorTolerance,
        Status::ErrorCallback,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Status> {
        Status::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// What an object stores its state in; chosen when it is made. Steps compute in double precision whatever it is,
/// but for those that an object's header names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Precision {
    Float32 = 0,
    Float64 = 1,
}

impl Precision {
    /// Every one of them.
    pub const ALL: [Precision; 2] = [
        Precision::Float32,
        Precision::Float64,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Precision> {
        Precision::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// How a step advances the state by dt. CD_METHOD_IMPLICIT is the default, with lambda = 1/2. Bounds hold, and
/// energy is kept, to rounding: in a step a node's position may be wrong by some 1e-15 of the distance that its
/// velocity covers in dt, in a ring or with bend also by 1e-15 of the distance that it would fall in dt, which
/// shows where dt is longer than 1e12 times the time of the fastest swing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Method {
    /// Kass 1997, eq. 21: lambda = 1/2 keeps energy and is second order, lambda = 1 is backward Euler; for lambda
    /// \>= 1/2 bounded at every dt
    Implicit = 0,
    /// Kass 1997, eq. 13; without damping it grows at every dt
    ForwardEuler = 1,
    /// the new velocity moves the position, of water in its symmetric form (velocity Verlet); bounded up to
    /// cd_\*_stable_dt
    SymplecticEuler = 2,
    /// two implicit stages with gamma = 1 - 1/sqrt(2) (SDIRK2): second order, and L-stable: motion too fast for dt
    /// dies out
    StiffSecond = 3,
}

impl Method {
    /// Every one of them.
    pub const ALL: [Method; 4] = [
        Method::Implicit,
        Method::ForwardEuler,
        Method::SymplecticEuler,
        Method::StiffSecond,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Method> {
        Method::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// How the two-dimensional system of a membrane's implicit step is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Solver {
    /// rows, then columns: Kass 1997, section 9
    Alternating = 0,
    /// both at once, to a tolerance
    Coupled = 1,
    /// the first where that is right for the step, else the second
    Auto = 2,
}

impl Solver {
    /// Every one of them.
    pub const ALL: [Solver; 3] = [
        Solver::Alternating,
        Solver::Coupled,
        Solver::Auto,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Solver> {
        Solver::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// How the total mass is dealt out to the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum MassRule {
    /// every node the same: the notes' rule, first order in space
    Equal = 0,
    /// nodes on a border half as heavy as those inside: second order in space
    HalfEnds = 1,
}

impl MassRule {
    /// Every one of them.
    pub const ALL: [MassRule; 2] = [
        MassRule::Equal,
        MassRule::HalfEnds,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<MassRule> {
        MassRule::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// The instructions that steps are made of. All give the same bits as long as all numbers are finite; how far
/// infinity and NaN spread in steps that end with CD_ERROR_DIVERGED may differ. A new object has the fastest that
/// its processor runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Kernels {
    /// what every processor of the target has: SSE2 on x86-64, NEON on AArch64, and on WebAssembly SIMD128 where
    /// that was built with -msimd128
    Plain = 0,
    Avx2 = 1,
    /// the parts F and DQ of AVX-512
    Avx512 = 2,
}

impl Kernels {
    /// Every one of them.
    pub const ALL: [Kernels; 3] = [
        Kernels::Plain,
        Kernels::Avx2,
        Kernels::Avx512,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Kernels> {
        Kernels::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// What holds a node. The values are also those of the field CD_PIN.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Node {
    Free = 0,
    /// infinite mass, at rest
    Pinned = 1,
    /// infinite mass, moves with the velocity written to it
    Driven = 2,
    /// border nodes only: free, with the impedance sqrt(stiffness mass) that sends no echo back
    Matched = 3,
    /// infinite mass; each call of cd_\*_step moves it to where CD_TARGET is, evenly, and there it stays until
    /// CD_TARGET is written again. Without that field as CD_NODE_DRIVEN: it stands still where no velocity has been
    /// written
    Posed = 4,
}

impl Node {
    /// Every one of them.
    pub const ALL: [Node; 5] = [
        Node::Free,
        Node::Pinned,
        Node::Driven,
        Node::Matched,
        Node::Posed,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Node> {
        Node::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// What a collider of ropes and cloth is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Shape {
    None = 0,
    Plane = 1,
    Capsule = 2,
    Bed = 3,
    Callback = 4,
}

impl Shape {
    /// Every one of them.
    pub const ALL: [Shape; 5] = [
        Shape::None,
        Shape::Plane,
        Shape::Capsule,
        Shape::Bed,
        Shape::Callback,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Shape> {
        Shape::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// What becomes of places outside of an object that it is sampled at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Outside {
    /// CD_ERROR_VALUE, and nothing is told of the other places either
    Refused = 0,
    /// they stand for the nearest place in the object; only NaN is refused
    Nearest = 1,
}

impl Outside {
    /// Every one of them.
    pub const ALL: [Outside; 2] = [
        Outside::Refused,
        Outside::Nearest,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Outside> {
        Outside::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// Per-node and per-spring data; each object's header lists those that it has. They are in one list, since a field
/// that several objects have means the same in each. All hold numbers, pins and masks too, for one read and one
/// write.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Field {
    Position = 0,
    Velocity = 1,
    Force = 2,
    Mass = 3,
    Stiffness = 4,
    Bend = 5,
    Pin = 6,
    Target = 7,
    StiffnessU = 8,
    StiffnessV = 9,
    Mask = 10,
    Depth = 11,
    Bed = 12,
    Surface = 13,
    VelocityX = 14,
    VelocityY = 15,
    Source = 16,
    Pressure = 17,
    ForceX = 18,
    ForceY = 19,
    WallX = 20,
    WallY = 21,
    RestLength = 22,
    Tension = 23,
    Wind = 24,
    Strength = 25,
    Strain = 26,
    RestLengthU = 27,
    RestLengthV = 28,
    TensionU = 29,
    TensionV = 30,
    StrainU = 31,
    StrainV = 32,
    BreakingStrainU = 33,
    BreakingStrainV = 34,
    RestAngle = 35,
}

impl Field {
    /// Every one of them.
    pub const ALL: [Field; 36] = [
        Field::Position,
        Field::Velocity,
        Field::Force,
        Field::Mass,
        Field::Stiffness,
        Field::Bend,
        Field::Pin,
        Field::Target,
        Field::StiffnessU,
        Field::StiffnessV,
        Field::Mask,
        Field::Depth,
        Field::Bed,
        Field::Surface,
        Field::VelocityX,
        Field::VelocityY,
        Field::Source,
        Field::Pressure,
        Field::ForceX,
        Field::ForceY,
        Field::WallX,
        Field::WallY,
        Field::RestLength,
        Field::Tension,
        Field::Wind,
        Field::Strength,
        Field::Strain,
        Field::RestLengthU,
        Field::RestLengthV,
        Field::TensionU,
        Field::TensionV,
        Field::StrainU,
        Field::StrainV,
        Field::BreakingStrainU,
        Field::BreakingStrainV,
        Field::RestAngle,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Field> {
        Field::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// The kinds of objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Kind {
    Chain = 1,
    Membrane = 2,
    Water = 3,
}

impl Kind {
    /// Every one of them.
    pub const ALL: [Kind; 3] = [
        Kind::Chain,
        Kind::Membrane,
        Kind::Water,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Kind> {
        Kind::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// The two ends of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum End {
    First = 0,
    Last = 1,
}

impl End {
    /// Every one of them.
    pub const ALL: [End; 2] = [
        End::First,
        End::Last,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<End> {
        End::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// The four edges of a membrane. A corner belongs to two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Edge {
    /// the nodes with u = 0
    UFirst = 0,
    /// u = nu
    ULast = 1,
    /// v = 0
    VFirst = 2,
    /// v = nv
    VLast = 3,
}

impl Edge {
    /// Every one of them.
    pub const ALL: [Edge; 4] = [
        Edge::UFirst,
        Edge::ULast,
        Edge::VFirst,
        Edge::VLast,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Edge> {
        Edge::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// The four sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Side {
    /// x = 0
    XFirst = 0,
    /// x = nx dx
    XLast = 1,
    /// y = 0
    YFirst = 2,
    /// y = ny dy
    YLast = 3,
}

impl Side {
    /// Every one of them.
    pub const ALL: [Side; 4] = [
        Side::XFirst,
        Side::XLast,
        Side::YFirst,
        Side::YLast,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Side> {
        Side::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// What is at a side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Border {
    Wall = 0,
    /// water of a given level outside, into which waves run without an echo
    Open = 1,
    /// a given discharge comes in; if negative, leaves as far as there is water
    Inflow = 2,
    /// goes on at the opposite side
    Periodic = 3,
    /// holds a given level for what flows out slower than its waves: a lake, a weir
    Level = 4,
}

impl Border {
    /// Every one of them.
    pub const ALL: [Border; 5] = [
        Border::Wall,
        Border::Open,
        Border::Inflow,
        Border::Periodic,
        Border::Level,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Border> {
        Border::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// Whether water carries its momentum along.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Momentum {
    Linear = 0,
    Advected = 1,
}

impl Momentum {
    /// Every one of them.
    pub const ALL: [Momentum; 2] = [
        Momentum::Linear,
        Momentum::Advected,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<Momentum> {
        Momentum::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// What a write to CD_BED leaves as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum BedRule {
    /// the depth: water rides on the bed, volume is kept
    LiftsWater = 0,
    /// the surface of wet cells: the account tells the volume that a write brings or takes
    KeepsSurface = 1,
}

impl BedRule {
    /// Every one of them.
    pub const ALL: [BedRule; 2] = [
        BedRule::LiftsWater,
        BedRule::KeepsSurface,
    ];

    /// The one with C's value.
    pub fn from_raw(value: i32) -> Option<BedRule> {
        BedRule::ALL.into_iter().find(|known| *known as i32 == value)
    }
}

/// Name of a status, such as "CD_ERROR_VALUE"; "CD_ERROR_UNKNOWN" for a number that is none. A static string.
pub fn status_name(status: Status) -> String {
    unsafe { string_of(sys::cd_status_name(status as i32)) }
}

/// Why the last failed call on this thread failed: the function, the argument, its value, what would be valid.
/// Empty before the first failure; successful calls leave it as it is. The string belongs to the library and stays
/// valid until the next failure on the same thread. The library tells nothing else, and has no hook for messages.
pub fn error_message() -> String {
    unsafe { string_of(sys::cd_error_message()) }
}

/// What [`saved_shape`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SavedShape {
    pub kind: Kind,
    pub first: usize,
    pub second: usize,
    pub components: usize,
    pub precision: Precision,
}

/// What cd_\*_save made these bytes of: the kind of object, and what its create function has to be given so that it
/// loads them: of a chain strands and springs, of a membrane nu and nv, of water nx and ny; components, of water 1;
/// and the precision. Water's dx and dy, allocators and callbacks may be others. Each output may be null, and is
/// left alone on failure. Errors: CD_ERROR_FORMAT for bytes that are damaged, cut short or of a later version.
pub fn saved_shape(bytes: &[u8]) -> Result<SavedShape> {
    let size = bytes.len();
    let mut out_kind = 0;
    let mut out_first = 0;
    let mut out_second = 0;
    let mut out_components = 0;
    let mut out_precision = 0;
    check(unsafe { sys::cd_saved_shape(bytes.as_ptr().cast(), size, &mut out_kind, &mut out_first, &mut out_second,
        &mut out_components, &mut out_precision) })?;
    Ok(SavedShape {
        kind: known(Kind::from_raw(out_kind), out_kind, "cd_saved_shape")?,
        first: out_first,
        second: out_second,
        components: out_components,
        precision: known(Precision::from_raw(out_precision), out_precision, "cd_saved_shape")?,
    })
}

/// The kernels that this build has and this processor runs: the sum of 1 \<\< k for each of them, k a cd_kernels.
/// The largest k is the fastest. CD_KERNELS_PLAIN is always there.
pub fn runnable_kernels() -> u32 {
    unsafe { sys::cd_runnable_kernels() }
}

/// The instructions' name, such as "AVX-512"; of CD_KERNELS_PLAIN those that it was built with: "SSE2", "NEON",
/// "SIMD128", or "plain" for one number at a time. "unknown" for a number that is no cd_kernels. A static string.
pub fn kernels_name(kernels: Kernels) -> String {
    unsafe { string_of(sys::cd_kernels_name(kernels as i32)) }
}

/// Version of the library that runs: major \* 1000000 + minor \* 1000 + patch. The macros tell that of the header.
pub fn version() -> u32 {
    unsafe { sys::cd_version() }
}

/// The same as text, "0.2.0". A static string.
pub fn version_string() -> String {
    unsafe { string_of(sys::cd_version_string()) }
}

/// Compiler, target, and which objects, features, precisions and kernels this build has, in one line: options of
/// the build leave parts out, and what asks for one that is not there says CD_ERROR_UNSUPPORTED. A static string.
pub fn build_info() -> String {
    unsafe { string_of(sys::cd_build_info()) }
}

/// What [`Chain::get_shape`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainShape {
    pub strands: usize,
    pub springs: usize,
    pub components: usize,
    pub precision: Precision,
}

/// What [`Chain::get_sleep`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainSleep {
    pub speed: f64,
    pub seconds: f64,
}

/// What [`Chain::get_air`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainAir {
    pub along: f64,
    pub across: f64,
}

/// What [`Chain::get_tolerance`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainTolerance {
    pub tolerance: f64,
    pub most_iterations: usize,
}

/// What [`Chain::get_convergence`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainConvergence {
    pub iterations: usize,
    pub residual: f64,
}

/// What [`Chain::get_bed`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainBed {
    pub columns: usize,
    pub rows: usize,
}

/// What [`Chain::get_collider`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainCollider {
    pub shape: Shape,
    pub radius: f64,
    pub friction: f64,
}

/// What [`Chain::get_attachment`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainAttachment {
    pub stiffness: f64,
    pub damping: f64,
}

/// What [`Chain::get_energy`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainEnergy {
    pub kinetic: f64,
    pub elastic: f64,
    pub gravity: f64,
}

/// contdyn: a chain of nodes joined by springs: massive spring, rope, hair, spline.
/// A chain has `springs` springs and nodes = springs + 1 nodes; spring i joins node i to node i + 1. A ring has one
/// spring more, number `springs`, from the last node to the first. A node has 1 to 4 components that never mix. One
/// handle holds one or many strands, each with its own positions, velocities, forces and targets. Strands share
/// masses, stiffnesses, pins and attachments, and so one factorization; only ropes' strands have their own of these
/// too.
/// Energy E = 1/2 sum k_i |x_{i+1} - x_i|^2 + 1/2 sum b_i |x_{i+1} - 2 x_i + x_{i-1}|^2 (Kass 1997, eq. 2 and 5)
/// Motion M x'' + C x' + K x = M g + f, K = the Hessian of E, C = drag M + stiffness_damping K
/// Rest length is zero, unless cd_chain_set_rest_length makes the chain a rope: a free chain draws together, and
/// one stretched evenly is held by its ends. A new chain lies with every node at the origin, at rest, all nodes
/// free, mass 1, stiffness 1, no bend, no gravity, no damping, CD_METHOD_IMPLICIT with lambda 1/2.
/// All computing is done in double precision; CD_FLOAT32 is what positions, velocities, forces and targets are
/// stored in. (Steps of symplectic Euler on uniform chains without damping and forces compute in float32 and are as
/// exact.) Numbers smaller than 2^-80 (float32) or 2^-500 (float64), in those steps velocities, are taken for 0
/// where a step stores them, so that a scene at rest is never slow. Parameters may be as large as 1e60, masses as
/// small as 1e-60.
/// Every function returns CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a handle of another kind; the
/// comments name the other errors.
pub struct Chain {
    handle: NonNull<sys::cd_chain>,
}

// The library ties objects to no thread. They are not Sync, as NonNull is not.
unsafe impl Send for Chain {}

impl Drop for Chain {
    fn drop(&mut self) {
        unsafe { sys::cd_chain_destroy(self.as_ptr()) }
    }
}

impl std::fmt::Debug for Chain {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Debug::fmt(&self.get_shape(), f)
    }
}

impl Chain {
    /// Makes a chain. strands \>= 1; springs \>= 0 (0: a single node); components 1 to 4. allocator may be null
    /// (malloc). The caller owns \*out_chain and releases it with cd_chain_destroy; on failure \*out_chain is left
    /// alone. Errors: CD_ERROR_VALUE, CD_ERROR_ENUM, CD_ERROR_SIZE, CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for a
    /// precision that this build leaves out.
    pub fn new(strands: usize, springs: usize, components: usize, precision: Precision) -> Result<Chain> {
        unsafe { Chain::create(strands, springs, components, precision, None) }
    }

    /// [`Chain::new`] with callbacks.
    ///
    /// # Safety
    /// The functions and `user` must be good for as long as the object may call them, from whichever threads
    /// it is used on, and must not unwind.
    pub unsafe fn create(strands: usize, springs: usize, components: usize, precision: Precision,
        allocator: Option<&sys::cd_allocator>) -> Result<Chain> {
        check_version()?;
        let mut made = std::ptr::null_mut();
        check(unsafe { sys::cd_chain_create(strands, springs, components, precision as i32,
            allocator.map_or(std::ptr::null(), |c| c as *const _), &mut made) })?;
        Ok(unsafe { Chain::from_raw(made) })
    }

    /// Takes a handle over.
    ///
    /// # Safety
    /// It must be one of the library's, alive, and of this kind, and nobody else may use it from then on.
    pub unsafe fn from_raw(handle: *mut sys::cd_chain) -> Chain {
        Chain { handle: NonNull::new(handle).expect("a handle") }
    }

    /// The handle, for functions of [`sys`]; it stays this object's.
    pub fn as_ptr(&self) -> *mut sys::cd_chain {
        self.handle.as_ptr()
    }

    /// Gives the handle away, to be released by the caller.
    pub fn into_raw(self) -> *mut sys::cd_chain {
        std::mem::ManuallyDrop::new(self).handle.as_ptr()
    }

    fn whole(&self, field: Field) -> Result<Whole> {
        const ROWS: [FieldRow; 14] = [
            FieldRow { field: Field::Position, extents: [1, 0, 0, 2, 1, 0], components: true, one_but_in_ropes: false },
            FieldRow { field: Field::Velocity, extents: [1, 0, 0, 2, 1, 0], components: true, one_but_in_ropes: false },
            FieldRow { field: Field::Force, extents: [1, 0, 0, 2, 1, 0], components: true, one_but_in_ropes: false },
            FieldRow { field: Field::Target, extents: [1, 0, 0, 2, 1, 0], components: true, one_but_in_ropes: false },
            FieldRow { field: Field::Mass, extents: [1, 0, 0, 2, 1, 0], components: false, one_but_in_ropes: true },
            FieldRow { field: Field::Stiffness, extents: [1, 0, 0, 2, 0, 1], components: false,
                one_but_in_ropes: true },
            FieldRow { field: Field::Bend, extents: [1, 0, 0, 2, 1, 0], components: false, one_but_in_ropes: true },
            FieldRow { field: Field::Pin, extents: [1, 0, 0, 2, 1, 0], components: false, one_but_in_ropes: true },
            FieldRow { field: Field::RestLength, extents: [1, 0, 0, 2, 0, 1], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::Tension, extents: [1, 0, 0, 2, 0, 1], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::Wind, extents: [1, 0, 0, 2, 1, 0], components: true, one_but_in_ropes: false },
            FieldRow { field: Field::Strength, extents: [1, 0, 0, 2, 0, 1], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::RestAngle, extents: [1, 0, 0, 2, 1, 0], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::Strain, extents: [1, 0, 0, 2, 0, 1], components: false, one_but_in_ropes: false },
        ];
        let row = match ROWS.iter().find(|row| row.field == field) {
            Some(row) => row,
            None => return Ok(Whole::default()),
        };
        let shape = self.get_shape()?;
        Ok(Whole::new(row, &[shape.strands, shape.springs], &[self.get_ring()?],
            row.one_but_in_ropes && self.get_rest_length()? > 0.0, shape.components))
    }

    /// How many values a whole field has.
    pub fn get_size(&self, field: Field) -> Result<usize> {
        let count = self.whole(field)?.count();
        if count == 0 {
            self.read_f64(field, 0, 0, 0, 0, &mut [])?; // says which fields there are
        }
        Ok(count)
    }

    /// All values of a field, as `read_f32` or `read_f64`.
    pub fn read<T: Number>(&self, field: Field) -> Result<Vec<T>> {
        let whole = self.whole(field)?;
        let mut values = vec![T::default(); whole.count()];
        let [a, b, c, d] = whole.range(true);
        let field = field as i32;
        check(unsafe {
            if T::SINGLE {
                sys::cd_chain_read_f32(self.as_ptr(), field, a, b, c, d, values.as_mut_ptr().cast(), values.len())
            } else {
                sys::cd_chain_read_f64(self.as_ptr(), field, a, b, c, d, values.as_mut_ptr().cast(), values.len())
            }
        })?;
        Ok(values)
    }

    /// Writes all values of a field, as `write_f32` or `write_f64`.
    pub fn write<T: Number>(&mut self, field: Field, values: &[T]) -> Result<()> {
        let whole = self.whole(field)?;
        let [a, b, c, d] = whole.range(true);
        let field = field as i32;
        check(unsafe {
            if T::SINGLE {
                sys::cd_chain_write_f32(self.as_ptr(), field, a, b, c, d, values.as_ptr().cast(), values.len())
            } else {
                sys::cd_chain_write_f64(self.as_ptr(), field, a, b, c, d, values.as_ptr().cast(), values.len())
            }
        })
    }

    /// What cd_chain_create was given. Each output may be null.
    pub fn get_shape(&self) -> Result<ChainShape> {
        let mut out_strands = 0;
        let mut out_springs = 0;
        let mut out_components = 0;
        let mut out_precision = 0;
        check(unsafe { sys::cd_chain_get_shape(self.as_ptr(), &mut out_strands, &mut out_springs, &mut out_components,
            &mut out_precision) })?;
        Ok(ChainShape {
            strands: out_strands,
            springs: out_springs,
            components: out_components,
            precision: known(Precision::from_raw(out_precision), out_precision, "cd_chain_get_shape")?,
        })
    }

    /// How steps are made. Methods differ in the memory they need: implicit ones a factorization and a row of scratch,
    /// CD_METHOD_STIFF_SECOND a second row. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
    pub fn set_method(&mut self, method: Method) -> Result<()> {
        check(unsafe { sys::cd_chain_set_method(self.as_ptr(), method as i32) })
    }

    /// How steps are made. Methods differ in the memory they need: implicit ones a factorization and a row of scratch,
    /// CD_METHOD_STIFF_SECOND a second row. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
    pub fn get_method(&self) -> Result<Method> {
        let mut out_method = 0;
        check(unsafe { sys::cd_chain_get_method(self.as_ptr(), &mut out_method) })?;
        known(Method::from_raw(out_method), out_method, "cd_chain_get_method")
    }

    /// lambda of CD_METHOD_IMPLICIT, in \[0, 1\]; default 1/2. Errors: CD_ERROR_VALUE.
    pub fn set_lambda(&mut self, lambda: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_lambda(self.as_ptr(), lambda) })
    }

    /// lambda of CD_METHOD_IMPLICIT, in \[0, 1\]; default 1/2. Errors: CD_ERROR_VALUE.
    pub fn get_lambda(&self) -> Result<f64> {
        let mut out_lambda = 0.0;
        check(unsafe { sys::cd_chain_get_lambda(self.as_ptr(), &mut out_lambda) })?;
        Ok(out_lambda)
    }

    /// Spreads the strands of a step over the caller's threads. Null: none. Errors: CD_ERROR_NULL for a table without
    /// run.
    ///
    /// # Safety
    /// The functions and `user` must be good for as long as the object may call them, from whichever threads
    /// it is used on, and must not unwind.
    pub unsafe fn set_parallel(&mut self, parallel: Option<&sys::cd_parallel>) -> Result<()> {
        check(unsafe { sys::cd_chain_set_parallel(self.as_ptr(), parallel.map_or(std::ptr::null(),
            |c| c as *const _)) })
    }

    /// The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and
    /// a new chain has the fastest that its processor runs. Not part of the saved state. Errors: CD_ERROR_ENUM;
    /// CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
    pub fn set_kernels(&mut self, kernels: Kernels) -> Result<()> {
        check(unsafe { sys::cd_chain_set_kernels(self.as_ptr(), kernels as i32) })
    }

    /// The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and
    /// a new chain has the fastest that its processor runs. Not part of the saved state. Errors: CD_ERROR_ENUM;
    /// CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
    pub fn get_kernels(&self) -> Result<Kernels> {
        let mut out_kernels = 0;
        check(unsafe { sys::cd_chain_get_kernels(self.as_ptr(), &mut out_kernels) })?;
        known(Kernels::from_raw(out_kernels), out_kernels, "cd_chain_get_kernels")
    }

    /// Mass \[kg\], \> 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half of it at the
    /// two ends (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.
    pub fn set_mass(&mut self, mass: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_mass(self.as_ptr(), mass) })
    }

    /// Mass \[kg\], \> 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half of it at the
    /// two ends (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.
    pub fn get_mass(&self) -> Result<f64> {
        let mut out_mass = 0.0;
        check(unsafe { sys::cd_chain_get_mass(self.as_ptr(), &mut out_mass) })?;
        Ok(out_mass)
    }

    /// Mass \[kg\], \> 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half of it at the
    /// two ends (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.
    pub fn set_mass_rule(&mut self, rule: MassRule) -> Result<()> {
        check(unsafe { sys::cd_chain_set_mass_rule(self.as_ptr(), rule as i32) })
    }

    /// Mass \[kg\], \> 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half of it at the
    /// two ends (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.
    pub fn get_mass_rule(&self) -> Result<MassRule> {
        let mut out_rule = 0;
        check(unsafe { sys::cd_chain_get_mass_rule(self.as_ptr(), &mut out_rule) })?;
        known(MassRule::from_raw(out_rule), out_rule, "cd_chain_get_mass_rule")
    }

    /// Stretch stiffness k \[N/m\], \>= 0, of ropes up to INFINITY. Per spring: k times the number of springs. Kass
    /// 1997, eq. 7. Waves run along the chain in sqrt(mass / k) seconds.
    pub fn set_stiffness(&mut self, stiffness: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_stiffness(self.as_ptr(), stiffness) })
    }

    /// Stretch stiffness k \[N/m\], \>= 0, of ropes up to INFINITY. Per spring: k times the number of springs. Kass
    /// 1997, eq. 7. Waves run along the chain in sqrt(mass / k) seconds.
    pub fn get_stiffness(&self) -> Result<f64> {
        let mut out_stiffness = 0.0;
        check(unsafe { sys::cd_chain_get_stiffness(self.as_ptr(), &mut out_stiffness) })?;
        Ok(out_stiffness)
    }

    /// Bend stiffness b \[N/m\], \>= 0. Per node with two neighbours: b times the cube of the number of springs (Kass
    /// 1997, eq. 5; eq. 8 prints the square). With b = E I / L^3, L the length of all its springs, held ones too, a
    /// rope bends as a beam of the rigidity E I \[N m^2\]. Errors: CD_ERROR_MEMORY when bend is switched on.
    pub fn set_bend(&mut self, bend: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_bend(self.as_ptr(), bend) })
    }

    /// Bend stiffness b \[N/m\], \>= 0. Per node with two neighbours: b times the cube of the number of springs (Kass
    /// 1997, eq. 5; eq. 8 prints the square). With b = E I / L^3, L the length of all its springs, held ones too, a
    /// rope bends as a beam of the rigidity E I \[N m^2\]. Errors: CD_ERROR_MEMORY when bend is switched on.
    pub fn get_bend(&self) -> Result<f64> {
        let mut out_bend = 0.0;
        check(unsafe { sys::cd_chain_get_bend(self.as_ptr(), &mut out_bend) })?;
        Ok(out_bend)
    }

    /// Drag \[1/s\], \>= 0: every node loses velocity at this rate.
    pub fn set_drag(&mut self, drag: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_drag(self.as_ptr(), drag) })
    }

    /// Drag \[1/s\], \>= 0: every node loses velocity at this rate.
    pub fn get_drag(&self) -> Result<f64> {
        let mut out_drag = 0.0;
        check(unsafe { sys::cd_chain_get_drag(self.as_ptr(), &mut out_drag) })?;
        Ok(out_drag)
    }

    /// Stiffness damping \[s\], \>= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
    /// amplitude at the rate (drag + stiffness_damping w^2) / 2. Ropes take none.
    pub fn set_stiffness_damping(&mut self, seconds: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_stiffness_damping(self.as_ptr(), seconds) })
    }

    /// Stiffness damping \[s\], \>= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
    /// amplitude at the rate (drag + stiffness_damping w^2) / 2. Ropes take none.
    pub fn get_stiffness_damping(&self) -> Result<f64> {
        let mut out_seconds = 0.0;
        check(unsafe { sys::cd_chain_get_stiffness_damping(self.as_ptr(), &mut out_seconds) })?;
        Ok(out_seconds)
    }

    /// Gravity \[m/s^2\], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors: CD_ERROR_RANGE if
    /// count is not the number of components.
    pub fn set_gravity(&mut self, gravity: &[f64]) -> Result<()> {
        let count = count_of(gravity.len(), 1, "cd_chain_set_gravity", "gravity")?;
        check(unsafe { sys::cd_chain_set_gravity(self.as_ptr(), gravity.as_ptr(), count) })
    }

    /// Gravity \[m/s^2\], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors: CD_ERROR_RANGE if
    /// count is not the number of components.
    pub fn get_gravity(&self, out_gravity: &mut [f64]) -> Result<()> {
        let count = count_of(out_gravity.len(), 1, "cd_chain_get_gravity", "out_gravity")?;
        check(unsafe { sys::cd_chain_get_gravity(self.as_ptr(), out_gravity.as_mut_ptr(), count) })
    }

    /// What holds an end: the same as writing the field CD_PIN at the first or last node of every strand; the getter
    /// tells that of the first strand. Pinning stops the node; driving leaves its velocity, which is then written
    /// through CD_VELOCITY; posing switches CD_TARGET on and sets the end's target to where it is: write the next one
    /// there. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED on a ring;
    /// CD_ERROR_DIVERGED for CD_NODE_POSED where the state is not finite.
    pub fn set_end(&mut self, end: End, kind: Node) -> Result<()> {
        check(unsafe { sys::cd_chain_set_end(self.as_ptr(), end as i32, kind as i32) })
    }

    /// What holds an end: the same as writing the field CD_PIN at the first or last node of every strand; the getter
    /// tells that of the first strand. Pinning stops the node; driving leaves its velocity, which is then written
    /// through CD_VELOCITY; posing switches CD_TARGET on and sets the end's target to where it is: write the next one
    /// there. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED on a ring;
    /// CD_ERROR_DIVERGED for CD_NODE_POSED where the state is not finite.
    pub fn get_end(&self, end: End) -> Result<Node> {
        let mut out_kind = 0;
        check(unsafe { sys::cd_chain_get_end(self.as_ptr(), end as i32, &mut out_kind) })?;
        known(Node::from_raw(out_kind), out_kind, "cd_chain_get_end")
    }

    /// Joins the last node to the first (1) or opens the ring (0). A ring has as many springs as nodes, and with bend a
    /// bend term at every node; totals are dealt out anew, and a per-spring stiffness field gets the uniform value.
    /// Needs 3 nodes. A ring with bend whose springs are cut, or some far softer than others, gains energy by rounding
    /// in steps longer than some 1e6 times its fastest swing. Errors: CD_ERROR_VALUE for anything but 0 and 1;
    /// CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched end; CD_ERROR_MEMORY.
    pub fn set_ring(&mut self, ring: bool) -> Result<()> {
        check(unsafe { sys::cd_chain_set_ring(self.as_ptr(), i32::from(ring)) })
    }

    /// Joins the last node to the first (1) or opens the ring (0). A ring has as many springs as nodes, and with bend a
    /// bend term at every node; totals are dealt out anew, and a per-spring stiffness field gets the uniform value.
    /// Needs 3 nodes. A ring with bend whose springs are cut, or some far softer than others, gains energy by rounding
    /// in steps longer than some 1e6 times its fastest swing. Errors: CD_ERROR_VALUE for anything but 0 and 1;
    /// CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched end; CD_ERROR_MEMORY.
    pub fn get_ring(&self) -> Result<bool> {
        let mut out_ring = 0;
        check(unsafe { sys::cd_chain_get_ring(self.as_ptr(), &mut out_ring) })?;
        Ok(out_ring != 0)
    }

    /// Lets what has come to rest sleep: steps leave it as it is, at hardly any cost. Strands of a rope do so one by
    /// one, others together. One stops, and sleeps, once for some `seconds` \[s\], in \[1e-30, 1e60\], no step left a
    /// free node of it faster than `speed` \[m/s\], in \[0, 1e60\], nor a held one moving. Energy is lost and none
    /// gained. Neglected is a mean acceleration of up to 2 speed / seconds: let that be little beside gravity, or what
    /// is thrown may stay in the air. speed 0, the default: nothing sleeps, and seconds means nothing and is 0. A plane
    /// or capsule that moves wakes what it could touch in the next step; a bed that moves, or a callback, keeps all
    /// awake. What changes a strand wakes it, with whatever numbers: a write, an impulse, a teleport, an attachment, a
    /// cut; what is set wakes all, but for the hook, the kernels and the tolerance. Who sleeps is part of the state.
    /// Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
    pub fn set_sleep(&mut self, speed: f64, seconds: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_sleep(self.as_ptr(), speed, seconds) })
    }

    /// Lets what has come to rest sleep: steps leave it as it is, at hardly any cost. Strands of a rope do so one by
    /// one, others together. One stops, and sleeps, once for some `seconds` \[s\], in \[1e-30, 1e60\], no step left a
    /// free node of it faster than `speed` \[m/s\], in \[0, 1e60\], nor a held one moving. Energy is lost and none
    /// gained. Neglected is a mean acceleration of up to 2 speed / seconds: let that be little beside gravity, or what
    /// is thrown may stay in the air. speed 0, the default: nothing sleeps, and seconds means nothing and is 0. A plane
    /// or capsule that moves wakes what it could touch in the next step; a bed that moves, or a callback, keeps all
    /// awake. What changes a strand wakes it, with whatever numbers: a write, an impulse, a teleport, an attachment, a
    /// cut; what is set wakes all, but for the hook, the kernels and the tolerance. Who sleeps is part of the state.
    /// Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
    pub fn get_sleep(&self) -> Result<ChainSleep> {
        let mut out_speed = 0.0;
        let mut out_seconds = 0.0;
        check(unsafe { sys::cd_chain_get_sleep(self.as_ptr(), &mut out_speed, &mut out_seconds) })?;
        Ok(ChainSleep {
            speed: out_speed,
            seconds: out_seconds,
        })
    }

    /// How many nodes are awake: those that the next step moves.
    pub fn get_awake(&self) -> Result<usize> {
        let mut out_nodes = 0;
        check(unsafe { sys::cd_chain_get_awake(self.as_ptr(), &mut out_nodes) })?;
        Ok(out_nodes)
    }

    /// Rest length of a strand \[m\], 0 or in \[1e-60, 1e60\]; default 0: no rope. Per spring: length / springs; nodes
    /// stay where they are. A rope has the fields CD_TENSION, at first 0, and CD_STRAIN. Its strands are individuals:
    /// each has its own pins, masses, stiffnesses, bends, rest lengths and attachments, at first those that they
    /// shared. Length 0 switches CD_TENSION off, and CD_REST_LENGTH, rest angles, strength, air, wind and colliders
    /// too. Reeled in or paid out a little every step, it is a winch. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY;
    /// CD_ERROR_UNSUPPORTED with 4 components or no spring, and for 0 where strands differ in what they would share, or
    /// an infinite stiffness would weld all springs or two held nodes.
    pub fn set_rest_length(&mut self, length: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_rest_length(self.as_ptr(), length) })
    }

    /// Rest length of a strand \[m\], 0 or in \[1e-60, 1e60\]; default 0: no rope. Per spring: length / springs; nodes
    /// stay where they are. A rope has the fields CD_TENSION, at first 0, and CD_STRAIN. Its strands are individuals:
    /// each has its own pins, masses, stiffnesses, bends, rest lengths and attachments, at first those that they
    /// shared. Length 0 switches CD_TENSION off, and CD_REST_LENGTH, rest angles, strength, air, wind and colliders
    /// too. Reeled in or paid out a little every step, it is a winch. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY;
    /// CD_ERROR_UNSUPPORTED with 4 components or no spring, and for 0 where strands differ in what they would share, or
    /// an infinite stiffness would weld all springs or two held nodes.
    pub fn get_rest_length(&self) -> Result<f64> {
        let mut out_length = 0.0;
        check(unsafe { sys::cd_chain_get_rest_length(self.as_ptr(), &mut out_length) })?;
        Ok(out_length)
    }

    /// Rest angle of a strand \[rad\], by which its last spring is turned from its first at rest, from the first axis
    /// to the second; default 0: straight. Per node with two neighbours: angle / (springs - 1), at most pi in size. It
    /// is what bend bends about, so it does nothing without bend, and turns with the rope: curls, hooks, tentacles,
    /// blades of grass. The field CD_REST_ANGLE has one for each node. Where springs push, a rod takes its shape by
    /// turning, else also by going slack. Errors: CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a chain that is no rope, or,
    /// but for 0, without 2 components: in space a curl needs to know how its links are twisted, which nodes do not
    /// tell.
    pub fn set_rest_angle(&mut self, angle: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_rest_angle(self.as_ptr(), angle) })
    }

    /// Rest angle of a strand \[rad\], by which its last spring is turned from its first at rest, from the first axis
    /// to the second; default 0: straight. Per node with two neighbours: angle / (springs - 1), at most pi in size. It
    /// is what bend bends about, so it does nothing without bend, and turns with the rope: curls, hooks, tentacles,
    /// blades of grass. The field CD_REST_ANGLE has one for each node. Where springs push, a rod takes its shape by
    /// turning, else also by going slack. Errors: CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a chain that is no rope, or,
    /// but for 0, without 2 components: in space a curl needs to know how its links are twisted, which nodes do not
    /// tell.
    pub fn get_rest_angle(&self) -> Result<f64> {
        let mut out_angle = 0.0;
        check(unsafe { sys::cd_chain_get_rest_angle(self.as_ptr(), &mut out_angle) })?;
        Ok(out_angle)
    }

    /// Whether springs with a length push when shorter (1) or are slack (0, the default). Links that push are solved by
    /// Newton's method alone, which may fail from a crumpled start, or where hardly any bend holds them at long steps:
    /// of the first 15 steps of 20 or 50 links laid at random one in 700, which moves too little. Errors:
    /// CD_ERROR_VALUE.
    pub fn set_push(&mut self, push: bool) -> Result<()> {
        check(unsafe { sys::cd_chain_set_push(self.as_ptr(), i32::from(push)) })
    }

    /// Whether springs with a length push when shorter (1) or are slack (0, the default). Links that push are solved by
    /// Newton's method alone, which may fail from a crumpled start, or where hardly any bend holds them at long steps:
    /// of the first 15 steps of 20 or 50 links laid at random one in 700, which moves too little. Errors:
    /// CD_ERROR_VALUE.
    pub fn get_push(&self) -> Result<bool> {
        let mut out_push = 0;
        check(unsafe { sys::cd_chain_get_push(self.as_ptr(), &mut out_push) })?;
        Ok(out_push != 0)
    }

    /// The tension at which a spring breaks \[N\], 1e-60 to 1e60, or INFINITY, the default: springs hold. A rope's step
    /// ends by cutting, of each strand, the spring whose tension is most beyond its strength: its stiffness and tension
    /// become 0, and the next step shows what the others bear. Where a step ends short of its tolerance and leaves
    /// springs of fixed length longer than that allows, as between held nodes that are driven apart, no tension is
    /// large enough: then, of the springs between the held nodes on both sides of the longest one, the weakest breaks.
    /// Mend a spring by writing CD_STIFFNESS, which a finite strength switches on and keeps on. The field CD_STRENGTH
    /// has one for each spring. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of a chain that is no
    /// rope.
    pub fn set_strength(&mut self, strength: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_strength(self.as_ptr(), strength) })
    }

    /// The tension at which a spring breaks \[N\], 1e-60 to 1e60, or INFINITY, the default: springs hold. A rope's step
    /// ends by cutting, of each strand, the spring whose tension is most beyond its strength: its stiffness and tension
    /// become 0, and the next step shows what the others bear. Where a step ends short of its tolerance and leaves
    /// springs of fixed length longer than that allows, as between held nodes that are driven apart, no tension is
    /// large enough: then, of the springs between the held nodes on both sides of the longest one, the weakest breaks.
    /// Mend a spring by writing CD_STIFFNESS, which a finite strength switches on and keeps on. The field CD_STRENGTH
    /// has one for each spring. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of a chain that is no
    /// rope.
    pub fn get_strength(&self) -> Result<f64> {
        let mut out_strength = 0.0;
        check(unsafe { sys::cd_chain_get_strength(self.as_ptr(), &mut out_strength) })?;
        Ok(out_strength)
    }

    /// How many springs broke in the last call of cd_chain_step that made steps: those whose CD_STIFFNESS became 0.
    pub fn get_broken(&self) -> Result<usize> {
        let mut out_springs = 0;
        check(unsafe { sys::cd_chain_get_broken(self.as_ptr(), &mut out_springs) })?;
        Ok(out_springs)
    }

    /// The force \[N\], one number per component, with which the springs of a rope pull at a node, and its bend: of a
    /// held node, what the rope does to whatever holds it. It is the sum of the springs' tensions, along their
    /// directions now (0 of a spring without length), and of the forces of the bend at the node and at the nodes beside
    /// it. After a step that ended short of its tolerance tensions are a guess, 0 or at most the sum of the forces of
    /// springs on each node in that step: a rope of fixed length has no tension that holds a driven end which would
    /// stretch it. To tie a rope to a body of your own, give the last node its mass, in CD_MASS; or drive an end of a
    /// rope of finite stiffness. Where tensions are read, or a strength is set, take lambda = 1. With 1/2 \< lambda \<
    /// 1 they miss up to a third of the pull of hardly yielding springs where nodes swing; with 1/2 those can be twice
    /// the mean just after a jolt. With lambda \< 1 a load paid out by springs of infinite stiffness is let fall and
    /// caught by turns where dt^2 times gravity is less than 5 tolerance \* length: of 10 kg on 4 m of rope at dt =
    /// 1/960 s they are 6 N and 190 N; a smaller tolerance helps. Errors: CD_ERROR_RANGE; CD_ERROR_UNSUPPORTED of a
    /// chain that is no rope.
    pub fn get_reaction(&self, strand: usize, node: usize, out_force: &mut [f64]) -> Result<()> {
        let count = count_of(out_force.len(), 1, "cd_chain_get_reaction", "out_force")?;
        check(unsafe { sys::cd_chain_get_reaction(self.as_ptr(), strand, node, out_force.as_mut_ptr(), count) })
    }

    /// Resistance of the air, per length of a rope \[N s/m^2\], in \[0, 1e60\], default 0: a piece of length s whose
    /// velocity through the air is w, w_t along the rope and w_n across it, is pushed by -s (along w_t + across w_n).
    /// Implicit, so that it only takes energy, as seen from the air, at any dt; the rope's direction is the one that it
    /// would have lambda dt after the step began. A node bears half of its two springs' rest lengths, at most 1e10 m /
    /// dt \[N s/m\] where its mass is m; cut springs feel no air. A round rope of diameter d has some across = 0.6
    /// density d |w_n|, and along a hundredth of that. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of
    /// a chain that is no rope.
    pub fn set_air(&mut self, along: f64, across: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_air(self.as_ptr(), along, across) })
    }

    /// Resistance of the air, per length of a rope \[N s/m^2\], in \[0, 1e60\], default 0: a piece of length s whose
    /// velocity through the air is w, w_t along the rope and w_n across it, is pushed by -s (along w_t + across w_n).
    /// Implicit, so that it only takes energy, as seen from the air, at any dt; the rope's direction is the one that it
    /// would have lambda dt after the step began. A node bears half of its two springs' rest lengths, at most 1e10 m /
    /// dt \[N s/m\] where its mass is m; cut springs feel no air. A round rope of diameter d has some across = 0.6
    /// density d |w_n|, and along a hundredth of that. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of
    /// a chain that is no rope.
    pub fn get_air(&self) -> Result<ChainAir> {
        let mut out_along = 0.0;
        let mut out_across = 0.0;
        check(unsafe { sys::cd_chain_get_air(self.as_ptr(), &mut out_along, &mut out_across) })?;
        Ok(ChainAir {
            along: out_along,
            across: out_across,
        })
    }

    /// Velocity of that air \[m/s\], one number per component, default 0; the field CD_WIND has one for each node.
    /// Errors: CD_ERROR_VALUE; CD_ERROR_RANGE if count is not the number of components; set: CD_ERROR_UNSUPPORTED of a
    /// chain that is no rope.
    pub fn set_wind(&mut self, velocity: &[f64]) -> Result<()> {
        let count = count_of(velocity.len(), 1, "cd_chain_set_wind", "velocity")?;
        check(unsafe { sys::cd_chain_set_wind(self.as_ptr(), velocity.as_ptr(), count) })
    }

    /// Velocity of that air \[m/s\], one number per component, default 0; the field CD_WIND has one for each node.
    /// Errors: CD_ERROR_VALUE; CD_ERROR_RANGE if count is not the number of components; set: CD_ERROR_UNSUPPORTED of a
    /// chain that is no rope.
    pub fn get_wind(&self, out_velocity: &mut [f64]) -> Result<()> {
        let count = count_of(out_velocity.len(), 1, "cd_chain_get_wind", "out_velocity")?;
        check(unsafe { sys::cd_chain_get_wind(self.as_ptr(), out_velocity.as_mut_ptr(), count) })
    }

    /// When a step of a rope ends: when every spring is as long as its tension makes it, but for `tolerance` times its
    /// rest length, and springs gave no more energy than such errors are worth. A slack spring that is shorter by the
    /// fraction s may keep a tension of tolerance / s times the mean force on the nodes, or the mean tension. In
    /// \[1e-14, 1/2\], default 1e-6; above 1e-4 it costs more time, not less, since the next step must correct what one
    /// leaves. most_iterations, 1 to 10000, default 200, limits the slow and sure method, an interior point, which
    /// follows on at most 16 iterations of Newton's; where springs push, it limits Newton's. Errors: CD_ERROR_VALUE.
    pub fn set_tolerance(&mut self, tolerance: f64, most_iterations: usize) -> Result<()> {
        check(unsafe { sys::cd_chain_set_tolerance(self.as_ptr(), tolerance, most_iterations) })
    }

    /// When a step of a rope ends: when every spring is as long as its tension makes it, but for `tolerance` times its
    /// rest length, and springs gave no more energy than such errors are worth. A slack spring that is shorter by the
    /// fraction s may keep a tension of tolerance / s times the mean force on the nodes, or the mean tension. In
    /// \[1e-14, 1/2\], default 1e-6; above 1e-4 it costs more time, not less, since the next step must correct what one
    /// leaves. most_iterations, 1 to 10000, default 200, limits the slow and sure method, an interior point, which
    /// follows on at most 16 iterations of Newton's; where springs push, it limits Newton's. Errors: CD_ERROR_VALUE.
    pub fn get_tolerance(&self) -> Result<ChainTolerance> {
        let mut out_tolerance = 0.0;
        let mut out_most_iterations = 0;
        check(unsafe { sys::cd_chain_get_tolerance(self.as_ptr(), &mut out_tolerance, &mut out_most_iterations) })?;
        Ok(ChainTolerance {
            tolerance: out_tolerance,
            most_iterations: out_most_iterations,
        })
    }

    /// What the last call of cd_chain_step did with ropes: the most iterations that a step of a strand took, and the
    /// largest error it ended with, as the tolerance counts it, or INFINITY. 0 and 0 without ropes. Each output may be
    /// null.
    pub fn get_convergence(&self) -> Result<ChainConvergence> {
        let mut out_iterations = 0;
        let mut out_residual = 0.0;
        check(unsafe { sys::cd_chain_get_convergence(self.as_ptr(), &mut out_iterations, &mut out_residual) })?;
        Ok(ChainConvergence {
            iterations: out_iterations,
            residual: out_residual,
        })
    }

    /// How many colliders there are, 0 to 4096, default 0: new ones are CD_SHAPE_NONE, those that stay keep what they
    /// are. Rest length 0 takes them away. Errors: CD_ERROR_MEMORY.
    pub fn set_colliders(&mut self, count: usize) -> Result<()> {
        check(unsafe { sys::cd_chain_set_colliders(self.as_ptr(), count) })
    }

    /// How many colliders there are, 0 to 4096, default 0: new ones are CD_SHAPE_NONE, those that stay keep what they
    /// are. Rest length 0 takes them away. Errors: CD_ERROR_MEMORY.
    pub fn get_colliders(&self) -> Result<usize> {
        let mut out_count = 0;
        check(unsafe { sys::cd_chain_get_colliders(self.as_ptr(), &mut out_count) })?;
        Ok(out_count)
    }

    /// Makes a collider the half space behind the plane through `point` \[m\] that `normal`, of any length but 0,
    /// points out of; one number per component each, at most 1e60 in size. friction, 0 to 1e60, is Coulomb's
    /// coefficient.
    pub fn set_plane(&mut self, index: usize, point: &[f64], normal: &[f64], friction: f64) -> Result<()> {
        let count = count_of(point.len(), 1, "cd_chain_set_plane", "point")?;
        same(Some(normal.len()), count.checked_mul(1), "cd_chain_set_plane", "normal")?;
        check(unsafe { sys::cd_chain_set_plane(self.as_ptr(), index, point.as_ptr(), normal.as_ptr(), count,
            friction) })
    }

    /// Makes a collider all that is less than `radius` \[m\], 1e-60 to 1e60, away from the line between two ends: a
    /// sphere where they are the same.
    pub fn set_capsule(&mut self, index: usize, first: &[f64], last: &[f64], radius: f64, friction: f64) -> Result<()> {
        let count = count_of(first.len(), 1, "cd_chain_set_capsule", "first")?;
        same(Some(last.len()), count.checked_mul(1), "cd_chain_set_capsule", "last")?;
        check(unsafe { sys::cd_chain_set_capsule(self.as_ptr(), index, first.as_ptr(), last.as_ptr(), count, radius,
            friction) })
    }

    /// Makes a collider all that lies below a bed of heights \[m\], at most 1e60 in size, which are copied. The last
    /// component is up. With 3 components heights\[j \* columns + i\] is at the first two components origin + (i
    /// column_spacing, j row_spacing), of at least 2 columns and rows; with 2 components a single row is along the
    /// first one, and row_spacing means nothing. Heights count from the origin's own; spacings \[m\] are 1e-60 to 1e60.
    /// Between heights the bed is bilinear, with creases rounded within a quarter of the spacing either side; beyond
    /// the border it goes on at the border's height. How far outside a node is, is its height above the bed times the
    /// upward part of the bed's normal. A step meets the bed at the plane that touches it there where it finds the
    /// node. What the bed rises above that plane on the node's way the node may end inside of, and the next step takes
    /// it out; however fast, none falls through. Errors: CD_ERROR_RANGE too, if height_count is not columns \* rows;
    /// CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED with 1 component.
    pub fn set_bed(&mut self, index: usize, origin: &[f64], columns: usize, rows: usize, column_spacing: f64,
        row_spacing: f64, heights: &[f64], friction: f64) -> Result<()> {
        let count = count_of(origin.len(), 1, "cd_chain_set_bed", "origin")?;
        let height_count = count_of(heights.len(), 1, "cd_chain_set_bed", "heights")?;
        check(unsafe { sys::cd_chain_set_bed(self.as_ptr(), index, origin.as_ptr(), count, columns, rows,
            column_spacing, row_spacing, heights.as_ptr(), height_count, friction) })
    }

    /// Each output may be null; 0 columns and rows of what is no bed. Errors: CD_ERROR_RANGE for an index that no
    /// collider has, and, with out_heights, if height_count is not columns \* rows.
    pub fn get_bed(&self, index: usize, out_heights: Option<&mut [f64]>) -> Result<ChainBed> {
        let height_count = out_heights.as_deref().map(<[_]>::len);
        let height_count = count_of(height_count.unwrap_or(0), 1, "cd_chain_get_bed", "out_heights")?;
        let mut out_columns = 0;
        let mut out_rows = 0;
        check(unsafe { sys::cd_chain_get_bed(self.as_ptr(), index, &mut out_columns, &mut out_rows,
            out_heights.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr), height_count) })?;
        Ok(ChainBed {
            columns: out_columns,
            rows: out_rows,
        })
    }

    /// Makes a collider the shape that a callback tells the distances of, whose positions are relative to origin \[m\].
    /// A step asks for all nodes of a strand at once, at its start and then in each iteration where they would end.
    /// Where a shape is hollow it is met as beds are. Where an answer is not what cd_distance says, that step takes it
    /// for nothing there, and cd_chain_step says CD_ERROR_CALLBACK. The callback itself is no state: after a load, or a
    /// copied state, a collider that was CD_SHAPE_CALLBACK before goes on with the one it had, and for any other
    /// cd_chain_step says CD_ERROR_UNSUPPORTED until it is set again. origin may be null: a collider that is
    /// CD_SHAPE_CALLBACK stays as it is and gets this callback; count and friction mean nothing then. Errors:
    /// CD_ERROR_NULL too, for a table without a function; CD_ERROR_MEMORY.
    ///
    /// # Safety
    /// The functions and `user` must be good for as long as the object may call them, from whichever threads
    /// it is used on, and must not unwind.
    pub unsafe fn set_callback(&mut self, index: usize, distance: Option<&sys::cd_distance>, origin: Option<&[f64]>,
        friction: f64) -> Result<()> {
        let count = origin.map(<[_]>::len);
        let count = count_of(count.unwrap_or(0), 1, "cd_chain_set_callback", "origin")?;
        check(unsafe { sys::cd_chain_set_callback(self.as_ptr(), index, distance.map_or(std::ptr::null(),
            |c| c as *const _), origin.map_or(std::ptr::null(), <[_]>::as_ptr), count, friction) })
    }

    /// Makes a collider CD_SHAPE_NONE, at rest: nothing touches it.
    pub fn remove_collider(&mut self, index: usize) -> Result<()> {
        check(unsafe { sys::cd_chain_remove_collider(self.as_ptr(), index) })
    }

    /// Velocity of a collider \[m/s\], default 0, one number per component, at most 1e60 in size: steps move it, and it
    /// carries what it touches along. It keeps its velocity when it is made another shape. A capsule that turns: before
    /// each step put it where it will be after it, less dt times its middle's velocity, and give it that: cloth on
    /// limbs that swing at 3.6 rad/s ends up to 2e-3 m inside in steps of 1/30 s; put where the step begins, 3.5e-2 m.
    pub fn set_collider_velocity(&mut self, index: usize, velocity: &[f64]) -> Result<()> {
        let count = count_of(velocity.len(), 1, "cd_chain_set_collider_velocity", "velocity")?;
        check(unsafe { sys::cd_chain_set_collider_velocity(self.as_ptr(), index, velocity.as_ptr(), count) })
    }

    /// What a collider is, and where now: of a plane its point and its normal, of length 1; of a capsule its two ends;
    /// of a bed its origin and its spacings, 0 upward; of a callback its origin; else zeros, but for its velocity. One
    /// number per component in each array. Each output may be null. Errors: CD_ERROR_RANGE for an index that no
    /// collider has, or a count that is not the number of components.
    pub fn get_collider(&self, index: usize, out_first: Option<&mut [f64]>, out_second: Option<&mut [f64]>,
        out_velocity: Option<&mut [f64]>) -> Result<ChainCollider> {
        let count = out_first.as_deref().map(<[_]>::len);
        let count = count.or(out_second.as_deref().map(<[_]>::len));
        let count = count.or(out_velocity.as_deref().map(<[_]>::len));
        let count = count_of(count.unwrap_or(0), 1, "cd_chain_get_collider", "out_first")?;
        same(out_second.as_deref().map(<[_]>::len), count.checked_mul(1), "cd_chain_get_collider", "out_second")?;
        same(out_velocity.as_deref().map(<[_]>::len), count.checked_mul(1), "cd_chain_get_collider", "out_velocity")?;
        let mut out_shape = 0;
        let mut out_radius = 0.0;
        let mut out_friction = 0.0;
        check(unsafe { sys::cd_chain_get_collider(self.as_ptr(), index, &mut out_shape,
            out_first.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr), out_second.map_or(std::ptr::null_mut(),
            <[_]>::as_mut_ptr), out_velocity.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr), count, &mut out_radius,
            &mut out_friction) })?;
        Ok(ChainCollider {
            shape: known(Shape::from_raw(out_shape), out_shape, "cd_chain_get_collider")?,
            radius: out_radius,
            friction: out_friction,
        })
    }

    /// Whether steps note what ropes do to colliders: 1, or 0, the default. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
    pub fn set_loads(&mut self, loads: bool) -> Result<()> {
        check(unsafe { sys::cd_chain_set_loads(self.as_ptr(), i32::from(loads)) })
    }

    /// Whether steps note what ropes do to colliders: 1, or 0, the default. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
    pub fn get_loads(&self) -> Result<bool> {
        let mut out_loads = 0;
        check(unsafe { sys::cd_chain_get_loads(self.as_ptr(), &mut out_loads) })?;
        Ok(out_loads != 0)
    }

    /// What the nodes of all strands did to a collider, pushes and friction, in the last step, in the mean over its
    /// time: 6 numbers, the force along x, y and z \[N\] and its moment about the origin \[N m\]; about a point p it is
    /// less by p x force. Momentum of ropes changes by what all else gives, less this, but 0 is told of a strand whose
    /// step ended short of its tolerance. What a node forgets of the speed at which it came out of a collider is not
    /// given. A strand that sleeps bears as in its last step. 0 before a step. Part of the state. Errors:
    /// CD_ERROR_RANGE for index, or if count is not 6; CD_ERROR_DISABLED unless cd_chain_set_loads has asked for it.
    pub fn get_collider_load(&self, index: usize, out_load: &mut [f64]) -> Result<()> {
        let count = count_of(out_load.len(), 1, "cd_chain_get_collider_load", "out_load")?;
        check(unsafe { sys::cd_chain_get_collider_load(self.as_ptr(), index, out_load.as_mut_ptr(), count) })
    }

    /// How thick ropes are, as a radius \[m\] in \[0, 1e60\], default 0: nodes stay this far outside of colliders.
    pub fn set_thickness(&mut self, radius: f64) -> Result<()> {
        check(unsafe { sys::cd_chain_set_thickness(self.as_ptr(), radius) })
    }

    /// How thick ropes are, as a radius \[m\] in \[0, 1e60\], default 0: nodes stay this far outside of colliders.
    pub fn get_thickness(&self) -> Result<f64> {
        let mut out_radius = 0.0;
        check(unsafe { sys::cd_chain_get_thickness(self.as_ptr(), &mut out_radius) })?;
        Ok(out_radius)
    }

    /// Switches a field on, filled with the present uniform values (force 0, target the present position). On already:
    /// nothing happens. CD_STRENGTH switches CD_STIFFNESS on too. Errors: CD_ERROR_ENUM, CD_ERROR_MEMORY;
    /// CD_ERROR_DIVERGED for CD_TARGET where the state is not finite; here and below CD_ERROR_UNSUPPORTED for the
    /// fields of ropes of a chain that is none.
    pub fn enable_field(&mut self, field: Field) -> Result<()> {
        check(unsafe { sys::cd_chain_enable_field(self.as_ptr(), field as i32) })
    }

    /// Switches a field off and releases its memory: uniform values again, no forces, all attachments loosened. Errors:
    /// CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for position, velocity, pin, tension and strain, and for stiffness where
    /// springs may break.
    pub fn disable_field(&mut self, field: Field) -> Result<()> {
        check(unsafe { sys::cd_chain_disable_field(self.as_ptr(), field as i32) })
    }

    /// Writes or reads values\[strand\]\[node\]\[component\], dense, of strands \[first_strand, first_strand + strands)
    /// and nodes (or springs) \[first, first + n). Fields without components have one value per node; fields that the
    /// strands share have the single strand 0. `count` is the number of values in the buffer: strands \* n \*
    /// components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
    /// CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and
    /// CD_ERROR_UNSUPPORTED for CD_STRAIN.
    pub fn write_f32(&mut self, field: Field, first_strand: usize, strands: usize, first: usize, n: usize,
        values: &[f32]) -> Result<()> {
        let count = count_of(values.len(), 1, "cd_chain_write_f32", "values")?;
        check(unsafe { sys::cd_chain_write_f32(self.as_ptr(), field as i32, first_strand, strands, first, n,
            values.as_ptr(), count) })
    }

    /// Writes or reads values\[strand\]\[node\]\[component\], dense, of strands \[first_strand, first_strand + strands)
    /// and nodes (or springs) \[first, first + n). Fields without components have one value per node; fields that the
    /// strands share have the single strand 0. `count` is the number of values in the buffer: strands \* n \*
    /// components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
    /// CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and
    /// CD_ERROR_UNSUPPORTED for CD_STRAIN.
    pub fn write_f64(&mut self, field: Field, first_strand: usize, strands: usize, first: usize, n: usize,
        values: &[f64]) -> Result<()> {
        let count = count_of(values.len(), 1, "cd_chain_write_f64", "values")?;
        check(unsafe { sys::cd_chain_write_f64(self.as_ptr(), field as i32, first_strand, strands, first, n,
            values.as_ptr(), count) })
    }

    /// Writes or reads values\[strand\]\[node\]\[component\], dense, of strands \[first_strand, first_strand + strands)
    /// and nodes (or springs) \[first, first + n). Fields without components have one value per node; fields that the
    /// strands share have the single strand 0. `count` is the number of values in the buffer: strands \* n \*
    /// components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
    /// CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and
    /// CD_ERROR_UNSUPPORTED for CD_STRAIN.
    pub fn read_f32(&self, field: Field, first_strand: usize, strands: usize, first: usize, n: usize,
        out_values: &mut [f32]) -> Result<()> {
        let count = count_of(out_values.len(), 1, "cd_chain_read_f32", "out_values")?;
        check(unsafe { sys::cd_chain_read_f32(self.as_ptr(), field as i32, first_strand, strands, first, n,
            out_values.as_mut_ptr(), count) })
    }

    /// Writes or reads values\[strand\]\[node\]\[component\], dense, of strands \[first_strand, first_strand + strands)
    /// and nodes (or springs) \[first, first + n). Fields without components have one value per node; fields that the
    /// strands share have the single strand 0. `count` is the number of values in the buffer: strands \* n \*
    /// components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
    /// CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index, and
    /// CD_ERROR_UNSUPPORTED for CD_STRAIN.
    pub fn read_f64(&self, field: Field, first_strand: usize, strands: usize, first: usize, n: usize,
        out_values: &mut [f64]) -> Result<()> {
        let count = count_of(out_values.len(), 1, "cd_chain_read_f64", "out_values")?;
        check(unsafe { sys::cd_chain_read_f64(self.as_ptr(), field as i32, first_strand, strands, first, n,
            out_values.as_mut_ptr(), count) })
    }

    /// Where a field lies in the chain's own memory, in the chain's precision, to read without a copy: the value of
    /// (strand, node, component) is at byte \*out_data + strand \* strand_stride + node \* node_stride + component \*
    /// component_stride. Position, velocity, force and target only. The pointer is good until the field is switched off
    /// or the chain released; the numbers change with every write and step. Do not write through it. Errors:
    /// CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_UNSUPPORTED.
    pub fn view(&self, field: Field) -> Result<View<'_>> {
        let mut data = std::ptr::null();
        let mut strides = [0; 3];
        let [s0, s1, s2] = &mut strides;
        check(unsafe { sys::cd_chain_view(self.as_ptr(), field as i32, &mut data, s0, s1, s2) })?;
        Ok(View::new(data.cast(), strides, self.whole(field)?, self.get_shape()?.precision))
    }

    /// Adds impulse \[N s\], one number per component, to a node: its velocity changes by impulse / mass, in a welded
    /// group by impulse / the group's mass; a held node takes none. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE,
    /// CD_ERROR_DIVERGED.
    pub fn impulse(&mut self, strand: usize, node: usize, impulse: &[f64]) -> Result<()> {
        let count = count_of(impulse.len(), 1, "cd_chain_impulse", "impulse")?;
        check(unsafe { sys::cd_chain_impulse(self.as_ptr(), strand, node, impulse.as_ptr(), count) })
    }

    /// Moves a strand as a whole, as if it had always been there: every position and target becomes rotation \* x +
    /// offset, every velocity rotation \* v; tensions stay, and colliders stay where they are. rotation: components
    /// rows of as many numbers, orthogonal to 1e-6, with rest angles no mirror image; null: none. offset \[m\]: one
    /// number per component, which count counts. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE; CD_ERROR_DIVERGED for a state
    /// that is not finite.
    pub fn teleport(&mut self, strand: usize, rotation: Option<&[f64]>, offset: &[f64]) -> Result<()> {
        let count = count_of(offset.len(), 1, "cd_chain_teleport", "offset")?;
        same(rotation.map(<[_]>::len), count.checked_mul(count), "cd_chain_teleport", "rotation")?;
        check(unsafe { sys::cd_chain_teleport(self.as_ptr(), strand, rotation.map_or(std::ptr::null(), <[_]>::as_ptr),
            offset.as_ptr(), count) })
    }

    /// Ties a node to its target by a spring of `stiffness` \[N/m\] \>= 0 and `damping` \[N s/m\] \>= 0, as a mouse
    /// drag does. In a rope it is the node of this strand; in a chain that is no rope `strand` must be 0, and the node
    /// of every strand is tied. target, one number per component, is given to every strand that is tied; null: the
    /// present position, and count means nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the
    /// numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and
    /// CD_ERROR_DIVERGED for a state that is not finite.
    pub fn attach(&mut self, strand: usize, node: usize, stiffness: f64, damping: f64,
        target: Option<&[f64]>) -> Result<()> {
        let count = target.map(<[_]>::len);
        let count = count_of(count.unwrap_or(0), 1, "cd_chain_attach", "target")?;
        check(unsafe { sys::cd_chain_attach(self.as_ptr(), strand, node, stiffness, damping,
            target.map_or(std::ptr::null(), <[_]>::as_ptr), count) })
    }

    /// Ties a node to its target by a spring of `stiffness` \[N/m\] \>= 0 and `damping` \[N s/m\] \>= 0, as a mouse
    /// drag does. In a rope it is the node of this strand; in a chain that is no rope `strand` must be 0, and the node
    /// of every strand is tied. target, one number per component, is given to every strand that is tied; null: the
    /// present position, and count means nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the
    /// numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and
    /// CD_ERROR_DIVERGED for a state that is not finite.
    pub fn detach(&mut self, strand: usize, node: usize) -> Result<()> {
        check(unsafe { sys::cd_chain_detach(self.as_ptr(), strand, node) })
    }

    /// Ties a node to its target by a spring of `stiffness` \[N/m\] \>= 0 and `damping` \[N s/m\] \>= 0, as a mouse
    /// drag does. In a rope it is the node of this strand; in a chain that is no rope `strand` must be 0, and the node
    /// of every strand is tied. target, one number per component, is given to every strand that is tied; null: the
    /// present position, and count means nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the
    /// numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and
    /// CD_ERROR_DIVERGED for a state that is not finite.
    pub fn get_attachment(&self, strand: usize, node: usize) -> Result<ChainAttachment> {
        let mut out_stiffness = 0.0;
        let mut out_damping = 0.0;
        check(unsafe { sys::cd_chain_get_attachment(self.as_ptr(), strand, node, &mut out_stiffness,
            &mut out_damping) })?;
        Ok(ChainAttachment {
            stiffness: out_stiffness,
            damping: out_damping,
        })
    }

    /// Cuts a spring (stiffness 0) or welds it (infinite stiffness), in a rope of this strand; in a chain that is no
    /// rope `strand` must be 0, and it is done in every strand. From a weld on the two nodes share one velocity, the
    /// mean of theirs by mass, so that momentum is kept, and their offset stays as it is. Welding to a held node gives
    /// that node's velocity. A cut or welded spring gets a stiffness again by writing CD_STIFFNESS. Both switch
    /// CD_STIFFNESS on. Bend is not cut with the spring: write CD_BEND. In a rope it is, as long as the stiffness is 0,
    /// and welding fixes the spring's length only. Errors: CD_ERROR_RANGE, CD_ERROR_MEMORY; weld: CD_ERROR_UNSUPPORTED
    /// if it would join two held nodes.
    pub fn cut(&mut self, strand: usize, spring: usize) -> Result<()> {
        check(unsafe { sys::cd_chain_cut(self.as_ptr(), strand, spring) })
    }

    /// Cuts a spring (stiffness 0) or welds it (infinite stiffness), in a rope of this strand; in a chain that is no
    /// rope `strand` must be 0, and it is done in every strand. From a weld on the two nodes share one velocity, the
    /// mean of theirs by mass, so that momentum is kept, and their offset stays as it is. Welding to a held node gives
    /// that node's velocity. A cut or welded spring gets a stiffness again by writing CD_STIFFNESS. Both switch
    /// CD_STIFFNESS on. Bend is not cut with the spring: write CD_BEND. In a rope it is, as long as the stiffness is 0,
    /// and welding fixes the spring's length only. Errors: CD_ERROR_RANGE, CD_ERROR_MEMORY; weld: CD_ERROR_UNSUPPORTED
    /// if it would join two held nodes.
    pub fn weld(&mut self, strand: usize, spring: usize) -> Result<()> {
        check(unsafe { sys::cd_chain_weld(self.as_ptr(), strand, spring) })
    }

    /// Makes `count` steps of dt \[s\] each, 0 or in \[1e-30, 1e30\]: with 0 no time passes, as with 0 steps. Never
    /// allocates. Time is proportional to count \* strands \* nodes \* components. Errors: CD_ERROR_VALUE;
    /// CD_ERROR_DIVERGED if a number leaves the finite range: all steps are made, the message gives the first bad one,
    /// the chain can be read, and steps again after cd_chain_reset, a load, or once finite positions and velocities
    /// have been written; of ropes CD_ERROR_UNSUPPORTED for what they can't have, CD_ERROR_CALLBACK as
    /// cd_chain_set_callback says, and CD_ERROR_TOLERANCE if a step ended short of its tolerance: all steps are made,
    /// and good to the error that cd_chain_get_convergence tells, but for tensions: see cd_chain_get_reaction.
    pub fn step(&mut self, dt: f64, count: usize) -> Result<()> {
        check(unsafe { sys::cd_chain_step(self.as_ptr(), dt, count) })
    }

    /// The longest dt at which CD_METHOD_SYMPLECTIC_EULER stays bounded, whatever method is set: the largest dt with 4
    /// M - 2 dt C - dt^2 K positive definite. Exact for stretch with drag and stiffness damping; with bend a lower
    /// bound, exact in the limit of many nodes; with matched ends and attachment damping a lower bound, and close.
    /// INFINITY if nothing can swing. Errors: CD_ERROR_UNSUPPORTED of ropes.
    pub fn stable_dt(&self) -> Result<f64> {
        let mut out_dt = 0.0;
        check(unsafe { sys::cd_chain_stable_dt(self.as_ptr(), &mut out_dt) })?;
        Ok(out_dt)
    }

    /// Simulated time \[s\] and steps made since create or reset, those before a load or a copied state included.
    pub fn get_time(&self) -> Result<f64> {
        let mut out_time = 0.0;
        check(unsafe { sys::cd_chain_get_time(self.as_ptr(), &mut out_time) })?;
        Ok(out_time)
    }

    /// Simulated time \[s\] and steps made since create or reset, those before a load or a copied state included.
    pub fn get_steps(&self) -> Result<u64> {
        let mut out_steps = 0;
        check(unsafe { sys::cd_chain_get_steps(self.as_ptr(), &mut out_steps) })?;
        Ok(out_steps)
    }

    /// How many factorizations the chain has made: one at the first implicit step and one at the first after each
    /// change of dt, lambda, method or a parameter. Ropes make none. Not part of the saved state.
    pub fn get_factorizations(&self) -> Result<u64> {
        let mut out_count = 0;
        check(unsafe { sys::cd_chain_get_factorizations(self.as_ptr(), &mut out_count) })?;
        Ok(out_count)
    }

    /// Energies of all strands together \[J\]; each output may be null. Kinetic: of the free nodes. Elastic: stretch,
    /// bend and attachments; a welded spring holds none. Gravity: -sum m g x of the free nodes. Undamped, lambda = 1/2
    /// keeps their sum, of ropes but for what is told of them.
    pub fn get_energy(&self) -> Result<ChainEnergy> {
        let mut out_kinetic = 0.0;
        let mut out_elastic = 0.0;
        let mut out_gravity = 0.0;
        check(unsafe { sys::cd_chain_get_energy(self.as_ptr(), &mut out_kinetic, &mut out_elastic,
            &mut out_gravity) })?;
        Ok(ChainEnergy {
            kinetic: out_kinetic,
            elastic: out_elastic,
            gravity: out_gravity,
        })
    }

    /// Momentum of the free nodes of all strands together \[kg m/s\], one number per component. Errors: CD_ERROR_RANGE
    /// if count is not the number of components.
    pub fn get_momentum(&self, out_momentum: &mut [f64]) -> Result<()> {
        let count = count_of(out_momentum.len(), 1, "cd_chain_get_momentum", "out_momentum")?;
        check(unsafe { sys::cd_chain_get_momentum(self.as_ptr(), out_momentum.as_mut_ptr(), count) })
    }

    /// Positions of one strand at places along it, linear between nodes: at\[j\] in \[0, springs\] (ring: to springs +
    /// 1), out_positions\[j\]\[component\], out_count = n \* components. Errors: CD_ERROR_RANGE if there is no such
    /// strand or out_count is another number; CD_ERROR_ENUM; CD_ERROR_VALUE for a place beyond the strand.
    pub fn sample(&self, strand: usize, at: &[f64], outside: Outside, out_positions: &mut [f64]) -> Result<()> {
        let n = count_of(at.len(), 1, "cd_chain_sample", "at")?;
        let out_count = count_of(out_positions.len(), 1, "cd_chain_sample", "out_positions")?;
        check(unsafe { sys::cd_chain_sample(self.as_ptr(), strand, at.as_ptr(), n, outside as i32,
            out_positions.as_mut_ptr(), out_count) })
    }

    /// Bytes the chain holds from its allocator.
    pub fn get_memory(&self) -> Result<usize> {
        let mut out_bytes = 0;
        check(unsafe { sys::cd_chain_get_memory(self.as_ptr(), &mut out_bytes) })?;
        Ok(out_bytes)
    }

    /// A 64-bit hash of everything cd_chain_save would write. Equal on every machine, compiler and vector width.
    pub fn hash(&self) -> Result<u64> {
        let mut out_hash = 0;
        check(unsafe { sys::cd_chain_hash(self.as_ptr(), &mut out_hash) })?;
        Ok(out_hash)
    }

    /// The whole state as bytes: shape, parameters, fields, time: all the future depends on but the callbacks.
    /// Little-endian on every machine, versioned, with a checksum. save needs size \>= cd_chain_save_size and tells
    /// what it wrote. load needs a chain of the same shape and precision; it switches fields on and off as they were.
    /// Bytes that are damaged, cut short, of a later version or another kind are refused and change nothing. Errors:
    /// save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn save_size(&self) -> Result<usize> {
        let mut out_size = 0;
        check(unsafe { sys::cd_chain_save_size(self.as_ptr(), &mut out_size) })?;
        Ok(out_size)
    }

    /// The whole state as bytes: shape, parameters, fields, time: all the future depends on but the callbacks.
    /// Little-endian on every machine, versioned, with a checksum. save needs size \>= cd_chain_save_size and tells
    /// what it wrote. load needs a chain of the same shape and precision; it switches fields on and off as they were.
    /// Bytes that are damaged, cut short, of a later version or another kind are refused and change nothing. Errors:
    /// save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn save_into(&self, buffer: &mut [u8]) -> Result<usize> {
        let size = buffer.len();
        let mut out_written = 0;
        check(unsafe { sys::cd_chain_save(self.as_ptr(), buffer.as_mut_ptr().cast(), size, &mut out_written) })?;
        Ok(out_written)
    }

    /// The same into a new vector.
    pub fn save(&self) -> Result<Vec<u8>> {
        let mut bytes = vec![0; self.save_size()?];
        let written = self.save_into(&mut bytes)?;
        bytes.truncate(written);
        Ok(bytes)
    }

    /// The whole state as bytes: shape, parameters, fields, time: all the future depends on but the callbacks.
    /// Little-endian on every machine, versioned, with a checksum. save needs size \>= cd_chain_save_size and tells
    /// what it wrote. load needs a chain of the same shape and precision; it switches fields on and off as they were.
    /// Bytes that are damaged, cut short, of a later version or another kind are refused and change nothing. Errors:
    /// save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn load(&mut self, bytes: &[u8]) -> Result<()> {
        let size = bytes.len();
        check(unsafe { sys::cd_chain_load(self.as_ptr(), bytes.as_ptr().cast(), size) })
    }

    /// Makes `chain` what `source` is, as save and load would, without the bytes: the two must agree in shape and
    /// precision. Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn copy_state(&mut self, source: &Chain) -> Result<()> {
        check(unsafe { sys::cd_chain_copy_state(self.as_ptr(), source.as_ptr()) })
    }

    /// Positions, velocities, tensions, time and steps back to 0. Parameters, fields and pins stay; targets too.
    pub fn reset(&mut self) -> Result<()> {
        check(unsafe { sys::cd_chain_reset(self.as_ptr()) })
    }
}

/// What [`Membrane::get_shape`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneShape {
    pub nu: usize,
    pub nv: usize,
    pub components: usize,
    pub precision: Precision,
}

/// What [`Membrane::get_tolerance`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneTolerance {
    pub tolerance: f64,
    pub most_iterations: usize,
}

/// What [`Membrane::get_convergence`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneConvergence {
    pub iterations: usize,
    pub residual: f64,
}

/// What [`Membrane::get_stiffness`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneStiffness {
    pub along_u: f64,
    pub along_v: f64,
}

/// What [`Membrane::get_ring`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneRing {
    pub along_u: bool,
    pub along_v: bool,
}

/// What [`Membrane::get_sleep`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneSleep {
    pub speed: f64,
    pub seconds: f64,
}

/// What [`Membrane::get_rest_length`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneRestLength {
    pub along_u: f64,
    pub along_v: f64,
}

/// What [`Membrane::get_effort`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneEffort {
    pub newton: usize,
    pub gradient: usize,
}

/// What [`Membrane::get_air`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneAir {
    pub along: f64,
    pub across: f64,
}

/// What [`Membrane::get_bed`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneBed {
    pub columns: usize,
    pub rows: usize,
}

/// What [`Membrane::get_collider`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneCollider {
    pub shape: Shape,
    pub radius: f64,
    pub friction: f64,
}

/// What [`Membrane::get_attachment`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneAttachment {
    pub stiffness: f64,
    pub damping: f64,
}

/// What [`Membrane::get_energy`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneEnergy {
    pub kinetic: f64,
    pub elastic: f64,
    pub gravity: f64,
}

/// contdyn: a membrane: nodes joined by springs in two directions: drum, balloon, plate, and with rest lengths
/// cloth.
/// A membrane has `nu` springs along u and `nv` along v, and (nu + 1) (nv + 1) nodes; node (u, v) has the number v
/// (nu + 1) + u wherever nodes are listed. A node has 1 to 4 components that never mix. A direction can be closed
/// to a ring: its last nodes are then joined to the first by one spring more.
/// Energy E = 1/2 sum k_u |x_{u+1,v} - x_{u,v}|^2 + 1/2 sum k_v |x_{u,v+1} - x_{u,v}|^2 + 1/2 sum b (|x_uu|^2 + 2
/// |x_uv|^2 + |x_vv|^2) (Kass 1997, section 8; the thin plate's energy) Motion M x'' + C x' + K x = M g + f +
/// pressure along the normal, K = the Hessian of E, C = drag M + stiffness_damping K
/// Rest length is zero, unless cd_membrane_set_rest_length makes the membrane cloth: a free sheet draws together,
/// and one stretched evenly is held by its edges. A new membrane lies at the origin, at rest, all nodes free, mass
/// 1, stiffness 1 both ways, no bend, gravity and damping, CD_METHOD_IMPLICIT with lambda 1/2, CD_SOLVER_AUTO.
/// Which solver? An implicit step of a sheet without rest lengths has a two-dimensional system to solve, here with
/// h = lambda dt. Leave that to CD_SOLVER_AUTO, or take CD_SOLVER_ALTERNATING for a fixed cost and less memory. A
/// sheet is uniform here if its masses and stiffnesses are the totals dealt out and no node is absent; if nothing
/// holds it but whole rows and columns and at most 16 single nodes, held or attached, these while h (h + damping)
/// (2 k + 16 b) is at most 1e4 times a node's mass; and if with bend each direction is held at both edges or a
/// ring, not both a ring. CD_SOLVER_ALTERNATING rows, then columns (Kass 1997, section 9). Uniform sheets are
/// stable at any stiffness and any dt that stays the same. A motion of the angular frequencies w_u and w_v along
/// the two directions is slowed down as if it were 1 + (w_u h)^2 (w_v h)^2 times as heavy; where the sheet comes to
/// rest does not depend on dt. Other sheets, a plate that is a ring both ways among them, would blow up: their
/// step, not quite linear and at six times the cost, is the best, in energy, of sums of the lines' answers, the
/// velocity and common motion. It leaves slow motions anywhere where fast ones have energy: a plate with a hole was
/// off by all that it swung. CD_SOLVER_COUPLED the system itself, to a tolerance, by conjugate gradients: nothing
/// is slowed down. Uniform sheets without bend and rings take one or two iterations of some ten alternating solves
/// each, others multigrid, 4 to 100 times the cost. It comes to rest where alternating does. Take it where stiff
/// sheets must move in time, or stiff parts against each other: alternating finds only their common motion. It
/// needs many iterations where springs or masses vary at random by decades, plates with free edges hardly stretch
/// or many nodes are tied. CD_SOLVER_AUTO of uniform sheets, for each dt, alternating where the slowest motion
/// (half a wave along each direction, round a ring a whole one, with the kinks at held or attached nodes) is made
/// at most 5% heavier. Else coupled; and so, until cd_membrane_reset, uniform sheets that have been coupled once,
/// whose steps have differed in dt, method, lambda, damping or solver, or of which moving nodes were pinned. At
/// that bound a kick of one of 33 x 33 nodes goes 31 times as far as it should, of a radius of an eighth of the
/// sheet 3.5, of a quarter 1.4. It holds some 300 bytes a node; alternating takes 36 where edges hold it. Builds
/// without coupled solver alternate. Steps are of second order in time, those of alternating plates with stiffness
/// damping of first. Without rest lengths: Energy: lambda = 1/2 keeps it, and lambda \> 1/2 never adds any,
/// whatever the tolerance of coupled solves. Momentum: of a free sheet, and of each part of a torn one, it is kept
/// however stiff they are; alternating, up to a stiffness of 1e19 mass / h^2 of uniform sheets, and a bend of 1e13
/// mass / h^2 of plates with one ring. Unlike steps: alternating, the energy that a uniform sheet keeps counts the
/// extra mass, which depends on dt, lambda and damping. If these keep changing it grows without bound: with lambda
/// = 1/2 or CD_METHOD_STIFF_SECOND by up to an eighth a step where 16 and 17 ms take turns, with lambda = 1 by a
/// quarter where some steps are twice as long. CD_FLOAT32: alternating, the rounding of a velocity is a kick whose
/// energy is so many times larger as the motion is heavier: where (w_u h) (w_v h) is beyond 1e4, take CD_FLOAT64 or
/// the coupled solver. CD_METHOD_STIFF_SECOND: adds no energy where coupled solves meet the default tolerance; a
/// step that ended short of its own has added a third, one that alternates on a sheet that is not uniform a
/// twentieth. What chain.h says of precision and of numbers that are too small holds for sheets too. Parameters may
/// be as large as 1e60, masses as small as 1e-60. Every function returns CD_ERROR_NULL for a null pointer and
/// CD_ERROR_HANDLE for a handle of another kind; the comments name the other errors. Functions that the chain has
/// too mean the same here.
pub struct Membrane {
    handle: NonNull<sys::cd_membrane>,
}

// The library ties objects to no thread. They are not Sync, as NonNull is not.
unsafe impl Send for Membrane {}

impl Drop for Membrane {
    fn drop(&mut self) {
        unsafe { sys::cd_membrane_destroy(self.as_ptr()) }
    }
}

impl std::fmt::Debug for Membrane {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Debug::fmt(&self.get_shape(), f)
    }
}

impl Membrane {
    /// Makes a membrane. nu, nv \>= 0 (0: a single row or column of nodes); components 1 to 4. allocator may be null
    /// (malloc). The caller owns \*out_membrane and releases it with cd_membrane_destroy; on failure \*out_membrane is
    /// left alone. Errors: CD_ERROR_VALUE, CD_ERROR_ENUM, CD_ERROR_SIZE, CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for a
    /// precision that this build leaves out.
    pub fn new(nu: usize, nv: usize, components: usize, precision: Precision) -> Result<Membrane> {
        unsafe { Membrane::create(nu, nv, components, precision, None) }
    }

    /// [`Membrane::new`] with callbacks.
    ///
    /// # Safety
    /// The functions and `user` must be good for as long as the object may call them, from whichever threads
    /// it is used on, and must not unwind.
    pub unsafe fn create(nu: usize, nv: usize, components: usize, precision: Precision,
        allocator: Option<&sys::cd_allocator>) -> Result<Membrane> {
        check_version()?;
        let mut made = std::ptr::null_mut();
        check(unsafe { sys::cd_membrane_create(nu, nv, components, precision as i32, allocator.map_or(std::ptr::null(),
            |c| c as *const _), &mut made) })?;
        Ok(unsafe { Membrane::from_raw(made) })
    }

    /// Takes a handle over.
    ///
    /// # Safety
    /// It must be one of the library's, alive, and of this kind, and nobody else may use it from then on.
    pub unsafe fn from_raw(handle: *mut sys::cd_membrane) -> Membrane {
        Membrane { handle: NonNull::new(handle).expect("a handle") }
    }

    /// The handle, for functions of [`sys`]; it stays this object's.
    pub fn as_ptr(&self) -> *mut sys::cd_membrane {
        self.handle.as_ptr()
    }

    /// Gives the handle away, to be released by the caller.
    pub fn into_raw(self) -> *mut sys::cd_membrane {
        std::mem::ManuallyDrop::new(self).handle.as_ptr()
    }

    fn whole(&self, field: Field) -> Result<Whole> {
        const ROWS: [FieldRow; 18] = [
            FieldRow { field: Field::Position, extents: [1, 1, 0, 2, 1, 0], components: true, one_but_in_ropes: false },
            FieldRow { field: Field::Velocity, extents: [1, 1, 0, 2, 1, 0], components: true, one_but_in_ropes: false },
            FieldRow { field: Field::Force, extents: [1, 1, 0, 2, 1, 0], components: true, one_but_in_ropes: false },
            FieldRow { field: Field::Target, extents: [1, 1, 0, 2, 1, 0], components: true, one_but_in_ropes: false },
            FieldRow { field: Field::Mass, extents: [1, 1, 0, 2, 1, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::StiffnessU, extents: [1, 0, 1, 2, 1, 0], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::StiffnessV, extents: [1, 1, 0, 2, 0, 2], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::Pin, extents: [1, 1, 0, 2, 1, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::Mask, extents: [1, 1, 0, 2, 1, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::RestLengthU, extents: [1, 0, 1, 2, 1, 0], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::RestLengthV, extents: [1, 1, 0, 2, 0, 2], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::BreakingStrainU, extents: [1, 0, 1, 2, 1, 0], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::BreakingStrainV, extents: [1, 1, 0, 2, 0, 2], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::Wind, extents: [1, 1, 0, 2, 1, 0], components: true, one_but_in_ropes: false },
            FieldRow { field: Field::TensionU, extents: [1, 0, 1, 2, 1, 0], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::TensionV, extents: [1, 1, 0, 2, 0, 2], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::StrainU, extents: [1, 0, 1, 2, 1, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::StrainV, extents: [1, 1, 0, 2, 0, 2], components: false, one_but_in_ropes: false },
        ];
        let row = match ROWS.iter().find(|row| row.field == field) {
            Some(row) => row,
            None => return Ok(Whole::default()),
        };
        let shape = self.get_shape()?;
        let ring = self.get_ring()?;
        Ok(Whole::new(row, &[shape.nu, shape.nv], &[ring.along_u, ring.along_v], false, shape.components))
    }

    /// How many values a whole field has.
    pub fn get_size(&self, field: Field) -> Result<usize> {
        let count = self.whole(field)?.count();
        if count == 0 {
            self.read_f64(field, 0, 0, 0, 0, &mut [])?; // says which fields there are
        }
        Ok(count)
    }

    /// All values of a field, as `read_f32` or `read_f64`.
    pub fn read<T: Number>(&self, field: Field) -> Result<Vec<T>> {
        let whole = self.whole(field)?;
        let mut values = vec![T::default(); whole.count()];
        let [a, b, c, d] = whole.range(false);
        let field = field as i32;
        check(unsafe {
            if T::SINGLE {
                sys::cd_membrane_read_f32(self.as_ptr(), field, a, b, c, d, values.as_mut_ptr().cast(), values.len())
            } else {
                sys::cd_membrane_read_f64(self.as_ptr(), field, a, b, c, d, values.as_mut_ptr().cast(), values.len())
            }
        })?;
        Ok(values)
    }

    /// Writes all values of a field, as `write_f32` or `write_f64`.
    pub fn write<T: Number>(&mut self, field: Field, values: &[T]) -> Result<()> {
        let whole = self.whole(field)?;
        let [a, b, c, d] = whole.range(false);
        let field = field as i32;
        check(unsafe {
            if T::SINGLE {
                sys::cd_membrane_write_f32(self.as_ptr(), field, a, b, c, d, values.as_ptr().cast(), values.len())
            } else {
                sys::cd_membrane_write_f64(self.as_ptr(), field, a, b, c, d, values.as_ptr().cast(), values.len())
            }
        })
    }

    /// What cd_membrane_create was given. Each output may be null.
    pub fn get_shape(&self) -> Result<MembraneShape> {
        let mut out_nu = 0;
        let mut out_nv = 0;
        let mut out_components = 0;
        let mut out_precision = 0;
        check(unsafe { sys::cd_membrane_get_shape(self.as_ptr(), &mut out_nu, &mut out_nv, &mut out_components,
            &mut out_precision) })?;
        Ok(MembraneShape {
            nu: out_nu,
            nv: out_nv,
            components: out_components,
            precision: known(Precision::from_raw(out_precision), out_precision, "cd_membrane_get_shape")?,
        })
    }

    /// How steps are made. Methods and solvers differ in the memory they need. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
    pub fn set_method(&mut self, method: Method) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_method(self.as_ptr(), method as i32) })
    }

    /// How steps are made. Methods and solvers differ in the memory they need. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
    pub fn get_method(&self) -> Result<Method> {
        let mut out_method = 0;
        check(unsafe { sys::cd_membrane_get_method(self.as_ptr(), &mut out_method) })?;
        known(Method::from_raw(out_method), out_method, "cd_membrane_get_method")
    }

    /// lambda of CD_METHOD_IMPLICIT, in \[0, 1\]; default 1/2. Errors: CD_ERROR_VALUE.
    pub fn set_lambda(&mut self, lambda: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_lambda(self.as_ptr(), lambda) })
    }

    /// lambda of CD_METHOD_IMPLICIT, in \[0, 1\]; default 1/2. Errors: CD_ERROR_VALUE.
    pub fn get_lambda(&self) -> Result<f64> {
        let mut out_lambda = 0.0;
        check(unsafe { sys::cd_membrane_get_lambda(self.as_ptr(), &mut out_lambda) })?;
        Ok(out_lambda)
    }

    /// How implicit steps solve their system; see above. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
    pub fn set_solver(&mut self, solver: Solver) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_solver(self.as_ptr(), solver as i32) })
    }

    /// How implicit steps solve their system; see above. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
    pub fn get_solver(&self) -> Result<Solver> {
        let mut out_solver = 0;
        check(unsafe { sys::cd_membrane_get_solver(self.as_ptr(), &mut out_solver) })?;
        known(Solver::from_raw(out_solver), out_solver, "cd_membrane_get_solver")
    }

    /// Which of the two the last step took that found it awake; CD_SOLVER_AUTO: neither. Not part of the saved state.
    pub fn get_solver_taken(&self) -> Result<Solver> {
        let mut out_solver = 0;
        check(unsafe { sys::cd_membrane_get_solver_taken(self.as_ptr(), &mut out_solver) })?;
        known(Solver::from_raw(out_solver), out_solver, "cd_membrane_get_solver_taken")
    }

    /// When CD_SOLVER_COUPLED is content: a residual of `tolerance` times the one it starts from, in \[1e-14, 1/2\],
    /// default 1e-6. Each component's is the Euclidean norm of its nodes', each over its diagonal entry of the system.
    /// It may take most_iterations, \>= 1, default 100, and ends when 500 have not halved the residual, which rounding
    /// may keep from falling. cd_membrane_step says CD_ERROR_TOLERANCE where it ends short of the tolerance. Errors:
    /// CD_ERROR_VALUE.
    pub fn set_tolerance(&mut self, tolerance: f64, most_iterations: usize) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_tolerance(self.as_ptr(), tolerance, most_iterations) })
    }

    /// When CD_SOLVER_COUPLED is content: a residual of `tolerance` times the one it starts from, in \[1e-14, 1/2\],
    /// default 1e-6. Each component's is the Euclidean norm of its nodes', each over its diagonal entry of the system.
    /// It may take most_iterations, \>= 1, default 100, and ends when 500 have not halved the residual, which rounding
    /// may keep from falling. cd_membrane_step says CD_ERROR_TOLERANCE where it ends short of the tolerance. Errors:
    /// CD_ERROR_VALUE.
    pub fn get_tolerance(&self) -> Result<MembraneTolerance> {
        let mut out_tolerance = 0.0;
        let mut out_most_iterations = 0;
        check(unsafe { sys::cd_membrane_get_tolerance(self.as_ptr(), &mut out_tolerance, &mut out_most_iterations) })?;
        Ok(MembraneTolerance {
            tolerance: out_tolerance,
            most_iterations: out_most_iterations,
        })
    }

    /// What the last call of cd_membrane_step did when it took CD_SOLVER_COUPLED: the most iterations that a solve
    /// needed, and the largest residual it ended with, as a fraction of the one it started from: INFINITY where its
    /// square is. 0 and 0 if there was no such solve. Soft motions beside stiff ones may be off by more. Each output
    /// may be null.
    pub fn get_convergence(&self) -> Result<MembraneConvergence> {
        let mut out_iterations = 0;
        let mut out_residual = 0.0;
        check(unsafe { sys::cd_membrane_get_convergence(self.as_ptr(), &mut out_iterations, &mut out_residual) })?;
        Ok(MembraneConvergence {
            iterations: out_iterations,
            residual: out_residual,
        })
    }

    /// Spreads a step over the caller's threads. Null turns it off. Errors: CD_ERROR_NULL for a table without run.
    ///
    /// # Safety
    /// The functions and `user` must be good for as long as the object may call them, from whichever threads
    /// it is used on, and must not unwind.
    pub unsafe fn set_parallel(&mut self, parallel: Option<&sys::cd_parallel>) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_parallel(self.as_ptr(), parallel.map_or(std::ptr::null(),
            |c| c as *const _)) })
    }

    /// The instructions that steps are made of, as cd_chain_set_kernels says. Not part of the saved state. Errors:
    /// CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
    pub fn set_kernels(&mut self, kernels: Kernels) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_kernels(self.as_ptr(), kernels as i32) })
    }

    /// The instructions that steps are made of, as cd_chain_set_kernels says. Not part of the saved state. Errors:
    /// CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
    pub fn get_kernels(&self) -> Result<Kernels> {
        let mut out_kernels = 0;
        check(unsafe { sys::cd_membrane_get_kernels(self.as_ptr(), &mut out_kernels) })?;
        known(Kernels::from_raw(out_kernels), out_kernels, "cd_membrane_get_kernels")
    }

    /// Mass \[kg\], \> 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge line counts
    /// half, in its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an
    /// edge, a quarter at a corner. In a direction that is a ring or has no spring the rules agree, and in what follows
    /// its nu + 1 and nu (or nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness
    /// anew.
    pub fn set_mass(&mut self, mass: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_mass(self.as_ptr(), mass) })
    }

    /// Mass \[kg\], \> 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge line counts
    /// half, in its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an
    /// edge, a quarter at a corner. In a direction that is a ring or has no spring the rules agree, and in what follows
    /// its nu + 1 and nu (or nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness
    /// anew.
    pub fn get_mass(&self) -> Result<f64> {
        let mut out_mass = 0.0;
        check(unsafe { sys::cd_membrane_get_mass(self.as_ptr(), &mut out_mass) })?;
        Ok(out_mass)
    }

    /// Mass \[kg\], \> 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge line counts
    /// half, in its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an
    /// edge, a quarter at a corner. In a direction that is a ring or has no spring the rules agree, and in what follows
    /// its nu + 1 and nu (or nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness
    /// anew.
    pub fn set_mass_rule(&mut self, rule: MassRule) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_mass_rule(self.as_ptr(), rule as i32) })
    }

    /// Mass \[kg\], \> 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge line counts
    /// half, in its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an
    /// edge, a quarter at a corner. In a direction that is a ring or has no spring the rules agree, and in what follows
    /// its nu + 1 and nu (or nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness
    /// anew.
    pub fn get_mass_rule(&self) -> Result<MassRule> {
        let mut out_rule = 0;
        check(unsafe { sys::cd_membrane_get_mass_rule(self.as_ptr(), &mut out_rule) })?;
        known(MassRule::from_raw(out_rule), out_rule, "cd_membrane_get_mass_rule")
    }

    /// Stretch stiffness along u and along v \[N/m\], \>= 0: a sheet stretched evenly along u by the length d holds the
    /// energy k_u d^2 / 2. Per spring along u: nu k_u / (nv + 1), half edges: nu k_u / nv and half of it along the
    /// edges; along v likewise. Waves run across the sheet along u in sqrt(mass / k_u) seconds. A sheet of 1 component
    /// has no size of its own: with the sides L_u and L_v under the tension S \[N/m\] k_u = S L_v / L_u and k_v = S L_u
    /// / L_v, a square one S.
    pub fn set_stiffness(&mut self, along_u: f64, along_v: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_stiffness(self.as_ptr(), along_u, along_v) })
    }

    /// Stretch stiffness along u and along v \[N/m\], \>= 0: a sheet stretched evenly along u by the length d holds the
    /// energy k_u d^2 / 2. Per spring along u: nu k_u / (nv + 1), half edges: nu k_u / nv and half of it along the
    /// edges; along v likewise. Waves run across the sheet along u in sqrt(mass / k_u) seconds. A sheet of 1 component
    /// has no size of its own: with the sides L_u and L_v under the tension S \[N/m\] k_u = S L_v / L_u and k_v = S L_u
    /// / L_v, a square one S.
    pub fn get_stiffness(&self) -> Result<MembraneStiffness> {
        let mut out_along_u = 0.0;
        let mut out_along_v = 0.0;
        check(unsafe { sys::cd_membrane_get_stiffness(self.as_ptr(), &mut out_along_u, &mut out_along_v) })?;
        Ok(MembraneStiffness {
            along_u: out_along_u,
            along_v: out_along_v,
        })
    }

    /// Bend stiffness b \[N/m\], \>= 0, of E = b/2 times the integral of |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2 over the unit
    /// square of u and v. Per node with two neighbours along u: b nu^3 / (nv + 1), half edges: b nu^3 / nv and half of
    /// it along the edges; along v likewise; per cell, on the squared twist: twice their geometric mean. A square plate
    /// of side L with b = D / L^2 has the flexural rigidity D \[N m\]; one of L_u by L_v has b L_u^3 / L_v along u, b
    /// L_v^3 / L_u along v and b L_u L_v in twist. Cut springs do not cut it, but CD_MASK. Errors: CD_ERROR_MEMORY when
    /// bend is switched on.
    pub fn set_bend(&mut self, bend: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_bend(self.as_ptr(), bend) })
    }

    /// Bend stiffness b \[N/m\], \>= 0, of E = b/2 times the integral of |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2 over the unit
    /// square of u and v. Per node with two neighbours along u: b nu^3 / (nv + 1), half edges: b nu^3 / nv and half of
    /// it along the edges; along v likewise; per cell, on the squared twist: twice their geometric mean. A square plate
    /// of side L with b = D / L^2 has the flexural rigidity D \[N m\]; one of L_u by L_v has b L_u^3 / L_v along u, b
    /// L_v^3 / L_u along v and b L_u L_v in twist. Cut springs do not cut it, but CD_MASK. Errors: CD_ERROR_MEMORY when
    /// bend is switched on.
    pub fn get_bend(&self) -> Result<f64> {
        let mut out_bend = 0.0;
        check(unsafe { sys::cd_membrane_get_bend(self.as_ptr(), &mut out_bend) })?;
        Ok(out_bend)
    }

    /// Drag \[1/s\], \>= 0: every node loses velocity at this rate.
    pub fn set_drag(&mut self, drag: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_drag(self.as_ptr(), drag) })
    }

    /// Drag \[1/s\], \>= 0: every node loses velocity at this rate.
    pub fn get_drag(&self) -> Result<f64> {
        let mut out_drag = 0.0;
        check(unsafe { sys::cd_membrane_get_drag(self.as_ptr(), &mut out_drag) })?;
        Ok(out_drag)
    }

    /// Stiffness damping \[s\], \>= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
    /// amplitude at the rate (drag + stiffness_damping w^2) / 2. Cloth takes none.
    pub fn set_stiffness_damping(&mut self, seconds: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_stiffness_damping(self.as_ptr(), seconds) })
    }

    /// Stiffness damping \[s\], \>= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
    /// amplitude at the rate (drag + stiffness_damping w^2) / 2. Cloth takes none.
    pub fn get_stiffness_damping(&self) -> Result<f64> {
        let mut out_seconds = 0.0;
        check(unsafe { sys::cd_membrane_get_stiffness_damping(self.as_ptr(), &mut out_seconds) })?;
        Ok(out_seconds)
    }

    /// Gravity \[m/s^2\], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors: CD_ERROR_RANGE if
    /// count is not the number of components.
    pub fn set_gravity(&mut self, gravity: &[f64]) -> Result<()> {
        let count = count_of(gravity.len(), 1, "cd_membrane_set_gravity", "gravity")?;
        check(unsafe { sys::cd_membrane_set_gravity(self.as_ptr(), gravity.as_ptr(), count) })
    }

    /// Gravity \[m/s^2\], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors: CD_ERROR_RANGE if
    /// count is not the number of components.
    pub fn get_gravity(&self, out_gravity: &mut [f64]) -> Result<()> {
        let count = count_of(out_gravity.len(), 1, "cd_membrane_get_gravity", "out_gravity")?;
        check(unsafe { sys::cd_membrane_get_gravity(self.as_ptr(), out_gravity.as_mut_ptr(), count) })
    }

    /// Pressure \[Pa\] on the sheet along its normal x_u x x_v, of either sign, at most 1e60 in size: the force on a
    /// node is pressure times the gradient of the volume under the sheet, at an edge its part of the cells' areas, at
    /// the positions a step starts from. It grows with the sheet, beyond some half of stiffness / side without end. 3
    /// components only; costs memory while not 0. Errors: CD_ERROR_UNSUPPORTED for other components unless 0;
    /// CD_ERROR_MEMORY.
    pub fn set_pressure(&mut self, pressure: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_pressure(self.as_ptr(), pressure) })
    }

    /// Pressure \[Pa\] on the sheet along its normal x_u x x_v, of either sign, at most 1e60 in size: the force on a
    /// node is pressure times the gradient of the volume under the sheet, at an edge its part of the cells' areas, at
    /// the positions a step starts from. It grows with the sheet, beyond some half of stiffness / side without end. 3
    /// components only; costs memory while not 0. Errors: CD_ERROR_UNSUPPORTED for other components unless 0;
    /// CD_ERROR_MEMORY.
    pub fn get_pressure(&self) -> Result<f64> {
        let mut out_pressure = 0.0;
        check(unsafe { sys::cd_membrane_get_pressure(self.as_ptr(), &mut out_pressure) })?;
        Ok(out_pressure)
    }

    /// What holds an edge; a corner is pinned if either of its edges is, else driven, else posed if either is. Pinning
    /// stops the nodes; driving leaves their velocity, which is then written through CD_VELOCITY; posing switches
    /// CD_TARGET on and sets the edge's targets to where it is: write the next ones there. CD_NODE_MATCHED leaves the
    /// edge free, with the impedance that sends no echo back to a wave that runs straight at it. Where CD_PIN is
    /// switched on, all but matched are written to it along the edge. The getter tells what was set last, whatever was
    /// written to CD_PIN since. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED in the direction of a
    /// ring; CD_ERROR_MEMORY; CD_ERROR_DIVERGED for CD_NODE_POSED where the state is not finite.
    pub fn set_edge(&mut self, edge: Edge, kind: Node) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_edge(self.as_ptr(), edge as i32, kind as i32) })
    }

    /// What holds an edge; a corner is pinned if either of its edges is, else driven, else posed if either is. Pinning
    /// stops the nodes; driving leaves their velocity, which is then written through CD_VELOCITY; posing switches
    /// CD_TARGET on and sets the edge's targets to where it is: write the next ones there. CD_NODE_MATCHED leaves the
    /// edge free, with the impedance that sends no echo back to a wave that runs straight at it. Where CD_PIN is
    /// switched on, all but matched are written to it along the edge. The getter tells what was set last, whatever was
    /// written to CD_PIN since. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED in the direction of a
    /// ring; CD_ERROR_MEMORY; CD_ERROR_DIVERGED for CD_NODE_POSED where the state is not finite.
    pub fn get_edge(&self, edge: Edge) -> Result<Node> {
        let mut out_kind = 0;
        check(unsafe { sys::cd_membrane_get_edge(self.as_ptr(), edge as i32, &mut out_kind) })?;
        known(Node::from_raw(out_kind), out_kind, "cd_membrane_get_edge")
    }

    /// Joins the last nodes along u (along v) to the first (1), or opens them (0). Totals are dealt out anew, and
    /// fields of masses and stiffnesses get the uniform values. A ring needs 3 nodes. Errors: CD_ERROR_VALUE for
    /// anything but 0 and 1; CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched edge; CD_ERROR_MEMORY.
    pub fn set_ring(&mut self, along_u: bool, along_v: bool) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_ring(self.as_ptr(), i32::from(along_u), i32::from(along_v)) })
    }

    /// Joins the last nodes along u (along v) to the first (1), or opens them (0). Totals are dealt out anew, and
    /// fields of masses and stiffnesses get the uniform values. A ring needs 3 nodes. Errors: CD_ERROR_VALUE for
    /// anything but 0 and 1; CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched edge; CD_ERROR_MEMORY.
    pub fn get_ring(&self) -> Result<MembraneRing> {
        let mut out_along_u = 0;
        let mut out_along_v = 0;
        check(unsafe { sys::cd_membrane_get_ring(self.as_ptr(), &mut out_along_u, &mut out_along_v) })?;
        Ok(MembraneRing {
            along_u: out_along_u != 0,
            along_v: out_along_v != 0,
        })
    }

    /// Lets a sheet sleep, as a whole, once it has been slower than `speed` \[m/s\], in \[0, 1e60\], for some `seconds`
    /// \[s\], in \[1e-30, 1e60\]: as cd_chain_set_sleep says; the effort wakes nothing. Errors: CD_ERROR_VALUE;
    /// CD_ERROR_MEMORY.
    pub fn set_sleep(&mut self, speed: f64, seconds: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_sleep(self.as_ptr(), speed, seconds) })
    }

    /// Lets a sheet sleep, as a whole, once it has been slower than `speed` \[m/s\], in \[0, 1e60\], for some `seconds`
    /// \[s\], in \[1e-30, 1e60\]: as cd_chain_set_sleep says; the effort wakes nothing. Errors: CD_ERROR_VALUE;
    /// CD_ERROR_MEMORY.
    pub fn get_sleep(&self) -> Result<MembraneSleep> {
        let mut out_speed = 0.0;
        let mut out_seconds = 0.0;
        check(unsafe { sys::cd_membrane_get_sleep(self.as_ptr(), &mut out_speed, &mut out_seconds) })?;
        Ok(MembraneSleep {
            speed: out_speed,
            seconds: out_seconds,
        })
    }

    /// Lets a sheet sleep, as a whole, once it has been slower than `speed` \[m/s\], in \[0, 1e60\], for some `seconds`
    /// \[s\], in \[1e-30, 1e60\]: as cd_chain_set_sleep says; the effort wakes nothing. Errors: CD_ERROR_VALUE;
    /// CD_ERROR_MEMORY.
    pub fn get_awake(&self) -> Result<usize> {
        let mut out_nodes = 0;
        check(unsafe { sys::cd_membrane_get_awake(self.as_ptr(), &mut out_nodes) })?;
        Ok(out_nodes)
    }

    /// Rest lengths of the sheet along u and along v \[m\], 0 or in \[1e-60, 1e60\]; default 0: no cloth. Both are 0 or
    /// neither is. Per spring: length / springs, in a ring as well; nodes stay where they are. Making cloth of a
    /// membrane sets lambda to 1. Length 0 switches the fields of cloth off, and breaking strain, air, wind and
    /// colliders too. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED without 3 components and springs
    /// along both directions.
    pub fn set_rest_length(&mut self, along_u: f64, along_v: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_rest_length(self.as_ptr(), along_u, along_v) })
    }

    /// Rest lengths of the sheet along u and along v \[m\], 0 or in \[1e-60, 1e60\]; default 0: no cloth. Both are 0 or
    /// neither is. Per spring: length / springs, in a ring as well; nodes stay where they are. Making cloth of a
    /// membrane sets lambda to 1. Length 0 switches the fields of cloth off, and breaking strain, air, wind and
    /// colliders too. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED without 3 components and springs
    /// along both directions.
    pub fn get_rest_length(&self) -> Result<MembraneRestLength> {
        let mut out_along_u = 0.0;
        let mut out_along_v = 0.0;
        check(unsafe { sys::cd_membrane_get_rest_length(self.as_ptr(), &mut out_along_u, &mut out_along_v) })?;
        Ok(MembraneRestLength {
            along_u: out_along_u,
            along_v: out_along_v,
        })
    }

    /// Shear stiffness \[N/m\], \>= 0, default 0, of a spring along each diagonal of every cell, with the law and the
    /// mean rest lengths of the cell's springs. Of square cells the shear modulus is half of it \[N/m\]. Errors here
    /// and below: CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a membrane that is no cloth.
    pub fn set_shear(&mut self, stiffness: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_shear(self.as_ptr(), stiffness) })
    }

    /// Shear stiffness \[N/m\], \>= 0, default 0, of a spring along each diagonal of every cell, with the law and the
    /// mean rest lengths of the cell's springs. Of square cells the shear modulus is half of it \[N/m\]. Errors here
    /// and below: CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a membrane that is no cloth.
    pub fn get_shear(&self) -> Result<f64> {
        let mut out_stiffness = 0.0;
        check(unsafe { sys::cd_membrane_get_shear(self.as_ptr(), &mut out_stiffness) })?;
        Ok(out_stiffness)
    }

    /// What keeps cloth from crumpling: springs along u and v that are shorter than their length push by c (L - l),
    /// longer ones pull by as much, c dealt out as a stiffness of mass \* rate. rate \[1/s^2\] \>= 0, default 80: flags
    /// of a metre wave in winds up to 12 m/s with 0.4% folded sharply at most; smaller ones want more. It damps folds
    /// from node to node.
    pub fn set_compression(&mut self, rate: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_compression(self.as_ptr(), rate) })
    }

    /// What keeps cloth from crumpling: springs along u and v that are shorter than their length push by c (L - l),
    /// longer ones pull by as much, c dealt out as a stiffness of mass \* rate. rate \[1/s^2\] \>= 0, default 80: flags
    /// of a metre wave in winds up to 12 m/s with 0.4% folded sharply at most; smaller ones want more. It damps folds
    /// from node to node.
    pub fn get_compression(&self) -> Result<f64> {
        let mut out_rate = 0.0;
        check(unsafe { sys::cd_membrane_get_compression(self.as_ptr(), &mut out_rate) })?;
        Ok(out_rate)
    }

    /// The strain, length over rest length less 1, at which a spring tears, whatever its stiffness: 1e-60 to 1e60, or
    /// INFINITY, the default: springs hold. The fields CD_BREAKING_STRAIN_U and _V have one for each spring: a seam is
    /// a line of springs that tear at less. A step ends by cutting springs beyond their breaking strains, in each row
    /// and each column of springs at most one. First goes the spring whose strain is the largest multiple of its
    /// breaking strain; then its neighbour in the next row, and so on from row to row, while that is beyond its
    /// breaking strain too; then the same in the rows that are left. So tears go on from their ends, and jerked cloth
    /// parts without falling to pieces. A cut spring's stiffness becomes 0, and adds no energy. Mend it by writing
    /// CD_STIFFNESS_U or _V, which finite breaking strains switch on and keep on. A cell of cloth that lacks two or
    /// more springs is open: it is not drawn, it has no volume, and air and pressure go through it. Errors:
    /// CD_ERROR_MEMORY too.
    pub fn set_breaking_strain(&mut self, strain: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_breaking_strain(self.as_ptr(), strain) })
    }

    /// The strain, length over rest length less 1, at which a spring tears, whatever its stiffness: 1e-60 to 1e60, or
    /// INFINITY, the default: springs hold. The fields CD_BREAKING_STRAIN_U and _V have one for each spring: a seam is
    /// a line of springs that tear at less. A step ends by cutting springs beyond their breaking strains, in each row
    /// and each column of springs at most one. First goes the spring whose strain is the largest multiple of its
    /// breaking strain; then its neighbour in the next row, and so on from row to row, while that is beyond its
    /// breaking strain too; then the same in the rows that are left. So tears go on from their ends, and jerked cloth
    /// parts without falling to pieces. A cut spring's stiffness becomes 0, and adds no energy. Mend it by writing
    /// CD_STIFFNESS_U or _V, which finite breaking strains switch on and keep on. A cell of cloth that lacks two or
    /// more springs is open: it is not drawn, it has no volume, and air and pressure go through it. Errors:
    /// CD_ERROR_MEMORY too.
    pub fn get_breaking_strain(&self) -> Result<f64> {
        let mut out_strain = 0.0;
        check(unsafe { sys::cd_membrane_get_breaking_strain(self.as_ptr(), &mut out_strain) })?;
        Ok(out_strain)
    }

    /// How many springs tore in the last call of cd_membrane_step that made steps: those whose stiffness became 0.
    /// Where there are any, cd_membrane_write_indices may write other triangles than before.
    pub fn get_broken(&self) -> Result<usize> {
        let mut out_springs = 0;
        check(unsafe { sys::cd_membrane_get_broken(self.as_ptr(), &mut out_springs) })?;
        Ok(out_springs)
    }

    /// How much a step may do: iterations of Newton's method, `newton`, 1 to 1000, default 3, and in each those of
    /// conjugate gradients, `gradient`, 1 to 10000, or 0, the default: until four bring less than 3% of the energy that
    /// all brought. Up to 4 more of Newton's are made where it gains little, with gradient 0 also where it still gains
    /// much. After a step get_convergence tells the most of conjugate gradients that a step took, and what gradient was
    /// left over the first.
    pub fn set_effort(&mut self, newton: usize, gradient: usize) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_effort(self.as_ptr(), newton, gradient) })
    }

    /// How much a step may do: iterations of Newton's method, `newton`, 1 to 1000, default 3, and in each those of
    /// conjugate gradients, `gradient`, 1 to 10000, or 0, the default: until four bring less than 3% of the energy that
    /// all brought. Up to 4 more of Newton's are made where it gains little, with gradient 0 also where it still gains
    /// much. After a step get_convergence tells the most of conjugate gradients that a step took, and what gradient was
    /// left over the first.
    pub fn get_effort(&self) -> Result<MembraneEffort> {
        let mut out_newton = 0;
        let mut out_gradient = 0;
        check(unsafe { sys::cd_membrane_get_effort(self.as_ptr(), &mut out_newton, &mut out_gradient) })?;
        Ok(MembraneEffort {
            newton: out_newton,
            gradient: out_gradient,
        })
    }

    /// Resistance of the air, per area of cloth \[N s/m^3\], in \[0, 1e60\], default 0: a piece of area a whose
    /// velocity through the air is w, w_t along the cloth and w_n across it, is pushed by -a (along w_t + across w_n).
    /// Implicit, so that it only takes energy, as seen from the air, at any dt; areas and directions are those that the
    /// step starts from. Air of density 1.2 kg/m^3 that passes at the speed s has about across = 1.2 s and along = 0.02
    /// s. A node on an edge bears half the air: with CD_MASS_EQUAL, where it has the whole mass, a flat sheet folds as
    /// it falls; with CD_MASS_HALF_ENDS it falls flat. Errors: CD_ERROR_MEMORY too.
    pub fn set_air(&mut self, along: f64, across: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_air(self.as_ptr(), along, across) })
    }

    /// Resistance of the air, per area of cloth \[N s/m^3\], in \[0, 1e60\], default 0: a piece of area a whose
    /// velocity through the air is w, w_t along the cloth and w_n across it, is pushed by -a (along w_t + across w_n).
    /// Implicit, so that it only takes energy, as seen from the air, at any dt; areas and directions are those that the
    /// step starts from. Air of density 1.2 kg/m^3 that passes at the speed s has about across = 1.2 s and along = 0.02
    /// s. A node on an edge bears half the air: with CD_MASS_EQUAL, where it has the whole mass, a flat sheet folds as
    /// it falls; with CD_MASS_HALF_ENDS it falls flat. Errors: CD_ERROR_MEMORY too.
    pub fn get_air(&self) -> Result<MembraneAir> {
        let mut out_along = 0.0;
        let mut out_across = 0.0;
        check(unsafe { sys::cd_membrane_get_air(self.as_ptr(), &mut out_along, &mut out_across) })?;
        Ok(MembraneAir {
            along: out_along,
            across: out_across,
        })
    }

    /// Velocity of that air \[m/s\], one number per component, default 0; the field CD_WIND has one for each node.
    /// Errors: CD_ERROR_RANGE too, if count is not the number of components.
    pub fn set_wind(&mut self, velocity: &[f64]) -> Result<()> {
        let count = count_of(velocity.len(), 1, "cd_membrane_set_wind", "velocity")?;
        check(unsafe { sys::cd_membrane_set_wind(self.as_ptr(), velocity.as_ptr(), count) })
    }

    /// Velocity of that air \[m/s\], one number per component, default 0; the field CD_WIND has one for each node.
    /// Errors: CD_ERROR_RANGE too, if count is not the number of components.
    pub fn get_wind(&self, out_velocity: &mut [f64]) -> Result<()> {
        let count = count_of(out_velocity.len(), 1, "cd_membrane_get_wind", "out_velocity")?;
        check(unsafe { sys::cd_membrane_get_wind(self.as_ptr(), out_velocity.as_mut_ptr(), count) })
    }

    /// As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres
    /// among them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three
    /// that it would be deepest in, or nearest to, at its velocity, as the planes that touch them where the step
    /// begins: it goes through none of them, however fast. Nodes collide; what lies between them does not, nor does
    /// cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet
    /// lands at 50 m/s; with the default effort nodes are now and then deeper, by up to 7e-3 m in steps that move them
    /// by 0.1 m. What lies inside comes out, and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a
    /// step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the push that the step's iterations
    /// find. With the default effort, what begins to slide is up to a quarter too slow in its first half second. What
    /// friction holds creeps, at half of the largest force that it can hold by 1e-3 m/s. Beds and callbacks are those
    /// of cd_chain, met at the plane that touches them where a step finds a node: what a hollow rises above that plane
    /// a node may end inside of, and the next step takes it out. A callback is asked once a step, for all nodes;
    /// answers that it may not give make cd_membrane_step say CD_ERROR_CALLBACK, and one that is missing after a load
    /// CD_ERROR_UNSUPPORTED. Errors and ranges are those of the functions of cd_chain.
    pub fn set_colliders(&mut self, count: usize) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_colliders(self.as_ptr(), count) })
    }

    /// As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres
    /// among them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three
    /// that it would be deepest in, or nearest to, at its velocity, as the planes that touch them where the step
    /// begins: it goes through none of them, however fast. Nodes collide; what lies between them does not, nor does
    /// cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet
    /// lands at 50 m/s; with the default effort nodes are now and then deeper, by up to 7e-3 m in steps that move them
    /// by 0.1 m. What lies inside comes out, and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a
    /// step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the push that the step's iterations
    /// find. With the default effort, what begins to slide is up to a quarter too slow in its first half second. What
    /// friction holds creeps, at half of the largest force that it can hold by 1e-3 m/s. Beds and callbacks are those
    /// of cd_chain, met at the plane that touches them where a step finds a node: what a hollow rises above that plane
    /// a node may end inside of, and the next step takes it out. A callback is asked once a step, for all nodes;
    /// answers that it may not give make cd_membrane_step say CD_ERROR_CALLBACK, and one that is missing after a load
    /// CD_ERROR_UNSUPPORTED. Errors and ranges are those of the functions of cd_chain.
    pub fn get_colliders(&self) -> Result<usize> {
        let mut out_count = 0;
        check(unsafe { sys::cd_membrane_get_colliders(self.as_ptr(), &mut out_count) })?;
        Ok(out_count)
    }

    /// As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres
    /// among them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three
    /// that it would be deepest in, or nearest to, at its velocity, as the planes that touch them where the step
    /// begins: it goes through none of them, however fast. Nodes collide; what lies between them does not, nor does
    /// cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet
    /// lands at 50 m/s; with the default effort nodes are now and then deeper, by up to 7e-3 m in steps that move them
    /// by 0.1 m. What lies inside comes out, and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a
    /// step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the push that the step's iterations
    /// find. With the default effort, what begins to slide is up to a quarter too slow in its first half second. What
    /// friction holds creeps, at half of the largest force that it can hold by 1e-3 m/s. Beds and callbacks are those
    /// of cd_chain, met at the plane that touches them where a step finds a node: what a hollow rises above that plane
    /// a node may end inside of, and the next step takes it out. A callback is asked once a step, for all nodes;
    /// answers that it may not give make cd_membrane_step say CD_ERROR_CALLBACK, and one that is missing after a load
    /// CD_ERROR_UNSUPPORTED. Errors and ranges are those of the functions of cd_chain.
    pub fn set_plane(&mut self, index: usize, point: &[f64], normal: &[f64], friction: f64) -> Result<()> {
        let count = count_of(point.len(), 1, "cd_membrane_set_plane", "point")?;
        same(Some(normal.len()), count.checked_mul(1), "cd_membrane_set_plane", "normal")?;
        check(unsafe { sys::cd_membrane_set_plane(self.as_ptr(), index, point.as_ptr(), normal.as_ptr(), count,
            friction) })
    }

    /// As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres
    /// among them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three
    /// that it would be deepest in, or nearest to, at its velocity, as the planes that touch them where the step
    /// begins: it goes through none of them, however fast. Nodes collide; what lies between them does not, nor does
    /// cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet
    /// lands at 50 m/s; with the default effort nodes are now and then deeper, by up to 7e-3 m in steps that move them
    /// by 0.1 m. What lies inside comes out, and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a
    /// step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the push that the step's iterations
    /// find. With the default effort, what begins to slide is up to a quarter too slow in its first half second. What
    /// friction holds creeps, at half of the largest force that it can hold by 1e-3 m/s. Beds and callbacks are those
    /// of cd_chain, met at the plane that touches them where a step finds a node: what a hollow rises above that plane
    /// a node may end inside of, and the next step takes it out. A callback is asked once a step, for all nodes;
    /// answers that it may not give make cd_membrane_step say CD_ERROR_CALLBACK, and one that is missing after a load
    /// CD_ERROR_UNSUPPORTED. Errors and ranges are those of the functions of cd_chain.
    pub fn set_capsule(&mut self, index: usize, first: &[f64], last: &[f64], radius: f64, friction: f64) -> Result<()> {
        let count = count_of(first.len(), 1, "cd_membrane_set_capsule", "first")?;
        same(Some(last.len()), count.checked_mul(1), "cd_membrane_set_capsule", "last")?;
        check(unsafe { sys::cd_membrane_set_capsule(self.as_ptr(), index, first.as_ptr(), last.as_ptr(), count, radius,
            friction) })
    }

    /// As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres
    /// among them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three
    /// that it would be deepest in, or nearest to, at its velocity, as the planes that touch them where the step
    /// begins: it goes through none of them, however fast. Nodes collide; what lies between them does not, nor does
    /// cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet
    /// lands at 50 m/s; with the default effort nodes are now and then deeper, by up to 7e-3 m in steps that move them
    /// by 0.1 m. What lies inside comes out, and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a
    /// step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the push that the step's iterations
    /// find. With the default effort, what begins to slide is up to a quarter too slow in its first half second. What
    /// friction holds creeps, at half of the largest force that it can hold by 1e-3 m/s. Beds and callbacks are those
    /// of cd_chain, met at the plane that touches them where a step finds a node: what a hollow rises above that plane
    /// a node may end inside of, and the next step takes it out. A callback is asked once a step, for all nodes;
    /// answers that it may not give make cd_membrane_step say CD_ERROR_CALLBACK, and one that is missing after a load
    /// CD_ERROR_UNSUPPORTED. Errors and ranges are those of the functions of cd_chain.
    pub fn set_bed(&mut self, index: usize, origin: &[f64], columns: usize, rows: usize, column_spacing: f64,
        row_spacing: f64, heights: &[f64], friction: f64) -> Result<()> {
        let count = count_of(origin.len(), 1, "cd_membrane_set_bed", "origin")?;
        let height_count = count_of(heights.len(), 1, "cd_membrane_set_bed", "heights")?;
        check(unsafe { sys::cd_membrane_set_bed(self.as_ptr(), index, origin.as_ptr(), count, columns, rows,
            column_spacing, row_spacing, heights.as_ptr(), height_count, friction) })
    }

    /// Each output may be null.
    pub fn get_bed(&self, index: usize, out_heights: Option<&mut [f64]>) -> Result<MembraneBed> {
        let height_count = out_heights.as_deref().map(<[_]>::len);
        let height_count = count_of(height_count.unwrap_or(0), 1, "cd_membrane_get_bed", "out_heights")?;
        let mut out_columns = 0;
        let mut out_rows = 0;
        check(unsafe { sys::cd_membrane_get_bed(self.as_ptr(), index, &mut out_columns, &mut out_rows,
            out_heights.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr), height_count) })?;
        Ok(MembraneBed {
            columns: out_columns,
            rows: out_rows,
        })
    }

    /// origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.
    ///
    /// # Safety
    /// The functions and `user` must be good for as long as the object may call them, from whichever threads
    /// it is used on, and must not unwind.
    pub unsafe fn set_callback(&mut self, index: usize, distance: Option<&sys::cd_distance>, origin: Option<&[f64]>,
        friction: f64) -> Result<()> {
        let count = origin.map(<[_]>::len);
        let count = count_of(count.unwrap_or(0), 1, "cd_membrane_set_callback", "origin")?;
        check(unsafe { sys::cd_membrane_set_callback(self.as_ptr(), index, distance.map_or(std::ptr::null(),
            |c| c as *const _), origin.map_or(std::ptr::null(), <[_]>::as_ptr), count, friction) })
    }

    /// origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.
    pub fn remove_collider(&mut self, index: usize) -> Result<()> {
        check(unsafe { sys::cd_membrane_remove_collider(self.as_ptr(), index) })
    }

    /// origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.
    pub fn set_collider_velocity(&mut self, index: usize, velocity: &[f64]) -> Result<()> {
        let count = count_of(velocity.len(), 1, "cd_membrane_set_collider_velocity", "velocity")?;
        check(unsafe { sys::cd_membrane_set_collider_velocity(self.as_ptr(), index, velocity.as_ptr(), count) })
    }

    /// Each output may be null.
    pub fn get_collider(&self, index: usize, out_first: Option<&mut [f64]>, out_second: Option<&mut [f64]>,
        out_velocity: Option<&mut [f64]>) -> Result<MembraneCollider> {
        let count = out_first.as_deref().map(<[_]>::len);
        let count = count.or(out_second.as_deref().map(<[_]>::len));
        let count = count.or(out_velocity.as_deref().map(<[_]>::len));
        let count = count_of(count.unwrap_or(0), 1, "cd_membrane_get_collider", "out_first")?;
        same(out_second.as_deref().map(<[_]>::len), count.checked_mul(1), "cd_membrane_get_collider", "out_second")?;
        same(out_velocity.as_deref().map(<[_]>::len), count.checked_mul(1), "cd_membrane_get_collider",
            "out_velocity")?;
        let mut out_shape = 0;
        let mut out_radius = 0.0;
        let mut out_friction = 0.0;
        check(unsafe { sys::cd_membrane_get_collider(self.as_ptr(), index, &mut out_shape,
            out_first.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr), out_second.map_or(std::ptr::null_mut(),
            <[_]>::as_mut_ptr), out_velocity.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr), count, &mut out_radius,
            &mut out_friction) })?;
        Ok(MembraneCollider {
            shape: known(Shape::from_raw(out_shape), out_shape, "cd_membrane_get_collider")?,
            radius: out_radius,
            friction: out_friction,
        })
    }

    /// What cloth does to colliders, as cd_chain_get_collider_load says: what the momentum of each node that meets one
    /// lacks, and of a part of the sheet that nothing holds that of all its nodes. So of free sheets the sum is right
    /// whatever the effort; of held ones as right as the step's velocities are.
    pub fn set_loads(&mut self, loads: bool) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_loads(self.as_ptr(), i32::from(loads)) })
    }

    /// What cloth does to colliders, as cd_chain_get_collider_load says: what the momentum of each node that meets one
    /// lacks, and of a part of the sheet that nothing holds that of all its nodes. So of free sheets the sum is right
    /// whatever the effort; of held ones as right as the step's velocities are.
    pub fn get_loads(&self) -> Result<bool> {
        let mut out_loads = 0;
        check(unsafe { sys::cd_membrane_get_loads(self.as_ptr(), &mut out_loads) })?;
        Ok(out_loads != 0)
    }

    /// What cloth does to colliders, as cd_chain_get_collider_load says: what the momentum of each node that meets one
    /// lacks, and of a part of the sheet that nothing holds that of all its nodes. So of free sheets the sum is right
    /// whatever the effort; of held ones as right as the step's velocities are.
    pub fn get_collider_load(&self, index: usize, out_load: &mut [f64]) -> Result<()> {
        let count = count_of(out_load.len(), 1, "cd_membrane_get_collider_load", "out_load")?;
        check(unsafe { sys::cd_membrane_get_collider_load(self.as_ptr(), index, out_load.as_mut_ptr(), count) })
    }

    /// How thick cloth is, as a distance \[m\] in \[0, 1e60\], default 0, that nodes keep from colliders.
    pub fn set_thickness(&mut self, distance: f64) -> Result<()> {
        check(unsafe { sys::cd_membrane_set_thickness(self.as_ptr(), distance) })
    }

    /// How thick cloth is, as a distance \[m\] in \[0, 1e60\], default 0, that nodes keep from colliders.
    pub fn get_thickness(&self) -> Result<f64> {
        let mut out_distance = 0.0;
        check(unsafe { sys::cd_membrane_get_thickness(self.as_ptr(), &mut out_distance) })?;
        Ok(out_distance)
    }

    /// Switches a field on, filled with the present uniform values (force 0, target the present position, mask 1, pin
    /// what the edges say). CD_BREAKING_STRAIN_U and _V switch CD_STIFFNESS_U and _V on too. On already: nothing
    /// happens. Errors: CD_ERROR_ENUM, CD_ERROR_MEMORY; CD_ERROR_DIVERGED for CD_TARGET where the state is not finite;
    /// here and below CD_ERROR_UNSUPPORTED for the fields of cloth of a membrane that is none.
    pub fn enable_field(&mut self, field: Field) -> Result<()> {
        check(unsafe { sys::cd_membrane_enable_field(self.as_ptr(), field as i32) })
    }

    /// Switches a field off and releases its memory: uniform values again, no forces, all attachments loosened, all
    /// nodes there, none held but on edges. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for position, velocity, tension
    /// and strain, and for the stiffness of springs that may tear.
    pub fn disable_field(&mut self, field: Field) -> Result<()> {
        check(unsafe { sys::cd_membrane_disable_field(self.as_ptr(), field as i32) })
    }

    /// Writes or reads values\[v\]\[u\]\[component\], dense, of the rectangle of nodes (or springs) \[first_u, first_u
    /// \+ n_u) x \[first_v, first_v + n_v). Fields without components have one value per node or spring; there are nu
    /// (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in
    /// the buffer: n_u \* n_v \* components. Numbers are rounded once, to the precision of the side that is narrower.
    /// Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
    /// bad index, and CD_ERROR_UNSUPPORTED for tension and strain.
    pub fn write_f32(&mut self, field: Field, first_u: usize, first_v: usize, n_u: usize, n_v: usize,
        values: &[f32]) -> Result<()> {
        let count = count_of(values.len(), 1, "cd_membrane_write_f32", "values")?;
        check(unsafe { sys::cd_membrane_write_f32(self.as_ptr(), field as i32, first_u, first_v, n_u, n_v,
            values.as_ptr(), count) })
    }

    /// Writes or reads values\[v\]\[u\]\[component\], dense, of the rectangle of nodes (or springs) \[first_u, first_u
    /// \+ n_u) x \[first_v, first_v + n_v). Fields without components have one value per node or spring; there are nu
    /// (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in
    /// the buffer: n_u \* n_v \* components. Numbers are rounded once, to the precision of the side that is narrower.
    /// Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
    /// bad index, and CD_ERROR_UNSUPPORTED for tension and strain.
    pub fn write_f64(&mut self, field: Field, first_u: usize, first_v: usize, n_u: usize, n_v: usize,
        values: &[f64]) -> Result<()> {
        let count = count_of(values.len(), 1, "cd_membrane_write_f64", "values")?;
        check(unsafe { sys::cd_membrane_write_f64(self.as_ptr(), field as i32, first_u, first_v, n_u, n_v,
            values.as_ptr(), count) })
    }

    /// Writes or reads values\[v\]\[u\]\[component\], dense, of the rectangle of nodes (or springs) \[first_u, first_u
    /// \+ n_u) x \[first_v, first_v + n_v). Fields without components have one value per node or spring; there are nu
    /// (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in
    /// the buffer: n_u \* n_v \* components. Numbers are rounded once, to the precision of the side that is narrower.
    /// Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
    /// bad index, and CD_ERROR_UNSUPPORTED for tension and strain.
    pub fn read_f32(&self, field: Field, first_u: usize, first_v: usize, n_u: usize, n_v: usize,
        out_values: &mut [f32]) -> Result<()> {
        let count = count_of(out_values.len(), 1, "cd_membrane_read_f32", "out_values")?;
        check(unsafe { sys::cd_membrane_read_f32(self.as_ptr(), field as i32, first_u, first_v, n_u, n_v,
            out_values.as_mut_ptr(), count) })
    }

    /// Writes or reads values\[v\]\[u\]\[component\], dense, of the rectangle of nodes (or springs) \[first_u, first_u
    /// \+ n_u) x \[first_v, first_v + n_v). Fields without components have one value per node or spring; there are nu
    /// (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in
    /// the buffer: n_u \* n_v \* components. Numbers are rounded once, to the precision of the side that is narrower.
    /// Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
    /// bad index, and CD_ERROR_UNSUPPORTED for tension and strain.
    pub fn read_f64(&self, field: Field, first_u: usize, first_v: usize, n_u: usize, n_v: usize,
        out_values: &mut [f64]) -> Result<()> {
        let count = count_of(out_values.len(), 1, "cd_membrane_read_f64", "out_values")?;
        check(unsafe { sys::cd_membrane_read_f64(self.as_ptr(), field as i32, first_u, first_v, n_u, n_v,
            out_values.as_mut_ptr(), count) })
    }

    /// Where a field lies in the membrane's own memory, in the membrane's precision, to read without a copy: the value
    /// of (u, v, component) is at byte \*out_data + u \* u_stride + v \* v_stride + component \* component_stride.
    /// Position, velocity, force and target only. The pointer is good until the field is switched off or the membrane
    /// released; the numbers change with every write and step. Do not write through it. Errors: CD_ERROR_ENUM,
    /// CD_ERROR_DISABLED, CD_ERROR_UNSUPPORTED.
    pub fn view(&self, field: Field) -> Result<View<'_>> {
        let mut data = std::ptr::null();
        let mut strides = [0; 3];
        let [s0, s1, s2] = &mut strides;
        check(unsafe { sys::cd_membrane_view(self.as_ptr(), field as i32, &mut data, s0, s1, s2) })?;
        Ok(View::new(data.cast(), strides, self.whole(field)?, self.get_shape()?.precision))
    }

    /// Adds impulse \[N s\], one number per component, spread over the nodes less than `radius` springs away from the
    /// place (u, v), counted on the lattice and not round a ring, by weights (1 - (distance / radius)^2)^2, scaled to
    /// sum to 1; all on the nearest node if there is none. A node's velocity changes by its share / its mass; held and
    /// absent nodes lose it. u in \[0, nu\], v in \[0, nv\], radius \>= 0. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE,
    /// CD_ERROR_DIVERGED.
    pub fn impulse(&mut self, u: f64, v: f64, radius: f64, impulse: &[f64]) -> Result<()> {
        let count = count_of(impulse.len(), 1, "cd_membrane_impulse", "impulse")?;
        check(unsafe { sys::cd_membrane_impulse(self.as_ptr(), u, v, radius, impulse.as_ptr(), count) })
    }

    /// Moves the sheet as a whole, as if it had always been there: every position and target becomes rotation \* x +
    /// offset, every velocity rotation \* v; colliders stay where they are. rotation: components rows of as many
    /// numbers, orthogonal to 1e-6; null: none. offset \[m\]: one number per component, which count counts. Errors:
    /// CD_ERROR_RANGE, CD_ERROR_VALUE; CD_ERROR_DIVERGED for a state that is not finite.
    pub fn teleport(&mut self, rotation: Option<&[f64]>, offset: &[f64]) -> Result<()> {
        let count = count_of(offset.len(), 1, "cd_membrane_teleport", "offset")?;
        same(rotation.map(<[_]>::len), count.checked_mul(count), "cd_membrane_teleport", "rotation")?;
        check(unsafe { sys::cd_membrane_teleport(self.as_ptr(), rotation.map_or(std::ptr::null(), <[_]>::as_ptr),
            offset.as_ptr(), count) })
    }

    /// Ties a node to its target by a spring of `stiffness` \[N/m\] \>= 0 and `damping` \[N s/m\] \>= 0, as a mouse
    /// drag does. target: one number per component; null: the node's present position, and count means nothing. Move it
    /// afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on. Errors:
    /// CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite.
    pub fn attach(&mut self, u: usize, v: usize, stiffness: f64, damping: f64, target: Option<&[f64]>) -> Result<()> {
        let count = target.map(<[_]>::len);
        let count = count_of(count.unwrap_or(0), 1, "cd_membrane_attach", "target")?;
        check(unsafe { sys::cd_membrane_attach(self.as_ptr(), u, v, stiffness, damping, target.map_or(std::ptr::null(),
            <[_]>::as_ptr), count) })
    }

    /// Ties a node to its target by a spring of `stiffness` \[N/m\] \>= 0 and `damping` \[N s/m\] \>= 0, as a mouse
    /// drag does. target: one number per component; null: the node's present position, and count means nothing. Move it
    /// afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on. Errors:
    /// CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite.
    pub fn detach(&mut self, u: usize, v: usize) -> Result<()> {
        check(unsafe { sys::cd_membrane_detach(self.as_ptr(), u, v) })
    }

    /// Ties a node to its target by a spring of `stiffness` \[N/m\] \>= 0 and `damping` \[N s/m\] \>= 0, as a mouse
    /// drag does. target: one number per component; null: the node's present position, and count means nothing. Move it
    /// afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET on. Errors:
    /// CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite.
    pub fn get_attachment(&self, u: usize, v: usize) -> Result<MembraneAttachment> {
        let mut out_stiffness = 0.0;
        let mut out_damping = 0.0;
        check(unsafe { sys::cd_membrane_get_attachment(self.as_ptr(), u, v, &mut out_stiffness, &mut out_damping) })?;
        Ok(MembraneAttachment {
            stiffness: out_stiffness,
            damping: out_damping,
        })
    }

    /// Makes `count` steps of dt \[s\] each, 0 or in \[1e-30, 1e30\]: with 0 no time passes, as with 0 steps. Never
    /// allocates. Time is proportional to count \* nodes \* components, with CD_SOLVER_COUPLED to the iterations too.
    /// Errors: CD_ERROR_VALUE; CD_ERROR_DIVERGED if a number leaves the finite range: all steps are made, the message
    /// gives the first bad one, the membrane can be read, and steps again after cd_membrane_reset, a load, or once
    /// finite positions and velocities have been written; CD_ERROR_TOLERANCE if a coupled solve ended short of its
    /// tolerance: all steps are made, and good to the residual that cd_membrane_get_convergence tells.
    pub fn step(&mut self, dt: f64, count: usize) -> Result<()> {
        check(unsafe { sys::cd_membrane_step(self.as_ptr(), dt, count) })
    }

    /// The longest dt at which CD_METHOD_SYMPLECTIC_EULER is sure to stay bounded, whatever method is set: the largest
    /// dt with 4 M - 2 dt C - dt^2 K positive definite, by a bound on K that is exact in the limit of many nodes for
    /// uniform sheets, and a safe lower bound otherwise. INFINITY if nothing can swing. Errors: CD_ERROR_UNSUPPORTED of
    /// cloth.
    pub fn stable_dt(&self) -> Result<f64> {
        let mut out_dt = 0.0;
        check(unsafe { sys::cd_membrane_stable_dt(self.as_ptr(), &mut out_dt) })?;
        Ok(out_dt)
    }

    /// Simulated time \[s\] and steps made since create or reset, those before a load or a copied state included.
    pub fn get_time(&self) -> Result<f64> {
        let mut out_time = 0.0;
        check(unsafe { sys::cd_membrane_get_time(self.as_ptr(), &mut out_time) })?;
        Ok(out_time)
    }

    /// Simulated time \[s\] and steps made since create or reset, those before a load or a copied state included.
    pub fn get_steps(&self) -> Result<u64> {
        let mut out_steps = 0;
        check(unsafe { sys::cd_membrane_get_steps(self.as_ptr(), &mut out_steps) })?;
        Ok(out_steps)
    }

    /// How many factorizations the membrane has made: one at the first implicit step and one at the first after each
    /// change of dt, lambda, method, solver or a parameter. Not part of the saved state.
    pub fn get_factorizations(&self) -> Result<u64> {
        let mut out_count = 0;
        check(unsafe { sys::cd_membrane_get_factorizations(self.as_ptr(), &mut out_count) })?;
        Ok(out_count)
    }

    /// Energies \[J\]; each output may be null. Kinetic: of the free nodes. Elastic: stretch, bend and attachments.
    /// Gravity: -sum m g x of the free nodes. What of their sum lambda = 1/2 keeps is told above.
    pub fn get_energy(&self) -> Result<MembraneEnergy> {
        let mut out_kinetic = 0.0;
        let mut out_elastic = 0.0;
        let mut out_gravity = 0.0;
        check(unsafe { sys::cd_membrane_get_energy(self.as_ptr(), &mut out_kinetic, &mut out_elastic,
            &mut out_gravity) })?;
        Ok(MembraneEnergy {
            kinetic: out_kinetic,
            elastic: out_elastic,
            gravity: out_gravity,
        })
    }

    /// Momentum of the free nodes \[kg m/s\], one number per component. Errors: CD_ERROR_RANGE if count is not the
    /// number of components.
    pub fn get_momentum(&self, out_momentum: &mut [f64]) -> Result<()> {
        let count = count_of(out_momentum.len(), 1, "cd_membrane_get_momentum", "out_momentum")?;
        check(unsafe { sys::cd_membrane_get_momentum(self.as_ptr(), out_momentum.as_mut_ptr(), count) })
    }

    /// The force \[N\], one number per component, with which springs, shear and bend pull at a node where it is now: of
    /// a held node, what the sheet does to whatever holds it, but for weight, forces, attachment, pressure and wind of
    /// that node itself. Errors: CD_ERROR_RANGE for count, or if there is no such node.
    pub fn get_reaction(&self, u: usize, v: usize, out_force: &mut [f64]) -> Result<()> {
        let count = count_of(out_force.len(), 1, "cd_membrane_get_reaction", "out_force")?;
        check(unsafe { sys::cd_membrane_get_reaction(self.as_ptr(), u, v, out_force.as_mut_ptr(), count) })
    }

    /// Volume between the sheet and the origin \[m^3\]: a third of the integral of x over the surface's normal, each
    /// cell the mean of its two triangulations, cells with an absent node or torn open left out. Of a drum-head whose
    /// rim lies in a plane through the origin it is the volume under it; of a closed surface, what it encloses. 3
    /// components only. Errors: CD_ERROR_UNSUPPORTED.
    pub fn get_volume(&self) -> Result<f64> {
        let mut out_volume = 0.0;
        check(unsafe { sys::cd_membrane_get_volume(self.as_ptr(), &mut out_volume) })?;
        Ok(out_volume)
    }

    /// Positions at n places on the sheet, bilinear between nodes: at\[j\] = {u, v}, u in \[0, nu\] (ring: to nu + 1),
    /// v likewise; out_positions\[j\]\[component\], out_count = n \* components. Errors: CD_ERROR_RANGE, CD_ERROR_ENUM,
    /// CD_ERROR_VALUE.
    pub fn sample(&self, at: &[f64], outside: Outside, out_positions: &mut [f64]) -> Result<()> {
        let n = count_of(at.len(), 2, "cd_membrane_sample", "at")?;
        let out_count = count_of(out_positions.len(), 1, "cd_membrane_sample", "out_positions")?;
        check(unsafe { sys::cd_membrane_sample(self.as_ptr(), at.as_ptr(), n, outside as i32,
            out_positions.as_mut_ptr(), out_count) })
    }

    /// Bytes the membrane holds from its allocator.
    pub fn get_memory(&self) -> Result<usize> {
        let mut out_bytes = 0;
        check(unsafe { sys::cd_membrane_get_memory(self.as_ptr(), &mut out_bytes) })?;
        Ok(out_bytes)
    }

    /// A 64-bit hash of everything cd_membrane_save would write. Equal on every machine, compiler and vector width.
    pub fn hash(&self) -> Result<u64> {
        let mut out_hash = 0;
        check(unsafe { sys::cd_membrane_hash(self.as_ptr(), &mut out_hash) })?;
        Ok(out_hash)
    }

    /// Writes a vertex for every node, in node order, into the caller's buffer: vertex i at byte i \* stride, its
    /// position as 3 floats at position_offset and its unit normal, smooth across the sheet, as 3 floats at
    /// normal_offset. A normal points along x_u x x_v and is zero where the sheet has no area or is not finite.
    /// Components that are not there are written as 0, and a fourth is not drawn; a membrane of 1 component is drawn as
    /// the height z over the unit square, x = u / nu, y = v / nv (a direction without a spring: 0; a ring: u / (nu +
    /// 1), and for the normals the sheet goes on beyond its ends). normal_offset SIZE_MAX: no normals. Bytes between
    /// are left alone; any offset and stride will do, aligned or not, that keeps the vertices apart. Absent nodes get
    /// their vertex too, with a zero normal. Errors: CD_ERROR_RANGE if size \< nodes \* stride, an offset and its 12
    /// bytes reach past stride, or both overlap.
    pub fn write_vertices(&self, buffer: &mut [u8], stride: usize, position_offset: usize,
        normal_offset: usize) -> Result<()> {
        let size = buffer.len();
        check(unsafe { sys::cd_membrane_write_vertices(self.as_ptr(), buffer.as_mut_ptr().cast(), size, stride,
            position_offset, normal_offset) })
    }

    /// How many indices cd_membrane_write_indices writes now: 6 per cell of four nodes that are there, of cloth 0 if it
    /// is torn open, 3 per cell of which three are there. Cells that close a ring are among them, but not of 1
    /// component: they would reach back across the unit square.
    pub fn get_index_count(&self) -> Result<usize> {
        let mut out_count = 0;
        check(unsafe { sys::cd_membrane_get_index_count(self.as_ptr(), &mut out_count) })?;
        Ok(out_count)
    }

    /// Writes the triangles as vertex numbers of index_size 2 or 4 bytes (unsigned, the machine's byte order),
    /// counter-clockwise seen from where the normal points; a cell is cut from its node (u, v) to (u + 1, v + 1).
    /// `size` is that of the buffer in bytes. The numbers change with CD_MASK, cd_membrane_set_ring and what is cut of
    /// cloth only. 65535 with 2 bytes and 2^32 - 1 with 4, which graphics cards may take for a restart, are never
    /// written. Errors: CD_ERROR_VALUE for another index_size; CD_ERROR_RANGE if size is too small;
    /// CD_ERROR_UNSUPPORTED for more nodes.
    pub fn write_indices(&self, buffer: &mut [u8], index_size: usize) -> Result<()> {
        let size = buffer.len();
        check(unsafe { sys::cd_membrane_write_indices(self.as_ptr(), buffer.as_mut_ptr().cast(), size, index_size) })
    }

    /// The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load needs a
    /// membrane of the same shape and precision; it switches fields on and off as they were. Errors: save:
    /// CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn save_size(&self) -> Result<usize> {
        let mut out_size = 0;
        check(unsafe { sys::cd_membrane_save_size(self.as_ptr(), &mut out_size) })?;
        Ok(out_size)
    }

    /// The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load needs a
    /// membrane of the same shape and precision; it switches fields on and off as they were. Errors: save:
    /// CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn save_into(&self, buffer: &mut [u8]) -> Result<usize> {
        let size = buffer.len();
        let mut out_written = 0;
        check(unsafe { sys::cd_membrane_save(self.as_ptr(), buffer.as_mut_ptr().cast(), size, &mut out_written) })?;
        Ok(out_written)
    }

    /// The same into a new vector.
    pub fn save(&self) -> Result<Vec<u8>> {
        let mut bytes = vec![0; self.save_size()?];
        let written = self.save_into(&mut bytes)?;
        bytes.truncate(written);
        Ok(bytes)
    }

    /// The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load needs a
    /// membrane of the same shape and precision; it switches fields on and off as they were. Errors: save:
    /// CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn load(&mut self, bytes: &[u8]) -> Result<()> {
        let size = bytes.len();
        check(unsafe { sys::cd_membrane_load(self.as_ptr(), bytes.as_ptr().cast(), size) })
    }

    /// Makes `membrane` what `source` is, as save and load would, without the bytes: the two must agree in shape and
    /// precision. Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn copy_state(&mut self, source: &Membrane) -> Result<()> {
        check(unsafe { sys::cd_membrane_copy_state(self.as_ptr(), source.as_ptr()) })
    }

    /// Positions, velocities, time and steps back to 0. Parameters, fields and pins stay; targets too.
    pub fn reset(&mut self) -> Result<()> {
        check(unsafe { sys::cd_membrane_reset(self.as_ptr()) })
    }
}

/// What [`Water::get_shape`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaterShape {
    pub nx: usize,
    pub ny: usize,
    pub dx: f64,
    pub dy: f64,
    pub precision: Precision,
}

/// What [`Water::get_side`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaterSide {
    pub kind: Border,
    pub value: f64,
    pub rate: f64,
}

/// What [`Water::get_hulls`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaterHulls {
    pub count: usize,
    pub n_along: usize,
    pub n_across: usize,
}

/// What [`Water::get_hull`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaterHull {
    pub mass: f64,
    pub length: f64,
    pub width: f64,
    pub area: f64,
}

/// What [`Water::get_hull_drag`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaterHullDrag {
    pub along: f64,
    pub across: f64,
    pub friction: f64,
}

/// What [`Water::get_hull_energy`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaterHullEnergy {
    pub kinetic: f64,
    pub potential: f64,
}

/// What [`Water::get_limited`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaterLimited {
    pub cells: u64,
    pub volume: f64,
}

/// What [`Water::get_account`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaterAccount {
    pub initial: f64,
    pub r#in: f64,
    pub out: f64,
    pub error: f64,
}

/// What [`Water::get_energy`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaterEnergy {
    pub kinetic: f64,
    pub potential: f64,
}

/// contdyn: water: a height field of columns over a bed: pool, river, tide, flood.
/// A water has nx x ny cells of dx x dy metres; ny = 1 is a slice. A cell holds a column of water of depth d \>= 0
/// over its bed b; its surface is h = b + d. Velocities live on the faces between cells: x-face (i, j) lies between
/// the cells (i - 1, j) and (i, j), so that there are nx + 1 of them in a row; y-face (i, j) between (i, j - 1) and
/// (i, j). Cell (i, j) has its centre at ((i + 1/2) dx, (j + 1/2) dy).
/// Motion d_t + (d u)_x + (d v)_y = source u_t \[+ u u_x + v u_y\] = -g h_x - p_x / density + force - friction u,
/// and v likewise friction = drag + g manning^2 |u| / d^(4/3) (Kass 1997, eq. 32-33; the bracket: shallow water)
/// CD_MOMENTUM_LINEAR without the bracket: waves, splashes, tides, floods that creep. CD_MOMENTUM_ADVECTED with it:
/// moving shores, dam breaks, bores, whirls. Momentum goes with the water that leaves a cell, upwind, of second
/// order where depths are even.
/// What to set: the momentum by this list; lambda as cd_water_set_momentum sets it; one step a frame, which is
/// never too long to be stable, or more where waves must run at their speed (cd_water_get_courant at most 1).
/// lambda = 1/2 is of second order in time and keeps the energy of small waves; above 1/2 short waves die out, and
/// linear water, whose shores are steep, needs a little more. Right for waves much longer than the water is deep
/// and for surfaces that do not turn over: there is no dispersion, and there are no ship wakes.
/// A step sweeps along all rows, then along all columns, and the next step the other way round. Along such a line
/// the fluxes and the changes of the surface are solved for together, by the theta scheme, theta = lambda, in time
/// in proportion to its cells. The depth at a face is the mean of its two cells'; where these differ a lot, it is
/// nearer to that of the cell which the water leaves. No cell gives more than it has and gets: cd_water_get_limited
/// tells how much that holds back. So no depth is negative, a lake lies still on any bed, and cd_water_get_account
/// tells all changes of volume. Explicit methods differ in that no surface is solved for: half of the slope pushes,
/// the water moves, then the other half pushes (velocity Verlet).
/// What goes wrong, and by how much. "From n cells on": in steps, or parts of fast water's, in which waves cross as
/// many. Long steps: from 1 cell on waves run too slowly, short ones most, and slantwise more than along the axes.
/// Make them shorter: to solve for the whole plane, a system that streams make neither symmetric nor definite, cost
/// tens of times as much, and gained and lost water. Fast water: a line whose water would run more than half a cell
/// makes its step in 2, 4, ... 64 parts, at so many times the cost, none of which begins with faster water. Water
/// that runs more than 32 cells is carried less exactly, and ripples on it may grow; on slower water only those of
/// linear momentum, lambda 1/2, uneven beds do. Bores, linear: momentum is not carried on, so that a shore moves
/// with the slope of the surface there, and a bore a tenth, half, twice as high as the depth before it is 2, 9, 22%
/// too slow, against a stream as much too fast. Bores, advected: within 1.2% of their speed, also against streams,
/// until water runs over 32 cells; from 2 cells on those a tenth of the depth high are spread over 2 to 6 times as
/// many. Waves behind a bore: with lambda = 1/2 up to its own height (linear: 1.6), with 0.6 up to 0.3 (1.3), all
/// along its way where the water behind it rests. Energy, linear: where water deepens it gains h_t u^2 / 2, at
/// random shores some hundredths in all (and see hulls). From 2 cells on waves in the plane, with lambda = 1/2,
/// grow in thousands of steps to a ninth of the depth. Energy, advected: from 1 cell on it does not rise by itself.
/// Below 1 cell up to 0.005 of it is won among cliffs, far below also at shores, and 0.01 in the first step after
/// velocities are written there. Energy, both: from 1 cell on no face gains more than its water loses by falling:
/// linear over uneven depths, advected where a depth changes by half; from 1e12 on rounding may add any amount. Air
/// that presses water dry adds 1.4 times what it has to give where momentum is linear, half of it where advected,
/// any amount if explicit. Dry land: what pushes water away from it gives the face at the water's edge a velocity
/// that no water follows.
/// A new water is dry, over a bed at 0, at rest, walled in, gravity 9.81, density 1000, no drag,
/// CD_MOMENTUM_LINEAR, CD_METHOD_IMPLICIT with lambda 0.55. All computing is in double precision; CD_FLOAT32 is
/// what depth, bed, velocities and the fields are stored in. Steps store 0 for depths below 2^-80 m and velocities
/// below 2^-80 (float32), 2^-500 m/s. Parameters may be as large as 1e60.
/// Every function returns CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a handle of another kind; the
/// comments name the other errors. Functions that chain and membrane have too mean the same here.
pub struct Water {
    handle: NonNull<sys::cd_water>,
}

// The library ties objects to no thread. They are not Sync, as NonNull is not.
unsafe impl Send for Water {}

impl Drop for Water {
    fn drop(&mut self) {
        unsafe { sys::cd_water_destroy(self.as_ptr()) }
    }
}

impl std::fmt::Debug for Water {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Debug::fmt(&self.get_shape(), f)
    }
}

impl Water {
    /// Makes a water. nx, ny \>= 1; dx, dy \[m\] in \[1e-30, 1e30\]. allocator may be null (malloc). The caller owns
    /// \*out_water and releases it with cd_water_destroy; on failure \*out_water is left alone. Errors: CD_ERROR_VALUE,
    /// CD_ERROR_ENUM, CD_ERROR_SIZE, CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for a precision that this build leaves out.
    pub fn new(nx: usize, ny: usize, dx: f64, dy: f64, precision: Precision) -> Result<Water> {
        unsafe { Water::create(nx, ny, dx, dy, precision, None) }
    }

    /// [`Water::new`] with callbacks.
    ///
    /// # Safety
    /// The functions and `user` must be good for as long as the object may call them, from whichever threads
    /// it is used on, and must not unwind.
    pub unsafe fn create(nx: usize, ny: usize, dx: f64, dy: f64, precision: Precision,
        allocator: Option<&sys::cd_allocator>) -> Result<Water> {
        check_version()?;
        let mut made = std::ptr::null_mut();
        check(unsafe { sys::cd_water_create(nx, ny, dx, dy, precision as i32, allocator.map_or(std::ptr::null(),
            |c| c as *const _), &mut made) })?;
        Ok(unsafe { Water::from_raw(made) })
    }

    /// Takes a handle over.
    ///
    /// # Safety
    /// It must be one of the library's, alive, and of this kind, and nobody else may use it from then on.
    pub unsafe fn from_raw(handle: *mut sys::cd_water) -> Water {
        Water { handle: NonNull::new(handle).expect("a handle") }
    }

    /// The handle, for functions of [`sys`]; it stays this object's.
    pub fn as_ptr(&self) -> *mut sys::cd_water {
        self.handle.as_ptr()
    }

    /// Gives the handle away, to be released by the caller.
    pub fn into_raw(self) -> *mut sys::cd_water {
        std::mem::ManuallyDrop::new(self).handle.as_ptr()
    }

    fn whole(&self, field: Field) -> Result<Whole> {
        const ROWS: [FieldRow; 12] = [
            FieldRow { field: Field::Depth, extents: [1, 0, 0, 2, 0, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::Bed, extents: [1, 0, 0, 2, 0, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::Surface, extents: [1, 0, 0, 2, 0, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::VelocityX, extents: [1, 1, 0, 2, 0, 0], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::VelocityY, extents: [1, 0, 0, 2, 1, 0], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::Source, extents: [1, 0, 0, 2, 0, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::Pressure, extents: [1, 0, 0, 2, 0, 0], components: false,
                one_but_in_ropes: false },
            FieldRow { field: Field::ForceX, extents: [1, 1, 0, 2, 0, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::ForceY, extents: [1, 0, 0, 2, 1, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::Mask, extents: [1, 0, 0, 2, 0, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::WallX, extents: [1, 1, 0, 2, 0, 0], components: false, one_but_in_ropes: false },
            FieldRow { field: Field::WallY, extents: [1, 0, 0, 2, 1, 0], components: false, one_but_in_ropes: false },
        ];
        let row = match ROWS.iter().find(|row| row.field == field) {
            Some(row) => row,
            None => return Ok(Whole::default()),
        };
        let shape = self.get_shape()?;
        Ok(Whole::new(row, &[shape.nx, shape.ny], &[], false, 1))
    }

    /// How many values a whole field has.
    pub fn get_size(&self, field: Field) -> Result<usize> {
        let count = self.whole(field)?.count();
        if count == 0 {
            self.read_f64(field, 0, 0, 0, 0, &mut [])?; // says which fields there are
        }
        Ok(count)
    }

    /// All values of a field, as `read_f32` or `read_f64`.
    pub fn read<T: Number>(&self, field: Field) -> Result<Vec<T>> {
        let whole = self.whole(field)?;
        let mut values = vec![T::default(); whole.count()];
        let [a, b, c, d] = whole.range(false);
        let field = field as i32;
        check(unsafe {
            if T::SINGLE {
                sys::cd_water_read_f32(self.as_ptr(), field, a, b, c, d, values.as_mut_ptr().cast(), values.len())
            } else {
                sys::cd_water_read_f64(self.as_ptr(), field, a, b, c, d, values.as_mut_ptr().cast(), values.len())
            }
        })?;
        Ok(values)
    }

    /// Writes all values of a field, as `write_f32` or `write_f64`.
    pub fn write<T: Number>(&mut self, field: Field, values: &[T]) -> Result<()> {
        let whole = self.whole(field)?;
        let [a, b, c, d] = whole.range(false);
        let field = field as i32;
        check(unsafe {
            if T::SINGLE {
                sys::cd_water_write_f32(self.as_ptr(), field, a, b, c, d, values.as_ptr().cast(), values.len())
            } else {
                sys::cd_water_write_f64(self.as_ptr(), field, a, b, c, d, values.as_ptr().cast(), values.len())
            }
        })
    }

    /// What cd_water_create was given, or what has been loaded since. Each output may be null.
    pub fn get_shape(&self) -> Result<WaterShape> {
        let mut out_nx = 0;
        let mut out_ny = 0;
        let mut out_dx = 0.0;
        let mut out_dy = 0.0;
        let mut out_precision = 0;
        check(unsafe { sys::cd_water_get_shape(self.as_ptr(), &mut out_nx, &mut out_ny, &mut out_dx, &mut out_dy,
            &mut out_precision) })?;
        Ok(WaterShape {
            nx: out_nx,
            ny: out_ny,
            dx: out_dx,
            dy: out_dy,
            precision: known(Precision::from_raw(out_precision), out_precision, "cd_water_get_shape")?,
        })
    }

    /// How steps are made: CD_METHOD_IMPLICIT; CD_METHOD_SYMPLECTIC_EULER, here in its symmetric form, second order in
    /// time and bounded up to cd_water_stable_dt; CD_METHOD_FORWARD_EULER, first order, bounded at no dt. Errors:
    /// CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for CD_METHOD_STIFF_SECOND; CD_ERROR_MEMORY.
    pub fn set_method(&mut self, method: Method) -> Result<()> {
        check(unsafe { sys::cd_water_set_method(self.as_ptr(), method as i32) })
    }

    /// How steps are made: CD_METHOD_IMPLICIT; CD_METHOD_SYMPLECTIC_EULER, here in its symmetric form, second order in
    /// time and bounded up to cd_water_stable_dt; CD_METHOD_FORWARD_EULER, first order, bounded at no dt. Errors:
    /// CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for CD_METHOD_STIFF_SECOND; CD_ERROR_MEMORY.
    pub fn get_method(&self) -> Result<Method> {
        let mut out_method = 0;
        check(unsafe { sys::cd_water_get_method(self.as_ptr(), &mut out_method) })?;
        known(Method::from_raw(out_method), out_method, "cd_water_get_method")
    }

    /// lambda of CD_METHOD_IMPLICIT, in \[0, 1\]; below 1/2 it grows without bound at most dt. Errors: CD_ERROR_VALUE.
    pub fn set_lambda(&mut self, lambda: f64) -> Result<()> {
        check(unsafe { sys::cd_water_set_lambda(self.as_ptr(), lambda) })
    }

    /// lambda of CD_METHOD_IMPLICIT, in \[0, 1\]; below 1/2 it grows without bound at most dt. Errors: CD_ERROR_VALUE.
    pub fn get_lambda(&self) -> Result<f64> {
        let mut out_lambda = 0.0;
        check(unsafe { sys::cd_water_get_lambda(self.as_ptr(), &mut out_lambda) })?;
        Ok(out_lambda)
    }

    /// Linear or advected momentum; see above. Sets lambda too, to what suits the mode: 0.55 for linear, 1/2 for
    /// advected. Advected momentum costs memory. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
    pub fn set_momentum(&mut self, momentum: Momentum) -> Result<()> {
        check(unsafe { sys::cd_water_set_momentum(self.as_ptr(), momentum as i32) })
    }

    /// Linear or advected momentum; see above. Sets lambda too, to what suits the mode: 0.55 for linear, 1/2 for
    /// advected. Advected momentum costs memory. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.
    pub fn get_momentum(&self) -> Result<Momentum> {
        let mut out_momentum = 0;
        check(unsafe { sys::cd_water_get_momentum(self.as_ptr(), &mut out_momentum) })?;
        known(Momentum::from_raw(out_momentum), out_momentum, "cd_water_get_momentum")
    }

    /// Which way the next step sweeps first: along x (0, the default of a new water) or along y (1). Every step turns
    /// it round. A scene and its transpose, begun opposite ways, stay each other's transpose to the bit. Errors:
    /// CD_ERROR_VALUE for anything but 0 and 1.
    pub fn set_first(&mut self, along_y: bool) -> Result<()> {
        check(unsafe { sys::cd_water_set_first(self.as_ptr(), i32::from(along_y)) })
    }

    /// Which way the next step sweeps first: along x (0, the default of a new water) or along y (1). Every step turns
    /// it round. A scene and its transpose, begun opposite ways, stay each other's transpose to the bit. Errors:
    /// CD_ERROR_VALUE for anything but 0 and 1.
    pub fn get_first(&self) -> Result<bool> {
        let mut out_along_y = 0;
        check(unsafe { sys::cd_water_get_first(self.as_ptr(), &mut out_along_y) })?;
        Ok(out_along_y != 0)
    }

    /// Spreads a step over the caller's threads. Null turns it off. It costs memory, for work that threads do not
    /// share. Errors: CD_ERROR_NULL for a table without run; CD_ERROR_MEMORY.
    ///
    /// # Safety
    /// The functions and `user` must be good for as long as the object may call them, from whichever threads
    /// it is used on, and must not unwind.
    pub unsafe fn set_parallel(&mut self, parallel: Option<&sys::cd_parallel>) -> Result<()> {
        check(unsafe { sys::cd_water_set_parallel(self.as_ptr(), parallel.map_or(std::ptr::null(),
            |c| c as *const _)) })
    }

    /// The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and
    /// a new water has the fastest that its processor runs. Not part of the saved state. Errors: CD_ERROR_ENUM;
    /// CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
    pub fn set_kernels(&mut self, kernels: Kernels) -> Result<()> {
        check(unsafe { sys::cd_water_set_kernels(self.as_ptr(), kernels as i32) })
    }

    /// The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and
    /// a new water has the fastest that its processor runs. Not part of the saved state. Errors: CD_ERROR_ENUM;
    /// CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.
    pub fn get_kernels(&self) -> Result<Kernels> {
        let mut out_kernels = 0;
        check(unsafe { sys::cd_water_get_kernels(self.as_ptr(), &mut out_kernels) })?;
        known(Kernels::from_raw(out_kernels), out_kernels, "cd_water_get_kernels")
    }

    /// Gravity \[m/s^2\], 0 or in \[1e-60, 1e6\]; default 9.81.
    pub fn set_gravity(&mut self, gravity: f64) -> Result<()> {
        check(unsafe { sys::cd_water_set_gravity(self.as_ptr(), gravity) })
    }

    /// Gravity \[m/s^2\], 0 or in \[1e-60, 1e6\]; default 9.81.
    pub fn get_gravity(&self) -> Result<f64> {
        let mut out_gravity = 0.0;
        check(unsafe { sys::cd_water_get_gravity(self.as_ptr(), &mut out_gravity) })?;
        Ok(out_gravity)
    }

    /// Density \[kg/m^3\], in \[1e-6, 1e6\]; default 1000. Only pressure, impulses and energies know it.
    pub fn set_density(&mut self, density: f64) -> Result<()> {
        check(unsafe { sys::cd_water_set_density(self.as_ptr(), density) })
    }

    /// Density \[kg/m^3\], in \[1e-6, 1e6\]; default 1000. Only pressure, impulses and energies know it.
    pub fn get_density(&self) -> Result<f64> {
        let mut out_density = 0.0;
        check(unsafe { sys::cd_water_get_density(self.as_ptr(), &mut out_density) })?;
        Ok(out_density)
    }

    /// Drag \[1/s\], \>= 0: velocities die out by exp(-drag t). Default 0.
    pub fn set_drag(&mut self, drag: f64) -> Result<()> {
        check(unsafe { sys::cd_water_set_drag(self.as_ptr(), drag) })
    }

    /// Drag \[1/s\], \>= 0: velocities die out by exp(-drag t). Default 0.
    pub fn get_drag(&self) -> Result<f64> {
        let mut out_drag = 0.0;
        check(unsafe { sys::cd_water_get_drag(self.as_ptr(), &mut out_drag) })?;
        Ok(out_drag)
    }

    /// Manning's roughness of the bed \[s/m^(1/3)\], in \[0, 1e3\]: 0.01 for glass, 0.03 for a river, 0.1 for a flooded
    /// wood. Default 0. Water that runs down a slope S, any way, settles at d^(2/3) sqrt(S) / manning.
    pub fn set_manning(&mut self, manning: f64) -> Result<()> {
        check(unsafe { sys::cd_water_set_manning(self.as_ptr(), manning) })
    }

    /// Manning's roughness of the bed \[s/m^(1/3)\], in \[0, 1e3\]: 0.01 for glass, 0.03 for a river, 0.1 for a flooded
    /// wood. Default 0. Water that runs down a slope S, any way, settles at d^(2/3) sqrt(S) / manning.
    pub fn get_manning(&self) -> Result<f64> {
        let mut out_manning = 0.0;
        check(unsafe { sys::cd_water_get_manning(self.as_ptr(), &mut out_manning) })?;
        Ok(out_manning)
    }

    /// What is at a side. `value` now, and how fast it changes, `rate` per second, from now on, both at most 1e60 in
    /// size, in CD_FLOAT32 1e30: CD_BORDER_OPEN level of the water outside \[m\], which is at rest: for a tide set
    /// level and rate anew as it goes. Low waves leave without an echo; some hundredths of high ones come back. With d
    /// the depth in the cell at the side, D the level's depth over the same bed, water leaves by u = 2 (sqrt(g d) -
    /// sqrt(g D)), linear by u = sqrt(g d) (1 - D / d), and the discharge is u d. Where u is faster than waves, as over
    /// a side that lies higher than the level, water falls off: a stream slower than its waves leaves at critical
    /// depth, u = sqrt(g d), a faster one as it comes. CD_BORDER_LEVEL level \[m\] that is held at the side itself:
    /// with D its depth over the bed of the cell there and q the discharge one face inside, what leaves tends, as waves
    /// cross half a cell, to q + 2 D (sqrt(g d) - sqrt(g D)), advected with q D / d for q where d \< D. Advected water
    /// that comes in at U stands U^2 / 2 g lower, at most D / 3. Waves are thrown back; with lambda = 1/2 some may
    /// grow, slowly. What outruns its waves falls off as above. CD_BORDER_INFLOW discharge per metre of the side
    /// \[m^2/s\] into the water, velocity times depth; into a cell below critical depth it comes in at that. If
    /// negative it leaves, as far as there is water. CD_BORDER_WALL, CD_BORDER_PERIODIC value and rate mean nothing
    /// Both sides of a direction are periodic or neither is: setting one sets the other, and leaving it leaves both,
    /// the opposite one as a wall. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE.
    pub fn set_side(&mut self, side: Side, kind: Border, value: f64, rate: f64) -> Result<()> {
        check(unsafe { sys::cd_water_set_side(self.as_ptr(), side as i32, kind as i32, value, rate) })
    }

    /// Value and rate as of now; 0 where they mean nothing. Each output may be null. Errors: CD_ERROR_ENUM.
    pub fn get_side(&self, side: Side) -> Result<WaterSide> {
        let mut out_kind = 0;
        let mut out_value = 0.0;
        let mut out_rate = 0.0;
        check(unsafe { sys::cd_water_get_side(self.as_ptr(), side as i32, &mut out_kind, &mut out_value,
            &mut out_rate) })?;
        Ok(WaterSide {
            kind: known(Border::from_raw(out_kind), out_kind, "cd_water_get_side")?,
            value: out_value,
            rate: out_rate,
        })
    }

    /// Depth of an inflow \[m\], 0 or in \[1e-6, 1e30\]; default 0: that of the cell at the side. Else advected water
    /// comes in at the speed of its discharge in that depth, as under a gate so far open: faster than its waves, it has
    /// that depth in the first cell; if slower, or if it drowns the gate, that of what comes after. Other sides,
    /// outflow and linear momentum do not use it; cd_water_set_side keeps it. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE.
    pub fn set_inflow_depth(&mut self, side: Side, depth: f64) -> Result<()> {
        check(unsafe { sys::cd_water_set_inflow_depth(self.as_ptr(), side as i32, depth) })
    }

    /// Depth of an inflow \[m\], 0 or in \[1e-6, 1e30\]; default 0: that of the cell at the side. Else advected water
    /// comes in at the speed of its discharge in that depth, as under a gate so far open: faster than its waves, it has
    /// that depth in the first cell; if slower, or if it drowns the gate, that of what comes after. Other sides,
    /// outflow and linear momentum do not use it; cd_water_set_side keeps it. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE.
    pub fn get_inflow_depth(&self, side: Side) -> Result<f64> {
        let mut out_depth = 0.0;
        check(unsafe { sys::cd_water_get_inflow_depth(self.as_ptr(), side as i32, &mut out_depth) })?;
        Ok(out_depth)
    }

    /// What a write to CD_BED leaves as it is; default CD_BED_LIFTS_WATER. Errors: CD_ERROR_ENUM.
    pub fn set_bed_rule(&mut self, rule: BedRule) -> Result<()> {
        check(unsafe { sys::cd_water_set_bed_rule(self.as_ptr(), rule as i32) })
    }

    /// What a write to CD_BED leaves as it is; default CD_BED_LIFTS_WATER. Errors: CD_ERROR_ENUM.
    pub fn get_bed_rule(&self) -> Result<BedRule> {
        let mut out_rule = 0;
        check(unsafe { sys::cd_water_get_bed_rule(self.as_ptr(), &mut out_rule) })?;
        known(BedRule::from_raw(out_rule), out_rule, "cd_water_get_bed_rule")
    }

    /// Switches a field on: no sources, pressure, force or walls yet, all cells there. On already: nothing happens.
    /// Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for a field of other objects; CD_ERROR_MEMORY.
    pub fn enable_field(&mut self, field: Field) -> Result<()> {
        check(unsafe { sys::cd_water_enable_field(self.as_ptr(), field as i32) })
    }

    /// Switches a field off and releases its memory. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED if it is always there.
    pub fn disable_field(&mut self, field: Field) -> Result<()> {
        check(unsafe { sys::cd_water_disable_field(self.as_ptr(), field as i32) })
    }

    /// Writes or reads values\[j\]\[i\], dense, of the rectangle of cells or faces \[first_x, first_x + n_x) x
    /// \[first_y, first_y + n_y); `count` is n_x \* n_y. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces.
    /// Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM,
    /// CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index.
    pub fn write_f32(&mut self, field: Field, first_x: usize, first_y: usize, n_x: usize, n_y: usize,
        values: &[f32]) -> Result<()> {
        let count = count_of(values.len(), 1, "cd_water_write_f32", "values")?;
        check(unsafe { sys::cd_water_write_f32(self.as_ptr(), field as i32, first_x, first_y, n_x, n_y,
            values.as_ptr(), count) })
    }

    /// Writes or reads values\[j\]\[i\], dense, of the rectangle of cells or faces \[first_x, first_x + n_x) x
    /// \[first_y, first_y + n_y); `count` is n_x \* n_y. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces.
    /// Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM,
    /// CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index.
    pub fn write_f64(&mut self, field: Field, first_x: usize, first_y: usize, n_x: usize, n_y: usize,
        values: &[f64]) -> Result<()> {
        let count = count_of(values.len(), 1, "cd_water_write_f64", "values")?;
        check(unsafe { sys::cd_water_write_f64(self.as_ptr(), field as i32, first_x, first_y, n_x, n_y,
            values.as_ptr(), count) })
    }

    /// Writes or reads values\[j\]\[i\], dense, of the rectangle of cells or faces \[first_x, first_x + n_x) x
    /// \[first_y, first_y + n_y); `count` is n_x \* n_y. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces.
    /// Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM,
    /// CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index.
    pub fn read_f32(&self, field: Field, first_x: usize, first_y: usize, n_x: usize, n_y: usize,
        out_values: &mut [f32]) -> Result<()> {
        let count = count_of(out_values.len(), 1, "cd_water_read_f32", "out_values")?;
        check(unsafe { sys::cd_water_read_f32(self.as_ptr(), field as i32, first_x, first_y, n_x, n_y,
            out_values.as_mut_ptr(), count) })
    }

    /// Writes or reads values\[j\]\[i\], dense, of the rectangle of cells or faces \[first_x, first_x + n_x) x
    /// \[first_y, first_y + n_y); `count` is n_x \* n_y. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces.
    /// Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors: CD_ERROR_ENUM,
    /// CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first bad index.
    pub fn read_f64(&self, field: Field, first_x: usize, first_y: usize, n_x: usize, n_y: usize,
        out_values: &mut [f64]) -> Result<()> {
        let count = count_of(out_values.len(), 1, "cd_water_read_f64", "out_values")?;
        check(unsafe { sys::cd_water_read_f64(self.as_ptr(), field as i32, first_x, first_y, n_x, n_y,
            out_values.as_mut_ptr(), count) })
    }

    /// Where a field lies in the water's own memory, in its precision, to read without a copy: the value of (i, j) is
    /// at byte \*out_data + i \* x_stride + j \* y_stride. All but CD_SURFACE, CD_MASK and the walls. The pointer is
    /// good until the field is switched off or the water released; the numbers change with every write and step. Do not
    /// write through it. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_UNSUPPORTED.
    pub fn view(&self, field: Field) -> Result<View<'_>> {
        let mut data = std::ptr::null();
        let mut strides = [0; 3];
        let [s0, s1, ..] = &mut strides;
        check(unsafe { sys::cd_water_view(self.as_ptr(), field as i32, &mut data, s0, s1) })?;
        Ok(View::new(data.cast(), strides, self.whole(field)?, self.get_shape()?.precision))
    }

    /// Adds volume \[m^3\] over a disc, or takes it if negative, as far as there is water in each cell's share.
    /// out_added, which may be null, tells what it came to. The account counts it. Errors: CD_ERROR_VALUE,
    /// CD_ERROR_DIVERGED.
    pub fn add_volume(&mut self, x: f64, y: f64, radius: f64, volume: f64) -> Result<f64> {
        let mut out_added = 0.0;
        check(unsafe { sys::cd_water_add_volume(self.as_ptr(), x, y, radius, volume, &mut out_added) })?;
        Ok(out_added)
    }

    /// Adds volume \[m^3\] evenly over the cells there of a rectangle, or takes it; out_added as above. Errors:
    /// CD_ERROR_RANGE; CD_ERROR_VALUE, CD_ERROR_DIVERGED.
    pub fn add_volume_rectangle(&mut self, first_x: usize, first_y: usize, n_x: usize, n_y: usize,
        volume: f64) -> Result<f64> {
        let mut out_added = 0.0;
        check(unsafe { sys::cd_water_add_volume_rectangle(self.as_ptr(), first_x, first_y, n_x, n_y, volume,
            &mut out_added) })?;
        Ok(out_added)
    }

    /// Adds a source of rate \[m^3/s\] over a disc to CD_SOURCE, or a drain if negative, and switches that field on.
    /// Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.
    pub fn add_source(&mut self, x: f64, y: f64, radius: f64, rate: f64) -> Result<()> {
        check(unsafe { sys::cd_water_add_source(self.as_ptr(), x, y, radius, rate) })
    }

    /// The same evenly over the cells there of a rectangle. Errors: CD_ERROR_RANGE; CD_ERROR_VALUE; CD_ERROR_MEMORY.
    pub fn add_source_rectangle(&mut self, first_x: usize, first_y: usize, n_x: usize, n_y: usize,
        rate: f64) -> Result<()> {
        check(unsafe { sys::cd_water_add_source_rectangle(self.as_ptr(), first_x, first_y, n_x, n_y, rate) })
    }

    /// A splash: water of the disc, down to `height` \[m\] \>= 0 at its centre and as far as there is water, is heaped
    /// up on the wet cells around it, out to twice the radius, if there are any; volume is kept. Errors:
    /// CD_ERROR_VALUE, _DIVERGED.
    pub fn splash(&mut self, x: f64, y: f64, radius: f64, height: f64) -> Result<()> {
        check(unsafe { sys::cd_water_splash(self.as_ptr(), x, y, radius, height) })
    }

    /// Adds an impulse (x, y) \[N s\] over a disc: a face's velocity changes by its share of it / the mass of water at
    /// it, shares in proportion to that mass too; on dry faces nothing happens. Errors: CD_ERROR_VALUE,
    /// CD_ERROR_DIVERGED.
    pub fn impulse(&mut self, x: f64, y: f64, radius: f64, impulse_x: f64, impulse_y: f64) -> Result<()> {
        check(unsafe { sys::cd_water_impulse(self.as_ptr(), x, y, radius, impulse_x, impulse_y) })
    }

    /// How many hulls there are, `count`, 0 to 4096, default 0, and how many plates each has, `n_along` and `n_across`,
    /// 1 to 256: new ones are none (mass 0), those that stay keep what they are unless the plates change. Without hulls
    /// n_along and n_across mean nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. Each output may be null.
    pub fn set_hulls(&mut self, count: usize, n_along: usize, n_across: usize) -> Result<()> {
        check(unsafe { sys::cd_water_set_hulls(self.as_ptr(), count, n_along, n_across) })
    }

    /// How many hulls there are, `count`, 0 to 4096, default 0, and how many plates each has, `n_along` and `n_across`,
    /// 1 to 256: new ones are none (mass 0), those that stay keep what they are unless the plates change. Without hulls
    /// n_along and n_across mean nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. Each output may be null.
    pub fn get_hulls(&self) -> Result<WaterHulls> {
        let mut out_count = 0;
        let mut out_n_along = 0;
        let mut out_n_across = 0;
        check(unsafe { sys::cd_water_get_hulls(self.as_ptr(), &mut out_count, &mut out_n_along, &mut out_n_across) })?;
        Ok(WaterHulls {
            count: out_count,
            n_along: out_n_along,
            n_across: out_n_across,
        })
    }

    /// Makes a hull of a mass \[kg\] in \[1e-12, 1e15\] and length and width \[m\], \>= 1e-60 and at most 512 cells.
    /// heights\[j\]\[i\]: of the floor's plate i along, j to port, above the keel \[m\], in \[0, 1e60\], or -1 where
    /// there is none; `count` is n_along n_across; null: flat. Where it is, and how it moves, stays. Errors:
    /// CD_ERROR_VALUE, also for no plate.
    pub fn set_hull(&mut self, index: usize, mass: f64, length: f64, width: f64,
        heights: Option<&[f64]>) -> Result<()> {
        let count = heights.map(<[_]>::len);
        let count = count_of(count.unwrap_or(0), 1, "cd_water_set_hull", "heights")?;
        check(unsafe { sys::cd_water_set_hull(self.as_ptr(), index, mass, length, width,
            heights.map_or(std::ptr::null(), <[_]>::as_ptr), count) })
    }

    /// Makes a hull with a flat round floor: those plates of a square whose middles lie in the disc, all stretched so
    /// that their area is the disc's. The radius \[m\] is \>= 1e-60, the square at most 512 cells wide. Errors:
    /// CD_ERROR_VALUE.
    pub fn set_disc(&mut self, index: usize, mass: f64, radius: f64) -> Result<()> {
        check(unsafe { sys::cd_water_set_disc(self.as_ptr(), index, mass, radius) })
    }

    /// What a hull is: mass (0: none), length, width, the area of its plates \[m^2\]. Each output may be null; heights:
    /// `count` of them, or null and any count.
    pub fn get_hull(&self, index: usize, out_heights: Option<&mut [f64]>) -> Result<WaterHull> {
        let count = out_heights.as_deref().map(<[_]>::len);
        let count = count_of(count.unwrap_or(0), 1, "cd_water_get_hull", "out_heights")?;
        let mut out_mass = 0.0;
        let mut out_length = 0.0;
        let mut out_width = 0.0;
        let mut out_area = 0.0;
        check(unsafe { sys::cd_water_get_hull(self.as_ptr(), index, &mut out_mass, &mut out_length, &mut out_width,
            &mut out_area, out_heights.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr), count) })?;
        Ok(WaterHull {
            mass: out_mass,
            length: out_length,
            width: out_width,
            area: out_area,
        })
    }

    /// What a hull is: mass (0: none), length, width, the area of its plates \[m^2\]. Each output may be null; heights:
    /// `count` of them, or null and any count.
    pub fn remove_hull(&mut self, index: usize) -> Result<()> {
        check(unsafe { sys::cd_water_remove_hull(self.as_ptr(), index) })
    }

    /// Launches a hull at (x, y) in the scene, its bow towards (ahead_x, ahead_y) of any length but 0, at rest. It lies
    /// as it would in time. The water that it displaces goes, evenly, to all cells whose surface is within its draft of
    /// that under it; where there is no such cell, or the bed bears it, it displaces none. What it displaced before is
    /// not given back: to move a hull set its pose. Errors: CD_ERROR_VALUE; CD_ERROR_DISABLED if it has no mass, or no
    /// cell is under it, or gravity is 0; CD_ERROR_DIVERGED of a water that did.
    pub fn launch_hull(&mut self, index: usize, x: f64, y: f64, ahead_x: f64, ahead_y: f64) -> Result<()> {
        check(unsafe { sys::cd_water_launch_hull(self.as_ptr(), index, x, y, ahead_x, ahead_y) })
    }

    /// The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most
    /// 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An
    /// obstacle that moves through the water, as heavy as the water in its place or heavier, has both set before each
    /// step; with its keel a third of the water's depth below the bed it presses all water away. Errors:
    /// CD_ERROR_VALUE.
    pub fn set_hull_pose(&mut self, index: usize, pose: &[f64]) -> Result<()> {
        let count = count_of(pose.len(), 1, "cd_water_set_hull_pose", "pose")?;
        check(unsafe { sys::cd_water_set_hull_pose(self.as_ptr(), index, pose.as_ptr(), count) })
    }

    /// The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most
    /// 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An
    /// obstacle that moves through the water, as heavy as the water in its place or heavier, has both set before each
    /// step; with its keel a third of the water's depth below the bed it presses all water away. Errors:
    /// CD_ERROR_VALUE.
    pub fn get_hull_pose(&self, index: usize, out_pose: &mut [f64]) -> Result<()> {
        let count = count_of(out_pose.len(), 1, "cd_water_get_hull_pose", "out_pose")?;
        check(unsafe { sys::cd_water_get_hull_pose(self.as_ptr(), index, out_pose.as_mut_ptr(), count) })
    }

    /// The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most
    /// 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An
    /// obstacle that moves through the water, as heavy as the water in its place or heavier, has both set before each
    /// step; with its keel a third of the water's depth below the bed it presses all water away. Errors:
    /// CD_ERROR_VALUE.
    pub fn set_hull_velocity(&mut self, index: usize, velocity: &[f64]) -> Result<()> {
        let count = count_of(velocity.len(), 1, "cd_water_set_hull_velocity", "velocity")?;
        check(unsafe { sys::cd_water_set_hull_velocity(self.as_ptr(), index, velocity.as_ptr(), count) })
    }

    /// The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most
    /// 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An
    /// obstacle that moves through the water, as heavy as the water in its place or heavier, has both set before each
    /// step; with its keel a third of the water's depth below the bed it presses all water away. Errors:
    /// CD_ERROR_VALUE.
    pub fn get_hull_velocity(&self, index: usize, out_velocity: &mut [f64]) -> Result<()> {
        let count = count_of(out_velocity.len(), 1, "cd_water_get_hull_velocity", "out_velocity")?;
        check(unsafe { sys::cd_water_get_hull_velocity(self.as_ptr(), index, out_velocity.as_mut_ptr(), count) })
    }

    /// The pose in which the floor lies on the water since the last step or launch, to be drawn: 7 numbers.
    pub fn get_hull_floor(&self, index: usize, out_pose: &mut [f64]) -> Result<()> {
        let count = count_of(out_pose.len(), 1, "cd_water_get_hull_floor", "out_pose")?;
        check(unsafe { sys::cd_water_get_hull_floor(self.as_ptr(), index, out_pose.as_mut_ptr(), count) })
    }

    /// What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port and up \[N\]
    /// and moments of yaw, pitch and roll \[N m\], at most 1e30 in size. Default 0. Errors: CD_ERROR_VALUE.
    pub fn set_hull_force(&mut self, index: usize, force: &[f64]) -> Result<()> {
        let count = count_of(force.len(), 1, "cd_water_set_hull_force", "force")?;
        check(unsafe { sys::cd_water_set_hull_force(self.as_ptr(), index, force.as_ptr(), count) })
    }

    /// What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port and up \[N\]
    /// and moments of yaw, pitch and roll \[N m\], at most 1e30 in size. Default 0. Errors: CD_ERROR_VALUE.
    pub fn get_hull_force(&self, index: usize, out_force: &mut [f64]) -> Result<()> {
        let count = count_of(out_force.len(), 1, "cd_water_get_hull_force", "out_force")?;
        check(unsafe { sys::cd_water_get_hull_force(self.as_ptr(), index, out_force.as_mut_ptr(), count) })
    }

    /// Drag against the water under it, along the hull and across it \[N s/m\], which slows turning too, and Coulomb
    /// friction on the bed; in \[0, 1e30\], default 0. Errors: CD_ERROR_VALUE.
    pub fn set_hull_drag(&mut self, index: usize, along: f64, across: f64, friction: f64) -> Result<()> {
        check(unsafe { sys::cd_water_set_hull_drag(self.as_ptr(), index, along, across, friction) })
    }

    /// Drag against the water under it, along the hull and across it \[N s/m\], which slows turning too, and Coulomb
    /// friction on the bed; in \[0, 1e30\], default 0. Errors: CD_ERROR_VALUE.
    pub fn get_hull_drag(&self, index: usize) -> Result<WaterHullDrag> {
        let mut out_along = 0.0;
        let mut out_across = 0.0;
        let mut out_friction = 0.0;
        check(unsafe { sys::cd_water_get_hull_drag(self.as_ptr(), index, &mut out_along, &mut out_across,
            &mut out_friction) })?;
        Ok(WaterHullDrag {
            along: out_along,
            across: out_across,
            friction: out_friction,
        })
    }

    /// What a hull felt from water and bed in the last step: 6 numbers, forces x, y, up \[N\], moments yaw, pitch, roll
    /// \[N m\].
    pub fn get_hull_load(&self, index: usize, out_load: &mut [f64]) -> Result<()> {
        let count = count_of(out_load.len(), 1, "cd_water_get_hull_load", "out_load")?;
        check(unsafe { sys::cd_water_get_hull_load(self.as_ptr(), index, out_load.as_mut_ptr(), count) })
    }

    /// Energies of all hulls \[J\]: of their motion; mass g z, and what their skins hold. Each output may be null.
    pub fn get_hull_energy(&self) -> Result<WaterHullEnergy> {
        let mut out_kinetic = 0.0;
        let mut out_potential = 0.0;
        check(unsafe { sys::cd_water_get_hull_energy(self.as_ptr(), &mut out_kinetic, &mut out_potential) })?;
        Ok(WaterHullEnergy {
            kinetic: out_kinetic,
            potential: out_potential,
        })
    }

    /// How high \[m\] the water would stand at n places, at\[k\] = {x, y}, with no hull pressing on it: its surface and
    /// the head that hulls press with. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE for a place outside; CD_ERROR_RANGE for
    /// more than fit in memory.
    pub fn sample_heads(&self, at: &[f64], outside: Outside, out_heads: &mut [f64]) -> Result<()> {
        let n = count_of(at.len(), 2, "cd_water_sample_heads", "at")?;
        same(Some(out_heads.len()), n.checked_mul(1), "cd_water_sample_heads", "out_heads")?;
        check(unsafe { sys::cd_water_sample_heads(self.as_ptr(), at.as_ptr(), n, outside as i32,
            out_heads.as_mut_ptr()) })
    }

    /// Makes `count` steps of dt \[s\] each, 0 or in \[1e-30, 1e30\]: with 0 no time passes, as with 0 steps. Never
    /// allocates. Time is proportional to count \* cells, and to the parts that steps are made in (see above). Errors:
    /// CD_ERROR_VALUE; CD_ERROR_DIVERGED if a number leaves the finite range: all steps are made, the message gives the
    /// first bad one, the water can be read, and steps again after cd_water_reset, a load, or once finite depths and
    /// velocities have been written.
    pub fn step(&mut self, dt: f64, count: usize) -> Result<()> {
        check(unsafe { sys::cd_water_step(self.as_ptr(), dt, count) })
    }

    /// The longest dt at which CD_METHOD_SYMPLECTIC_EULER stays bounded for small waves on the water as it lies now,
    /// whatever method is set: the least of both axes, each exact in the limit of many cells for water of one depth, a
    /// safe lower bound otherwise; for a stream over an uneven bed take 0.8 of it. INFINITY if nothing can swing.
    pub fn stable_dt(&self) -> Result<f64> {
        let mut out_dt = 0.0;
        check(unsafe { sys::cd_water_stable_dt(self.as_ptr(), &mut out_dt) })?;
        Ok(out_dt)
    }

    /// Simulated time \[s\] and steps made since create or reset, those before a load or a copied state included.
    pub fn get_time(&self) -> Result<f64> {
        let mut out_time = 0.0;
        check(unsafe { sys::cd_water_get_time(self.as_ptr(), &mut out_time) })?;
        Ok(out_time)
    }

    /// Simulated time \[s\] and steps made since create or reset, those before a load or a copied state included.
    pub fn get_steps(&self) -> Result<u64> {
        let mut out_steps = 0;
        check(unsafe { sys::cd_water_get_steps(self.as_ptr(), &mut out_steps) })?;
        Ok(out_steps)
    }

    /// How many times lines have been solved along a direction since the water was made: of every sweep the most parts
    /// that a line made its step in, each a factorization of its own, since depths change. Not part of the saved state.
    pub fn get_factorizations(&self) -> Result<u64> {
        let mut out_count = 0;
        check(unsafe { sys::cd_water_get_factorizations(self.as_ptr(), &mut out_count) })?;
        Ok(out_count)
    }

    /// What the last call of cd_water_step had to hold back so that no cell gave more than it had and got: in how many
    /// cells, counted once per sweep and part, and how much less water \[m^3\] went through faces. Each output may be
    /// null.
    pub fn get_limited(&self) -> Result<WaterLimited> {
        let mut out_cells = 0;
        let mut out_volume = 0.0;
        check(unsafe { sys::cd_water_get_limited(self.as_ptr(), &mut out_cells, &mut out_volume) })?;
        Ok(WaterLimited {
            cells: out_cells,
            volume: out_volume,
        })
    }

    /// Lets water sleep where it hardly moves: steps leave parts of 16 x 16 cells as they are, at no cost, where all
    /// waves are lower than `height` \[m\], in \[0, 1e60\], and so are all that a step could carry there. Default 0:
    /// nothing sleeps. Neglected are, at each face, a rise of the surface below height / 16, a velocity below height
    /// sqrt(g / d), and water that stands less than the height over the higher bed. What falls asleep stops, so energy
    /// is lost and none gained; volume is kept. Waves lower than the height meet sleeping water as a wall. The energy
    /// bound of long steps, which is one of whole lines, is then one of what is awake of a line. Awake stay parts with
    /// sources or forces, under hulls, and at open, level and inflow sides; and all of the water while there are higher
    /// waves at a periodic side. Which parts sleep follows from the state alone, whatever hook and kernels; where all
    /// are awake a step has the bits of one of water that never sleeps. A step's time is in proportion to the cells
    /// awake, each up to half as dear again. A splash, a volume, an impulse, a write of cells or faces and what is set
    /// of a hull wake what they touch; after any other call that may change the water the next step looks at all of it,
    /// in half a step's time. Costs a byte for ten cells. The height is kept with the state. Errors: CD_ERROR_VALUE;
    /// CD_ERROR_MEMORY.
    pub fn set_sleep(&mut self, height: f64) -> Result<()> {
        check(unsafe { sys::cd_water_set_sleep(self.as_ptr(), height) })
    }

    /// Lets water sleep where it hardly moves: steps leave parts of 16 x 16 cells as they are, at no cost, where all
    /// waves are lower than `height` \[m\], in \[0, 1e60\], and so are all that a step could carry there. Default 0:
    /// nothing sleeps. Neglected are, at each face, a rise of the surface below height / 16, a velocity below height
    /// sqrt(g / d), and water that stands less than the height over the higher bed. What falls asleep stops, so energy
    /// is lost and none gained; volume is kept. Waves lower than the height meet sleeping water as a wall. The energy
    /// bound of long steps, which is one of whole lines, is then one of what is awake of a line. Awake stay parts with
    /// sources or forces, under hulls, and at open, level and inflow sides; and all of the water while there are higher
    /// waves at a periodic side. Which parts sleep follows from the state alone, whatever hook and kernels; where all
    /// are awake a step has the bits of one of water that never sleeps. A step's time is in proportion to the cells
    /// awake, each up to half as dear again. A splash, a volume, an impulse, a write of cells or faces and what is set
    /// of a hull wake what they touch; after any other call that may change the water the next step looks at all of it,
    /// in half a step's time. Costs a byte for ten cells. The height is kept with the state. Errors: CD_ERROR_VALUE;
    /// CD_ERROR_MEMORY.
    pub fn get_sleep(&self) -> Result<f64> {
        let mut out_height = 0.0;
        check(unsafe { sys::cd_water_get_sleep(self.as_ptr(), &mut out_height) })?;
        Ok(out_height)
    }

    /// How many cells were awake in the last step; all, before it and where nothing sleeps. Not part of the saved
    /// state.
    pub fn get_awake(&self) -> Result<usize> {
        let mut out_cells = 0;
        check(unsafe { sys::cd_water_get_awake(self.as_ptr(), &mut out_cells) })?;
        Ok(out_cells)
    }

    /// Volume \[m^3\]: the sum of all depths times the cells' area.
    pub fn get_volume(&self) -> Result<f64> {
        let mut out_volume = 0.0;
        check(unsafe { sys::cd_water_get_volume(self.as_ptr(), &mut out_volume) })?;
        Ok(out_volume)
    }

    /// The volume account \[m^3\], kept in double whatever the precision: what was there when it was started (by
    /// create, reset, cd_water_restart_account, or a write of CD_DEPTH, CD_SURFACE or CD_MASK), what came in since then
    /// (sides, sources, volumes added, beds that keep the surface), what went out, and what the present volume has
    /// above initial + in - out, which is rounding. Each output may be null.
    pub fn get_account(&self) -> Result<WaterAccount> {
        let mut out_initial = 0.0;
        let mut out_in = 0.0;
        let mut out_out = 0.0;
        let mut out_error = 0.0;
        check(unsafe { sys::cd_water_get_account(self.as_ptr(), &mut out_initial, &mut out_in, &mut out_out,
            &mut out_error) })?;
        Ok(WaterAccount {
            initial: out_initial,
            r#in: out_in,
            out: out_out,
            error: out_error,
        })
    }

    /// The volume account \[m^3\], kept in double whatever the precision: what was there when it was started (by
    /// create, reset, cd_water_restart_account, or a write of CD_DEPTH, CD_SURFACE or CD_MASK), what came in since then
    /// (sides, sources, volumes added, beds that keep the surface), what went out, and what the present volume has
    /// above initial + in - out, which is rounding. Each output may be null.
    pub fn restart_account(&mut self) -> Result<()> {
        check(unsafe { sys::cd_water_restart_account(self.as_ptr()) })
    }

    /// Energies \[J\]; each output may be null. Kinetic: density / 2 times area, mean depth of both cells and
    /// velocity^2 of faces, at a shore as steps begin with it. Potential: density g times area, depth and height of the
    /// column's middle.
    pub fn get_energy(&self) -> Result<WaterEnergy> {
        let mut out_kinetic = 0.0;
        let mut out_potential = 0.0;
        check(unsafe { sys::cd_water_get_energy(self.as_ptr(), &mut out_kinetic, &mut out_potential) })?;
        Ok(WaterEnergy {
            kinetic: out_kinetic,
            potential: out_potential,
        })
    }

    /// Area \[m^2\] of the cells with depth \> 0.
    pub fn get_wet_area(&self) -> Result<f64> {
        let mut out_area = 0.0;
        check(unsafe { sys::cd_water_get_wet_area(self.as_ptr(), &mut out_area) })?;
        Ok(out_area)
    }

    /// The largest Courant number of a step of dt \[s\], in \[0, 1e30\], over directions and wet faces: (|u| + sqrt(g
    /// d)) dt / dx. Errors: CD_ERROR_VALUE.
    pub fn get_courant(&self, dt: f64) -> Result<f64> {
        let mut out_courant = 0.0;
        check(unsafe { sys::cd_water_get_courant(self.as_ptr(), dt, &mut out_courant) })?;
        Ok(out_courant)
    }

    /// The water at n places, at\[k\] = {x, y} in metres inside the scene: surface \[m\] and depth \[m\], bilinear
    /// between cell centres that are there, level beyond the outermost ones; normal of the surface (3 numbers, unit
    /// length, z up); velocity \[m/s\] (2 numbers), bilinear between faces. A dry place has the bed for its surface.
    /// Each output may be null. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE for a place outside; CD_ERROR_RANGE for more than
    /// fit in memory.
    pub fn sample(&self, at: &[f64], outside: Outside, out_surface: Option<&mut [f64]>, out_depth: Option<&mut [f64]>,
        out_normal: Option<&mut [f64]>, out_velocity: Option<&mut [f64]>) -> Result<()> {
        let n = count_of(at.len(), 2, "cd_water_sample", "at")?;
        same(out_surface.as_deref().map(<[_]>::len), n.checked_mul(1), "cd_water_sample", "out_surface")?;
        same(out_depth.as_deref().map(<[_]>::len), n.checked_mul(1), "cd_water_sample", "out_depth")?;
        same(out_normal.as_deref().map(<[_]>::len), n.checked_mul(3), "cd_water_sample", "out_normal")?;
        same(out_velocity.as_deref().map(<[_]>::len), n.checked_mul(2), "cd_water_sample", "out_velocity")?;
        check(unsafe { sys::cd_water_sample(self.as_ptr(), at.as_ptr(), n, outside as i32,
            out_surface.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr), out_depth.map_or(std::ptr::null_mut(),
            <[_]>::as_mut_ptr), out_normal.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr),
            out_velocity.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr)) })
    }

    /// Bytes the water holds from its allocator.
    pub fn get_memory(&self) -> Result<usize> {
        let mut out_bytes = 0;
        check(unsafe { sys::cd_water_get_memory(self.as_ptr(), &mut out_bytes) })?;
        Ok(out_bytes)
    }

    /// A 64-bit hash of everything cd_water_save would write. Equal on every machine, compiler and vector width.
    pub fn hash(&self) -> Result<u64> {
        let mut out_hash = 0;
        check(unsafe { sys::cd_water_hash(self.as_ptr(), &mut out_hash) })?;
        Ok(out_hash)
    }

    /// Writes a vertex for every cell, cell (i, j) as number j nx + i, into the caller's buffer: vertex k at byte k \*
    /// stride, its position, the cell's centre on the surface, as 3 floats at position_offset; its unit normal as 3
    /// floats at normal_offset; its depth as 1 float at depth_offset, 0 where it is dry and -1 where the cell is
    /// absent, for a shader to fade out shores. normal_offset or depth_offset SIZE_MAX: none. Bytes between are left
    /// alone; any offset and stride will do that keeps them apart. Errors: CD_ERROR_RANGE if size is less than cells \*
    /// stride, or an offset and its bytes reach past stride, or two overlap.
    pub fn write_vertices(&self, buffer: &mut [u8], stride: usize, position_offset: usize, normal_offset: usize,
        depth_offset: usize) -> Result<()> {
        let size = buffer.len();
        check(unsafe { sys::cd_water_write_vertices(self.as_ptr(), buffer.as_mut_ptr().cast(), size, stride,
            position_offset, normal_offset, depth_offset) })
    }

    /// How many indices cd_water_write_indices writes now: 6 per square of four neighbouring cells that are there, 3
    /// per square of which three are. skip_dry 1: squares without a wet cell are left out, so that it changes with the
    /// water. Errors: CD_ERROR_VALUE for a skip_dry neither 0 nor 1.
    pub fn get_index_count(&self, skip_dry: bool) -> Result<usize> {
        let mut out_count = 0;
        check(unsafe { sys::cd_water_get_index_count(self.as_ptr(), i32::from(skip_dry), &mut out_count) })?;
        Ok(out_count)
    }

    /// Writes the triangles as vertex numbers of index_size 2 or 4 bytes (unsigned, the machine's byte order), counter-
    /// clockwise seen from above. `size` is that of the buffer in bytes. 65535 with 2 bytes and 2^32 - 1 with 4 are
    /// never written. Errors: CD_ERROR_VALUE for another index_size, or skip_dry neither 0 nor 1; CD_ERROR_RANGE if
    /// size is too small; CD_ERROR_UNSUPPORTED for more than 65535 or 2^32 - 1 cells.
    pub fn write_indices(&self, skip_dry: bool, buffer: &mut [u8], index_size: usize) -> Result<()> {
        let size = buffer.len();
        check(unsafe { sys::cd_water_write_indices(self.as_ptr(), i32::from(skip_dry), buffer.as_mut_ptr().cast(),
            size, index_size) })
    }

    /// The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but the callbacks.
    /// Little-endian on every machine, versioned, with a checksum. save needs size \>= cd_water_save_size and tells
    /// what it wrote. load needs a water of as many cells and the same precision, takes the cells' size over, and
    /// switches fields on and off as they were. Bytes that are damaged, cut short, of a later version or another kind
    /// are refused. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn save_size(&self) -> Result<usize> {
        let mut out_size = 0;
        check(unsafe { sys::cd_water_save_size(self.as_ptr(), &mut out_size) })?;
        Ok(out_size)
    }

    /// The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but the callbacks.
    /// Little-endian on every machine, versioned, with a checksum. save needs size \>= cd_water_save_size and tells
    /// what it wrote. load needs a water of as many cells and the same precision, takes the cells' size over, and
    /// switches fields on and off as they were. Bytes that are damaged, cut short, of a later version or another kind
    /// are refused. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn save_into(&self, buffer: &mut [u8]) -> Result<usize> {
        let size = buffer.len();
        let mut out_written = 0;
        check(unsafe { sys::cd_water_save(self.as_ptr(), buffer.as_mut_ptr().cast(), size, &mut out_written) })?;
        Ok(out_written)
    }

    /// The same into a new vector.
    pub fn save(&self) -> Result<Vec<u8>> {
        let mut bytes = vec![0; self.save_size()?];
        let written = self.save_into(&mut bytes)?;
        bytes.truncate(written);
        Ok(bytes)
    }

    /// The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but the callbacks.
    /// Little-endian on every machine, versioned, with a checksum. save needs size \>= cd_water_save_size and tells
    /// what it wrote. load needs a water of as many cells and the same precision, takes the cells' size over, and
    /// switches fields on and off as they were. Bytes that are damaged, cut short, of a later version or another kind
    /// are refused. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn load(&mut self, bytes: &[u8]) -> Result<()> {
        let size = bytes.len();
        check(unsafe { sys::cd_water_load(self.as_ptr(), bytes.as_ptr().cast(), size) })
    }

    /// Makes `water` what `source` is, as save and load would, without the bytes: the two must agree in cells and
    /// precision. Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH, CD_ERROR_MEMORY.
    pub fn copy_state(&mut self, source: &Water) -> Result<()> {
        check(unsafe { sys::cd_water_copy_state(self.as_ptr(), source.as_ptr()) })
    }

    /// Depths, velocities, time, steps and account back to 0, hulls to where new ones lie, at rest. Bed, parameters and
    /// the other fields stay, and what hulls are. What is at sides begins again with time: a level or discharge that
    /// changes is what it was at time 0, or by its rate would have been if it was set later; then set it anew.
    pub fn reset(&mut self) -> Result<()> {
        check(unsafe { sys::cd_water_reset(self.as_ptr()) })
    }
}
