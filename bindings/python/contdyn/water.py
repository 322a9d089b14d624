"""Water: a height field of columns over a bed: pool, river, tide, flood."""
from ctypes import byref, c_double
from typing import Any, List, NamedTuple, Optional, Tuple

from . import _arrays
from ._api import BedRule, Border, Field, Momentum, Outside, Precision, Side
from ._arrays import Array, Values
from ._callbacks import Allocator
from ._properties import Reading, Setting, SettingOfSeveral, State
from ._sheet import Sheet


class WaterShape(NamedTuple):
    """What a water was made with."""

    nx: int
    ny: int
    #: m
    dx: float
    #: m
    dy: float
    precision: Precision


class SideState(NamedTuple):
    """What is at a side, as of now."""

    kind: Border
    #: level [m] of Border.OPEN and Border.LEVEL, discharge per metre [m^2/s] of Border.INFLOW, else 0
    value: float
    #: how fast the value changes, per second
    rate: float


class Limited(NamedTuple):
    """What the last call of step held back so that no cell gave more than it had and got."""

    cells: int
    #: m^3
    volume: float


class Account(NamedTuple):
    """The volume account [m^3]."""

    initial: float
    came_in: float
    went_out: float
    #: what the present volume has above initial + came_in - went_out: rounding
    error: float


class WaterEnergy(NamedTuple):
    """Energies [J]."""

    kinetic: float
    potential: float


class WaterVertices(NamedTuple):
    """For drawing: float32 arrays with a row per vertex."""

    #: (n, 3), metres
    position: Array
    #: (n, 3), unit length
    normal: Array
    #: (n,), metres; 0 where it is dry, -1 where the cell is absent
    depth: Array


class Sample(NamedTuple):
    """The water at n places, float64."""

    #: (n,), metres
    surface: Array
    #: (n,), metres
    depth: Array
    #: (n, 3), unit length, z up
    normal: Array
    #: (n, 2), m/s
    velocity: Array


class Hulls(NamedTuple):
    """How many hulls a water has, and the plates of each."""

    count: int  # type: ignore[assignment]  # a tuple has a method of that name
    n_along: int
    n_across: int


class Hull(NamedTuple):
    """What a hull is."""

    #: kg; 0: there is none
    mass: float
    length: float
    width: float
    #: of its plates, m^2
    area: float
    #: (n_across, n_along), metres above the keel; -1 where there is none
    heights: Array


class HullPose(NamedTuple):
    """Where a hull is: its middle, the keel's height, the bow's direction, the rise per metre ahead and to port."""

    x: float
    y: float
    z: float
    ahead_x: float
    ahead_y: float
    pitch: float
    roll: float


class HullWays(NamedTuple):
    """Velocities or forces of a hull: three along axes, three round them."""

    x: float
    y: float
    z: float
    yaw: float
    pitch: float
    roll: float


class HullDrag(NamedTuple):
    """Against the water [N s/m], and on the bed."""

    along: float
    across: float
    friction: float


class Water(Sheet, kind="water"):
    """`nx` x `ny` cells of dx x dy metres, each with a column of water over its bed; velocities on the faces between.

    Arrays have y first: those per cell the shape (ny, nx), per x-face (ny, nx + 1), per y-face (ny + 1, nx). Cell
    (i, j) has its centre at ((i + 1/2) dx, (j + 1/2) dy).

    A new water is dry, over a bed at 0, at rest, walled in, gravity 9.81, density 1000, without drag, with
    Momentum.LINEAR, Method.IMPLICIT and lambda 0.55. The C header water.h tells the equations, what steps suit, and
    where the model is right.
    """

    __slots__ = ()

    def __init__(self, nx: int, ny: int, dx: float, dy: float, precision: Precision = Precision.FLOAT64, *,
                 allocator: Optional[Allocator] = None) -> None:
        """nx, ny >= 1; dx, dy [m]; precision: what depth, bed, velocities and the fields are stored in."""
        self._create(allocator, nx, ny, dx, dy, precision)

    shape = Reading(lambda nx, ny, dx, dy, precision: WaterShape(nx, ny, dx, dy, Precision(precision)),
                    "(nx, ny, dx, dy, precision), as it was made or loaded.")

    # ---- method -----------------------------------------------------------------------------------------------------

    momentum = Setting(Momentum, "Whether water carries its momentum along, a Momentum; default Momentum.LINEAR. Sets "
                                 "lambda_ too: 0.55 for linear, 1/2 for advected.")
    first = Setting(int, "Which way the next step sweeps first: along x (0, the default) or along y (1).")

    # ---- parameters -------------------------------------------------------------------------------------------------

    gravity = Setting(float, "Gravity [m/s^2], in [0, 1e6]; default 9.81.")
    density = Setting(float, "Density [kg/m^3], in [1e-6, 1e6]; default 1000.")
    manning = Setting(float, "Manning's roughness of the bed [s/m^(1/3)], in [0, 1e3]; default 0.")
    sleep = Setting(float, "The height of waves [m] below which water sleeps, in [0, 1e60]; default 0: it never does.")
    bed_rule = Setting(BedRule, "What a write of the bed leaves as it is, a BedRule; default BedRule.LIFTS_WATER.")

    def set_side(self, side: Side, kind: Border, value: float = 0.0, rate: float = 0.0) -> None:
        """What is at a side; `value` now, and its `rate` of change per second from now on.

        Border.OPEN: the level of the water outside [m], into which waves run without an echo. Border.LEVEL: a level [m]
        that is held at the side itself for what flows out slower than its waves. Border.INFLOW: discharge per metre of
        the side [m^2/s]. Both sides of a direction are Border.PERIODIC or neither is.
        """
        self._call("set_side", side, kind, value, rate)

    def get_side(self, side: Side) -> SideState:
        """What is at a side: kind, and value and rate as of now."""
        kind, value, rate = self._get("get_side", side)
        return SideState(Border(kind), value, rate)

    def set_inflow_depth(self, side: Side, depth: float) -> None:
        """Depth of an inflow [m], 0 or in [1e-6, 1e30], in which advected water comes in, as under a gate; by default 0:
        that of the cell at the side."""
        self._call("set_inflow_depth", side, depth)

    def get_inflow_depth(self, side: Side) -> float:
        """Depth of an inflow [m]."""
        return float(self._get("get_inflow_depth", side)[0])

    # ---- fields -----------------------------------------------------------------------------------------------------

    depth = State(Field.DEPTH, "Depths [m], >= 0, shown without a copy; assigned, they are written. Shape (ny, nx).")
    bed = State(Field.BED, "The bed [m], likewise.")
    surface = State(Field.SURFACE, "Bed + depth [m], a new array each time; assigned, it fills the bed up to there.")
    velocity_x = State(Field.VELOCITY_X, "Velocities along x [m/s] on the x-faces, likewise. Shape (ny, nx + 1).")
    velocity_y = State(Field.VELOCITY_Y, "Velocities along y [m/s] on the y-faces, likewise. Shape (ny + 1, nx).")
    source = State(Field.SOURCE, "Depth per second [m/s] that comes in, likewise, once switched on.")
    pressure = State(Field.PRESSURE, "Pressure on the surface [Pa], likewise, once switched on.")
    force_x = State(Field.FORCE_X, "Acceleration along x [m/s^2] on the x-faces, likewise, once switched on.")
    force_y = State(Field.FORCE_Y, "Acceleration along y [m/s^2] on the y-faces, likewise, once switched on.")

    def _places(self, field: Field) -> Tuple[int, int]:
        per = self._fields[field].per
        nx, ny, *_ = self._made_of
        return nx + ("x-face" in per), ny + ("y-face" in per)

    def _axes(self, strides: List[int]) -> List[int]:
        return strides[::-1]

    def read(self, field: Field, first_x: int = 0, first_y: int = 0, n_x: Optional[int] = None,
             n_y: Optional[int] = None, *, precision: Optional[Precision] = None, out: Any = None) -> Any:
        """A copy of a field, of the cells or faces [first_x, first_x + n_x) x [first_y, first_y + n_y).

        None stands for all the rest. The array has the shape (n_y, n_x), and the object's precision or the one asked
        for. `out`: a dense array of float32 or float64 to fill, which is given back.
        """
        with self._lock:
            place, shape = self._rectangle(field, (first_x, first_y), (n_x, n_y))
            return self._read(field, place, shape, precision, out)

    def write(self, field: Field, values: Values, first_x: int = 0, first_y: int = 0, n_x: Optional[int] = None,
              n_y: Optional[int] = None) -> None:
        """Writes a field, of the cells or faces [first_x, first_x + n_x) x [first_y, first_y + n_y).

        values: an array of the shape that read gives, nested sequences, all numbers in one row, or one for all places.
        """
        with self._lock:
            place, shape = self._rectangle(field, (first_x, first_y), (n_x, n_y))
            self._write(field, place, shape, values)

    def _shown(self, field: Field) -> Array:
        shown: Array = self.view(field) if self._fields[field].viewable else self.read(field)
        return shown

    # ---- acting on it -----------------------------------------------------------------------------------------------
    # Discs have their centre at (x, y) [m] and a radius [m] >= 0; shares fall off from the centre.

    def add_volume(self, x: float, y: float, radius: float, volume: float) -> float:
        """Adds volume [m^3] over a disc, or takes it if negative, as far as there is water; what it came to."""
        return float(self._get("add_volume", x, y, radius, volume)[0])

    def add_volume_rectangle(self, first_x: int, first_y: int, n_x: int, n_y: int, volume: float) -> float:
        """Adds volume [m^3] evenly over the cells there of a rectangle, or takes it; what it came to."""
        return float(self._get("add_volume_rectangle", first_x, first_y, n_x, n_y, volume)[0])

    def add_source(self, x: float, y: float, radius: float, rate: float) -> None:
        """Adds a source of rate [m^3/s] over a disc to Field.SOURCE, or a drain if negative; switches that field on."""
        self._call("add_source", x, y, radius, rate)

    def add_source_rectangle(self, first_x: int, first_y: int, n_x: int, n_y: int, rate: float) -> None:
        """The same evenly over the cells there of a rectangle."""
        self._call("add_source_rectangle", first_x, first_y, n_x, n_y, rate)

    def splash(self, x: float, y: float, radius: float, height: float) -> None:
        """Heaps water of the disc, down to `height` [m] at its centre, on the wet cells around it; keeps volume."""
        self._call("splash", x, y, radius, height)

    def impulse(self, x: float, y: float, radius: float, impulse_x: float, impulse_y: float) -> None:
        """Adds an impulse [N s] over a disc."""
        self._call("impulse", x, y, radius, impulse_x, impulse_y)

    # ---- what floats on it ------------------------------------------------------------------------------------------
    # Hulls are numbered from 0; their floors are n_along x n_across plates.

    hulls = SettingOfSeveral(Hulls, "How many hulls there are, and the plates of each: (count, n_along, n_across).")
    hull_energy = Reading(WaterEnergy, "Energies of all hulls [J]: (kinetic, potential).")

    def set_hull(self, index: int, mass: float, length: float, width: float, heights: Optional[Values] = None) -> None:
        """Makes a hull: mass [kg], length and width [m], heights of its plates above the keel; None: a flat floor.

        heights: shape (n_across, n_along) or all in a row; -1 where there is no plate.
        """
        if heights is None:
            self._call("set_hull", index, mass, length, width, None, 0)
        else:
            _, along, across = self.hulls
            floor = _arrays.dense(heights, (across, along), Precision.FLOAT64)
            self._call("set_hull", index, mass, length, width, floor.address, floor.length)

    def set_disc(self, index: int, mass: float, radius: float) -> None:
        """Makes a hull with a flat round floor."""
        self._call("set_disc", index, mass, radius)

    def get_hull(self, index: int) -> Hull:
        """What a hull is: mass (0: none), length, width, area of its plates, and their heights."""
        _, along, across = self.hulls
        heights = _arrays.empty((across, along), "d")
        numbers = [c_double() for _ in range(4)]
        self._call("get_hull", index, *(byref(number) for number in numbers),
                   _arrays.target(heights, along * across).address, along * across)
        mass, length, width, area = (number.value for number in numbers)
        return Hull(mass, length, width, area, heights)

    def remove_hull(self, index: int) -> None:
        """Takes a hull away."""
        self._call("remove_hull", index)

    def launch_hull(self, index: int, x: float, y: float, ahead_x: float = 1.0, ahead_y: float = 0.0) -> None:
        """Lays a hull on the water at (x, y), its bow towards (ahead_x, ahead_y), at rest."""
        self._call("launch_hull", index, x, y, ahead_x, ahead_y)

    def _set_hull(self, name: str, index: int, values: Values) -> None:
        numbers = _arrays.row(values)
        self._call(name, index, numbers.address, numbers.length)

    def _of_hull(self, name: str, index: int, count: int) -> List[float]:
        numbers = (c_double * count)()
        self._call(name, index, numbers, count)
        return list(numbers)

    def set_hull_pose(self, index: int, pose: Values) -> None:
        """A hull's pose: (x, y, z, ahead_x, ahead_y, pitch, roll)."""
        self._set_hull("set_hull_pose", index, pose)

    def get_hull_pose(self, index: int) -> HullPose:
        """The pose of a hull's body."""
        return HullPose(*self._of_hull("get_hull_pose", index, 7))

    def get_hull_floor(self, index: int) -> HullPose:
        """The pose in which a hull's floor lies on the water, to be drawn."""
        return HullPose(*self._of_hull("get_hull_floor", index, 7))

    def set_hull_velocity(self, index: int, velocity: Values) -> None:
        """A hull's velocity: along x, y, z [m/s], of yaw, pitch, roll [1/s]."""
        self._set_hull("set_hull_velocity", index, velocity)

    def get_hull_velocity(self, index: int) -> HullWays:
        """A hull's velocity."""
        return HullWays(*self._of_hull("get_hull_velocity", index, 6))

    def set_hull_force(self, index: int, force: Values) -> None:
        """What acts from outside until it is set anew: forces ahead, to port, up [N]; moments of yaw, pitch, roll."""
        self._set_hull("set_hull_force", index, force)

    def get_hull_force(self, index: int) -> HullWays:
        """What acts on a hull from outside."""
        return HullWays(*self._of_hull("get_hull_force", index, 6))

    def set_hull_drag(self, index: int, along: float, across: float, friction: float = 0.0) -> None:
        """Drag against the water along a hull and across it [N s/m], and friction on the bed."""
        self._call("set_hull_drag", index, along, across, friction)

    def get_hull_drag(self, index: int) -> HullDrag:
        """Drag along and across, and friction."""
        return HullDrag(*self._get("get_hull_drag", index))

    def get_hull_load(self, index: int) -> HullWays:
        """What water and bed did to a hull in the last step: along x, y, z [N]; yaw, pitch, roll [N m]."""
        return HullWays(*self._of_hull("get_hull_load", index, 6))

    def sample_heads(self, at: Values, outside: Outside = Outside.REFUSED) -> Array:
        """How high [m] the water would stand at n places with no hull pressing on it: shape (n,).

        at: shape (n, 2), places (x, y) [m]. outside: what becomes of those that lie outside of the scene.
        """
        places = _arrays.pairs(at)
        n = places.length // 2
        heads: Array = _arrays.empty((n,), "d")
        self._call("sample_heads", places.address, n, outside, _arrays.target(heads, n).address)
        return heads

    # ---- measuring --------------------------------------------------------------------------------------------------

    limited = Reading(Limited, "What the last call of step held back: (cells, volume [m^3]).")
    awake = Reading(int, "How many cells were awake in the last step.")
    volume = Reading(float, "Volume [m^3].")
    account = Reading(Account, "The volume account [m^3]: (initial, came_in, went_out, error).")
    energy = Reading(WaterEnergy, "Energies [J]: (kinetic, potential).")
    wet_area = Reading(float, "Area [m^2] of the cells with water.")

    def restart_account(self) -> None:
        """Starts the volume account anew, from the present volume."""
        self._call("restart_account")

    def get_courant(self, dt: float) -> float:
        """The largest Courant number of a step of dt [s], over directions and wet faces: (|u| + sqrt(g d)) dt / dx."""
        return float(self._get("get_courant", dt)[0])

    def sample(self, at: Values, outside: Outside = Outside.REFUSED) -> Sample:
        """The water at n places inside the scene: surface, depth, the surface's normal, velocity; linear between cells.

        at: shape (n, 2), places (x, y) [m]. outside: what becomes of those that lie outside of the scene.
        """
        places = _arrays.pairs(at)
        n = places.length // 2
        sample = Sample(*(_arrays.empty(shape, "d") for shape in ((n,), (n,), (n, 3), (n, 2))))
        addresses = [_arrays.target(values, n * times).address for values, times in zip(sample, (1, 1, 3, 2))]
        self._call("sample", places.address, n, outside, *addresses)
        return sample

    # ---- drawing ----------------------------------------------------------------------------------------------------

    def vertices(self) -> WaterVertices:
        """A vertex for every cell, cell (i, j) as number j nx + i: position on the surface, normal, depth."""
        nx, ny, *_ = self._made_of
        numbers = self._vertices(1, nx * ny)
        return WaterVertices(numbers[:, :3], numbers[:, 3:6], numbers[:, 6])

    def write_vertices(self, buffer: Any, stride: int, position_offset: int, normal_offset: Optional[int],
                       depth_offset: Optional[int]) -> None:
        """Writes a vertex for every cell into a writable buffer, vertex k at byte k * stride.

        Its position as 3 float32 at position_offset, its unit normal as 3 float32 at normal_offset, its depth as 1
        float32 at depth_offset; None: no normals, no depths. Bytes between are left alone.
        """
        self._write_vertices(buffer, stride, position_offset, normal_offset, depth_offset)

    def get_index_count(self, skip_dry: bool = False) -> int:
        """How many indices write_indices writes now: 3 per triangle. skip_dry leaves out squares without a wet cell."""
        return int(self._get("get_index_count", skip_dry)[0])

    def indices(self, skip_dry: bool = False) -> Array:
        """The triangles as vertex numbers, counter-clockwise seen from above: shape (n, 3)."""
        nx, ny, *_ = self._made_of
        with self._lock:
            indices: Array = self._indices(self.get_index_count(skip_dry), nx * ny, skip_dry)
        return indices

    def write_indices(self, skip_dry: bool, buffer: Any, index_size: int) -> None:
        """Writes the triangles into a writable buffer, as unsigned numbers of index_size 2 or 4 bytes."""
        self._write_indices(buffer, index_size, skip_dry)
