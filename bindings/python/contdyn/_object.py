"""What chain, membrane and water have in common."""
import threading
import weakref
from ctypes import ArgumentError, byref, c_char, c_size_t, c_void_p, create_string_buffer
from ctypes import Array as CArray
from math import prod
from types import TracebackType
from typing import TYPE_CHECKING, Any, Callable, ClassVar, Dict, List, Optional, Sequence, Tuple, Type, TypeVar

from . import _arrays
from ._api import FIELDS, Field, FieldInfo, Kernels, Method, Precision
from ._arrays import Array, Values
from ._callbacks import Allocator, Parallel, Provider, Runner, Shape
from ._library import MOST, Functions, failure
from ._properties import Reading, Setting
from .errors import DisabledError, Error, HandleError, InvalidEnumError, RangeError

Self = TypeVar("Self", bound="Object")


class Handle(c_void_p):
    """Owns one object of the library. All that may still reach its memory holds one: the Python object until it is
    closed, every array that shows a field, and, being its argument, every call on its way."""

    destroy: Callable[..., Any]
    provider: Optional[Provider] = None
    runner: Optional[Runner] = None
    shapes: Dict[int, Shape]
    shown: Dict[Field, "weakref.ref[CArray[c_char]]"]

    def memory(self, field: Field, address: int, size: int) -> "CArray[c_char]":
        """A field's bytes, which keep the handle alive."""
        known = self.is_shown(field)
        if known is not None and len(known) == size:
            return known
        memory = (c_char * size).from_address(address)
        memory.handle = self  # type: ignore[attr-defined]
        self.shown[field] = weakref.ref(memory)
        return memory

    def is_shown(self, field: Field) -> "Optional[CArray[c_char]]":
        """The field's bytes, if an array shows them."""
        known = self.shown.get(field)
        return known() if known else None

    def __del__(self) -> None:
        if self.value:
            self.destroy(self)


class Object:
    """An object of the library. Use it in a `with` statement, close() it, or leave that to Python.

    Calls run without Python's global lock: on distinct objects from different threads at once, on one object one after
    the other.
    """

    _kind: ClassVar[str]
    _own_class: ClassVar[Type["Object"]]  # Chain, Membrane or Water
    _c: ClassVar[Functions]
    _fields: ClassVar[Dict[int, FieldInfo]]
    __slots__ = ("_handle", "_made_of", "_precision", "_components", "_parallel", "_step", "_lock", "__weakref__")
    _handle: Optional[Handle]
    _made_of: Tuple[Any, ...]
    _precision: Precision
    _components: int
    _parallel: Parallel
    _step: Callable[..., int]
    _lock: "threading._RLock"

    def __init_subclass__(cls, kind: str = "", **rest: Any) -> None:
        super().__init_subclass__(**rest)
        if kind:
            cls._kind, cls._own_class = kind, cls
            cls._c, cls._fields = Functions(f"cd_{kind}_"), FIELDS[kind]

    # ---- life -------------------------------------------------------------------------------------------------------

    def _create(self, allocator: Optional[Allocator], *arguments: Any) -> None:
        provider = Provider(allocator) if allocator is not None else None
        self._lock = threading.RLock()
        made = c_void_p()
        status = self._c.create(*arguments, byref(provider.struct) if provider else None, byref(made))
        if status:
            raise provider.cause(failure(status)) if provider else failure(status)
        handle = Handle(made.value)
        self._step = self._c.step.raw
        handle.destroy, handle.provider, handle.shown, handle.shapes = self._c.destroy.raw, provider, {}, {}
        self._handle = handle
        *sizes, precision = self._get("get_shape")
        self._precision = Precision(precision)
        self._made_of = (*sizes, self._precision)
        self._components = sizes[-1] if self._kind != "water" else 1
        self._parallel = None

    def close(self) -> None:
        """Releases the object: calls on it raise HandleError from now on. Closing twice does nothing.

        Arrays that show its fields stay valid, with the numbers as they are; its memory goes when the last one does.
        """
        self._handle = None

    @property
    def closed(self) -> bool:
        """Whether it was closed."""
        return self._handle is None

    def __enter__(self: Self) -> Self:
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 where: Optional[TracebackType]) -> None:
        self.close()

    def __repr__(self) -> str:
        *sizes, precision = self._made_of if self.closed else self._get("get_shape")
        shape = ", ".join(map(str, (*sizes, Precision(precision).name)))
        return f"<{'closed ' if self.closed else ''}{type(self).__name__}({shape})>"

    if not TYPE_CHECKING:  # to which every name would be known
        def __getattr__(self, name):
            """Of the C API's names says where they have gone: the library's manual has them."""
            own = next((own for own in (name[4:], name[4:] + "_")
                        if name[:4] in ("get_", "set_") and isinstance(getattr(type(self), own, None), Reading)), None)
            error = AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}"
                                   + (f": it is the property {own!r}" if own else ""))
            error.name, error.obj = name, self
            raise error

    def __reduce__(self) -> Tuple[Any, ...]:
        """Copies and pickles hold what save() gives: not the allocator, `parallel`, `kernels` or callbacks."""
        return _restored, (type(self), self._made_of, self.save()), getattr(self, "__dict__", None) or None

    # ---- calls ------------------------------------------------------------------------------------------------------

    def _call(self, name: str, *arguments: Any) -> None:
        function = getattr(self._c, name)
        with self._lock:
            status = function(self._handle, *arguments)
        if status:
            raise self._failure(status)

    def _get(self, name: str, *arguments: Any) -> List[Any]:
        """The results of a function whose other arguments are these."""
        results = [kind() for kind in getattr(self._c, name).results]
        self._call(name, *arguments, *map(byref, results))
        return [result.value for result in results]

    def _failure(self, status: int) -> Error:
        handle = self._handle
        if handle is None:
            return HandleError(f"this {type(self).__name__} is closed")
        error, provider = failure(status), handle.provider
        for shape in handle.shapes.values():
            shape.cause(error)
        return provider.cause(error) if provider else error

    # ---- method -----------------------------------------------------------------------------------------------------

    method = Setting(Method, "How steps are made, a Method; default Method.IMPLICIT.")
    lambda_ = Setting(float, "lambda of Method.IMPLICIT, in [0, 1]: 1/2 keeps energy and is second order, the "
                             "default of chains and membranes; above it fast motion dies out; 1 is backward Euler.")
    kernels = Setting(Kernels, "The instructions that steps are made of, a Kernels; default the fastest of "
                               "runnable_kernels(). For tests and measurements: all give the same bits.")

    @property
    def parallel(self) -> Parallel:
        """How a step is spread over threads; None, the default: not at all. The results are the same, bit for bit.

        A number: of threads, this one among them. A concurrent.futures.ThreadPoolExecutor: its threads and this one.
        A function run(count, task): it calls task(i) once for every i in range(count), in any order, on any threads,
        and returns when all are done. What it raises is raised again when the step is over. It must not call
        the object.
        """
        return self._parallel

    @parallel.setter
    def parallel(self, way: Parallel) -> None:
        runner = Runner(way) if way is not None else None
        with self._lock:
            handle = self._handle
            self._call("set_parallel", byref(runner.struct) if runner else None)
            assert handle is not None
            handle.runner = runner
            self._parallel = way
            self._step = self._c.step.raw
            if runner is not None:
                self._step = self._step_in_parallel

    def _step_in_parallel(self, handle: Optional[Handle], dt: float, count: int) -> int:
        status = self._c.step.raw(handle, dt, count)
        if handle is not None and handle.runner is not None:
            handle.runner.raise_kept()
        return status

    # ---- parameters -------------------------------------------------------------------------------------------------

    drag = Setting(float, "Drag [1/s], >= 0: velocities die out at this rate; default 0.")

    # ---- time -------------------------------------------------------------------------------------------------------

    def step(self, dt: float, count: int = 1) -> None:
        """Makes `count` steps of dt [s] each, in [1e-30, 1e30]. Never allocates in the library.

        DivergedError: a number left the finite range. ToleranceError: a coupled solve of a membrane, or a step of a
        rope, ended short of its tolerance. CallbackError: a callback of a collider gave no distance. All steps have
        been made in all these cases.
        """
        if not (hasattr(count, "__index__") and 0 <= count <= _MOST_STEPS):
            self._c.step.refuse(2, count)
        with self._lock:
            try:
                status = self._step(self._handle, dt, count)
            except ArgumentError:
                status = self._c.step(self._handle, dt, count)  # tells what is wrong
        if status:
            raise self._failure(status)

    def stable_dt(self) -> float:
        """The longest dt [s] at which Method.SYMPLECTIC_EULER stays bounded, whatever method is set; inf if nothing can
        swing. How sharp it is depends on the kind of object: see the C header. UnsupportedError of ropes."""
        return float(self._get("stable_dt")[0])

    time = Reading(float, "Simulated time [s] since it was made, reset or loaded.")
    steps = Reading(int, "Steps made since it was made, reset or loaded.")
    factorizations = Reading(int, "How many factorizations it has made. Not part of the saved state.")
    memory = Reading(int, "Bytes it holds from its allocator.")

    # ---- fields -----------------------------------------------------------------------------------------------------

    def enable_field(self, field: Field) -> None:
        """Switches a field on, filled with the present uniform values. On already: nothing happens."""
        self._call("enable_field", field)

    def disable_field(self, field: Field) -> None:
        """Switches a field off and releases its memory: uniform values again.

        BufferError while an array shows the field; nothing has changed then.
        """
        with self._lock:
            if self._handle is not None and self._handle.is_shown(field) is not None:
                raise BufferError(f"{_name(field)} cannot be switched off while an array shows it")
            self._call("disable_field", field)

    def view(self, field: Field) -> Array:
        """A field in the object's own memory: a read-only array without a copy, of the object's precision.

        Its numbers change with every write and step. It stays valid as long as it is held, even when the object is
        closed; what would switch the field off raises BufferError meanwhile.
        """
        shape, precision = self._whole(field), self._precision
        dimensions = len(getattr(self._c, "view").results) - 1
        data, strides = c_void_p(), [c_size_t() for _ in range(dimensions)]
        with self._lock:
            handle = self._handle
            self._call("view", field, byref(data), *map(byref, strides))
            assert handle is not None and data.value is not None
            axes = self._axes([stride.value for stride in strides])
            last = sum((extent - 1) * stride for extent, stride in zip(shape, axes))
            memory = handle.memory(Field(field), data.value, last + (8 if precision == Precision.FLOAT64 else 4))
        shown: Array = _arrays.show(memory, precision, shape, axes)
        return shown

    def _axes(self, strides: List[int]) -> List[int]:
        """The strides of `view` in the order of an array's dimensions."""
        raise NotImplementedError

    def _whole(self, field: Field) -> Tuple[int, ...]:
        """The shape of all of a field."""
        raise NotImplementedError

    def _known(self, field: Field) -> FieldInfo:
        """What this kind of object has of a field; raises what the library says of one that is none of its own."""
        info = self._fields.get(field)
        if info is None:
            self._call("read_f64", field, 0, 0, 0, 0, _arrays.address_of(memoryview(bytearray(8))), 0)
            raise InvalidEnumError(f"{field!r} is no field of a {self._kind}")
        return info

    def _read(self, field: Field, place: Sequence[int], shape: Tuple[int, ...], precision: Optional[Precision],
              out: Any) -> Any:
        if out is None:
            wanted = Precision(precision) if precision is not None else self._precision
            out = _arrays.empty(shape, "f" if wanted == Precision.FLOAT32 else "d")
        elif precision is not None:
            raise TypeError("out has a precision of its own")
        numbers = _arrays.target(out, prod(shape))
        name = "read_f32" if numbers.precision == Precision.FLOAT32 else "read_f64"
        self._call(name, field, *place, numbers.address, numbers.length)
        return out

    def _write(self, field: Field, place: Sequence[int], shape: Tuple[int, ...], values: Values) -> None:
        numbers = _arrays.dense(values, shape, None)
        name = "write_f32" if numbers.precision == Precision.FLOAT32 else "write_f64"
        self._call(name, field, *place, numbers.address, numbers.length)

    def _write_all(self, field: Field, values: Values) -> None:
        raise NotImplementedError

    def _shown(self, field: Field) -> Array:
        """The field as its property tells it."""
        return self.view(field)

    # ---- keeping ----------------------------------------------------------------------------------------------------

    def hash(self) -> int:
        """A 64-bit hash of everything save() would write. Equal on every machine, compiler and vector width."""
        return int(self._get("hash")[0])

    def save_size(self) -> int:
        """How many bytes save() would give."""
        return int(self._get("save_size")[0])

    def save(self) -> bytes:
        """The whole state: shape, parameters, fields, time; all the future depends on but the callbacks."""
        with self._lock:
            buffer, written = create_string_buffer(self.save_size()), c_size_t()
            self._call("save", buffer, len(buffer), byref(written))
        return buffer.raw[:written.value]

    def load(self, data: Any) -> None:
        """Takes over a state that save() gave, of an object of the same shape and precision.

        It switches fields on and off as they were; BufferError if an array shows one that would go.
        FormatError, MismatchError: nothing has changed.
        """
        state = bytes(memoryview(data))
        with self._lock:
            shown = self._shown_fields()
            if shown:  # which fields would stay is known to an object that loads the same
                with self._own_class(*self._made_of) as trial:
                    trial._call("load", state, len(state))
                    self._refuse_to_lose(shown, trial)
            self._call("load", state, len(state))

    def copy_state(self, source: "Object") -> None:
        """Becomes what `source` is, as save and load would, without the bytes; of the same shape and precision.

        BufferError if an array shows a field that would be switched off.
        """
        if not isinstance(source, self._own_class):
            raise TypeError(f"source is a {type(source).__name__}, must be a {self._own_class.__name__}")
        first, second = sorted((self, source), key=id)  # two that copy each other must not wait for each other
        with first._lock, second._lock:
            handle = source._handle
            if handle is None:
                raise HandleError(f"the source, a {type(source).__name__}, is closed")
            self._refuse_to_lose(self._shown_fields(), source)
            self._call("copy_state", handle)

    def _shown_fields(self) -> List[Field]:
        """Fields that could be switched off and that an array shows."""
        handle = self._handle
        if handle is None:
            return []
        return [field for field in handle.shown
                if not self._fields[field].always and handle.is_shown(field) is not None]

    @staticmethod
    def _refuse_to_lose(shown: List[Field], other: "Object") -> None:
        for field in shown:
            try:
                other.view(field)
            except DisabledError:
                raise BufferError(f"{_name(field)} would be switched off while an array shows it") from None

    def reset(self) -> None:
        """Back to the start: the state to 0, time and steps too. Parameters and fields stay."""
        self._call("reset")


def _restored(kind: Type[Object], made_of: Tuple[Any, ...], state: bytes) -> Object:
    restored = kind.__new__(kind)
    kind._own_class.__init__(restored, *made_of)
    restored.load(state)
    return restored


def _name(field: Field) -> str:
    return f"Field.{Field(field).name}"


def rest(first: int, n: Optional[int], extent: int, what: str) -> int:
    """How many from `first` on: n, or all there are."""
    if not hasattr(first, "__index__") or not (n is None or hasattr(n, "__index__")):
        raise TypeError(f"{what} from {first!r} on, {n!r} of them: must be integers")
    count = n if n is not None else max(extent - first, 0)
    if first < 0 or count < 0 or first + count > extent:
        raise RangeError(f"{what} [{first}, {first + count}) of {extent}, must lie in [0, {extent})")
    return count


_MOST_STEPS = MOST["size"]
