"""Making, closing, copying objects; what is left when they are gone."""
import copy
import gc
import pickle
import unittest

import contdyn
from contdyn import Chain, HandleError, Membrane, Precision, Water, _properties

from support import KINDS, Heap, api, make, moving

# What each function takes, beyond the object; by the C API's name without its prefix.
ARGUMENTS = {
    "set_end": (0, 0), "get_end": (0,), "set_edge": (0, 0), "get_edge": (0,), "set_side": (0, 0), "get_side": (0,),
    "set_inflow_depth": (0, 1), "get_inflow_depth": (0,),
    "enable_field": (2,), "disable_field": (2,), "view": (0,), "cut": (0, 0), "weld": (0, 0), "step": (0.01,),
    "get_courant": (0.1,), "add_volume": (0, 0, 1, 1), "add_volume_rectangle": (0, 0, 1, 1, 1),
    "add_source": (0, 0, 1, 1), "add_source_rectangle": (0, 0, 1, 1, 1), "splash": (0, 0, 1, 1), "load": (b"",),
    "set_plane": (0, [0] * 3, [0] * 3), "set_capsule": (0, [0] * 3, [0] * 3, 1), "remove_collider": (0,),
    "set_bed": (0, [0] * 3, 2, 2, 1, 1, [0] * 4), "get_bed": (0,), "set_callback": (0, max, [0] * 3),
    "get_collider": (0,), "get_collider_load": (0,), "set_collider_velocity": (0, [0] * 3),
    "set_hull": (0, 1, 1, 1), "set_disc": (0, 1, 0.5), "get_hull": (0,), "remove_hull": (0,), "launch_hull": (0, 0, 0),
    "set_hull_pose": (0, [0, 0, 0, 1, 0, 0, 0]), "get_hull_pose": (0,), "get_hull_floor": (0,),
    "set_hull_velocity": (0, [0] * 6), "get_hull_velocity": (0,), "set_hull_force": (0, [0] * 6),
    "get_hull_force": (0,), "set_hull_drag": (0, 1, 1), "get_hull_drag": (0,), "get_hull_load": (0,),
    "sample_heads": ([0, 0],),
}
ARGUMENTS_OF = {
    ("chain", "impulse"): (0, 0, [0] * 3), ("membrane", "impulse"): (0, 0, 0, [0] * 3),
    ("water", "impulse"): (0, 0, 1, 0, 0), ("chain", "get_reaction"): (0, 0),
    ("membrane", "get_reaction"): (0, 0),
    ("chain", "teleport"): (0, None, [0] * 3), ("membrane", "teleport"): (None, [0] * 3),
    ("chain", "attach"): (0, 0, 1, 0), ("membrane", "attach"): (0, 0, 1, 0),
    ("chain", "detach"): (0, 0), ("membrane", "detach"): (0, 0), ("chain", "get_attachment"): (0, 0),
    ("membrane", "get_attachment"): (0, 0), ("chain", "sample"): (0, [0]), ("membrane", "sample"): ([0, 0],),
    ("water", "sample"): ([0, 0],), ("membrane", "write_vertices"): (bytearray(480), 24, 0, 12),
    ("water", "write_vertices"): (bytearray(560), 28, 0, 12, 24),
    ("membrane", "write_indices"): (bytearray(400), 4), ("water", "write_indices"): (False, bytearray(400), 4),
    ("chain", "read"): (0,), ("membrane", "read"): (0,), ("water", "read"): (11,), ("chain", "write"): (0, 0),
    ("membrane", "write"): (0, 0), ("water", "write"): (11, 0),
}
VALUES = {"gravity": 0, "ring": 0, "stiffness": 0, "tolerance": 0, "parallel": 2, "kernels": 0}


def uses(kind_name):
    """Every way to call the library on an object: its name, and a function of the object."""
    kind = KINDS[kind_name]
    for function in api()["functions"]:
        short = function["short"]
        if function["object"] != kind_name or short in ("create", "destroy"):
            continue
        plain = short.replace("_f32", "").replace("_f64", "")
        name = plain[4:] if plain.startswith(("get_", "set_")) else plain
        name = "lambda_" if name == "lambda" else name
        if plain.startswith("get_") and not hasattr(kind, plain):
            yield short, lambda made, name=name: getattr(made, name)
        elif plain.startswith("set_") and not hasattr(kind, plain):
            several = isinstance(getattr(kind, name), _properties.SettingOfSeveral)
            value = (1, 1, 1) if name == "hulls" else (0, 0) if several else VALUES.get(name, 1)
            yield short, lambda made, name=name, value=value: setattr(made, name, value)
        elif short == "copy_state":
            yield short, lambda made, kind=kind: made.copy_state(make(kind))
        else:
            arguments = ARGUMENTS_OF.get((kind_name, plain), ARGUMENTS.get(plain, ()))
            yield short, lambda made, plain=plain, arguments=arguments: getattr(made, plain)(*arguments)


class Life(unittest.TestCase):
    def test_a_new_membrane_has_the_solver_that_its_description_says(self):
        with Membrane(1, 1, 1) as new:
            self.assertIn(f"Solver.{new.solver.name}.", Membrane.__doc__)

    def test_a_closed_object_refuses_every_call(self):
        for kind_name, kind in KINDS.items():
            for name, use in uses(kind_name):
                with self.subTest(kind_name, function=name):
                    made = make(kind)
                    made.close()
                    with self.assertRaisesRegex(HandleError, f"this {kind.__name__} is closed") as caught:
                        use(made)
                    self.assertIsInstance(caught.exception, ValueError)
                    self.assertEqual(caught.exception.status, contdyn.Status.ERROR_HANDLE)

    def test_what_a_closed_object_refuses_an_open_one_does(self):
        for kind_name, kind in KINDS.items():
            for name, use in uses(kind_name):
                with self.subTest(kind_name, function=name):
                    try:
                        use(make(kind))
                    except contdyn.Error as error:
                        self.assertNotIsInstance(error, HandleError)

    def test_closing_twice_does_nothing(self):
        for kind in KINDS.values():
            made = make(kind)
            self.assertFalse(made.closed)
            made.close()
            made.close()
            self.assertTrue(made.closed)
            self.assertIn("closed", repr(made))

    def test_a_with_statement_closes_also_when_it_fails(self):
        for kind in KINDS.values():
            with self.assertRaises(ZeroDivisionError), make(kind) as made:
                raise ZeroDivisionError
            self.assertTrue(made.closed)

    def test_all_memory_goes_back_when_closed_or_forgotten(self):
        for kind in KINDS.values():
            for way in ("close", "forget"):
                with self.subTest(kind.__name__, way=way):
                    heap = Heap()
                    made = make(kind, allocator=heap)
                    self.assertEqual(heap.bytes, made.memory)
                    if way == "close":
                        made.close()
                    else:
                        del made
                        gc.collect()
                    self.assertEqual(heap.blocks, {})

    def test_what_fails_to_be_made_leaves_nothing(self):
        for kind, arguments in ((Chain, (0, 1, 1)), (Membrane, (1, 1, 9)), (Water, (0, 1, 1, 1))):
            heap = Heap()
            with self.assertRaises(contdyn.InvalidValueError):
                kind(*arguments, allocator=heap)
            self.assertEqual(heap.blocks, {})

    def test_shapes_are_told_as_made(self):
        self.assertEqual(Chain(2, 5, 3, Precision.FLOAT32).shape, (2, 5, 3, Precision.FLOAT32))
        self.assertEqual(Chain(2, 5, 3).shape.nodes, 6)
        self.assertEqual(Membrane(4, 3, 2).shape, (4, 3, 2, Precision.FLOAT64))
        self.assertEqual(Membrane(4, 3, 2).shape.nodes, (4, 5))
        self.assertEqual(Water(5, 4, 0.5, 0.25).shape, (5, 4, 0.5, 0.25, Precision.FLOAT64))
        self.assertEqual(repr(Water(5, 4, 0.5, 0.25)), "<Water(5, 4, 0.5, 0.25, FLOAT64)>")

    def test_unknown_attributes_cannot_be_set_by_a_slip(self):
        for name in ("time", "energy", "stiffnes"):
            with self.subTest(name), self.assertRaises(AttributeError):
                setattr(make(Chain), name, 1)

    def test_names_of_the_c_api_that_became_properties_are_told(self):
        for kind, name, told in ((Water, "set_hulls", "'hulls'"), (Chain, "set_lambda", "'lambda_'"),
                                 (Membrane, "get_energy", "'energy'")):
            with self.subTest(name), self.assertRaisesRegex(AttributeError, f"'{name}': it is the property {told}$"):
                getattr(make(kind), name)
        for name in ("set_nothing", "get_step", "hull", "_other"):
            with self.subTest(name), self.assertRaisesRegex(AttributeError, f"'Chain' object has no .* '{name}'$"):
                getattr(make(Chain), name)


class Keeping(unittest.TestCase):
    def test_save_and_load(self):
        for kind in KINDS.values():
            for precision in Precision:
                made, other = moving(kind, precision), make(kind, precision)
                state = made.save()
                self.assertEqual(len(state), made.save_size())
                for form in (state, bytearray(state), memoryview(state)):
                    other.reset()
                    other.load(form)
                    self.assertEqual(other.hash(), made.hash())
                self.assertEqual((other.time, other.steps), (made.time, made.steps))

    def test_copy_state(self):
        for kind in KINDS.values():
            made, other = moving(kind), make(kind)
            other.copy_state(made)
            self.assertEqual(other.hash(), made.hash())
            closed = make(kind)
            closed.close()
            with self.assertRaisesRegex(HandleError, "the source"):
                other.copy_state(closed)
            with self.assertRaises(TypeError):
                other.copy_state(make(Water if kind is Chain else Chain))

    def test_copies_and_pickles_go_on_alike(self):
        for kind in KINDS.values():
            made = moving(kind)
            others = [copy.copy(made), copy.deepcopy(made), pickle.loads(pickle.dumps(made))]
            for each in (made, *others):
                each.step(0.01, 5)
            self.assertEqual({each.hash() for each in others}, {made.hash()})

    def test_classes_of_the_users_own(self):
        class Rope(Chain):
            def __init__(self, name):
                super().__init__(1, 4, 1)
                self.name = name

        rope = Rope("mine")
        rope.enable_field(contdyn.Field.FORCE)
        shown = rope.force
        rope.load(rope.save())
        self.assertEqual(shown.tolist(), [[[0]] * 5])
        twin = copy.copy(rope)
        self.assertEqual((type(twin), twin.name, twin.hash()), (Rope, "mine", rope.hash()))
        plain = Chain(1, 4, 1)
        plain.copy_state(rope)
        rope.copy_state(plain)

    def test_reset(self):
        for kind in KINDS.values():
            made = moving(kind)
            made.reset()
            self.assertEqual((made.hash(), made.time, made.steps), (make(kind).hash(), 0, 0))

    def test_damaged_bytes_change_nothing(self):
        for kind in KINDS.values():
            made = moving(kind)
            before, state = made.hash(), bytearray(made.save())
            state[-1] ^= 1
            for bad in (b"", bytes(state), bytes(state[:40])):
                with self.assertRaises(contdyn.FormatError):
                    made.load(bad)
            self.assertEqual(made.hash(), before)


if __name__ == "__main__":
    unittest.main()
