"""The type hints hold, and tell a user's mistakes."""
import importlib.util
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from support import NUMPY, PYTHON

USE = Path(__file__).with_name("typed_use.py")


@unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
@unittest.skipUnless(NUMPY, "NumPy tells what arrays are")
class Types(unittest.TestCase):
    def mypy(self, *arguments):
        with tempfile.TemporaryDirectory() as cache:
            return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--no-error-summary", "--cache-dir", cache,
                                   *arguments], cwd=PYTHON, capture_output=True, text=True, check=False)

    def test_the_package_and_its_use(self):
        said = self.mypy("contdyn", str(USE)).stdout.splitlines()
        wrong = {number for number, line in enumerate(USE.read_text(encoding="utf-8").splitlines(), 1)
                 if line.endswith("# WRONG")}
        found = {int(re.match(r".*typed_use.py:(\d+): error", line).group(1)) for line in said
                 if "typed_use.py" in line and ": error" in line}
        self.assertEqual(found, wrong)
        self.assertEqual([line for line in said if "typed_use.py" not in line], [])


if __name__ == "__main__":
    unittest.main()
