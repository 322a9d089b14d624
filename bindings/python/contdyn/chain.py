"""A chain of nodes joined by springs: massive spring, rope, hair, spline."""
from typing import Any, List, NamedTuple, Optional, Tuple

from . import _arrays
from ._api import End, Field, Node, Outside, Precision
from ._arrays import Array, Values, row
from ._body import Attachment, Body, Convergence, Tolerance
from ._callbacks import Allocator
from ._object import rest
from ._properties import Reading, Setting, SettingOfSeveral


class ChainShape(NamedTuple):
    """What a chain was made with."""

    strands: int
    springs: int
    components: int
    precision: Precision

    @property
    def nodes(self) -> int:
        """Nodes of a strand: springs + 1."""
        return self.springs + 1


class Chain(Body, kind="chain"):
    """`strands` strands of `springs` springs and springs + 1 nodes. Strands share masses, stiffnesses, bends, pins and
    attachments; those of ropes have their own.

    Arrays of positions, velocities, forces and targets have the shape (strands, nodes, components); those of masses,
    bends and pins (nodes,); of stiffnesses (springs,), in a ring one more. In ropes masses, bends, rest angles and pins
    are (strands, nodes); stiffnesses, rest lengths, tensions, strengths and strains (strands, springs).

    Rest length is zero, unless rest_length makes the chain a rope: a free chain draws together, and one stretched
    evenly is held by its ends. A new chain lies with every node at the origin, at rest and free, mass 1, stiffness 1,
    without bend, gravity and damping, with Method.IMPLICIT and lambda 1/2. The C header chain.h tells the energies,
    equations and limits.
    """

    __slots__ = ()

    def __init__(self, strands: int, springs: int, components: int, precision: Precision = Precision.FLOAT64, *,
                 allocator: Optional[Allocator] = None) -> None:
        """strands >= 1; springs >= 0 (0: a single node); components 1 to 4; precision: what the state is stored in."""
        self._create(allocator, strands, springs, components, precision)

    shape = Reading(lambda strands, springs, components, precision:
                    ChainShape(strands, springs, components, Precision(precision)),
                    "(strands, springs, components, precision) and nodes, as it was made.")

    # ---- parameters -------------------------------------------------------------------------------------------------

    stiffness = Setting(float, "Stretch stiffness k [N/m], >= 0, of ropes up to math.inf; k times the number of "
                               "springs for each of them; default 1. Waves run along the chain in sqrt(mass / k) "
                               "seconds.")
    ring = Setting(bool, "Whether the last node is joined to the first; needs 3 nodes. Totals are dealt out anew.")

    def set_end(self, end: End, kind: Node) -> None:
        """What holds an end of every strand: the same as writing Field.PIN there. Node.MATCHED sends no echo back;
        Node.POSED switches Field.TARGET on, and each call of step moves the nodes to what is written there."""
        self._call("set_end", end, kind)

    def get_end(self, end: End) -> Node:
        """What holds an end."""
        return Node(self._get("get_end", end)[0])

    # ---- ropes: springs that have a length --------------------------------------------------------------------------

    rest_length = Setting(float, "Rest length of a strand [m], dealt out evenly to its springs; default 0: they have "
                                 "none. A chain with a rest length is a rope: its 1 to 3 components are directions of "
                                 "space, its springs pull along themselves once they are longer than their length, and "
                                 "it steps by Method.IMPLICIT with lambda in [1/2, 1], without ring, matched end and "
                                 "stiffness damping; with bend it is a rod. It has the fields Field.TENSION and "
                                 "Field.STRAIN and, to be switched on, Field.REST_LENGTH, Field.STRENGTH and "
                                 "Field.WIND; it may have air and wind, and its springs may break.")
    rest_angle = Setting(float, "Rest angle of a strand [rad], by which its last spring is turned from its first at rest; "
                                "default 0: straight. It is dealt out evenly to the joints, at most pi each, and does "
                                "nothing without bend; needs 2 components. Field.REST_ANGLE has one for each node.")
    push = Setting(bool, "Whether springs that are shorter than their length push; default False: they are slack.")
    strength = Setting(float, "The tension at which a spring of a rope breaks [N]; default math.inf: none does. A step "
                              "cuts at most one spring of each strand, the one most beyond its strength. "
                              "Field.STRENGTH has one for each spring; writing Field.STIFFNESS mends a spring.")
    broken = Reading(int, "How many springs broke in the last call of step.")
    tolerance = SettingOfSeveral(Tolerance, "When a rope's step is content: (tolerance, most_iterations); the "
                                            "tolerance is a fraction of the springs' lengths.")
    convergence = Reading(Convergence, "What the last call of step did with a rope: (iterations, residual).")

    def get_reaction(self, strand: int, node: int) -> Tuple[float, ...]:
        """The force [N] with which the springs of a rope pull at a node, one number per component: of a held node, what
        the rope does to whatever holds it."""
        return self._reaction(strand, node)

    # ---- fields -----------------------------------------------------------------------------------------------------

    def _extents(self, field: Field) -> Tuple[int, int]:
        """Strands, and nodes or springs."""
        per = self._known(field).per
        strands, springs, *_ = self._made_of
        places = springs + self.ring if "spring" in per else springs + 1
        return (strands if self._is_own(field) else 1), places

    def _is_own(self, field: Field) -> bool:
        """Whether each strand has its own."""
        info = self._fields[field]
        return "strand" in info.per and (not info.own_in_ropes or self.rest_length > 0)

    def _shape_of(self, field: Field, strands: int, n: int) -> Tuple[int, ...]:
        components = (self._components,) if self._fields[field].components else ()
        return ((strands,) if self._is_own(field) else ()) + (n,) + components

    def _whole(self, field: Field) -> Tuple[int, ...]:
        return self._shape_of(field, *self._extents(field))

    def _axes(self, strides: List[int]) -> List[int]:
        return strides

    def read(self, field: Field, first_strand: int = 0, strands: Optional[int] = None, first: int = 0,
             n: Optional[int] = None, *, precision: Optional[Precision] = None, out: Any = None) -> Any:
        """A copy of a field: strands [first_strand, first_strand + strands), nodes (or springs) [first, first + n).

        None stands for all the rest. The array has the shape (strands, n, components), of fields without components
        (strands, n), of those that strands share (n,), and the object's precision or the one asked for. `out`: a dense
        array of float32 or float64 to fill, which is given back.
        """
        with self._lock:
            place, shape = self._range(field, first_strand, strands, first, n)
            return self._read(field, place, shape, precision, out)

    def write(self, field: Field, values: Values, first_strand: int = 0, strands: Optional[int] = None, first: int = 0,
              n: Optional[int] = None) -> None:
        """Writes a field: strands [first_strand, first_strand + strands), nodes (or springs) [first, first + n).

        values: an array of the shape that read gives, nested sequences, all numbers in one row, or one for all places.
        """
        with self._lock:
            place, shape = self._range(field, first_strand, strands, first, n)
            self._write(field, place, shape, values)

    def _range(self, field: Field, first_strand: int, strands: Optional[int], first: int, n: Optional[int]) -> Any:
        all_strands, all_places = self._extents(field)
        strands = rest(first_strand, strands, all_strands, "strands")
        n = rest(first, n, all_places, "places")
        return (first_strand, strands, first, n), self._shape_of(field, strands, n)

    def _write_all(self, field: Field, values: Values) -> None:
        self.write(field, values)

    # ---- acting on it -----------------------------------------------------------------------------------------------

    def impulse(self, strand: int, node: int, impulse: Values) -> None:
        """Adds impulse [N s], one number per component, to a node; a held one takes none."""
        numbers = row(impulse)
        self._call("impulse", strand, node, numbers.address, numbers.length)

    def teleport(self, strand: int, rotation: Optional[Values], offset: Values) -> None:
        """Moves a strand as a whole, as if it had always been there: every position and target x becomes
        rotation x + offset, every velocity v becomes rotation v; tensions stay, and colliders where they are.

        rotation: shape (components, components), orthogonal to 1e-6; None: none. offset [m]: one number per component.
        """
        self._teleport((strand,), rotation, offset)

    # strand: one of a rope; in a chain that is no rope 0, for all strands, which share such things.

    def attach(self, strand: int, node: int, stiffness: float, damping: float,
               target: Optional[Values] = None) -> None:
        """Ties a node to its target by a spring of `stiffness` [N/m] and `damping` [N s/m], both >= 0: in a rope the
        node of this strand; in a chain that is no rope `strand` must be 0, and the node of every strand is tied.

        target [m]: one number per component, given to every strand that is tied; None: each node's present position.
        Move it afterwards by writing Field.TARGET, which this switches on.
        """
        self._attach((strand, node), stiffness, damping, target)

    def detach(self, strand: int, node: int) -> None:
        """Loosens a node from its target."""
        self._call("detach", strand, node)

    def get_attachment(self, strand: int, node: int) -> Attachment:
        """(stiffness, damping) that tie a node to its target; zeros if none do."""
        return self._attachment((strand, node))

    def cut(self, strand: int, spring: int) -> None:
        """Cuts a spring: stiffness 0. Switches Field.STIFFNESS on. Bend is not cut with it."""
        self._call("cut", strand, spring)

    def weld(self, strand: int, spring: int) -> None:
        """Makes a spring rigid: its two nodes share one velocity from now on, of a rope its length is kept. Switches
        Field.STIFFNESS on."""
        self._call("weld", strand, spring)

    # ---- measuring --------------------------------------------------------------------------------------------------

    def sample(self, strand: int, at: Values, outside: Outside = Outside.REFUSED) -> Array:
        """Positions [m] of one strand at n places along it, linear between nodes; shape (n, components), float64.

        at: n numbers in [0, springs], of a ring to springs + 1. outside: what becomes of others.
        """
        places = row(at)
        positions: Array = _arrays.empty((places.length, self._components), "d")
        numbers = _arrays.target(positions, places.length * self._components)
        self._call("sample", strand, places.address, places.length, outside, numbers.address, numbers.length)
        return positions
