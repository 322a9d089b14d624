"""The package as pip installs it, into environments of their own and without a network: from a source distribution,
which builds the library, and with a library given; and all that README.md says, by a new user in an empty folder."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import venv
import zipfile
from pathlib import Path

PYTHON = Path(__file__).resolve().parents[2]
ROOT = PYTHON.parents[1]
README = (PYTHON / "README.md").read_text(encoding="utf-8")
LIBRARY = os.environ["CONTDYN_LIBRARY"]


def clean(**more):
    """The environment of a user who has set nothing, without a network."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("CONTDYN", "PYTHON", "PIP"))}
    return {**kept, "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1", **more}


class Place(unittest.TestCase):
    """An empty folder."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = Path(place.name)

    def run_here(self, *command, **more):
        done = subprocess.run(list(map(str, command)), cwd=self.folder, env=clean(**more), stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout


class Installed(Place):
    def environment(self):
        """A Python of its own, that sees the system's packages."""
        venv.create(self.folder / "env", system_site_packages=True, with_pip=True, symlinks=True)
        return self.folder / "env" / "bin" / "python"

    def test_a_source_distribution_builds_a_wheel_that_passes_the_tests(self):
        python = self.environment()
        build = f"import sys; sys.path.insert(0, '.'); import backend; print(backend.build_sdist({str(self.folder)!r}))"
        name = subprocess.run([sys.executable, "-c", build], cwd=PYTHON, env=clean(), capture_output=True, text=True,
                              check=True).stdout.strip()
        self.run_here(python, "-m", "pip", "wheel", "--no-index", "--no-build-isolation", self.folder / name)
        wheel, = self.folder.glob("*.whl")
        self.assertRegex(wheel.name, r"^contdyn-[0-9.]+-py3-none-(many|musl)linux_[0-9]+_[0-9]+_\w+\.whl$")
        with zipfile.ZipFile(wheel) as archive:
            self.assertIsNone(archive.testzip())
            names = archive.namelist()
        self.assertEqual([name for name in names if "libcontdyn" in name][0].split("/")[0], "contdyn")
        self.assertIn("contdyn/py.typed", names)
        self.run_here(python, "-m", "pip", "install", wheel)
        found = self.run_here(python, "-c", "import contdyn; print(contdyn.library_path())").strip()
        self.assertTrue(Path(found).is_relative_to((self.folder / "env").resolve()), found)
        said = self.run_here(python, PYTHON / "tests" / "run.py", "--installed")
        self.assertIn(found, said)

    def test_the_installed_library_is_found(self):
        """By a package that has none beside it, as from `cmake --install`."""
        shutil.copytree(PYTHON / "contdyn", self.folder / "contdyn")
        soname = re.search(rb"\0(libcontdyn\.so\.[0-9.]+)\0", Path(LIBRARY).read_bytes()).group(1).decode()
        shutil.copy(LIBRARY, self.folder / soname)
        asked = ["-c", "import contdyn; print(contdyn.library_path(), contdyn.Water(1, 1, 1, 1).volume)"]
        self.assertEqual(self.run_here(sys.executable, *asked, LD_LIBRARY_PATH=str(self.folder)).split()[-1], "0.0")
        self.assertEqual(self.run_here(sys.executable, *asked, CONTDYN_LIBRARY=LIBRARY).split(), [LIBRARY, "0.0"])

    def test_a_library_that_is_not_there(self):
        shutil.copytree(PYTHON / "contdyn", self.folder / "contdyn")
        for named, said in (("/nowhere/libcontdyn.so", "CONTDYN_LIBRARY names no library"),
                            (sys.executable, "CONTDYN_LIBRARY names no library")):
            done = subprocess.run([sys.executable, "-c", "import contdyn"], cwd=self.folder, capture_output=True,
                                  env=clean(CONTDYN_LIBRARY=named), text=True, check=False)
            self.assertIn(said, done.stderr)
            self.assertIn("ImportError", done.stderr)


class Readme(Place):
    """Its blocks in their order: files are written, commands run in one shell, what `run` prints is compared."""

    BLOCK = re.compile(r"<!-- (file|command|output): (.+?) -->\n```\w*\n(.*?)```", re.DOTALL)

    def test_a_new_user_gets_what_it_says(self):
        (self.folder / "contdyn").symlink_to(ROOT)
        script = [f"set -e; export PATH={Path(sys.executable).parent}:$PATH"]
        outputs = {}
        for kind, name, text in self.BLOCK.findall(README):
            if kind == "file":
                (self.folder / name).write_text(text, encoding="utf-8")
            elif kind == "output":
                outputs[name] = text
            elif name == "build tree":
                # its first line makes this build
                script.append(f"echo '== {name}'; CONTDYN_LIBRARY={LIBRARY} {text.splitlines()[-1]}")
            else:
                script.append(f"echo '== {name}'\n{text}")
            if name == "install":
                script.append("unset CONTDYN_LIBRARY")  # only spared it a build
        self.assertEqual(sorted(outputs), ["cloth", "run"])
        said = self.run_here("bash", "-c", "\n".join(script), CONTDYN_LIBRARY=LIBRARY)
        parts = dict(part.split("\n", 1) for part in said.split("== ")[1:])
        self.assertEqual(list(parts), ["install", "run", "cloth", "gallery", "build tree"])
        for name, output in outputs.items():
            self.assertEqual(parts[name], output)
        self.assertIn("objects: chain", parts["build tree"])

    def test_tables_of_errors_and_names_are_true(self):
        import importlib
        sys.path.insert(0, str(PYTHON))
        contdyn = importlib.import_module("contdyn")
        for name in re.findall(r"contdyn\.(\w+)", README):
            if name not in ("so", "pc"):
                self.assertTrue(hasattr(contdyn, name), name)
        with self.assertRaisesRegex(contdyn.InvalidValueError, "cd_chain_set_mass: mass is -1, "):
            contdyn.Chain(1, 1, 1).mass = -1


if __name__ == "__main__":
    unittest.main()
