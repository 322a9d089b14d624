"""What chain and membrane have in common: nodes with mass, joined by springs."""
from ctypes import byref, c_double, c_int32, c_size_t
from typing import NamedTuple, Optional, Sequence, Tuple

from ._api import Field, MassRule, Precision, Shape
from ._arrays import Array, Values, dense, empty, row, target
from ._callbacks import Distance
from ._callbacks import Shape as Asked
from ._object import Object
from ._properties import Reading, ReadingPerComponent, Setting, SettingOfSeveral, SettingPerComponent, State


class Energy(NamedTuple):
    """Energies of the free nodes [J]; lambda = 1/2 keeps their sum."""

    kinetic: float
    #: stretch, bend and attachments
    elastic: float
    #: -sum m g x
    gravity: float


class Attachment(NamedTuple):
    """What ties a node to its target."""

    #: N/m
    stiffness: float
    #: N s/m
    damping: float


class Resistance(NamedTuple):
    """Of the air, per length of a rope [N s/m^2], per area of cloth [N s/m^3]."""

    along: float
    across: float


class Load(NamedTuple):
    """What a collider bears, in the mean over a step."""

    #: along x, y and z [N]
    force: Tuple[float, ...]
    #: about the origin [N m]; about a point p it is less by p x force
    moment: Tuple[float, ...]


class Sleep(NamedTuple):
    """When a body has come to rest: once it has been slower than a speed [m/s] for some seconds."""

    speed: float
    seconds: float


class Tolerance(NamedTuple):
    """When a solver is content: Solver.COUPLED of a membrane, a rope's steps."""

    #: of a residual, as a fraction of the one it starts from, or of a rope's springs, as a fraction of their length; in
    #: [1e-14, 1/2], default 1e-6
    tolerance: float
    #: >= 1; default 100 of a membrane, 200 of a chain
    most_iterations: int


class Convergence(NamedTuple):
    """What the last call of step came to, as Tolerance counts it; zeros if there was nothing to solve."""

    #: the most that a solve, or a step of a rope or of cloth, took
    iterations: int
    #: the largest that one ended with; of cloth a gradient, as a fraction of the one that the step started from
    residual: float


class Collider(NamedTuple):
    """What a rope or cloth touches: of a plane a point and the normal, of a capsule its two ends, of a bed its origin
    and spacings, of a callback its origin."""

    shape: Shape
    first: Tuple[float, ...]
    second: Tuple[float, ...]
    velocity: Tuple[float, ...]
    radius: float
    friction: float


class Body(Object):
    """Nodes with 1 to 4 components that never mix, joined by springs."""

    __slots__ = ()

    mass = Setting(float, "Mass [kg], > 0, of one strand or of the sheet, dealt out by mass_rule; default 1.")
    mass_rule = Setting(MassRule, "How the mass is dealt out to the nodes, a MassRule; default MassRule.EQUAL.")
    bend = Setting(float, "Bend stiffness [N/m], >= 0; default 0.")
    stiffness_damping = Setting(float, "Stiffness damping [s], >= 0: stretch and bend damp at this time constant; a "
                                       "mode of angular frequency w loses amplitude at the rate "
                                       "(drag + stiffness_damping w^2) / 2.")
    gravity = SettingPerComponent("Gravity [m/s^2], one number per component; default 0.")
    sleep = SettingOfSeveral(Sleep, "When a sheet, or the strands of a rope one by one, or those of another chain all "
                                    "together, stop and cost nothing until something changes: once they have been "
                                    "slower than a speed [m/s] for some seconds, (speed, seconds); default (0, 0): "
                                    "never. An acceleration of up to 2 speed / seconds is neglected.")
    awake = Reading(int, "How many nodes are awake: those that the next step moves.")
    energy = Reading(Energy, "Energies of all there is [J]: kinetic, elastic, gravity.")
    momentum = ReadingPerComponent("Momentum of the free nodes [kg m/s], one number per component.")

    position = State(Field.POSITION, "Positions [m], shown without a copy; assigned, they are written.")
    velocity = State(Field.VELOCITY, "Velocities [m/s], likewise. Those of pinned nodes are 0 and stay so.")
    force = State(Field.FORCE, "Forces [N], likewise, once enable_field(Field.FORCE) has been called.")
    target = State(Field.TARGET, "Where attach pulls to and Node.POSED goes [m], likewise, once a node is attached or "
                                 "an end or edge is posed.")

    # What ropes and cloth have: springs that have a length.

    air = SettingOfSeveral(Resistance, "Resistance of the air, per length of a rope [N s/m^2] or area of cloth "
                                       "[N s/m^3]: (along, across) it; default 0. Implicit: bounded at any dt.")
    wind = SettingPerComponent("Velocity of that air [m/s], one number per component; default 0. Field.WIND has one "
                               "for each node.")
    colliders = Setting(int, "How many colliders the nodes of a rope or of cloth stay outside of; default 0: see "
                             "set_plane and set_capsule.")
    thickness = Setting(float, "How thick a rope or cloth is, as the distance [m] that its nodes keep from colliders; "
                               "default 0.")
    loads = Setting(bool, "Whether steps note what they do to each collider, for get_collider_load; default False.")

    def set_plane(self, index: int, point: Values, normal: Values, friction: float = 0) -> None:
        """Makes a collider the half space behind the plane through point [m] that normal points out of."""
        self._set_collider("set_plane", index, point, normal, friction)

    def set_capsule(self, index: int, first: Values, last: Values, radius: float, friction: float = 0) -> None:
        """Makes a collider all that is less than radius [m] away from the line between two ends: a sphere where they
        are the same."""
        self._set_collider("set_capsule", index, first, last, radius, friction)

    def _set_collider(self, name: str, index: int, first: Values, second: Values, *numbers: float) -> None:
        other = row(second)
        place = dense(first, (other.length,), Precision.FLOAT64)
        self._call(name, index, place.address, other.address, other.length, *numbers)

    def set_bed(self, index: int, origin: Values, columns: int, rows: int, column_spacing: float, row_spacing: float,
                heights: Values, friction: float = 0) -> None:
        """Makes a collider all that lies below a bed: heights[row][column] [m] above the origin's last component, at
        the first two components origin + (column * column_spacing, row * row_spacing). With 2 components it has one
        row, along the first. Beyond its border the bed goes on at the border's height."""
        place, numbers = row(origin), row(heights)
        self._call("set_bed", index, place.address, place.length, columns, rows, column_spacing, row_spacing,
                   numbers.address, numbers.length, friction)

    def get_bed(self, index: int) -> Array:
        """A copy of a bed's heights[row][column]; of no rows and columns if the collider is none."""
        columns, rows = c_size_t(), c_size_t()
        with self._lock:
            self._call("get_bed", index, byref(columns), byref(rows), None, 0)
            heights: Array = empty((rows.value, columns.value), "d")
            to = target(heights, rows.value * columns.value)
            self._call("get_bed", index, None, None, to.address, to.length)
        return heights

    def set_callback(self, index: int, distance: Distance, origin: Optional[Values] = None,
                     friction: float = 0) -> None:
        """Makes a collider the shape that distance(time, positions) describes: of positions[place][component], which
        are relative to origin [m], it gives how far outside of the shape they are, distances[place] [m], below 0
        inside, and unit vectors on the way out, normals[place][component]. Steps call it, from threads of `parallel`
        too. It must not call the object; if it raises, steps are made as if nothing were there, and end with
        CallbackError.

        It is not part of the saved state: after a load or a copied state it may have to be set again, without origin.
        """
        asked = Asked(distance)
        place = None if origin is None else row(origin)
        with self._lock:
            handle = self._handle
            self._call("set_callback", index, byref(asked.struct), place.address if place else None,
                       place.length if place else 0, friction)
            assert handle is not None
            handle.shapes[index] = asked

    def remove_collider(self, index: int) -> None:
        """Makes a collider Shape.NONE: nothing touches it."""
        self._call("remove_collider", index)

    def set_collider_velocity(self, index: int, velocity: Values) -> None:
        """Velocity of a collider [m/s], one number per component: steps move it."""
        numbers = row(velocity)
        self._call("set_collider_velocity", index, numbers.address, numbers.length)

    def get_collider(self, index: int) -> Collider:
        """What a collider is, and where now."""
        first, second, velocity = ((c_double * self._components)() for _ in range(3))
        shape, radius, friction = c_int32(), c_double(), c_double()
        self._call("get_collider", index, byref(shape), first, second, velocity, self._components, byref(radius),
                   byref(friction))
        return Collider(Shape(shape.value), tuple(first), tuple(second), tuple(velocity), radius.value, friction.value)

    def get_collider_load(self, index: int) -> Load:
        """What the nodes did to a collider in the last step, pushes and friction: where loads is True."""
        load = (c_double * 6)()
        self._call("get_collider_load", index, load, len(load))
        return Load(tuple(load[:3]), tuple(load[3:]))

    def _attach(self, node: Tuple[int, ...], stiffness: float, damping: float, target: Optional[Values]) -> None:
        if target is None:
            self._call("attach", *node, stiffness, damping, None, 0)
        else:
            numbers = row(target)
            self._call("attach", *node, stiffness, damping, numbers.address, numbers.length)

    def _teleport(self, strand: Tuple[int, ...], rotation: Optional[Values], offset: Values) -> None:
        moved = row(offset)
        if rotation is None:
            self._call("teleport", *strand, None, moved.address, moved.length)
            return
        turned = dense(rotation, (moved.length, moved.length), Precision.FLOAT64)
        self._call("teleport", *strand, turned.address, moved.address, moved.length)

    def _attachment(self, node: Sequence[int]) -> Attachment:
        return Attachment(*self._get("get_attachment", *node))

    def _reaction(self, *node: int) -> Tuple[float, ...]:
        force = (c_double * self._components)()
        self._call("get_reaction", *node, force, len(force))
        return tuple(force)
