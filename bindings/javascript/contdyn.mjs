// contdyn: ropes, hair, sheets, drums and water. Made by generate.py from ../api.json: do not edit.
import {
  Handle, addressOf, assign, begin, bits, check, componentsOf, count, enumeration, expect, flag, getBytes, got, integer,
  items, knowStatuses, member, nameOf, number, optionsOf, put, putBytes, readField, real, result, several, size,
  sizeOrNone, take, text, viewField, wasm, whole, writeField,
} from "./runtime.mjs";

export { ContdynError, load } from "./runtime.mjs";

export const VERSION = "0.2.0";

export const Status = enumeration({
  ok: 0,
  errorNull: 1,
  errorHandle: 2,
  errorValue: 3,
  errorEnum: 4,
  errorRange: 5,
  errorSize: 6,
  errorMemory: 7,
  errorDisabled: 8,
  errorUnsupported: 9,
  errorDiverged: 10,
  errorFormat: 11,
  errorMismatch: 12,
  errorTolerance: 13,
  errorCallback: 14,
});

export const Precision = enumeration({
  float32: 0,
  float64: 1,
});

export const Method = enumeration({
  implicit: 0,
  forwardEuler: 1,
  symplecticEuler: 2,
  stiffSecond: 3,
});

export const Solver = enumeration({
  alternating: 0,
  coupled: 1,
  auto: 2,
});

export const MassRule = enumeration({
  equal: 0,
  halfEnds: 1,
});

export const Kernels = enumeration({
  plain: 0,
  avx2: 1,
  avx512: 2,
});

export const Node = enumeration({
  free: 0,
  pinned: 1,
  driven: 2,
  matched: 3,
  posed: 4,
});

export const Shape = enumeration({
  none: 0,
  plane: 1,
  capsule: 2,
  bed: 3,
  callback: 4,
});

export const Outside = enumeration({
  refused: 0,
  nearest: 1,
});

export const Field = enumeration({
  position: 0,
  velocity: 1,
  force: 2,
  mass: 3,
  stiffness: 4,
  bend: 5,
  pin: 6,
  target: 7,
  stiffnessU: 8,
  stiffnessV: 9,
  mask: 10,
  depth: 11,
  bed: 12,
  surface: 13,
  velocityX: 14,
  velocityY: 15,
  source: 16,
  pressure: 17,
  forceX: 18,
  forceY: 19,
  wallX: 20,
  wallY: 21,
  restLength: 22,
  tension: 23,
  wind: 24,
  strength: 25,
  strain: 26,
  restLengthU: 27,
  restLengthV: 28,
  tensionU: 29,
  tensionV: 30,
  strainU: 31,
  strainV: 32,
  breakingStrainU: 33,
  breakingStrainV: 34,
  restAngle: 35,
});

export const Kind = enumeration({
  chain: 1,
  membrane: 2,
  water: 3,
});

export const End = enumeration({
  first: 0,
  last: 1,
});

export const Edge = enumeration({
  uFirst: 0,
  uLast: 1,
  vFirst: 2,
  vLast: 3,
});

export const Side = enumeration({
  xFirst: 0,
  xLast: 1,
  yFirst: 2,
  yLast: 3,
});

export const Border = enumeration({
  wall: 0,
  open: 1,
  inflow: 2,
  periodic: 3,
  level: 4,
});

export const Momentum = enumeration({
  linear: 0,
  advected: 1,
});

export const BedRule = enumeration({
  liftsWater: 0,
  keepsSurface: 1,
});
knowStatuses(Status);

export function statusName(status) {
  return text(wasm.cd_status_name(member(Status, status, "status")));
}

export function errorMessage() {
  return text(wasm.cd_error_message());
}

export function savedShape(bytes) {
  begin();
  const bytesAt = putBytes(bytes, "bytes");
  const sizeOf = bytesAt.length;
  check(wasm.cd_saved_shape(bytesAt.address, sizeOf, result(0), result(1), result(2), result(3), result(4)));
  return {
    kind: nameOf(Kind, integer(0)),
    first: whole(1),
    second: whole(2),
    components: whole(3),
    precision: nameOf(Precision, integer(4)),
  };
}

export function runnableKernels() {
  return wasm.cd_runnable_kernels() >>> 0;
}

export function kernelsName(kernels) {
  return text(wasm.cd_kernels_name(member(Kernels, kernels, "kernels")));
}

export function version() {
  return wasm.cd_version() >>> 0;
}

export function versionString() {
  return text(wasm.cd_version_string());
}

export function buildInfo() {
  return text(wasm.cd_build_info());
}

export class Chain extends Handle {
  constructor(options) {
    const { strands, springs, components, precision = "float64" } = optionsOf(options, "Chain", ["strands", "springs",
      "components"]);
    check(wasm.cd_chain_create(size(strands, "strands"), size(springs, "springs"), size(components, "components"),
      member(Precision, precision, "precision"), 0, result(0)));
    super(wasm.cd_chain_destroy, components);
    assign(this, options, ["strands", "springs", "components", "precision"]);
    if (new.target === Chain) Object.preventExtensions(this); // a property that is misspelt throws
  }

  get shape() {
    check(wasm.cd_chain_get_shape(addressOf(this, Chain), result(0), result(1), result(2), result(3)));
    return {
      strands: whole(0),
      springs: whole(1),
      components: whole(2),
      precision: nameOf(Precision, integer(3)),
    };
  }

  get method() {
    check(wasm.cd_chain_get_method(addressOf(this, Chain), result(0)));
    return nameOf(Method, integer(0));
  }

  set method(method) {
    check(wasm.cd_chain_set_method(addressOf(this, Chain), member(Method, method, "method")));
  }

  get lambda() {
    check(wasm.cd_chain_get_lambda(addressOf(this, Chain), result(0)));
    return real(0);
  }

  set lambda(lambda) {
    check(wasm.cd_chain_set_lambda(addressOf(this, Chain), number(lambda, "lambda")));
  }

  get kernels() {
    check(wasm.cd_chain_get_kernels(addressOf(this, Chain), result(0)));
    return nameOf(Kernels, integer(0));
  }

  set kernels(kernels) {
    check(wasm.cd_chain_set_kernels(addressOf(this, Chain), member(Kernels, kernels, "kernels")));
  }

  get mass() {
    check(wasm.cd_chain_get_mass(addressOf(this, Chain), result(0)));
    return real(0);
  }

  set mass(mass) {
    check(wasm.cd_chain_set_mass(addressOf(this, Chain), number(mass, "mass")));
  }

  get massRule() {
    check(wasm.cd_chain_get_mass_rule(addressOf(this, Chain), result(0)));
    return nameOf(MassRule, integer(0));
  }

  set massRule(rule) {
    check(wasm.cd_chain_set_mass_rule(addressOf(this, Chain), member(MassRule, rule, "rule")));
  }

  get stiffness() {
    check(wasm.cd_chain_get_stiffness(addressOf(this, Chain), result(0)));
    return real(0);
  }

  set stiffness(stiffness) {
    check(wasm.cd_chain_set_stiffness(addressOf(this, Chain), number(stiffness, "stiffness")));
  }

  get bend() {
    check(wasm.cd_chain_get_bend(addressOf(this, Chain), result(0)));
    return real(0);
  }

  set bend(bend) {
    check(wasm.cd_chain_set_bend(addressOf(this, Chain), number(bend, "bend")));
  }

  get drag() {
    check(wasm.cd_chain_get_drag(addressOf(this, Chain), result(0)));
    return real(0);
  }

  set drag(drag) {
    check(wasm.cd_chain_set_drag(addressOf(this, Chain), number(drag, "drag")));
  }

  get stiffnessDamping() {
    check(wasm.cd_chain_get_stiffness_damping(addressOf(this, Chain), result(0)));
    return real(0);
  }

  set stiffnessDamping(seconds) {
    check(wasm.cd_chain_set_stiffness_damping(addressOf(this, Chain), number(seconds, "seconds")));
  }

  get gravity() {
    const address = addressOf(this, Chain);
    begin();
    const countOf = componentsOf(this);
    const gravityAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_chain_get_gravity(address, gravityAt, countOf));
    return got(gravityAt, Float64Array, countOf);
  }

  set gravity(gravity) {
    const address = addressOf(this, Chain);
    begin();
    const gravityAt = put(gravity, Float64Array, "gravity");
    const countOf = gravityAt.length;
    check(wasm.cd_chain_set_gravity(address, gravityAt.address, countOf));
  }

  setEnd(end, kind) {
    check(wasm.cd_chain_set_end(addressOf(this, Chain), member(End, end, "end"), member(Node, kind, "kind")));
  }

  getEnd(end) {
    check(wasm.cd_chain_get_end(addressOf(this, Chain), member(End, end, "end"), result(0)));
    return nameOf(Node, integer(0));
  }

  get ring() {
    check(wasm.cd_chain_get_ring(addressOf(this, Chain), result(0)));
    return integer(0) !== 0;
  }

  set ring(ring) {
    check(wasm.cd_chain_set_ring(addressOf(this, Chain), flag(ring, "ring")));
  }

  get sleep() {
    check(wasm.cd_chain_get_sleep(addressOf(this, Chain), result(0), result(1)));
    return {
      speed: real(0),
      seconds: real(1),
    };
  }

  set sleep(numbers) {
    const { speed, seconds } = several(numbers, () => this.sleep, "sleep", ["speed", "seconds"]);
    check(wasm.cd_chain_set_sleep(addressOf(this, Chain), number(speed, "speed"), number(seconds, "seconds")));
  }

  get awake() {
    check(wasm.cd_chain_get_awake(addressOf(this, Chain), result(0)));
    return whole(0);
  }

  get restLength() {
    check(wasm.cd_chain_get_rest_length(addressOf(this, Chain), result(0)));
    return real(0);
  }

  set restLength(length) {
    check(wasm.cd_chain_set_rest_length(addressOf(this, Chain), number(length, "length")));
  }

  get restAngle() {
    check(wasm.cd_chain_get_rest_angle(addressOf(this, Chain), result(0)));
    return real(0);
  }

  set restAngle(angle) {
    check(wasm.cd_chain_set_rest_angle(addressOf(this, Chain), number(angle, "angle")));
  }

  get push() {
    check(wasm.cd_chain_get_push(addressOf(this, Chain), result(0)));
    return integer(0) !== 0;
  }

  set push(push) {
    check(wasm.cd_chain_set_push(addressOf(this, Chain), flag(push, "push")));
  }

  get strength() {
    check(wasm.cd_chain_get_strength(addressOf(this, Chain), result(0)));
    return real(0);
  }

  set strength(strength) {
    check(wasm.cd_chain_set_strength(addressOf(this, Chain), number(strength, "strength")));
  }

  get broken() {
    check(wasm.cd_chain_get_broken(addressOf(this, Chain), result(0)));
    return whole(0);
  }

  getReaction(strand, node) {
    const address = addressOf(this, Chain);
    begin();
    const countOf = componentsOf(this);
    const forceAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_chain_get_reaction(address, size(strand, "strand"), size(node, "node"), forceAt, countOf));
    return got(forceAt, Float64Array, countOf);
  }

  get air() {
    check(wasm.cd_chain_get_air(addressOf(this, Chain), result(0), result(1)));
    return {
      along: real(0),
      across: real(1),
    };
  }

  set air(numbers) {
    const { along, across } = several(numbers, () => this.air, "air", ["along", "across"]);
    check(wasm.cd_chain_set_air(addressOf(this, Chain), number(along, "along"), number(across, "across")));
  }

  get wind() {
    const address = addressOf(this, Chain);
    begin();
    const countOf = componentsOf(this);
    const velocityAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_chain_get_wind(address, velocityAt, countOf));
    return got(velocityAt, Float64Array, countOf);
  }

  set wind(velocity) {
    const address = addressOf(this, Chain);
    begin();
    const velocityAt = put(velocity, Float64Array, "velocity");
    const countOf = velocityAt.length;
    check(wasm.cd_chain_set_wind(address, velocityAt.address, countOf));
  }

  get tolerance() {
    check(wasm.cd_chain_get_tolerance(addressOf(this, Chain), result(0), result(1)));
    return {
      tolerance: real(0),
      mostIterations: whole(1),
    };
  }

  set tolerance(numbers) {
    const { tolerance, mostIterations } = several(numbers, () => this.tolerance, "tolerance", ["tolerance",
      "mostIterations"]);
    check(wasm.cd_chain_set_tolerance(addressOf(this, Chain), number(tolerance, "tolerance"), size(mostIterations,
      "mostIterations")));
  }

  get convergence() {
    check(wasm.cd_chain_get_convergence(addressOf(this, Chain), result(0), result(1)));
    return {
      iterations: whole(0),
      residual: real(1),
    };
  }

  get colliders() {
    check(wasm.cd_chain_get_colliders(addressOf(this, Chain), result(0)));
    return whole(0);
  }

  set colliders(count) {
    check(wasm.cd_chain_set_colliders(addressOf(this, Chain), size(count, "count")));
  }

  setPlane(index, point, normal, friction = 0) {
    const address = addressOf(this, Chain);
    begin();
    const pointAt = put(point, Float64Array, "point");
    const normalAt = put(normal, Float64Array, "normal");
    expect(normalAt, pointAt.length, "normal");
    const countOf = pointAt.length;
    check(wasm.cd_chain_set_plane(address, size(index, "index"), pointAt.address, normalAt.address, countOf,
      number(friction, "friction")));
  }

  setCapsule(index, first, last, radius, friction = 0) {
    const address = addressOf(this, Chain);
    begin();
    const firstAt = put(first, Float64Array, "first");
    const lastAt = put(last, Float64Array, "last");
    expect(lastAt, firstAt.length, "last");
    const countOf = firstAt.length;
    check(wasm.cd_chain_set_capsule(address, size(index, "index"), firstAt.address, lastAt.address, countOf,
      number(radius, "radius"), number(friction, "friction")));
  }

  setBed(index, origin, columns, rows, columnSpacing, rowSpacing, heights, friction) {
    const address = addressOf(this, Chain);
    begin();
    const originAt = put(origin, Float64Array, "origin");
    const heightsAt = put(heights, Float64Array, "heights");
    const countOf = originAt.length;
    const heightCountOf = heightsAt.length;
    check(wasm.cd_chain_set_bed(address, size(index, "index"), originAt.address, countOf, size(columns, "columns"),
      size(rows, "rows"), number(columnSpacing, "columnSpacing"), number(rowSpacing, "rowSpacing"), heightsAt.address,
      heightCountOf, number(friction, "friction")));
  }

  getBed(index, heightCount = 0) {
    const address = addressOf(this, Chain);
    begin();
    const heightCountOf = size(heightCount, "heightCount");
    const heightsAt = heightCountOf === 0 ? 0 : take(Float64Array.BYTES_PER_ELEMENT * heightCountOf);
    check(wasm.cd_chain_get_bed(address, size(index, "index"), result(0), result(1), heightsAt, heightCountOf));
    return {
      columns: whole(0),
      rows: whole(1),
      heights: got(heightsAt, Float64Array, heightCountOf),
    };
  }

  removeCollider(index) {
    check(wasm.cd_chain_remove_collider(addressOf(this, Chain), size(index, "index")));
  }

  setColliderVelocity(index, velocity) {
    const address = addressOf(this, Chain);
    begin();
    const velocityAt = put(velocity, Float64Array, "velocity");
    const countOf = velocityAt.length;
    check(wasm.cd_chain_set_collider_velocity(address, size(index, "index"), velocityAt.address, countOf));
  }

  getCollider(index) {
    const address = addressOf(this, Chain);
    begin();
    const countOf = componentsOf(this);
    const firstAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    const secondAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    const velocityAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_chain_get_collider(address, size(index, "index"), result(0), firstAt, secondAt, velocityAt, countOf,
      result(1), result(2)));
    return {
      shape: nameOf(Shape, integer(0)),
      first: got(firstAt, Float64Array, countOf),
      second: got(secondAt, Float64Array, countOf),
      velocity: got(velocityAt, Float64Array, countOf),
      radius: real(1),
      friction: real(2),
    };
  }

  get loads() {
    check(wasm.cd_chain_get_loads(addressOf(this, Chain), result(0)));
    return integer(0) !== 0;
  }

  set loads(loads) {
    check(wasm.cd_chain_set_loads(addressOf(this, Chain), flag(loads, "loads")));
  }

  getColliderLoad(index) {
    const address = addressOf(this, Chain);
    begin();
    const countOf = 6;
    const loadAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_chain_get_collider_load(address, size(index, "index"), loadAt, countOf));
    return got(loadAt, Float64Array, countOf);
  }

  get thickness() {
    check(wasm.cd_chain_get_thickness(addressOf(this, Chain), result(0)));
    return real(0);
  }

  set thickness(radius) {
    check(wasm.cd_chain_set_thickness(addressOf(this, Chain), number(radius, "radius")));
  }

  enableField(field) {
    check(wasm.cd_chain_enable_field(addressOf(this, Chain), member(Field, field, "field")));
  }

  disableField(field) {
    check(wasm.cd_chain_disable_field(addressOf(this, Chain), member(Field, field, "field")));
  }

  write(field, values, range) {
    writeField(this, kChain, field, values, range);
  }

  read(field, range, out) {
    return readField(this, kChain, field, range, out);
  }

  view(field) {
    return viewField(this, kChain, field);
  }

  get position() {
    return viewField(this, kChain, "position");
  }

  set position(values) {
    writeField(this, kChain, "position", values);
  }

  get velocity() {
    return viewField(this, kChain, "velocity");
  }

  set velocity(values) {
    writeField(this, kChain, "velocity", values);
  }

  get force() {
    return viewField(this, kChain, "force");
  }

  set force(values) {
    writeField(this, kChain, "force", values);
  }

  get target() {
    return viewField(this, kChain, "target");
  }

  set target(values) {
    writeField(this, kChain, "target", values);
  }

  impulse(strand, node, impulse) {
    const address = addressOf(this, Chain);
    begin();
    const impulseAt = put(impulse, Float64Array, "impulse");
    const countOf = impulseAt.length;
    check(wasm.cd_chain_impulse(address, size(strand, "strand"), size(node, "node"), impulseAt.address, countOf));
  }

  teleport(strand, rotation, offset) {
    const address = addressOf(this, Chain);
    begin();
    const rotationAt = put(rotation, Float64Array, "rotation", true);
    const offsetAt = put(offset, Float64Array, "offset");
    expect(rotationAt, offsetAt.length * offsetAt.length, "rotation");
    const countOf = offsetAt.length;
    check(wasm.cd_chain_teleport(address, size(strand, "strand"), rotationAt.address, offsetAt.address, countOf));
  }

  attach(strand, node, stiffness, damping, target = null) {
    const address = addressOf(this, Chain);
    begin();
    const targetAt = put(target, Float64Array, "target", true);
    const countOf = targetAt.length;
    check(wasm.cd_chain_attach(address, size(strand, "strand"), size(node, "node"), number(stiffness, "stiffness"),
      number(damping, "damping"), targetAt.address, countOf));
  }

  detach(strand, node) {
    check(wasm.cd_chain_detach(addressOf(this, Chain), size(strand, "strand"), size(node, "node")));
  }

  getAttachment(strand, node) {
    check(wasm.cd_chain_get_attachment(addressOf(this, Chain), size(strand, "strand"), size(node, "node"), result(0),
      result(1)));
    return {
      stiffness: real(0),
      damping: real(1),
    };
  }

  cut(strand, spring) {
    check(wasm.cd_chain_cut(addressOf(this, Chain), size(strand, "strand"), size(spring, "spring")));
  }

  weld(strand, spring) {
    check(wasm.cd_chain_weld(addressOf(this, Chain), size(strand, "strand"), size(spring, "spring")));
  }

  step(dt, count = 1) {
    check(wasm.cd_chain_step(addressOf(this, Chain), number(dt, "dt"), size(count, "count")));
  }

  stableDt() {
    check(wasm.cd_chain_stable_dt(addressOf(this, Chain), result(0)));
    return real(0);
  }

  get time() {
    check(wasm.cd_chain_get_time(addressOf(this, Chain), result(0)));
    return real(0);
  }

  get steps() {
    check(wasm.cd_chain_get_steps(addressOf(this, Chain), result(0)));
    return count(0);
  }

  get factorizations() {
    check(wasm.cd_chain_get_factorizations(addressOf(this, Chain), result(0)));
    return count(0);
  }

  get energy() {
    check(wasm.cd_chain_get_energy(addressOf(this, Chain), result(0), result(1), result(2)));
    return {
      kinetic: real(0),
      elastic: real(1),
      gravity: real(2),
    };
  }

  get momentum() {
    const address = addressOf(this, Chain);
    begin();
    const countOf = componentsOf(this);
    const momentumAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_chain_get_momentum(address, momentumAt, countOf));
    return got(momentumAt, Float64Array, countOf);
  }

  sample(strand, at, outside = "refused") {
    const address = addressOf(this, Chain);
    begin();
    const atAt = put(at, Float64Array, "at");
    const nOf = atAt.length;
    const outCountOf = nOf * componentsOf(this);
    const positionsAt = take(Float64Array.BYTES_PER_ELEMENT * outCountOf);
    check(wasm.cd_chain_sample(address, size(strand, "strand"), atAt.address, nOf, member(Outside, outside, "outside"),
      positionsAt, outCountOf));
    return got(positionsAt, Float64Array, outCountOf);
  }

  get memory() {
    check(wasm.cd_chain_get_memory(addressOf(this, Chain), result(0)));
    return whole(0);
  }

  hash() {
    check(wasm.cd_chain_hash(addressOf(this, Chain), result(0)));
    return bits(0);
  }

  saveSize() {
    check(wasm.cd_chain_save_size(addressOf(this, Chain), result(0)));
    return whole(0);
  }

  save() {
    const size = this.saveSize();
    begin();
    const at = take(size);
    check(wasm.cd_chain_save(addressOf(this, Chain), at, size, result(0)));
    return got(at, Uint8Array, whole(0));
  }

  load(bytes) {
    const address = addressOf(this, Chain);
    begin();
    const bytesAt = putBytes(bytes, "bytes");
    const sizeOf = bytesAt.length;
    check(wasm.cd_chain_load(address, bytesAt.address, sizeOf));
  }

  copyState(source) {
    check(wasm.cd_chain_copy_state(addressOf(this, Chain), addressOf(source, Chain, "source")));
  }

  reset() {
    check(wasm.cd_chain_reset(addressOf(this, Chain)));
  }
}

const kChain = {
  name: "chain",
  Class: Chain,
  Field,
  range: ["firstStrand", "strands", "first", "n"],
  reversed: false,
  fields: {
    __proto__: null,
    position: { per: ["strand", "node"], components: true },
    velocity: { per: ["strand", "node"], components: true },
    force: { per: ["strand", "node"], components: true },
    target: { per: ["strand", "node"], components: true },
    mass: { per: ["strand", "node"], ownInRopes: true },
    stiffness: { per: ["strand", "spring"], ownInRopes: true },
    bend: { per: ["strand", "node"], ownInRopes: true },
    pin: { per: ["strand", "node"], ownInRopes: true },
    restLength: { per: ["strand", "spring"] },
    tension: { per: ["strand", "spring"] },
    wind: { per: ["strand", "node"], components: true },
    strength: { per: ["strand", "spring"] },
    restAngle: { per: ["strand", "node"] },
    strain: { per: ["strand", "spring"] },
  },
};

export class Membrane extends Handle {
  constructor(options) {
    const { nu, nv, components, precision = "float64" } = optionsOf(options, "Membrane", ["nu", "nv", "components"]);
    check(wasm.cd_membrane_create(size(nu, "nu"), size(nv, "nv"), size(components, "components"), member(Precision,
      precision, "precision"), 0, result(0)));
    super(wasm.cd_membrane_destroy, components);
    assign(this, options, ["nu", "nv", "components", "precision"]);
    if (new.target === Membrane) Object.preventExtensions(this); // a property that is misspelt throws
  }

  get shape() {
    check(wasm.cd_membrane_get_shape(addressOf(this, Membrane), result(0), result(1), result(2), result(3)));
    return {
      nu: whole(0),
      nv: whole(1),
      components: whole(2),
      precision: nameOf(Precision, integer(3)),
    };
  }

  get method() {
    check(wasm.cd_membrane_get_method(addressOf(this, Membrane), result(0)));
    return nameOf(Method, integer(0));
  }

  set method(method) {
    check(wasm.cd_membrane_set_method(addressOf(this, Membrane), member(Method, method, "method")));
  }

  get lambda() {
    check(wasm.cd_membrane_get_lambda(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  set lambda(lambda) {
    check(wasm.cd_membrane_set_lambda(addressOf(this, Membrane), number(lambda, "lambda")));
  }

  get solver() {
    check(wasm.cd_membrane_get_solver(addressOf(this, Membrane), result(0)));
    return nameOf(Solver, integer(0));
  }

  set solver(solver) {
    check(wasm.cd_membrane_set_solver(addressOf(this, Membrane), member(Solver, solver, "solver")));
  }

  get solverTaken() {
    check(wasm.cd_membrane_get_solver_taken(addressOf(this, Membrane), result(0)));
    return nameOf(Solver, integer(0));
  }

  get tolerance() {
    check(wasm.cd_membrane_get_tolerance(addressOf(this, Membrane), result(0), result(1)));
    return {
      tolerance: real(0),
      mostIterations: whole(1),
    };
  }

  set tolerance(numbers) {
    const { tolerance, mostIterations } = several(numbers, () => this.tolerance, "tolerance", ["tolerance",
      "mostIterations"]);
    check(wasm.cd_membrane_set_tolerance(addressOf(this, Membrane), number(tolerance, "tolerance"), size(mostIterations,
      "mostIterations")));
  }

  get convergence() {
    check(wasm.cd_membrane_get_convergence(addressOf(this, Membrane), result(0), result(1)));
    return {
      iterations: whole(0),
      residual: real(1),
    };
  }

  get kernels() {
    check(wasm.cd_membrane_get_kernels(addressOf(this, Membrane), result(0)));
    return nameOf(Kernels, integer(0));
  }

  set kernels(kernels) {
    check(wasm.cd_membrane_set_kernels(addressOf(this, Membrane), member(Kernels, kernels, "kernels")));
  }

  get mass() {
    check(wasm.cd_membrane_get_mass(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  set mass(mass) {
    check(wasm.cd_membrane_set_mass(addressOf(this, Membrane), number(mass, "mass")));
  }

  get massRule() {
    check(wasm.cd_membrane_get_mass_rule(addressOf(this, Membrane), result(0)));
    return nameOf(MassRule, integer(0));
  }

  set massRule(rule) {
    check(wasm.cd_membrane_set_mass_rule(addressOf(this, Membrane), member(MassRule, rule, "rule")));
  }

  get stiffness() {
    check(wasm.cd_membrane_get_stiffness(addressOf(this, Membrane), result(0), result(1)));
    return {
      alongU: real(0),
      alongV: real(1),
    };
  }

  set stiffness(numbers) {
    const { alongU, alongV } = several(numbers, () => this.stiffness, "stiffness", ["alongU", "alongV"]);
    check(wasm.cd_membrane_set_stiffness(addressOf(this, Membrane), number(alongU, "alongU"), number(alongV,
      "alongV")));
  }

  get bend() {
    check(wasm.cd_membrane_get_bend(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  set bend(bend) {
    check(wasm.cd_membrane_set_bend(addressOf(this, Membrane), number(bend, "bend")));
  }

  get drag() {
    check(wasm.cd_membrane_get_drag(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  set drag(drag) {
    check(wasm.cd_membrane_set_drag(addressOf(this, Membrane), number(drag, "drag")));
  }

  get stiffnessDamping() {
    check(wasm.cd_membrane_get_stiffness_damping(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  set stiffnessDamping(seconds) {
    check(wasm.cd_membrane_set_stiffness_damping(addressOf(this, Membrane), number(seconds, "seconds")));
  }

  get gravity() {
    const address = addressOf(this, Membrane);
    begin();
    const countOf = componentsOf(this);
    const gravityAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_membrane_get_gravity(address, gravityAt, countOf));
    return got(gravityAt, Float64Array, countOf);
  }

  set gravity(gravity) {
    const address = addressOf(this, Membrane);
    begin();
    const gravityAt = put(gravity, Float64Array, "gravity");
    const countOf = gravityAt.length;
    check(wasm.cd_membrane_set_gravity(address, gravityAt.address, countOf));
  }

  get pressure() {
    check(wasm.cd_membrane_get_pressure(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  set pressure(pressure) {
    check(wasm.cd_membrane_set_pressure(addressOf(this, Membrane), number(pressure, "pressure")));
  }

  setEdge(edge, kind) {
    check(wasm.cd_membrane_set_edge(addressOf(this, Membrane), member(Edge, edge, "edge"), member(Node, kind, "kind")));
  }

  getEdge(edge) {
    check(wasm.cd_membrane_get_edge(addressOf(this, Membrane), member(Edge, edge, "edge"), result(0)));
    return nameOf(Node, integer(0));
  }

  get ring() {
    check(wasm.cd_membrane_get_ring(addressOf(this, Membrane), result(0), result(1)));
    return {
      alongU: integer(0) !== 0,
      alongV: integer(1) !== 0,
    };
  }

  set ring(numbers) {
    const { alongU, alongV } = several(numbers, () => this.ring, "ring", ["alongU", "alongV"]);
    check(wasm.cd_membrane_set_ring(addressOf(this, Membrane), flag(alongU, "alongU"), flag(alongV, "alongV")));
  }

  get sleep() {
    check(wasm.cd_membrane_get_sleep(addressOf(this, Membrane), result(0), result(1)));
    return {
      speed: real(0),
      seconds: real(1),
    };
  }

  set sleep(numbers) {
    const { speed, seconds } = several(numbers, () => this.sleep, "sleep", ["speed", "seconds"]);
    check(wasm.cd_membrane_set_sleep(addressOf(this, Membrane), number(speed, "speed"), number(seconds, "seconds")));
  }

  get awake() {
    check(wasm.cd_membrane_get_awake(addressOf(this, Membrane), result(0)));
    return whole(0);
  }

  get restLength() {
    check(wasm.cd_membrane_get_rest_length(addressOf(this, Membrane), result(0), result(1)));
    return {
      alongU: real(0),
      alongV: real(1),
    };
  }

  set restLength(numbers) {
    const { alongU, alongV } = several(numbers, () => this.restLength, "restLength", ["alongU", "alongV"]);
    check(wasm.cd_membrane_set_rest_length(addressOf(this, Membrane), number(alongU, "alongU"), number(alongV,
      "alongV")));
  }

  get shear() {
    check(wasm.cd_membrane_get_shear(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  set shear(stiffness) {
    check(wasm.cd_membrane_set_shear(addressOf(this, Membrane), number(stiffness, "stiffness")));
  }

  get compression() {
    check(wasm.cd_membrane_get_compression(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  set compression(rate) {
    check(wasm.cd_membrane_set_compression(addressOf(this, Membrane), number(rate, "rate")));
  }

  get breakingStrain() {
    check(wasm.cd_membrane_get_breaking_strain(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  set breakingStrain(strain) {
    check(wasm.cd_membrane_set_breaking_strain(addressOf(this, Membrane), number(strain, "strain")));
  }

  get broken() {
    check(wasm.cd_membrane_get_broken(addressOf(this, Membrane), result(0)));
    return whole(0);
  }

  get effort() {
    check(wasm.cd_membrane_get_effort(addressOf(this, Membrane), result(0), result(1)));
    return {
      newton: whole(0),
      gradient: whole(1),
    };
  }

  set effort(numbers) {
    const { newton, gradient } = several(numbers, () => this.effort, "effort", ["newton", "gradient"]);
    check(wasm.cd_membrane_set_effort(addressOf(this, Membrane), size(newton, "newton"), size(gradient, "gradient")));
  }

  get air() {
    check(wasm.cd_membrane_get_air(addressOf(this, Membrane), result(0), result(1)));
    return {
      along: real(0),
      across: real(1),
    };
  }

  set air(numbers) {
    const { along, across } = several(numbers, () => this.air, "air", ["along", "across"]);
    check(wasm.cd_membrane_set_air(addressOf(this, Membrane), number(along, "along"), number(across, "across")));
  }

  get wind() {
    const address = addressOf(this, Membrane);
    begin();
    const countOf = componentsOf(this);
    const velocityAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_membrane_get_wind(address, velocityAt, countOf));
    return got(velocityAt, Float64Array, countOf);
  }

  set wind(velocity) {
    const address = addressOf(this, Membrane);
    begin();
    const velocityAt = put(velocity, Float64Array, "velocity");
    const countOf = velocityAt.length;
    check(wasm.cd_membrane_set_wind(address, velocityAt.address, countOf));
  }

  get colliders() {
    check(wasm.cd_membrane_get_colliders(addressOf(this, Membrane), result(0)));
    return whole(0);
  }

  set colliders(count) {
    check(wasm.cd_membrane_set_colliders(addressOf(this, Membrane), size(count, "count")));
  }

  setPlane(index, point, normal, friction = 0) {
    const address = addressOf(this, Membrane);
    begin();
    const pointAt = put(point, Float64Array, "point");
    const normalAt = put(normal, Float64Array, "normal");
    expect(normalAt, pointAt.length, "normal");
    const countOf = pointAt.length;
    check(wasm.cd_membrane_set_plane(address, size(index, "index"), pointAt.address, normalAt.address, countOf,
      number(friction, "friction")));
  }

  setCapsule(index, first, last, radius, friction = 0) {
    const address = addressOf(this, Membrane);
    begin();
    const firstAt = put(first, Float64Array, "first");
    const lastAt = put(last, Float64Array, "last");
    expect(lastAt, firstAt.length, "last");
    const countOf = firstAt.length;
    check(wasm.cd_membrane_set_capsule(address, size(index, "index"), firstAt.address, lastAt.address, countOf,
      number(radius, "radius"), number(friction, "friction")));
  }

  setBed(index, origin, columns, rows, columnSpacing, rowSpacing, heights, friction) {
    const address = addressOf(this, Membrane);
    begin();
    const originAt = put(origin, Float64Array, "origin");
    const heightsAt = put(heights, Float64Array, "heights");
    const countOf = originAt.length;
    const heightCountOf = heightsAt.length;
    check(wasm.cd_membrane_set_bed(address, size(index, "index"), originAt.address, countOf, size(columns, "columns"),
      size(rows, "rows"), number(columnSpacing, "columnSpacing"), number(rowSpacing, "rowSpacing"), heightsAt.address,
      heightCountOf, number(friction, "friction")));
  }

  getBed(index, heightCount = 0) {
    const address = addressOf(this, Membrane);
    begin();
    const heightCountOf = size(heightCount, "heightCount");
    const heightsAt = heightCountOf === 0 ? 0 : take(Float64Array.BYTES_PER_ELEMENT * heightCountOf);
    check(wasm.cd_membrane_get_bed(address, size(index, "index"), result(0), result(1), heightsAt, heightCountOf));
    return {
      columns: whole(0),
      rows: whole(1),
      heights: got(heightsAt, Float64Array, heightCountOf),
    };
  }

  removeCollider(index) {
    check(wasm.cd_membrane_remove_collider(addressOf(this, Membrane), size(index, "index")));
  }

  setColliderVelocity(index, velocity) {
    const address = addressOf(this, Membrane);
    begin();
    const velocityAt = put(velocity, Float64Array, "velocity");
    const countOf = velocityAt.length;
    check(wasm.cd_membrane_set_collider_velocity(address, size(index, "index"), velocityAt.address, countOf));
  }

  getCollider(index) {
    const address = addressOf(this, Membrane);
    begin();
    const countOf = componentsOf(this);
    const firstAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    const secondAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    const velocityAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_membrane_get_collider(address, size(index, "index"), result(0), firstAt, secondAt, velocityAt,
      countOf, result(1), result(2)));
    return {
      shape: nameOf(Shape, integer(0)),
      first: got(firstAt, Float64Array, countOf),
      second: got(secondAt, Float64Array, countOf),
      velocity: got(velocityAt, Float64Array, countOf),
      radius: real(1),
      friction: real(2),
    };
  }

  get loads() {
    check(wasm.cd_membrane_get_loads(addressOf(this, Membrane), result(0)));
    return integer(0) !== 0;
  }

  set loads(loads) {
    check(wasm.cd_membrane_set_loads(addressOf(this, Membrane), flag(loads, "loads")));
  }

  getColliderLoad(index) {
    const address = addressOf(this, Membrane);
    begin();
    const countOf = 6;
    const loadAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_membrane_get_collider_load(address, size(index, "index"), loadAt, countOf));
    return got(loadAt, Float64Array, countOf);
  }

  get thickness() {
    check(wasm.cd_membrane_get_thickness(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  set thickness(distance) {
    check(wasm.cd_membrane_set_thickness(addressOf(this, Membrane), number(distance, "distance")));
  }

  enableField(field) {
    check(wasm.cd_membrane_enable_field(addressOf(this, Membrane), member(Field, field, "field")));
  }

  disableField(field) {
    check(wasm.cd_membrane_disable_field(addressOf(this, Membrane), member(Field, field, "field")));
  }

  write(field, values, range) {
    writeField(this, kMembrane, field, values, range);
  }

  read(field, range, out) {
    return readField(this, kMembrane, field, range, out);
  }

  view(field) {
    return viewField(this, kMembrane, field);
  }

  get position() {
    return viewField(this, kMembrane, "position");
  }

  set position(values) {
    writeField(this, kMembrane, "position", values);
  }

  get velocity() {
    return viewField(this, kMembrane, "velocity");
  }

  set velocity(values) {
    writeField(this, kMembrane, "velocity", values);
  }

  get force() {
    return viewField(this, kMembrane, "force");
  }

  set force(values) {
    writeField(this, kMembrane, "force", values);
  }

  get target() {
    return viewField(this, kMembrane, "target");
  }

  set target(values) {
    writeField(this, kMembrane, "target", values);
  }

  impulse(u, v, radius, impulse) {
    const address = addressOf(this, Membrane);
    begin();
    const impulseAt = put(impulse, Float64Array, "impulse");
    const countOf = impulseAt.length;
    check(wasm.cd_membrane_impulse(address, number(u, "u"), number(v, "v"), number(radius, "radius"), impulseAt.address,
      countOf));
  }

  teleport(rotation, offset) {
    const address = addressOf(this, Membrane);
    begin();
    const rotationAt = put(rotation, Float64Array, "rotation", true);
    const offsetAt = put(offset, Float64Array, "offset");
    expect(rotationAt, offsetAt.length * offsetAt.length, "rotation");
    const countOf = offsetAt.length;
    check(wasm.cd_membrane_teleport(address, rotationAt.address, offsetAt.address, countOf));
  }

  attach(u, v, stiffness, damping, target = null) {
    const address = addressOf(this, Membrane);
    begin();
    const targetAt = put(target, Float64Array, "target", true);
    const countOf = targetAt.length;
    check(wasm.cd_membrane_attach(address, size(u, "u"), size(v, "v"), number(stiffness, "stiffness"), number(damping,
      "damping"), targetAt.address, countOf));
  }

  detach(u, v) {
    check(wasm.cd_membrane_detach(addressOf(this, Membrane), size(u, "u"), size(v, "v")));
  }

  getAttachment(u, v) {
    check(wasm.cd_membrane_get_attachment(addressOf(this, Membrane), size(u, "u"), size(v, "v"), result(0), result(1)));
    return {
      stiffness: real(0),
      damping: real(1),
    };
  }

  step(dt, count = 1) {
    check(wasm.cd_membrane_step(addressOf(this, Membrane), number(dt, "dt"), size(count, "count")));
  }

  stableDt() {
    check(wasm.cd_membrane_stable_dt(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  get time() {
    check(wasm.cd_membrane_get_time(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  get steps() {
    check(wasm.cd_membrane_get_steps(addressOf(this, Membrane), result(0)));
    return count(0);
  }

  get factorizations() {
    check(wasm.cd_membrane_get_factorizations(addressOf(this, Membrane), result(0)));
    return count(0);
  }

  get energy() {
    check(wasm.cd_membrane_get_energy(addressOf(this, Membrane), result(0), result(1), result(2)));
    return {
      kinetic: real(0),
      elastic: real(1),
      gravity: real(2),
    };
  }

  get momentum() {
    const address = addressOf(this, Membrane);
    begin();
    const countOf = componentsOf(this);
    const momentumAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_membrane_get_momentum(address, momentumAt, countOf));
    return got(momentumAt, Float64Array, countOf);
  }

  getReaction(u, v) {
    const address = addressOf(this, Membrane);
    begin();
    const countOf = componentsOf(this);
    const forceAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_membrane_get_reaction(address, size(u, "u"), size(v, "v"), forceAt, countOf));
    return got(forceAt, Float64Array, countOf);
  }

  get volume() {
    check(wasm.cd_membrane_get_volume(addressOf(this, Membrane), result(0)));
    return real(0);
  }

  sample(at, outside = "refused") {
    const address = addressOf(this, Membrane);
    begin();
    const atAt = put(at, Float64Array, "at");
    const nOf = items(atAt, 2, "at");
    const outCountOf = nOf * componentsOf(this);
    const positionsAt = take(Float64Array.BYTES_PER_ELEMENT * outCountOf);
    check(wasm.cd_membrane_sample(address, atAt.address, nOf, member(Outside, outside, "outside"), positionsAt,
      outCountOf));
    return got(positionsAt, Float64Array, outCountOf);
  }

  get memory() {
    check(wasm.cd_membrane_get_memory(addressOf(this, Membrane), result(0)));
    return whole(0);
  }

  hash() {
    check(wasm.cd_membrane_hash(addressOf(this, Membrane), result(0)));
    return bits(0);
  }

  writeVertices(buffer, stride, positionOffset, normalOffset) {
    const address = addressOf(this, Membrane);
    begin();
    const bufferAt = putBytes(buffer, "buffer");
    const sizeOf = bufferAt.length;
    check(wasm.cd_membrane_write_vertices(address, bufferAt.address, sizeOf, size(stride, "stride"),
      size(positionOffset, "positionOffset"), sizeOrNone(normalOffset, "normalOffset")));
    getBytes(buffer, bufferAt);
  }

  get indexCount() {
    check(wasm.cd_membrane_get_index_count(addressOf(this, Membrane), result(0)));
    return whole(0);
  }

  writeIndices(buffer, indexSize) {
    const address = addressOf(this, Membrane);
    begin();
    const bufferAt = putBytes(buffer, "buffer");
    const sizeOf = bufferAt.length;
    check(wasm.cd_membrane_write_indices(address, bufferAt.address, sizeOf, size(indexSize, "indexSize")));
    getBytes(buffer, bufferAt);
  }

  saveSize() {
    check(wasm.cd_membrane_save_size(addressOf(this, Membrane), result(0)));
    return whole(0);
  }

  save() {
    const size = this.saveSize();
    begin();
    const at = take(size);
    check(wasm.cd_membrane_save(addressOf(this, Membrane), at, size, result(0)));
    return got(at, Uint8Array, whole(0));
  }

  load(bytes) {
    const address = addressOf(this, Membrane);
    begin();
    const bytesAt = putBytes(bytes, "bytes");
    const sizeOf = bytesAt.length;
    check(wasm.cd_membrane_load(address, bytesAt.address, sizeOf));
  }

  copyState(source) {
    check(wasm.cd_membrane_copy_state(addressOf(this, Membrane), addressOf(source, Membrane, "source")));
  }

  reset() {
    check(wasm.cd_membrane_reset(addressOf(this, Membrane)));
  }
}

const kMembrane = {
  name: "membrane",
  Class: Membrane,
  Field,
  range: ["firstU", "firstV", "nU", "nV"],
  reversed: true,
  fields: {
    __proto__: null,
    position: { per: ["node"], components: true },
    velocity: { per: ["node"], components: true },
    force: { per: ["node"], components: true },
    target: { per: ["node"], components: true },
    mass: { per: ["node"] },
    stiffnessU: { per: ["spring"] },
    stiffnessV: { per: ["spring"] },
    pin: { per: ["node"] },
    mask: { per: ["node"] },
    restLengthU: { per: ["spring"] },
    restLengthV: { per: ["spring"] },
    breakingStrainU: { per: ["spring"] },
    breakingStrainV: { per: ["spring"] },
    wind: { per: ["node"], components: true },
    tensionU: { per: ["spring"] },
    tensionV: { per: ["spring"] },
    strainU: { per: ["spring"] },
    strainV: { per: ["spring"] },
  },
};

export class Water extends Handle {
  constructor(options) {
    const { nx, ny, dx, dy, precision = "float64" } = optionsOf(options, "Water", ["nx", "ny", "dx", "dy"]);
    check(wasm.cd_water_create(size(nx, "nx"), size(ny, "ny"), number(dx, "dx"), number(dy, "dy"), member(Precision,
      precision, "precision"), 0, result(0)));
    super(wasm.cd_water_destroy, 1);
    assign(this, options, ["nx", "ny", "dx", "dy", "precision"]);
    if (new.target === Water) Object.preventExtensions(this); // a property that is misspelt throws
  }

  get shape() {
    check(wasm.cd_water_get_shape(addressOf(this, Water), result(0), result(1), result(2), result(3), result(4)));
    return {
      nx: whole(0),
      ny: whole(1),
      dx: real(2),
      dy: real(3),
      precision: nameOf(Precision, integer(4)),
    };
  }

  get method() {
    check(wasm.cd_water_get_method(addressOf(this, Water), result(0)));
    return nameOf(Method, integer(0));
  }

  set method(method) {
    check(wasm.cd_water_set_method(addressOf(this, Water), member(Method, method, "method")));
  }

  get lambda() {
    check(wasm.cd_water_get_lambda(addressOf(this, Water), result(0)));
    return real(0);
  }

  set lambda(lambda) {
    check(wasm.cd_water_set_lambda(addressOf(this, Water), number(lambda, "lambda")));
  }

  get momentum() {
    check(wasm.cd_water_get_momentum(addressOf(this, Water), result(0)));
    return nameOf(Momentum, integer(0));
  }

  set momentum(momentum) {
    check(wasm.cd_water_set_momentum(addressOf(this, Water), member(Momentum, momentum, "momentum")));
  }

  get first() {
    check(wasm.cd_water_get_first(addressOf(this, Water), result(0)));
    return integer(0) !== 0;
  }

  set first(alongY) {
    check(wasm.cd_water_set_first(addressOf(this, Water), flag(alongY, "alongY")));
  }

  get kernels() {
    check(wasm.cd_water_get_kernels(addressOf(this, Water), result(0)));
    return nameOf(Kernels, integer(0));
  }

  set kernels(kernels) {
    check(wasm.cd_water_set_kernels(addressOf(this, Water), member(Kernels, kernels, "kernels")));
  }

  get gravity() {
    check(wasm.cd_water_get_gravity(addressOf(this, Water), result(0)));
    return real(0);
  }

  set gravity(gravity) {
    check(wasm.cd_water_set_gravity(addressOf(this, Water), number(gravity, "gravity")));
  }

  get density() {
    check(wasm.cd_water_get_density(addressOf(this, Water), result(0)));
    return real(0);
  }

  set density(density) {
    check(wasm.cd_water_set_density(addressOf(this, Water), number(density, "density")));
  }

  get drag() {
    check(wasm.cd_water_get_drag(addressOf(this, Water), result(0)));
    return real(0);
  }

  set drag(drag) {
    check(wasm.cd_water_set_drag(addressOf(this, Water), number(drag, "drag")));
  }

  get manning() {
    check(wasm.cd_water_get_manning(addressOf(this, Water), result(0)));
    return real(0);
  }

  set manning(manning) {
    check(wasm.cd_water_set_manning(addressOf(this, Water), number(manning, "manning")));
  }

  setSide(side, kind, value = 0, rate = 0) {
    check(wasm.cd_water_set_side(addressOf(this, Water), member(Side, side, "side"), member(Border, kind, "kind"),
      number(value, "value"), number(rate, "rate")));
  }

  getSide(side) {
    check(wasm.cd_water_get_side(addressOf(this, Water), member(Side, side, "side"), result(0), result(1), result(2)));
    return {
      kind: nameOf(Border, integer(0)),
      value: real(1),
      rate: real(2),
    };
  }

  setInflowDepth(side, depth) {
    check(wasm.cd_water_set_inflow_depth(addressOf(this, Water), member(Side, side, "side"), number(depth, "depth")));
  }

  getInflowDepth(side) {
    check(wasm.cd_water_get_inflow_depth(addressOf(this, Water), member(Side, side, "side"), result(0)));
    return real(0);
  }

  get bedRule() {
    check(wasm.cd_water_get_bed_rule(addressOf(this, Water), result(0)));
    return nameOf(BedRule, integer(0));
  }

  set bedRule(rule) {
    check(wasm.cd_water_set_bed_rule(addressOf(this, Water), member(BedRule, rule, "rule")));
  }

  enableField(field) {
    check(wasm.cd_water_enable_field(addressOf(this, Water), member(Field, field, "field")));
  }

  disableField(field) {
    check(wasm.cd_water_disable_field(addressOf(this, Water), member(Field, field, "field")));
  }

  write(field, values, range) {
    writeField(this, kWater, field, values, range);
  }

  read(field, range, out) {
    return readField(this, kWater, field, range, out);
  }

  view(field) {
    return viewField(this, kWater, field);
  }

  get depth() {
    return viewField(this, kWater, "depth");
  }

  set depth(values) {
    writeField(this, kWater, "depth", values);
  }

  get bed() {
    return viewField(this, kWater, "bed");
  }

  set bed(values) {
    writeField(this, kWater, "bed", values);
  }

  get velocityX() {
    return viewField(this, kWater, "velocityX");
  }

  set velocityX(values) {
    writeField(this, kWater, "velocityX", values);
  }

  get velocityY() {
    return viewField(this, kWater, "velocityY");
  }

  set velocityY(values) {
    writeField(this, kWater, "velocityY", values);
  }

  get source() {
    return viewField(this, kWater, "source");
  }

  set source(values) {
    writeField(this, kWater, "source", values);
  }

  get pressure() {
    return viewField(this, kWater, "pressure");
  }

  set pressure(values) {
    writeField(this, kWater, "pressure", values);
  }

  get forceX() {
    return viewField(this, kWater, "forceX");
  }

  set forceX(values) {
    writeField(this, kWater, "forceX", values);
  }

  get forceY() {
    return viewField(this, kWater, "forceY");
  }

  set forceY(values) {
    writeField(this, kWater, "forceY", values);
  }

  addVolume(x, y, radius, volume) {
    check(wasm.cd_water_add_volume(addressOf(this, Water), number(x, "x"), number(y, "y"), number(radius, "radius"),
      number(volume, "volume"), result(0)));
    return real(0);
  }

  addVolumeRectangle(firstX, firstY, nX, nY, volume) {
    check(wasm.cd_water_add_volume_rectangle(addressOf(this, Water), size(firstX, "firstX"), size(firstY, "firstY"),
      size(nX, "nX"), size(nY, "nY"), number(volume, "volume"), result(0)));
    return real(0);
  }

  addSource(x, y, radius, rate) {
    check(wasm.cd_water_add_source(addressOf(this, Water), number(x, "x"), number(y, "y"), number(radius, "radius"),
      number(rate, "rate")));
  }

  addSourceRectangle(firstX, firstY, nX, nY, rate) {
    check(wasm.cd_water_add_source_rectangle(addressOf(this, Water), size(firstX, "firstX"), size(firstY, "firstY"),
      size(nX, "nX"), size(nY, "nY"), number(rate, "rate")));
  }

  splash(x, y, radius, height) {
    check(wasm.cd_water_splash(addressOf(this, Water), number(x, "x"), number(y, "y"), number(radius, "radius"),
      number(height, "height")));
  }

  impulse(x, y, radius, impulseX, impulseY) {
    check(wasm.cd_water_impulse(addressOf(this, Water), number(x, "x"), number(y, "y"), number(radius, "radius"),
      number(impulseX, "impulseX"), number(impulseY, "impulseY")));
  }

  get hulls() {
    check(wasm.cd_water_get_hulls(addressOf(this, Water), result(0), result(1), result(2)));
    return {
      count: whole(0),
      nAlong: whole(1),
      nAcross: whole(2),
    };
  }

  set hulls(numbers) {
    const { count, nAlong, nAcross } = several(numbers, () => this.hulls, "hulls", ["count", "nAlong", "nAcross"]);
    check(wasm.cd_water_set_hulls(addressOf(this, Water), size(count, "count"), size(nAlong, "nAlong"), size(nAcross,
      "nAcross")));
  }

  setHull(index, mass, length, width, heights = null) {
    const address = addressOf(this, Water);
    begin();
    const heightsAt = put(heights, Float64Array, "heights", true);
    const countOf = heightsAt.length;
    check(wasm.cd_water_set_hull(address, size(index, "index"), number(mass, "mass"), number(length, "length"),
      number(width, "width"), heightsAt.address, countOf));
  }

  setDisc(index, mass, radius) {
    check(wasm.cd_water_set_disc(addressOf(this, Water), size(index, "index"), number(mass, "mass"), number(radius,
      "radius")));
  }

  getHull(index, count = 0) {
    const address = addressOf(this, Water);
    begin();
    const countOf = size(count, "count");
    const heightsAt = countOf === 0 ? 0 : take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_water_get_hull(address, size(index, "index"), result(0), result(1), result(2), result(3), heightsAt,
      countOf));
    return {
      mass: real(0),
      length: real(1),
      width: real(2),
      area: real(3),
      heights: got(heightsAt, Float64Array, countOf),
    };
  }

  removeHull(index) {
    check(wasm.cd_water_remove_hull(addressOf(this, Water), size(index, "index")));
  }

  launchHull(index, x, y, aheadX, aheadY) {
    check(wasm.cd_water_launch_hull(addressOf(this, Water), size(index, "index"), number(x, "x"), number(y, "y"),
      number(aheadX, "aheadX"), number(aheadY, "aheadY")));
  }

  setHullPose(index, pose) {
    const address = addressOf(this, Water);
    begin();
    const poseAt = put(pose, Float64Array, "pose");
    const countOf = poseAt.length;
    check(wasm.cd_water_set_hull_pose(address, size(index, "index"), poseAt.address, countOf));
  }

  getHullPose(index, count) {
    const address = addressOf(this, Water);
    begin();
    const countOf = size(count, "count");
    const poseAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_water_get_hull_pose(address, size(index, "index"), poseAt, countOf));
    return got(poseAt, Float64Array, countOf);
  }

  setHullVelocity(index, velocity) {
    const address = addressOf(this, Water);
    begin();
    const velocityAt = put(velocity, Float64Array, "velocity");
    const countOf = velocityAt.length;
    check(wasm.cd_water_set_hull_velocity(address, size(index, "index"), velocityAt.address, countOf));
  }

  getHullVelocity(index, count) {
    const address = addressOf(this, Water);
    begin();
    const countOf = size(count, "count");
    const velocityAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_water_get_hull_velocity(address, size(index, "index"), velocityAt, countOf));
    return got(velocityAt, Float64Array, countOf);
  }

  getHullFloor(index, count) {
    const address = addressOf(this, Water);
    begin();
    const countOf = size(count, "count");
    const poseAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_water_get_hull_floor(address, size(index, "index"), poseAt, countOf));
    return got(poseAt, Float64Array, countOf);
  }

  setHullForce(index, force) {
    const address = addressOf(this, Water);
    begin();
    const forceAt = put(force, Float64Array, "force");
    const countOf = forceAt.length;
    check(wasm.cd_water_set_hull_force(address, size(index, "index"), forceAt.address, countOf));
  }

  getHullForce(index, count) {
    const address = addressOf(this, Water);
    begin();
    const countOf = size(count, "count");
    const forceAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_water_get_hull_force(address, size(index, "index"), forceAt, countOf));
    return got(forceAt, Float64Array, countOf);
  }

  setHullDrag(index, along, across, friction) {
    check(wasm.cd_water_set_hull_drag(addressOf(this, Water), size(index, "index"), number(along, "along"),
      number(across, "across"), number(friction, "friction")));
  }

  getHullDrag(index) {
    check(wasm.cd_water_get_hull_drag(addressOf(this, Water), size(index, "index"), result(0), result(1), result(2)));
    return {
      along: real(0),
      across: real(1),
      friction: real(2),
    };
  }

  getHullLoad(index, count) {
    const address = addressOf(this, Water);
    begin();
    const countOf = size(count, "count");
    const loadAt = take(Float64Array.BYTES_PER_ELEMENT * countOf);
    check(wasm.cd_water_get_hull_load(address, size(index, "index"), loadAt, countOf));
    return got(loadAt, Float64Array, countOf);
  }

  get hullEnergy() {
    check(wasm.cd_water_get_hull_energy(addressOf(this, Water), result(0), result(1)));
    return {
      kinetic: real(0),
      potential: real(1),
    };
  }

  sampleHeads(at, outside = "refused") {
    const address = addressOf(this, Water);
    begin();
    const atAt = put(at, Float64Array, "at");
    const nOf = items(atAt, 2, "at");
    const headsAt = take(Float64Array.BYTES_PER_ELEMENT * nOf);
    check(wasm.cd_water_sample_heads(address, atAt.address, nOf, member(Outside, outside, "outside"), headsAt));
    return got(headsAt, Float64Array, nOf);
  }

  step(dt, count = 1) {
    check(wasm.cd_water_step(addressOf(this, Water), number(dt, "dt"), size(count, "count")));
  }

  stableDt() {
    check(wasm.cd_water_stable_dt(addressOf(this, Water), result(0)));
    return real(0);
  }

  get time() {
    check(wasm.cd_water_get_time(addressOf(this, Water), result(0)));
    return real(0);
  }

  get steps() {
    check(wasm.cd_water_get_steps(addressOf(this, Water), result(0)));
    return count(0);
  }

  get factorizations() {
    check(wasm.cd_water_get_factorizations(addressOf(this, Water), result(0)));
    return count(0);
  }

  get limited() {
    check(wasm.cd_water_get_limited(addressOf(this, Water), result(0), result(1)));
    return {
      cells: count(0),
      volume: real(1),
    };
  }

  get sleep() {
    check(wasm.cd_water_get_sleep(addressOf(this, Water), result(0)));
    return real(0);
  }

  set sleep(height) {
    check(wasm.cd_water_set_sleep(addressOf(this, Water), number(height, "height")));
  }

  get awake() {
    check(wasm.cd_water_get_awake(addressOf(this, Water), result(0)));
    return whole(0);
  }

  get volume() {
    check(wasm.cd_water_get_volume(addressOf(this, Water), result(0)));
    return real(0);
  }

  get account() {
    check(wasm.cd_water_get_account(addressOf(this, Water), result(0), result(1), result(2), result(3)));
    return {
      initial: real(0),
      in: real(1),
      out: real(2),
      error: real(3),
    };
  }

  restartAccount() {
    check(wasm.cd_water_restart_account(addressOf(this, Water)));
  }

  get energy() {
    check(wasm.cd_water_get_energy(addressOf(this, Water), result(0), result(1)));
    return {
      kinetic: real(0),
      potential: real(1),
    };
  }

  get wetArea() {
    check(wasm.cd_water_get_wet_area(addressOf(this, Water), result(0)));
    return real(0);
  }

  getCourant(dt) {
    check(wasm.cd_water_get_courant(addressOf(this, Water), number(dt, "dt"), result(0)));
    return real(0);
  }

  sample(at, outside = "refused") {
    const address = addressOf(this, Water);
    begin();
    const atAt = put(at, Float64Array, "at");
    const nOf = items(atAt, 2, "at");
    const surfaceAt = take(Float64Array.BYTES_PER_ELEMENT * nOf);
    const depthAt = take(Float64Array.BYTES_PER_ELEMENT * nOf);
    const normalAt = take(Float64Array.BYTES_PER_ELEMENT * nOf * 3);
    const velocityAt = take(Float64Array.BYTES_PER_ELEMENT * nOf * 2);
    check(wasm.cd_water_sample(address, atAt.address, nOf, member(Outside, outside, "outside"), surfaceAt, depthAt,
      normalAt, velocityAt));
    return {
      surface: got(surfaceAt, Float64Array, nOf),
      depth: got(depthAt, Float64Array, nOf),
      normal: got(normalAt, Float64Array, nOf * 3),
      velocity: got(velocityAt, Float64Array, nOf * 2),
    };
  }

  get memory() {
    check(wasm.cd_water_get_memory(addressOf(this, Water), result(0)));
    return whole(0);
  }

  hash() {
    check(wasm.cd_water_hash(addressOf(this, Water), result(0)));
    return bits(0);
  }

  writeVertices(buffer, stride, positionOffset, normalOffset, depthOffset) {
    const address = addressOf(this, Water);
    begin();
    const bufferAt = putBytes(buffer, "buffer");
    const sizeOf = bufferAt.length;
    check(wasm.cd_water_write_vertices(address, bufferAt.address, sizeOf, size(stride, "stride"), size(positionOffset,
      "positionOffset"), sizeOrNone(normalOffset, "normalOffset"), sizeOrNone(depthOffset, "depthOffset")));
    getBytes(buffer, bufferAt);
  }

  getIndexCount(skipDry) {
    check(wasm.cd_water_get_index_count(addressOf(this, Water), flag(skipDry, "skipDry"), result(0)));
    return whole(0);
  }

  writeIndices(skipDry, buffer, indexSize) {
    const address = addressOf(this, Water);
    begin();
    const bufferAt = putBytes(buffer, "buffer");
    const sizeOf = bufferAt.length;
    check(wasm.cd_water_write_indices(address, flag(skipDry, "skipDry"), bufferAt.address, sizeOf, size(indexSize,
      "indexSize")));
    getBytes(buffer, bufferAt);
  }

  saveSize() {
    check(wasm.cd_water_save_size(addressOf(this, Water), result(0)));
    return whole(0);
  }

  save() {
    const size = this.saveSize();
    begin();
    const at = take(size);
    check(wasm.cd_water_save(addressOf(this, Water), at, size, result(0)));
    return got(at, Uint8Array, whole(0));
  }

  load(bytes) {
    const address = addressOf(this, Water);
    begin();
    const bytesAt = putBytes(bytes, "bytes");
    const sizeOf = bytesAt.length;
    check(wasm.cd_water_load(address, bytesAt.address, sizeOf));
  }

  copyState(source) {
    check(wasm.cd_water_copy_state(addressOf(this, Water), addressOf(source, Water, "source")));
  }

  reset() {
    check(wasm.cd_water_reset(addressOf(this, Water)));
  }
}

const kWater = {
  name: "water",
  Class: Water,
  Field,
  range: ["firstX", "firstY", "nX", "nY"],
  reversed: true,
  fields: {
    __proto__: null,
    depth: { per: ["cell"] },
    bed: { per: ["cell"] },
    surface: { per: ["cell"] },
    velocityX: { per: ["x-face"] },
    velocityY: { per: ["y-face"] },
    source: { per: ["cell"] },
    pressure: { per: ["cell"] },
    forceX: { per: ["x-face"] },
    forceY: { per: ["y-face"] },
    mask: { per: ["cell"] },
    wallX: { per: ["x-face"] },
    wallY: { per: ["y-face"] },
  },
};
