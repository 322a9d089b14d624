"""Arrays of numbers: NumPy's where it is there, else views of memory with the same shapes."""
import array
from ctypes import addressof, c_char
from itertools import product
from math import prod
from typing import TYPE_CHECKING, Any, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

from ._api import Precision
from .errors import RangeError, as_float

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

if TYPE_CHECKING:
    from numpy.typing import NDArray

    #: What reads and views give: a NumPy array, or a View where there is no NumPy.
    Array = NDArray[Any]

#: What writes take: an array, anything with the buffer protocol, nested sequences, or one number for all places.
Values = Any

_FORMATS = {Precision.FLOAT32: "f", Precision.FLOAT64: "d"}
Index = Union[int, slice, Tuple[Union[int, slice], ...]]


class View:
    """Numbers in memory, by shape and strides: what stands for a NumPy array where there is none.

    Indexed by integers and slices, one for each of the leading dimensions; iterated over the first dimension.
    `shape`, `strides` (in bytes), `ndim`, `itemsize`, `format`, `readonly` and `tolist()` are those of a memoryview.
    """

    __slots__ = ("_numbers", "_start", "_steps", "shape")

    def __init__(self, numbers: memoryview, shape: Sequence[int], steps: Sequence[int], start: int = 0) -> None:
        self._numbers = numbers  # one-dimensional; start and steps count numbers in it
        self._start = start
        self._steps = tuple(steps)
        self.shape: Tuple[int, ...] = tuple(shape)

    @property
    def ndim(self) -> int:
        """How many dimensions."""
        return len(self.shape)

    @property
    def size(self) -> int:
        """How many numbers."""
        return prod(self.shape)

    @property
    def strides(self) -> Tuple[int, ...]:
        """Bytes from one place to the next, along each dimension."""
        return tuple(step * self.itemsize for step in self._steps)

    @property
    def itemsize(self) -> int:
        """Bytes of a number."""
        return self._numbers.itemsize

    @property
    def format(self) -> str:
        """The numbers' type, as in struct: f, d, H or I."""
        return self._numbers.format

    @property
    def readonly(self) -> bool:
        """Whether the numbers cannot be assigned."""
        return self._numbers.readonly

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("a view without dimensions has no length")
        return self.shape[0]

    def __iter__(self) -> Iterator[Any]:
        return (self[i] for i in range(len(self)))

    def __getitem__(self, index: Index) -> Any:
        found = self._part(index)
        return found if found.shape else self._numbers[found._start]

    def __setitem__(self, index: Index, value: Values) -> None:
        part = self._part(index)
        numbers = dense(value, part.shape, None)
        for place, number in zip(part._places(), numbers.pointed_at):
            self._numbers[place] = number

    def __float__(self) -> float:
        if self.size != 1:
            raise TypeError("only a view of one number is a number")
        return float(self._numbers[self._start])

    def __repr__(self) -> str:
        return f"View({self.tolist()})" if self.size <= 100 else f"<View of shape {self.shape}>"

    def _part(self, index: Index) -> "View":
        keys = index if isinstance(index, tuple) else (index,)
        if len(keys) > self.ndim:
            raise IndexError(f"{len(keys)} indices for {self.ndim} dimensions")
        start, shape, steps = self._start, [], []
        for key, extent, step in zip(keys, self.shape, self._steps):
            if isinstance(key, slice):
                picked = range(extent)[key]
                start += (picked.start if len(picked) else 0) * step
                shape.append(len(picked))
                steps.append(picked.step * step)
            else:
                start += range(extent)[key] * step
        shape += self.shape[len(keys):]
        steps += self._steps[len(keys):]
        return View(self._numbers, shape, steps, start)

    def _places(self) -> Iterator[int]:
        for place in product(*map(range, self.shape)):
            yield self._start + sum(i * step for i, step in zip(place, self._steps))

    def tolist(self) -> Any:
        """The numbers as nested lists."""
        if not self.shape:
            return self._numbers[self._start]
        return [part.tolist() for part in self] if self.ndim > 1 else next(self._rows()).tolist()

    def whole(self) -> memoryview:
        """The memory itself in one row; the view must show all of it, in order."""
        if self._steps != tuple(prod(self.shape[k + 1:]) for k in range(self.ndim)) or self.size != len(self._numbers):
            raise ValueError("the view is not dense, or a part of another")
        return self._numbers

    def flat(self) -> "array.array[float]":
        """A copy of the numbers in one row."""
        copy: "array.array[float]" = array.array(self.format)
        for numbers in self._rows():
            copy.frombytes(numbers.tobytes())
        return copy

    def _rows(self) -> Iterator[memoryview]:
        """The numbers along the last dimension, row by row."""
        n, step = (self.shape[-1], self._steps[-1]) if self.shape else (1, 1)
        for place in product(*map(range, self.shape[:-1])):
            start = self._start + sum(i * step for i, step in zip(place, self._steps))
            if step > 0:
                yield self._numbers[start:start + n * step:step]
            else:
                yield memoryview(array.array(self.format, (self._numbers[start + i * step] for i in range(n))))


if not TYPE_CHECKING:
    Array = View if numpy is None else numpy.ndarray


class Dense(NamedTuple):
    """Numbers one after the other in memory, for as long as this lives."""

    address: int
    length: int
    precision: Precision
    pointed_at: Any


# ---- from the caller to the library ---------------------------------------------------------------------------------


def dense(values: Values, shape: Sequence[int], precision: Optional[Precision]) -> Dense:
    """The values for an array of this shape, dense; in float32 if they are or it is asked for, else in float64.

    One number stands for all of them. Otherwise shapes must agree, but for dimensions of 1; one row of all will do.
    """
    taken = _taken_numpy(values, precision) if numpy is not None else _taken(values, precision)
    if taken.shape == ():
        taken = taken.filled(prod(shape))
    elif prod(taken.shape) != prod(shape) or (len(taken.shape) > 1 and _long(taken.shape) != _long(shape)):
        raise RangeError(f"values of shape {tuple(taken.shape)} for places of shape {tuple(shape)}")
    return taken.pointed_at()


def row(values: Values) -> Dense:
    """All the values in one row, in float64."""
    taken = _taken_numpy(values, Precision.FLOAT64) if numpy is not None else _taken(values, Precision.FLOAT64)
    return taken.pointed_at()


def pairs(values: Values) -> Dense:
    """Places of two numbers each, in one row, in float64."""
    places = row(values)
    if places.length % 2:
        raise RangeError(f"{places.length} numbers are no pairs")
    return places


def _long(shape: Sequence[int]) -> List[int]:
    return [extent for extent in shape if extent != 1]


class _Taken(NamedTuple):
    numbers: Any  # a NumPy array, or an array.array
    shape: Tuple[int, ...]

    def filled(self, count: int) -> "_Taken":
        if numpy is not None:
            return _Taken(numpy.full(count, self.numbers), (count,))
        return _Taken(self.numbers * count, (count,))

    def pointed_at(self) -> Dense:
        if numpy is not None:
            kind = Precision.FLOAT32 if self.numbers.dtype == numpy.float32 else Precision.FLOAT64
            return Dense(self.numbers.ctypes.data, self.numbers.size, kind, self.numbers)
        kind = Precision.FLOAT32 if self.numbers.typecode == "f" else Precision.FLOAT64
        address = self.numbers.buffer_info()[0] or addressof(_NOTHING)
        return Dense(address, len(self.numbers), kind, self.numbers)


def _taken_numpy(values: Values, precision: Optional[Precision]) -> _Taken:
    given = numpy.asarray(values)
    if given.dtype == object and all(hasattr(number, "__float__") for number in given.flat):  # as Fraction is
        given = numpy.array([as_float("a value", number) for number in given.flat]).reshape(given.shape)
    if given.dtype.kind not in "fiub":
        raise TypeError(f"values of type {given.dtype} are no real numbers")
    if precision is None:
        precision = Precision.FLOAT32 if given.dtype == numpy.float32 else Precision.FLOAT64
    return _Taken(numpy.require(given, _FORMATS[precision], ("C", "A")), given.shape)


def _taken(values: Values, precision: Optional[Precision]) -> _Taken:
    if isinstance(values, View):
        wanted = _FORMATS[precision] if precision is not None else "f" if values.format == "f" else "d"
        return _Taken(array.array(wanted, values.flat()), values.shape)
    if isinstance(values, (bytes, bytearray, str)):
        raise TypeError(f"{type(values).__name__} holds no real numbers")
    try:
        memory = memoryview(values)
    except TypeError:
        shape, numbers = _nested(values)
        return _Taken(array.array(_FORMATS[precision or Precision.FLOAT64], numbers), shape)
    wanted = _FORMATS[precision] if precision is not None else "f" if memory.format == "f" else "d"
    if memory.format == wanted and memory.c_contiguous:
        copied = array.array(wanted)
        copied.frombytes(memory.cast("B") if memory.nbytes else b"")
        return _Taken(copied, memory.shape or ())
    return _Taken(array.array(wanted, _nested(memory.tolist())[1]), memory.shape or ())


def _nested(values: Any) -> Tuple[Tuple[int, ...], List[float]]:
    if isinstance(values, View):
        return values.shape, values.flat().tolist()
    if hasattr(values, "__float__") or hasattr(values, "__index__"):
        return (), [as_float("a value", values)]
    if isinstance(values, (str, bytes)):
        raise TypeError(f"{type(values).__name__} holds no real numbers")
    parts = [_nested(value) for value in values]
    shapes = {shape for shape, _ in parts}
    if len(shapes) > 1:
        raise RangeError("the values are nested unevenly")
    inner = shapes.pop() if shapes else ()
    return (len(parts), *inner), [number for _, numbers in parts for number in numbers]


# ---- from the library to the caller ---------------------------------------------------------------------------------


def empty(shape: Sequence[int], kind: str) -> Any:
    """A new array; kind: f, d, or H and I for indices."""
    if numpy is not None:
        return numpy.empty(shape, kind)
    return dense_view(memoryview(array.array(kind, bytes(prod(shape) * array.array(kind).itemsize))), shape)


def dense_view(numbers: memoryview, shape: Sequence[int]) -> View:
    steps = [prod(shape[k + 1:]) for k in range(len(shape))]
    return View(numbers, shape, steps)


def target(out: Any, count: int) -> Dense:
    """Where the library may write `count` numbers: an array of float32 or float64, dense and writable."""
    memory = out.whole() if isinstance(out, View) else memoryview(out)
    precision = {"f": Precision.FLOAT32, "d": Precision.FLOAT64}.get(memory.format)
    if precision is None:
        raise TypeError(f"out holds numbers of format {memory.format!r}, must be float32 or float64")
    if memory.readonly or not memory.c_contiguous:
        raise ValueError("out must be writable and dense")
    if memory.nbytes != count * memory.itemsize:
        raise RangeError(f"out holds {memory.nbytes // memory.itemsize} numbers, must hold {count}")
    return Dense(address_of(memory), count, precision, out)


def address_of(memory: memoryview) -> int:
    """Where a writable, dense buffer lies; it must be kept alive by other means."""
    return addressof(c_char.from_buffer(memory)) if memory.nbytes else addressof(_NOTHING)


_NOTHING = c_char()


def show(memory: Any, precision: Precision, shape: Sequence[int], strides: Sequence[int]) -> Any:
    """A read-only array over a ctypes array of bytes, which it keeps alive."""
    shown = memoryview(memory).toreadonly()
    if numpy is not None:
        flat = numpy.frombuffer(shown, _FORMATS[precision])  # its flag `writeable` cannot be set any more
        return numpy.ndarray(shape, flat.dtype, flat, 0, strides)
    numbers = shown.cast("B").cast(_FORMATS[precision])
    return View(numbers, shape, [stride // numbers.itemsize for stride in strides])
