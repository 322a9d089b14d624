"""The scenes of bindings/conformance: the same hashes as in every other language."""
import itertools
import re
import unittest
from array import array

import contdyn
from contdyn import Precision, _properties, errors

from support import BINDINGS, KINDS, api

SCENES = BINDINGS / "conformance" / "scenes.txt"
ENUMERATORS = {value["name"]: value["value"] for enum in api()["enums"] for value in enum["values"]}
FUNCTIONS = {(function["object"], function["short"]): function for function in api()["functions"]}


def statements():
    """Line and words of each statement; lines that begin with a space go on with it."""
    found = []
    for number, line in enumerate(SCENES.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith(" "):
            found[-1][1].extend(line.split())
        elif line and not line.startswith("#"):
            found.append((number, line.split()))
    return found


def arguments(words, precision):
    """The words as Python has them: numbers, lists and None."""
    taken, into = [], None
    for word in words:
        if word == "[":
            into = []
            taken.append(into)
        elif word == "]":
            into = None
        else:
            if word == "null":
                value = None
            elif word == "precision":
                value = precision
            elif word in ENUMERATORS:
                value = ENUMERATORS[word]
            else:
                value = int(word) if re.fullmatch(r"\d+", word) else float(word)
            (taken if into is None else into).append(value)
    return taken


def numbers_of(kind_name, short, taken):
    """Reals where the C function takes them: an integer stands in the text for both."""
    entries = [p for p in FUNCTIONS[kind_name, short]["parameters"] if p["role"] in ("value", "array")]
    return [float(value) if entry["base"] == "double" and isinstance(value, int) else value
            for value, entry in zip(taken, entries)]


class Player:
    """Plays one scene in one precision by one set of kernels."""

    def __init__(self, test, precision, kernels):
        self.test, self.precision, self.kernels = test, precision, kernels
        self.made = self.kind = self.kind_name = self.made_of = None

    def create(self, kind_name, *words):
        self.kind_name, self.kind = kind_name, KINDS[kind_name]
        *self.made_of, allocator = arguments(words, self.precision)
        self.make(allocator=allocator)

    def make(self, **rest):
        """Makes the object anew; gives the last one."""
        last, self.made = self.made, self.kind(*self.made_of, **rest)
        self.made.kernels = self.kernels
        return last

    def copy(self):
        last = self.make()
        self.made.copy_state(last)

    def save_and_load(self):
        last = self.make()
        self.made.load(last.save())

    def hash(self, *hashes):
        self.test.assertEqual(hex(self.made.hash()), hex(int(hashes[self.precision], 16)))

    def refused(self, status, *call):
        with self.test.assertRaises(errors.CLASSES[ENUMERATORS[status]]) as caught:
            self.call(*call)
        self.test.assertIn(f"cd_{self.kind_name}_", str(caught.exception))

    def call(self, name, *words):
        taken = numbers_of(self.kind_name, name, arguments(words, self.precision))
        if name in ("write_f32", "write_f64"):
            field, *place, values = taken
            if name == "write_f32":
                values = array("f", values)
            self.made.write(field, values, *place)
        elif name.startswith("set_") and not hasattr(self.kind, name):
            plain = "lambda_" if name == "set_lambda" else name[4:]
            several = isinstance(getattr(self.kind, plain), _properties.SettingOfSeveral)
            setattr(self.made, plain, taken if several else taken[0])
        else:
            getattr(self.made, name)(*taken)

    def play(self, name, *words):
        special = {"create": self.create, "copy": self.copy, "save_and_load": self.save_and_load, "hash": self.hash,
                   "refused": self.refused}
        if name in special:
            special[name](*words)
        else:
            self.call(name, *words)


class Conformance(unittest.TestCase):
    def test_scenes_give_the_same_hashes(self):
        scenes = [k for k, (_, words) in enumerate(statements()) if words[0] == "scene"]
        self.assertGreater(len(scenes), 3)
        for precision, kernels in itertools.product(Precision, contdyn.runnable_kernels()):
            player = None
            for line, words in statements():
                if words[0] == "scene":
                    player = Player(self, precision, kernels)
                    continue
                with self.subTest(line=line, call=words[0], precision=precision, kernels=kernels):
                    player.play(*words)

    def test_another_step_is_another_hash(self):
        made = contdyn.Chain(1, 12, 2)
        before = made.hash()
        made.step(0.01)
        self.assertNotEqual(made.hash(), before)


if __name__ == "__main__":
    unittest.main()
