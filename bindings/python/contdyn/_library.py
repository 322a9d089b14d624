"""Finds the shared library and gives its functions their types."""
import ctypes.util
import os
import sys
from ctypes import CDLL, ArgumentError
from enum import IntEnum
from operator import index
from pathlib import Path
from typing import Any, Callable, Iterator, List, NoReturn, Tuple

from . import _api
from ._api import FUNCTIONS, TYPES, VERSION
from .errors import CLASSES, Error, RangeError, UnsupportedError, as_float, shown

_ABI = f"0.{VERSION[1]}" if VERSION[0] == 0 else f"{VERSION[0]}"  # before 1.0 every minor version may change the API
_FILE_NAMES = {
    "darwin": (f"libcontdyn.{_ABI}.dylib", "libcontdyn.dylib"),
    "win32": ("contdyn.dll", "libcontdyn.dll"),
}.get(sys.platform, (f"libcontdyn.so.{_ABI}", "libcontdyn.so"))


def _candidates() -> Iterator[str]:
    """Where the library may be, the likeliest first: in a wheel, a build tree, an installation."""
    here = Path(__file__).resolve().parent
    root = here.joinpath("..", "..", "..").resolve()
    folders = [here]
    if (root / "include" / "contdyn" / "contdyn.h").exists():  # the package lies in the project's sources
        folders.append(root / "build" / "src")
    for folder in folders:
        yield from (str(folder / name) for name in _FILE_NAMES if (folder / name).exists())
    yield _FILE_NAMES[0]  # wherever the system's loader looks
    found = ctypes.util.find_library("contdyn")
    if found:
        yield found
    for prefix in dict.fromkeys((sys.prefix, sys.base_prefix, "/usr/local", "/opt/local", "/opt/homebrew")):
        multiarch = getattr(sys.implementation, "_multiarch", "")
        for folder in (Path(prefix, "lib", multiarch), Path(prefix, "lib"), Path(prefix, "lib64")):
            yield from (str(folder / name) for name in _FILE_NAMES if (folder / name).exists())


def _open() -> Tuple[CDLL, str]:
    named = os.environ.get("CONTDYN_LIBRARY")
    if named:
        try:
            return CDLL(named), named
        except OSError as error:
            raise ImportError(f"CONTDYN_LIBRARY names no library that can be loaded: {error}") from None
    tried: List[str] = []
    for candidate in _candidates():
        try:
            return CDLL(candidate), candidate
        except OSError as error:
            tried.append(str(error))
    raise ImportError("contdyn's shared library was not found; tell where it is in the environment variable "
                      "CONTDYN_LIBRARY, as in CONTDYN_LIBRARY=build/src/libcontdyn.so\n" + "\n".join(tried))


def _check_version() -> None:
    number = library.cd_version()
    version = (number // 1000000, number // 1000 % 1000, number % 1000)
    if version[:2] != VERSION[:2]:
        raise ImportError(f"{path} is contdyn {'.'.join(map(str, version))}, and this package is written for "
                          f"{VERSION[0]}.{VERSION[1]}")


def _parameters(name: str) -> List[Tuple[str, str]]:
    words = FUNCTIONS[name].partition(": ")[2]
    return [(word.split()[0], word.split()[1]) for word in words.split(", ")] if words else []


def _set_types() -> None:
    for name, text in FUNCTIONS.items():
        function = getattr(library, name, None)
        if function is not None:  # or this build leaves it out
            function.restype = TYPES[text.partition(":")[0]]
            function.argtypes = [TYPES[kind] for _, kind in _parameters(name)]


library, path = _open()
_set_types()
_check_version()

MOST = {"size": 2 ** (8 * ctypes.sizeof(ctypes.c_size_t)) - 1, "int": 2**31 - 1}
LEAST = {"size": 0, "int": -(2**31)}
WORDS = {"size": "an integer", "int": "an integer, an enumerator or a bool", "double": "a number"}


def failure(status: int) -> Error:
    """The exception for what the last call of this thread returned."""
    return CLASSES.get(status, Error)(library.cd_error_message().decode())


class Function:
    """A function of the library that takes an object first and returns a status.

    ctypes would pass integers that do not fit modulo their type; here they are refused.
    """

    def __init__(self, name: str) -> None:
        if not hasattr(library, name):
            raise UnsupportedError(f"{name}: this build of the library leaves it out")
        self.name = name
        self.raw: Callable[..., int] = getattr(library, name)
        parameters = _parameters(name)
        self.count = len(parameters)
        self.names = [name for name, _ in parameters[1:]]
        self.integers = [(k, kind) for k, (_, kind) in enumerate(parameters) if kind in MOST]
        self.results: List[Any] = [TYPES[kind]._type_ for _, kind in parameters if kind.endswith("*")]

    def __call__(self, *arguments: Any) -> int:
        """The status."""
        if len(arguments) != self.count:
            raise TypeError(f"{self.name} takes {self.count - 1} values besides the object, not {len(arguments) - 1}")
        try:
            for k, kind in self.integers:
                if not (hasattr(arguments[k], "__index__") and LEAST[kind] <= arguments[k] <= MOST[kind]):
                    self.refuse(k, arguments[k])
            return self.raw(*arguments)
        except ArgumentError as error:
            k = int(str(error).split()[1].rstrip(":")) - 1  # "argument 2: ..."
            self.refuse(k, arguments[k])

    def refuse(self, k: int, value: Any) -> NoReturn:
        """Argument k is out of the range of its type, or of another type."""
        name, kind = _parameters(self.name)[k]
        if kind in MOST and hasattr(value, "__index__"):
            raise RangeError(f"{self.name}: {name} is {shown(index(value))}, must be in [{LEAST[kind]}, {MOST[kind]}]")
        if kind == "double" and (hasattr(value, "__float__") or hasattr(value, "__index__")):
            as_float(f"{self.name}: {name}", value)
        wanted = WORDS.get(kind, f"a {kind}")
        meant = "".join(f", as {kinds.__name__}.{value.upper()} is" for kinds in IntEnum.__subclasses__()
                        if kind == "int" and isinstance(value, str) and kinds.__module__ == _api.__name__
                        and value.upper() in kinds.__members__)
        raise TypeError(f"{self.name}: {name} is {shown(value)}, must be {wanted}{meant}") from None


def text(name: str, number: int) -> str:
    """What a function tells of a number, be that an enumerator or none."""
    told: Any = Function(name)(number)
    return str(told.decode())


class Functions:
    """The functions of one kind of object, by their names without prefix, each bound when it is first needed."""

    def __init__(self, prefix: str) -> None:
        self.prefix = prefix

    def __getattr__(self, short: str) -> Function:
        if short.startswith("__"):
            raise AttributeError(short)
        function = Function(self.prefix + short)
        setattr(self, short, function)
        return function
