// The types of contdyn. Made by generate.py from ../api.json: do not edit.

declare global {
  interface SymbolConstructor {
    readonly dispose: unique symbol; // as TypeScript has it from 5.2 on
  }
}

/** How the library is loaded. */
export interface LoadOptions {
  /** Whether to take the build with vector instructions; default: whether the engine has them. */
  simd?: boolean;
  /** The file itself, or where it is; default: beside this module. */
  source?: string | URL | Response | Promise<Response> | ArrayBuffer | ArrayBufferView | WebAssembly.Module;
}

/** Loads the library; to be awaited before anything else. Awaited again it does nothing more. */
export function load(options?: LoadOptions): Promise<void>;

/** What a call refused: the library's own message, and its status. */
export class ContdynError extends Error {
  readonly status: Status;
}

/** Numbers in one row: a typed array, an array, nested arrays, or what a view shows. */
export type Numbers = TypedArray | readonly NestedNumbers[] | View;
export type TypedArray = Float32Array | Float64Array | Int8Array | Int16Array | Int32Array | Uint8Array | Uint16Array
  | Uint32Array;
export type NestedNumbers = number | readonly NestedNumbers[];

/** An object of the library. `using`, `dispose()`, or in the end the garbage collector releases it. */
export class Handle {
  /** Releases it: every call on it throws from now on. Again does nothing. */
  dispose(): void;
  [Symbol.dispose](): void;
  readonly disposed: boolean;
}

/** A field in the library's own memory, without a copy. */
export interface View {
  /** The field's numbers, to read: place (a, b, c) is at a * strides[0] + b * strides[1] + c * strides[2]. Take it anew
   *  after calls that make objects, switch fields, load or write: memory may have grown, which empties the array taken
   *  before. Throws when the object is disposed of or the field switched off. */
  readonly values: Float32Array | Float64Array;
  /** How many there are in each dimension, as `read` orders them. */
  readonly shape: readonly number[];
  /** How far apart they are in each dimension, counted in numbers. */
  readonly strides: readonly number[];
  /** One number. */
  at(...place: number[]): number;
  /** A copy of all numbers, in the order of `read`. */
  dense(): Float32Array | Float64Array;
}

export const VERSION: string;

/** What a call of the library came to. */
export const Status: {
  readonly ok: 0;
  /** a pointer that may not be null is null */
  readonly errorNull: 1;
  /** the handle is of another kind of object */
  readonly errorHandle: 2;
  /** a number outside its valid range, or NaN or infinity where it has no meaning */
  readonly errorValue: 3;
  /** not one of the enumeration's values */
  readonly errorEnum: 4;
  /** an index, a range or a buffer length that does not fit the object */
  readonly errorRange: 5;
  /** a size that cannot be represented in memory */
  readonly errorSize: 6;
  /** the allocator returned null */
  readonly errorMemory: 7;
  /** the field is not switched on: see enableField */
  readonly errorDisabled: 8;
  /** what this object cannot do, or what was left out of this build: see buildInfo */
  readonly errorUnsupported: 9;
  /** the state left the finite range during a step, or has not come back to it */
  readonly errorDiverged: 10;
  /** the bytes to load are damaged, or of a later version or another kind */
  readonly errorFormat: 11;
  /** the two objects, or the object and the bytes, differ in shape or precision */
  readonly errorMismatch: 12;
  /** steps were made, but an iterative solve ended short of its tolerance */
  readonly errorTolerance: 13;
  /** steps were made, but a callback gave numbers that it may not */
  readonly errorCallback: 14;
};
export type Status = keyof typeof Status;

/**
 * What an object stores its state in; chosen when it is made. Steps compute in double precision whatever it is, but for
 * those that an object's header names.
 */
export const Precision: {
  readonly float32: 0;
  readonly float64: 1;
};
export type Precision = keyof typeof Precision;

/**
 * How a step advances the state by dt. "implicit" is the default, with lambda = 1/2. Bounds hold, and energy is
 * kept, to rounding: in a step a node's position may be wrong by some 1e-15 of the distance that its velocity covers in
 * dt, in a ring or with bend also by 1e-15 of the distance that it would fall in dt, which shows where dt is longer
 * than 1e12 times the time of the fastest swing.
 */
export const Method: {
  /**
   * Kass 1997, eq. 21: lambda = 1/2 keeps energy and is second order, lambda = 1 is backward Euler; for lambda >= 1/2
   * bounded at every dt
   */
  readonly implicit: 0;
  /** Kass 1997, eq. 13; without damping it grows at every dt */
  readonly forwardEuler: 1;
  /** the new velocity moves the position, of water in its symmetric form (velocity Verlet); bounded up to stableDt */
  readonly symplecticEuler: 2;
  /**
   * two implicit stages with gamma = 1 - 1/sqrt(2) (SDIRK2): second order, and L-stable: motion too fast for dt dies
   * out
   */
  readonly stiffSecond: 3;
};
export type Method = keyof typeof Method;

/** How the two-dimensional system of a membrane's implicit step is solved. */
export const Solver: {
  /** rows, then columns: Kass 1997, section 9 */
  readonly alternating: 0;
  /** both at once, to a tolerance */
  readonly coupled: 1;
  /** the first where that is right for the step, else the second */
  readonly auto: 2;
};
export type Solver = keyof typeof Solver;

/** How the total mass is dealt out to the nodes. */
export const MassRule: {
  /** every node the same: the notes' rule, first order in space */
  readonly equal: 0;
  /** nodes on a border half as heavy as those inside: second order in space */
  readonly halfEnds: 1;
};
export type MassRule = keyof typeof MassRule;

/**
 * The instructions that steps are made of. All give the same bits as long as all numbers are finite; how far infinity
 * and NaN spread in steps that end with "errorDiverged" may differ. A new object has the fastest that its processor
 * runs.
 */
export const Kernels: {
  /**
   * what every processor of the target has: SSE2 on x86-64, NEON on AArch64, and on WebAssembly SIMD128 where that was
   * built with -msimd128
   */
  readonly plain: 0;
  readonly avx2: 1;
  /** the parts F and DQ of AVX-512 */
  readonly avx512: 2;
};
export type Kernels = keyof typeof Kernels;

/** What holds a node. The values are also those of the field "pin". */
export const Node: {
  readonly free: 0;
  /** infinite mass, at rest */
  readonly pinned: 1;
  /** infinite mass, moves with the velocity written to it */
  readonly driven: 2;
  /** border nodes only: free, with the impedance sqrt(stiffness mass) that sends no echo back */
  readonly matched: 3;
  /**
   * infinite mass; each call of step moves it to where "target" is, evenly, and there it stays until "target" is
   * written again. Without that field as "driven": it stands still where no velocity has been written
   */
  readonly posed: 4;
};
export type Node = keyof typeof Node;

/** What a collider of ropes and cloth is. */
export const Shape: {
  readonly none: 0;
  readonly plane: 1;
  readonly capsule: 2;
  readonly bed: 3;
  readonly callback: 4;
};
export type Shape = keyof typeof Shape;

/** What becomes of places outside of an object that it is sampled at. */
export const Outside: {
  /** "errorValue", and nothing is told of the other places either */
  readonly refused: 0;
  /** they stand for the nearest place in the object; only NaN is refused */
  readonly nearest: 1;
};
export type Outside = keyof typeof Outside;

/**
 * Per-node and per-spring data; each object's header lists those that it has. They are in one list, since a field that
 * several objects have means the same in each. All hold numbers, pins and masks too, for one read and one write.
 */
export const Field: {
  readonly position: 0;
  readonly velocity: 1;
  readonly force: 2;
  readonly mass: 3;
  readonly stiffness: 4;
  readonly bend: 5;
  readonly pin: 6;
  readonly target: 7;
  readonly stiffnessU: 8;
  readonly stiffnessV: 9;
  readonly mask: 10;
  readonly depth: 11;
  readonly bed: 12;
  readonly surface: 13;
  readonly velocityX: 14;
  readonly velocityY: 15;
  readonly source: 16;
  readonly pressure: 17;
  readonly forceX: 18;
  readonly forceY: 19;
  readonly wallX: 20;
  readonly wallY: 21;
  readonly restLength: 22;
  readonly tension: 23;
  readonly wind: 24;
  readonly strength: 25;
  readonly strain: 26;
  readonly restLengthU: 27;
  readonly restLengthV: 28;
  readonly tensionU: 29;
  readonly tensionV: 30;
  readonly strainU: 31;
  readonly strainV: 32;
  readonly breakingStrainU: 33;
  readonly breakingStrainV: 34;
  readonly restAngle: 35;
};
export type Field = keyof typeof Field;

/** The kinds of objects. */
export const Kind: {
  readonly chain: 1;
  readonly membrane: 2;
  readonly water: 3;
};
export type Kind = keyof typeof Kind;

/** The two ends of a chain. */
export const End: {
  readonly first: 0;
  readonly last: 1;
};
export type End = keyof typeof End;

/** The four edges of a membrane. A corner belongs to two. */
export const Edge: {
  /** the nodes with u = 0 */
  readonly uFirst: 0;
  /** u = nu */
  readonly uLast: 1;
  /** v = 0 */
  readonly vFirst: 2;
  /** v = nv */
  readonly vLast: 3;
};
export type Edge = keyof typeof Edge;

/** The four sides. */
export const Side: {
  /** x = 0 */
  readonly xFirst: 0;
  /** x = nx dx */
  readonly xLast: 1;
  /** y = 0 */
  readonly yFirst: 2;
  /** y = ny dy */
  readonly yLast: 3;
};
export type Side = keyof typeof Side;

/** What is at a side. */
export const Border: {
  readonly wall: 0;
  /** water of a given level outside, into which waves run without an echo */
  readonly open: 1;
  /** a given discharge comes in; if negative, leaves as far as there is water */
  readonly inflow: 2;
  /** goes on at the opposite side */
  readonly periodic: 3;
  /** holds a given level for what flows out slower than its waves: a lake, a weir */
  readonly level: 4;
};
export type Border = keyof typeof Border;

/** Whether water carries its momentum along. */
export const Momentum: {
  readonly linear: 0;
  readonly advected: 1;
};
export type Momentum = keyof typeof Momentum;

/** What a write to "bed" leaves as it is. */
export const BedRule: {
  /** the depth: water rides on the bed, volume is kept */
  readonly liftsWater: 0;
  /** the surface of wet cells: the account tells the volume that a write brings or takes */
  readonly keepsSurface: 1;
};
export type BedRule = keyof typeof BedRule;

/** Name of a status, such as "CD_ERROR_VALUE"; "CD_ERROR_UNKNOWN" for a number that is none. A static string. */
export function statusName(status: Status): string;

/**
 * Why the last failed call on this thread failed: the function, the argument, its value, what would be valid.
 * Empty before the first failure; successful calls leave it as it is. The string belongs to the library and stays
 * valid until the next failure on the same thread. The library tells nothing else, and has no hook for messages.
 */
export function errorMessage(): string;

/**
 * What save made these bytes of: the kind of object, and what its create function has to be given so that it loads
 * them: of a chain strands and springs, of a membrane nu and nv, of water nx and ny; components, of water 1; and the
 * precision. Water's dx and dy, allocators and callbacks may be others., and is left alone on
 * failure. Errors: "errorFormat" for bytes that are damaged, cut short or of a later version.
 */
export function savedShape(bytes: ArrayBuffer | ArrayBufferView): { kind: Kind; first: number; second: number; components: number; precision: Precision };

/**
 * The kernels that this build has and this processor runs: the sum of 1 << k for each of them, k a Kernels. The
 * largest k is the fastest. "plain" is always there.
 */
export function runnableKernels(): number;

/**
 * The instructions' name, such as "AVX-512"; of "plain" those that it was built with: "SSE2", "NEON",
 * "SIMD128", or "plain" for one number at a time. "unknown" for a number that is no Kernels. A static string.
 */
export function kernelsName(kernels: Kernels): string;

/** Version of the library that runs: major * 1000000 + minor * 1000 + patch. The macros tell that of the header. */
export function version(): number;

/** The same as text, "0.2.0". A static string. */
export function versionString(): string;

/**
 * Compiler, target, and which objects, features, precisions and kernels this build has, in one line: options of the
 * build leave parts out, and what asks for one that is not there says "errorUnsupported". A static string.
 */
export function buildInfo(): string;

/**
 * The fields of a Chain.
 *
 *  field         per              unit    values
 *  "position"   strand, node     m       finite
 *  "velocity"   strand, node     m/s     finite; of a pinned node only 0
 *  "force"      strand, node     N       finite; acts until it is overwritten
 *  "target"     strand, node     m       finite; where attach pulls to, and where "posed" goes
 *  "mass"       (strand), node   kg      > 0
 *  "stiffness"  (strand), spring N/m     >= 0; 0: cut; Infinity: welded, see weld; in ropes of fixed length
 *  "bend"       (strand), node   N/m     >= 0; that of the two ends of an open chain is kept and not used
 *  "pin"        (strand), node   -       a Node
 *  "restLength" strand, spring  m       1e-60 to 1e60; of ropes only; below 1e-11 of others steps may end short
 *  "tension"    strand, spring   N       finite double; of ropes only: what the last step found and the next one starts
 *                                         from; how right it is, also after a step that ended short of its
 *                                         tolerance, see getReaction
 *  "wind"       strand, node     m/s     finite; of ropes only
 *  "strength"   strand, spring   N       1e-60 to 1e60, or Infinity; of ropes only: see strength
 *  "restAngle" strand, node     rad     at most 3.141592653589793 in size: pi; of ropes of 2 components only; see bend
 *  "strain"     strand, spring   -       of ropes, to read only: length now over rest length, less 1; -1 and more
 * (strand): per strand in ropes, shared by the strands of other chains.
 * Nodes joined by welded springs make a group, which may hold one held node: more is "errorUnsupported".
 * Position, velocity and pin are always there, tension and strain in ropes. The others cost memory and time only once
 * they are switched on.
 */
export type ChainField = "position" | "velocity" | "force" | "target" | "mass" | "stiffness" | "bend" | "pin" |
  "restLength" | "tension" | "wind" | "strength" | "restAngle" | "strain";

/** Part of a field; what is left out is all the rest. */
export interface ChainRange {
  firstStrand?: number;
  strands?: number;
  first?: number;
  n?: number;
}

/** What it is made with, and then any property that can be set, in this order. */
export interface ChainOptions {
  strands: number;
  springs: number;
  components: number;
  precision?: Precision; // default "float64"
  method?: Method;
  lambda?: number;
  kernels?: Kernels;
  mass?: number;
  massRule?: MassRule;
  stiffness?: number;
  bend?: number;
  drag?: number;
  stiffnessDamping?: number;
  gravity?: Numbers;
  ring?: boolean;
  sleep?: { speed?: number; seconds?: number };
  restLength?: number;
  restAngle?: number;
  push?: boolean;
  strength?: number;
  air?: { along?: number; across?: number };
  wind?: Numbers;
  tolerance?: { tolerance?: number; mostIterations?: number };
  colliders?: number;
  loads?: boolean;
  thickness?: number;
  position?: Numbers | number;
  velocity?: Numbers | number;
  force?: Numbers | number;
  target?: Numbers | number;
}

/**
 * contdyn: a chain of nodes joined by springs: massive spring, rope, hair, spline.
 *
 * A chain has `springs` springs and nodes = springs + 1 nodes; spring i joins node i to node i + 1. A ring has one
 * spring more, number `springs`, from the last node to the first. A node has 1 to 4 components that never mix. One
 * handle holds one or many strands, each with its own positions, velocities, forces and targets. Strands share masses,
 * stiffnesses, pins and attachments, and so one factorization; only ropes' strands have their own of these too.
 *
 * Energy    E = 1/2 sum k_i |x_{i+1} - x_i|^2 + 1/2 sum b_i |x_{i+1} - 2 x_i + x_{i-1}|^2      (Kass 1997, eq. 2 and 5)
 * Motion    M x'' + C x' + K x = M g + f,  K = the Hessian of E,  C = drag M + stiffness_damping K
 *
 * Rest length is zero, unless restLength makes the chain a rope: a free chain draws together, and one
 * stretched evenly is held by its ends. A new chain lies with every node at the origin, at rest, all nodes free, mass
 * 1, stiffness 1, no bend, no gravity, no damping, "implicit" with lambda 1/2.
 *
 * All computing is done in double precision; "float32" is what positions, velocities, forces and targets are stored
 * in. (Steps of symplectic Euler on uniform chains without damping and forces compute in float32 and are as exact.)
 * Numbers smaller than 2^-80 (float32) or 2^-500 (float64), in those steps velocities, are taken for 0 where a step
 * stores them, so that a scene at rest is never slow. Parameters may be as large as 1e60, masses as small as 1e-60.
 *
 * Every function returns "errorNull" for a null pointer and "errorHandle" for a handle of another kind; the
 * comments name the other errors.
 */
export class Chain extends Handle {
  /**
   * Makes a chain. strands >= 1; springs >= 0 (0: a single node); components 1 to 4.
   * Errors: "errorValue", "errorEnum", "errorSize", "errorMemory"; "errorUnsupported" for a precision that
   * this build leaves out.
   */
  constructor(options: ChainOptions);

  // ---- life ---------------------------------------------------------------------------------------------------------

  /** What new Chain was given. */
  get shape(): { strands: number; springs: number; components: number; precision: Precision };

  // ---- method -------------------------------------------------------------------------------------------------------

  /**
   * How steps are made. Methods differ in the memory they need: implicit ones a factorization and a row of scratch,
   * "stiffSecond" a second row. Errors: "errorEnum"; "errorMemory".
   */
  get method(): Method;
  set method(value: Method);

  /** lambda of "implicit", in [0, 1]; default 1/2. Errors: "errorValue". */
  get lambda(): number;
  set lambda(value: number);

  /**
   * The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and a
   * new chain has the fastest that its processor runs. Not part of the saved state.
   * Errors: "errorEnum"; "errorUnsupported" for kernels that are not among runnableKernels.
   */
  get kernels(): Kernels;
  set kernels(value: Kernels);

  // ---- parameters ---------------------------------------------------------------------------------------------------
  // Totals of one strand. A change takes effect at the next step and costs it one refactorization. Where the field of
  // the same name is switched on, setting the total writes the whole field anew. A getter tells the total last set.
  // Errors of all setters: "errorValue" for a number that is NaN, infinite or out of range; "errorEnum".

  /**
   * Mass [kg], > 0. Per node, "equal": mass / nodes; "halfEnds": mass / springs, half of it at the two
   * ends (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.
   */
  get mass(): number;
  set mass(value: number);

  /**
   * Mass [kg], > 0. Per node, "equal": mass / nodes; "halfEnds": mass / springs, half of it at the two
   * ends (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.
   */
  get massRule(): MassRule;
  set massRule(value: MassRule);

  /**
   * Stretch stiffness k [N/m], >= 0, of ropes up to Infinity. Per spring: k times the number of springs. Kass 1997,
   * eq. 7. Waves run along the chain in sqrt(mass / k) seconds.
   */
  get stiffness(): number;
  set stiffness(value: number);

  /**
   * Bend stiffness b [N/m], >= 0. Per node with two neighbours: b times the cube of the number of springs (Kass 1997,
   * eq. 5; eq. 8 prints the square). With b = E I / L^3, L the length of all its springs, held ones too, a rope bends
   * as a beam of the rigidity E I [N m^2]. Errors: "errorMemory" when bend is switched on.
   */
  get bend(): number;
  set bend(value: number);

  /** Drag [1/s], >= 0: every node loses velocity at this rate. */
  get drag(): number;
  set drag(value: number);

  /**
   * Stiffness damping [s], >= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
   * amplitude at the rate (drag + stiffness_damping w^2) / 2. Ropes take none.
   */
  get stiffnessDamping(): number;
  set stiffnessDamping(value: number);

  /**
   * Gravity [m/s^2], one number per component, at most 1e60 in size, in "float32" 1e30.
   * Errors: "errorRange" if count is not the number of components.
   */
  get gravity(): Float64Array;
  set gravity(value: Numbers);

  /**
   * What holds an end: the same as writing the field "pin" at the first or last node of every strand; the getter tells
   * that of the first strand. Pinning stops the node; driving leaves its velocity, which is then written through
   * "velocity"; posing switches "target" on and sets the end's target to where it is: write the next one there.
   * Errors: "errorEnum"; "errorMemory"; "errorUnsupported" for "matched" on a ring; "errorDiverged" for
   * "posed" where the state is not finite.
   */
  setEnd(end: End, kind: Node): void;

  /**
   * What holds an end: the same as writing the field "pin" at the first or last node of every strand; the getter tells
   * that of the first strand. Pinning stops the node; driving leaves its velocity, which is then written through
   * "velocity"; posing switches "target" on and sets the end's target to where it is: write the next one there.
   * Errors: "errorEnum"; "errorMemory"; "errorUnsupported" for "matched" on a ring; "errorDiverged" for
   * "posed" where the state is not finite.
   */
  getEnd(end: End): Node;

  /**
   * Joins the last node to the first (1) or opens the ring (0). A ring has as many springs as nodes, and with bend a
   * bend term at every node; totals are dealt out anew, and a per-spring stiffness field gets the uniform value.
   * Needs 3 nodes. A ring with bend whose springs are cut, or some far softer than others, gains energy by rounding in
   * steps longer than some 1e6 times its fastest swing. Errors: "errorValue" for anything but 0 and 1;
   * "errorUnsupported" with fewer than 3 nodes or a matched end; "errorMemory".
   */
  get ring(): boolean;
  set ring(value: boolean);

  /**
   * Lets what has come to rest sleep: steps leave it as it is, at hardly any cost. Strands of a rope do so one by one,
   * others together. One stops, and sleeps, once for some `seconds` [s], in [1e-30, 1e60], no step left a free node of
   * it
   * faster than `speed` [m/s], in [0, 1e60], nor a held one moving. Energy is lost and none gained.
   * Neglected is a mean acceleration of up to 2 speed / seconds: let that be little beside gravity, or what is thrown
   * may
   * stay in the air. speed 0, the default: nothing sleeps, and seconds means nothing and is 0.
   * A plane or capsule that moves wakes what it could touch in the next step; a bed that moves, or a callback, keeps
   * all
   * awake. What changes a strand wakes it, with whatever numbers: a write, an impulse, a teleport, an attachment, a
   * cut;
   * what is set wakes all, but for the hook, the kernels and the tolerance. Who sleeps is part of the state.
   * Errors: "errorValue"; "errorMemory".
   */
  get sleep(): { speed: number; seconds: number };
  set sleep(value: { speed?: number; seconds?: number });

  /** How many nodes are awake: those that the next step moves. */
  get awake(): number;

  // ---- ropes: springs that have a length ----------------------------------------------------------------------------
  // A rope is a chain with a rest length: the components of a node, 1 to 3, are directions of space, and a spring pulls
  // along itself by k_i (|x_{i+1} - x_i| - length_i) once it is longer than its length; shorter it is slack. k_i may be
  // anything up to Infinity, which keeps its length.
  // Steps: a step solves this nonlinear system, to the tolerance, by Newton's method, as a rule in 1 to 3 iterations,
  // each
  //    in time proportional to the nodes. lambda = 1/2 is second order and keeps the energy of a swing, but for the
  // jerk
  //    when slack ends; lambda = 1 damps most. Stretching of springs of finite stiffness is damped at every lambda,
  // with
  //    1/2 about half as much as with 1. What can't be solved with lambda < 1 is solved with 1. A spring that is longer
  //    than its tension makes it, because positions were written so, comes back within the step at any speed.
  // Momentum: a step that reaches its tolerance keeps it to rounding, at any dt, stiffness and masses.
  // Energy: such a step adds no more than errors of length within the tolerance are worth: for each spring, before the
  //    step and again after it, at most 2 T e + k e^2. e is tolerance * length; T is the spring's tension, or the mean
  //    force on the nodes where that is larger and the interior point was needed; k e^2 is left out where k is
  // infinite.
  //    In "float32" e includes the rounding of positions, 6e-8 of their distance from the origin: a swinging rope gains
  //    up to 2e-4 of its energy at 1e5 times its springs' length from there, a fifth at 1e6 times. Where a rest length
  //    is reduced, tension times what it falls by, with 1/2 along the mean of the spring's directions before and after
  //    the step, is work, and not counted as energy added.
  // Ropes need "implicit", lambda in [1/2, 1], no ring, matched end or stiffness damping, or step says
  // "errorUnsupported".
  //
  // With bend a rope is a rod, or hair, straight at rest or, in a plane, curled: its bend energy at a node is
  // b_i / 2 |d r_i|^2. d r_i is the difference of the two spring vectors at the node, each divided by its rest length
  // and
  // multiplied by the mean of both rest lengths, the first turned by the rest angle. Two pinned nodes at an end clamp
  // it:
  // the inner one, at the clamp, should have twice the bend of the others. A rod whose springs only pull shortens under
  // pressure about as far as the same force across would bend it: hair that is to stand needs push. Any bend
  // is stable; but where pinned nodes hold a rod bent with more than 1e5 times the energy m g L (m: of nodes all as
  // light as
  // its lightest), or where nodes lie a hundred of its lengths apart, rounding may let a step end short of its
  // tolerance.

  /**
   * Rest length of a strand [m], 0 or in [1e-60, 1e60]; default 0: no rope. Per spring: length / springs; nodes stay
   * where they are. A rope has the fields "tension", at first 0, and "strain". Its strands are individuals: each has
   * its own pins, masses, stiffnesses, bends, rest lengths and attachments, at first those that they shared. Length 0
   * switches "tension" off, and "restLength", rest angles, strength, air, wind and colliders too. Reeled in or paid
   * out a little every step, it is a winch. Errors: "errorValue"; "errorMemory"; "errorUnsupported" with 4
   * components or no spring, and for 0 where strands differ in what they would share, or an infinite stiffness would
   * weld
   * all springs or two held nodes.
   */
  get restLength(): number;
  set restLength(value: number);

  /**
   * Rest angle of a strand [rad], by which its last spring is turned from its first at rest, from the first axis to the
   * second; default 0: straight. Per node with two neighbours: angle / (springs - 1), at most pi in size. It is what
   * bend
   * bends about, so it does nothing without bend, and turns with the rope: curls, hooks, tentacles, blades of grass.
   * The
   * field "restAngle" has one for each node. Where springs push, a rod takes its shape by turning, else also by going
   * slack. Errors: "errorValue"; "errorUnsupported" of a chain that is no rope, or, but for 0, without 2 components: in
   * space a curl needs to know how its links are twisted, which nodes do not tell.
   */
  get restAngle(): number;
  set restAngle(value: number);

  /**
   * Whether springs with a length push when shorter (1) or are slack (0, the default). Links that push are solved by
   * Newton's method alone, which may fail from a crumpled start, or where hardly any bend holds them at long steps: of
   * the first 15 steps of 20 or 50 links laid at random one in 700, which moves too little. Errors: "errorValue".
   */
  get push(): boolean;
  set push(value: boolean);

  /**
   * The tension at which a spring breaks [N], 1e-60 to 1e60, or Infinity, the default: springs hold. A rope's step ends
   * by cutting, of each strand, the spring whose tension is most beyond its strength: its stiffness and tension become
   * 0, and the next step shows what the others bear. Where a step ends short of its tolerance and leaves springs of
   * fixed
   * length longer than that allows, as between held nodes that are driven apart, no tension is large enough: then, of
   * the
   * springs between the held nodes on both sides of the longest one, the weakest breaks. Mend a spring by writing
   * "stiffness", which a finite strength switches on and keeps on. The field "strength" has one for each spring.
   * Errors: "errorValue"; "errorMemory"; "errorUnsupported" of a chain that is no rope.
   */
  get strength(): number;
  set strength(value: number);

  /** How many springs broke in the last call of step that made steps: those whose "stiffness" became 0. */
  get broken(): number;

  /**
   * The force [N], one number per component, with which the springs of a rope pull at a node, and its bend: of a held
   * node, what the rope does to whatever holds it. It is the sum of the springs' tensions, along their directions now
   * (0
   * of a spring without length), and of the forces of the bend at the node and at the nodes beside it.
   * After a step that ended short of its tolerance tensions are a guess, 0 or at most the sum of the forces of springs
   * on
   * each node in that step: a rope of fixed length has no tension that holds a driven end which would stretch it. To
   * tie
   * a rope to a body of your own, give the last node its mass, in "mass"; or drive an end of a rope of finite
   * stiffness.
   * Where tensions are read, or a strength is set, take lambda = 1. With 1/2 < lambda < 1 they miss up to a third of
   * the
   * pull of hardly yielding springs where nodes swing; with 1/2 those can be twice the mean just after a jolt. With
   * lambda
   * < 1 a load paid out by springs of infinite stiffness is let fall and caught by turns where dt^2 times gravity is
   * less
   * than 5 tolerance * length: of 10 kg on 4 m of rope at dt = 1/960 s they are 6 N and 190 N; a smaller tolerance
   * helps.
   * Errors: "errorRange"; "errorUnsupported" of a chain that is no rope.
   */
  getReaction(strand: number, node: number): Float64Array;

  /**
   * Resistance of the air, per length of a rope [N s/m^2], in [0, 1e60], default 0: a piece of length s whose velocity
   * through the air is w, w_t along the rope and w_n across it, is pushed by -s (along w_t + across w_n). Implicit, so
   * that it only takes energy, as seen from the air, at any dt; the rope's direction is the one that it would have
   * lambda dt after the step began. A node bears half of its two springs' rest lengths, at most 1e10 m / dt [N s/m]
   * where
   * its mass is m; cut springs feel no air. A round rope of diameter d has some across = 0.6 density d |w_n|, and along
   * a
   * hundredth of that. Errors: "errorValue"; "errorMemory"; "errorUnsupported" of a chain that is no rope.
   */
  get air(): { along: number; across: number };
  set air(value: { along?: number; across?: number });

  /**
   * Velocity of that air [m/s], one number per component, default 0; the field "wind" has one for each node.
   * Errors: "errorValue"; "errorRange" if count is not the number of components; set: "errorUnsupported" of a chain
   * that is no rope.
   */
  get wind(): Float64Array;
  set wind(value: Numbers);

  /**
   * When a step of a rope ends: when every spring is as long as its tension makes it, but for `tolerance` times its
   * rest
   * length, and springs gave no more energy than such errors are worth. A slack spring that is shorter by the fraction
   * s
   * may keep a tension of tolerance / s times the mean force on the nodes, or the mean tension. In [1e-14, 1/2],
   * default
   * 1e-6; above 1e-4 it costs more time, not less, since the next step must correct what one leaves. mostIterations, 1
   * to 10000, default 200, limits the slow and sure method, an interior point, which follows on at most 16 iterations
   * of
   * Newton's; where springs push, it limits Newton's. Errors: "errorValue".
   */
  get tolerance(): { tolerance: number; mostIterations: number };
  set tolerance(value: { tolerance?: number; mostIterations?: number });

  /**
   * What the last call of step did with ropes: the most iterations that a step of a strand took, and the largest
   * error it ended with, as the tolerance counts it, or Infinity. 0 and 0 without ropes.
   */
  get convergence(): { iterations: number; residual: number };

  // ---- what ropes touch ---------------------------------------------------------------------------------------------
  // The nodes of a rope stay outside of colliders, numbered from 0, which all strands meet: half spaces, and capsules,
  // spheres among them, beds of heights, and shapes that a callback tells the distance from, each with a velocity and a
  // friction of its own. Nodes collide; springs between them do not, nor do ropes with each other. A step that reaches
  // its tolerance leaves no free node deeper inside than the tolerance times the springs' length, and colliders at rest
  // give no energy. What falls on one does not bounce; what comes to rest stays. A node that lies inside when a step
  // begins comes out, and throws neither itself nor its strand. No node passes through a capsule that it meets by less
  // than a radius a step; faster ones may: take shorter steps. Where colliders overlap, a node may be caught between
  // them, and where a rope lies across a body, its nodes come out on both sides: "errorTolerance". A strand that
  // touches something makes that step with lambda = 1; sliding at the speed v round a body of the radius R, this brakes
  // it as friction of the coefficient v dt / R would. Friction is Coulomb's: the coefficient times the force that
  // presses
  // a node on, times v / (v + 1e-4 m/s) at the speed v, to 1%; of the force after 50 iterations where a step is hard.
  // So
  // what it holds creeps: under half of what it can hold by 1e-4 m/s. Errors of all that set: "errorUnsupported"
  // without a rest length; "errorRange" for an index that no collider has, or a count that is not the number of
  // components; "errorValue"; "errorMemory" where a bed or a callback becomes something else.

  /**
   * How many colliders there are, 0 to 4096, default 0: new ones are "none", those that stay keep what they are.
   * Rest length 0 takes them away. Errors: "errorMemory".
   */
  get colliders(): number;
  set colliders(value: number);

  /**
   * Makes a collider the half space behind the plane through `point` [m] that `normal`, of any length but 0, points out
   * of; one number per component each, at most 1e60 in size. friction, 0 to 1e60, is Coulomb's coefficient.
   */
  setPlane(index: number, point: Numbers, normal: Numbers, friction?: number): void;

  /**
   * Makes a collider all that is less than `radius` [m], 1e-60 to 1e60, away from the line between two ends: a sphere
   * where they are the same.
   */
  setCapsule(index: number, first: Numbers, last: Numbers, radius: number, friction?: number): void;

  /**
   * Makes a collider all that lies below a bed of heights [m], at most 1e60 in size, which are copied. The last
   * component
   * is up. With 3 components heights[j * columns + i] is at the first two components origin + (i columnSpacing,
   * j rowSpacing), of at least 2 columns and rows; with 2 components a single row is along the first one, and
   * rowSpacing
   * means nothing. Heights count from the origin's own; spacings [m] are 1e-60 to 1e60. Between heights the bed is
   * bilinear, with creases rounded within a quarter of the spacing either side; beyond the border it goes on at the
   * border's height. How far outside a node is, is its height above the bed times the upward part of the bed's normal.
   * A step meets the bed at the plane that touches it there where it finds the node. What the bed rises above that
   * plane
   * on the node's way the node may end inside of, and the next step takes it out; however fast, none falls through.
   * Errors: "errorRange" too, if heightCount is not columns * rows; "errorMemory"; "errorUnsupported" with 1
   * component.
   */
  setBed(index: number, origin: Numbers, columns: number, rows: number, columnSpacing: number, rowSpacing: number,
    heights: Numbers, friction: number): void;

  /**
   * ; 0 columns and rows of what is no bed. Errors: "errorRange" for an index that no collider
   * has, and, with heights, if heightCount is not columns * rows.
   */
  getBed(index: number, heightCount?: number): { columns: number; rows: number; heights: Float64Array };

  /** Makes a collider "none", at rest: nothing touches it. */
  removeCollider(index: number): void;

  /**
   * Velocity of a collider [m/s], default 0, one number per component, at most 1e60 in size: steps move it, and it
   * carries what it touches along. It keeps its velocity when it is made another shape. A capsule that turns: before
   * each
   * step put it where it will be after it, less dt times its middle's velocity, and give it that: cloth on limbs that
   * swing
   * at 3.6 rad/s ends up to 2e-3 m inside in steps of 1/30 s; put where the step begins, 3.5e-2 m.
   */
  setColliderVelocity(index: number, velocity: Numbers): void;

  /**
   * What a collider is, and where now: of a plane its point and its normal, of length 1; of a capsule its two ends; of
   * a
   * bed its origin and its spacings, 0 upward; of a callback its origin; else zeros, but for its velocity. One number
   * per
   * component in each array.
   * Errors: "errorRange" for an index that no collider has, or a count that is not the number of components.
   */
  getCollider(index: number): { shape: Shape; first: Float64Array; second: Float64Array; velocity: Float64Array; radius:
    number; friction: number };

  /** Whether steps note what ropes do to colliders: 1, or 0, the default. Errors: "errorValue"; "errorMemory". */
  get loads(): boolean;
  set loads(value: boolean);

  /**
   * What the nodes of all strands did to a collider, pushes and friction, in the last step, in the mean over its time:
   * 6
   * numbers, the force along x, y and z [N] and its moment about the origin [N m]; about a point p it is less by p x
   * force.
   * Momentum of ropes changes by what all else gives, less this, but 0 is told of a strand whose step ended short of
   * its
   * tolerance. What a node forgets of the speed at which it came out of a collider is not given. A strand that sleeps
   * bears
   * as in its last step. 0 before a step. Part of the state. Errors: "errorRange" for index, or if count is not 6;
   * "errorDisabled" unless loads has asked for it.
   */
  getColliderLoad(index: number): Float64Array;

  /** How thick ropes are, as a radius [m] in [0, 1e60], default 0: nodes stay this far outside of colliders. */
  get thickness(): number;
  set thickness(value: number);

  // ---- fields -------------------------------------------------------------------------------------------------------

  /**
   * Switches a field on, filled with the present uniform values (force 0, target the present position). On already:
   * nothing happens. "strength" switches "stiffness" on too. Errors: "errorEnum", "errorMemory"; "errorDiverged"
   * for "target" where the state is not finite; here and below "errorUnsupported" for the fields of ropes of a chain
   * that is none.
   */
  enableField(field: Field): void;

  /**
   * Switches a field off and releases its memory: uniform values again, no forces, all attachments loosened.
   * Errors: "errorEnum"; "errorUnsupported" for position, velocity, pin, tension and strain, and for stiffness where
   * springs may break.
   */
  disableField(field: Field): void;

  /**
   * Writes or reads values[strand][node][component], dense, of strands [firstStrand, firstStrand + strands) and nodes
   * (or springs) [first, first + n). Fields without components have one value per node; fields that the strands share
   * have the single strand 0. `count` is the number of values in the buffer: strands * n * components. Numbers are
   * rounded once, to the precision of the side that is narrower. Never allocates.
   * Errors: "errorEnum", "errorDisabled", "errorRange"; write: "errorValue", with the first bad index, and
   * "errorUnsupported" for "strain".
   * One number stands for all places.
   */
  write(field: ChainField, values: Numbers | number, range?: ChainRange): void;

  /**
   * Writes or reads values[strand][node][component], dense, of strands [firstStrand, firstStrand + strands) and nodes
   * (or springs) [first, first + n). Fields without components have one value per node; fields that the strands share
   * have the single strand 0. `count` is the number of values in the buffer: strands * n * components. Numbers are
   * rounded once, to the precision of the side that is narrower. Never allocates.
   * Errors: "errorEnum", "errorDisabled", "errorRange"; write: "errorValue", with the first bad index, and
   * "errorUnsupported" for "strain".
   * Without `out` a new array, of the object's precision.
   */
  read(field: ChainField, range?: ChainRange): Float32Array | Float64Array;
  read<A extends Float32Array | Float64Array>(field: ChainField, range: ChainRange | undefined, out: A): A;

  /**
   * Where a field lies in the chain's own memory, in the chain's precision, to read without a copy: the value of
   * (strand, node, component) is at byte *data + strand * strand_stride + node * node_stride + component *
   * component_stride. Position, velocity, force and target only. The pointer is good until the field is switched off or
   * the chain released; the numbers change with every write and step. Do not write through it.
   * Errors: "errorEnum", "errorDisabled", "errorUnsupported".
   * Here as a `View`, which follows the field.
   */
  view(field: ChainField): View;

  /** `view("position")`; assigned, the field is written. */
  get position(): View;
  set position(values: Numbers | number);

  /** `view("velocity")`; assigned, the field is written. */
  get velocity(): View;
  set velocity(values: Numbers | number);

  /** `view("force")`; assigned, the field is written. */
  get force(): View;
  set force(values: Numbers | number);

  /** `view("target")`; assigned, the field is written. */
  get target(): View;
  set target(values: Numbers | number);

  // ---- acting on it -------------------------------------------------------------------------------------------------

  /**
   * Adds impulse [N s], one number per component, to a node: its velocity changes by impulse / mass, in a welded group
   * by impulse / the group's mass; a held node takes none. Errors: "errorRange", "errorValue", "errorDiverged".
   */
  impulse(strand: number, node: number, impulse: Numbers): void;

  /**
   * Moves a strand as a whole, as if it had always been there: every position and target becomes rotation * x + offset,
   * every velocity rotation * v; tensions stay, and colliders stay where they are. rotation: components rows of as many
   * numbers, orthogonal to 1e-6, with rest angles no mirror image; null: none. offset [m]: one number per component,
   * which count counts. Errors: "errorRange", "errorValue"; "errorDiverged" for a state that is not finite.
   */
  teleport(strand: number, rotation: Numbers | null, offset: Numbers): void;

  /**
   * Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does.
   * In
   * a rope it is the node of this strand; in a chain that is no rope `strand` must be 0, and the node of every strand
   * is
   * tied. target, one number per component, is given to every strand that is tied; null: the present position, and
   * count
   * means nothing. Move it afterwards by writing "target". Attaching again changes the numbers. Switches "target" on.
   * Errors: "errorRange"; attach: "errorValue", "errorMemory", and "errorDiverged" for a state that is not
   * finite.
   */
  attach(strand: number, node: number, stiffness: number, damping: number, target?: Numbers | null): void;

  /**
   * Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does.
   * In
   * a rope it is the node of this strand; in a chain that is no rope `strand` must be 0, and the node of every strand
   * is
   * tied. target, one number per component, is given to every strand that is tied; null: the present position, and
   * count
   * means nothing. Move it afterwards by writing "target". Attaching again changes the numbers. Switches "target" on.
   * Errors: "errorRange"; attach: "errorValue", "errorMemory", and "errorDiverged" for a state that is not
   * finite.
   */
  detach(strand: number, node: number): void;

  /**
   * Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does.
   * In
   * a rope it is the node of this strand; in a chain that is no rope `strand` must be 0, and the node of every strand
   * is
   * tied. target, one number per component, is given to every strand that is tied; null: the present position, and
   * count
   * means nothing. Move it afterwards by writing "target". Attaching again changes the numbers. Switches "target" on.
   * Errors: "errorRange"; attach: "errorValue", "errorMemory", and "errorDiverged" for a state that is not
   * finite.
   */
  getAttachment(strand: number, node: number): { stiffness: number; damping: number };

  /**
   * Cuts a spring (stiffness 0) or welds it (infinite stiffness), in a rope of this strand; in a chain that is no rope
   * `strand` must be 0, and it is done in every strand. From a weld on the two nodes share one velocity, the mean of
   * theirs by mass, so that momentum is kept, and their offset stays as it is. Welding to a held node gives that node's
   * velocity. A cut or welded spring gets a stiffness again by writing "stiffness". Both switch "stiffness" on. Bend is
   * not cut with the spring: write "bend". In a rope it is, as long as the stiffness is 0, and welding fixes the
   * spring's length only.
   * Errors: "errorRange", "errorMemory"; weld: "errorUnsupported" if it would join two held nodes.
   */
  cut(strand: number, spring: number): void;

  /**
   * Cuts a spring (stiffness 0) or welds it (infinite stiffness), in a rope of this strand; in a chain that is no rope
   * `strand` must be 0, and it is done in every strand. From a weld on the two nodes share one velocity, the mean of
   * theirs by mass, so that momentum is kept, and their offset stays as it is. Welding to a held node gives that node's
   * velocity. A cut or welded spring gets a stiffness again by writing "stiffness". Both switch "stiffness" on. Bend is
   * not cut with the spring: write "bend". In a rope it is, as long as the stiffness is 0, and welding fixes the
   * spring's length only.
   * Errors: "errorRange", "errorMemory"; weld: "errorUnsupported" if it would join two held nodes.
   */
  weld(strand: number, spring: number): void;

  // ---- time ---------------------------------------------------------------------------------------------------------

  /**
   * Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps.
   * Never allocates. Time is proportional to count * strands * nodes * components.
   * Errors: "errorValue"; "errorDiverged" if a number leaves the finite range: all steps are made, the message gives
   * the first bad one, the chain can be read, and steps again after reset, a load, or once finite positions and
   * velocities have been written; of ropes "errorUnsupported" for what they can't have, "errorCallback" as
   * setCallback says, and "errorTolerance" if a step ended short of its tolerance: all steps are made, and
   * good to the error that convergence tells, but for tensions: see getReaction.
   */
  step(dt: number, count?: number): void;

  /**
   * The longest dt at which "symplecticEuler" stays bounded, whatever method is set: the largest dt with
   * 4 M - 2 dt C - dt^2 K positive definite. Exact for stretch with drag and stiffness damping; with bend a lower
   * bound,
   * exact in the limit of many nodes; with matched ends and attachment damping a lower bound, and close. Infinity if
   * nothing can swing. Errors: "errorUnsupported" of ropes.
   */
  stableDt(): number;

  /** Simulated time [s] and steps made since create or reset, those before a load or a copied state included. */
  get time(): number;

  /** Simulated time [s] and steps made since create or reset, those before a load or a copied state included. */
  get steps(): number;

  /**
   * How many factorizations the chain has made: one at the first implicit step and one at the first after each change
   * of
   * dt, lambda, method or a parameter. Ropes make none. Not part of the saved state.
   */
  get factorizations(): number;

  // ---- measuring ----------------------------------------------------------------------------------------------------

  /**
   * Energies of all strands together [J]; Kinetic: of the free nodes. Elastic: stretch, bend
   * and attachments; a welded spring holds none. Gravity: -sum m g x of the free nodes. Undamped, lambda = 1/2
   * keeps their sum, of ropes but for what is told of them.
   */
  get energy(): { kinetic: number; elastic: number; gravity: number };

  /**
   * Momentum of the free nodes of all strands together [kg m/s], one number per component.
   * Errors: "errorRange" if count is not the number of components.
   */
  get momentum(): Float64Array;

  /**
   * Positions of one strand at places along it, linear between nodes: at[j] in [0, springs] (ring: to springs + 1),
   * positions[j][component], count = n * components. Errors: "errorRange" if there is no such strand or
   * count is another number; "errorEnum"; "errorValue" for a place beyond the strand.
   */
  sample(strand: number, at: Numbers, outside?: Outside): Float64Array;

  /** Bytes the chain holds from its allocator. */
  get memory(): number;

  /** A 64-bit hash of everything save would write. Equal on every machine, compiler and vector width. */
  hash(): bigint;

  // ---- keeping ------------------------------------------------------------------------------------------------------

  /**
   * The whole state as bytes: shape, parameters, fields, time: all the future depends on but the callbacks. Little-
   * endian
   * on every machine, versioned, with a checksum. save needs size >= saveSize and tells what it wrote.
   * load needs a chain of the same shape and precision; it switches fields on and off as they were. Bytes that are
   * damaged, cut short, of a later version or another kind are refused and change nothing.
   * Errors: save: "errorRange". load: "errorFormat", "errorMismatch", "errorMemory".
   */
  saveSize(): number;

  /**
   * The whole state as bytes: shape, parameters, fields, time: all the future depends on but the callbacks. Little-
   * endian
   * on every machine, versioned, with a checksum. save needs size >= saveSize and tells what it wrote.
   * load needs a chain of the same shape and precision; it switches fields on and off as they were. Bytes that are
   * damaged, cut short, of a later version or another kind are refused and change nothing.
   * Errors: save: "errorRange". load: "errorFormat", "errorMismatch", "errorMemory".
   */
  save(): Uint8Array;

  /**
   * The whole state as bytes: shape, parameters, fields, time: all the future depends on but the callbacks. Little-
   * endian
   * on every machine, versioned, with a checksum. save needs size >= saveSize and tells what it wrote.
   * load needs a chain of the same shape and precision; it switches fields on and off as they were. Bytes that are
   * damaged, cut short, of a later version or another kind are refused and change nothing.
   * Errors: save: "errorRange". load: "errorFormat", "errorMismatch", "errorMemory".
   */
  load(bytes: ArrayBuffer | ArrayBufferView): void;

  /**
   * Makes `chain` what `source` is, as save and load would, without the bytes: the two must agree in shape and
   * precision.
   * Allocates only if they differ in the fields switched on. Errors: "errorMismatch", "errorMemory".
   */
  copyState(source: Chain): void;

  /** Positions, velocities, tensions, time and steps back to 0. Parameters, fields and pins stay; targets too. */
  reset(): void;
}

/**
 * The fields of a Membrane.
 *
 *  field                per       unit    values
 *  "position"          node      m       finite
 *  "velocity"          node      m/s     finite; of a pinned or absent node only 0
 *  "force"             node      N       finite; acts until it is overwritten
 *  "target"            node      m       finite; where attach pulls to, and where "posed" goes
 *  "mass"              node      kg      > 0
 *  "stiffnessU"       spring    N/m     >= 0; 0: cut. Spring (u, v) joins node (u, v) to (u + 1, v)
 *  "stiffnessV"       spring    N/m     >= 0; 0: cut. Spring (u, v) joins node (u, v) to (u, v + 1)
 *  "pin"               node      -       any Node but "matched"; whole edges need it not, see
 *                                         setEdge
 *  "mask"              node      -       1: there; 0: absent, with all that touches it: it stands still where it is
 *                                         and counts for nothing
 *  "restLengthU"     spring    m       1e-60 to 1e60; of cloth only, as are all that follow
 *  "restLengthV"     spring    m       likewise
 *  "breakingStrainU" spring    -       1e-60 to 1e60, or Infinity
 *  "breakingStrainV" spring    -       likewise
 *  "wind"              node      m/s     finite
 *  "tensionU", _V     spring    N       to read only: what the spring pulls by now, less than 0 where it pushes
 *  "strainU", _V      spring    -       to read only: length now over rest length, less 1; -1 and more
 * Position and velocity are always there, tension and strain in cloth. The others cost memory and time only once they
 * are switched on; "mass", the stiffnesses, "target", "pin" and "mask" make a sheet that is no cloth one whose
 * lines differ, with factors for each of them.
 */
export type MembraneField = "position" | "velocity" | "force" | "target" | "mass" | "stiffnessU" | "stiffnessV" | "pin"
  | "mask" | "restLengthU" | "restLengthV" | "breakingStrainU" | "breakingStrainV" | "wind" | "tensionU" | "tensionV" |
  "strainU" | "strainV";

/** Part of a field; what is left out is all the rest. */
export interface MembraneRange {
  firstU?: number;
  firstV?: number;
  nU?: number;
  nV?: number;
}

/** What it is made with, and then any property that can be set, in this order. */
export interface MembraneOptions {
  nu: number;
  nv: number;
  components: number;
  precision?: Precision; // default "float64"
  method?: Method;
  lambda?: number;
  solver?: Solver;
  tolerance?: { tolerance?: number; mostIterations?: number };
  kernels?: Kernels;
  mass?: number;
  massRule?: MassRule;
  stiffness?: { alongU?: number; alongV?: number };
  bend?: number;
  drag?: number;
  stiffnessDamping?: number;
  gravity?: Numbers;
  pressure?: number;
  ring?: { alongU?: boolean; alongV?: boolean };
  sleep?: { speed?: number; seconds?: number };
  restLength?: { alongU?: number; alongV?: number };
  shear?: number;
  compression?: number;
  breakingStrain?: number;
  effort?: { newton?: number; gradient?: number };
  air?: { along?: number; across?: number };
  wind?: Numbers;
  colliders?: number;
  loads?: boolean;
  thickness?: number;
  position?: Numbers | number;
  velocity?: Numbers | number;
  force?: Numbers | number;
  target?: Numbers | number;
}

/**
 * contdyn: a membrane: nodes joined by springs in two directions: drum, balloon, plate, and with rest lengths cloth.
 *
 * A membrane has `nu` springs along u and `nv` along v, and (nu + 1) (nv + 1) nodes; node (u, v) has the number
 * v (nu + 1) + u wherever nodes are listed. A node has 1 to 4 components that never mix. A direction can be closed to a
 * ring: its last nodes are then joined to the first by one spring more.
 *
 * Energy    E = 1/2 sum k_u |x_{u+1,v} - x_{u,v}|^2 + 1/2 sum k_v |x_{u,v+1} - x_{u,v}|^2
 *             + 1/2 sum b (|x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2)           (Kass 1997, section 8; the thin plate's energy)
 * Motion    M x'' + C x' + K x = M g + f + pressure along the normal,  K = the Hessian of E,
 *           C = drag M + stiffness_damping K
 *
 * Rest length is zero, unless restLength makes the membrane cloth: a free sheet draws together, and
 * one stretched evenly is held by its edges. A new membrane lies at the origin, at rest, all nodes free, mass 1,
 * stiffness 1 both ways, no bend, gravity and damping, "implicit" with lambda 1/2, "auto".
 *
 * Which solver? An implicit step of a sheet without rest lengths has a two-dimensional system to solve, here with h =
 * lambda dt. Leave that to "auto", or take "alternating" for a fixed cost and less memory. A sheet is
 * uniform here if its masses and stiffnesses are the totals dealt out and no node is absent; if nothing holds it but
 * whole rows and columns and at most 16 single nodes, held or attached, these while h (h + damping) (2 k + 16 b) is at
 * most 1e4 times a node's mass; and if with bend each direction is held at both edges or a ring, not both a ring.
 *   "alternating"  rows, then columns (Kass 1997, section 9). Uniform sheets are stable at any stiffness and
 *      any dt that stays the same. A motion of the angular frequencies w_u and w_v along the two directions is slowed
 *      down as if it were 1 + (w_u h)^2 (w_v h)^2 times as heavy; where the sheet comes to rest does not depend on dt.
 *      Other sheets, a plate that is a ring both ways among them, would blow up: their step, not quite linear and at
 *      six times the cost, is the best, in energy, of sums of the lines' answers, the velocity and common motion. It
 *      leaves slow motions anywhere where fast ones have energy: a plate with a hole was off by all that it swung.
 *   "coupled"      the system itself, to a tolerance, by conjugate gradients: nothing is slowed down. Uniform
 *      sheets without bend and rings take one or two iterations of some ten alternating solves each, others multigrid,
 *      4 to 100 times the cost. It comes to rest where alternating does. Take it where stiff sheets must move in time,
 *      or stiff parts against each other: alternating finds only their common motion. It needs many iterations where
 *      springs or masses vary at random by decades, plates with free edges hardly stretch or many nodes are tied.
 *   "auto"         of uniform sheets, for each dt, alternating where the slowest motion (half a wave along each
 *      direction, round a ring a whole one, with the kinks at held or attached nodes) is made at most 5% heavier. Else
 *      coupled; and so, until reset, uniform sheets that have been coupled once, whose steps have differed
 *      in dt, method, lambda, damping or solver, or of which moving nodes were pinned. At that bound a kick of one of
 *      33 x 33 nodes goes 31 times as far as it should, of a radius of an eighth of the sheet 3.5, of a quarter 1.4. It
 *      holds some 300 bytes a node; alternating takes 36 where edges hold it. Builds without coupled solver alternate.
 * Steps are of second order in time, those of alternating plates with stiffness damping of first. Without rest lengths:
 *   Energy: lambda = 1/2 keeps it, and lambda > 1/2 never adds any, whatever the tolerance of coupled solves.
 *   Momentum: of a free sheet, and of each part of a torn one, it is kept however stiff they are; alternating, up to a
 *      stiffness of 1e19 mass / h^2 of uniform sheets, and a bend of 1e13 mass / h^2 of plates with one ring.
 *   Unlike steps: alternating, the energy that a uniform sheet keeps counts the extra mass, which depends on dt, lambda
 *      and damping. If these keep changing it grows without bound: with lambda = 1/2 or "stiffSecond" by up to
 *      an eighth a step where 16 and 17 ms take turns, with lambda = 1 by a quarter where some steps are twice as long.
 *   "float32": alternating, the rounding of a velocity is a kick whose energy is so many times larger as the motion is
 *      heavier: where (w_u h) (w_v h) is beyond 1e4, take "float64" or the coupled solver.
 *   "stiffSecond": adds no energy where coupled solves meet the default tolerance; a step that ended short of
 *      its own has added a third, one that alternates on a sheet that is not uniform a twentieth.
 * What chain.h says of precision and of numbers that are too small holds for sheets too. Parameters may be as large as
 * 1e60, masses as small as 1e-60. Every function returns "errorNull" for a null pointer and "errorHandle" for a
 * handle of another kind; the comments name the other errors. Functions that the chain has too mean the same here.
 */
export class Membrane extends Handle {
  /**
   * Makes a membrane. nu, nv >= 0 (0: a single row or column of nodes); components 1 to 4. Errors: "errorValue",
   * "errorEnum", "errorSize", "errorMemory"; "errorUnsupported" for a precision
   * that this build leaves out.
   */
  constructor(options: MembraneOptions);

  // ---- life ---------------------------------------------------------------------------------------------------------

  /** What new Membrane was given. */
  get shape(): { nu: number; nv: number; components: number; precision: Precision };

  // ---- method -------------------------------------------------------------------------------------------------------

  /** How steps are made. Methods and solvers differ in the memory they need. Errors: "errorEnum"; "errorMemory". */
  get method(): Method;
  set method(value: Method);

  /** lambda of "implicit", in [0, 1]; default 1/2. Errors: "errorValue". */
  get lambda(): number;
  set lambda(value: number);

  /** How implicit steps solve their system; see above. Errors: "errorEnum"; "errorMemory". */
  get solver(): Solver;
  set solver(value: Solver);

  /** Which of the two the last step took that found it awake; "auto": neither. Not part of the saved state. */
  get solverTaken(): Solver;

  /**
   * When "coupled" is content: a residual of `tolerance` times the one it starts from, in [1e-14, 1/2], default
   * 1e-6. Each component's is the Euclidean norm of its nodes', each over its diagonal entry of the system. It may take
   * mostIterations, >= 1, default 100, and ends when 500 have not halved the residual, which rounding may keep from
   * falling. step says "errorTolerance" where it ends short of the tolerance. Errors: "errorValue".
   */
  get tolerance(): { tolerance: number; mostIterations: number };
  set tolerance(value: { tolerance?: number; mostIterations?: number });

  /**
   * What the last call of step did when it took "coupled": the most iterations that a solve needed,
   * and the largest residual it ended with, as a fraction of the one it started from: Infinity where its square is. 0
   * and
   * 0 if there was no such solve. Soft motions beside stiff ones may be off by more.
   */
  get convergence(): { iterations: number; residual: number };

  /**
   * The instructions that steps are made of, as kernels says. Not part of the saved state.
   * Errors: "errorEnum"; "errorUnsupported" for kernels that are not among runnableKernels.
   */
  get kernels(): Kernels;
  set kernels(value: Kernels);

  // ---- parameters ---------------------------------------------------------------------------------------------------
  // Totals of the sheet. A change takes effect at the next step and costs it one refactorization. Where the field of
  // the same name is switched on, setting the total writes the whole field anew. A getter tells the total last set.
  // Errors of all setters: "errorValue" for a number that is NaN, infinite or out of range; "errorEnum".

  /**
   * Mass [kg], > 0. "equal": mass / ((nu + 1) (nv + 1)) per node. "halfEnds": an edge line counts half, in
   * its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an edge, a quarter
   * at
   * a corner. In a direction that is a ring or has no spring the rules agree, and in what follows its nu + 1 and nu (or
   * nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness anew.
   */
  get mass(): number;
  set mass(value: number);

  /**
   * Mass [kg], > 0. "equal": mass / ((nu + 1) (nv + 1)) per node. "halfEnds": an edge line counts half, in
   * its masses and in the springs and bends along it: mass / (nu nv) per node inside, half of it on an edge, a quarter
   * at
   * a corner. In a direction that is a ring or has no spring the rules agree, and in what follows its nu + 1 and nu (or
   * nv + 1 and nv) are both the number of its nodes. The rule deals out mass and stiffness anew.
   */
  get massRule(): MassRule;
  set massRule(value: MassRule);

  /**
   * Stretch stiffness along u and along v [N/m], >= 0: a sheet stretched evenly along u by the length d holds the
   * energy
   * k_u d^2 / 2. Per spring along u: nu k_u / (nv + 1), half edges: nu k_u / nv and half of it along the edges; along v
   * likewise. Waves run across the sheet along u in sqrt(mass / k_u) seconds. A sheet of 1 component has no size of its
   * own: with the sides L_u and L_v under the tension S [N/m] k_u = S L_v / L_u and k_v = S L_u / L_v, a square one S.
   */
  get stiffness(): { alongU: number; alongV: number };
  set stiffness(value: { alongU?: number; alongV?: number });

  /**
   * Bend stiffness b [N/m], >= 0, of E = b/2 times the integral of |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2 over the unit
   * square
   * of u and v. Per node with two neighbours along u: b nu^3 / (nv + 1), half edges: b nu^3 / nv and half of it along
   * the
   * edges; along v likewise; per cell, on the squared twist: twice their geometric mean. A square plate of side L with
   * b
   * = D / L^2 has the flexural rigidity D [N m]; one of L_u by L_v has b L_u^3 / L_v along u, b L_v^3 / L_u along v and
   * b
   * L_u L_v in twist. Cut springs do not cut it, but "mask". Errors: "errorMemory" when bend is switched on.
   */
  get bend(): number;
  set bend(value: number);

  /** Drag [1/s], >= 0: every node loses velocity at this rate. */
  get drag(): number;
  set drag(value: number);

  /**
   * Stiffness damping [s], >= 0: stretch and bend damp at this time constant; a mode of angular frequency w loses
   * amplitude at the rate (drag + stiffness_damping w^2) / 2. Cloth takes none.
   */
  get stiffnessDamping(): number;
  set stiffnessDamping(value: number);

  /**
   * Gravity [m/s^2], one number per component, at most 1e60 in size, in "float32" 1e30.
   * Errors: "errorRange" if count is not the number of components.
   */
  get gravity(): Float64Array;
  set gravity(value: Numbers);

  /**
   * Pressure [Pa] on the sheet along its normal x_u x x_v, of either sign, at most 1e60 in size: the force on a node is
   * pressure times the gradient of the volume under the sheet, at an edge its part of the cells' areas, at the
   * positions
   * a step starts from. It grows with the sheet, beyond some half of stiffness / side without end. 3 components only;
   * costs memory while not 0. Errors: "errorUnsupported" for other components unless 0; "errorMemory".
   */
  get pressure(): number;
  set pressure(value: number);

  /**
   * What holds an edge; a corner is pinned if either of its edges is, else driven, else posed if either is. Pinning
   * stops the nodes; driving leaves their velocity, which is then written through "velocity"; posing switches "target"
   * on and sets the edge's targets to where it is: write the next ones there. "matched" leaves the edge free, with
   * the impedance that sends no echo back to a wave that runs straight at it. Where "pin" is switched on, all but
   * matched are written to it along the edge. The getter tells what was set last, whatever was written to "pin" since.
   * Errors: "errorEnum"; "errorUnsupported" for "matched" in the direction of a ring; "errorMemory";
   * "errorDiverged" for "posed" where the state is not finite.
   */
  setEdge(edge: Edge, kind: Node): void;

  /**
   * What holds an edge; a corner is pinned if either of its edges is, else driven, else posed if either is. Pinning
   * stops the nodes; driving leaves their velocity, which is then written through "velocity"; posing switches "target"
   * on and sets the edge's targets to where it is: write the next ones there. "matched" leaves the edge free, with
   * the impedance that sends no echo back to a wave that runs straight at it. Where "pin" is switched on, all but
   * matched are written to it along the edge. The getter tells what was set last, whatever was written to "pin" since.
   * Errors: "errorEnum"; "errorUnsupported" for "matched" in the direction of a ring; "errorMemory";
   * "errorDiverged" for "posed" where the state is not finite.
   */
  getEdge(edge: Edge): Node;

  /**
   * Joins the last nodes along u (along v) to the first (1), or opens them (0). Totals are dealt out anew, and fields
   * of
   * masses and stiffnesses get the uniform values. A ring needs 3 nodes. Errors: "errorValue" for anything but 0 and
   * 1; "errorUnsupported" with fewer than 3 nodes or a matched edge; "errorMemory".
   */
  get ring(): { alongU: boolean; alongV: boolean };
  set ring(value: { alongU?: boolean; alongV?: boolean });

  /**
   * Lets a sheet sleep, as a whole, once it has been slower than `speed` [m/s], in [0, 1e60], for some `seconds` [s],
   * in
   * [1e-30, 1e60]: as sleep says; the effort wakes nothing. Errors: "errorValue"; "errorMemory".
   */
  get sleep(): { speed: number; seconds: number };
  set sleep(value: { speed?: number; seconds?: number });

  /**
   * Lets a sheet sleep, as a whole, once it has been slower than `speed` [m/s], in [0, 1e60], for some `seconds` [s],
   * in
   * [1e-30, 1e60]: as sleep says; the effort wakes nothing. Errors: "errorValue"; "errorMemory".
   */
  get awake(): number;

  // ---- cloth: springs that have a length ----------------------------------------------------------------------------
  // Cloth is a membrane with rest lengths. The 3 components of a node are directions of space, and a spring of
  // stiffness
  // k and rest length L that is l long pulls by
  //     0 up to l = L,   k (l - L)^2 / 0.012 L up to l = 1.006 L,   k (l - 1.003 L) beyond,
  // so that cloth is slack where it is shorter and stretches by 0.3% before it has all of its stiffness; it does not
  // shrink. Springs that are shorter resist crumpling by compression. A cell with its four springs has
  // shear and twist, a node between two springs of a line has bend; where one of those springs is cut they are cut too.
  //
  // Steps: a step minimizes a convex function of the velocities, by Newton's method with few iterations of conjugate
  //    gradients (effort), and then scales the velocities. They are of first order in time. lambda = 1
  //    damps motion that a step does not resolve; lambda nearer 1/2 damps it less, and needs more effort.
  // Energy: at any dt, stiffness, masses and effort, what energy tells rises only by the work of driven
  //    nodes, forces, pressure, wind and moving colliders. Free sheets, and free parts of torn ones, keep their
  // momentum.
  // Stiff sheets, default effort: at 10 mass / dt^2 [N/m] they fall 2% too slowly, and stretch by 2% where two corners
  //    hold them; at 100 2%, at 1000 5%, at 1e4 20%; beyond, only along with what holds or pushes them: shorten steps.
  // Cloth needs "implicit", lambda in [1/2, 1], no matched edge, no stiffness damping, or step says
  // "errorUnsupported"; solver and _set_tolerance do not matter to it.

  /**
   * Rest lengths of the sheet along u and along v [m], 0 or in [1e-60, 1e60]; default 0: no cloth. Both are 0 or
   * neither
   * is. Per spring: length / springs, in a ring as well; nodes stay where they are. Making cloth of a membrane sets
   * lambda to 1. Length 0 switches the fields of cloth off, and breaking strain, air, wind and colliders too. Errors:
   * "errorValue"; "errorMemory"; "errorUnsupported" without 3 components and springs along both directions.
   */
  get restLength(): { alongU: number; alongV: number };
  set restLength(value: { alongU?: number; alongV?: number });

  /**
   * Shear stiffness [N/m], >= 0, default 0, of a spring along each diagonal of every cell, with the law and the mean
   * rest lengths of the cell's springs. Of square cells the shear modulus is half of it [N/m].
   * Errors here and below: "errorValue"; "errorUnsupported" of a membrane that is no cloth.
   */
  get shear(): number;
  set shear(value: number);

  /**
   * What keeps cloth from crumpling: springs along u and v that are shorter than their length push by c (L - l), longer
   * ones pull by as much, c dealt out as a stiffness of mass * rate. rate [1/s^2] >= 0, default 80: flags of a metre
   * wave
   * in winds up to 12 m/s with 0.4% folded sharply at most; smaller ones want more. It damps folds from node to node.
   */
  get compression(): number;
  set compression(value: number);

  /**
   * The strain, length over rest length less 1, at which a spring tears, whatever its stiffness: 1e-60 to 1e60, or
   * Infinity, the default: springs hold. The fields "breakingStrainU" and _V have one for each spring: a seam is a
   * line of springs that tear at less. A step ends by cutting springs beyond their breaking strains, in each row and
   * each
   * column of springs at most one. First goes the spring whose strain is the largest multiple of its breaking strain;
   * then its neighbour in the next row, and so on from row to row, while that is beyond its breaking strain too; then
   * the
   * same in the rows that are left. So tears go on from their ends, and jerked cloth parts without falling to pieces. A
   * cut spring's stiffness becomes 0, and adds no energy. Mend it by writing "stiffnessU" or _V, which finite breaking
   * strains switch on and keep on. A cell of cloth that lacks two or more springs is open: it is not drawn, it has no
   * volume, and air and pressure go through it. Errors: "errorMemory" too.
   */
  get breakingStrain(): number;
  set breakingStrain(value: number);

  /**
   * How many springs tore in the last call of step that made steps: those whose stiffness became 0. Where
   * there are any, writeIndices may write other triangles than before.
   */
  get broken(): number;

  /**
   * How much a step may do: iterations of Newton's method, `newton`, 1 to 1000, default 3, and in each those of
   * conjugate
   * gradients, `gradient`, 1 to 10000, or 0, the default: until four bring less than 3% of the energy that all brought.
   * Up to 4 more of Newton's are made where it gains little, with gradient 0 also where it still gains much. After a
   * step
   * get_convergence tells the most of conjugate gradients that a step took, and what gradient was left over the first.
   */
  get effort(): { newton: number; gradient: number };
  set effort(value: { newton?: number; gradient?: number });

  /**
   * Resistance of the air, per area of cloth [N s/m^3], in [0, 1e60], default 0: a piece of area a whose velocity
   * through the air is w, w_t along the cloth and w_n across it, is pushed by -a (along w_t + across w_n). Implicit, so
   * that it only takes energy, as seen from the air, at any dt; areas and directions are those that the step starts
   * from. Air of density 1.2 kg/m^3 that passes at the speed s has about across = 1.2 s and along = 0.02 s. A node
   * on an edge bears half the air: with "equal", where it has the whole mass, a flat sheet folds as it falls;
   * with "halfEnds" it falls flat. Errors: "errorMemory" too.
   */
  get air(): { along: number; across: number };
  set air(value: { along?: number; across?: number });

  /**
   * Velocity of that air [m/s], one number per component, default 0; the field "wind" has one for each node.
   * Errors: "errorRange" too, if count is not the number of components.
   */
  get wind(): Float64Array;
  set wind(value: Numbers);

  // ---- what cloth touches -------------------------------------------------------------------------------------------

  /**
   * As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres among
   * them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three that it
   * would
   * be deepest in, or nearest to, at its velocity, as the planes that touch them where the step begins: it goes through
   * none of them, however fast. Nodes collide; what lies between them does not, nor does cloth with itself.
   * Depth: contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet lands at 50 m/s; with
   * the
   *    default effort nodes are now and then deeper, by up to 7e-3 m in steps that move them by 0.1 m. What lies inside
   *    comes out, and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a step.
   * Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the push that the step's iterations find. With
   * the
   *    default effort, what begins to slide is up to a quarter too slow in its first half second. What friction holds
   *    creeps, at half of the largest force that it can hold by 1e-3 m/s.
   * Beds and callbacks are those of Chain, met at the plane that touches them where a step finds a node: what a hollow
   * rises above that plane a node may end inside of, and the next step takes it out. A callback is asked once a step,
   * for
   * all nodes; answers that it may not give make step say "errorCallback", and one that is missing after a
   * load "errorUnsupported". Errors and ranges are those of the functions of Chain.
   */
  get colliders(): number;
  set colliders(value: number);

  /**
   * As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres among
   * them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three that it
   * would
   * be deepest in, or nearest to, at its velocity, as the planes that touch them where the step begins: it goes through
   * none of them, however fast. Nodes collide; what lies between them does not, nor does cloth with itself.
   * Depth: contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet lands at 50 m/s; with
   * the
   *    default effort nodes are now and then deeper, by up to 7e-3 m in steps that move them by 0.1 m. What lies inside
   *    comes out, and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a step.
   * Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the push that the step's iterations find. With
   * the
   *    default effort, what begins to slide is up to a quarter too slow in its first half second. What friction holds
   *    creeps, at half of the largest force that it can hold by 1e-3 m/s.
   * Beds and callbacks are those of Chain, met at the plane that touches them where a step finds a node: what a hollow
   * rises above that plane a node may end inside of, and the next step takes it out. A callback is asked once a step,
   * for
   * all nodes; answers that it may not give make step say "errorCallback", and one that is missing after a
   * load "errorUnsupported". Errors and ranges are those of the functions of Chain.
   */
  setPlane(index: number, point: Numbers, normal: Numbers, friction?: number): void;

  /**
   * As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres among
   * them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three that it
   * would
   * be deepest in, or nearest to, at its velocity, as the planes that touch them where the step begins: it goes through
   * none of them, however fast. Nodes collide; what lies between them does not, nor does cloth with itself.
   * Depth: contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet lands at 50 m/s; with
   * the
   *    default effort nodes are now and then deeper, by up to 7e-3 m in steps that move them by 0.1 m. What lies inside
   *    comes out, and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a step.
   * Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the push that the step's iterations find. With
   * the
   *    default effort, what begins to slide is up to a quarter too slow in its first half second. What friction holds
   *    creeps, at half of the largest force that it can hold by 1e-3 m/s.
   * Beds and callbacks are those of Chain, met at the plane that touches them where a step finds a node: what a hollow
   * rises above that plane a node may end inside of, and the next step takes it out. A callback is asked once a step,
   * for
   * all nodes; answers that it may not give make step say "errorCallback", and one that is missing after a
   * load "errorUnsupported". Errors and ranges are those of the functions of Chain.
   */
  setCapsule(index: number, first: Numbers, last: Numbers, radius: number, friction?: number): void;

  /**
   * As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and capsules, spheres among
   * them, beds and callbacks, each with velocity and friction of its own. In a step a node meets the three that it
   * would
   * be deepest in, or nearest to, at its velocity, as the planes that touch them where the step begins: it goes through
   * none of them, however fast. Nodes collide; what lies between them does not, nor does cloth with itself.
   * Depth: contacts yield by a node's force times dt^2 / (1e4 mass), some 1e-3 m where a sheet lands at 50 m/s; with
   * the
   *    default effort nodes are now and then deeper, by up to 7e-3 m in steps that move them by 0.1 m. What lies inside
   *    comes out, and what that lifts or stretches gains energy: at 1e9 N/m 1e-3 of it a step.
   * Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the push that the step's iterations find. With
   * the
   *    default effort, what begins to slide is up to a quarter too slow in its first half second. What friction holds
   *    creeps, at half of the largest force that it can hold by 1e-3 m/s.
   * Beds and callbacks are those of Chain, met at the plane that touches them where a step finds a node: what a hollow
   * rises above that plane a node may end inside of, and the next step takes it out. A callback is asked once a step,
   * for
   * all nodes; answers that it may not give make step say "errorCallback", and one that is missing after a
   * load "errorUnsupported". Errors and ranges are those of the functions of Chain.
   */
  setBed(index: number, origin: Numbers, columns: number, rows: number, columnSpacing: number, rowSpacing: number,
    heights: Numbers, friction: number): void;

  getBed(index: number, heightCount?: number): { columns: number; rows: number; heights: Float64Array };

  /** origin may be null where the collider is "callback" already: it stays as it is. */
  removeCollider(index: number): void;

  /** origin may be null where the collider is "callback" already: it stays as it is. */
  setColliderVelocity(index: number, velocity: Numbers): void;

  getCollider(index: number): { shape: Shape; first: Float64Array; second: Float64Array; velocity: Float64Array; radius:
    number; friction: number };

  /**
   * What cloth does to colliders, as getColliderLoad says: what the momentum of each node that meets one lacks,
   * and of a part of the sheet that nothing holds that of all its nodes. So of free sheets the sum is right whatever
   * the
   * effort; of held ones as right as the step's velocities are.
   */
  get loads(): boolean;
  set loads(value: boolean);

  /**
   * What cloth does to colliders, as getColliderLoad says: what the momentum of each node that meets one lacks,
   * and of a part of the sheet that nothing holds that of all its nodes. So of free sheets the sum is right whatever
   * the
   * effort; of held ones as right as the step's velocities are.
   */
  getColliderLoad(index: number): Float64Array;

  /** How thick cloth is, as a distance [m] in [0, 1e60], default 0, that nodes keep from colliders. */
  get thickness(): number;
  set thickness(value: number);

  // ---- fields -------------------------------------------------------------------------------------------------------

  /**
   * Switches a field on, filled with the present uniform values (force 0, target the present position, mask 1, pin
   * what the edges say). "breakingStrainU" and _V switch "stiffnessU" and _V on too. On already: nothing happens.
   * Errors: "errorEnum", "errorMemory"; "errorDiverged" for "target" where the state is not finite; here and below
   * "errorUnsupported" for the fields of cloth of a membrane that is none.
   */
  enableField(field: Field): void;

  /**
   * Switches a field off and releases its memory: uniform values again, no forces, all attachments loosened, all nodes
   * there, none held but on edges. Errors: "errorEnum"; "errorUnsupported" for position, velocity,
   * tension and strain, and for the stiffness of springs that may tear.
   */
  disableField(field: Field): void;

  /**
   * Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [firstU, firstU + nU) x
   * [firstV, firstV + nV). Fields without components have one value per node or spring; there are nu (ring: nu + 1)
   * springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in the buffer:
   * nU * nV * components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates.
   * Errors: "errorEnum", "errorDisabled", "errorRange"; write: "errorValue", with the first bad index, and
   * "errorUnsupported" for tension and strain.
   * One number stands for all places.
   */
  write(field: MembraneField, values: Numbers | number, range?: MembraneRange): void;

  /**
   * Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [firstU, firstU + nU) x
   * [firstV, firstV + nV). Fields without components have one value per node or spring; there are nu (ring: nu + 1)
   * springs along u and nv + 1 rows of them, and likewise along v. `count` is the number of values in the buffer:
   * nU * nV * components. Numbers are rounded once, to the precision of the side that is narrower. Never allocates.
   * Errors: "errorEnum", "errorDisabled", "errorRange"; write: "errorValue", with the first bad index, and
   * "errorUnsupported" for tension and strain.
   * Without `out` a new array, of the object's precision.
   */
  read(field: MembraneField, range?: MembraneRange): Float32Array | Float64Array;
  read<A extends Float32Array | Float64Array>(field: MembraneField, range: MembraneRange | undefined, out: A): A;

  /**
   * Where a field lies in the membrane's own memory, in the membrane's precision, to read without a copy: the value of
   * (u, v, component) is at byte *data + u * u_stride + v * v_stride + component * component_stride. Position,
   * velocity, force and target only. The pointer is good until the field is switched off or the membrane released; the
   * numbers change with every write and step. Do not write through it.
   * Errors: "errorEnum", "errorDisabled", "errorUnsupported".
   * Here as a `View`, which follows the field.
   */
  view(field: MembraneField): View;

  /** `view("position")`; assigned, the field is written. */
  get position(): View;
  set position(values: Numbers | number);

  /** `view("velocity")`; assigned, the field is written. */
  get velocity(): View;
  set velocity(values: Numbers | number);

  /** `view("force")`; assigned, the field is written. */
  get force(): View;
  set force(values: Numbers | number);

  /** `view("target")`; assigned, the field is written. */
  get target(): View;
  set target(values: Numbers | number);

  // ---- acting on it -------------------------------------------------------------------------------------------------

  /**
   * Adds impulse [N s], one number per component, spread over the nodes less than `radius` springs away from the place
   * (u, v), counted on the lattice and not round a ring, by weights (1 - (distance / radius)^2)^2, scaled to sum to 1;
   * all on the nearest node if there is none. A node's velocity changes by its share / its mass; held and absent nodes
   * lose it. u in [0, nu], v in [0, nv], radius >= 0. Errors: "errorRange", "errorValue", "errorDiverged".
   */
  impulse(u: number, v: number, radius: number, impulse: Numbers): void;

  /**
   * Moves the sheet as a whole, as if it had always been there: every position and target becomes rotation * x +
   * offset,
   * every velocity rotation * v; colliders stay where they are. rotation: components rows of as many numbers,
   * orthogonal
   * to 1e-6; null: none. offset [m]: one number per component, which count counts.
   * Errors: "errorRange", "errorValue"; "errorDiverged" for a state that is not finite.
   */
  teleport(rotation: Numbers | null, offset: Numbers): void;

  /**
   * Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does.
   * target: one number per component; null: the node's present position, and count means nothing. Move it afterwards by
   * writing "target". Attaching again changes the numbers. Switches "target" on. Errors: "errorRange"; attach:
   * "errorValue", "errorMemory", and "errorDiverged" for a state that is not finite.
   */
  attach(u: number, v: number, stiffness: number, damping: number, target?: Numbers | null): void;

  /**
   * Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does.
   * target: one number per component; null: the node's present position, and count means nothing. Move it afterwards by
   * writing "target". Attaching again changes the numbers. Switches "target" on. Errors: "errorRange"; attach:
   * "errorValue", "errorMemory", and "errorDiverged" for a state that is not finite.
   */
  detach(u: number, v: number): void;

  /**
   * Ties a node to its target by a spring of `stiffness` [N/m] >= 0 and `damping` [N s/m] >= 0, as a mouse drag does.
   * target: one number per component; null: the node's present position, and count means nothing. Move it afterwards by
   * writing "target". Attaching again changes the numbers. Switches "target" on. Errors: "errorRange"; attach:
   * "errorValue", "errorMemory", and "errorDiverged" for a state that is not finite.
   */
  getAttachment(u: number, v: number): { stiffness: number; damping: number };

  // ---- time ---------------------------------------------------------------------------------------------------------

  /**
   * Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps.
   * Never allocates. Time is proportional to count * nodes * components, with "coupled" to the iterations too.
   * Errors: "errorValue"; "errorDiverged" if a number leaves the finite range: all steps are made, the message gives
   * the first bad one, the membrane can be read, and steps again after reset, a load, or once finite
   * positions and velocities have been written; "errorTolerance" if a coupled solve ended short of its tolerance: all
   * steps are made, and good to the residual that convergence tells.
   */
  step(dt: number, count?: number): void;

  /**
   * The longest dt at which "symplecticEuler" is sure to stay bounded, whatever method is set: the largest dt
   * with 4 M - 2 dt C - dt^2 K positive definite, by a bound on K that is exact in the limit of many nodes for uniform
   * sheets, and a safe lower bound otherwise. Infinity if nothing can swing. Errors: "errorUnsupported" of cloth.
   */
  stableDt(): number;

  /** Simulated time [s] and steps made since create or reset, those before a load or a copied state included. */
  get time(): number;

  /** Simulated time [s] and steps made since create or reset, those before a load or a copied state included. */
  get steps(): number;

  /**
   * How many factorizations the membrane has made: one at the first implicit step and one at the first after each
   * change
   * of dt, lambda, method, solver or a parameter. Not part of the saved state.
   */
  get factorizations(): number;

  // ---- measuring ----------------------------------------------------------------------------------------------------

  /**
   * Energies [J]; Kinetic: of the free nodes. Elastic: stretch, bend and attachments. Gravity:
   * -sum m g x of the free nodes. What of their sum lambda = 1/2 keeps is told above.
   */
  get energy(): { kinetic: number; elastic: number; gravity: number };

  /**
   * Momentum of the free nodes [kg m/s], one number per component.
   * Errors: "errorRange" if count is not the number of components.
   */
  get momentum(): Float64Array;

  /**
   * The force [N], one number per component, with which springs, shear and bend pull at a node where it is now: of a
   * held
   * node, what the sheet does to whatever holds it, but for weight, forces, attachment, pressure and wind of that node
   * itself. Errors: "errorRange" for count, or if there is no such node.
   */
  getReaction(u: number, v: number): Float64Array;

  /**
   * Volume between the sheet and the origin [m^3]: a third of the integral of x over the surface's normal, each cell
   * the
   * mean of its two triangulations, cells with an absent node or torn open left out. Of a drum-head whose rim lies in a
   * plane through the origin it is the volume under it; of a closed surface, what it encloses. 3 components only.
   * Errors: "errorUnsupported".
   */
  get volume(): number;

  /**
   * Positions at n places on the sheet, bilinear between nodes: at[j] = {u, v}, u in [0, nu] (ring: to nu + 1), v
   * likewise; positions[j][component], count = n * components. Errors: "errorRange", "errorEnum",
   * "errorValue".
   */
  sample(at: Numbers, outside?: Outside): Float64Array;

  /** Bytes the membrane holds from its allocator. */
  get memory(): number;

  /** A 64-bit hash of everything save would write. Equal on every machine, compiler and vector width. */
  hash(): bigint;

  // ---- drawing ------------------------------------------------------------------------------------------------------

  /**
   * Writes a vertex for every node, in node order, into the caller's buffer: vertex i at byte i * stride, its position
   * as 3 floats at positionOffset and its unit normal, smooth across the sheet, as 3 floats at normalOffset. A normal
   * points along x_u x x_v and is zero where the sheet has no area or is not finite. Components that are not there are
   * written as 0, and a fourth is not drawn; a membrane of 1 component is drawn as the height z over the unit square,
   * x = u / nu, y = v / nv (a direction without a spring: 0; a ring: u / (nu + 1), and for the normals the sheet goes
   * on
   * beyond its ends). normalOffset null: no normals. Bytes between are left alone; any offset and stride will do,
   * aligned or not, that keeps the vertices apart. Absent nodes get their vertex too, with a zero normal.
   * Errors: "errorRange" if size < nodes * stride, an offset and its 12 bytes reach past stride, or both overlap.
   */
  writeVertices(buffer: ArrayBuffer | ArrayBufferView, stride: number, positionOffset: number, normalOffset: number |
    null): void;

  /**
   * How many indices writeIndices writes now: 6 per cell of four nodes that are there, of cloth 0 if it is
   * torn open, 3 per cell of which three are there. Cells that close a ring are among them, but not of 1 component:
   * they
   * would reach back across the unit square.
   */
  get indexCount(): number;

  /**
   * Writes the triangles as vertex numbers of indexSize 2 or 4 bytes (unsigned, the machine's byte order),
   * counter-clockwise seen from where the normal points; a cell is cut from its node (u, v) to (u + 1, v + 1). `size`
   * is
   * that of the buffer in bytes. The numbers change with "mask", ring and what is cut of cloth only.
   * 65535 with 2 bytes and 2^32 - 1 with 4, which graphics cards may take for a restart, are never written. Errors:
   * "errorValue" for another indexSize; "errorRange" if size is too small; "errorUnsupported" for more nodes.
   */
  writeIndices(buffer: ArrayBuffer | ArrayBufferView, indexSize: number): void;

  // ---- keeping ------------------------------------------------------------------------------------------------------

  /**
   * The whole state as bytes, all the future depends on but the callbacks, as save says. load needs a membrane of
   * the same shape and precision; it switches fields on and off as they were.
   * Errors: save: "errorRange". load: "errorFormat", "errorMismatch", "errorMemory".
   */
  saveSize(): number;

  /**
   * The whole state as bytes, all the future depends on but the callbacks, as save says. load needs a membrane of
   * the same shape and precision; it switches fields on and off as they were.
   * Errors: save: "errorRange". load: "errorFormat", "errorMismatch", "errorMemory".
   */
  save(): Uint8Array;

  /**
   * The whole state as bytes, all the future depends on but the callbacks, as save says. load needs a membrane of
   * the same shape and precision; it switches fields on and off as they were.
   * Errors: save: "errorRange". load: "errorFormat", "errorMismatch", "errorMemory".
   */
  load(bytes: ArrayBuffer | ArrayBufferView): void;

  /**
   * Makes `membrane` what `source` is, as save and load would, without the bytes: the two must agree in shape and
   * precision. Allocates only if they differ in the fields switched on. Errors: "errorMismatch", "errorMemory".
   */
  copyState(source: Membrane): void;

  /** Positions, velocities, time and steps back to 0. Parameters, fields and pins stay; targets too. */
  reset(): void;
}

/**
 * The fields of a Water.
 *
 *  field            per           unit    values
 *  "depth"         cell          m       finite, >= 0; of an absent cell only 0
 *  "bed"           cell          m       finite
 *  "surface"       cell          m       finite: bed + depth. Written: depth becomes surface - bed, or 0 where that is
 *                                         below the bed; of an absent cell nothing changes
 *  "velocityX"    x-face        m/s     finite; of a face that no water can cross only 0. Along periodic x the faces
 *                                         i = 0 and nx are one
 *  "velocityY"    y-face        m/s     likewise
 *  "source"        cell          m/s     finite: depth per second that comes in, or leaves as far as there is water;
 *                                         acts until it is overwritten
 *  "pressure"      cell          Pa      finite: on the surface
 *  "forceX"       x-face        m/s^2   finite: an acceleration; a wind's stress over density and depth
 *  "forceY"       y-face        m/s^2   likewise
 *  "mask"          cell          -       1: there; 0: absent, walled off. Its water goes, as a write of depth
 *  "wallX"        x-face        -       1: a wall stands there; 0: none. i from 1 to nx - 1 only count, and along
 *                                         periodic x 0, which is nx
 *  "wallY"        y-face        -       likewise
 * Depth, bed and velocities are always there, and the surface, which is made of them. The others cost memory and time
 * only once they are switched on. Writing "depth", "surface" or "mask" starts the account anew.
 */
export type WaterField = "depth" | "bed" | "surface" | "velocityX" | "velocityY" | "source" | "pressure" | "forceX" |
  "forceY" | "mask" | "wallX" | "wallY";

/** Part of a field; what is left out is all the rest. */
export interface WaterRange {
  firstX?: number;
  firstY?: number;
  nX?: number;
  nY?: number;
}

/** What it is made with, and then any property that can be set, in this order. */
export interface WaterOptions {
  nx: number;
  ny: number;
  dx: number;
  dy: number;
  precision?: Precision; // default "float64"
  method?: Method;
  lambda?: number;
  momentum?: Momentum;
  first?: boolean;
  kernels?: Kernels;
  gravity?: number;
  density?: number;
  drag?: number;
  manning?: number;
  bedRule?: BedRule;
  hulls?: { count?: number; nAlong?: number; nAcross?: number };
  sleep?: number;
  depth?: Numbers | number;
  bed?: Numbers | number;
  velocityX?: Numbers | number;
  velocityY?: Numbers | number;
  source?: Numbers | number;
  pressure?: Numbers | number;
  forceX?: Numbers | number;
  forceY?: Numbers | number;
}

/**
 * contdyn: water: a height field of columns over a bed: pool, river, tide, flood.
 *
 * A water has nx x ny cells of dx x dy metres; ny = 1 is a slice. A cell holds a column of water of depth d >= 0 over
 * its bed b; its surface is h = b + d. Velocities live on the faces between cells: x-face (i, j) lies between the cells
 * (i - 1, j) and (i, j), so that there are nx + 1 of them in a row; y-face (i, j) between (i, j - 1) and (i, j). Cell
 * (i, j) has its centre at ((i + 1/2) dx, (j + 1/2) dy).
 *
 * Motion    d_t + (d u)_x + (d v)_y = source
 *           u_t [+ u u_x + v u_y] = -g h_x - p_x / density + force - friction u,     and v likewise
 *           friction = drag + g manning^2 |u| / d^(4/3)         (Kass 1997, eq. 32-33; the bracket: shallow water)
 *
 * "linear"    without the bracket: waves, splashes, tides, floods that creep.
 * "advected"  with it: moving shores, dam breaks, bores, whirls. Momentum goes with the water that leaves a
 *                       cell, upwind, of second order where depths are even.
 *
 * What to set: the momentum by this list; lambda as momentum sets it; one step a frame, which is never too
 * long to be stable, or more where waves must run at their speed (getCourant at most 1). lambda = 1/2 is of
 * second order in time and keeps the energy of small waves; above 1/2 short waves die out, and linear water, whose
 * shores
 * are steep, needs a little more. Right for waves much longer than the water is deep and for surfaces that do not turn
 * over: there is no dispersion, and there are no ship wakes.
 *
 * A step sweeps along all rows, then along all columns, and the next step the other way round. Along such a line the
 * fluxes and the changes of the surface are solved for together, by the theta scheme, theta = lambda, in time in
 * proportion to its cells. The depth at a face is the mean of its two cells'; where these differ a lot, it is nearer to
 * that of the cell which the water leaves. No cell gives more than it has and gets: limited tells how much
 * that holds back. So no depth is negative, a lake lies still on any bed, and account tells all changes of
 * volume. Explicit methods differ in that no surface is solved for: half of the slope pushes, the water moves, then the
 * other half pushes (velocity Verlet).
 *
 * What goes wrong, and by how much. "From n cells on": in steps, or parts of fast water's, in which waves cross as
 * many.
 *   Long steps: from 1 cell on waves run too slowly, short ones most, and slantwise more than along the axes. Make
 *      them shorter: to solve for the whole plane, a system that streams make neither symmetric nor definite, cost tens
 *      of times as much, and gained and lost water.
 *   Fast water: a line whose water would run more than half a cell makes its step in 2, 4, ... 64 parts, at so many
 *      times the cost, none of which begins with faster water. Water that runs more than 32 cells is carried less
 *      exactly, and ripples on it may grow; on slower water only those of linear momentum, lambda 1/2, uneven beds do.
 *   Bores, linear: momentum is not carried on, so that a shore moves with the slope of the surface there, and a bore a
 *      tenth, half, twice as high as the depth before it is 2, 9, 22% too slow, against a stream as much too fast.
 *   Bores, advected: within 1.2% of their speed, also against streams, until water runs over 32 cells; from 2 cells
 *      on those a tenth of the depth high are spread over 2 to 6 times as many. Waves behind a bore: with lambda = 1/2
 *      up to its own height (linear: 1.6), with 0.6 up to 0.3 (1.3), all along its way where the water behind it rests.
 *   Energy, linear: where water deepens it gains h_t u^2 / 2, at random shores some hundredths in all (and see hulls).
 *      From 2 cells on waves in the plane, with lambda = 1/2, grow in thousands of steps to a ninth of the depth.
 *   Energy, advected: from 1 cell on it does not rise by itself. Below 1 cell up to 0.005 of it is won among cliffs,
 * far
 *      below also at shores, and 0.01 in the first step after velocities are written there.
 *   Energy, both: from 1 cell on no face gains more than its water loses by falling: linear over uneven depths,
 *      advected where a depth changes by half; from 1e12 on rounding may add any amount. Air that presses water dry
 *      adds 1.4 times what it has to give where momentum is linear, half of it where advected, any amount if explicit.
 *   Dry land: what pushes water away from it gives the face at the water's edge a velocity that no water follows.
 *
 * A new water is dry, over a bed at 0, at rest, walled in, gravity 9.81, density 1000, no drag, "linear",
 * "implicit" with lambda 0.55.
 * All computing is in double precision; "float32" is what depth, bed, velocities and the fields are stored in. Steps
 * store 0 for depths below 2^-80 m and velocities below 2^-80 (float32), 2^-500 m/s. Parameters may be as large as
 * 1e60.
 *
 * Every function returns "errorNull" for a null pointer and "errorHandle" for a handle of another kind; the
 * comments name the other errors. Functions that chain and membrane have too mean the same here.
 */
export class Water extends Handle {
  /**
   * Makes a water. nx, ny >= 1; dx, dy [m] in [1e-30, 1e30]. Errors: "errorValue", "errorEnum",
   * "errorSize", "errorMemory"; "errorUnsupported" for a precision that this build leaves out.
   */
  constructor(options: WaterOptions);

  // ---- life ---------------------------------------------------------------------------------------------------------

  /** What new Water was given, or what has been loaded since. */
  get shape(): { nx: number; ny: number; dx: number; dy: number; precision: Precision };

  // ---- method -------------------------------------------------------------------------------------------------------

  /**
   * How steps are made: "implicit"; "symplecticEuler", here in its symmetric form, second order in time
   * and bounded up to stableDt; "forwardEuler", first order, bounded at no dt.
   * Errors: "errorEnum"; "errorUnsupported" for "stiffSecond"; "errorMemory".
   */
  get method(): Method;
  set method(value: Method);

  /** lambda of "implicit", in [0, 1]; below 1/2 it grows without bound at most dt. Errors: "errorValue". */
  get lambda(): number;
  set lambda(value: number);

  /**
   * Linear or advected momentum; see above. Sets lambda too, to what suits the mode: 0.55 for linear, 1/2 for advected.
   * Advected momentum costs memory. Errors: "errorEnum"; "errorMemory".
   */
  get momentum(): Momentum;
  set momentum(value: Momentum);

  /**
   * Which way the next step sweeps first: along x (0, the default of a new water) or along y (1). Every step turns it
   * round. A scene and its transpose, begun opposite ways, stay each other's transpose to the bit.
   * Errors: "errorValue" for anything but 0 and 1.
   */
  get first(): boolean;
  set first(value: boolean);

  /**
   * The instructions that steps are made of, from here on: for tests and measurements, as all give the same bits and a
   * new water has the fastest that its processor runs. Not part of the saved state.
   * Errors: "errorEnum"; "errorUnsupported" for kernels that are not among runnableKernels.
   */
  get kernels(): Kernels;
  set kernels(value: Kernels);

  // ---- parameters ---------------------------------------------------------------------------------------------------
  // Errors of all setters: "errorValue" for a number that is NaN, infinite or out of range.

  /** Gravity [m/s^2], 0 or in [1e-60, 1e6]; default 9.81. */
  get gravity(): number;
  set gravity(value: number);

  /** Density [kg/m^3], in [1e-6, 1e6]; default 1000. Only pressure, impulses and energies know it. */
  get density(): number;
  set density(value: number);

  /** Drag [1/s], >= 0: velocities die out by exp(-drag t). Default 0. */
  get drag(): number;
  set drag(value: number);

  /**
   * Manning's roughness of the bed [s/m^(1/3)], in [0, 1e3]: 0.01 for glass, 0.03 for a river, 0.1 for a flooded wood.
   * Default 0. Water that runs down a slope S, any way, settles at d^(2/3) sqrt(S) / manning.
   */
  get manning(): number;
  set manning(value: number);

  /**
   * What is at a side. `value` now, and how fast it changes, `rate` per second, from now on, both at most 1e60 in size,
   * in "float32" 1e30:
   *   "open"     level of the water outside [m], which is at rest: for a tide set level and rate anew as it goes.
   *                      Low waves leave without an echo; some hundredths of high ones come back. With d the depth in
   * the
   *                      cell at the side, D the level's depth over the same bed, water leaves by u = 2 (sqrt(g d) -
   *                      sqrt(g D)), linear by u = sqrt(g d) (1 - D / d), and the discharge is u d. Where u is faster
   *                      than waves, as over a side that lies higher than the level, water falls off: a stream slower
   * than
   *                      its waves leaves at critical depth, u = sqrt(g d), a faster one as it comes.
   *   "level"    level [m] that is held at the side itself: with D its depth over the bed of the cell there and q
   *                      the discharge one face inside, what leaves tends, as waves cross half a cell, to q + 2 D
   * (sqrt(g
   *                      d) - sqrt(g D)), advected with q D / d for q where d < D. Advected water that comes in at U
   *                      stands U^2 / 2 g lower, at most D / 3. Waves are thrown back; with lambda = 1/2 some may grow,
   *                      slowly. What outruns its waves falls off as above.
   *   "inflow"   discharge per metre of the side [m^2/s] into the water, velocity times depth; into a cell below
   *                      critical depth it comes in at that. If negative it leaves, as far as there is water.
   *   "wall", "periodic"   value and rate mean nothing
   * Both sides of a direction are periodic or neither is: setting one sets the other, and leaving it leaves both, the
   * opposite one as a wall. Errors: "errorEnum"; "errorValue".
   */
  setSide(side: Side, kind: Border, value?: number, rate?: number): void;

  /** Value and rate as of now; 0 where they mean nothing. Errors: "errorEnum". */
  getSide(side: Side): { kind: Border; value: number; rate: number };

  /**
   * Depth of an inflow [m], 0 or in [1e-6, 1e30]; default 0: that of the cell at the side. Else advected water comes in
   * at
   * the speed of its discharge in that depth, as under a gate so far open: faster than its waves, it has that depth in
   * the
   * first cell; if slower, or if it drowns the gate, that of what comes after. Other sides, outflow and linear momentum
   * do
   * not use it; setSide keeps it. Errors: "errorEnum"; "errorValue".
   */
  setInflowDepth(side: Side, depth: number): void;

  /**
   * Depth of an inflow [m], 0 or in [1e-6, 1e30]; default 0: that of the cell at the side. Else advected water comes in
   * at
   * the speed of its discharge in that depth, as under a gate so far open: faster than its waves, it has that depth in
   * the
   * first cell; if slower, or if it drowns the gate, that of what comes after. Other sides, outflow and linear momentum
   * do
   * not use it; setSide keeps it. Errors: "errorEnum"; "errorValue".
   */
  getInflowDepth(side: Side): number;

  /** What a write to "bed" leaves as it is; default "liftsWater". Errors: "errorEnum". */
  get bedRule(): BedRule;
  set bedRule(value: BedRule);

  // ---- fields -------------------------------------------------------------------------------------------------------

  /**
   * Switches a field on: no sources, pressure, force or walls yet, all cells there. On already: nothing happens.
   * Errors: "errorEnum"; "errorUnsupported" for a field of other objects; "errorMemory".
   */
  enableField(field: Field): void;

  /** Switches a field off and releases its memory. Errors: "errorEnum"; "errorUnsupported" if it is always there. */
  disableField(field: Field): void;

  /**
   * Writes or reads values[j][i], dense, of the rectangle of cells or faces [firstX, firstX + nX) x [firstY,
   * firstY + nY); `count` is nX * nY. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces. Numbers are
   * rounded once, to the precision of the side that is narrower. Never allocates. Errors: "errorEnum",
   * "errorUnsupported", "errorDisabled", "errorRange"; write: "errorValue", with the first bad index.
   * One number stands for all places.
   */
  write(field: WaterField, values: Numbers | number, range?: WaterRange): void;

  /**
   * Writes or reads values[j][i], dense, of the rectangle of cells or faces [firstX, firstX + nX) x [firstY,
   * firstY + nY); `count` is nX * nY. There are nx + 1 x-faces in a row and ny + 1 rows of y-faces. Numbers are
   * rounded once, to the precision of the side that is narrower. Never allocates. Errors: "errorEnum",
   * "errorUnsupported", "errorDisabled", "errorRange"; write: "errorValue", with the first bad index.
   * Without `out` a new array, of the object's precision.
   */
  read(field: WaterField, range?: WaterRange): Float32Array | Float64Array;
  read<A extends Float32Array | Float64Array>(field: WaterField, range: WaterRange | undefined, out: A): A;

  /**
   * Where a field lies in the water's own memory, in its precision, to read without a copy: the value of (i, j) is at
   * byte *data + i * x_stride + j * y_stride. All but "surface", "mask" and the walls. The pointer is good until
   * the field is switched off or the water released; the numbers change with every write and step. Do not write through
   * it. Errors: "errorEnum", "errorDisabled", "errorUnsupported".
   * Here as a `View`, which follows the field.
   */
  view(field: WaterField): View;

  /** `view("depth")`; assigned, the field is written. */
  get depth(): View;
  set depth(values: Numbers | number);

  /** `view("bed")`; assigned, the field is written. */
  get bed(): View;
  set bed(values: Numbers | number);

  /** `view("velocityX")`; assigned, the field is written. */
  get velocityX(): View;
  set velocityX(values: Numbers | number);

  /** `view("velocityY")`; assigned, the field is written. */
  get velocityY(): View;
  set velocityY(values: Numbers | number);

  /** `view("source")`; assigned, the field is written. */
  get source(): View;
  set source(values: Numbers | number);

  /** `view("pressure")`; assigned, the field is written. */
  get pressure(): View;
  set pressure(values: Numbers | number);

  /** `view("forceX")`; assigned, the field is written. */
  get forceX(): View;
  set forceX(values: Numbers | number);

  /** `view("forceY")`; assigned, the field is written. */
  get forceY(): View;
  set forceY(values: Numbers | number);

  // ---- acting on it -------------------------------------------------------------------------------------------------
  // Discs have their centre at (x, y) [m] in the scene, x in [0, nx dx], y in [0, ny dy], and a radius [m] >= 0; where
  // a
  // disc has no cell centre in it, it is the cell at (x, y), the nearest one that is there. Shares fall off as
  // (1 - (distance / radius)^2)^2 from the centre, and are not spread round a periodic side.

  /**
   * Adds volume [m^3] over a disc, or takes it if negative, as far as there is water in each cell's share. added tells
   * what it came to. The account counts it. Errors: "errorValue", "errorDiverged".
   */
  addVolume(x: number, y: number, radius: number, volume: number): number;

  /**
   * Adds volume [m^3] evenly over the cells there of a rectangle, or takes it; added as above.
   * Errors: "errorRange"; "errorValue", "errorDiverged".
   */
  addVolumeRectangle(firstX: number, firstY: number, nX: number, nY: number, volume: number): number;

  /**
   * Adds a source of rate [m^3/s] over a disc to "source", or a drain if negative, and switches that field on.
   * Errors: "errorValue"; "errorMemory".
   */
  addSource(x: number, y: number, radius: number, rate: number): void;

  /** The same evenly over the cells there of a rectangle. Errors: "errorRange"; "errorValue"; "errorMemory". */
  addSourceRectangle(firstX: number, firstY: number, nX: number, nY: number, rate: number): void;

  /**
   * A splash: water of the disc, down to `height` [m] >= 0 at its centre and as far as there is water, is heaped up on
   * the
   * wet cells around it, out to twice the radius, if there are any; volume is kept. Errors: "errorValue", _DIVERGED.
   */
  splash(x: number, y: number, radius: number, height: number): void;

  /**
   * Adds an impulse (x, y) [N s] over a disc: a face's velocity changes by its share of it / the mass of water at it,
   * shares in proportion to that mass too; on dry faces nothing happens. Errors: "errorValue", "errorDiverged".
   */
  impulse(x: number, y: number, radius: number, impulseX: number, impulseY: number): void;

  // ---- what floats on it --------------------------------------------------------------------------------------------
  // Hulls float on the water, numbered from 0. Each is a rigid body whose floor is a rectangle of nAlong x nAcross
  // plates, at heights above its keel, with sides as high as it takes. What presses the water down makes waves; water
  // that rises, slopes or runs lifts, pushes and drags the hull; where the bed is higher it lies on that. Water only
  // meets
  // a hull's floor, and hulls do not meet each other. At sides that are not periodic a hull stops, without turning,
  // where
  // a cell's width of water is left before it, if there is room for that, and before walls and cells that are not
  // there.
  //
  // A pose is {x, y, z, aheadX, aheadY, pitch, roll}: the middle, the height of the keel under it [m], the direction of
  // the bow, and small slopes: pitch is by how much the bow rises per metre ahead, roll the port side, to the left, per
  // metre to port. Velocities are {along x, along y, upward [m/s], yaw, pitch, roll [1/s]}, yaw counter-clockwise seen
  // from above. Mass is spread evenly over length and width; the righting moment is that of the waterline.
  //
  // Between body and water lies an elastic skin, three times as stiff as the water's surface: the keel of a hull of
  // many
  // cells lies by a third of the draft below the floor that getHullFloor gives, to be drawn. At rest the floor
  // displaces the mass: draft = mass / (density area), if flat. Wedges displace 1.01 times as much, 3 cells wide 1.2
  // times.
  //
  // Energy: steps stay bounded at any dt, for hulls of any mass, and hulls and water together gain no energy but what
  // the
  //    water itself does and up to a twentieth of what hulls move and press with, which they owe. The water's is much
  //    where a hull presses it dry, if linear, where waves cross 2.8 cells 13 times what was there; advected none.
  // Long steps, in which waves cross many cells or a hull its own length, slow hulls down.
  // Momentum: the water gets all that drag takes from a hull, less in long steps, and half or more of what its waves
  // take.
  // Time: forces cost in proportion to the cells under hulls, and all cells of water with hulls a little more.
  // Errors of all: "errorRange" for an index that no hull has, or a count that is not what the comment says.

  /**
   * How many hulls there are, `count`, 0 to 4096, default 0, and how many plates each has, `nAlong` and `nAcross`, 1 to
   * 256: new ones are none (mass 0), those that stay keep what they are unless the plates change. Without hulls nAlong
   * and nAcross mean nothing. Errors: "errorValue"; "errorMemory".
   */
  get hulls(): { count: number; nAlong: number; nAcross: number };
  set hulls(value: { count?: number; nAlong?: number; nAcross?: number });

  /**
   * Makes a hull of a mass [kg] in [1e-12, 1e15] and length and width [m], >= 1e-60 and at most 512 cells.
   * heights[j][i]:
   * of the floor's plate i along, j to port, above the keel [m], in [0, 1e60], or -1 where there is none; `count` is
   * nAlong nAcross; null: flat. Where it is, and how it moves, stays. Errors: "errorValue", also for no plate.
   */
  setHull(index: number, mass: number, length: number, width: number, heights?: Numbers | null): void;

  /**
   * Makes a hull with a flat round floor: those plates of a square whose middles lie in the disc, all stretched so that
   * their area is the disc's. The radius [m] is >= 1e-60, the square at most 512 cells wide. Errors: "errorValue".
   */
  setDisc(index: number, mass: number, radius: number): void;

  /**
   * What a hull is: mass (0: none), length, width, the area of its plates [m^2].; heights:
   * `count` of them, or null and any count.
   */
  getHull(index: number, count?: number): { mass: number; length: number; width: number; area: number; heights:
    Float64Array };

  /**
   * What a hull is: mass (0: none), length, width, the area of its plates [m^2].; heights:
   * `count` of them, or null and any count.
   */
  removeHull(index: number): void;

  /**
   * Launches a hull at (x, y) in the scene, its bow towards (aheadX, aheadY) of any length but 0, at rest. It lies as
   * it
   * would in time. The water that it displaces goes, evenly, to all cells whose surface is within its draft of that
   * under
   * it; where there is no such cell, or the bed bears it, it displaces none. What it displaced before is not given
   * back:
   * to move a hull set its pose. Errors: "errorValue"; "errorDisabled" if it has no mass, or no cell is under it, or
   * gravity is 0; "errorDiverged" of a water that did.
   */
  launchHull(index: number, x: number, y: number, aheadX: number, aheadY: number): void;

  /**
   * The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most
   * 1e15
   * in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An obstacle
   * that moves through the water, as heavy as the water in its place or heavier, has both set before each step; with
   * its
   * keel a third of the water's depth below the bed it presses all water away. Errors: "errorValue".
   */
  setHullPose(index: number, pose: Numbers): void;

  /**
   * The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most
   * 1e15
   * in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An obstacle
   * that moves through the water, as heavy as the water in its place or heavier, has both set before each step; with
   * its
   * keel a third of the water's depth below the bed it presses all water away. Errors: "errorValue".
   */
  getHullPose(index: number, count: number): Float64Array;

  /**
   * The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most
   * 1e15
   * in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An obstacle
   * that moves through the water, as heavy as the water in its place or heavier, has both set before each step; with
   * its
   * keel a third of the water's depth below the bed it presses all water away. Errors: "errorValue".
   */
  setHullVelocity(index: number, velocity: Numbers): void;

  /**
   * The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all others are at most
   * 1e15
   * in size, and the direction of the bow is given back with length 1. New hulls lie at 0, heading along x. An obstacle
   * that moves through the water, as heavy as the water in its place or heavier, has both set before each step; with
   * its
   * keel a third of the water's depth below the bed it presses all water away. Errors: "errorValue".
   */
  getHullVelocity(index: number, count: number): Float64Array;

  /** The pose in which the floor lies on the water since the last step or launch, to be drawn: 7 numbers. */
  getHullFloor(index: number, count: number): Float64Array;

  /**
   * What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port and up [N] and
   * moments of yaw, pitch and roll [N m], at most 1e30 in size. Default 0. Errors: "errorValue".
   */
  setHullForce(index: number, force: Numbers): void;

  /**
   * What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port and up [N] and
   * moments of yaw, pitch and roll [N m], at most 1e30 in size. Default 0. Errors: "errorValue".
   */
  getHullForce(index: number, count: number): Float64Array;

  /**
   * Drag against the water under it, along the hull and across it [N s/m], which slows turning too, and Coulomb
   * friction
   * on the bed; in [0, 1e30], default 0. Errors: "errorValue".
   */
  setHullDrag(index: number, along: number, across: number, friction: number): void;

  /**
   * Drag against the water under it, along the hull and across it [N s/m], which slows turning too, and Coulomb
   * friction
   * on the bed; in [0, 1e30], default 0. Errors: "errorValue".
   */
  getHullDrag(index: number): { along: number; across: number; friction: number };

  /**
   * What a hull felt from water and bed in the last step: 6 numbers, forces x, y, up [N], moments yaw, pitch, roll [N
   * m].
   */
  getHullLoad(index: number, count: number): Float64Array;

  /** Energies of all hulls [J]: of their motion; mass g z, and what their skins hold. */
  get hullEnergy(): { kinetic: number; potential: number };

  /**
   * How high [m] the water would stand at n places, at[k] = {x, y}, with no hull pressing on it: its surface and the
   * head
   * that hulls press with. Errors: "errorEnum"; "errorValue" for a place outside; "errorRange" for more than fit
   * in memory.
   */
  sampleHeads(at: Numbers, outside?: Outside): Float64Array;

  // ---- time ---------------------------------------------------------------------------------------------------------

  /**
   * Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps.
   * Never allocates. Time is proportional to count * cells, and to the parts that steps are made in (see above).
   * Errors: "errorValue"; "errorDiverged" if a number leaves the finite range: all steps are made, the message gives
   * the first bad one, the water can be read, and steps again after reset, a load, or once finite depths and
   * velocities have been written.
   */
  step(dt: number, count?: number): void;

  /**
   * The longest dt at which "symplecticEuler" stays bounded for small waves on the water as it lies now,
   * whatever method is set: the least of both axes, each exact in the limit of many cells for water of one depth, a
   * safe
   * lower bound otherwise; for a stream over an uneven bed take 0.8 of it. Infinity if nothing can swing.
   */
  stableDt(): number;

  /** Simulated time [s] and steps made since create or reset, those before a load or a copied state included. */
  get time(): number;

  /** Simulated time [s] and steps made since create or reset, those before a load or a copied state included. */
  get steps(): number;

  /**
   * How many times lines have been solved along a direction since the water was made: of every sweep the most parts
   * that
   * a line made its step in, each a factorization of its own, since depths change. Not part of the saved state.
   */
  get factorizations(): number;

  /**
   * What the last call of step had to hold back so that no cell gave more than it had and got: in how many
   * cells, counted once per sweep and part, and how much less water [m^3] went through faces.
   */
  get limited(): { cells: number; volume: number };

  /**
   * Lets water sleep where it hardly moves: steps leave parts of 16 x 16 cells as they are, at no cost, where all waves
   * are lower than `height` [m], in [0, 1e60], and so are all that a step could carry there. Default 0: nothing sleeps.
   * Neglected are, at each face, a rise of the surface below height / 16, a velocity below height sqrt(g / d), and
   * water
   * that stands less than the height over the higher bed. What falls asleep stops, so energy is lost and none gained;
   * volume is kept. Waves lower than the height meet sleeping water as a wall. The energy bound of long steps, which is
   * one of whole lines, is then one of what is awake of a line.
   * Awake stay parts with sources or forces, under hulls, and at open, level and inflow sides; and all of the water
   * while there are higher waves at a periodic side. Which parts sleep follows from the state alone, whatever hook and
   * kernels; where all are awake a step has the bits of one of water that never sleeps.
   * A step's time is in proportion to the cells awake, each up to half as dear again. A splash, a volume, an impulse, a
   * write of cells or faces and what is set of a hull wake what they touch; after any other call that may change the
   * water the next step looks at all of it, in half a step's time. Costs a byte for ten cells. The height is kept with
   * the state. Errors: "errorValue"; "errorMemory".
   */
  get sleep(): number;
  set sleep(value: number);

  /**
   * How many cells were awake in the last step; all, before it and where nothing sleeps. Not part of the saved state.
   */
  get awake(): number;

  // ---- measuring ----------------------------------------------------------------------------------------------------

  /** Volume [m^3]: the sum of all depths times the cells' area. */
  get volume(): number;

  /**
   * The volume account [m^3], kept in double whatever the precision: what was there when it was started (by create,
   * reset, restartAccount, or a write of "depth", "surface" or "mask"), what came in since then (sides,
   * sources, volumes added, beds that keep the surface), what went out, and what the present volume has above initial +
   * in - out, which is rounding.
   */
  get account(): { initial: number; in: number; out: number; error: number };

  /**
   * The volume account [m^3], kept in double whatever the precision: what was there when it was started (by create,
   * reset, restartAccount, or a write of "depth", "surface" or "mask"), what came in since then (sides,
   * sources, volumes added, beds that keep the surface), what went out, and what the present volume has above initial +
   * in - out, which is rounding.
   */
  restartAccount(): void;

  /**
   * Energies [J]; Kinetic: density / 2 times area, mean depth of both cells and velocity^2 of
   * faces, at a shore as steps begin with it. Potential: density g times area, depth and height of the column's middle.
   */
  get energy(): { kinetic: number; potential: number };

  /** Area [m^2] of the cells with depth > 0. */
  get wetArea(): number;

  /**
   * The largest Courant number of a step of dt [s], in [0, 1e30], over directions and wet faces: (|u| + sqrt(g d)) dt /
   * dx.
   * Errors: "errorValue".
   */
  getCourant(dt: number): number;

  /**
   * The water at n places, at[k] = {x, y} in metres inside the scene: surface [m] and depth [m], bilinear between cell
   * centres that are there, level beyond the outermost ones; normal of the surface (3 numbers, unit length, z up);
   * velocity [m/s] (2 numbers), bilinear between faces. A dry place has the bed for its surface.
   * Errors: "errorEnum"; "errorValue" for a place outside; "errorRange" for more than fit in memory.
   */
  sample(at: Numbers, outside?: Outside): { surface: Float64Array; depth: Float64Array; normal: Float64Array; velocity:
    Float64Array };

  /** Bytes the water holds from its allocator. */
  get memory(): number;

  /** A 64-bit hash of everything save would write. Equal on every machine, compiler and vector width. */
  hash(): bigint;

  // ---- drawing ------------------------------------------------------------------------------------------------------

  /**
   * Writes a vertex for every cell, cell (i, j) as number j nx + i, into the caller's buffer: vertex k at byte k *
   * stride, its position, the cell's centre on the surface, as 3 floats at positionOffset; its unit normal as 3 floats
   * at normalOffset; its depth as 1 float at depthOffset, 0 where it is dry and -1 where the cell is absent, for a
   * shader to fade out shores. normalOffset or depthOffset null: none. Bytes between are left alone; any offset
   * and stride will do that keeps them apart. Errors: "errorRange" if size is less than cells * stride, or an offset
   * and its bytes reach past stride, or two overlap.
   */
  writeVertices(buffer: ArrayBuffer | ArrayBufferView, stride: number, positionOffset: number, normalOffset: number |
    null, depthOffset: number | null): void;

  /**
   * How many indices writeIndices writes now: 6 per square of four neighbouring cells that are there, 3 per
   * square of which three are. skipDry 1: squares without a wet cell are left out, so that it changes with the water.
   * Errors: "errorValue" for a skipDry neither 0 nor 1.
   */
  getIndexCount(skipDry: boolean): number;

  /**
   * Writes the triangles as vertex numbers of indexSize 2 or 4 bytes (unsigned, the machine's byte order), counter-
   * clockwise seen from above. `size` is that of the buffer in bytes. 65535 with 2 bytes and 2^32 - 1 with 4 are never
   * written. Errors: "errorValue" for another indexSize, or skipDry neither 0 nor 1; "errorRange" if size is too
   * small; "errorUnsupported" for more than 65535 or 2^32 - 1 cells.
   */
  writeIndices(skipDry: boolean, buffer: ArrayBuffer | ArrayBufferView, indexSize: number): void;

  // ---- keeping ------------------------------------------------------------------------------------------------------

  /**
   * The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but the callbacks.
   * Little-endian on every machine, versioned, with a checksum. save needs size >= saveSize and tells what it
   * wrote. load needs a water of as many cells and the same precision, takes the cells' size over, and switches fields
   * on
   * and off as they were. Bytes that are damaged, cut short, of a later version or another kind are refused.
   * Errors: save: "errorRange". load: "errorFormat", "errorMismatch", "errorMemory".
   */
  saveSize(): number;

  /**
   * The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but the callbacks.
   * Little-endian on every machine, versioned, with a checksum. save needs size >= saveSize and tells what it
   * wrote. load needs a water of as many cells and the same precision, takes the cells' size over, and switches fields
   * on
   * and off as they were. Bytes that are damaged, cut short, of a later version or another kind are refused.
   * Errors: save: "errorRange". load: "errorFormat", "errorMismatch", "errorMemory".
   */
  save(): Uint8Array;

  /**
   * The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but the callbacks.
   * Little-endian on every machine, versioned, with a checksum. save needs size >= saveSize and tells what it
   * wrote. load needs a water of as many cells and the same precision, takes the cells' size over, and switches fields
   * on
   * and off as they were. Bytes that are damaged, cut short, of a later version or another kind are refused.
   * Errors: save: "errorRange". load: "errorFormat", "errorMismatch", "errorMemory".
   */
  load(bytes: ArrayBuffer | ArrayBufferView): void;

  /**
   * Makes `water` what `source` is, as save and load would, without the bytes: the two must agree in cells and
   * precision.
   * Allocates only if they differ in the fields switched on. Errors: "errorMismatch", "errorMemory".
   */
  copyState(source: Water): void;

  /**
   * Depths, velocities, time, steps and account back to 0, hulls to where new ones lie, at rest. Bed, parameters and
   * the
   * other fields stay, and what hulls are. What is at sides begins again with time: a level or discharge that changes
   * is
   * what it was at time 0, or by its rate would have been if it was set later; then set it anew.
   */
  reset(): void;
}
