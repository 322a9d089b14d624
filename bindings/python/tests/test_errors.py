"""Every way in which a call on a chain, or on what is cloth's, can fail, as the C headers list them: the exception, its
message, and that nothing has changed."""
import math
import re
import unittest
from fractions import Fraction

import contdyn
from contdyn import Chain, Edge, End, Field, Membrane, Method, Node, Precision, Water
from contdyn._library import Functions

from support import Heap, api, lengthen, make, moving

NAN, INF = math.nan, math.inf


def hungry(kind_of_change, first=lambda chain: None):
    """The change on an object whose allocator gives no more, after what is done first."""

    def use(like):
        heap = Heap()
        with make(type(like), allocator=heap) as poor:
            first(poor)
            heap.most = heap.given
            kind_of_change(poor)

    return use


def pin_two(chain):
    chain.write(Field.PIN, [1, 1], first=2, n=2)


def diverge(chain):
    chain.method = Method.FORWARD_EULER
    chain.stiffness = 1e30
    chain.step(1e10, 100)


def make_rope(chain):
    chain.rest_length = 1


def make_rigid(chain):
    chain.rest_length, chain.stiffness = 1, INF


def make_fragile(chain):
    chain.rest_length, chain.strength = 1, 1e9
    chain.enable_field(Field.STRENGTH)


def make_solid(chain):
    chain.rest_length, chain.colliders = 1, 1


def make_solid_cloth(membrane):
    membrane.rest_length, membrane.colliders = (1, 1), 1


def setting(name, value):
    return lambda chain: setattr(chain, name, value)


BAD_NUMBERS = (NAN, INF, -INF, -1.0, 1e300)
# Function of the C API, the error that its comment lists, what makes it fail (after what, if two), what it must tell.
CASES = [
    ("create", "SIZE", lambda c: Chain(1, 2**60, 4), "1152921504606846976"),
    ("create", "VALUE", lambda c: Chain(0, 1, 1), "strands is 0"),
    ("create", "VALUE", lambda c: Chain(1, 1, 0), "components is 0"),
    ("create", "VALUE", lambda c: Chain(1, 1, 5), "components is 5"),
    ("create", "ENUM", lambda c: Chain(1, 1, 1, 7), "precision is 7"),
    ("create", "MEMORY", lambda c: Chain(1, 1, 1, allocator=Heap(0)), "no memory"),
    ("create", "RANGE", lambda c: Chain(-1, 1, 1), "strands is -1"),
    ("create", "RANGE", lambda c: Chain(1, 2**64 + 1, 1), "springs is 18446744073709551617"),
    ("set_method", "ENUM", setting("method", 4), "method is 4"),
    ("set_method", "ENUM", setting("method", -1), "method is -1"),
    ("set_method", "RANGE", setting("method", 2**32), "method is 4294967296"),
    ("set_method", "MEMORY", hungry(setting("method", Method.STIFF_SECOND)), "memory"),
    ("set_kernels", "ENUM", setting("kernels", 3), "kernels is 3"),
    ("set_kernels", "ENUM", setting("kernels", -1), "kernels is -1"),
    *(("set_lambda", "VALUE", setting("lambda_", x), "lambda is") for x in (NAN, -0.1, 1.1, INF)),
    *(("set_mass", "VALUE", setting("mass", x), "mass is") for x in (*BAD_NUMBERS, 0)),
    *(("set_stiffness", "VALUE", setting("stiffness", x), "stiffness is") for x in BAD_NUMBERS),
    ("set_stiffness", "VALUE", (make_rope, setting("stiffness", -INF)), "stiffness is"),
    *(("set_bend", "VALUE", setting("bend", x), "bend is") for x in BAD_NUMBERS),
    ("set_bend", "MEMORY", hungry(setting("bend", 1.0)), "memory"),
    *(("set_drag", "VALUE", setting("drag", x), "drag is") for x in BAD_NUMBERS),
    *(("set_stiffness_damping", "VALUE", setting("stiffness_damping", x), "is") for x in BAD_NUMBERS),
    ("set_mass_rule", "ENUM", setting("mass_rule", 2), "rule is 2"),
    ("set_gravity", "VALUE", setting("gravity", (0, NAN, 0)), "nan"),
    ("set_gravity", "RANGE", setting("gravity", (0, 1)), "2"),
    ("set_end", "ENUM", lambda c: c.set_end(2, Node.FREE), "end is 2"),
    ("set_end", "ENUM", lambda c: c.set_end(End.LAST, 5), "kind is 5"),
    ("set_end", "MEMORY", hungry(lambda c: c.set_end(End.LAST, Node.POSED)), "memory"),
    ("set_end", "UNSUPPORTED", (setting("ring", True), lambda c: c.set_end(End.LAST, Node.MATCHED)), "ring"),
    ("get_end", "ENUM", lambda c: c.get_end(-1), "end is -1"),
    ("set_ring", "VALUE", setting("ring", 2), "ring is 2"),
    ("set_ring", "UNSUPPORTED", lambda c: setattr(Chain(1, 1, 1), "ring", True), "needs 3 nodes: .* 2"),
    ("set_ring", "UNSUPPORTED", (lambda c: c.set_end(End.FIRST, Node.MATCHED), setting("ring", True)), "NODE_MATCHED"),
    ("set_ring", "MEMORY", hungry(setting("ring", True)), "memory"),
    *(("set_sleep", "VALUE", setting("sleep", (x, 1)), "speed is") for x in BAD_NUMBERS),
    ("set_sleep", "VALUE", setting("sleep", (1, 0)), "seconds is 0"),
    ("set_sleep", "MEMORY", hungry(setting("sleep", (1, 1))), "memory"),
    *(("set_rest_length", "VALUE", setting("rest_length", x), "length is") for x in (*BAD_NUMBERS, 1e-61)),
    ("set_rest_length", "UNSUPPORTED", lambda c: setattr(Chain(1, 2, 4), "rest_length", 1), "4 components"),
    ("set_rest_length", "UNSUPPORTED", lambda c: setattr(Chain(1, 0, 3), "rest_length", 1), "0 springs"),
    ("set_rest_length", "UNSUPPORTED", (make_rigid, setting("rest_length", 0)), "infinite"),
    ("set_rest_length", "MEMORY", hungry(make_rope), "memory"),
    *(("set_rest_angle", "VALUE", (make_rope, setting("rest_angle", x)), "angle is") for x in (NAN, INF, 12.6, -12.6)),
    ("set_rest_angle", "UNSUPPORTED", (make_rope, setting("rest_angle", 1)), "2 components"),
    ("set_rest_angle", "UNSUPPORTED", setting("rest_angle", 1), "only ropes"),
    ("set_push", "VALUE", setting("push", 2), "push is 2"),
    *(("set_strength", "VALUE", (make_rope, setting("strength", x)), "strength is") for x in (NAN, -INF, -1, 0, 1e300)),
    ("set_strength", "UNSUPPORTED", setting("strength", 1), "only ropes"),
    ("set_strength", "MEMORY", hungry(setting("strength", 1), make_rope), "memory"),
    ("set_colliders", "VALUE", (make_rope, setting("colliders", 4097)), "count is 4097"),
    ("set_colliders", "UNSUPPORTED", setting("colliders", 1), "only ropes"),
    ("set_colliders", "MEMORY", hungry(setting("colliders", 1), make_rope), "memory"),
    ("set_plane", "RANGE", (make_rope, lambda c: c.set_plane(0, (0, 0, 0), (0, 1, 0))), "index is 0"),
    ("set_plane", "VALUE", (make_solid, lambda c: c.set_plane(0, (0, 0, 0), (0, 0, 0))), "normal"),
    ("set_plane", "RANGE", (make_solid, lambda c: c.set_plane(0, (0, 0), (0, 0))), "count is 2"),
    ("set_capsule", "VALUE", (make_solid, lambda c: c.set_capsule(0, (0, 0, 0), (0, NAN, 0), 1)), "nan"),
    ("set_capsule", "VALUE", (make_solid, lambda c: c.set_capsule(0, (0, 0, 0), (0, 1, 0), 0)), "radius is 0"),
    ("set_bed", "VALUE", (make_solid, lambda c: c.set_bed(0, (0, 0, 0), 1, 2, 1, 1, [0] * 2)), "columns is 1"),
    ("set_bed", "VALUE", (make_solid, lambda c: c.set_bed(0, (0, 0, 0), 2, 2, 1, 0, [0] * 4)), "row_spacing is 0"),
    ("set_bed", "VALUE", (make_solid, lambda c: c.set_bed(0, (0, 0, 0), 2, 2, 1, 1, [0, 0, 0, NAN])), "heights"),
    ("set_bed", "RANGE", (make_solid, lambda c: c.set_bed(1, (0, 0, 0), 2, 2, 1, 1, [0] * 4)), "index is 1"),
    ("set_bed", "RANGE", (make_solid, lambda c: c.set_bed(0, (0, 0), 2, 2, 1, 1, [0] * 4)), "count is 2"),
    ("set_bed", "MEMORY", hungry(lambda c: c.set_bed(0, (0, 0, 0), 2, 2, 1, 1, [0] * 4), make_solid), "memory"),
    ("set_bed", "UNSUPPORTED", lambda c: c.set_bed(0, (0, 0, 0), 2, 2, 1, 1, [0] * 4), "only ropes"),
    ("set_callback", "MEMORY", hungry(lambda c: c.set_callback(0, max, (0, 0, 0)), make_solid), "memory"),
    ("set_callback", "UNSUPPORTED", lambda c: c.set_callback(0, max, (0, 0, 0)), "only ropes"),
    ("get_bed", "RANGE", (make_solid, lambda c: c.get_bed(1)), "index is 1"),
    ("set_callback", "RANGE", (make_solid, lambda c: c.set_callback(1, max, (0, 0, 0))), "index is 1"),
    ("set_callback", "NULL", (make_solid, lambda c: c.set_callback(0, max)), "origin is null"),
    ("set_callback", "VALUE", (make_solid, lambda c: c.set_callback(0, max, (0, 0, 0), -1)), "friction is -1"),
    ("set_collider_velocity", "VALUE", (make_solid, lambda c: c.set_collider_velocity(0, (0, NAN, 0))), "nan"),
    ("remove_collider", "RANGE", (make_solid, lambda c: c.remove_collider(1)), "index is 1"),
    ("get_collider", "RANGE", (make_solid, lambda c: c.get_collider(1)), "index is 1"),
    ("set_collider_velocity", "RANGE", (make_solid, lambda c: c.set_collider_velocity(0, (0, 1))), "count is 2"),
    ("set_plane", "VALUE", (make_solid, lambda c: c.set_plane(0, (0, 0, 0), (0, 1, 0), -1)), "friction is -1"),
    ("set_capsule", "RANGE", (make_solid, lambda c: c.set_capsule(0, (0, 0), (0, 1), 1)), "count is 2"),
    ("set_capsule", "VALUE", (make_solid, lambda c: c.set_capsule(0, (0, 0, 0), (0, 1, 0), 1, NAN)), "friction is"),
    ("set_thickness", "VALUE", (make_rope, setting("thickness", -1)), "radius is -1"),
    ("set_thickness", "UNSUPPORTED", setting("thickness", 1), "only ropes"),
    ("set_loads", "VALUE", setting("loads", 2), "loads is 2"),
    ("set_loads", "UNSUPPORTED", setting("loads", True), "only ropes"),
    ("set_loads", "MEMORY", hungry(setting("loads", True), make_solid), "memory"),
    ("get_collider_load", "DISABLED", (make_solid, lambda c: c.get_collider_load(0)), "cd_chain_set_loads"),
    ("get_collider_load", "RANGE", (make_solid, lambda c: c.get_collider_load(1)), "index is 1"),
    ("get_reaction", "RANGE", (make_rope, lambda c: c.get_reaction(2, 0)), "strand is 2"),
    ("get_reaction", "RANGE", (make_rope, lambda c: c.get_reaction(0, 6)), "node is 6"),
    ("get_reaction", "UNSUPPORTED", lambda c: c.get_reaction(0, 0), "only ropes"),
    *(("set_air", "VALUE", (make_rope, setting("air", (x, 1))), "along is") for x in BAD_NUMBERS),
    ("set_air", "VALUE", (make_rope, setting("air", (1, -1))), "across is -1"),
    ("set_air", "UNSUPPORTED", setting("air", (1, 1)), "ropes"),
    ("set_air", "MEMORY", hungry(setting("air", (1, 1)), make_rope), "memory"),
    ("set_wind", "VALUE", (make_rope, setting("wind", (0, INF, 0))), "inf"),
    ("set_wind", "RANGE", (make_rope, setting("wind", (0, 0))), "2"),
    ("set_wind", "UNSUPPORTED", setting("wind", (0, 0, 0)), "ropes"),
    *(("set_tolerance", "VALUE", setting("tolerance", (x, 10)), "tolerance is") for x in (NAN, 0, 1e-15, 0.6, INF)),
    ("set_tolerance", "VALUE", setting("tolerance", (1e-6, 0)), "most_iterations is 0"),
    ("enable_field", "ENUM", lambda c: c.enable_field(99), "field is 99"),
    ("enable_field", "UNSUPPORTED", lambda c: c.enable_field(Field.REST_LENGTH), "CD_REST_LENGTH"),
    ("enable_field", "ENUM", lambda c: c.enable_field(Field.DEPTH), "field"),
    ("enable_field", "MEMORY", hungry(lambda c: c.enable_field(Field.FORCE)), "memory"),
    ("disable_field", "ENUM", lambda c: c.disable_field(99), "field is 99"),
    ("disable_field", "UNSUPPORTED", lambda c: c.disable_field(Field.PIN), "CD_PIN"),
    ("disable_field", "UNSUPPORTED", (make_rope, lambda c: c.disable_field(Field.TENSION)), "CD_TENSION"),
    ("disable_field", "UNSUPPORTED", (make_rope, lambda c: c.disable_field(Field.STRAIN)), "CD_STRAIN"),
    ("disable_field", "UNSUPPORTED", (make_fragile, lambda c: c.disable_field(Field.STIFFNESS)), "CD_STIFFNESS"),
    ("write_f64", "UNSUPPORTED", (make_rope, lambda c: c.write(Field.STRAIN, 0)), "CD_STRAIN"),
    ("write_f64", "VALUE", (make_fragile, lambda c: c.write(Field.STRENGTH, [0], 0, 1, 0, 1)), r"values\[0\] is 0"),
    ("write_f64", "ENUM", lambda c: c.write(Field.DEPTH, 1), "field"),
    ("write_f64", "DISABLED", lambda c: c.write(Field.FORCE, 1), "CD_FORCE"),
    ("write_f64", "RANGE", lambda c: c.write(Field.POSITION, 1, first=5, n=2), r"\[5, 7\) of 6"),
    ("write_f64", "RANGE", lambda c: c.write(Field.POSITION, 1, first_strand=3), "strands"),
    ("write_f64", "RANGE", lambda c: c.write(Field.POSITION, [1.0, 2.0]), r"\(2,\)"),
    ("write_f64", "RANGE", lambda c: c.write(Field.POSITION, 1, first=-1), "-1"),
    ("write_f64", "VALUE", lambda c: c.write(Field.POSITION, [0, 1, NAN], 0, 1, 0, 1), r"values\[2\] is"),
    ("write_f64", "VALUE", lambda c: c.write(Field.PIN, 5), r"values\[0\] is 5"),
    ("write_f64", "UNSUPPORTED", (lambda c: c.weld(0, 2), pin_two), "held"),
    ("write_f64", "VALUE", (make_rope, lambda c: c.write(Field.TENSION, NAN)), r"values\[0\] is"),
    ("write_f64", "RANGE", (make_rope, lambda c: c.write(Field.TENSION, 1, first=5, n=1)), "of 5"),
    ("read_f64", "ENUM", lambda c: c.read(-5), "field is -5"),
    ("read_f64", "UNSUPPORTED", lambda c: c.read(Field.TENSION), "CD_TENSION"),
    ("read_f64", "DISABLED", lambda c: c.read(Field.BEND), "CD_BEND"),
    ("read_f64", "RANGE", lambda c: c.read(Field.PIN, first=7), "of 6"),
    ("read_f64", "RANGE", lambda c: c.read(Field.POSITION, strands=-1), "-1"),
    ("view", "ENUM", lambda c: c.view(99), "field is 99"),
    ("view", "DISABLED", lambda c: c.view(Field.TARGET), "CD_TARGET"),
    ("view", "UNSUPPORTED", lambda c: c.view(Field.PIN), "CD_PIN"),
    ("impulse", "RANGE", lambda c: c.impulse(2, 0, (0, 0, 0)), "strand is 2"),
    ("impulse", "RANGE", lambda c: c.impulse(0, 6, (0, 0, 0)), "node is 6"),
    ("impulse", "RANGE", lambda c: c.impulse(0, 0, (0, 0)), "2"),
    ("impulse", "VALUE", lambda c: c.impulse(0, 0, (0, INF, 0)), "inf"),
    ("teleport", "RANGE", lambda c: c.teleport(2, None, (0, 0, 0)), "strand is 2"),
    ("teleport", "RANGE", lambda c: c.teleport(0, None, (0, 0)), "2"),
    ("teleport", "RANGE", lambda c: c.teleport(0, [[1, 0], [0, 1]], (0, 0, 0)), r"\(2, 2\)"),
    ("teleport", "VALUE", lambda c: c.teleport(0, None, (0, NAN, 0)), "nan"),
    ("teleport", "VALUE", lambda c: c.teleport(0, [[1, 0, 0], [0, 1, 0], [0, 1, 1]], (0, 0, 0)), "rotation"),
    ("teleport", "VALUE", lambda c: c.teleport(0, 1, (0, 0, 0)), "rotation"),
    ("attach", "RANGE", lambda c: c.attach(0, 6, 1, 1), "node is 6"),
    ("attach", "RANGE", lambda c: c.attach(0, 0, 1, 1, (1, 2)), "2"),
    ("attach", "VALUE", lambda c: c.attach(0, 0, -1, 1), "stiffness is -1"),
    ("attach", "VALUE", lambda c: c.attach(0, 0, 1, NAN), "damping is"),
    ("attach", "VALUE", lambda c: c.attach(0, 0, 1, 1, (1, NAN, 2)), "nan"),
    ("attach", "MEMORY", hungry(lambda c: c.attach(0, 0, 1, 1)), "memory"),
    ("detach", "RANGE", lambda c: c.detach(0, 6), "node is 6"),
    ("get_attachment", "RANGE", lambda c: c.get_attachment(0, 6), "node is 6"),
    ("cut", "RANGE", lambda c: c.cut(0, 5), "spring is 5"),
    ("cut", "MEMORY", hungry(lambda c: c.cut(0, 0)), "memory"),
    ("weld", "RANGE", lambda c: c.weld(0, 5), "spring is 5"),
    ("weld", "MEMORY", hungry(lambda c: c.weld(0, 0)), "memory"),
    ("weld", "UNSUPPORTED", (pin_two, lambda c: c.weld(0, 2)), "held"),
    *(("step", "VALUE", lambda c, x=x: c.step(x), "dt is") for x in (-1, NAN, INF, 1e31, 1e-31)),
    *(("step", "UNSUPPORTED", (lambda c, change=change: (make_rope(c), change(c)), lambda c: c.step(0.01)), "length")
      for change in (setting("method", Method.SYMPLECTIC_EULER), setting("lambda_", 0.4),
                     setting("ring", True), setting("stiffness_damping", 0.1),
                     lambda c: c.set_end(End.LAST, Node.MATCHED))),
    ("step", "RANGE", lambda c: c.step(0.01, -1), "count is -1"),
    ("step", "RANGE", lambda c: c.step(0.01, 2**64), "count is 18446744073709551616"),
    ("stable_dt", "UNSUPPORTED", (make_rope, lambda c: c.stable_dt()), "length"),
    ("sample", "RANGE", lambda c: c.sample(2, [0]), "strand is 2"),
    ("sample", "VALUE", lambda c: c.sample(0, [5.5]), "5.5"),
    ("sample", "VALUE", lambda c: c.sample(0, [0, NAN]), "nan"),
    ("sample", "ENUM", lambda c: c.sample(0, [0], 7), "outside is 7"),
    ("load", "FORMAT", lambda c: c.load(b"not a chain"), "11 of them"),
    ("load", "FORMAT", lambda c: c.load(contdyn.Water(1, 1, 1, 1).save()), "chain"),
    ("load", "MISMATCH", lambda c: c.load(Chain(2, 6, 3).save()), "6"),
    ("load", "MISMATCH", lambda c: c.load(Chain(2, 5, 3, Precision.FLOAT32).save()), "precision 0"),
    ("copy_state", "MISMATCH", lambda c: c.copy_state(Chain(2, 4, 3)), "4"),
]

# The same of membranes, for what is cloth's.
OF_CLOTH = [
    *(("set_rest_length", "VALUE", setting("rest_length", (x, 1)), "along_u is") for x in (*BAD_NUMBERS, 1e-61)),
    *(("set_rest_length", "VALUE", setting("rest_length", (1, x)), "along_v is") for x in (*BAD_NUMBERS, 1e-61)),
    ("set_rest_length", "VALUE", setting("rest_length", (1, 0)), "along"),
    ("set_rest_length", "UNSUPPORTED", lambda m: setattr(Membrane(2, 2, 2), "rest_length", (1, 1)), "2 components"),
    ("set_rest_length", "UNSUPPORTED", lambda m: setattr(Membrane(2, 0, 3), "rest_length", (1, 1)), "0 springs"),
    ("set_rest_length", "MEMORY", hungry(lengthen), "memory"),
    *(("set_shear", "VALUE", (lengthen, setting("shear", x)), "stiffness is") for x in BAD_NUMBERS),
    ("set_shear", "UNSUPPORTED", setting("shear", 1), "cloth"),
    *(("set_compression", "VALUE", (lengthen, setting("compression", x)), "rate is") for x in BAD_NUMBERS),
    ("set_compression", "UNSUPPORTED", setting("compression", 1), "cloth"),
    *(("set_sleep", "VALUE", setting("sleep", (x, 1)), "speed is") for x in BAD_NUMBERS),
    ("set_sleep", "VALUE", setting("sleep", (1, 0)), "seconds is 0"),
    ("set_sleep", "MEMORY", hungry(setting("sleep", (1, 1))), "memory"),
    *(("set_breaking_strain", "VALUE", (lengthen, setting("breaking_strain", x)), "strain is")
      for x in (NAN, -INF, -1, 0, 1e300)),
    ("set_breaking_strain", "UNSUPPORTED", setting("breaking_strain", 1), "cloth"),
    ("set_breaking_strain", "MEMORY", hungry(setting("breaking_strain", 1), lengthen), "memory"),
    *(("set_effort", "VALUE", (lengthen, setting("effort", (x, 1))), f"newton is {x}") for x in (0, 1001)),
    *(("set_effort", "VALUE", (lengthen, setting("effort", (1, x))), f"gradient is {x}") for x in (10001, 2**63)),
    ("set_effort", "UNSUPPORTED", setting("effort", (2, 2)), "cloth"),
    *(("set_air", "VALUE", (lengthen, setting("air", (x, 1))), "along is") for x in BAD_NUMBERS),
    ("set_air", "VALUE", (lengthen, setting("air", (1, -1))), "across is -1"),
    ("set_air", "UNSUPPORTED", setting("air", (1, 1)), "cloth"),
    ("set_air", "MEMORY", hungry(setting("air", (1, 1)), lengthen), "memory"),
    ("set_wind", "VALUE", (lengthen, setting("wind", (0, INF, 0))), "inf"),
    ("set_wind", "RANGE", (lengthen, setting("wind", (0, 0))), "2"),
    ("set_wind", "UNSUPPORTED", setting("wind", (0, 0, 0)), "cloth"),
    ("set_colliders", "VALUE", (lengthen, setting("colliders", 4097)), "count is 4097"),
    ("set_colliders", "UNSUPPORTED", setting("colliders", 1), "cloth"),
    ("set_colliders", "MEMORY", hungry(setting("colliders", 1), lengthen), "memory"),
    ("set_plane", "RANGE", (lengthen, lambda m: m.set_plane(0, (0, 0, 0), (0, 1, 0))), "index is 0"),
    ("set_plane", "VALUE", (make_solid_cloth, lambda m: m.set_plane(0, (0, 0, 0), (0, 0, 0))), "normal"),
    ("set_plane", "RANGE", (make_solid_cloth, lambda m: m.set_plane(0, (0, 0), (0, 0))), "count is 2"),
    ("set_plane", "VALUE", (make_solid_cloth, lambda m: m.set_plane(0, (0, 0, 0), (0, 1, 0), -1)), "friction is -1"),
    ("set_capsule", "VALUE", (make_solid_cloth, lambda m: m.set_capsule(0, (0, 0, 0), (0, NAN, 0), 1)), "nan"),
    ("set_capsule", "VALUE", (make_solid_cloth, lambda m: m.set_capsule(0, (0, 0, 0), (0, 1, 0), 0)), "radius is 0"),
    ("set_bed", "VALUE", (make_solid_cloth, lambda m: m.set_bed(0, (0, 0, 0), 1, 2, 1, 1, [0] * 2)), "columns is 1"),
    ("set_bed", "VALUE", (make_solid_cloth, lambda m: m.set_bed(0, (0, 0, 0), 2, 2, 1, 0, [0] * 4)),
     "row_spacing is 0"),
    ("set_bed", "VALUE", (make_solid_cloth, lambda m: m.set_bed(0, (0, 0, 0), 2, 2, 1, 1, [0, 0, 0, NAN])), "heights"),
    ("set_bed", "RANGE", (make_solid_cloth, lambda m: m.set_bed(1, (0, 0, 0), 2, 2, 1, 1, [0] * 4)), "index is 1"),
    ("set_bed", "RANGE", (make_solid_cloth, lambda m: m.set_bed(0, (0, 0), 2, 2, 1, 1, [0] * 4)), "count is 2"),
    ("get_bed", "RANGE", (make_solid_cloth, lambda m: m.get_bed(1)), "index is 1"),
    ("set_callback", "RANGE", (make_solid_cloth, lambda m: m.set_callback(1, max, (0, 0, 0))), "index is 1"),
    ("set_callback", "NULL", (make_solid_cloth, lambda m: m.set_callback(0, max)), "origin is null"),
    ("set_callback", "VALUE", (make_solid_cloth, lambda m: m.set_callback(0, max, (0, 0, 0), -1)), "friction is -1"),
    ("set_collider_velocity", "VALUE", (make_solid_cloth, lambda m: m.set_collider_velocity(0, (0, NAN, 0))), "nan"),
    ("set_collider_velocity", "RANGE", (make_solid_cloth, lambda m: m.set_collider_velocity(0, (0, 1))), "count is 2"),
    ("remove_collider", "RANGE", (make_solid_cloth, lambda m: m.remove_collider(1)), "index is 1"),
    ("get_collider", "RANGE", (make_solid_cloth, lambda m: m.get_collider(1)), "index is 1"),
    ("set_thickness", "VALUE", (lengthen, setting("thickness", -1)), "distance is -1"),
    ("set_thickness", "UNSUPPORTED", setting("thickness", 1), "cloth"),
    ("set_loads", "VALUE", setting("loads", 2), "loads is 2"),
    ("set_loads", "UNSUPPORTED", setting("loads", True), "cloth"),
    ("set_loads", "MEMORY", hungry(setting("loads", True), make_solid_cloth), "memory"),
    ("get_collider_load", "DISABLED", (make_solid_cloth, lambda m: m.get_collider_load(0)), "cd_membrane_set_loads"),
    ("get_collider_load", "RANGE", (make_solid_cloth, lambda m: m.get_collider_load(1)), "index is 1"),
    ("enable_field", "UNSUPPORTED", lambda m: m.enable_field(Field.REST_LENGTH_U), "CD_REST_LENGTH_U"),
    ("enable_field", "ENUM", lambda m: m.enable_field(Field.TENSION), "field"),
    ("disable_field", "UNSUPPORTED", (lengthen, lambda m: m.disable_field(Field.STRAIN_U)), "CD_STRAIN_U"),
    ("disable_field", "UNSUPPORTED", (lambda m: (lengthen(m), m.enable_field(Field.BREAKING_STRAIN_V)),
                                      lambda m: m.disable_field(Field.STIFFNESS_V)), "CD_STIFFNESS_V"),
    ("write_f64", "VALUE", (lambda m: (lengthen(m), m.enable_field(Field.BREAKING_STRAIN_V)),
                            lambda m: m.write(Field.BREAKING_STRAIN_V, 0)), r"values\[0\] is 0"),
    ("write_f64", "UNSUPPORTED", (lengthen, lambda m: m.write(Field.TENSION_V, 0)), "CD_TENSION_V"),
    ("write_f64", "DISABLED", (lengthen, lambda m: m.write(Field.REST_LENGTH_V, 1)), "CD_REST_LENGTH_V"),
    ("write_f64", "VALUE", (lambda m: (lengthen(m), m.enable_field(Field.REST_LENGTH_V)),
                            lambda m: m.write(Field.REST_LENGTH_V, 0)), r"values\[0\] is 0"),
    ("read_f64", "UNSUPPORTED", lambda m: m.read(Field.STRAIN_V), "CD_STRAIN_V"),
    *(("step", "UNSUPPORTED", (lambda m, change=change: (lengthen(m), change(m)), lambda m: m.step(0.01)), "length")
      for change in (setting("method", Method.SYMPLECTIC_EULER), setting("lambda_", 0.4),
                     setting("stiffness_damping", 0.1), lambda m: m.set_edge(Edge.U_LAST, Node.MATCHED))),
]

# Listed in the comments, and not to be had from Python.
NOT_TO_BE_HAD = {
    ("create", "UNSUPPORTED"): "for a precision that the build leaves out; this one has both",
    ("set_kernels", "UNSUPPORTED"): "for kernels that the processor does not run; there may be none",
    ("save", "RANGE"): "save makes a buffer of the right size",
    ("set_push", "TOLERANCE"): "what a step may end with",
    ("set_callback", "CALLBACK"): "likewise",
    ("get_gravity", "RANGE"): "the count is always that of the components",
    ("get_wind", "RANGE"): "likewise",
    ("get_momentum", "RANGE"): "likewise",
}


def listed():
    """(functions that share a comment, error) as the comments of chain.h list them."""
    groups = {}
    for function in api()["functions"]:
        if function["object"] == "chain":
            groups.setdefault(function["doc"] or function["name"], []).append(function["short"])
    for doc, shorts in groups.items():
        for error in set(re.findall(r"CD_ERROR_([A-Z]+)", doc)):
            yield shorts, error


class Errors(unittest.TestCase):
    def test_each_failure_has_its_exception_and_message_and_changes_nothing(self):
        for kind, cases in ((Chain, CASES), (Membrane, OF_CLOTH)):
            for k, (function, error, use, message) in enumerate(cases):
                with self.subTest(k, kind=kind.__name__, function=function, error=error, message=message):
                    made = moving(kind)
                    if isinstance(use, tuple):
                        prepare, use = use
                        prepare(made)
                    before = made.hash()
                    with self.assertRaisesRegex(contdyn.Error, message) as caught:
                        use(made)
                    self.assertEqual(caught.exception.status, contdyn.Status["ERROR_" + error])
                    self.assertEqual(made.hash(), before)

    def test_messages_name_the_function(self):
        with self.assertRaisesRegex(contdyn.InvalidValueError, "^cd_chain_set_mass: mass is -2"):
            moving(Chain).mass = -2

    def test_every_error_that_the_header_lists_is_here(self):
        tried = {(function, error) for function, error, _, _ in CASES}
        tried |= {(function, "DIVERGED") for function in (
            "step", "set_end", "teleport", "attach", "enable_field", "impulse", "splash", "add_volume",
            "add_volume_rectangle")}
        tried |= {("load", "MEMORY"), ("copy_state", "MEMORY"), ("step", "TOLERANCE"), ("step", "CALLBACK")}
        for shorts, error in listed():
            if error in ("NULL",):  # no null pointer is passed from Python
                continue
            here = {(short, error) for short in shorts}
            with self.subTest(functions=shorts, error=error):
                self.assertTrue(here & (tried | set(NOT_TO_BE_HAD)))

    def test_divergence_is_told_and_can_be_left(self):
        chain = moving(Chain)
        with self.assertRaises(contdyn.DivergedError) as caught:
            diverge(chain)
        self.assertIsInstance(caught.exception, ArithmeticError)
        self.assertEqual(chain.steps, 103)
        chain.read(Field.POSITION)
        for use in (lambda: chain.step(0.01), lambda: chain.teleport(0, None, (1, 1, 1)),
                    lambda: chain.set_end(End.LAST, Node.POSED), lambda: chain.attach(0, 1, 1, 1),
                    lambda: chain.enable_field(Field.TARGET), lambda: chain.impulse(0, 1, (1, 1, 1))):
            with self.assertRaises(contdyn.DivergedError):
                use()
        chain.reset()
        chain.step(0.01)
        pool = moving(Water, Precision.FLOAT32)
        pool.enable_field(Field.SOURCE)
        pool.write(Field.SOURCE, 1e37)
        for use in (lambda: pool.step(8, 10), lambda: pool.impulse(1, 1, 1, 1, 1), lambda: pool.splash(1, 1, 1, 1),
                    lambda: pool.add_volume(1, 1, 1, 1), lambda: pool.add_volume_rectangle(0, 0, 1, 1, 1)):
            with self.assertRaises(contdyn.DivergedError):
                use()

    def test_no_memory_for_what_is_loaded(self):
        source = moving(Chain)
        source.enable_field(Field.FORCE)
        for use in (lambda chain: chain.load(source.save()), lambda chain: chain.copy_state(source)):
            heap = Heap()
            chain = moving(Chain, allocator=heap)
            before, heap.most = chain.hash(), heap.given
            with self.assertRaises(contdyn.OutOfMemoryError):
                use(chain)
            self.assertEqual(chain.hash(), before)

    def test_an_unreached_tolerance_is_told(self):
        sheet = contdyn.Membrane(16, 16, 1)
        sheet.solver, sheet.stiffness, sheet.tolerance = contdyn.Solver.COUPLED, (1e6, 1e3), (1e-14, 1)
        sheet.impulse(3, 5, 2, [1])
        with self.assertRaises(contdyn.ToleranceError):
            sheet.step(1)
        self.assertEqual(sheet.steps, 1)
        self.assertGreater(sheet.convergence.residual, 1e-14)
        rope = contdyn.Chain(1, 20, 2)
        rope.position = [[0.05 * i, 0] for i in range(21)]
        rope.rest_length, rope.stiffness, rope.gravity, rope.tolerance = 1, math.inf, (0, -9.81), (1e-14, 1)
        rope.set_end(contdyn.End.FIRST, contdyn.Node.PINNED)
        with self.assertRaises(contdyn.ToleranceError):
            rope.step(0.5, 3)
        self.assertEqual(rope.steps, 3)
        self.assertGreater(rope.convergence.residual, 1e-14)

    def test_wrong_types(self):
        chain = moving(Chain)
        for use in (lambda: setattr(chain, "mass", "1"), lambda: setattr(chain, "mass", None), lambda: chain.step("1"),
                    lambda: chain.step(0.01, 1.5), lambda: chain.step(), lambda: chain.cut(0, 1.0),
                    lambda: chain.cut(0, "1"), lambda: chain.cut("0", 1),
                    lambda: setattr(chain, "gravity", "123"), lambda: chain.write(Field.POSITION, "abc"),
                    lambda: chain.write(Field.POSITION, b"abc"), lambda: chain.write(Field.POSITION, 1j),
                    lambda: chain.write("position", 1), lambda: chain.load(3), lambda: chain.load("text"),
                    lambda: chain.set_end("first", 1), lambda: Chain("1", 2, 3), lambda: Chain(1.0, 2, 3),
                    lambda: setattr(chain, "parallel", "many"), lambda: setattr(chain, "parallel", True)):
            before = chain.hash()
            with self.assertRaises(TypeError):
                use()
            self.assertEqual(chain.hash(), before)
        for use, told in ((lambda c: Chain("1", 2, 3), "cd_chain_create: strands is '1', must be an integer"),
                          (lambda c: Chain(1.5, 2, 3), "cd_chain_create: strands is 1.5, must be an integer"),
                          (setting("method", "implicit"), "cd_chain_set_method: method is 'implicit', must be an integer, an "
                           "enumerator or a bool, as Method.IMPLICIT is"),
                          (lambda c: contdyn.status_name("x"), "cd_status_name: status is 'x', must be an integer"),
                          (lambda c: contdyn.kernels_name(None), "cd_kernels_name: kernels is None, must be"),
                          (setting("mass", "1"), "cd_chain_set_mass: mass is '1', must be a number"),
                          (lambda c: c.step(0.1, "1"), "cd_chain_step: count is '1', must be an integer"),
                          (lambda c: c.read(Field.POSITION, first="a"), "places from 'a' on")):
            with self.subTest(told), self.assertRaisesRegex(TypeError, re.escape(told)):
                use(chain)
        for use in (lambda: setattr(contdyn.Membrane(2, 2, 1), "stiffness", 1), lambda: chain.read("position"),
                    lambda: setattr(contdyn.Membrane(2, 2, 1), "stiffness", (1, 2, 3))):
            with self.assertRaises(TypeError):
                use()

        with self.assertRaisesRegex(contdyn.RangeError, "kernels is 4294967296, must be in"):
            contdyn.kernels_name(2**32)

    def test_numbers_that_no_float_holds_are_values_out_of_range(self):
        chain = moving(Chain)
        before = chain.hash()
        for huge, told in ((10**400, "10000"), (-10**5000, "an int of"), (Fraction(10**400), "Fraction")):
            for use in (setting("mass", huge), lambda c: c.step(huge), setting("gravity", (0, huge)),
                        setting("position", huge), lambda c: c.write(Field.POSITION, [0, huge], n=1),
                        lambda c: c.impulse(0, 0, [huge, 0])):
                with self.subTest(told), self.assertRaisesRegex(contdyn.InvalidValueError, f" is {told}.* beyond"):
                    use(chain)
        with self.assertRaisesRegex(contdyn.RangeError, "count is an int of thousands of digits, must be in"):
            chain.step(0.01, 10**5000)
        self.assertEqual(chain.hash(), before)
        chain.position = 2**70  # beyond 64 bits, and a float
        self.assertEqual(chain.position[0, 0, 0], 2.0**70)

    def test_what_was_left_out_of_the_library_is_named(self):
        class Bridge(Chain):
            _c = Functions("cd_bridge_")  # which no build has

        with self.assertRaisesRegex(contdyn.UnsupportedError, "^cd_bridge_create: this build"):
            Bridge(1, 2, 3)

    def test_settings_of_several_values_name_them(self):
        for made, name, value, names in ((Membrane(2, 2, 3), "stiffness", 5, "2 values, (along_u, along_v)"),
                                         (Membrane(2, 2, 3), "rest_length", 1, "2 values, (along_u, along_v)"),
                                         (Membrane(2, 2, 3), "ring", None, "2 values, (along_u, along_v)"),
                                         (moving(Chain), "air", (1, 2, 3), "2 values, (along, across)"),
                                         (Water(2, 2, 1, 1), "hulls", 2, "3 values, (count, n_along, n_across)")):
            before = made.hash()
            with self.subTest(name), self.assertRaises(TypeError) as caught:
                setattr(made, name, value)
            self.assertEqual(str(caught.exception), f"{name} takes {names}, not {value!r}")
            self.assertEqual(made.hash(), before)


if __name__ == "__main__":
    unittest.main()
