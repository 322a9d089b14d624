"""Builds the package for pip (PEP 517), with nothing but the standard library, CMake and a C++ compiler.

    pip wheel --no-index bindings/python        a wheel that contains the library

The library is built from the sources around this folder; in a source distribution they lie in its folder `library`.
Environment: CONTDYN_LIBRARY, a shared library to put into the wheel instead of building one; CMAKE_ARGS, options for
CMake, such as -DCMAKE_CXX_COMPILER=clang++.
"""
import base64
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCES = HERE / "library" if (HERE / "library").exists() else HERE.parents[1]
VERSION = ".".join(re.findall(r"#define CD_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)",
                              (SOURCES / "include" / "contdyn" / "base.h").read_text(encoding="utf-8")))
NAME = f"contdyn-{VERSION}"
ABI = re.match(r"0\.\d+|\d+", VERSION).group()  # before 1.0 every minor version may change the API
LIBRARY = {"darwin": f"libcontdyn.{ABI}.dylib", "win32": "contdyn.dll"}.get(sys.platform, f"libcontdyn.so.{ABI}")


def metadata():
    return f"""\
Metadata-Version: 2.1
Name: contdyn
Version: {VERSION}
Summary: Ropes, hair, sheets, drums and water that never blow up
Requires-Python: >=3.9
Provides-Extra: numpy
Requires-Dist: numpy; extra == "numpy"
Description-Content-Type: text/markdown

""" + (HERE / "README.md").read_text(encoding="utf-8")


def tag(built):
    """Where the library runs, in pip's words: on Linux the C library that it needs, by the versions of its symbols."""
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    if platform.startswith("linux_"):
        machine = platform[len("linux_"):]
        needed = [int(minor) for minor in re.findall(rb"\0GLIBC_2\.(\d+)(?:\.\d+)?(?=\0)", built)]
        if needed:
            platform = f"manylinux_2_{max(17, *needed)}_{machine}"  # pip knows none older than 2.17 on all machines
        elif re.search(rb"\0libc\.(musl-\w+\.)?so(\.1)?\0", built):
            platform = f"musllinux_1_1_{machine}"
    return f"py3-none-{platform}"


def options():
    """For CMake: no symbols on Linux; on macOS the processors and the oldest system that this Python is for."""
    if sys.platform == "linux":
        return ["-DCMAKE_SHARED_LINKER_FLAGS=-s"]
    if sys.platform == "darwin":
        _, oldest, machine = sysconfig.get_platform().split("-")
        processors = {"universal2": "arm64;x86_64"}.get(machine, machine)
        return [f"-DCMAKE_OSX_ARCHITECTURES={processors}", f"-DCMAKE_OSX_DEPLOYMENT_TARGET={oldest}"]
    return []


def library(folder):
    """The shared library, built in a folder or given."""
    given = os.environ.get("CONTDYN_LIBRARY")
    if given:
        return Path(given)
    subprocess.run(["cmake", "-S", SOURCES, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DCONTDYN_TESTS=OFF",
                    "-DCONTDYN_REPORT=OFF", *options(), *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
    subprocess.run(["cmake", "--build", folder, "--config", "Release", "--target", "contdyn",
                    "--parallel", str(os.cpu_count() or 1)], check=True)
    for pattern in ("libcontdyn.so", "libcontdyn.dylib", "*contdyn.dll"):
        for found in Path(folder).rglob(pattern):
            return found
    raise FileNotFoundError(f"CMake has built no shared library in {folder}")


# ---- what pip calls -------------------------------------------------------------------------------------------------


def get_requires_for_build_wheel(_settings=None):
    return []


def get_requires_for_build_sdist(_settings=None):
    return []


def prepare_metadata_for_build_wheel(directory, _settings=None):
    info = Path(directory, f"{NAME}.dist-info")
    info.mkdir()
    (info / "METADATA").write_text(metadata(), encoding="utf-8")
    return info.name


def build_wheel(directory, _settings=None, _metadata_directory=None):
    with tempfile.TemporaryDirectory() as folder:
        built = library(folder).read_bytes()
    platform = tag(built)
    name = f"{NAME}-{platform}.whl"
    record = []
    with zipfile.ZipFile(Path(directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:

        def put(where, data, mode=0o644):
            entry = zipfile.ZipInfo(where, (1980, 1, 1, 0, 0, 0))  # the same bytes whenever it is built
            entry.external_attr, entry.compress_type = (0o100000 | mode) << 16, zipfile.ZIP_DEFLATED
            wheel.writestr(entry, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{where},sha256={digest},{len(data)}")

        for source in sorted((HERE / "contdyn").glob("*.py*")):
            if source.is_file():
                put(f"contdyn/{source.name}", source.read_bytes())
        put("contdyn/py.typed", b"")
        put(f"contdyn/{LIBRARY}", built, 0o755)
        info = f"{NAME}.dist-info"
        put(f"{info}/METADATA", metadata().encode())
        put(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: contdyn\nRoot-Is-Purelib: false\nTag: {platform}\n".encode())
        put(f"{info}/RECORD", "\n".join([*record, f"{info}/RECORD,,", ""]).encode())
    return name


def build_sdist(directory, _settings=None):
    """This folder, and beside it as `library` what the library is built from."""
    name = f"{NAME}.tar.gz"
    with tempfile.TemporaryDirectory() as folder, tarfile.open(Path(directory, name), "w:gz") as archive:
        tree = Path(folder, NAME)
        shutil.copytree(HERE, tree, ignore=shutil.ignore_patterns("__pycache__", ".*", "build", "library"))
        others = shutil.ignore_patterns("__pycache__", "python", "javascript", "lua", "rust", "csharp")
        for part in ("CMakeLists.txt", "include", "src", "pkgconfig", "bindings"):
            source, target = SOURCES / part, tree / "library" / part
            if source.is_dir():
                shutil.copytree(source, target, ignore=others)
            else:
                target.parent.mkdir(exist_ok=True)
                shutil.copy(source, target)
        (tree / "PKG-INFO").write_text(metadata(), encoding="utf-8")
        archive.add(tree, NAME)
    return name
