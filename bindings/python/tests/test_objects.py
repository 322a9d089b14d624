"""What each function does to its object, seen through the others."""
import copy
import math
import unittest
from array import array

import contdyn
from contdyn import (BedRule, Border, Chain, Edge, End, Field, MassRule, Membrane, Method, Momentum, Node, Outside,
                     Precision, Shape, Side, Solver, Water)

from support import KINDS, lengthen, make, moving


def close(test, found, expected, digits=12):
    test.assertEqual(len(found), len(expected))
    for one, other in zip(found, expected):
        test.assertAlmostEqual(one, other, digits)


class Everyone(unittest.TestCase):
    def test_parameters_come_back(self):
        shared = {"method": Method.SYMPLECTIC_EULER, "lambda_": 0.75, "drag": 0.5}
        body = {"mass": 2.5, "mass_rule": MassRule.HALF_ENDS, "bend": 0.25, "stiffness_damping": 0.125,
                "gravity": (1.0, 2.0, 3.0), "sleep": (0.25, 0.5)}
        own = {
            Chain: {**body, "stiffness": 3.0, "ring": True, "rest_length": 2.0, "push": True, "tolerance": (1e-4, 7),
                    "air": (0.5, 2.0), "wind": (1.0, -2.0, 3.0), "strength": 5.0, "colliders": 3,
                    "thickness": 0.25, "loads": True, "rest_angle": -2.5},
            Membrane: {**body, "stiffness": (3.0, 4.0), "ring": (True, False), "solver": Solver.COUPLED,
                       "tolerance": (1e-4, 7), "pressure": 0.5, "rest_length": (2.0, 3.0), "shear": 100.0,
                       "compression": 3.25, "effort": (3, 20), "air": (0.5, 2.0), "wind": (1.0, -2.0, 3.0),
                       "colliders": 3, "thickness": 0.25, "loads": True, "breaking_strain": 0.5},
            Water: {"momentum": Momentum.ADVECTED, "first": 1, "gravity": 1.5, "density": 900.0, "manning": 0.03,
                    "bed_rule": BedRule.KEEPS_SURFACE, "sleep": 0.125},
        }
        for kind in KINDS.values():
            for name, value in {**shared, **own[kind]}.items():
                with self.subTest(kind.__name__, parameter=name):
                    made = make(kind)
                    if name == "rest_angle":
                        made = Chain(2, 5, 2)
                    if name in ("rest_angle", "air", "wind", "strength", "colliders", "thickness", "loads", "shear",
                                "compression", "effort", "breaking_strain"):
                        lengthen(made)  # only ropes and cloth have it
                    self.assertNotEqual(getattr(made, name), value)
                    setattr(made, name, value)
                    self.assertEqual(getattr(made, name), value)
                    self.assertIs(type(getattr(made, name)), type(getattr(make(kind), name)))

    def test_time_steps_and_factorizations(self):
        for kind in KINDS.values():
            made = make(kind)
            if kind is Water:
                made.depth = 1
            made.step(0.25)
            made.step(0.25, 3)
            made.step(0.25, count=0)
            self.assertEqual((made.time, made.steps), (1.0, 4))
            self.assertGreaterEqual(made.factorizations, 1)
            self.assertGreater(made.memory, 0)

    def test_stable_dt_is_the_limit(self):
        for kind in (Chain, Membrane):
            made = moving(kind)
            made.method = Method.SYMPLECTIC_EULER
            dt = made.stable_dt()
            before = sum(made.energy)
            made.step(0.9 * dt, 500)
            self.assertLess(sum(made.energy), 100 * before)
            made.step(1.2 * dt, 500)
            self.assertGreater(sum(made.energy), 1e6 * before)
        self.assertEqual(Chain(1, 0, 1).stable_dt(), math.inf)
        self.assertGreater(moving(Water).stable_dt(), 0)

    def test_fields_take_memory_only_while_they_are_on(self):
        for kind, field in ((Chain, Field.FORCE), (Membrane, Field.MASK), (Water, Field.SOURCE)):
            made = make(kind)
            if kind is Membrane:
                made.solver = Solver.ALTERNATING  # coupled, a sheet with a mask may take less
            before = made.memory
            made.enable_field(field)
            self.assertGreater(made.memory, before)
            made.disable_field(field)
            self.assertEqual(made.memory, before)


class Chains(unittest.TestCase):
    def setUp(self):
        self.chain = Chain(1, 4, 2)
        self.chain.position = [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0]]

    def test_energy_and_momentum(self):
        chain = self.chain
        chain.velocity = [1, 2] * 5
        chain.gravity = (0, -10)
        close(self, chain.energy, (2.5, 0.5 * 4 * 4, 0))
        close(self, chain.momentum, (1, 2))

    def test_impulse(self):
        self.chain.impulse(0, 1, [0.1, 0.2])
        close(self, self.chain.velocity[0, 1].tolist(), (0.5, 1.0))
        self.chain.impulse(0, 1, array("d", [0.1, 0.2]))
        close(self, self.chain.velocity[0, 1].tolist(), (1.0, 2.0))

    def test_attachments(self):
        self.chain.attach(0, 2, 30, 0.5)
        self.assertEqual(self.chain.target.tolist()[0][2], [2, 0])
        self.chain.attach(0, 3, 40, 0, (7, 8))
        self.assertEqual(self.chain.target.tolist()[0][3], [7, 8])
        self.assertEqual(self.chain.get_attachment(0, 2), (30, 0.5))
        self.assertEqual(self.chain.get_attachment(0, 3).stiffness, 40)
        self.chain.detach(0, 2)
        self.assertEqual(self.chain.get_attachment(0, 2), (0, 0))

    def test_cut_and_weld(self):
        self.chain.cut(0, 1)
        self.chain.weld(0, 3)
        self.assertEqual(self.chain.read(Field.STIFFNESS).tolist(), [4, 0, 4, math.inf])

    def test_ends(self):
        self.chain.set_end(End.FIRST, Node.PINNED)
        self.chain.set_end(End.LAST, Node.DRIVEN)
        self.assertIs(self.chain.get_end(End.FIRST), Node.PINNED)
        self.assertEqual(self.chain.read(Field.PIN).tolist(), [1, 0, 0, 0, 2])
        self.chain.write(Field.VELOCITY, [0, 3], 0, 1, 4, 1)
        self.chain.step(1)
        close(self, self.chain.position[0, 4].tolist(), (4, 3))

    def test_a_rope_keeps_its_length_and_tells_its_tensions(self):
        rope = Chain(2, 4, 3)
        rope.position = [[[0, 0, -i / 4] for i in range(5)]] * 2
        rope.rest_length, rope.stiffness, rope.gravity = 1, math.inf, (0, 0, -10)
        rope.set_end(End.FIRST, Node.PINNED)
        self.assertEqual(rope.read(Field.TENSION).shape, (2, 4))
        rope.step(1 / 60, 60)
        self.assertLessEqual(rope.convergence.residual, rope.tolerance.tolerance)
        self.assertGreater(rope.convergence.iterations, 0)
        for tensions in rope.read(Field.TENSION).tolist():
            close(self, tensions, (8, 6, 4, 2), 5)  # what hangs below
        close(self, rope.position[1, 4].tolist(), (0, 0, -1), 5)
        rope.enable_field(Field.REST_LENGTH)
        rope.write(Field.REST_LENGTH, [[0.5, 0.25, 0.25, 0.25]], strands=1)  # of the first strand
        rope.step(1 / 60, 60)
        for strand, length in ((0, 0.5), (1, 0.25)):
            first, second = rope.position[strand, :2].tolist()
            self.assertAlmostEqual(math.dist(first, second), length, 5)
        rope.write(Field.TENSION, [1, 2], first_strand=1, first=2, n=2)
        self.assertEqual(rope.read(Field.TENSION, 1, 1, 2, 2).tolist(), [[1, 2]])
        copy = Chain(2, 4, 3)
        copy.load(rope.save())
        self.assertEqual(copy.hash(), rope.hash())
        copy.write(Field.TENSION, 0)
        self.assertNotEqual(copy.hash(), rope.hash())
        rope.cut(1, 3)
        self.assertEqual(rope.read(Field.STIFFNESS).tolist(), [[math.inf] * 4, [math.inf] * 3 + [0]])
        rope.attach(1, 2, 30, 0.5)
        self.assertEqual((rope.get_attachment(0, 2).stiffness, rope.get_attachment(1, 2).stiffness), (0, 30))
        with self.assertRaisesRegex(contdyn.UnsupportedError, "strands differ"):
            rope.rest_length = 0
        rope.disable_field(Field.TARGET)
        rope.stiffness, rope.rest_length = 1, 0
        rope.step(1 / 60)
        self.assertEqual(rope.convergence, (0, 0))

    def test_a_rope_leans_with_the_wind(self):
        rope = Chain(2, 4, 3)
        rope.position = [[[0, 0, -i / 4] for i in range(5)]] * 2
        rope.rest_length, rope.stiffness, rope.gravity, rope.lambda_ = 1, math.inf, (0, 0, -10), 1
        rope.mass_rule = MassRule.HALF_ENDS
        rope.set_end(End.FIRST, Node.PINNED)
        rope.air, rope.wind = (0.5, 5), (2, 0, 0)
        rope.enable_field(Field.WIND)
        rope.write(Field.WIND, 0, first_strand=1)
        self.assertEqual(rope.read(Field.WIND).shape, (2, 5, 3))
        rope.step(0.1, 1000)
        slope = math.sqrt(0.5)  # as much wind as weight
        close(self, rope.position[0, 4].tolist(), (slope, 0, -slope), 6)
        close(self, rope.position[1, 4].tolist(), (0, 0, -1), 6)

    def test_a_rope_breaks_where_it_bears_too_much(self):
        rope = Chain(2, 4, 3)
        rope.position = [[[0, 0, -i / 4] for i in range(5)]] * 2
        rope.rest_length, rope.stiffness, rope.gravity = 1, 1e5, (0, 0, -10)
        rope.set_end(End.FIRST, Node.PINNED)
        rope.lambda_ = 1
        rope.step(0.1, 50)
        self.assertEqual(rope.broken, 0)
        close(self, rope.get_reaction(0, 0), (0, 0, -8), 6)  # what hangs at it
        close(self, rope.get_reaction(1, 4), (0, 0, 2), 6)
        strains = rope.read(Field.STRAIN)
        self.assertEqual(strains.shape, (2, 4))
        close(self, strains[1].tolist(), [t / 1e5 for t in (8, 6, 4, 2)], 9)
        blade = Chain(2, 3, 2)
        blade.rest_length, blade.rest_angle = 1, 0.5
        blade.enable_field(Field.REST_ANGLE)
        self.assertEqual(blade.read(Field.REST_ANGLE).tolist(), [[0.25] * 4] * 2)
        rope.strength = 100
        rope.enable_field(Field.STRENGTH)
        self.assertEqual(rope.read(Field.STRENGTH).tolist(), [[100] * 4] * 2)
        rope.write(Field.STRENGTH, [[7, 5, 100, 100]], 1, 1)
        rope.step(1 / 60)
        self.assertEqual(rope.broken, 1)  # of two that bear too much
        self.assertEqual(rope.read(Field.STIFFNESS).tolist(), [[4e5] * 4, [4e5, 0, 4e5, 4e5]])
        rope.step(1 / 60)
        self.assertEqual(rope.broken, 0)

    def test_a_rope_rests_on_what_it_touches(self):
        rope = Chain(1, 4, 3)
        rope.position = [[[i / 4, 0.5, 0] for i in range(5)]]
        rope.rest_length, rope.stiffness, rope.gravity = 1, math.inf, (0, -10, 0)
        rope.colliders, rope.thickness, rope.loads = 2, 0.125, True
        rope.set_plane(0, (0, -1, 0), (0, 2, 0), 0.5)
        rope.set_capsule(1, (3, 0, 0), (4, 0, 0), 0.5)
        rope.set_collider_velocity(0, (0, 0, 0.25))
        rope.step(1 / 60, 120)
        for node in range(5):
            self.assertAlmostEqual(rope.position[0, node, 1], -0.875, 5)
        force, moment = rope.get_collider_load(0)
        close(self, force, (0, -10, 0), 6)  # its weight, in its middle
        close(self, moment[2:], [-10 * sum(rope.position[0, :, 0]) / 5], 6)
        plane = rope.get_collider(0)
        self.assertEqual((plane.shape, plane.second, plane.friction), (Shape.PLANE, (0, 1, 0), 0.5))
        close(self, plane.first, (0, -1, 0.5))
        self.assertEqual(rope.get_collider(1), (Shape.CAPSULE, (3, 0, 0), (4, 0, 0), (0, 0, 0), 0.5, 0))
        rope.remove_collider(1)
        self.assertIs(rope.get_collider(1).shape, Shape.NONE)

    def test_a_rope_lies_on_a_bed(self):
        rope = Chain(1, 4, 3)
        rope.position = [[[i / 4, 0.5, 0.5] for i in range(5)]]
        rope.rest_length, rope.stiffness, rope.gravity = 1, math.inf, (0, 0, -10)
        rope.colliders = 2
        rope.set_bed(0, (-1, -1, -1), 4, 2, 1, 2, [[0.25, 0.25, 0.25, 0.25], [0.25, 0.25, 0.25, 0.25]], 0.5)
        self.assertEqual(rope.get_bed(0).tolist(), [[0.25] * 4] * 2)
        self.assertEqual(rope.get_bed(1).tolist(), [])
        self.assertEqual(rope.get_collider(0), (Shape.BED, (-1, -1, -1), (1, 2, 0), (0, 0, 0), 0, 0.5))
        rope.step(1 / 60, 120)
        for node in range(5):
            self.assertAlmostEqual(rope.position[0, node, 2], -0.75, 5)
        flat = Chain(1, 4, 2)
        flat.rest_length, flat.colliders = 1, 1
        flat.set_bed(0, (-1, -1), 3, 1, 0.5, 0, [0.5, 0.25, 0])
        self.assertEqual(flat.get_bed(0).tolist(), [[0.5, 0.25, 0]])
        cloth = Membrane(2, 2, 3)
        cloth.rest_length, cloth.colliders = (1, 1), 1
        cloth.set_bed(0, (0, 0, -1), 2, 2, 1, 1, array("d", (0, 1, 2, 3)))
        self.assertEqual(cloth.get_bed(0).tolist(), [[0, 1], [2, 3]])

    def test_a_function_may_be_what_a_rope_and_cloth_touch(self):
        asked = []

        def floor(time, positions):
            asked.append((time, tuple(positions.shape)))
            return [float(x[1]) + 1 for x in positions], [(0, 1, 0)] * len(positions)

        rope, cloth = Chain(1, 4, 3), Membrane(2, 2, 3)
        rope.position = [[[i / 4, 0.5, 0] for i in range(5)]]
        cloth.position = [[[u / 2, 0.5, v / 2] for u in range(3)] for v in range(3)]
        rope.rest_length, rope.stiffness, cloth.rest_length, cloth.lambda_ = 1, math.inf, (1, 1), 1
        for body, height in ((rope, -0.5), (cloth, -0.5)):
            body.gravity, body.colliders = (0, -10, 0), 1
            body.set_callback(0, floor, (0, 0.5, 0), 0.5)
            self.assertEqual(body.get_collider(0), (Shape.CALLBACK, (0, 0.5, 0), (0, 0, 0), (0, 0, 0), 0, 0.5))
            body.step(1 / 60, 120)
            self.assertAlmostEqual(float(body.position[0, 0, 1]), height, 3)
            self.assertAlmostEqual(asked[-1][0], 2, delta=0.1)
        self.assertIn((5, 3), [shape for _, shape in asked])
        self.assertEqual(asked[-1][1], (9, 3))
        copied = copy.copy(rope)
        with self.assertRaises(contdyn.UnsupportedError):
            copied.step(1 / 60)
        copied.set_callback(0, floor)
        copied.step(1 / 60)

        def forgetful(time, positions):
            raise KeyError("a place")

        rope.set_callback(0, forgetful)
        steps = rope.steps
        with self.assertRaises(contdyn.CallbackError) as caught:
            rope.step(1 / 60, 2)
        self.assertIsInstance(caught.exception.__cause__, KeyError)
        self.assertEqual(rope.steps, steps + 2)
        rope.set_callback(0, lambda time, positions: ([math.nan] * 5, [(0, 1, 0)] * 5))
        with self.assertRaises(contdyn.CallbackError) as caught:
            rope.step(1 / 60)
        self.assertIsNone(caught.exception.__cause__)
        with self.assertRaises(TypeError):
            rope.set_callback(0, 3)

    def test_a_posed_end_goes_to_its_target(self):
        for kind, hold in ((Chain, lambda made: made.set_end(End.FIRST, Node.POSED)),
                           (Membrane, lambda made: made.set_edge(Edge.U_FIRST, Node.POSED))):
            made = make(kind)
            made.gravity = (0, -10, 0)
            hold(made)
            made.write(Field.TARGET, [1, 2, 3], 0, 1, 0, 1) if kind is Chain else made.write(
                Field.TARGET, [1, 2, 3], 0, 0, 1, 1)
            made.step(0.1, 4)
            close(self, made.position[0, 0].tolist(), (1, 2, 3))
            made.step(0.1)
            close(self, made.position[0, 0].tolist(), (1, 2, 3))
        chain = make(Chain)
        chain.set_end(End.LAST, Node.POSED)
        self.assertIs(chain.get_end(End.LAST), Node.POSED)
        self.assertEqual(chain.target.tolist(), chain.position.tolist())

    def test_teleport(self):
        chain = moving(Chain)
        before, speeds = chain.position.tolist(), chain.velocity.tolist()
        chain.teleport(1, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], (10, 20, 30))
        for node in range(6):
            x, y, z = before[1][node]
            close(self, chain.position[1, node].tolist(), (10 - y, 20 + x, 30 + z))
            x, y, z = speeds[1][node]
            close(self, chain.velocity[1, node].tolist(), (-y, x, z))
        self.assertEqual(chain.position[0].tolist(), before[0])
        chain.teleport(0, None, (1, 2, 3))
        close(self, chain.position[0, 5].tolist(), [x + dx for x, dx in zip(before[0][5], (1, 2, 3))])
        self.assertEqual(chain.velocity[0].tolist(), speeds[0])
        chain.teleport(0, [1, 0, 0, 0, 1, 0, 0, 0, 1], array("d", [0, 0, 0]))  # in one row
        sheet = moving(Membrane)
        before = sheet.position.tolist()
        sheet.teleport([[0, 0, 1], [0, 1, 0], [-1, 0, 0]], (0, 0, 5))
        for v in range(4):
            for u in range(5):
                x, y, z = before[v][u]
                close(self, sheet.position[v, u].tolist(), (z, y, 5 - x))
        sheet.teleport(None, (0, 1, -5))
        x, y, z = before[3][4]
        close(self, sheet.position[3, 4].tolist(), (z, y + 1, -x))

    def test_links_that_push_do_not_go_slack(self):
        for push, length in ((False, 0.8), (True, 1)):
            rope = Chain(1, 4, 2)
            rope.position = [[0.2 * i, 0] for i in range(5)]
            rope.rest_length, rope.stiffness, rope.push = 1, math.inf, push
            rope.step(1 / 60, 10)
            ends = [rope.position[0, node].tolist() for node in (0, 4)]
            self.assertAlmostEqual(math.dist(*ends), length, 5)

    def test_sample(self):
        self.assertEqual(self.chain.sample(0, [0.5, 3.25]).tolist(), [[0.5, 0], [3.25, 0]])
        self.assertEqual(self.chain.sample(0, 2).tolist(), [[2, 0]])
        self.assertEqual(self.chain.sample(0, []).tolist(), [])
        self.assertEqual(self.chain.sample(0, [-1], Outside.NEAREST).tolist(), [[0, 0]])


class Membranes(unittest.TestCase):
    def setUp(self):
        self.sheet = Membrane(2, 3, 3)  # over [0, 2] x [0, 3]
        self.sheet.position = [[[u, v, 0] for u in range(3)] for v in range(4)]

    def test_sides_of_arrays(self):
        self.assertEqual(self.sheet.read(Field.POSITION, 1, 2, 1, 1).tolist(), [[[1, 2, 0]]])
        self.assertEqual(self.sheet.position[2, 1].tolist(), [1, 2, 0])
        self.assertEqual(self.sheet.sample([[0.5, 2.5], [2, 0]]).tolist(), [[0.5, 2.5, 0], [2, 0, 0]])
        with self.assertRaises(contdyn.RangeError):
            self.sheet.sample([1, 2, 3])

    def test_edges_and_mask(self):
        self.sheet.set_edge(Edge.U_FIRST, Node.PINNED)
        self.assertIs(self.sheet.get_edge(Edge.U_FIRST), Node.PINNED)
        self.sheet.enable_field(Field.PIN)
        self.assertEqual(self.sheet.read(Field.PIN).tolist(), [[1, 0, 0]] * 4)

    def test_impulse_energy_momentum(self):
        self.sheet.impulse(1, 1, 0, (0, 0, 0.5))
        close(self, self.sheet.momentum, (0, 0, 0.5))
        self.assertAlmostEqual(self.sheet.energy.kinetic, 0.5**2 * 12 / 2)

    def test_attachments(self):
        self.sheet.attach(2, 3, 10, 0.25, (1, 1, 1))
        self.assertEqual(self.sheet.get_attachment(2, 3), (10, 0.25))
        self.assertEqual(self.sheet.target[3, 2].tolist(), [1, 1, 1])
        self.sheet.attach(0, 1, 10, 0)
        self.assertEqual(self.sheet.target[1, 0].tolist(), [0, 1, 0])
        self.sheet.detach(2, 3)
        self.assertEqual(self.sheet.get_attachment(2, 3), (0, 0))

    def test_reactions(self):
        sheet = Membrane(2, 0, 2)  # two springs of 2 N/m
        sheet.position = [[[0, 0], [1, 0], [1, 3]]]
        self.assertEqual([sheet.get_reaction(u, 0) for u in range(3)], [(2, 0), (-2, 6), (0, -6)])

    def test_volume_under_a_lifted_sheet(self):
        self.sheet.position = [[[u, v, 0.5] for u in range(3)] for v in range(4)]
        self.assertAlmostEqual(self.sheet.volume, 0.5 * 6 / 3)

    def test_cloth_hangs_and_tells_its_tensions(self):
        cloth = Membrane(4, 3, 3)
        cloth.position = [[[u / 4, 0, -v / 4] for u in range(5)] for v in range(4)]
        cloth.rest_length, cloth.stiffness, cloth.gravity = (1, 0.75), (1e4, 1e4), (0, 0, -10)
        self.assertEqual(cloth.lambda_, 1)
        cloth.compression, cloth.shear, cloth.effort = 0.5, 1, (8, 60)
        cloth.set_edge(Edge.V_FIRST, Node.PINNED)
        cloth.step(1 / 60, 120)
        self.assertGreater(cloth.convergence.iterations, 0)
        self.assertEqual((cloth.read(Field.TENSION_U).shape, cloth.read(Field.STRAIN_U).shape), ((4, 4), (4, 4)))
        for row, tension in zip(cloth.read(Field.TENSION_V).tolist(), (1.5, 1, 0.5)):
            close(self, row, [tension] * 5, 2)  # what hangs below
        strains = cloth.read(Field.STRAIN_V)
        self.assertEqual(strains.shape, (3, 5))
        self.assertAlmostEqual(float(strains[0, 2]), 4 * (cloth.position[0, 2, 2] - cloth.position[1, 2, 2]) - 1, 12)
        cloth.enable_field(Field.REST_LENGTH_V)
        self.assertEqual(cloth.read(Field.REST_LENGTH_V).tolist(), [[0.25] * 5] * 3)
        cloth.write(Field.REST_LENGTH_V, 0.5, first_v=2)
        cloth.step(1 / 60, 300)
        for u in range(5):  # by 0.25 m longer, but for what it stretches
            self.assertAlmostEqual(float(cloth.position[3, u, 2]), -1, 2)
        for field in (Field.TENSION_U, Field.TENSION_V, Field.STRAIN_U, Field.STRAIN_V):
            with self.assertRaisesRegex(contdyn.UnsupportedError, field.name):
                cloth.write(field, 0)
            with self.assertRaisesRegex(contdyn.UnsupportedError, field.name):
                cloth.disable_field(field)
        copy = Membrane(4, 3, 3)
        copy.load(cloth.save())
        self.assertEqual((copy.hash(), copy.rest_length, copy.effort), (cloth.hash(), (1, 0.75), (8, 60)))

    def test_cloth_tears_along_its_seam(self):
        cloth = Membrane(4, 3, 3)
        cloth.position = [[[u / 4, 0, -v / 4] for u in range(5)] for v in range(4)]
        cloth.rest_length, cloth.stiffness, cloth.gravity = (1, 0.75), (1e4, 1e4), (0, 0, -10)
        cloth.set_edge(Edge.V_FIRST, Node.PINNED)
        cloth.breaking_strain = 0.5
        for field, shape in ((Field.BREAKING_STRAIN_U, (4, 4)), (Field.BREAKING_STRAIN_V, (3, 5))):
            cloth.enable_field(field)
            self.assertEqual(cloth.read(field).tolist(), [[0.5] * shape[1]] * shape[0])
        cloth.write(Field.BREAKING_STRAIN_V, 1e-4, first_v=1, n_v=1)
        cloth.step(1 / 60, 10)
        self.assertEqual(cloth.broken, 5)
        whole = cloth.read(Field.STIFFNESS_U).tolist()
        self.assertEqual(cloth.read(Field.STIFFNESS_V).tolist(), [[6000] * 5, [0] * 5, [6000] * 5])
        self.assertTrue(all(k > 0 for row in whole for k in row))
        cloth.step(1 / 60)
        self.assertEqual(cloth.broken, 0)
        cloth.rest_length = 0, 0
        with self.assertRaisesRegex(contdyn.UnsupportedError, "TENSION_U"):
            cloth.read(Field.TENSION_U)
        cloth.step(1 / 60)
        self.assertEqual(cloth.solver_taken, Solver.COUPLED)
        cloth.solver = Solver.ALTERNATING
        cloth.step(1 / 60)
        self.assertEqual((cloth.convergence, cloth.solver_taken), ((0, 0), Solver.ALTERNATING))

    def test_cloth_leans_with_the_wind(self):
        cloth = Membrane(4, 3, 3)
        cloth.position = [[[u / 4, 0, -v / 4] for u in range(5)] for v in range(4)]
        cloth.rest_length, cloth.stiffness, cloth.gravity = (1, 0.75), (1e4, 1e4), (0, 0, -10)
        cloth.set_edge(Edge.V_FIRST, Node.PINNED)
        cloth.air, cloth.wind = (0.5, 5), (0, 2, 0)
        cloth.enable_field(Field.WIND)
        self.assertEqual(cloth.read(Field.WIND).tolist(), [[[0, 2, 0]] * 5] * 4)
        cloth.step(1 / 30, 300)
        self.assertGreater(float(cloth.position[3, 2, 1]), 0.1)
        cloth.write(Field.WIND, 0)
        cloth.step(1 / 30, 600)
        self.assertAlmostEqual(float(cloth.position[3, 2, 1]), 0, 2)

    def test_cloth_rests_on_what_it_touches(self):
        cloth = Membrane(4, 3, 3)
        cloth.position = [[[u / 4, 0.5, v / 4] for u in range(5)] for v in range(4)]
        cloth.rest_length, cloth.gravity = (1, 0.75), (0, -10, 0)
        cloth.colliders, cloth.thickness, cloth.loads = 2, 0.125, True
        cloth.set_plane(0, (0, -1, 0), (0, 2, 0), 0.5)
        cloth.set_capsule(1, (3, 0, 0), (4, 0, 0), 0.5)
        cloth.set_collider_velocity(0, (0, 0, 0.25))
        cloth.step(1 / 60, 120)
        for row in cloth.position.tolist():
            for node in row:
                self.assertAlmostEqual(node[1], -0.875, 5)
        self.assertLess(cloth.get_collider_load(0).force[1], 0)
        plane = cloth.get_collider(0)
        self.assertEqual((plane.shape, plane.second, plane.friction), (Shape.PLANE, (0, 1, 0), 0.5))
        close(self, plane.first, (0, -1, 0.5))
        self.assertEqual(cloth.get_collider(1), (Shape.CAPSULE, (3, 0, 0), (4, 0, 0), (0, 0, 0), 0.5, 0))
        cloth.remove_collider(1)
        self.assertIs(cloth.get_collider(1).shape, Shape.NONE)

    def test_convergence(self):
        self.assertEqual(self.sheet.convergence, (0, 0))
        self.sheet.solver = Solver.COUPLED
        self.sheet.step(0.1)
        self.assertGreater(self.sheet.convergence.iterations, 0)

    def test_vertices_and_triangles(self):
        vertices, triangles = self.sheet.vertices(), self.sheet.indices()
        self.assertEqual(vertices.position.tolist(), [[u, v, 0] for v in range(4) for u in range(3)])
        self.assertEqual(vertices.normal.tolist(), [[0, 0, 1]] * 12)
        self.assertEqual((triangles.shape, self.sheet.index_count), ((12, 3), 36))
        self.assertEqual(sorted(triangles[0].tolist()), [0, 1, 4])
        buffer = bytearray(b"\x07" * (12 * 20))
        self.sheet.write_vertices(buffer, 20, 4, None)
        self.assertEqual(memoryview(buffer).cast("f")[6:9].tolist(), [1, 0, 0])
        self.assertEqual(buffer[:4] + buffer[16:20], b"\x07" * 8)
        numbers = array("I", bytes(144))
        self.sheet.write_indices(numbers, 4)
        self.assertEqual(list(numbers), [k for triangle in triangles.tolist() for k in triangle])
        for use in (lambda: self.sheet.write_vertices(bytearray(100), 24, 0, 12),
                    lambda: self.sheet.write_indices(bytearray(100), 4),
                    lambda: self.sheet.write_vertices(bytearray(480), 24, 0, 13)):
            with self.assertRaises(contdyn.RangeError):
                use()
        with self.assertRaises(TypeError):
            self.sheet.write_vertices(bytes(288), 24, 0, 12)

    def test_many_vertices_take_longer_numbers(self):
        self.assertEqual(Membrane(255, 256, 1).indices().itemsize, 4)
        self.assertEqual(Membrane(250, 250, 1).indices().itemsize, 2)


class Waters(unittest.TestCase):
    def setUp(self):
        self.water = Water(6, 4, 0.5, 0.25)  # 3 m x 1 m
        self.water.depth = 0.5

    def test_volumes(self):
        water = self.water
        self.assertAlmostEqual(water.volume, 1.5)
        self.assertAlmostEqual(water.add_volume(1.5, 0.5, 0.5, 0.25), 0.25)
        self.assertAlmostEqual(water.add_volume_rectangle(0, 0, 6, 4, -100), -1.75)
        self.assertAlmostEqual(water.account.went_out, 1.75)
        self.assertAlmostEqual(water.account.came_in, 0.25)
        self.assertEqual(water.wet_area, 0)
        water.restart_account()
        self.assertEqual(water.account.went_out, 0)

    def test_surface_and_bed(self):
        self.water.bed = 0.25
        self.assertEqual(self.water.read(Field.SURFACE).tolist(), [[0.75] * 6] * 4)
        self.assertEqual(self.water.surface.tolist(), [[0.75] * 6] * 4)
        self.water.surface = 0.5
        self.assertEqual(self.water.depth.tolist(), [[0.25] * 6] * 4)
        self.water.write(Field.SURFACE, 1)
        self.assertEqual(self.water.depth.tolist(), [[0.75] * 6] * 4)

    def test_sources(self):
        self.water.add_source(1.5, 0.5, 0.6, 0.3)
        self.water.add_source_rectangle(0, 0, 2, 2, -0.1)
        self.water.step(0.01, 100)
        self.assertAlmostEqual(self.water.volume, 1.5 + 0.2, 9)

    def test_sides(self):
        self.water.set_side(Side.X_FIRST, Border.OPEN, 0.5, 0.125)
        self.water.set_side(Side.Y_LAST, Border.PERIODIC)
        self.water.step(0.5)
        self.assertEqual(self.water.get_side(Side.X_FIRST), (Border.OPEN, 0.5625, 0.125))
        self.assertIs(self.water.get_side(Side.Y_FIRST).kind, Border.PERIODIC)
        self.water.set_inflow_depth(Side.X_LAST, 0.25)
        self.assertEqual(self.water.get_inflow_depth(Side.X_LAST), 0.25)

    def test_splash_and_impulse(self):
        before = self.water.hash()
        self.water.splash(1.5, 0.5, 0.4, 0.1)
        self.assertNotEqual(self.water.hash(), before)
        self.assertAlmostEqual(self.water.volume, 1.5)
        self.water.impulse(1.5, 0.5, 0.5, 10, 0)
        self.assertGreater(self.water.energy.kinetic, 0)

    def test_a_side_holds_its_level(self):
        water = self.water
        water.depth = 1
        water.set_side(Side.X_LAST, Border.LEVEL, 0.5)
        self.assertEqual(water.get_side(Side.X_LAST), (Border.LEVEL, 0.5, 0))
        water.drag = 0.5
        water.step(0.05, 4000)
        for row in water.depth.tolist():
            close(self, row, [0.5] * 6)
        self.assertAlmostEqual(water.account.went_out - water.account.came_in, 1.5)

    def test_hulls(self) -> None:
        water = self.water
        water.hulls = 2, 2, 1
        self.assertEqual(water.hulls, (2, 2, 1))
        water.set_hull(0, 20, 1, 0.25, [[0, 0.125]])
        water.set_disc(1, 5, 0.25)
        self.assertEqual(water.get_hull(0).heights.tolist(), [[0, 0.125]])
        self.assertAlmostEqual(water.get_hull(1).area, 0.19634954)
        water.set_hull(0, 20, 1, 0.25)
        water.launch_hull(0, 1.5, 0.5)
        water.set_hull_drag(0, 1, 2, 0.5)
        self.assertEqual(water.get_hull_drag(0), (1, 2, 0.5))
        water.set_hull_force(0, (10, 0, 0, 0, 0, 0))
        self.assertEqual(water.get_hull_force(0).x, 10)
        water.set_hull_velocity(0, [0.25, 0, 0, 0, 0, 0])
        water.step(0.01, 10)
        self.assertGreater(water.get_hull_velocity(0).x, 0.2)
        self.assertGreater(water.get_hull_pose(0).x, 1.5)
        self.assertNotEqual(water.get_hull_floor(0).z, water.get_hull_pose(0).z)
        self.assertGreater(water.get_hull_load(0).z, 0)
        self.assertGreater(water.hull_energy.kinetic, 0)
        self.assertAlmostEqual(water.sample_heads([(0.25, 0.5)]).tolist()[0], 0.5, delta=0.25)
        water.set_hull_pose(0, water.get_hull_pose(0))
        water.remove_hull(0)
        self.assertEqual(water.get_hull(0).mass, 0)

    def test_momentum_sets_lambda(self):
        self.water.momentum = Momentum.ADVECTED
        self.assertEqual(self.water.lambda_, 0.5)
        self.water.momentum = Momentum.LINEAR
        self.assertEqual(self.water.lambda_, 0.55)

    def test_courant_and_limits(self):
        self.assertAlmostEqual(self.water.get_courant(0.1), math.sqrt(9.81 * 0.5) * 0.1 / 0.25)
        self.water.depth = [[1e-3] * 3 + [1] * 3] * 4
        self.water.momentum = Momentum.ADVECTED
        self.water.step(0.5, 3)
        self.assertEqual(len(self.water.limited), 2)

    def test_sample(self):
        sample = self.water.sample([[1, 0.5], [2.9, 0.1]])
        self.assertEqual(sample.surface.tolist(), [0.5, 0.5])
        self.assertEqual(sample.depth.tolist(), [0.5, 0.5])
        self.assertEqual(sample.normal.tolist(), [[0, 0, 1]] * 2)
        self.assertEqual(sample.velocity.tolist(), [[0, 0]] * 2)
        with self.assertRaises(contdyn.InvalidValueError):
            self.water.sample([[5, 0]])

    def test_vertices_and_triangles(self):
        self.water.depth = [[0.5, 0, 0, 0, 0, 0]] + [[0] * 6] * 3
        vertices = self.water.vertices()
        self.assertEqual(vertices.position.tolist()[0], [0.25, 0.125, 0.5])
        self.assertEqual(vertices.depth.tolist()[:2], [0.5, 0])
        self.assertEqual(vertices.normal.shape, (24, 3))
        self.assertEqual(self.water.get_index_count(), 6 * 15)
        self.assertEqual(self.water.indices().shape, (30, 3))
        self.assertEqual(self.water.indices(skip_dry=True).shape, (2, 3))
        buffer = bytearray(24 * 16)
        self.water.write_vertices(buffer, 16, 0, None, 12)
        self.assertEqual(memoryview(buffer).cast("f")[:4].tolist(), [0.25, 0.125, 0.5, 0.5])
        numbers = array("H", bytes(12))
        self.water.write_indices(True, numbers, 2)
        self.assertEqual(list(numbers), [k for triangle in self.water.indices(True).tolist() for k in triangle])

    def test_float32(self):
        water = Water(4, 4, 1, 1, Precision.FLOAT32)
        water.depth = 0.1
        self.assertEqual(water.depth.itemsize, 4)
        self.assertNotEqual(water.read(Field.DEPTH)[0, 0], 0.1)


if __name__ == "__main__":
    unittest.main()
