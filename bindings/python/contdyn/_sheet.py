"""What membrane and water have in common: a lattice in two directions."""
from typing import Any, NamedTuple, Optional, Tuple

from . import _arrays
from ._api import Field
from ._arrays import Array, Values
from ._library import MOST
from ._object import Object, rest


class Vertices(NamedTuple):
    """For drawing: float32 arrays with a row per vertex."""

    #: (n, 3), metres
    position: Array
    #: (n, 3), unit length, or 0 where there is none
    normal: Array


class Sheet(Object):
    """A lattice in two directions. Arrays have the second direction first: [v][u], [y][x], as in the C API."""

    __slots__ = ()

    def _places(self, field: Field) -> Tuple[int, int]:
        """How many places of a field there are along the first and the second direction."""
        raise NotImplementedError

    def _values_per_place(self, field: Field) -> Tuple[int, ...]:
        return (self._components,) if self._fields[field].components else ()

    def _whole(self, field: Field) -> Tuple[int, ...]:
        self._known(field)
        return (*reversed(self._places(field)), *self._values_per_place(field))

    def _rectangle(self, field: Field, first: Tuple[int, int], n: Tuple[Optional[int], Optional[int]]) -> Any:
        """The rectangle as the C API takes it, and an array's shape."""
        self._known(field)
        first_extent, second_extent = self._places(field)
        n_first = rest(first[0], n[0], first_extent, "places along the first direction")
        n_second = rest(first[1], n[1], second_extent, "places along the second direction")
        return (*first, n_first, n_second), (n_second, n_first, *self._values_per_place(field))

    def _write_all(self, field: Field, values: Values) -> None:
        with self._lock:
            place, shape = self._rectangle(field, (0, 0), (None, None))
            self._write(field, place, shape, values)

    def _vertices(self, extra: int, count: int) -> Any:
        """position, normal and `extra` numbers more of each vertex."""
        numbers = _arrays.empty((count, 6 + extra), "f")
        offsets = [24] if extra else []
        address = _arrays.target(numbers, count * (6 + extra)).address
        self._call("write_vertices", address, count * (6 + extra) * 4, (6 + extra) * 4, 0, 12, *offsets)
        return numbers

    def _write_vertices(self, buffer: Any, stride: int, *offsets: Optional[int]) -> None:
        memory = memoryview(buffer)
        self._call("write_vertices", _arrays.address_of(memory), memory.nbytes, stride,
                   *(MOST["size"] if offset is None else offset for offset in offsets))

    def _indices(self, count: int, places: int, *skip_dry: int) -> Any:
        kind = "H" if places <= 65535 else "I"
        numbers = _arrays.empty((count // 3, 3), kind)
        memory = numbers.whole() if isinstance(numbers, _arrays.View) else memoryview(numbers)
        self._call("write_indices", *skip_dry, _arrays.address_of(memory), memory.nbytes, memory.itemsize)
        return numbers

    def _write_indices(self, buffer: Any, index_size: int, *skip_dry: int) -> None:
        memory = memoryview(buffer)
        self._call("write_indices", *skip_dry, _arrays.address_of(memory), memory.nbytes, index_size)
