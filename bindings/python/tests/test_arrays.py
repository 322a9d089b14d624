"""Numbers from the caller and to the caller: every form of them, with and without NumPy."""
import unittest
from array import array

from contdyn import Chain, Field, Membrane, Precision, RangeError, View, Water, _arrays

from support import KINDS, NUMPY, make, numbers_for, possible, switch_all_on, wave


class Writing(unittest.TestCase):
    def setUp(self):
        self.chain = Chain(2, 5, 3)
        self.numbers = wave((2, 6, 3))
        self.flat = [number for strand in self.numbers for node in strand for number in node]

    def written(self, values, **place):
        self.chain.position = 0
        self.chain.write(Field.POSITION, values, **place)
        return self.chain.position.tolist()

    def test_forms_of_numbers(self):
        forms = {
            "nested lists": self.numbers,
            "nested tuples": tuple(tuple(map(tuple, strand)) for strand in self.numbers),
            "one row": self.flat,
            "array of doubles": array("d", self.flat),
            "array of floats": array("f", self.flat),
            "shaped buffer": memoryview(array("d", self.flat)).cast("B").cast("d", (2, 6, 3)),
            "read-only buffer": memoryview(array("f", self.flat)).toreadonly(),
            "strided buffer": memoryview(array("d", [x for number in self.flat for x in (number, 0)]))[::2],
            "dimensions of 1": [[[[number] for number in node] for node in strand] for strand in self.numbers],
        }
        chain = Chain(2, 5, 3)
        chain.position = self.numbers
        forms["what a view gives"] = chain.position
        forms["views in a list"] = [chain.position[0], list(chain.position[1])]
        forms["what a read gives"] = chain.read(Field.POSITION, precision=Precision.FLOAT32)
        if NUMPY:
            numpy = _arrays.numpy
            full = numpy.array(self.numbers)
            forms.update({
                "float32": full.astype("f"), "other byte order": full.astype(">f8"), "columns first": full.copy("F"),
                "every other": numpy.repeat(full, 2, 1)[:, ::2], "reversed twice": full[::-1].copy()[::-1],
                "objects with numbers": numpy.float32(full), "read-only": numpy.broadcast_to(full, full.shape),
            })
        for name, values in forms.items():
            with self.subTest(name):
                self.assertEqual(self.written(values), self.numbers)

    def test_integers_and_truths(self):
        self.assertEqual(self.written(array("i", range(36)))[1][5], [33, 34, 35])
        self.assertEqual(self.written([True] * 36)[1][5], [1, 1, 1])

    def test_one_number_fills_the_place(self):
        self.assertEqual(self.written(0.5), [[[0.5] * 3] * 6] * 2)
        self.assertEqual(self.written(2, first_strand=1, first=5)[1][4:], [[0, 0, 0], [2, 2, 2]])

    def test_ranges(self):
        expected = [[[0.0] * 3 for _ in range(6)] for _ in range(2)]
        expected[1][2:4] = [[1, 2, 3], [4, 5, 6]]
        self.assertEqual(self.written([[1, 2, 3], [4, 5, 6]], first_strand=1, strands=1, first=2, n=2), expected)
        self.assertEqual(self.written([], n=0), [[[0.0] * 3] * 6] * 2)

    def test_float32_is_written_without_a_detour(self):
        chain = Chain(1, 0, 1, Precision.FLOAT32)
        chain.position = array("f", [0.1])
        self.assertEqual(chain.read(Field.POSITION).tolist(), [[[array("f", [0.1])[0]]]])

    def test_shapes_that_do_not_fit(self):
        water = Water(5, 4, 1, 1)
        turned = [[0.0] * 4] * 5
        for made, field, values in ((self.chain, Field.POSITION, self.flat[1:]), (water, Field.DEPTH, turned),
                                    (water, Field.DEPTH, [[0.0] * 5] * 3), (self.chain, Field.PIN, [0] * 7),
                                    (self.chain, Field.POSITION, []), (self.chain, Field.POSITION, [1])):
            with self.subTest(field=field), self.assertRaises(RangeError):
                made.write(field, values)
        with self.assertRaises((RangeError, ValueError, TypeError)):
            self.chain.write(Field.PIN, [0, [1, 2], 0, 0, 0])


class Reading(unittest.TestCase):
    def test_every_field_comes_back_in_both_precisions(self):
        for kind in KINDS.values():
            for precision in Precision:
                made = make(kind, precision)
                switch_all_on(made)
                for field in (f for f in possible(made) if not kind._fields[f].read_only):
                    with self.subTest(kind.__name__, field=field):
                        discrete = field in (Field.PIN, Field.MASK, Field.WALL_X, Field.WALL_Y)
                        numbers = 1.0 if discrete else numbers_for(made, field)
                        if field not in (Field.PIN, Field.WALL_X, Field.WALL_Y):
                            made.write(field, numbers)
                        whole = made.read(field)
                        for wanted in Precision:
                            copy = made.read(field, precision=wanted)
                            self.assertEqual(copy.itemsize, 4 if wanted == Precision.FLOAT32 else 8)
                            self.assertEqual(copy.tolist(), whole.tolist())
                        if not discrete:
                            self.assertEqual(whole.tolist(), numbers)

    def test_shapes_of_fields(self):
        membrane = Membrane(4, 3, 2)
        shapes = {Field.POSITION: (4, 5, 2), Field.STIFFNESS_U: (4, 4), Field.STIFFNESS_V: (3, 5), Field.MASK: (4, 5)}
        for field, shape in shapes.items():
            membrane.enable_field(field)
            self.assertEqual(membrane.read(field).shape, shape)
        cloth = Membrane(4, 3, 3)
        cloth.rest_length = 1, 1
        for field, shape in ((Field.REST_LENGTH_U, (4, 4)), (Field.REST_LENGTH_V, (3, 5)), (Field.WIND, (4, 5, 3)),
                             (Field.TENSION_U, (4, 4)), (Field.TENSION_V, (3, 5)), (Field.STRAIN_U, (4, 4)),
                             (Field.STRAIN_V, (3, 5)), (Field.BREAKING_STRAIN_U, (4, 4)),
                             (Field.BREAKING_STRAIN_V, (3, 5))):
            cloth.enable_field(field)
            self.assertEqual(cloth.read(field).shape, shape)
        cloth.ring = True, False
        self.assertEqual(cloth.read(Field.STRAIN_U).shape, (4, 5))
        ring = Membrane(4, 3, 2)
        ring.ring = True, True
        for field, shape in ((Field.STIFFNESS_U, (4, 5)), (Field.STIFFNESS_V, (4, 5))):
            ring.enable_field(field)
            self.assertEqual(ring.read(field).shape, shape)
        chain = Chain(2, 5, 3)
        chain.enable_field(Field.STIFFNESS)
        self.assertEqual(chain.read(Field.STIFFNESS).shape, (5,))
        chain.ring = True
        self.assertEqual(chain.read(Field.STIFFNESS).shape, (6,))
        self.assertEqual(chain.read(Field.PIN).shape, (6,))
        water = Water(5, 4, 1, 1)
        for field, shape in ((Field.WALL_X, (4, 6)), (Field.WALL_Y, (5, 5)), (Field.SURFACE, (4, 5))):
            if field != Field.SURFACE:
                water.enable_field(field)
            self.assertEqual(water.read(field).shape, shape)
        empty = Membrane(0, 3, 1)
        empty.enable_field(Field.STIFFNESS_U)
        self.assertEqual(empty.read(Field.STIFFNESS_U).tolist(), [[]] * 4)

    def test_ranges(self):
        chain, water = Chain(2, 5, 3), Water(5, 4, 1, 1)
        chain.position, water.bed = wave((2, 6, 3)), wave((4, 5))
        self.assertEqual(chain.read(Field.POSITION, 1, 1, 2, 3).tolist(), [wave((2, 6, 3))[1][2:5]])
        self.assertEqual(chain.read(Field.POSITION, first=4).shape, (2, 2, 3))
        self.assertEqual(water.read(Field.BED, 1, 2, 3, 1).tolist(), [wave((4, 5))[2][1:4]])
        self.assertEqual(water.read(Field.BED, first_x=3, n_y=2).tolist(), [row[3:] for row in wave((4, 5))[:2]])

    def test_into_an_array_of_the_caller(self):
        chain = Chain(2, 5, 3)
        chain.position = wave((2, 6, 3))
        outs = [array("d", bytes(288)), array("f", bytes(144)), memoryview(bytearray(288)).cast("d", (2, 6, 3)),
                chain.read(Field.VELOCITY)]
        for out in outs:
            self.assertIs(chain.read(Field.POSITION, out=out), out)
            filled = out.whole() if isinstance(out, View) else memoryview(out)
            self.assertEqual(list(filled.cast("B").cast(filled.format)), [number / 64 for number in range(1, 37)])
        for bad, error in ((array("d", bytes(280)), RangeError), (array("i", bytes(144)), TypeError),
                           (bytes(288), TypeError), (memoryview(array("d", bytes(288))).toreadonly(), ValueError),
                           (memoryview(array("d", bytes(576)))[::2], ValueError)):
            with self.assertRaises(error):
                chain.read(Field.POSITION, out=bad)
        with self.assertRaises(TypeError):
            chain.read(Field.POSITION, precision=Precision.FLOAT32, out=outs[0])


class Views(unittest.TestCase):
    """View, which stands for NumPy's arrays."""

    def setUp(self):
        self.numbers = wave((2, 3, 4))
        row = array("d", [number for table in self.numbers for line in table for number in line])
        self.view = _arrays.dense_view(memoryview(row), (2, 3, 4))

    def test_indices(self):
        view, numbers = self.view, self.numbers
        self.assertEqual(view[1, 2, 3], numbers[1][2][3])
        self.assertEqual(view[-1][0, -2], numbers[1][0][2])
        self.assertEqual(view[1].tolist(), numbers[1])
        self.assertEqual(view[:, 1].tolist(), [numbers[0][1], numbers[1][1]])
        self.assertEqual(view[0, ::-1, 1:3].tolist(), [row[1:3] for row in numbers[0][::-1]])
        self.assertEqual(view[:, :, 5:].tolist(), [[[], [], []]] * 2)
        self.assertEqual(view[:, 1, 3].flat().tolist(), [numbers[0][1][3], numbers[1][1][3]])
        self.assertEqual(view[1, 2, ::-2].flat().tolist(), numbers[1][2][::-2])
        self.assertEqual(view[:, :, 2:].flat().tolist(), [x for table in numbers for line in table for x in line[2:]])
        self.assertEqual([part.tolist() for part in view], numbers)
        self.assertEqual([float(x) for x in view[0, 0]], numbers[0][0])
        for bad in (2, (0, 3), (0, 0, 0, 0)):
            with self.assertRaises(IndexError):
                view[bad]
        with self.assertRaises(TypeError):
            view[0.5]

    def test_what_it_tells(self):
        view = self.view
        self.assertEqual((view.shape, view.strides, view.ndim, view.size), ((2, 3, 4), (96, 32, 8), 3, 24))
        self.assertEqual((view.itemsize, view.format, view.readonly, len(view)), (8, "d", False, 2))
        self.assertEqual(view[:, 0, 0].strides, (96,))
        self.assertEqual(repr(view[0, 0, :2]), f"View({self.numbers[0][0][:2]})")
        self.assertEqual(float(view[0, 0, :1]), self.numbers[0][0][0])
        with self.assertRaises(TypeError):
            float(view)

    def test_assigning(self):
        self.view[0, 1] = [9, 8, 7, 6]
        self.view[1] = 0
        self.view[0, 0, 0] = -1
        self.assertEqual(self.view[0, :2].tolist(), [[-1, *self.numbers[0][0][1:]], [9, 8, 7, 6]])
        self.assertEqual(self.view[1].tolist(), [[0] * 4] * 3)
        with self.assertRaises(RangeError):
            self.view[0] = [1, 2]
        with self.assertRaises(ValueError):
            self.view[:, 0].whole()


if __name__ == "__main__":
    unittest.main()
