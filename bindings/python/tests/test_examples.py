"""The gallery runs: with Matplotlib, if it is installed, and without."""
import contextlib
import importlib.util
import io
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import contdyn
from support import NUMPY, PYTHON

EXAMPLES = [PYTHON / "examples" / f"{name}.py" for name in ("rope", "drum", "pool")]
WITHOUT = """
import os, runpy, sys
for name in sys.argv.pop(1).split(","):
    sys.modules[name] = None
sys.argv.pop(0)
sys.path.insert(0, os.path.dirname(sys.argv[0]))
runpy.run_path(sys.argv[0], run_name="__main__")
"""


class Examples(unittest.TestCase):
    def test_the_one_in_the_package(self):
        lines = [line[4:] for line in contdyn.__doc__.splitlines() if line.startswith("    ")]
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            exec("\n".join(lines), {})
        self.assertIn("-1.95", said.getvalue())

    def run_in(self, folder, *arguments):
        environment = {**os.environ, "CONTDYN_LIBRARY": contdyn.library_path(),
                       "PYTHONPATH": str(Path(contdyn.__file__).parents[1])}
        done = subprocess.run([sys.executable, *map(str, arguments)], cwd=folder, env=environment, capture_output=True,
                              text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    @unittest.skipUnless(NUMPY and importlib.util.find_spec("matplotlib"), "Matplotlib is not installed")
    def test_pictures(self):
        for path in EXAMPLES:
            with self.subTest(path.name), tempfile.TemporaryDirectory() as folder:
                self.assertIn(f"{path.stem}.png", self.run_in(folder, path))
                picture = Path(folder, f"{path.stem}.png").read_bytes()
                self.assertEqual(picture[:4], b"\x89PNG")
                self.assertGreater(len(picture), 20000)

    def test_numbers(self):
        missing = "matplotlib" if NUMPY else "matplotlib,numpy"
        for path in EXAMPLES:
            with self.subTest(path.name), tempfile.TemporaryDirectory() as folder:
                said = self.run_in(folder, "-c", WITHOUT, missing, path)
                self.assertGreater(len(said.splitlines()), 4)
                self.assertNotIn("nan", said)
                self.assertEqual(list(Path(folder).iterdir()), [])

    def test_runs_are_the_same_over_any_number_of_processes(self):
        with tempfile.TemporaryDirectory() as folder:
            said = [self.run_in(folder, PYTHON / "examples" / "runs.py", 12, processes) for processes in (1, 2)]
        self.assertEqual(said[0], said[1])
        pulls = [float(line.split()[-2]) for line in said[0].splitlines()]
        self.assertEqual(pulls, sorted(pulls))
        self.assertGreater(pulls[1], 1.5 * pulls[0])


if __name__ == "__main__":
    unittest.main()
