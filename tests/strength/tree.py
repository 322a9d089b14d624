"""A copy of the sources that may be broken, and builds."""

import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def run(*command, cwd=None):
    return subprocess.run(command, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def configure(tree, build, *options):
    configured = run("cmake", "-S", tree, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DCONTDYN_REPORT=OFF",
                     "-DCONTDYN_JAVASCRIPT=OFF", *options)
    if configured.returncode:
        sys.exit(configured.stdout)


def copy_and_configure(folder, *options):
    """Copies the sources to `folder`/tree and configures `folder`/build of them, and returns the two."""
    tree, build = Path(folder).resolve() / "tree", Path(folder).resolve() / "build"
    shutil.rmtree(tree, ignore_errors=True)
    # New times: what an earlier run has built of a broken file is older.
    shutil.copytree(ROOT, tree, ignore=shutil.ignore_patterns("build*", ".git"), copy_function=shutil.copy)
    configure(tree, build, "-DCONTDYN_AVX512=OFF", *options)
    return tree, build
