"""Python functions that the library calls: memory, and parallel work."""
import os
import sys
import threading
from concurrent.futures import Executor, ThreadPoolExecutor
from operator import index
from ctypes import c_double, memmove
from typing import Any, Callable, List, Optional, Protocol, Tuple, Union

from . import _api, _arrays
from ._api import Precision
from ._arrays import Array, Values
from .errors import Error

#: What a `parallel` callable gets: task(i) does the i-th part, on any thread.
Task = Callable[[int], None]
#: What may be set as `parallel`: nothing, a number of threads, an executor of threads, or run(count, task).
Parallel = Union[None, int, Executor, Callable[[int, Task], None]]


#: What may be a collider: distance(time, positions) of positions[place][component] gives distances[place], and unit
#: vectors normals[place][component].
Distance = Callable[[float, Array], Tuple[Values, Values]]


class Allocator(Protocol):
    """Memory for one object. Called when it is made, changed in what it needs, and released; never from a step."""

    def allocate(self, size: int, alignment: int) -> Optional[int]:
        """The address of `size` bytes aligned to `alignment`, a power of two; None: there is no memory."""

    def release(self, address: int, size: int, alignment: int) -> None:
        """Gets back what allocate gave."""


class Provider:
    """A caller's allocator, as the C API wants it. What it raises is kept, and stands for no memory."""

    def __init__(self, allocator: Allocator) -> None:
        self.kept: Optional[BaseException] = None
        self.allocator = allocator
        self.struct = _api.Allocator(None, _api.ALLOCATE_FUNCTION(self._allocate), _api.RELEASE_FUNCTION(self._release))

    def _allocate(self, _user: Any, size: int, alignment: int) -> int:
        try:
            return index(self.allocator.allocate(size, alignment) or 0)
        except BaseException as error:  # raised as the cause of OutOfMemoryError
            self.kept = error
            return 0

    def _release(self, _user: Any, address: int, size: int, alignment: int) -> None:
        self.allocator.release(address, size, alignment)

    def cause(self, error: Error) -> Error:
        """The error, with what the allocator raised for its cause."""
        error.__cause__, self.kept = self.kept, None
        return error


class Shape:
    """A caller's distances, as the C API wants them. What the function raises is kept, and stands for no answer."""

    def __init__(self, distance: Distance) -> None:
        if not callable(distance):
            raise TypeError(f"distance is {distance!r}, must be a function of a time and positions")
        self.kept: Optional[BaseException] = None
        self.distance = distance
        self.struct = _api.Distance(None, _api.DISTANCE_FUNCTION(self._tell))

    def _tell(self, _user: Any, time: float, count: int, components: int, positions: int, out_distances: int,
              out_normals: int) -> None:
        try:
            places = (c_double * (count * components)).from_buffer_copy(
                (c_double * (count * components)).from_address(positions))
            shown = _arrays.show(places, Precision.FLOAT64, (count, components), (8 * components, 8))
            distances, normals = self.distance(time, shown)
            for values, shape, to in ((distances, (count,), out_distances),
                                      (normals, (count, components), out_normals)):
                numbers = _arrays.dense(values, shape, Precision.FLOAT64)
                memmove(to, numbers.address, 8 * numbers.length)
        except BaseException as error:  # raised as the cause of CallbackError
            self.kept = self.kept or error

    def cause(self, error: Error) -> None:
        if self.kept is not None:
            error.__cause__, self.kept = self.kept, None


class Runner:
    """A caller's way to work in parallel, as the C API wants it: every part done exactly once, whatever the way does.

    What it raises is kept, the parts that it left out are done here, and raise_kept raises when the step is over.
    """

    def __init__(self, way: Parallel) -> None:
        self.kept: Optional[BaseException] = None
        self.own: Optional[ThreadPoolExecutor] = None
        if isinstance(way, bool) or not (isinstance(way, (int, Executor)) or callable(way)):
            raise TypeError(f"parallel is {way!r}, must be None, a number of threads, an executor, or run(count, task)")
        if isinstance(way, int):
            if way < 1:
                raise ValueError(f"parallel is {way}, must be at least 1")
            self.own = ThreadPoolExecutor(way - 1, "contdyn") if way > 1 else None
        self.threads = way if isinstance(way, int) else getattr(way, "_max_workers", os.cpu_count() or 1) + 1
        self.executor = self.own if isinstance(way, int) else way if isinstance(way, Executor) else None
        self.run_parts: Callable[[int, Task], Any] = way if callable(way) else self._share
        self.struct = _api.Parallel(None, _api.RUN_FUNCTION(self._run))

    def _run(self, _user: Any, count: int, task: Any, context: Any) -> None:
        parts = Parts(count, lambda i: task(context, i))
        try:
            self.run_parts(count, parts)
        except BaseException as error:  # raised again when the step is over
            self.kept = self.kept or error
        while not parts.over:
            try:
                parts.finish()
            except BaseException as error:  # an interrupt from the keyboard: the library must not go on before the rest
                self.kept = self.kept or error

    def _share(self, count: int, task: Task) -> None:
        """Deals the parts out in stripes, the first to this thread; takes back those that no thread has begun."""
        stripes = min(self.threads, count)

        def do_stripe(first: int) -> None:
            for i in range(first, count, stripes):
                task(i)

        futures = []
        if self.executor is not None:
            futures = [self.executor.submit(do_stripe, first) for first in range(1, stripes)]
        do_stripe(0)
        for first, future in enumerate(futures, 1):
            if future.cancel():
                do_stripe(first)
            else:
                future.result()

    def raise_kept(self) -> None:
        error, self.kept = self.kept, None
        if error is not None:
            raise error

    def __del__(self) -> None:
        own = getattr(self, "own", None)
        if own is not None and not sys.is_finalizing():
            own.shutdown(wait=False)


class Parts:
    """The parts of one piece of parallel work: each can be done once, and none once all are over."""

    def __init__(self, count: int, do: Callable[[int], Any]) -> None:
        self.left: List[bool] = [True] * count
        self.running = 0
        self.over = False
        self.changed = threading.Condition()
        self.do = do

    def __call__(self, i: int) -> None:
        with self.changed:
            if self.over:
                raise RuntimeError("this parallel work is over")
            if not 0 <= i < len(self.left):
                raise IndexError(f"part {i} of {len(self.left)}")
            if not self.left[i]:
                raise RuntimeError(f"part {i} is done or being done already")
            self.left[i] = False
            self.running += 1
        try:
            self.do(i)
        finally:
            with self.changed:
                self.running -= 1
                self.changed.notify_all()

    def finish(self) -> None:
        """Does what is left and waits for what runs."""
        for i, waiting in enumerate(self.left):
            if waiting:
                try:
                    self(i)
                except RuntimeError:  # another thread was faster
                    pass
        with self.changed:
            self.changed.wait_for(lambda: self.running == 0)
            self.over = True
