//! The C functions as they are: see the headers, include/contdyn/\*.h.
//! Made by generate.py from ../api.json: do not edit.
use std::os::raw::{c_char, c_void};

pub const CD_VERSION_MAJOR: u32 = 0;
pub const CD_VERSION_MINOR: u32 = 2;
pub const CD_VERSION_PATCH: u32 = 0;

pub type cd_status = i32;
pub const CD_OK: cd_status = 0;
pub const CD_ERROR_NULL: cd_status = 1;
pub const CD_ERROR_HANDLE: cd_status = 2;
pub const CD_ERROR_VALUE: cd_status = 3;
pub const CD_ERROR_ENUM: cd_status = 4;
pub const CD_ERROR_RANGE: cd_status = 5;
pub const CD_ERROR_SIZE: cd_status = 6;
pub const CD_ERROR_MEMORY: cd_status = 7;
pub const CD_ERROR_DISABLED: cd_status = 8;
pub const CD_ERROR_UNSUPPORTED: cd_status = 9;
pub const CD_ERROR_DIVERGED: cd_status = 10;
pub const CD_ERROR_FORMAT: cd_status = 11;
pub const CD_ERROR_MISMATCH: cd_status = 12;
pub const CD_ERROR_TOLERANCE: cd_status = 13;
pub const CD_ERROR_CALLBACK: cd_status = 14;

pub type cd_precision = i32;
pub const CD_FLOAT32: cd_precision = 0;
pub const CD_FLOAT64: cd_precision = 1;

pub type cd_method = i32;
pub const CD_METHOD_IMPLICIT: cd_method = 0;
pub const CD_METHOD_FORWARD_EULER: cd_method = 1;
pub const CD_METHOD_SYMPLECTIC_EULER: cd_method = 2;
pub const CD_METHOD_STIFF_SECOND: cd_method = 3;

pub type cd_solver = i32;
pub const CD_SOLVER_ALTERNATING: cd_solver = 0;
pub const CD_SOLVER_COUPLED: cd_solver = 1;
pub const CD_SOLVER_AUTO: cd_solver = 2;

pub type cd_mass_rule = i32;
pub const CD_MASS_EQUAL: cd_mass_rule = 0;
pub const CD_MASS_HALF_ENDS: cd_mass_rule = 1;

pub type cd_kernels = i32;
pub const CD_KERNELS_PLAIN: cd_kernels = 0;
pub const CD_KERNELS_AVX2: cd_kernels = 1;
pub const CD_KERNELS_AVX512: cd_kernels = 2;

pub type cd_node = i32;
pub const CD_NODE_FREE: cd_node = 0;
pub const CD_NODE_PINNED: cd_node = 1;
pub const CD_NODE_DRIVEN: cd_node = 2;
pub const CD_NODE_MATCHED: cd_node = 3;
pub const CD_NODE_POSED: cd_node = 4;

pub type cd_shape = i32;
pub const CD_SHAPE_NONE: cd_shape = 0;
pub const CD_SHAPE_PLANE: cd_shape = 1;
pub const CD_SHAPE_CAPSULE: cd_shape = 2;
pub const CD_SHAPE_BED: cd_shape = 3;
pub const CD_SHAPE_CALLBACK: cd_shape = 4;

pub type cd_outside = i32;
pub const CD_OUTSIDE_REFUSED: cd_outside = 0;
pub const CD_OUTSIDE_NEAREST: cd_outside = 1;

pub type cd_field = i32;
pub const CD_POSITION: cd_field = 0;
pub const CD_VELOCITY: cd_field = 1;
pub const CD_FORCE: cd_field = 2;
pub const CD_MASS: cd_field = 3;
pub const CD_STIFFNESS: cd_field = 4;
pub const CD_BEND: cd_field = 5;
pub const CD_PIN: cd_field = 6;
pub const CD_TARGET: cd_field = 7;
pub const CD_STIFFNESS_U: cd_field = 8;
pub const CD_STIFFNESS_V: cd_field = 9;
pub const CD_MASK: cd_field = 10;
pub const CD_DEPTH: cd_field = 11;
pub const CD_BED: cd_field = 12;
pub const CD_SURFACE: cd_field = 13;
pub const CD_VELOCITY_X: cd_field = 14;
pub const CD_VELOCITY_Y: cd_field = 15;
pub const CD_SOURCE: cd_field = 16;
pub const CD_PRESSURE: cd_field = 17;
pub const CD_FORCE_X: cd_field = 18;
pub const CD_FORCE_Y: cd_field = 19;
pub const CD_WALL_X: cd_field = 20;
pub const CD_WALL_Y: cd_field = 21;
pub const CD_REST_LENGTH: cd_field = 22;
pub const CD_TENSION: cd_field = 23;
pub const CD_WIND: cd_field = 24;
pub const CD_STRENGTH: cd_field = 25;
pub const CD_STRAIN: cd_field = 26;
pub const CD_REST_LENGTH_U: cd_field = 27;
pub const CD_REST_LENGTH_V: cd_field = 28;
pub const CD_TENSION_U: cd_field = 29;
pub const CD_TENSION_V: cd_field = 30;
pub const CD_STRAIN_U: cd_field = 31;
pub const CD_STRAIN_V: cd_field = 32;
pub const CD_BREAKING_STRAIN_U: cd_field = 33;
pub const CD_BREAKING_STRAIN_V: cd_field = 34;
pub const CD_REST_ANGLE: cd_field = 35;

pub type cd_kind = i32;
pub const CD_KIND_CHAIN: cd_kind = 1;
pub const CD_KIND_MEMBRANE: cd_kind = 2;
pub const CD_KIND_WATER: cd_kind = 3;

pub type cd_end = i32;
pub const CD_END_FIRST: cd_end = 0;
pub const CD_END_LAST: cd_end = 1;

pub type cd_edge = i32;
pub const CD_EDGE_U_FIRST: cd_edge = 0;
pub const CD_EDGE_U_LAST: cd_edge = 1;
pub const CD_EDGE_V_FIRST: cd_edge = 2;
pub const CD_EDGE_V_LAST: cd_edge = 3;

pub type cd_side = i32;
pub const CD_SIDE_X_FIRST: cd_side = 0;
pub const CD_SIDE_X_LAST: cd_side = 1;
pub const CD_SIDE_Y_FIRST: cd_side = 2;
pub const CD_SIDE_Y_LAST: cd_side = 3;

pub type cd_border = i32;
pub const CD_BORDER_WALL: cd_border = 0;
pub const CD_BORDER_OPEN: cd_border = 1;
pub const CD_BORDER_INFLOW: cd_border = 2;
pub const CD_BORDER_PERIODIC: cd_border = 3;
pub const CD_BORDER_LEVEL: cd_border = 4;

pub type cd_momentum = i32;
pub const CD_MOMENTUM_LINEAR: cd_momentum = 0;
pub const CD_MOMENTUM_ADVECTED: cd_momentum = 1;

pub type cd_bed_rule = i32;
pub const CD_BED_LIFTS_WATER: cd_bed_rule = 0;
pub const CD_BED_KEEPS_SURFACE: cd_bed_rule = 1;

#[repr(C)]
pub struct cd_chain {
    _private: [u8; 0],
}

#[repr(C)]
pub struct cd_membrane {
    _private: [u8; 0],
}

#[repr(C)]
pub struct cd_water {
    _private: [u8; 0],
}

/// Memory from the caller. allocate returns `size` bytes aligned to `alignment` (a power of two, at most 64), or
/// null; release gets back what allocate gave, with the same size and alignment. Both are called only from inside a
/// call on the object, on the caller's thread, never from a step, a read or a write. Copied at create.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct cd_allocator {
    pub user: *mut c_void,
    pub allocate: Option<unsafe extern "C" fn(user: *mut c_void, size: usize, alignment: usize) -> *mut c_void>,
    pub release: Option<unsafe extern "C" fn(user: *mut c_void, pointer: *mut c_void, size: usize, alignment: usize)>,
}

/// Parallel work from the caller. run calls task(context, i) once for every i in \[0, count), in any order, on any
/// threads, and returns when all are done. Results do not depend on it, bit for bit, as long as they are finite.
/// Copied when it is set.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct cd_parallel {
    pub user: *mut c_void,
    pub run: Option<unsafe extern "C" fn(user: *mut c_void, count: usize,
        task: Option<unsafe extern "C" fn(context: *mut c_void, index: usize)>, context: *mut c_void)>,
}

/// A shape from the caller, of a collider of ropes and cloth. distance is given `count` positions, each of
/// `components` numbers and relative to the collider's origin, and the time \[s\]. To out_distances\[i\] it writes
/// how far outside of the shape each is \[m\], less than 0 inside, at most 1e60 in size; to
/// out_normals\[i\]\[component\] the unit vector along which that distance grows fastest, of a length within 1e-3
/// of 1. It is called from steps, from any thread of cd_parallel and from several at once. The same position must
/// get the same answer at the same time, whatever others are asked with it, and it may call no function on the
/// object. A shape that moves as a whole should do so by the collider's velocity: one that changes with time by
/// itself is met where it was when the step began. Copied when it is set.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct cd_distance {
    pub user: *mut c_void,
    pub distance: Option<unsafe extern "C" fn(user: *mut c_void, time: f64, count: usize, components: usize,
        positions: *const f64, out_distances: *mut f64, out_normals: *mut f64)>,
}

extern "C" {
    pub fn cd_status_name(status: cd_status) -> *const c_char;
    pub fn cd_error_message() -> *const c_char;
    pub fn cd_saved_shape(bytes: *const c_void, size: usize, out_kind: *mut cd_kind, out_first: *mut usize,
        out_second: *mut usize, out_components: *mut usize, out_precision: *mut cd_precision) -> cd_status;
    pub fn cd_runnable_kernels() -> u32;
    pub fn cd_kernels_name(kernels: cd_kernels) -> *const c_char;
    pub fn cd_version() -> u32;
    pub fn cd_version_string() -> *const c_char;
    pub fn cd_build_info() -> *const c_char;
    pub fn cd_chain_create(strands: usize, springs: usize, components: usize, precision: cd_precision,
        allocator: *const cd_allocator, out_chain: *mut *mut cd_chain) -> cd_status;
    pub fn cd_chain_destroy(chain: *mut cd_chain);
    pub fn cd_chain_get_shape(chain: *const cd_chain, out_strands: *mut usize, out_springs: *mut usize,
        out_components: *mut usize, out_precision: *mut cd_precision) -> cd_status;
    pub fn cd_chain_set_method(chain: *mut cd_chain, method: cd_method) -> cd_status;
    pub fn cd_chain_get_method(chain: *const cd_chain, out_method: *mut cd_method) -> cd_status;
    pub fn cd_chain_set_lambda(chain: *mut cd_chain, lambda: f64) -> cd_status;
    pub fn cd_chain_get_lambda(chain: *const cd_chain, out_lambda: *mut f64) -> cd_status;
    pub fn cd_chain_set_parallel(chain: *mut cd_chain, parallel: *const cd_parallel) -> cd_status;
    pub fn cd_chain_set_kernels(chain: *mut cd_chain, kernels: cd_kernels) -> cd_status;
    pub fn cd_chain_get_kernels(chain: *const cd_chain, out_kernels: *mut cd_kernels) -> cd_status;
    pub fn cd_chain_set_mass(chain: *mut cd_chain, mass: f64) -> cd_status;
    pub fn cd_chain_get_mass(chain: *const cd_chain, out_mass: *mut f64) -> cd_status;
    pub fn cd_chain_set_mass_rule(chain: *mut cd_chain, rule: cd_mass_rule) -> cd_status;
    pub fn cd_chain_get_mass_rule(chain: *const cd_chain, out_rule: *mut cd_mass_rule) -> cd_status;
    pub fn cd_chain_set_stiffness(chain: *mut cd_chain, stiffness: f64) -> cd_status;
    pub fn cd_chain_get_stiffness(chain: *const cd_chain, out_stiffness: *mut f64) -> cd_status;
    pub fn cd_chain_set_bend(chain: *mut cd_chain, bend: f64) -> cd_status;
    pub fn cd_chain_get_bend(chain: *const cd_chain, out_bend: *mut f64) -> cd_status;
    pub fn cd_chain_set_drag(chain: *mut cd_chain, drag: f64) -> cd_status;
    pub fn cd_chain_get_drag(chain: *const cd_chain, out_drag: *mut f64) -> cd_status;
    pub fn cd_chain_set_stiffness_damping(chain: *mut cd_chain, seconds: f64) -> cd_status;
    pub fn cd_chain_get_stiffness_damping(chain: *const cd_chain, out_seconds: *mut f64) -> cd_status;
    pub fn cd_chain_set_gravity(chain: *mut cd_chain, gravity: *const f64, count: usize) -> cd_status;
    pub fn cd_chain_get_gravity(chain: *const cd_chain, out_gravity: *mut f64, count: usize) -> cd_status;
    pub fn cd_chain_set_end(chain: *mut cd_chain, end: cd_end, kind: cd_node) -> cd_status;
    pub fn cd_chain_get_end(chain: *const cd_chain, end: cd_end, out_kind: *mut cd_node) -> cd_status;
    pub fn cd_chain_set_ring(chain: *mut cd_chain, ring: i32) -> cd_status;
    pub fn cd_chain_get_ring(chain: *const cd_chain, out_ring: *mut i32) -> cd_status;
    pub fn cd_chain_set_sleep(chain: *mut cd_chain, speed: f64, seconds: f64) -> cd_status;
    pub fn cd_chain_get_sleep(chain: *const cd_chain, out_speed: *mut f64, out_seconds: *mut f64) -> cd_status;
    pub fn cd_chain_get_awake(chain: *const cd_chain, out_nodes: *mut usize) -> cd_status;
    pub fn cd_chain_set_rest_length(chain: *mut cd_chain, length: f64) -> cd_status;
    pub fn cd_chain_get_rest_length(chain: *const cd_chain, out_length: *mut f64) -> cd_status;
    pub fn cd_chain_set_rest_angle(chain: *mut cd_chain, angle: f64) -> cd_status;
    pub fn cd_chain_get_rest_angle(chain: *const cd_chain, out_angle: *mut f64) -> cd_status;
    pub fn cd_chain_set_push(chain: *mut cd_chain, push: i32) -> cd_status;
    pub fn cd_chain_get_push(chain: *const cd_chain, out_push: *mut i32) -> cd_status;
    pub fn cd_chain_set_strength(chain: *mut cd_chain, strength: f64) -> cd_status;
    pub fn cd_chain_get_strength(chain: *const cd_chain, out_strength: *mut f64) -> cd_status;
    pub fn cd_chain_get_broken(chain: *const cd_chain, out_springs: *mut usize) -> cd_status;
    pub fn cd_chain_get_reaction(chain: *const cd_chain, strand: usize, node: usize, out_force: *mut f64,
        count: usize) -> cd_status;
    pub fn cd_chain_set_air(chain: *mut cd_chain, along: f64, across: f64) -> cd_status;
    pub fn cd_chain_get_air(chain: *const cd_chain, out_along: *mut f64, out_across: *mut f64) -> cd_status;
    pub fn cd_chain_set_wind(chain: *mut cd_chain, velocity: *const f64, count: usize) -> cd_status;
    pub fn cd_chain_get_wind(chain: *const cd_chain, out_velocity: *mut f64, count: usize) -> cd_status;
    pub fn cd_chain_set_tolerance(chain: *mut cd_chain, tolerance: f64, most_iterations: usize) -> cd_status;
    pub fn cd_chain_get_tolerance(chain: *const cd_chain, out_tolerance: *mut f64,
        out_most_iterations: *mut usize) -> cd_status;
    pub fn cd_chain_get_convergence(chain: *const cd_chain, out_iterations: *mut usize,
        out_residual: *mut f64) -> cd_status;
    pub fn cd_chain_set_colliders(chain: *mut cd_chain, count: usize) -> cd_status;
    pub fn cd_chain_get_colliders(chain: *const cd_chain, out_count: *mut usize) -> cd_status;
    pub fn cd_chain_set_plane(chain: *mut cd_chain, index: usize, point: *const f64, normal: *const f64, count: usize,
        friction: f64) -> cd_status;
    pub fn cd_chain_set_capsule(chain: *mut cd_chain, index: usize, first: *const f64, last: *const f64, count: usize,
        radius: f64, friction: f64) -> cd_status;
    pub fn cd_chain_set_bed(chain: *mut cd_chain, index: usize, origin: *const f64, count: usize, columns: usize,
        rows: usize, column_spacing: f64, row_spacing: f64, heights: *const f64, height_count: usize,
        friction: f64) -> cd_status;
    pub fn cd_chain_get_bed(chain: *const cd_chain, index: usize, out_columns: *mut usize, out_rows: *mut usize,
        out_heights: *mut f64, height_count: usize) -> cd_status;
    pub fn cd_chain_set_callback(chain: *mut cd_chain, index: usize, distance: *const cd_distance, origin: *const f64,
        count: usize, friction: f64) -> cd_status;
    pub fn cd_chain_remove_collider(chain: *mut cd_chain, index: usize) -> cd_status;
    pub fn cd_chain_set_collider_velocity(chain: *mut cd_chain, index: usize, velocity: *const f64,
        count: usize) -> cd_status;
    pub fn cd_chain_get_collider(chain: *const cd_chain, index: usize, out_shape: *mut cd_shape, out_first: *mut f64,
        out_second: *mut f64, out_velocity: *mut f64, count: usize, out_radius: *mut f64,
        out_friction: *mut f64) -> cd_status;
    pub fn cd_chain_set_loads(chain: *mut cd_chain, loads: i32) -> cd_status;
    pub fn cd_chain_get_loads(chain: *const cd_chain, out_loads: *mut i32) -> cd_status;
    pub fn cd_chain_get_collider_load(chain: *const cd_chain, index: usize, out_load: *mut f64,
        count: usize) -> cd_status;
    pub fn cd_chain_set_thickness(chain: *mut cd_chain, radius: f64) -> cd_status;
    pub fn cd_chain_get_thickness(chain: *const cd_chain, out_radius: *mut f64) -> cd_status;
    pub fn cd_chain_enable_field(chain: *mut cd_chain, field: cd_field) -> cd_status;
    pub fn cd_chain_disable_field(chain: *mut cd_chain, field: cd_field) -> cd_status;
    pub fn cd_chain_write_f32(chain: *mut cd_chain, field: cd_field, first_strand: usize, strands: usize, first: usize,
        n: usize, values: *const f32, count: usize) -> cd_status;
    pub fn cd_chain_write_f64(chain: *mut cd_chain, field: cd_field, first_strand: usize, strands: usize, first: usize,
        n: usize, values: *const f64, count: usize) -> cd_status;
    pub fn cd_chain_read_f32(chain: *const cd_chain, field: cd_field, first_strand: usize, strands: usize,
        first: usize, n: usize, out_values: *mut f32, count: usize) -> cd_status;
    pub fn cd_chain_read_f64(chain: *const cd_chain, field: cd_field, first_strand: usize, strands: usize,
        first: usize, n: usize, out_values: *mut f64, count: usize) -> cd_status;
    pub fn cd_chain_view(chain: *const cd_chain, field: cd_field, out_data: *mut *const c_void,
        out_strand_stride: *mut usize, out_node_stride: *mut usize, out_component_stride: *mut usize) -> cd_status;
    pub fn cd_chain_impulse(chain: *mut cd_chain, strand: usize, node: usize, impulse: *const f64,
        count: usize) -> cd_status;
    pub fn cd_chain_teleport(chain: *mut cd_chain, strand: usize, rotation: *const f64, offset: *const f64,
        count: usize) -> cd_status;
    pub fn cd_chain_attach(chain: *mut cd_chain, strand: usize, node: usize, stiffness: f64, damping: f64,
        target: *const f64, count: usize) -> cd_status;
    pub fn cd_chain_detach(chain: *mut cd_chain, strand: usize, node: usize) -> cd_status;
    pub fn cd_chain_get_attachment(chain: *const cd_chain, strand: usize, node: usize, out_stiffness: *mut f64,
        out_damping: *mut f64) -> cd_status;
    pub fn cd_chain_cut(chain: *mut cd_chain, strand: usize, spring: usize) -> cd_status;
    pub fn cd_chain_weld(chain: *mut cd_chain, strand: usize, spring: usize) -> cd_status;
    pub fn cd_chain_step(chain: *mut cd_chain, dt: f64, count: usize) -> cd_status;
    pub fn cd_chain_stable_dt(chain: *const cd_chain, out_dt: *mut f64) -> cd_status;
    pub fn cd_chain_get_time(chain: *const cd_chain, out_time: *mut f64) -> cd_status;
    pub fn cd_chain_get_steps(chain: *const cd_chain, out_steps: *mut u64) -> cd_status;
    pub fn cd_chain_get_factorizations(chain: *const cd_chain, out_count: *mut u64) -> cd_status;
    pub fn cd_chain_get_energy(chain: *const cd_chain, out_kinetic: *mut f64, out_elastic: *mut f64,
        out_gravity: *mut f64) -> cd_status;
    pub fn cd_chain_get_momentum(chain: *const cd_chain, out_momentum: *mut f64, count: usize) -> cd_status;
    pub fn cd_chain_sample(chain: *const cd_chain, strand: usize, at: *const f64, n: usize, outside: cd_outside,
        out_positions: *mut f64, out_count: usize) -> cd_status;
    pub fn cd_chain_get_memory(chain: *const cd_chain, out_bytes: *mut usize) -> cd_status;
    pub fn cd_chain_hash(chain: *const cd_chain, out_hash: *mut u64) -> cd_status;
    pub fn cd_chain_save_size(chain: *const cd_chain, out_size: *mut usize) -> cd_status;
    pub fn cd_chain_save(chain: *const cd_chain, buffer: *mut c_void, size: usize,
        out_written: *mut usize) -> cd_status;
    pub fn cd_chain_load(chain: *mut cd_chain, bytes: *const c_void, size: usize) -> cd_status;
    pub fn cd_chain_copy_state(chain: *mut cd_chain, source: *const cd_chain) -> cd_status;
    pub fn cd_chain_reset(chain: *mut cd_chain) -> cd_status;
    pub fn cd_membrane_create(nu: usize, nv: usize, components: usize, precision: cd_precision,
        allocator: *const cd_allocator, out_membrane: *mut *mut cd_membrane) -> cd_status;
    pub fn cd_membrane_destroy(membrane: *mut cd_membrane);
    pub fn cd_membrane_get_shape(membrane: *const cd_membrane, out_nu: *mut usize, out_nv: *mut usize,
        out_components: *mut usize, out_precision: *mut cd_precision) -> cd_status;
    pub fn cd_membrane_set_method(membrane: *mut cd_membrane, method: cd_method) -> cd_status;
    pub fn cd_membrane_get_method(membrane: *const cd_membrane, out_method: *mut cd_method) -> cd_status;
    pub fn cd_membrane_set_lambda(membrane: *mut cd_membrane, lambda: f64) -> cd_status;
    pub fn cd_membrane_get_lambda(membrane: *const cd_membrane, out_lambda: *mut f64) -> cd_status;
    pub fn cd_membrane_set_solver(membrane: *mut cd_membrane, solver: cd_solver) -> cd_status;
    pub fn cd_membrane_get_solver(membrane: *const cd_membrane, out_solver: *mut cd_solver) -> cd_status;
    pub fn cd_membrane_get_solver_taken(membrane: *const cd_membrane, out_solver: *mut cd_solver) -> cd_status;
    pub fn cd_membrane_set_tolerance(membrane: *mut cd_membrane, tolerance: f64, most_iterations: usize) -> cd_status;
    pub fn cd_membrane_get_tolerance(membrane: *const cd_membrane, out_tolerance: *mut f64,
        out_most_iterations: *mut usize) -> cd_status;
    pub fn cd_membrane_get_convergence(membrane: *const cd_membrane, out_iterations: *mut usize,
        out_residual: *mut f64) -> cd_status;
    pub fn cd_membrane_set_parallel(membrane: *mut cd_membrane, parallel: *const cd_parallel) -> cd_status;
    pub fn cd_membrane_set_kernels(membrane: *mut cd_membrane, kernels: cd_kernels) -> cd_status;
    pub fn cd_membrane_get_kernels(membrane: *const cd_membrane, out_kernels: *mut cd_kernels) -> cd_status;
    pub fn cd_membrane_set_mass(membrane: *mut cd_membrane, mass: f64) -> cd_status;
    pub fn cd_membrane_get_mass(membrane: *const cd_membrane, out_mass: *mut f64) -> cd_status;
    pub fn cd_membrane_set_mass_rule(membrane: *mut cd_membrane, rule: cd_mass_rule) -> cd_status;
    pub fn cd_membrane_get_mass_rule(membrane: *const cd_membrane, out_rule: *mut cd_mass_rule) -> cd_status;
    pub fn cd_membrane_set_stiffness(membrane: *mut cd_membrane, along_u: f64, along_v: f64) -> cd_status;
    pub fn cd_membrane_get_stiffness(membrane: *const cd_membrane, out_along_u: *mut f64,
        out_along_v: *mut f64) -> cd_status;
    pub fn cd_membrane_set_bend(membrane: *mut cd_membrane, bend: f64) -> cd_status;
    pub fn cd_membrane_get_bend(membrane: *const cd_membrane, out_bend: *mut f64) -> cd_status;
    pub fn cd_membrane_set_drag(membrane: *mut cd_membrane, drag: f64) -> cd_status;
    pub fn cd_membrane_get_drag(membrane: *const cd_membrane, out_drag: *mut f64) -> cd_status;
    pub fn cd_membrane_set_stiffness_damping(membrane: *mut cd_membrane, seconds: f64) -> cd_status;
    pub fn cd_membrane_get_stiffness_damping(membrane: *const cd_membrane, out_seconds: *mut f64) -> cd_status;
    pub fn cd_membrane_set_gravity(membrane: *mut cd_membrane, gravity: *const f64, count: usize) -> cd_status;
    pub fn cd_membrane_get_gravity(membrane: *const cd_membrane, out_gravity: *mut f64, count: usize) -> cd_status;
    pub fn cd_membrane_set_pressure(membrane: *mut cd_membrane, pressure: f64) -> cd_status;
    pub fn cd_membrane_get_pressure(membrane: *const cd_membrane, out_pressure: *mut f64) -> cd_status;
    pub fn cd_membrane_set_edge(membrane: *mut cd_membrane, edge: cd_edge, kind: cd_node) -> cd_status;
    pub fn cd_membrane_get_edge(membrane: *const cd_membrane, edge: cd_edge, out_kind: *mut cd_node) -> cd_status;
    pub fn cd_membrane_set_ring(membrane: *mut cd_membrane, along_u: i32, along_v: i32) -> cd_status;
    pub fn cd_membrane_get_ring(membrane: *const cd_membrane, out_along_u: *mut i32,
        out_along_v: *mut i32) -> cd_status;
    pub fn cd_membrane_set_sleep(membrane: *mut cd_membrane, speed: f64, seconds: f64) -> cd_status;
    pub fn cd_membrane_get_sleep(membrane: *const cd_membrane, out_speed: *mut f64, out_seconds: *mut f64) -> cd_status;
    pub fn cd_membrane_get_awake(membrane: *const cd_membrane, out_nodes: *mut usize) -> cd_status;
    pub fn cd_membrane_set_rest_length(membrane: *mut cd_membrane, along_u: f64, along_v: f64) -> cd_status;
    pub fn cd_membrane_get_rest_length(membrane: *const cd_membrane, out_along_u: *mut f64,
        out_along_v: *mut f64) -> cd_status;
    pub fn cd_membrane_set_shear(membrane: *mut cd_membrane, stiffness: f64) -> cd_status;
    pub fn cd_membrane_get_shear(membrane: *const cd_membrane, out_stiffness: *mut f64) -> cd_status;
    pub fn cd_membrane_set_compression(membrane: *mut cd_membrane, rate: f64) -> cd_status;
    pub fn cd_membrane_get_compression(membrane: *const cd_membrane, out_rate: *mut f64) -> cd_status;
    pub fn cd_membrane_set_breaking_strain(membrane: *mut cd_membrane, strain: f64) -> cd_status;
    pub fn cd_membrane_get_breaking_strain(membrane: *const cd_membrane, out_strain: *mut f64) -> cd_status;
    pub fn cd_membrane_get_broken(membrane: *const cd_membrane, out_springs: *mut usize) -> cd_status;
    pub fn cd_membrane_set_effort(membrane: *mut cd_membrane, newton: usize, gradient: usize) -> cd_status;
    pub fn cd_membrane_get_effort(membrane: *const cd_membrane, out_newton: *mut usize,
        out_gradient: *mut usize) -> cd_status;
    pub fn cd_membrane_set_air(membrane: *mut cd_membrane, along: f64, across: f64) -> cd_status;
    pub fn cd_membrane_get_air(membrane: *const cd_membrane, out_along: *mut f64, out_across: *mut f64) -> cd_status;
    pub fn cd_membrane_set_wind(membrane: *mut cd_membrane, velocity: *const f64, count: usize) -> cd_status;
    pub fn cd_membrane_get_wind(membrane: *const cd_membrane, out_velocity: *mut f64, count: usize) -> cd_status;
    pub fn cd_membrane_set_colliders(membrane: *mut cd_membrane, count: usize) -> cd_status;
    pub fn cd_membrane_get_colliders(membrane: *const cd_membrane, out_count: *mut usize) -> cd_status;
    pub fn cd_membrane_set_plane(membrane: *mut cd_membrane, index: usize, point: *const f64, normal: *const f64,
        count: usize, friction: f64) -> cd_status;
    pub fn cd_membrane_set_capsule(membrane: *mut cd_membrane, index: usize, first: *const f64, last: *const f64,
        count: usize, radius: f64, friction: f64) -> cd_status;
    pub fn cd_membrane_set_bed(membrane: *mut cd_membrane, index: usize, origin: *const f64, count: usize,
        columns: usize, rows: usize, column_spacing: f64, row_spacing: f64, heights: *const f64, height_count: usize,
        friction: f64) -> cd_status;
    pub fn cd_membrane_get_bed(membrane: *const cd_membrane, index: usize, out_columns: *mut usize,
        out_rows: *mut usize, out_heights: *mut f64, height_count: usize) -> cd_status;
    pub fn cd_membrane_set_callback(membrane: *mut cd_membrane, index: usize, distance: *const cd_distance,
        origin: *const f64, count: usize, friction: f64) -> cd_status;
    pub fn cd_membrane_remove_collider(membrane: *mut cd_membrane, index: usize) -> cd_status;
    pub fn cd_membrane_set_collider_velocity(membrane: *mut cd_membrane, index: usize, velocity: *const f64,
        count: usize) -> cd_status;
    pub fn cd_membrane_get_collider(membrane: *const cd_membrane, index: usize, out_shape: *mut cd_shape,
        out_first: *mut f64, out_second: *mut f64, out_velocity: *mut f64, count: usize, out_radius: *mut f64,
        out_friction: *mut f64) -> cd_status;
    pub fn cd_membrane_set_loads(membrane: *mut cd_membrane, loads: i32) -> cd_status;
    pub fn cd_membrane_get_loads(membrane: *const cd_membrane, out_loads: *mut i32) -> cd_status;
    pub fn cd_membrane_get_collider_load(membrane: *const cd_membrane, index: usize, out_load: *mut f64,
        count: usize) -> cd_status;
    pub fn cd_membrane_set_thickness(membrane: *mut cd_membrane, distance: f64) -> cd_status;
    pub fn cd_membrane_get_thickness(membrane: *const cd_membrane, out_distance: *mut f64) -> cd_status;
    pub fn cd_membrane_enable_field(membrane: *mut cd_membrane, field: cd_field) -> cd_status;
    pub fn cd_membrane_disable_field(membrane: *mut cd_membrane, field: cd_field) -> cd_status;
    pub fn cd_membrane_write_f32(membrane: *mut cd_membrane, field: cd_field, first_u: usize, first_v: usize,
        n_u: usize, n_v: usize, values: *const f32, count: usize) -> cd_status;
    pub fn cd_membrane_write_f64(membrane: *mut cd_membrane, field: cd_field, first_u: usize, first_v: usize,
        n_u: usize, n_v: usize, values: *const f64, count: usize) -> cd_status;
    pub fn cd_membrane_read_f32(membrane: *const cd_membrane, field: cd_field, first_u: usize, first_v: usize,
        n_u: usize, n_v: usize, out_values: *mut f32, count: usize) -> cd_status;
    pub fn cd_membrane_read_f64(membrane: *const cd_membrane, field: cd_field, first_u: usize, first_v: usize,
        n_u: usize, n_v: usize, out_values: *mut f64, count: usize) -> cd_status;
    pub fn cd_membrane_view(membrane: *const cd_membrane, field: cd_field, out_data: *mut *const c_void,
        out_u_stride: *mut usize, out_v_stride: *mut usize, out_component_stride: *mut usize) -> cd_status;
    pub fn cd_membrane_impulse(membrane: *mut cd_membrane, u: f64, v: f64, radius: f64, impulse: *const f64,
        count: usize) -> cd_status;
    pub fn cd_membrane_teleport(membrane: *mut cd_membrane, rotation: *const f64, offset: *const f64,
        count: usize) -> cd_status;
    pub fn cd_membrane_attach(membrane: *mut cd_membrane, u: usize, v: usize, stiffness: f64, damping: f64,
        target: *const f64, count: usize) -> cd_status;
    pub fn cd_membrane_detach(membrane: *mut cd_membrane, u: usize, v: usize) -> cd_status;
    pub fn cd_membrane_get_attachment(membrane: *const cd_membrane, u: usize, v: usize, out_stiffness: *mut f64,
        out_damping: *mut f64) -> cd_status;
    pub fn cd_membrane_step(membrane: *mut cd_membrane, dt: f64, count: usize) -> cd_status;
    pub fn cd_membrane_stable_dt(membrane: *const cd_membrane, out_dt: *mut f64) -> cd_status;
    pub fn cd_membrane_get_time(membrane: *const cd_membrane, out_time: *mut f64) -> cd_status;
    pub fn cd_membrane_get_steps(membrane: *const cd_membrane, out_steps: *mut u64) -> cd_status;
    pub fn cd_membrane_get_factorizations(membrane: *const cd_membrane, out_count: *mut u64) -> cd_status;
    pub fn cd_membrane_get_energy(membrane: *const cd_membrane, out_kinetic: *mut f64, out_elastic: *mut f64,
        out_gravity: *mut f64) -> cd_status;
    pub fn cd_membrane_get_momentum(membrane: *const cd_membrane, out_momentum: *mut f64, count: usize) -> cd_status;
    pub fn cd_membrane_get_reaction(membrane: *const cd_membrane, u: usize, v: usize, out_force: *mut f64,
        count: usize) -> cd_status;
    pub fn cd_membrane_get_volume(membrane: *const cd_membrane, out_volume: *mut f64) -> cd_status;
    pub fn cd_membrane_sample(membrane: *const cd_membrane, at: *const f64, n: usize, outside: cd_outside,
        out_positions: *mut f64, out_count: usize) -> cd_status;
    pub fn cd_membrane_get_memory(membrane: *const cd_membrane, out_bytes: *mut usize) -> cd_status;
    pub fn cd_membrane_hash(membrane: *const cd_membrane, out_hash: *mut u64) -> cd_status;
    pub fn cd_membrane_write_vertices(membrane: *const cd_membrane, buffer: *mut c_void, size: usize, stride: usize,
        position_offset: usize, normal_offset: usize) -> cd_status;
    pub fn cd_membrane_get_index_count(membrane: *const cd_membrane, out_count: *mut usize) -> cd_status;
    pub fn cd_membrane_write_indices(membrane: *const cd_membrane, buffer: *mut c_void, size: usize,
        index_size: usize) -> cd_status;
    pub fn cd_membrane_save_size(membrane: *const cd_membrane, out_size: *mut usize) -> cd_status;
    pub fn cd_membrane_save(membrane: *const cd_membrane, buffer: *mut c_void, size: usize,
        out_written: *mut usize) -> cd_status;
    pub fn cd_membrane_load(membrane: *mut cd_membrane, bytes: *const c_void, size: usize) -> cd_status;
    pub fn cd_membrane_copy_state(membrane: *mut cd_membrane, source: *const cd_membrane) -> cd_status;
    pub fn cd_membrane_reset(membrane: *mut cd_membrane) -> cd_status;
    pub fn cd_water_create(nx: usize, ny: usize, dx: f64, dy: f64, precision: cd_precision,
        allocator: *const cd_allocator, out_water: *mut *mut cd_water) -> cd_status;
    pub fn cd_water_destroy(water: *mut cd_water);
    pub fn cd_water_get_shape(water: *const cd_water, out_nx: *mut usize, out_ny: *mut usize, out_dx: *mut f64,
        out_dy: *mut f64, out_precision: *mut cd_precision) -> cd_status;
    pub fn cd_water_set_method(water: *mut cd_water, method: cd_method) -> cd_status;
    pub fn cd_water_get_method(water: *const cd_water, out_method: *mut cd_method) -> cd_status;
    pub fn cd_water_set_lambda(water: *mut cd_water, lambda: f64) -> cd_status;
    pub fn cd_water_get_lambda(water: *const cd_water, out_lambda: *mut f64) -> cd_status;
    pub fn cd_water_set_momentum(water: *mut cd_water, momentum: cd_momentum) -> cd_status;
    pub fn cd_water_get_momentum(water: *const cd_water, out_momentum: *mut cd_momentum) -> cd_status;
    pub fn cd_water_set_first(water: *mut cd_water, along_y: i32) -> cd_status;
    pub fn cd_water_get_first(water: *const cd_water, out_along_y: *mut i32) -> cd_status;
    pub fn cd_water_set_parallel(water: *mut cd_water, parallel: *const cd_parallel) -> cd_status;
    pub fn cd_water_set_kernels(water: *mut cd_water, kernels: cd_kernels) -> cd_status;
    pub fn cd_water_get_kernels(water: *const cd_water, out_kernels: *mut cd_kernels) -> cd_status;
    pub fn cd_water_set_gravity(water: *mut cd_water, gravity: f64) -> cd_status;
    pub fn cd_water_get_gravity(water: *const cd_water, out_gravity: *mut f64) -> cd_status;
    pub fn cd_water_set_density(water: *mut cd_water, density: f64) -> cd_status;
    pub fn cd_water_get_density(water: *const cd_water, out_density: *mut f64) -> cd_status;
    pub fn cd_water_set_drag(water: *mut cd_water, drag: f64) -> cd_status;
    pub fn cd_water_get_drag(water: *const cd_water, out_drag: *mut f64) -> cd_status;
    pub fn cd_water_set_manning(water: *mut cd_water, manning: f64) -> cd_status;
    pub fn cd_water_get_manning(water: *const cd_water, out_manning: *mut f64) -> cd_status;
    pub fn cd_water_set_side(water: *mut cd_water, side: cd_side, kind: cd_border, value: f64, rate: f64) -> cd_status;
    pub fn cd_water_get_side(water: *const cd_water, side: cd_side, out_kind: *mut cd_border, out_value: *mut f64,
        out_rate: *mut f64) -> cd_status;
    pub fn cd_water_set_inflow_depth(water: *mut cd_water, side: cd_side, depth: f64) -> cd_status;
    pub fn cd_water_get_inflow_depth(water: *const cd_water, side: cd_side, out_depth: *mut f64) -> cd_status;
    pub fn cd_water_set_bed_rule(water: *mut cd_water, rule: cd_bed_rule) -> cd_status;
    pub fn cd_water_get_bed_rule(water: *const cd_water, out_rule: *mut cd_bed_rule) -> cd_status;
    pub fn cd_water_enable_field(water: *mut cd_water, field: cd_field) -> cd_status;
    pub fn cd_water_disable_field(water: *mut cd_water, field: cd_field) -> cd_status;
    pub fn cd_water_write_f32(water: *mut cd_water, field: cd_field, first_x: usize, first_y: usize, n_x: usize,
        n_y: usize, values: *const f32, count: usize) -> cd_status;
    pub fn cd_water_write_f64(water: *mut cd_water, field: cd_field, first_x: usize, first_y: usize, n_x: usize,
        n_y: usize, values: *const f64, count: usize) -> cd_status;
    pub fn cd_water_read_f32(water: *const cd_water, field: cd_field, first_x: usize, first_y: usize, n_x: usize,
        n_y: usize, out_values: *mut f32, count: usize) -> cd_status;
    pub fn cd_water_read_f64(water: *const cd_water, field: cd_field, first_x: usize, first_y: usize, n_x: usize,
        n_y: usize, out_values: *mut f64, count: usize) -> cd_status;
    pub fn cd_water_view(water: *const cd_water, field: cd_field, out_data: *mut *const c_void,
        out_x_stride: *mut usize, out_y_stride: *mut usize) -> cd_status;
    pub fn cd_water_add_volume(water: *mut cd_water, x: f64, y: f64, radius: f64, volume: f64,
        out_added: *mut f64) -> cd_status;
    pub fn cd_water_add_volume_rectangle(water: *mut cd_water, first_x: usize, first_y: usize, n_x: usize, n_y: usize,
        volume: f64, out_added: *mut f64) -> cd_status;
    pub fn cd_water_add_source(water: *mut cd_water, x: f64, y: f64, radius: f64, rate: f64) -> cd_status;
    pub fn cd_water_add_source_rectangle(water: *mut cd_water, first_x: usize, first_y: usize, n_x: usize, n_y: usize,
        rate: f64) -> cd_status;
    pub fn cd_water_splash(water: *mut cd_water, x: f64, y: f64, radius: f64, height: f64) -> cd_status;
    pub fn cd_water_impulse(water: *mut cd_water, x: f64, y: f64, radius: f64, impulse_x: f64,
        impulse_y: f64) -> cd_status;
    pub fn cd_water_set_hulls(water: *mut cd_water, count: usize, n_along: usize, n_across: usize) -> cd_status;
    pub fn cd_water_get_hulls(water: *const cd_water, out_count: *mut usize, out_n_along: *mut usize,
        out_n_across: *mut usize) -> cd_status;
    pub fn cd_water_set_hull(water: *mut cd_water, index: usize, mass: f64, length: f64, width: f64,
        heights: *const f64, count: usize) -> cd_status;
    pub fn cd_water_set_disc(water: *mut cd_water, index: usize, mass: f64, radius: f64) -> cd_status;
    pub fn cd_water_get_hull(water: *const cd_water, index: usize, out_mass: *mut f64, out_length: *mut f64,
        out_width: *mut f64, out_area: *mut f64, out_heights: *mut f64, count: usize) -> cd_status;
    pub fn cd_water_remove_hull(water: *mut cd_water, index: usize) -> cd_status;
    pub fn cd_water_launch_hull(water: *mut cd_water, index: usize, x: f64, y: f64, ahead_x: f64,
        ahead_y: f64) -> cd_status;
    pub fn cd_water_set_hull_pose(water: *mut cd_water, index: usize, pose: *const f64, count: usize) -> cd_status;
    pub fn cd_water_get_hull_pose(water: *const cd_water, index: usize, out_pose: *mut f64, count: usize) -> cd_status;
    pub fn cd_water_set_hull_velocity(water: *mut cd_water, index: usize, velocity: *const f64,
        count: usize) -> cd_status;
    pub fn cd_water_get_hull_velocity(water: *const cd_water, index: usize, out_velocity: *mut f64,
        count: usize) -> cd_status;
    pub fn cd_water_get_hull_floor(water: *const cd_water, index: usize, out_pose: *mut f64, count: usize) -> cd_status;
    pub fn cd_water_set_hull_force(water: *mut cd_water, index: usize, force: *const f64, count: usize) -> cd_status;
    pub fn cd_water_get_hull_force(water: *const cd_water, index: usize, out_force: *mut f64,
        count: usize) -> cd_status;
    pub fn cd_water_set_hull_drag(water: *mut cd_water, index: usize, along: f64, across: f64,
        friction: f64) -> cd_status;
    pub fn cd_water_get_hull_drag(water: *const cd_water, index: usize, out_along: *mut f64, out_across: *mut f64,
        out_friction: *mut f64) -> cd_status;
    pub fn cd_water_get_hull_load(water: *const cd_water, index: usize, out_load: *mut f64, count: usize) -> cd_status;
    pub fn cd_water_get_hull_energy(water: *const cd_water, out_kinetic: *mut f64,
        out_potential: *mut f64) -> cd_status;
    pub fn cd_water_sample_heads(water: *const cd_water, at: *const f64, n: usize, outside: cd_outside,
        out_heads: *mut f64) -> cd_status;
    pub fn cd_water_step(water: *mut cd_water, dt: f64, count: usize) -> cd_status;
    pub fn cd_water_stable_dt(water: *const cd_water, out_dt: *mut f64) -> cd_status;
    pub fn cd_water_get_time(water: *const cd_water, out_time: *mut f64) -> cd_status;
    pub fn cd_water_get_steps(water: *const cd_water, out_steps: *mut u64) -> cd_status;
    pub fn cd_water_get_factorizations(water: *const cd_water, out_count: *mut u64) -> cd_status;
    pub fn cd_water_get_limited(water: *const cd_water, out_cells: *mut u64, out_volume: *mut f64) -> cd_status;
    pub fn cd_water_set_sleep(water: *mut cd_water, height: f64) -> cd_status;
    pub fn cd_water_get_sleep(water: *const cd_water, out_height: *mut f64) -> cd_status;
    pub fn cd_water_get_awake(water: *const cd_water, out_cells: *mut usize) -> cd_status;
    pub fn cd_water_get_volume(water: *const cd_water, out_volume: *mut f64) -> cd_status;
    pub fn cd_water_get_account(water: *const cd_water, out_initial: *mut f64, out_in: *mut f64, out_out: *mut f64,
        out_error: *mut f64) -> cd_status;
    pub fn cd_water_restart_account(water: *mut cd_water) -> cd_status;
    pub fn cd_water_get_energy(water: *const cd_water, out_kinetic: *mut f64, out_potential: *mut f64) -> cd_status;
    pub fn cd_water_get_wet_area(water: *const cd_water, out_area: *mut f64) -> cd_status;
    pub fn cd_water_get_courant(water: *const cd_water, dt: f64, out_courant: *mut f64) -> cd_status;
    pub fn cd_water_sample(water: *const cd_water, at: *const f64, n: usize, outside: cd_outside,
        out_surface: *mut f64, out_depth: *mut f64, out_normal: *mut f64, out_velocity: *mut f64) -> cd_status;
    pub fn cd_water_get_memory(water: *const cd_water, out_bytes: *mut usize) -> cd_status;
    pub fn cd_water_hash(water: *const cd_water, out_hash: *mut u64) -> cd_status;
    pub fn cd_water_write_vertices(water: *const cd_water, buffer: *mut c_void, size: usize, stride: usize,
        position_offset: usize, normal_offset: usize, depth_offset: usize) -> cd_status;
    pub fn cd_water_get_index_count(water: *const cd_water, skip_dry: i32, out_count: *mut usize) -> cd_status;
    pub fn cd_water_write_indices(water: *const cd_water, skip_dry: i32, buffer: *mut c_void, size: usize,
        index_size: usize) -> cd_status;
    pub fn cd_water_save_size(water: *const cd_water, out_size: *mut usize) -> cd_status;
    pub fn cd_water_save(water: *const cd_water, buffer: *mut c_void, size: usize,
        out_written: *mut usize) -> cd_status;
    pub fn cd_water_load(water: *mut cd_water, bytes: *const c_void, size: usize) -> cd_status;
    pub fn cd_water_copy_state(water: *mut cd_water, source: *const cd_water) -> cd_status;
    pub fn cd_water_reset(water: *mut cd_water) -> cd_status;
}
