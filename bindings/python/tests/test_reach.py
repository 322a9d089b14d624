"""The package against api.json: nothing of the C API is missing, and its names follow from those of the C API."""
import enum
import inspect
import subprocess
import sys
import unittest

import contdyn
from contdyn import _api, _library, _properties, errors

from support import KINDS, PYTHON, api

# Functions that are not reached by the rule in `python_name`, and how they are.
OTHERWISE = {
    "cd_status_name": "contdyn.status_name",
    "cd_error_message": "the text of every contdyn.Error",
    "cd_version": "contdyn.version",
    "cd_version_string": "contdyn.__version__",
    "cd_build_info": "contdyn.build_info",
    "cd_saved_shape": "contdyn.saved_shape",
    "cd_runnable_kernels": "contdyn.runnable_kernels",
    "cd_kernels_name": "contdyn.kernels_name",
    "cd_chain_create": "contdyn.Chain",
    "cd_membrane_create": "contdyn.Membrane",
    "cd_water_create": "contdyn.Water",
    "cd_chain_destroy": "contdyn.Chain.close",
    "cd_membrane_destroy": "contdyn.Membrane.close",
    "cd_water_destroy": "contdyn.Water.close",
}
# What is not reached, and why. Nothing at present.
LEFT_OUT = {}
# Parameters with another name in Python, and why.
RENAMED = {"bytes": "data"}  # bytes is a type of Python's


def python_name(function):
    """get_ and set_ make a property where nothing but the object and the value goes in; otherwise names stay."""
    short = function["short"]
    for ending in ("_f32", "_f64"):
        short = short[: -len(ending)] if short.endswith(ending) else short
    if not short.startswith(("get_", "set_")) or hasattr(KINDS[function["object"]], short):
        return short
    return "lambda_" if short == "set_lambda" or short == "get_lambda" else short[4:]


class Reach(unittest.TestCase):
    def test_the_generated_module_is_up_to_date(self):
        subprocess.run([sys.executable, PYTHON / "generate.py", "--check"], check=True)

    def test_every_function_is_reached(self):
        for function in api()["functions"]:
            name = function["name"]
            with self.subTest(name):
                if name in LEFT_OUT:
                    continue
                if name in OTHERWISE:
                    words = OTHERWISE[name].split()[-1].split(".")
                    target = contdyn
                    for word in words[1:]:
                        target = getattr(target, word)
                    continue
                kind = KINDS[function["object"]]
                reached = inspect.getattr_static(kind, python_name(function))
                short = function["short"]
                if short.startswith("set_") and not hasattr(kind, short):
                    if isinstance(reached, property):
                        self.assertIsNotNone(reached.fset)
                    else:
                        self.assertIsNot(type(reached).__set__, _properties.Reading.__set__)
                elif short.startswith("get_") and not hasattr(kind, short):
                    self.assertIsInstance(reached, _properties.Reading)
                else:
                    self.assertTrue(inspect.isfunction(reached))

    def test_tables_name_what_there_is(self):
        names = {function["name"] for function in api()["functions"]}
        self.assertEqual((set(OTHERWISE) | set(LEFT_OUT)) - names, set())

    def test_parameters_have_the_same_names_in_the_same_order(self):
        for function in api()["functions"]:
            short, kind = function["short"], KINDS.get(function["object"])
            if kind is None or short == "destroy":
                continue
            name = "__init__" if short == "create" else python_name(function)
            reached = inspect.getattr_static(kind, name)
            if not inspect.isfunction(reached):
                continue
            taken = list(inspect.signature(reached).parameters)[1:]
            wanted = [RENAMED.get(p["name"], p["name"]) for p in function["parameters"]
                      if p["role"] in ("value", "array", "bytes", "handle", "callbacks") and
                      (p["direction"] in ("in", "inout") or p["role"] == "bytes")]
            if short.startswith("write_f"):
                wanted.insert(1, wanted.pop())  # values come before the range, which can be left out
            if short.startswith("read_f"):
                taken = taken[: len(wanted)]
            if short == "save":
                wanted = []  # gives bytes
            with self.subTest(function["name"]):
                self.assertEqual(taken, wanted)

    def test_enumerations_have_the_same_values(self):
        ours = {name: kind for name, kind in vars(contdyn).items()
                if inspect.isclass(kind) and issubclass(kind, enum.IntEnum)}
        for described in api()["enums"]:
            name = "".join(word.capitalize() for word in described["name"].split("_")[1:])
            with self.subTest(name):
                self.assertEqual({value.name.lower(): value.value for value in ours.pop(name)},
                                 {value["short"]: value["value"] for value in described["values"]})
        self.assertEqual(ours, {})

    def test_every_status_has_its_exception(self):
        kinds = [errors.CLASSES[status] for status in contdyn.Status if status != contdyn.Status.OK]
        self.assertEqual(len(set(kinds)), len(kinds))
        for kind in kinds:
            self.assertTrue(issubclass(kind, contdyn.Error))
            self.assertIs(getattr(contdyn, kind.__name__), kind)
        for kind, standard in ((contdyn.InvalidValueError, ValueError), (contdyn.RangeError, IndexError),
                               (contdyn.OutOfMemoryError, MemoryError), (contdyn.SizeError, OverflowError),
                               (contdyn.UnsupportedError, NotImplementedError)):
            self.assertTrue(issubclass(kind, standard))

    def test_structs_have_the_same_members(self):
        for described in api()["callbacks"]:
            struct = getattr(_api, described["name"][3:].capitalize())
            self.assertEqual([name for name, _ in struct._fields_], [member["name"] for member in described["members"]])

    def test_the_library_has_every_function_and_its_version(self):
        for name in _api.FUNCTIONS:
            self.assertTrue(hasattr(_library.library, name), name)
        self.assertEqual(contdyn.__version__, ".".join(map(str, contdyn.version())))
        self.assertEqual(contdyn.__version__, api()["version"])
        self.assertEqual(contdyn.__version__, _library.library.cd_version_string().decode())
        self.assertEqual(contdyn.library_path(), _library.path)

    def test_words_of_the_library(self):
        self.assertEqual(contdyn.status_name(3), "CD_ERROR_VALUE")
        self.assertEqual(contdyn.status_name(-1), "CD_ERROR_UNKNOWN")
        self.assertRegex(contdyn.build_info(), "objects: .*chain")
        self.assertEqual(contdyn.kernels_name(contdyn.Kernels.AVX512), "AVX-512")
        self.assertEqual(contdyn.runnable_kernels()[0], contdyn.Kernels.PLAIN)

    def test_what_saved_bytes_are_of(self):
        water = contdyn.Water(5, 3, 0.1, 0.2, contdyn.Precision.FLOAT32)
        self.assertEqual(contdyn.saved_shape(water.save()), (contdyn.Kind.WATER, 5, 3, 1, contdyn.Precision.FLOAT32))
        with self.assertRaises(contdyn.FormatError):
            contdyn.saved_shape(b"none")

    def test_everything_public_is_documented(self):
        for name in contdyn.__all__:
            target = getattr(contdyn, name)
            if not (inspect.isclass(target) and target.__module__.startswith("contdyn")):
                continue
            self.assertTrue(inspect.getdoc(target), name)
            for member, value in vars(target).items():
                if not member.startswith("_") and (inspect.isfunction(value) or isinstance(value, property) or
                                                   isinstance(value, (_properties.Reading, _properties.State))):
                    self.assertTrue(inspect.getdoc(value), f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
