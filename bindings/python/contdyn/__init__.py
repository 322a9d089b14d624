"""contdyn: ropes, hair, sheets, drums and water that never blow up.

    from contdyn import Chain, End, Node

    rope = Chain(strands=1, springs=100, components=2)
    rope.position = [[i / 100, 0] for i in range(101)]   # metres
    rope.stiffness, rope.gravity = 4.905, (0, -9.81)
    rope.set_end(End.FIRST, Node.PINNED)
    rope.step(1 / 60, 60)
    print(rope.position[0, -1])

Chain, Membrane and Water are the three objects of the C library; their methods have its functions' names, its set_ and
get_ pairs are properties. A field of the state is an array that shows the object's own memory, read-only and without a
copy; assigning to it writes it. Arrays are NumPy's where it is installed, else a View. Quantities are in SI units, or
in any other consistent set.
"""
from ctypes import byref, c_int32, c_size_t
from typing import Any, NamedTuple, Tuple

from . import _library
from ._api import (BedRule, Border, Edge, End, Field, Kernels, Kind, MassRule, Method, Momentum, Node, Outside,
                   Precision, Shape, Side, Solver, Status)
from ._arrays import Array, View
from ._body import Attachment, Collider, Convergence, Energy, Load, Resistance, Sleep, Tolerance
from ._callbacks import Allocator, Distance, Parallel, Task
from ._sheet import Vertices
from .chain import Chain, ChainShape
from .errors import (CallbackError, DisabledError, DivergedError, Error, FormatError, HandleError, InvalidEnumError,
                     InvalidValueError, MismatchError, NullError, OutOfMemoryError, RangeError, SizeError,
                     ToleranceError, UnsupportedError)
from .membrane import Effort, Membrane, MembraneShape, RestLength, Ring, Stiffness
from .water import (Account, Hull, HullDrag, HullPose, Hulls, HullWays, Limited, Sample, SideState, Water,
                    WaterEnergy, WaterShape, WaterVertices)

__all__ = [
    "Account", "Allocator", "Array", "Attachment", "BedRule", "Border", "CallbackError", "Chain", "ChainShape",
    "Collider", "Convergence", "DisabledError", "Distance", "DivergedError", "Edge", "Effort", "End", "Energy", "Error",
    "Field", "FormatError", "HandleError", "Hull", "HullDrag", "HullPose", "HullWays", "Hulls", "InvalidEnumError",
    "InvalidValueError", "Kernels", "Kind", "Limited", "Load", "MassRule", "Membrane", "MembraneShape", "Method",
    "MismatchError", "Momentum", "Node", "NullError", "OutOfMemoryError", "Outside", "Parallel", "Precision",
    "RangeError", "Resistance", "RestLength", "Ring", "Sample", "SavedShape", "Shape", "Side", "SideState", "SizeError",
    "Sleep", "Solver", "Status", "Stiffness", "Task", "Tolerance", "ToleranceError", "UnsupportedError", "Vertices",
    "View", "Water", "WaterEnergy", "WaterShape", "WaterVertices", "build_info", "kernels_name", "library_path",
    "runnable_kernels", "saved_shape", "status_name", "version",
]


def version() -> Tuple[int, int, int]:
    """The library's version: (major, minor, patch)."""
    number = _library.library.cd_version()
    return number // 1000000, number // 1000 % 1000, number % 1000


def build_info() -> str:
    """Compiler, target and what was left out of this build of the library, in one line."""
    return str(_library.library.cd_build_info().decode())


def runnable_kernels() -> Tuple[Kernels, ...]:
    """The kernels that this build has and this processor runs, the fastest last."""
    those = _library.library.cd_runnable_kernels()
    return tuple(kernels for kernels in Kernels if those >> kernels & 1)


def kernels_name(kernels: Kernels) -> str:
    """The instructions' name, such as "AVX-512"; of Kernels.PLAIN those that it was built with, such as "SSE2"."""
    return _library.text("cd_kernels_name", kernels)


class SavedShape(NamedTuple):
    """What saved bytes are of: the kind of object, and what it was made with. Of a chain strands and springs, of a
    membrane nu and nv, of water nx and ny; components, of water 1; and the precision."""

    kind: Kind
    first: int
    second: int
    components: int
    precision: Precision


def saved_shape(data: Any) -> SavedShape:
    """What save() of an object gave these bytes of, so that one can be made to load them. FormatError: none."""
    state = bytes(memoryview(data))
    kind, first, second, components, precision = results = c_int32(), c_size_t(), c_size_t(), c_size_t(), c_int32()
    status = _library.library.cd_saved_shape(state, len(state), *map(byref, results))
    if status:
        raise _library.failure(status)
    return SavedShape(Kind(kind.value), first.value, second.value, components.value, Precision(precision.value))


def status_name(status: int) -> str:
    """Name of a status, such as "CD_ERROR_VALUE"; "CD_ERROR_UNKNOWN" for a number that is none."""
    return _library.text("cd_status_name", status)


def library_path() -> str:
    """The shared library in use, as it was found: CONTDYN_LIBRARY, beside the package, a build tree, the system's."""
    return _library.path


__version__: str = _library.library.cd_version_string().decode()
