"""Exceptions: one class for each status of the C API, each an Error that carries the library's message."""
from typing import ClassVar, Dict, Optional, SupportsFloat, Type

from ._api import Status

__all__ = [
    "Error", "NullError", "HandleError", "InvalidValueError", "InvalidEnumError", "RangeError", "SizeError",
    "OutOfMemoryError", "DisabledError", "UnsupportedError", "DivergedError", "FormatError", "MismatchError",
    "ToleranceError", "CallbackError",
]


class Error(Exception):
    """Anything that the library refuses or reports. `status` tells what, the text why, with the offending value."""

    status: ClassVar[Optional[Status]] = None


class NullError(Error, ValueError):
    """A pointer that may not be null is null. The package passes none: seeing this is a bug in it."""

    status = Status.ERROR_NULL


class HandleError(Error, ValueError):
    """The object is closed, or of another kind."""

    status = Status.ERROR_HANDLE


class InvalidValueError(Error, ValueError):
    """A number outside its valid range, or NaN or infinity where it has no meaning."""

    status = Status.ERROR_VALUE


class InvalidEnumError(Error, ValueError):
    """Not one of the enumeration's values."""

    status = Status.ERROR_ENUM


class RangeError(Error, ValueError, IndexError):
    """An index, a range or an array's length that does not fit the object."""

    status = Status.ERROR_RANGE


class SizeError(Error, OverflowError):
    """A size that cannot be represented in memory."""

    status = Status.ERROR_SIZE


class OutOfMemoryError(Error, MemoryError):
    """The allocator gave no memory."""

    status = Status.ERROR_MEMORY


class DisabledError(Error, RuntimeError):
    """The field is not switched on: see enable_field."""

    status = Status.ERROR_DISABLED


class UnsupportedError(Error, NotImplementedError):
    """A combination that this object or this build of the library cannot do."""

    status = Status.ERROR_UNSUPPORTED


class DivergedError(Error, ArithmeticError):
    """The state left the finite range during a step. All steps were made; the state can be read, reset or loaded."""

    status = Status.ERROR_DIVERGED


class FormatError(Error, ValueError):
    """The bytes to load are damaged, or of a later version or another kind."""

    status = Status.ERROR_FORMAT


class MismatchError(Error, ValueError):
    """The two objects, or the object and the bytes, differ in shape or precision."""

    status = Status.ERROR_MISMATCH


class ToleranceError(Error, ArithmeticError):
    """An iterative solve ended short of its tolerance. All steps were made, as good as `convergence` tells."""

    status = Status.ERROR_TOLERANCE


class CallbackError(Error, ArithmeticError):
    """A callback gave numbers that it may not, or raised what is this error's cause. All steps were made."""

    status = Status.ERROR_CALLBACK


CLASSES: Dict[int, Type[Error]] = {kind.status: kind for kind in Error.__subclasses__() if kind.status is not None}


def shown(value: object) -> str:
    """A value as messages show it, in some hundred characters at most."""
    try:
        text = str(int(value)) if isinstance(value, int) else repr(value)
    except ValueError:  # of huge integers Python writes no digits
        return "an int of thousands of digits"
    return text if len(text) <= 100 else f"{text[:40]}... ({len(text)} characters)"


def as_float(what: str, value: SupportsFloat) -> float:
    """A number as a float; `what` is what messages call it."""
    try:
        return float(value)
    except OverflowError:
        raise InvalidValueError(f"{what} is {shown(value)}, which is beyond what a float holds") from None
