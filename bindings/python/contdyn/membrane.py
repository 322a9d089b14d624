"""A membrane: a sheet of nodes joined by springs in two directions: drum, cloth, flag, thin plate."""
from typing import Any, List, NamedTuple, Optional, Tuple

from . import _arrays
from ._api import Edge, Field, Node, Outside, Precision, Solver
from ._arrays import Array, Values, row
from ._body import Attachment, Body, Convergence, Tolerance
from ._callbacks import Allocator
from ._properties import Reading, Setting, SettingOfSeveral
from ._sheet import Sheet, Vertices


class MembraneShape(NamedTuple):
    """What a membrane was made with."""

    nu: int
    nv: int
    components: int
    precision: Precision

    @property
    def nodes(self) -> Tuple[int, int]:
        """Nodes along v and along u: (nv + 1, nu + 1), as in arrays."""
        return self.nv + 1, self.nu + 1


class Stiffness(NamedTuple):
    """Stretch stiffness along the two directions [N/m]."""

    along_u: float
    along_v: float


class RestLength(NamedTuple):
    """Rest lengths of the sheet along the two directions [m]; zeros: none."""

    along_u: float
    along_v: float


class Effort(NamedTuple):
    """How many iterations a step of cloth may do."""

    #: of Newton's method, 1 to 1000
    newton: int
    #: of conjugate gradients in each of those, 1 to 10000, or 0: as many as bring something
    gradient: int


class Ring(NamedTuple):
    """Which directions are closed to a ring."""

    along_u: bool
    along_v: bool


_OF_SPRINGS_U = (Field.STIFFNESS_U, Field.REST_LENGTH_U, Field.BREAKING_STRAIN_U, Field.TENSION_U, Field.STRAIN_U)
_OF_SPRINGS_V = (Field.STIFFNESS_V, Field.REST_LENGTH_V, Field.BREAKING_STRAIN_V, Field.TENSION_V, Field.STRAIN_V)


class Membrane(Body, Sheet, kind="membrane"):
    """`nu` springs along u, `nv` along v, and (nu + 1) (nv + 1) nodes.

    Arrays have v first: those of positions, velocities, forces and targets the shape (nv + 1, nu + 1, components), of
    masses, pins and masks (nv + 1, nu + 1), of stiffnesses along u (nv + 1, nu), along v (nv, nu + 1), and so of rest
    lengths, breaking strains, tensions and strains; in a ring there are as many springs as nodes.

    Rest length is zero, unless rest_length makes cloth of the membrane: a free sheet draws together, and one stretched
    evenly is held by its edges. A new membrane lies with every node at the origin, at rest and free, mass 1, stiffness
    1 along both directions, without bend, gravity and damping, with Method.IMPLICIT, lambda 1/2 and Solver.AUTO.
    The C header membrane.h tells which solver to take, the energies, equations and limits.
    """

    __slots__ = ()

    def __init__(self, nu: int, nv: int, components: int, precision: Precision = Precision.FLOAT64, *,
                 allocator: Optional[Allocator] = None) -> None:
        """nu, nv >= 0 (0: a single row or column of nodes); components 1 to 4; precision: what it is stored in."""
        self._create(allocator, nu, nv, components, precision)

    shape = Reading(lambda nu, nv, components, precision: MembraneShape(nu, nv, components, Precision(precision)),
                    "(nu, nv, components, precision) and nodes, as it was made.")

    # ---- method -----------------------------------------------------------------------------------------------------

    solver = Setting(Solver, "How implicit steps solve their system, a Solver; default Solver.AUTO.")
    solver_taken = Reading(Solver, "Which of the two the last call of step took; Solver.AUTO: none.")
    tolerance = SettingOfSeveral(Tolerance, "When Solver.COUPLED is content: (tolerance, most_iterations).")
    convergence = Reading(Convergence, "What the last call of step did with Solver.COUPLED, or with cloth: "
                                       "(iterations, residual).")

    # ---- parameters -------------------------------------------------------------------------------------------------

    stiffness = SettingOfSeveral(Stiffness, "Stretch stiffness (along_u, along_v) [N/m], >= 0: a sheet stretched "
                                            "evenly along u by d holds k_u d^2 / 2; default (1, 1).")
    pressure = Setting(float, "Pressure [Pa] on the sheet along its normal x_u x x_v; 3 components only; default 0.")
    ring = SettingOfSeveral(lambda u, v: Ring(bool(u), bool(v)),
                            "Whether the last nodes (along_u, along_v) are joined to the first; needs 3 nodes.")

    def set_edge(self, edge: Edge, kind: Node) -> None:
        """What holds an edge; a corner is pinned if either of its edges is, else driven, else posed if either is.
        Node.POSED switches Field.TARGET on, and each call of step moves the nodes to what is written there."""
        self._call("set_edge", edge, kind)

    def get_edge(self, edge: Edge) -> Node:
        """What was set last for an edge, whatever was written to Field.PIN since."""
        return Node(self._get("get_edge", edge)[0])

    # ---- cloth: springs that have a length --------------------------------------------------------------------------

    rest_length = SettingOfSeveral(
        RestLength, "Rest lengths of the sheet (along_u, along_v) [m], dealt out evenly to its springs; default: they "
                    "have none. A membrane with rest lengths is cloth: its 3 components are directions of space, its "
                    "springs pull along themselves once they are longer than their length, and it steps by "
                    "Method.IMPLICIT with lambda in [1/2, 1], 1 once it is made cloth, without matched edge and "
                    "stiffness damping. It has the fields Field.TENSION_U, TENSION_V, STRAIN_U and STRAIN_V, which "
                    "are read only, and, to be switched on, Field.REST_LENGTH_U, REST_LENGTH_V, BREAKING_STRAIN_U, "
                    "BREAKING_STRAIN_V and WIND; it may have air, wind and colliders, and its springs may tear.")
    shear = Setting(float, "Shear stiffness of cloth [N/m], >= 0, of a spring along each diagonal of every cell; "
                           "default 0.")
    compression = Setting(float, "What keeps cloth from crumpling within its own plane [1/s^2], >= 0: springs that are "
                                 "shorter than their length push a little.")
    breaking_strain = Setting(float, "The strain, length over rest length less 1, at which a spring of cloth tears; "
                                     "default math.inf: none does. A step cuts each row and each column of springs in "
                                     "one place at the most. Field.BREAKING_STRAIN_U and BREAKING_STRAIN_V have one "
                                     "for each spring, of a seam a lower one; writing Field.STIFFNESS_U or STIFFNESS_V "
                                     "mends a spring.")
    broken = Reading(int, "How many springs tore in the last call of step.")
    effort = SettingOfSeveral(Effort, "How many iterations a step of cloth may do: (newton, gradient), by default (3, 0): "
                                      "of conjugate gradients as many as bring something. Where little is gained it "
                                      "takes a few more of the former and fewer of the latter.")

    # ---- fields -----------------------------------------------------------------------------------------------------

    def _places(self, field: Field) -> Tuple[int, int]:
        nu, nv, *_ = self._made_of
        ring = self.ring
        along_u = nu + ring.along_u if field in _OF_SPRINGS_U else nu + 1
        along_v = nv + ring.along_v if field in _OF_SPRINGS_V else nv + 1
        return along_u, along_v

    def _axes(self, strides: List[int]) -> List[int]:
        along_u, along_v, component = strides
        return [along_v, along_u, component]

    def read(self, field: Field, first_u: int = 0, first_v: int = 0, n_u: Optional[int] = None,
             n_v: Optional[int] = None, *, precision: Optional[Precision] = None, out: Any = None) -> Any:
        """A copy of a field, of the nodes (or springs) [first_u, first_u + n_u) x [first_v, first_v + n_v).

        None stands for all the rest. The array has the shape (n_v, n_u, components), of fields without components
        (n_v, n_u), and the object's precision or the one asked for. `out`: a dense array of float32 or float64 to fill,
        which is given back.
        """
        with self._lock:
            place, shape = self._rectangle(field, (first_u, first_v), (n_u, n_v))
            return self._read(field, place, shape, precision, out)

    def write(self, field: Field, values: Values, first_u: int = 0, first_v: int = 0, n_u: Optional[int] = None,
              n_v: Optional[int] = None) -> None:
        """Writes a field, of the nodes (or springs) [first_u, first_u + n_u) x [first_v, first_v + n_v).

        values: an array of the shape that read gives, nested sequences, all numbers in one row, or one for all places.
        """
        with self._lock:
            place, shape = self._rectangle(field, (first_u, first_v), (n_u, n_v))
            self._write(field, place, shape, values)

    # ---- acting on it -----------------------------------------------------------------------------------------------

    def impulse(self, u: float, v: float, radius: float, impulse: Values) -> None:
        """Adds impulse [N s], one number per component, spread over the nodes less than `radius` springs from (u, v).

        u in [0, nu], v in [0, nv], radius >= 0; all on the nearest node if there is none that near.
        """
        numbers = row(impulse)
        self._call("impulse", u, v, radius, numbers.address, numbers.length)

    def teleport(self, rotation: Optional[Values], offset: Values) -> None:
        """Moves the sheet as a whole, as if it had always been there: every position and target x becomes
        rotation x + offset, every velocity v becomes rotation v; colliders stay where they are.

        rotation: shape (components, components), orthogonal to 1e-6; None: none. offset [m]: one number per component.
        """
        self._teleport((), rotation, offset)

    def attach(self, u: int, v: int, stiffness: float, damping: float, target: Optional[Values] = None) -> None:
        """Ties node (u, v) to its target by a spring of `stiffness` [N/m] and `damping` [N s/m], both >= 0.

        target [m]: one number per component; None: its present position. Move it afterwards by writing Field.TARGET,
        which this switches on.
        """
        self._attach((u, v), stiffness, damping, target)

    def detach(self, u: int, v: int) -> None:
        """Loosens node (u, v) from its target."""
        self._call("detach", u, v)

    def get_attachment(self, u: int, v: int) -> Attachment:
        """(stiffness, damping) that tie node (u, v) to its target; zeros if none do."""
        return self._attachment((u, v))

    # ---- measuring --------------------------------------------------------------------------------------------------

    def get_reaction(self, u: int, v: int) -> Tuple[float, ...]:
        """The force [N] with which springs, shear and bend pull at node (u, v) where it is now, one number per
        component: of a held node, what the sheet does to whatever holds it."""
        return self._reaction(u, v)

    volume = Reading(float, "Volume between the sheet and the origin [m^3]; 3 components only.")

    def sample(self, at: Values, outside: Outside = Outside.REFUSED) -> Array:
        """Positions [m] at n places on the sheet, bilinear between nodes; shape (n, components), float64.

        at: shape (n, 2), places (u, v) with u in [0, nu], of a ring to nu + 1, and v likewise. outside: what
        becomes of others.
        """
        places = _arrays.pairs(at)
        n = places.length // 2
        positions: Array = _arrays.empty((n, self._components), "d")
        numbers = _arrays.target(positions, n * self._components)
        self._call("sample", places.address, n, outside, numbers.address, numbers.length)
        return positions

    # ---- drawing ----------------------------------------------------------------------------------------------------

    def vertices(self) -> Vertices:
        """A vertex for every node, number v (nu + 1) + u: positions and smooth unit normals. See write_vertices."""
        nu, nv, *_ = self._made_of
        numbers = self._vertices(0, (nu + 1) * (nv + 1))
        return Vertices(numbers[:, :3], numbers[:, 3:6])

    def write_vertices(self, buffer: Any, stride: int, position_offset: int, normal_offset: Optional[int]) -> None:
        """Writes a vertex for every node into a writable buffer, vertex i at byte i * stride.

        Its position as 3 float32 at position_offset, its unit normal as 3 float32 at normal_offset (None: no normals).
        A membrane of 1 component is drawn as the height z over the unit square. Bytes between are left alone.
        """
        self._write_vertices(buffer, stride, position_offset, normal_offset)

    index_count = Reading(int, "How many indices write_indices writes now: 3 per triangle.")

    def indices(self) -> Array:
        """The triangles as vertex numbers, counter-clockwise seen from where the normal points: shape (n, 3)."""
        nu, nv, *_ = self._made_of
        with self._lock:
            indices: Array = self._indices(self.index_count, (nu + 1) * (nv + 1))
        return indices

    def write_indices(self, buffer: Any, index_size: int) -> None:
        """Writes the triangles into a writable buffer, as unsigned numbers of index_size 2 or 4 bytes."""
        self._write_indices(buffer, index_size)
