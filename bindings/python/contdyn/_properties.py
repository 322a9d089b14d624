"""Properties over the get_ and set_ functions of the C API."""
from ctypes import c_double
from typing import TYPE_CHECKING, Any, Callable, Generic, Iterable, NoReturn, Optional, Tuple, TypeVar, Union, overload

from ._api import Field
from ._arrays import Array, Values, row

if TYPE_CHECKING:
    from ._object import Object

T = TypeVar("T")


class Reading(Generic[T]):
    """What a get_ function tells: its results, made one value. Reading it calls the function."""

    def __init__(self, make: Callable[..., T], doc: str) -> None:
        self.make = make
        self.__doc__ = doc

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name.rstrip("_")

    @overload
    def __get__(self, an_object: None, owner: type) -> "Reading[T]": ...
    @overload
    def __get__(self, an_object: "Object", owner: type) -> T: ...

    def __get__(self, an_object: "Optional[Object]", owner: type) -> "Union[Reading[T], T]":
        if an_object is None:
            return self
        return self.make(*an_object._get("get_" + self.name))

    def __set__(self, an_object: "Object", value: NoReturn) -> None:
        raise AttributeError(f"{self.name} can be read only")


class Setting(Reading[T]):
    """A parameter: what a get_ function tells, and the set_ function of that name changes."""

    def __set__(self, an_object: "Object", value: T) -> None:
        an_object._call("set_" + self.name, value)


class SettingOfSeveral(Reading[T]):
    """A parameter of several numbers, told as a named tuple; assigned any sequence of them."""

    def __set__(self, an_object: "Object", value: Iterable[float]) -> None:
        function = "set_" + self.name
        try:
            values = tuple(value)
        except TypeError:
            values = ()
        names = getattr(an_object._c, function).names
        if len(values) != len(names):
            raise TypeError(f"{self.name} takes {len(names)} values, ({', '.join(names)}), not {value!r}")
        an_object._call(function, *values)


class ReadingPerComponent(Reading[Tuple[float, ...]]):
    """One number per component."""

    def __init__(self, doc: str) -> None:
        super().__init__(tuple, doc)

    def __get__(self, an_object: Any, owner: type) -> Any:
        if an_object is None:
            return self
        numbers = (c_double * an_object._components)()
        an_object._call("get_" + self.name, numbers, len(numbers))
        return tuple(numbers)


class SettingPerComponent(ReadingPerComponent):
    def __set__(self, an_object: "Object", value: Values) -> None:
        numbers = row(value)
        an_object._call("set_" + self.name, numbers.address, numbers.length)


class State:
    """A field: read, an array that shows it without a copy, if it lies in memory as a whole; assigned, it is written."""

    def __init__(self, field: Field, doc: str) -> None:
        self.field = field
        self.__doc__ = doc

    @overload
    def __get__(self, an_object: None, owner: type) -> "State": ...
    @overload
    def __get__(self, an_object: "Object", owner: type) -> Array: ...

    def __get__(self, an_object: "Optional[Object]", owner: type) -> "Union[State, Array]":
        return self if an_object is None else an_object._shown(self.field)

    def __set__(self, an_object: "Object", value: Values) -> None:
        an_object._write_all(self.field, value)
