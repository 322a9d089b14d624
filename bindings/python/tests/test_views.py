"""Fields shown without a copy: where they lie, that they cannot be written, and that they never dangle."""
import gc
import unittest

import contdyn
from contdyn import Chain, Field, Membrane, MassRule, Method, Momentum, Node, Precision, Solver, Water

from support import (KINDS, NUMPY, Heap, large, lengthen, make, moving, numbers_for, optional_views, switch_all_on,
                     viewable)


def each_view():
    for kind in KINDS.values():
        for precision in Precision:
            for field in viewable(kind):
                yield kind, precision, field


class Shown(unittest.TestCase):
    def test_views_agree_with_reads_and_follow_steps(self):
        for kind, precision, field in each_view():
            with self.subTest(kind.__name__, precision=precision, field=field):
                made = moving(kind, precision)
                if not kind._fields[field].always:
                    made.enable_field(field)
                made.write(field, numbers_for(made, field))
                shown = made.view(field)
                for _ in range(2):
                    copy = made.read(field)
                    self.assertEqual(shown.shape, copy.shape)
                    self.assertEqual(shown.itemsize, 4 if precision == Precision.FLOAT32 else 8)
                    self.assertEqual(shown.tolist(), copy.tolist())
                    made.step(0.01)

    def test_shapes(self):
        chain, membrane, water = (make(kind) for kind in (Chain, Membrane, Water))
        self.assertEqual(chain.position.shape, (2, 6, 3))
        self.assertEqual(membrane.velocity.shape, (4, 5, 3))
        self.assertEqual(water.depth.shape, (4, 5))
        self.assertEqual(water.velocity_x.shape, (4, 6))
        self.assertEqual(water.velocity_y.shape, (5, 5))
        self.assertEqual(Chain(1, 0, 1).position.shape, (1, 1, 1))

    def test_views_cannot_be_written(self):
        for kind, precision, field in each_view():
            made = make(kind, precision)
            switch_all_on(made)
            shown = made.view(field)
            for place in (0, slice(None), (0,) * len(shown.shape)):
                with self.subTest(kind.__name__, field=field, place=place), self.assertRaises((TypeError, ValueError)):
                    shown[place] = 1
            if NUMPY:
                self.assertFalse(shown.flags.writeable)
                with self.assertRaises(ValueError):
                    shown.flags.writeable = True
                with self.assertRaises(ValueError):
                    made.read(field, out=shown)
            else:
                self.assertTrue(shown.readonly)

    def test_two_views_of_a_field_are_one_memory(self):
        made = moving(Chain)
        one, two = made.position, made.position
        made.write(Field.POSITION, 3)
        self.assertEqual(one.tolist(), two.tolist())

    def test_assigning_writes(self):
        for kind, precision, field in each_view():
            made = make(kind, precision)
            switch_all_on(made)
            numbers = numbers_for(made, field)
            setattr(made, field.name.lower(), numbers)
            self.assertEqual(getattr(made, field.name.lower()).tolist(), numbers)

    def test_fields_without_a_view_say_so(self):
        for kind, field in ((Chain, Field.PIN), (Chain, Field.TENSION), (Chain, Field.STRAIN), (Water, Field.SURFACE),
                            (Membrane, Field.TENSION_U), (Membrane, Field.STRAIN_V)):
            made = make(kind)
            lengthen(made)
            with self.assertRaises(contdyn.UnsupportedError):
                made.view(field)
        with self.assertRaises(contdyn.DisabledError):
            make(Chain).view(Field.FORCE)
        self.assertEqual([field for field in viewable(Water) if not hasattr(Water, field.name.lower())], [])


class Lasting(unittest.TestCase):
    def test_a_view_outlives_its_closed_or_forgotten_object(self):
        for kind in KINDS.values():
            for field in viewable(kind):
                for way in ("close", "forget", "with"):
                    with self.subTest(kind.__name__, field=field, way=way):
                        heap = Heap()
                        made = moving(kind, allocator=heap)
                        switch_all_on(made)
                        shown = made.view(field)
                        part, before = shown[0:1], shown.tolist()
                        if way == "close":
                            made.close()
                        elif way == "with":
                            with made:
                                pass
                        del made
                        gc.collect()
                        self.assertEqual(shown.tolist(), before)
                        del shown
                        gc.collect()
                        self.assertEqual(part.tolist(), before[0:1])
                        self.assertNotEqual(heap.blocks, {})
                        del part
                        gc.collect()
                        self.assertEqual(heap.blocks, {})

    def test_a_shown_field_cannot_be_switched_off(self):
        for kind in KINDS.values():
            for field in optional_views(kind):
                with self.subTest(kind.__name__, field=field):
                    made = make(kind, allocator=Heap())
                    made.enable_field(field)
                    shown = made.view(field)
                    before = shown.tolist()
                    with self.assertRaisesRegex(BufferError, field.name):
                        made.disable_field(field)
                    self.assertEqual((made.read(field).tolist(), shown.tolist()), (before, before))
                    del shown
                    gc.collect()
                    made.disable_field(field)
                    with self.assertRaises(contdyn.DisabledError):
                        made.view(field)

    def test_a_shown_field_cannot_be_lost_by_load_or_copy_state(self):
        for kind in KINDS.values():
            for field in optional_views(kind):
                with self.subTest(kind.__name__, field=field):
                    made, without, within = (moving(kind, allocator=Heap()) for _ in range(3))
                    made.enable_field(field)
                    shown = made.view(field)
                    before, hash_before = shown.tolist(), made.hash()
                    for use in (lambda: made.load(without.save()), lambda: made.copy_state(without)):
                        with self.assertRaisesRegex(BufferError, field.name):
                            use()
                    self.assertEqual((shown.tolist(), made.hash()), (before, hash_before))
                    within.enable_field(field)
                    for number, use in ((0.25, lambda: made.load(within.save())),
                                        (0.5, lambda: made.copy_state(within))):
                        if kind is not Water or field not in (Field.FORCE_X, Field.FORCE_Y):
                            within.write(field, number)
                        use()
                        self.assertEqual(shown.tolist(), within.read(field).tolist())
                    with self.assertRaises(contdyn.FormatError):
                        made.load(b"")
                    del shown
                    gc.collect()
                    made.copy_state(without)
                    self.assertEqual(made.hash(), without.hash())

    def test_what_else_takes_or_gives_memory_leaves_views_in_place(self):
        heap = Heap()
        changes = {
            Chain: [lambda m: m.attach(0, 1, 2, 3), lambda m: m.detach(0, 1), lambda m: m.cut(0, 1),
                    lambda m: m.weld(0, 2),
                    lambda m: setattr(m, "bend", 0.1), lambda m: setattr(m, "ring", True),
                    lambda m: setattr(m, "ring", False), lambda m: setattr(m, "bend", 0),
                    lambda m: m.disable_field(Field.BEND), lambda m: setattr(m, "rest_length", 9),
                    lambda m: m.enable_field(Field.REST_LENGTH), lambda m: m.enable_field(Field.STRENGTH),
                    lambda m: m.set_end(0, Node.POSED), lambda m: m.teleport(0, None, (1, 2, 3)),
                    lambda m: setattr(m, "rest_length", 0)],
            Membrane: [lambda m: m.attach(1, 1, 2, 3), lambda m: m.detach(1, 1), lambda m: setattr(m, "bend", 0.1),
                       lambda m: setattr(m, "rest_length", (9, 9)), lambda m: m.enable_field(Field.REST_LENGTH_U),
                       lambda m: setattr(m, "breaking_strain", 9), lambda m: m.enable_field(Field.BREAKING_STRAIN_V),
                       lambda m: m.enable_field(Field.WIND), lambda m: setattr(m, "air", (1, 2)),
                       lambda m: setattr(m, "colliders", 2), lambda m: setattr(m, "ring", (False, True)),
                       lambda m: setattr(m, "rest_length", (0, 0)),
                       lambda m: setattr(m, "ring", (True, False)), lambda m: setattr(m, "solver", Solver.COUPLED),
                       lambda m: setattr(m, "pressure", 0.1), lambda m: m.set_edge(2, Node.MATCHED),
                       lambda m: m.set_edge(3, Node.POSED), lambda m: m.teleport(None, (1, 2, 3)),
                       lambda m: setattr(m, "solver", Solver.ALTERNATING)],
            Water: [lambda m: setattr(m, "momentum", Momentum.ADVECTED), lambda m: m.add_source(1, 0.5, 1, 0.1),
                    lambda m: setattr(m, "momentum", Momentum.LINEAR)],
        }
        for kind, more in changes.items():
            switching = [lambda m, f=f: m.enable_field(f) for f, info in kind._fields.items()
                         if not info.always and not info.lengths]
            methods = [Method.IMPLICIT, Method.SYMPLECTIC_EULER, Method.FORWARD_EULER, Method.IMPLICIT]
            setting = [lambda m, x=x: setattr(m, "method", x) for x in methods]
            setting += [lambda m, x=x: setattr(m, "mass_rule", x) for x in MassRule] if kind is not Water else []
            setting += [lambda m: setattr(m, "parallel", 2), lambda m: setattr(m, "parallel", None)]
            made = moving(kind, allocator=heap)
            shown = {field: made.view(field) for field in viewable(kind) if kind._fields[field].always}
            for k, change in enumerate(switching + setting + more + [lambda m: m.reset()]):
                with self.subTest(kind.__name__, change=k):
                    change(made)
                    made.step(0.001)
                    for field, view in shown.items():
                        self.assertEqual(view.tolist(), made.read(field).tolist())

    def test_a_call_on_its_way_keeps_the_object(self):
        for kind in KINDS.values():
            heap = Heap()
            made = large(kind, allocator=heap)
            made.parallel = lambda count, task, made=made: made.close()  # in the midst of the step
            made.step(0.01)
            self.assertTrue(made.closed)
            del made
            gc.collect()
            self.assertEqual(heap.blocks, {})


if __name__ == "__main__":
    unittest.main()
