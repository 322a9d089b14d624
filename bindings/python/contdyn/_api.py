"""The C API as data. Made by generate.py from ../api.json: do not edit."""
from ctypes import CFUNCTYPE, POINTER, Structure
from ctypes import c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p
from enum import IntEnum
from typing import Any, Dict, NamedTuple, Tuple

VERSION = (0, 2, 0)


class Status(IntEnum):
    """What a call of the C API returns."""

    OK = 0
    #: a pointer that may not be null is null
    ERROR_NULL = 1
    #: the handle is of another kind of object
    ERROR_HANDLE = 2
    #: a number outside its valid range, or NaN or infinity where it has no meaning
    ERROR_VALUE = 3
    #: not one of the enumeration's values
    ERROR_ENUM = 4
    #: an index, a range or a buffer length that does not fit the object
    ERROR_RANGE = 5
    #: a size that cannot be represented in memory
    ERROR_SIZE = 6
    #: the allocator returned null
    ERROR_MEMORY = 7
    #: the field is not switched on: see enable_field
    ERROR_DISABLED = 8
    #: what this object cannot do, or what was left out of this build: see cd_build_info
    ERROR_UNSUPPORTED = 9
    #: the state left the finite range during a step, or has not come back to it
    ERROR_DIVERGED = 10
    #: the bytes to load are damaged, or of a later version or another kind
    ERROR_FORMAT = 11
    #: the two objects, or the object and the bytes, differ in shape or precision
    ERROR_MISMATCH = 12
    #: steps were made, but an iterative solve ended short of its tolerance
    ERROR_TOLERANCE = 13
    #: steps were made, but a callback gave numbers that it may not
    ERROR_CALLBACK = 14


class Precision(IntEnum):
    """What an object stores its state in; chosen when it is made. Steps compute in double precision whatever it is, but
    for those that an object's header names."""

    FLOAT32 = 0
    FLOAT64 = 1


class Method(IntEnum):
    """How a step advances the state by dt. Method.IMPLICIT is the default, with lambda = 1/2. Bounds hold, and energy
    is kept, to rounding: in a step a node's position may be wrong by some 1e-15 of the distance that its velocity
    covers in dt, in a ring or with bend also by 1e-15 of the distance that it would fall in dt, which shows where dt is
    longer than 1e12 times the time of the fastest swing."""

    #: Kass 1997, eq. 21: lambda = 1/2 keeps energy and is second order, lambda = 1 is backward Euler; for lambda >= 1/2
    #: bounded at every dt
    IMPLICIT = 0
    #: Kass 1997, eq. 13; without damping it grows at every dt
    FORWARD_EULER = 1
    #: the new velocity moves the position, of water in its symmetric form (velocity Verlet); bounded up to stable_dt
    SYMPLECTIC_EULER = 2
    #: two implicit stages with gamma = 1 - 1/sqrt(2) (SDIRK2): second order, and L-stable: motion too fast for dt dies
    #: out
    STIFF_SECOND = 3


class Solver(IntEnum):
    """How the two-dimensional system of a membrane's implicit step is solved."""

    #: rows, then columns: Kass 1997, section 9
    ALTERNATING = 0
    #: both at once, to a tolerance
    COUPLED = 1
    #: the first where that is right for the step, else the second
    AUTO = 2


class MassRule(IntEnum):
    """How the total mass is dealt out to the nodes."""

    #: every node the same: the notes' rule, first order in space
    EQUAL = 0
    #: nodes on a border half as heavy as those inside: second order in space
    HALF_ENDS = 1


class Kernels(IntEnum):
    """The instructions that steps are made of. All give the same bits as long as all numbers are finite; how far
    infinity and NaN spread in steps that end with CD_ERROR_DIVERGED may differ. A new object has the fastest that its
    processor runs."""

    #: what every processor of the target has: SSE2 on x86-64, NEON on AArch64, and on WebAssembly SIMD128 where that
    #: was built with -msimd128
    PLAIN = 0
    AVX2 = 1
    #: the parts F and DQ of AVX-512
    AVX512 = 2


class Node(IntEnum):
    """What holds a node. The values are also those of the field Field.PIN."""

    FREE = 0
    #: infinite mass, at rest
    PINNED = 1
    #: infinite mass, moves with the velocity written to it
    DRIVEN = 2
    #: border nodes only: free, with the impedance sqrt(stiffness mass) that sends no echo back
    MATCHED = 3
    #: infinite mass; each call of step moves it to where Field.TARGET is, evenly, and there it stays until Field.TARGET
    #: is written again. Without that field as Node.DRIVEN: it stands still where no velocity has been written
    POSED = 4


class Shape(IntEnum):
    """What a collider of ropes and cloth is."""

    NONE = 0
    PLANE = 1
    CAPSULE = 2
    BED = 3
    CALLBACK = 4


class Outside(IntEnum):
    """What becomes of places outside of an object that it is sampled at."""

    #: CD_ERROR_VALUE, and nothing is told of the other places either
    REFUSED = 0
    #: they stand for the nearest place in the object; only NaN is refused
    NEAREST = 1


class Field(IntEnum):
    """Per-node and per-spring data; each object's header lists those that it has. They are in one list, since a field
    that several objects have means the same in each. All hold numbers, pins and masks too, for one read and one
    write."""

    POSITION = 0
    VELOCITY = 1
    FORCE = 2
    MASS = 3
    STIFFNESS = 4
    BEND = 5
    PIN = 6
    TARGET = 7
    STIFFNESS_U = 8
    STIFFNESS_V = 9
    MASK = 10
    DEPTH = 11
    BED = 12
    SURFACE = 13
    VELOCITY_X = 14
    VELOCITY_Y = 15
    SOURCE = 16
    PRESSURE = 17
    FORCE_X = 18
    FORCE_Y = 19
    WALL_X = 20
    WALL_Y = 21
    REST_LENGTH = 22
    TENSION = 23
    WIND = 24
    STRENGTH = 25
    STRAIN = 26
    REST_LENGTH_U = 27
    REST_LENGTH_V = 28
    TENSION_U = 29
    TENSION_V = 30
    STRAIN_U = 31
    STRAIN_V = 32
    BREAKING_STRAIN_U = 33
    BREAKING_STRAIN_V = 34
    REST_ANGLE = 35


class Kind(IntEnum):
    """The kinds of objects."""

    CHAIN = 1
    MEMBRANE = 2
    WATER = 3


class End(IntEnum):
    """The two ends of a chain."""

    FIRST = 0
    LAST = 1


class Edge(IntEnum):
    """The four edges of a membrane. A corner belongs to two."""

    #: the nodes with u = 0
    U_FIRST = 0
    #: u = nu
    U_LAST = 1
    #: v = 0
    V_FIRST = 2
    #: v = nv
    V_LAST = 3


class Side(IntEnum):
    """The four sides."""

    #: x = 0
    X_FIRST = 0
    #: x = nx dx
    X_LAST = 1
    #: y = 0
    Y_FIRST = 2
    #: y = ny dy
    Y_LAST = 3


class Border(IntEnum):
    """What is at a side."""

    WALL = 0
    #: water of a given level outside, into which waves run without an echo
    OPEN = 1
    #: a given discharge comes in; if negative, leaves as far as there is water
    INFLOW = 2
    #: goes on at the opposite side
    PERIODIC = 3
    #: holds a given level for what flows out slower than its waves: a lake, a weir
    LEVEL = 4


class Momentum(IntEnum):
    """Whether water carries its momentum along."""

    LINEAR = 0
    ADVECTED = 1


class BedRule(IntEnum):
    """What a write to CD_BED leaves as it is."""

    #: the depth: water rides on the bed, volume is kept
    LIFTS_WATER = 0
    #: the surface of wet cells: the account tells the volume that a write brings or takes
    KEEPS_SURFACE = 1


class FieldInfo(NamedTuple):
    """One value per what, and for each component; always there; shown by view; only with rest lengths, in ropes and
    cloth; per strand only in ropes; not to be written."""

    per: Tuple[str, ...]
    components: bool
    always: bool
    viewable: bool
    lengths: bool
    own_in_ropes: bool
    read_only: bool


FIELDS: Dict[str, Dict[int, FieldInfo]] = {
    "chain": {
        Field.POSITION: FieldInfo(("strand", "node"), True, True, True, False, False, False),
        Field.VELOCITY: FieldInfo(("strand", "node"), True, True, True, False, False, False),
        Field.FORCE: FieldInfo(("strand", "node"), True, False, True, False, False, False),
        Field.TARGET: FieldInfo(("strand", "node"), True, False, True, False, False, False),
        Field.MASS: FieldInfo(("strand", "node"), False, False, False, False, True, False),
        Field.STIFFNESS: FieldInfo(("strand", "spring"), False, False, False, False, True, False),
        Field.BEND: FieldInfo(("strand", "node"), False, False, False, False, True, False),
        Field.PIN: FieldInfo(("strand", "node"), False, True, False, False, True, False),
        Field.REST_LENGTH: FieldInfo(("strand", "spring"), False, False, False, True, False, False),
        Field.TENSION: FieldInfo(("strand", "spring"), False, True, False, True, False, False),
        Field.WIND: FieldInfo(("strand", "node"), True, False, False, True, False, False),
        Field.STRENGTH: FieldInfo(("strand", "spring"), False, False, False, True, False, False),
        Field.REST_ANGLE: FieldInfo(("strand", "node"), False, False, False, True, False, False),
        Field.STRAIN: FieldInfo(("strand", "spring"), False, True, False, True, False, True),
    },
    "membrane": {
        Field.POSITION: FieldInfo(("node",), True, True, True, False, False, False),
        Field.VELOCITY: FieldInfo(("node",), True, True, True, False, False, False),
        Field.FORCE: FieldInfo(("node",), True, False, True, False, False, False),
        Field.TARGET: FieldInfo(("node",), True, False, True, False, False, False),
        Field.MASS: FieldInfo(("node",), False, False, False, False, False, False),
        Field.STIFFNESS_U: FieldInfo(("spring",), False, False, False, False, False, False),
        Field.STIFFNESS_V: FieldInfo(("spring",), False, False, False, False, False, False),
        Field.PIN: FieldInfo(("node",), False, False, False, False, False, False),
        Field.MASK: FieldInfo(("node",), False, False, False, False, False, False),
        Field.REST_LENGTH_U: FieldInfo(("spring",), False, False, False, True, False, False),
        Field.REST_LENGTH_V: FieldInfo(("spring",), False, False, False, True, False, False),
        Field.BREAKING_STRAIN_U: FieldInfo(("spring",), False, False, False, True, False, False),
        Field.BREAKING_STRAIN_V: FieldInfo(("spring",), False, False, False, True, False, False),
        Field.WIND: FieldInfo(("node",), True, False, False, True, False, False),
        Field.TENSION_U: FieldInfo(("spring",), False, True, False, True, False, True),
        Field.TENSION_V: FieldInfo(("spring",), False, True, False, True, False, True),
        Field.STRAIN_U: FieldInfo(("spring",), False, True, False, True, False, True),
        Field.STRAIN_V: FieldInfo(("spring",), False, True, False, True, False, True),
    },
    "water": {
        Field.DEPTH: FieldInfo(("cell",), False, True, True, False, False, False),
        Field.BED: FieldInfo(("cell",), False, True, True, False, False, False),
        Field.SURFACE: FieldInfo(("cell",), False, True, False, False, False, False),
        Field.VELOCITY_X: FieldInfo(("x-face",), False, True, True, False, False, False),
        Field.VELOCITY_Y: FieldInfo(("y-face",), False, True, True, False, False, False),
        Field.SOURCE: FieldInfo(("cell",), False, False, True, False, False, False),
        Field.PRESSURE: FieldInfo(("cell",), False, False, True, False, False, False),
        Field.FORCE_X: FieldInfo(("x-face",), False, False, True, False, False, False),
        Field.FORCE_Y: FieldInfo(("y-face",), False, False, True, False, False, False),
        Field.MASK: FieldInfo(("cell",), False, False, False, False, False, False),
        Field.WALL_X: FieldInfo(("x-face",), False, False, False, False, False, False),
        Field.WALL_Y: FieldInfo(("y-face",), False, False, False, False, False, False),
    },
}

ALLOCATE_FUNCTION = CFUNCTYPE(c_void_p, c_void_p, c_size_t, c_size_t)
RELEASE_FUNCTION = CFUNCTYPE(None, c_void_p, c_void_p, c_size_t, c_size_t)


class Allocator(Structure):
    """cd_allocator."""

    _fields_ = [
        ("user", c_void_p),
        ("allocate", ALLOCATE_FUNCTION),
        ("release", RELEASE_FUNCTION),
    ]


TASK_FUNCTION = CFUNCTYPE(None, c_void_p, c_size_t)
RUN_FUNCTION = CFUNCTYPE(None, c_void_p, c_size_t, TASK_FUNCTION, c_void_p)


class Parallel(Structure):
    """cd_parallel."""

    _fields_ = [
        ("user", c_void_p),
        ("run", RUN_FUNCTION),
    ]


DISTANCE_FUNCTION = CFUNCTYPE(None, c_void_p, c_double, c_size_t, c_size_t, c_void_p, c_void_p, c_void_p)


class Distance(Structure):
    """cd_distance."""

    _fields_ = [
        ("user", c_void_p),
        ("distance", DISTANCE_FUNCTION),
    ]


TYPES: Dict[str, Any] = {
    "handle": c_void_p,
    "pointer": c_void_p,
    "status": c_int32,
    "int": c_int32,
    "uint": c_uint32,
    "uint64": c_uint64,
    "size": c_size_t,
    "double": c_double,
    "text": c_char_p,
    "nothing": None,
    "handle*": POINTER(c_void_p),
    "pointer*": POINTER(c_void_p),
    "int*": POINTER(c_int32),
    "uint64*": POINTER(c_uint64),
    "size*": POINTER(c_size_t),
    "double*": POINTER(c_double),
    "Allocator*": POINTER(Allocator),
    "Parallel*": POINTER(Parallel),
    "Distance*": POINTER(Distance),
}

# What each function returns: its parameters' names and types.
FUNCTIONS: Dict[str, str] = {
    "cd_status_name": "text: status int",
    "cd_error_message": "text:",
    "cd_saved_shape": ("status: bytes pointer, size size, out_kind int*, out_first size*, out_second size*, "
                       "out_components size*, out_precision int*"),
    "cd_runnable_kernels": "uint:",
    "cd_kernels_name": "text: kernels int",
    "cd_version": "uint:",
    "cd_version_string": "text:",
    "cd_build_info": "text:",
    "cd_chain_create": ("status: strands size, springs size, components size, precision int, allocator Allocator*, "
                        "out_chain handle*"),
    "cd_chain_destroy": "nothing: chain handle",
    "cd_chain_get_shape": ("status: chain handle, out_strands size*, out_springs size*, out_components size*, "
                           "out_precision int*"),
    "cd_chain_set_method": "status: chain handle, method int",
    "cd_chain_get_method": "status: chain handle, out_method int*",
    "cd_chain_set_lambda": "status: chain handle, lambda double",
    "cd_chain_get_lambda": "status: chain handle, out_lambda double*",
    "cd_chain_set_parallel": "status: chain handle, parallel Parallel*",
    "cd_chain_set_kernels": "status: chain handle, kernels int",
    "cd_chain_get_kernels": "status: chain handle, out_kernels int*",
    "cd_chain_set_mass": "status: chain handle, mass double",
    "cd_chain_get_mass": "status: chain handle, out_mass double*",
    "cd_chain_set_mass_rule": "status: chain handle, rule int",
    "cd_chain_get_mass_rule": "status: chain handle, out_rule int*",
    "cd_chain_set_stiffness": "status: chain handle, stiffness double",
    "cd_chain_get_stiffness": "status: chain handle, out_stiffness double*",
    "cd_chain_set_bend": "status: chain handle, bend double",
    "cd_chain_get_bend": "status: chain handle, out_bend double*",
    "cd_chain_set_drag": "status: chain handle, drag double",
    "cd_chain_get_drag": "status: chain handle, out_drag double*",
    "cd_chain_set_stiffness_damping": "status: chain handle, seconds double",
    "cd_chain_get_stiffness_damping": "status: chain handle, out_seconds double*",
    "cd_chain_set_gravity": "status: chain handle, gravity pointer, count size",
    "cd_chain_get_gravity": "status: chain handle, out_gravity pointer, count size",
    "cd_chain_set_end": "status: chain handle, end int, kind int",
    "cd_chain_get_end": "status: chain handle, end int, out_kind int*",
    "cd_chain_set_ring": "status: chain handle, ring int",
    "cd_chain_get_ring": "status: chain handle, out_ring int*",
    "cd_chain_set_sleep": "status: chain handle, speed double, seconds double",
    "cd_chain_get_sleep": "status: chain handle, out_speed double*, out_seconds double*",
    "cd_chain_get_awake": "status: chain handle, out_nodes size*",
    "cd_chain_set_rest_length": "status: chain handle, length double",
    "cd_chain_get_rest_length": "status: chain handle, out_length double*",
    "cd_chain_set_rest_angle": "status: chain handle, angle double",
    "cd_chain_get_rest_angle": "status: chain handle, out_angle double*",
    "cd_chain_set_push": "status: chain handle, push int",
    "cd_chain_get_push": "status: chain handle, out_push int*",
    "cd_chain_set_strength": "status: chain handle, strength double",
    "cd_chain_get_strength": "status: chain handle, out_strength double*",
    "cd_chain_get_broken": "status: chain handle, out_springs size*",
    "cd_chain_get_reaction": "status: chain handle, strand size, node size, out_force pointer, count size",
    "cd_chain_set_air": "status: chain handle, along double, across double",
    "cd_chain_get_air": "status: chain handle, out_along double*, out_across double*",
    "cd_chain_set_wind": "status: chain handle, velocity pointer, count size",
    "cd_chain_get_wind": "status: chain handle, out_velocity pointer, count size",
    "cd_chain_set_tolerance": "status: chain handle, tolerance double, most_iterations size",
    "cd_chain_get_tolerance": "status: chain handle, out_tolerance double*, out_most_iterations size*",
    "cd_chain_get_convergence": "status: chain handle, out_iterations size*, out_residual double*",
    "cd_chain_set_colliders": "status: chain handle, count size",
    "cd_chain_get_colliders": "status: chain handle, out_count size*",
    "cd_chain_set_plane": ("status: chain handle, index size, point pointer, normal pointer, count size, friction "
                           "double"),
    "cd_chain_set_capsule": ("status: chain handle, index size, first pointer, last pointer, count size, radius "
                             "double, friction double"),
    "cd_chain_set_bed": ("status: chain handle, index size, origin pointer, count size, columns size, rows size, "
                         "column_spacing double, row_spacing double, heights pointer, height_count size, friction "
                         "double"),
    "cd_chain_get_bed": ("status: chain handle, index size, out_columns size*, out_rows size*, out_heights pointer, "
                         "height_count size"),
    "cd_chain_set_callback": ("status: chain handle, index size, distance Distance*, origin pointer, count size, "
                              "friction double"),
    "cd_chain_remove_collider": "status: chain handle, index size",
    "cd_chain_set_collider_velocity": "status: chain handle, index size, velocity pointer, count size",
    "cd_chain_get_collider": ("status: chain handle, index size, out_shape int*, out_first pointer, out_second "
                              "pointer, out_velocity pointer, count size, out_radius double*, out_friction double*"),
    "cd_chain_set_loads": "status: chain handle, loads int",
    "cd_chain_get_loads": "status: chain handle, out_loads int*",
    "cd_chain_get_collider_load": "status: chain handle, index size, out_load pointer, count size",
    "cd_chain_set_thickness": "status: chain handle, radius double",
    "cd_chain_get_thickness": "status: chain handle, out_radius double*",
    "cd_chain_enable_field": "status: chain handle, field int",
    "cd_chain_disable_field": "status: chain handle, field int",
    "cd_chain_write_f32": ("status: chain handle, field int, first_strand size, strands size, first size, n size, "
                           "values pointer, count size"),
    "cd_chain_write_f64": ("status: chain handle, field int, first_strand size, strands size, first size, n size, "
                           "values pointer, count size"),
    "cd_chain_read_f32": ("status: chain handle, field int, first_strand size, strands size, first size, n size, "
                          "out_values pointer, count size"),
    "cd_chain_read_f64": ("status: chain handle, field int, first_strand size, strands size, first size, n size, "
                          "out_values pointer, count size"),
    "cd_chain_view": ("status: chain handle, field int, out_data pointer*, out_strand_stride size*, out_node_stride "
                      "size*, out_component_stride size*"),
    "cd_chain_impulse": "status: chain handle, strand size, node size, impulse pointer, count size",
    "cd_chain_teleport": "status: chain handle, strand size, rotation pointer, offset pointer, count size",
    "cd_chain_attach": ("status: chain handle, strand size, node size, stiffness double, damping double, target "
                        "pointer, count size"),
    "cd_chain_detach": "status: chain handle, strand size, node size",
    "cd_chain_get_attachment": ("status: chain handle, strand size, node size, out_stiffness double*, out_damping "
                                "double*"),
    "cd_chain_cut": "status: chain handle, strand size, spring size",
    "cd_chain_weld": "status: chain handle, strand size, spring size",
    "cd_chain_step": "status: chain handle, dt double, count size",
    "cd_chain_stable_dt": "status: chain handle, out_dt double*",
    "cd_chain_get_time": "status: chain handle, out_time double*",
    "cd_chain_get_steps": "status: chain handle, out_steps uint64*",
    "cd_chain_get_factorizations": "status: chain handle, out_count uint64*",
    "cd_chain_get_energy": "status: chain handle, out_kinetic double*, out_elastic double*, out_gravity double*",
    "cd_chain_get_momentum": "status: chain handle, out_momentum pointer, count size",
    "cd_chain_sample": ("status: chain handle, strand size, at pointer, n size, outside int, out_positions pointer, "
                        "out_count size"),
    "cd_chain_get_memory": "status: chain handle, out_bytes size*",
    "cd_chain_hash": "status: chain handle, out_hash uint64*",
    "cd_chain_save_size": "status: chain handle, out_size size*",
    "cd_chain_save": "status: chain handle, buffer pointer, size size, out_written size*",
    "cd_chain_load": "status: chain handle, bytes pointer, size size",
    "cd_chain_copy_state": "status: chain handle, source handle",
    "cd_chain_reset": "status: chain handle",
    "cd_membrane_create": ("status: nu size, nv size, components size, precision int, allocator Allocator*, "
                           "out_membrane handle*"),
    "cd_membrane_destroy": "nothing: membrane handle",
    "cd_membrane_get_shape": ("status: membrane handle, out_nu size*, out_nv size*, out_components size*, "
                              "out_precision int*"),
    "cd_membrane_set_method": "status: membrane handle, method int",
    "cd_membrane_get_method": "status: membrane handle, out_method int*",
    "cd_membrane_set_lambda": "status: membrane handle, lambda double",
    "cd_membrane_get_lambda": "status: membrane handle, out_lambda double*",
    "cd_membrane_set_solver": "status: membrane handle, solver int",
    "cd_membrane_get_solver": "status: membrane handle, out_solver int*",
    "cd_membrane_get_solver_taken": "status: membrane handle, out_solver int*",
    "cd_membrane_set_tolerance": "status: membrane handle, tolerance double, most_iterations size",
    "cd_membrane_get_tolerance": "status: membrane handle, out_tolerance double*, out_most_iterations size*",
    "cd_membrane_get_convergence": "status: membrane handle, out_iterations size*, out_residual double*",
    "cd_membrane_set_parallel": "status: membrane handle, parallel Parallel*",
    "cd_membrane_set_kernels": "status: membrane handle, kernels int",
    "cd_membrane_get_kernels": "status: membrane handle, out_kernels int*",
    "cd_membrane_set_mass": "status: membrane handle, mass double",
    "cd_membrane_get_mass": "status: membrane handle, out_mass double*",
    "cd_membrane_set_mass_rule": "status: membrane handle, rule int",
    "cd_membrane_get_mass_rule": "status: membrane handle, out_rule int*",
    "cd_membrane_set_stiffness": "status: membrane handle, along_u double, along_v double",
    "cd_membrane_get_stiffness": "status: membrane handle, out_along_u double*, out_along_v double*",
    "cd_membrane_set_bend": "status: membrane handle, bend double",
    "cd_membrane_get_bend": "status: membrane handle, out_bend double*",
    "cd_membrane_set_drag": "status: membrane handle, drag double",
    "cd_membrane_get_drag": "status: membrane handle, out_drag double*",
    "cd_membrane_set_stiffness_damping": "status: membrane handle, seconds double",
    "cd_membrane_get_stiffness_damping": "status: membrane handle, out_seconds double*",
    "cd_membrane_set_gravity": "status: membrane handle, gravity pointer, count size",
    "cd_membrane_get_gravity": "status: membrane handle, out_gravity pointer, count size",
    "cd_membrane_set_pressure": "status: membrane handle, pressure double",
    "cd_membrane_get_pressure": "status: membrane handle, out_pressure double*",
    "cd_membrane_set_edge": "status: membrane handle, edge int, kind int",
    "cd_membrane_get_edge": "status: membrane handle, edge int, out_kind int*",
    "cd_membrane_set_ring": "status: membrane handle, along_u int, along_v int",
    "cd_membrane_get_ring": "status: membrane handle, out_along_u int*, out_along_v int*",
    "cd_membrane_set_sleep": "status: membrane handle, speed double, seconds double",
    "cd_membrane_get_sleep": "status: membrane handle, out_speed double*, out_seconds double*",
    "cd_membrane_get_awake": "status: membrane handle, out_nodes size*",
    "cd_membrane_set_rest_length": "status: membrane handle, along_u double, along_v double",
    "cd_membrane_get_rest_length": "status: membrane handle, out_along_u double*, out_along_v double*",
    "cd_membrane_set_shear": "status: membrane handle, stiffness double",
    "cd_membrane_get_shear": "status: membrane handle, out_stiffness double*",
    "cd_membrane_set_compression": "status: membrane handle, rate double",
    "cd_membrane_get_compression": "status: membrane handle, out_rate double*",
    "cd_membrane_set_breaking_strain": "status: membrane handle, strain double",
    "cd_membrane_get_breaking_strain": "status: membrane handle, out_strain double*",
    "cd_membrane_get_broken": "status: membrane handle, out_springs size*",
    "cd_membrane_set_effort": "status: membrane handle, newton size, gradient size",
    "cd_membrane_get_effort": "status: membrane handle, out_newton size*, out_gradient size*",
    "cd_membrane_set_air": "status: membrane handle, along double, across double",
    "cd_membrane_get_air": "status: membrane handle, out_along double*, out_across double*",
    "cd_membrane_set_wind": "status: membrane handle, velocity pointer, count size",
    "cd_membrane_get_wind": "status: membrane handle, out_velocity pointer, count size",
    "cd_membrane_set_colliders": "status: membrane handle, count size",
    "cd_membrane_get_colliders": "status: membrane handle, out_count size*",
    "cd_membrane_set_plane": ("status: membrane handle, index size, point pointer, normal pointer, count size, "
                              "friction double"),
    "cd_membrane_set_capsule": ("status: membrane handle, index size, first pointer, last pointer, count size, radius "
                                "double, friction double"),
    "cd_membrane_set_bed": ("status: membrane handle, index size, origin pointer, count size, columns size, rows size, "
                            "column_spacing double, row_spacing double, heights pointer, height_count size, friction "
                            "double"),
    "cd_membrane_get_bed": ("status: membrane handle, index size, out_columns size*, out_rows size*, out_heights "
                            "pointer, height_count size"),
    "cd_membrane_set_callback": ("status: membrane handle, index size, distance Distance*, origin pointer, count size, "
                                 "friction double"),
    "cd_membrane_remove_collider": "status: membrane handle, index size",
    "cd_membrane_set_collider_velocity": "status: membrane handle, index size, velocity pointer, count size",
    "cd_membrane_get_collider": ("status: membrane handle, index size, out_shape int*, out_first pointer, out_second "
                                 "pointer, out_velocity pointer, count size, out_radius double*, out_friction double*"),
    "cd_membrane_set_loads": "status: membrane handle, loads int",
    "cd_membrane_get_loads": "status: membrane handle, out_loads int*",
    "cd_membrane_get_collider_load": "status: membrane handle, index size, out_load pointer, count size",
    "cd_membrane_set_thickness": "status: membrane handle, distance double",
    "cd_membrane_get_thickness": "status: membrane handle, out_distance double*",
    "cd_membrane_enable_field": "status: membrane handle, field int",
    "cd_membrane_disable_field": "status: membrane handle, field int",
    "cd_membrane_write_f32": ("status: membrane handle, field int, first_u size, first_v size, n_u size, n_v size, "
                              "values pointer, count size"),
    "cd_membrane_write_f64": ("status: membrane handle, field int, first_u size, first_v size, n_u size, n_v size, "
                              "values pointer, count size"),
    "cd_membrane_read_f32": ("status: membrane handle, field int, first_u size, first_v size, n_u size, n_v size, "
                             "out_values pointer, count size"),
    "cd_membrane_read_f64": ("status: membrane handle, field int, first_u size, first_v size, n_u size, n_v size, "
                             "out_values pointer, count size"),
    "cd_membrane_view": ("status: membrane handle, field int, out_data pointer*, out_u_stride size*, out_v_stride "
                         "size*, out_component_stride size*"),
    "cd_membrane_impulse": "status: membrane handle, u double, v double, radius double, impulse pointer, count size",
    "cd_membrane_teleport": "status: membrane handle, rotation pointer, offset pointer, count size",
    "cd_membrane_attach": ("status: membrane handle, u size, v size, stiffness double, damping double, target pointer, "
                           "count size"),
    "cd_membrane_detach": "status: membrane handle, u size, v size",
    "cd_membrane_get_attachment": ("status: membrane handle, u size, v size, out_stiffness double*, out_damping "
                                   "double*"),
    "cd_membrane_step": "status: membrane handle, dt double, count size",
    "cd_membrane_stable_dt": "status: membrane handle, out_dt double*",
    "cd_membrane_get_time": "status: membrane handle, out_time double*",
    "cd_membrane_get_steps": "status: membrane handle, out_steps uint64*",
    "cd_membrane_get_factorizations": "status: membrane handle, out_count uint64*",
    "cd_membrane_get_energy": "status: membrane handle, out_kinetic double*, out_elastic double*, out_gravity double*",
    "cd_membrane_get_momentum": "status: membrane handle, out_momentum pointer, count size",
    "cd_membrane_get_reaction": "status: membrane handle, u size, v size, out_force pointer, count size",
    "cd_membrane_get_volume": "status: membrane handle, out_volume double*",
    "cd_membrane_sample": ("status: membrane handle, at pointer, n size, outside int, out_positions pointer, out_count "
                           "size"),
    "cd_membrane_get_memory": "status: membrane handle, out_bytes size*",
    "cd_membrane_hash": "status: membrane handle, out_hash uint64*",
    "cd_membrane_write_vertices": ("status: membrane handle, buffer pointer, size size, stride size, position_offset "
                                   "size, normal_offset size"),
    "cd_membrane_get_index_count": "status: membrane handle, out_count size*",
    "cd_membrane_write_indices": "status: membrane handle, buffer pointer, size size, index_size size",
    "cd_membrane_save_size": "status: membrane handle, out_size size*",
    "cd_membrane_save": "status: membrane handle, buffer pointer, size size, out_written size*",
    "cd_membrane_load": "status: membrane handle, bytes pointer, size size",
    "cd_membrane_copy_state": "status: membrane handle, source handle",
    "cd_membrane_reset": "status: membrane handle",
    "cd_water_create": ("status: nx size, ny size, dx double, dy double, precision int, allocator Allocator*, "
                        "out_water handle*"),
    "cd_water_destroy": "nothing: water handle",
    "cd_water_get_shape": ("status: water handle, out_nx size*, out_ny size*, out_dx double*, out_dy double*, "
                           "out_precision int*"),
    "cd_water_set_method": "status: water handle, method int",
    "cd_water_get_method": "status: water handle, out_method int*",
    "cd_water_set_lambda": "status: water handle, lambda double",
    "cd_water_get_lambda": "status: water handle, out_lambda double*",
    "cd_water_set_momentum": "status: water handle, momentum int",
    "cd_water_get_momentum": "status: water handle, out_momentum int*",
    "cd_water_set_first": "status: water handle, along_y int",
    "cd_water_get_first": "status: water handle, out_along_y int*",
    "cd_water_set_parallel": "status: water handle, parallel Parallel*",
    "cd_water_set_kernels": "status: water handle, kernels int",
    "cd_water_get_kernels": "status: water handle, out_kernels int*",
    "cd_water_set_gravity": "status: water handle, gravity double",
    "cd_water_get_gravity": "status: water handle, out_gravity double*",
    "cd_water_set_density": "status: water handle, density double",
    "cd_water_get_density": "status: water handle, out_density double*",
    "cd_water_set_drag": "status: water handle, drag double",
    "cd_water_get_drag": "status: water handle, out_drag double*",
    "cd_water_set_manning": "status: water handle, manning double",
    "cd_water_get_manning": "status: water handle, out_manning double*",
    "cd_water_set_side": "status: water handle, side int, kind int, value double, rate double",
    "cd_water_get_side": "status: water handle, side int, out_kind int*, out_value double*, out_rate double*",
    "cd_water_set_inflow_depth": "status: water handle, side int, depth double",
    "cd_water_get_inflow_depth": "status: water handle, side int, out_depth double*",
    "cd_water_set_bed_rule": "status: water handle, rule int",
    "cd_water_get_bed_rule": "status: water handle, out_rule int*",
    "cd_water_enable_field": "status: water handle, field int",
    "cd_water_disable_field": "status: water handle, field int",
    "cd_water_write_f32": ("status: water handle, field int, first_x size, first_y size, n_x size, n_y size, values "
                           "pointer, count size"),
    "cd_water_write_f64": ("status: water handle, field int, first_x size, first_y size, n_x size, n_y size, values "
                           "pointer, count size"),
    "cd_water_read_f32": ("status: water handle, field int, first_x size, first_y size, n_x size, n_y size, out_values "
                          "pointer, count size"),
    "cd_water_read_f64": ("status: water handle, field int, first_x size, first_y size, n_x size, n_y size, out_values "
                          "pointer, count size"),
    "cd_water_view": "status: water handle, field int, out_data pointer*, out_x_stride size*, out_y_stride size*",
    "cd_water_add_volume": "status: water handle, x double, y double, radius double, volume double, out_added double*",
    "cd_water_add_volume_rectangle": ("status: water handle, first_x size, first_y size, n_x size, n_y size, volume "
                                      "double, out_added double*"),
    "cd_water_add_source": "status: water handle, x double, y double, radius double, rate double",
    "cd_water_add_source_rectangle": ("status: water handle, first_x size, first_y size, n_x size, n_y size, rate "
                                      "double"),
    "cd_water_splash": "status: water handle, x double, y double, radius double, height double",
    "cd_water_impulse": "status: water handle, x double, y double, radius double, impulse_x double, impulse_y double",
    "cd_water_set_hulls": "status: water handle, count size, n_along size, n_across size",
    "cd_water_get_hulls": "status: water handle, out_count size*, out_n_along size*, out_n_across size*",
    "cd_water_set_hull": ("status: water handle, index size, mass double, length double, width double, heights "
                          "pointer, count size"),
    "cd_water_set_disc": "status: water handle, index size, mass double, radius double",
    "cd_water_get_hull": ("status: water handle, index size, out_mass double*, out_length double*, out_width double*, "
                          "out_area double*, out_heights pointer, count size"),
    "cd_water_remove_hull": "status: water handle, index size",
    "cd_water_launch_hull": "status: water handle, index size, x double, y double, ahead_x double, ahead_y double",
    "cd_water_set_hull_pose": "status: water handle, index size, pose pointer, count size",
    "cd_water_get_hull_pose": "status: water handle, index size, out_pose pointer, count size",
    "cd_water_set_hull_velocity": "status: water handle, index size, velocity pointer, count size",
    "cd_water_get_hull_velocity": "status: water handle, index size, out_velocity pointer, count size",
    "cd_water_get_hull_floor": "status: water handle, index size, out_pose pointer, count size",
    "cd_water_set_hull_force": "status: water handle, index size, force pointer, count size",
    "cd_water_get_hull_force": "status: water handle, index size, out_force pointer, count size",
    "cd_water_set_hull_drag": "status: water handle, index size, along double, across double, friction double",
    "cd_water_get_hull_drag": ("status: water handle, index size, out_along double*, out_across double*, out_friction "
                               "double*"),
    "cd_water_get_hull_load": "status: water handle, index size, out_load pointer, count size",
    "cd_water_get_hull_energy": "status: water handle, out_kinetic double*, out_potential double*",
    "cd_water_sample_heads": "status: water handle, at pointer, n size, outside int, out_heads pointer",
    "cd_water_step": "status: water handle, dt double, count size",
    "cd_water_stable_dt": "status: water handle, out_dt double*",
    "cd_water_get_time": "status: water handle, out_time double*",
    "cd_water_get_steps": "status: water handle, out_steps uint64*",
    "cd_water_get_factorizations": "status: water handle, out_count uint64*",
    "cd_water_get_limited": "status: water handle, out_cells uint64*, out_volume double*",
    "cd_water_set_sleep": "status: water handle, height double",
    "cd_water_get_sleep": "status: water handle, out_height double*",
    "cd_water_get_awake": "status: water handle, out_cells size*",
    "cd_water_get_volume": "status: water handle, out_volume double*",
    "cd_water_get_account": ("status: water handle, out_initial double*, out_in double*, out_out double*, out_error "
                             "double*"),
    "cd_water_restart_account": "status: water handle",
    "cd_water_get_energy": "status: water handle, out_kinetic double*, out_potential double*",
    "cd_water_get_wet_area": "status: water handle, out_area double*",
    "cd_water_get_courant": "status: water handle, dt double, out_courant double*",
    "cd_water_sample": ("status: water handle, at pointer, n size, outside int, out_surface pointer, out_depth "
                        "pointer, out_normal pointer, out_velocity pointer"),
    "cd_water_get_memory": "status: water handle, out_bytes size*",
    "cd_water_hash": "status: water handle, out_hash uint64*",
    "cd_water_write_vertices": ("status: water handle, buffer pointer, size size, stride size, position_offset size, "
                                "normal_offset size, depth_offset size"),
    "cd_water_get_index_count": "status: water handle, skip_dry int, out_count size*",
    "cd_water_write_indices": "status: water handle, skip_dry int, buffer pointer, size size, index_size size",
    "cd_water_save_size": "status: water handle, out_size size*",
    "cd_water_save": "status: water handle, buffer pointer, size size, out_written size*",
    "cd_water_load": "status: water handle, bytes pointer, size size",
    "cd_water_copy_state": "status: water handle, source handle",
    "cd_water_reset": "status: water handle",
}
