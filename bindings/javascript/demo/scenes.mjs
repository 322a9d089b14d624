// The five scenes of the page. Each makes one object, steps it, draws it, and answers a pointer in its own coordinates.
import { Chain, Membrane, Water } from "../contdyn/contdyn.mjs";

const kMethods = { implicit: "implicit", symplecticEuler: "symplectic Euler", forwardEuler: "forward Euler",
  stiffSecond: "stiff, second order" };

// ---- controls -------------------------------------------------------------------------------------------------------

const digits = (value) => (value === Infinity ? "∞" : Number(value.toPrecision(3)).toString());

/** A slider of powers of ten; at its end, where that may be, infinity. */
const powers = (label, unit, from, to, value, infinite = false) => ({ label, unit, value, min: from,
  max: to + (infinite ? 0.1 : 0), step: 0.05, of: (x) => (infinite && x > to + 0.01 ? Infinity : 10 ** x),
  at: (v) => (v === Infinity ? to + 0.1 : Math.log10(v)), show: (v) => `${digits(v)} ${unit}` });
const range = (label, unit, min, max, step, value) => ({ label, unit, value, min, max, step, of: Number, at: Number,
  show: (v) => `${digits(v)} ${unit}` });
const choice = (label, choices, value) => ({ label, choices, value });
const stepSize = (value = 1 / 60) => ({ ...powers("Step size", "ms", 0, 2.3, value), of: (x) => 10 ** x / 1000,
  at: (v) => Math.log10(v * 1000), show: (v) => `${digits(v * 1000)} ms` });

// ---- drawing --------------------------------------------------------------------------------------------------------

/** Where a rectangle of the scene lies in a picture of width x height, y up. */
export function frame({ left, right, bottom, top }, width, height) {
  const scale = Math.min(width / (right - left), height / (top - bottom));
  const x0 = width / 2 - (scale * (left + right)) / 2;
  const y0 = height / 2 + (scale * (top + bottom)) / 2;
  return { scale, x: (x) => x0 + scale * x, y: (y) => y0 - scale * y, back: (px, py) => [(px - x0) / scale,
    (y0 - py) / scale] };
}

function line(context, view, values, strides, from, to) {
  const [, node, component] = strides;
  context.moveTo(view.x(values[from * node]), view.y(values[from * node + component]));
  for (let i = from + 1; i <= to; ++i) context.lineTo(view.x(values[i * node]), view.y(values[i * node + component]));
}

function disc(context, view, x, y, radius) {
  context.beginPath();
  context.arc(view.x(x), view.y(y), radius * view.scale, 0, 2 * Math.PI);
}

// ---- pool -----------------------------------------------------------------------------------------------------------

const kCells = 256;
const kBoat = { mass: 110, length: 1.2, width: 0.5, along: 12, across: 6, freeboard: 0.16 };

class Pool {
  static title = "Pool";
  static hint = "Drag through the water, or pull the boat. A beach lies to the right. Then take forward Euler, and the "
    + "pool blows up; symplectic Euler bears short steps only; the implicit step any.";
  static world = { left: 0, right: 8, bottom: 0, top: 6 };
  static controls = {
    dt: stepSize(),
    method: choice("Method", { implicit: kMethods.implicit, symplecticEuler: kMethods.symplecticEuler,
      forwardEuler: kMethods.forwardEuler }, "implicit"),
    lambda: range("Lambda", "", 0, 1, 0.05, 0.55),
    gravity: range("Gravity", "m/s²", 0, 30, 0.1, 9.81),
    momentum: choice("Momentum", { linear: "linear", advected: "carried along" }, "linear"),
  };

  constructor(settings) {
    const { right, top } = Pool.world;
    const bed = new Float32Array(kCells * kCells);
    for (let j = 0; j < kCells; ++j) {
      for (let i = 0; i < kCells; ++i) {
        const x = i / kCells;
        const y = j / kCells;
        const shore = 0.66 + 0.07 * Math.sin(7 * y) + 0.02 * Math.sin(17 * y + 1);
        const island = 0.75 * Math.exp(-((x - 0.3) ** 2 + (y - 0.62) ** 2) / 0.005);
        bed[j * kCells + i] = Math.max(-0.6 + 1.7 * Math.max(0, x - shore + 0.35), -0.6 + island);
      }
    }
    this.object = new Water({ nx: kCells, ny: kCells, dx: right / kCells, dy: top / kCells, precision: "float32",
      ...this.#changed(settings), bed });
    this.object.write("surface", 0);
    this.object.restartAccount();
    this.object.splash(2.2, 2.2, 0.6, 0.3);
    this.#launch();
    this.image = null;
  }

  /** A flat boat whose bow narrows to a point. */
  #launch() {
    const { mass, length, width, along, across } = kBoat;
    const heights = [];
    for (let j = 0; j < across; ++j) {
      for (let i = 0; i < along; ++i) {
        const beside = Math.abs(2 * (j + 0.5) / across - 1);
        heights.push(beside > (along - i - 0.5) / (0.35 * along) ? -1 : 0);
      }
    }
    this.object.hulls = { count: 1, nAlong: along, nAcross: across };
    this.object.setHull(0, mass, length, width, heights);
    this.object.setHullDrag(0, 60, 600, 0.3);
    this.object.launchHull(0, 3.9, 2.1, 1, 0.4);
    this.pulled = null;
  }

  /** While the boat is held, a rope from the pointer to its middle pulls it and turns its bow there. */
  before() {
    if (!this.pulled) return;
    const [x, y, , aheadX, aheadY] = this.object.getHullFloor(0, 7);
    const [speedX, speedY, , yaw] = this.object.getHullVelocity(0, 6);
    const [toX, toY] = [this.pulled[0] - x, this.pulled[1] - y];
    const [pullX, pullY] = [400 * toX - 150 * speedX, 400 * toY - 150 * speedY];
    const turn = 150 * (toY * aheadX - toX * aheadY) - 30 * yaw;
    this.object.setHullForce(0, [pullX * aheadX + pullY * aheadY, pullY * aheadX - pullX * aheadY, 0, turn, 0, 0]);
  }

  #changed({ method, lambda, gravity, momentum }) {
    return { momentum, method, lambda, gravity }; // momentum sets lambda too
  }

  set(settings) {
    Object.assign(this.object, this.#changed(settings));
  }

  press(x, y) {
    const [boatX, boatY] = this.object.getHullFloor(0, 7);
    if (Math.hypot(boatX - x, boatY - y) < kBoat.length / 2) this.pulled = [x, y];
    else this.object.splash(this.#x(x), this.#y(y), 0.35, 0.15);
  }

  drag(x, y, dx, dy) {
    if (this.pulled) this.pulled = [this.#x(x), this.#y(y)];
    else this.object.impulse(this.#x(x), this.#y(y), 0.4, 900 * dx, 900 * dy);
  }

  release() {
    if (this.pulled) this.object.setHullForce(0, [0, 0, 0, 0, 0, 0]);
    this.pulled = null;
  }

  #x(x) {
    return Math.min(Math.max(x, 0), 8);
  }

  #y(y) {
    return Math.min(Math.max(y, 0), 6);
  }

  energy() {
    const { kinetic, potential } = this.object.energy;
    return { kinetic, total: kinetic + potential - (this.rest ??= this.#rest()) };
  }

  /** The potential energy of water that lies still. */
  #rest() {
    const bed = this.object.read("bed");
    const cell = (8 / kCells) * (6 / kCells);
    return bed.reduce((sum, b) => (b < 0 ? sum - 0.5 * 1000 * this.object.gravity * cell * b * b : sum), 0);
  }

  numbers() {
    const { initial, in: came, out: went, error } = this.object.account;
    const [x, y] = this.object.getHullFloor(0, 7);
    return { Boat: `${x.toFixed(1)} m, ${y.toFixed(1)} m`, Volume: `${(initial + came - went + error).toFixed(4)} m³`,
      "Lost or gained": `${error.toExponential(1)} m³` };
  }

  draw(context, view, { dark }) {
    const { object } = this;
    this.image ??= new ImageData(kCells, kCells);
    this.canvas ??= Object.assign(document.createElement("canvas"), { width: kCells, height: kCells });
    const { values: depth, strides: [row, column] } = object.depth;
    const { values: bed, strides: [bedRow, bedColumn] } = object.bed;
    const { data } = this.image;
    const dim = dark ? 0.8 : 1;
    for (let j = 0; j < kCells; ++j) {
      let west = bed[j * bedRow] + depth[j * row];
      for (let i = 0; i < kCells; ++i) {
        const b = bed[j * bedRow + i * bedColumn];
        const d = depth[j * row + i * column];
        const up = Math.min(j + 1, kCells - 1);
        const north = bed[up * bedRow + i * bedColumn] + depth[up * row + i * column];
        const h = b + d;
        const light = dim * Math.min(1.5, Math.max(0.5, 1 + 7 * (h - west) - 5 * (north - h)));
        const wet = Math.min(1, d * 25);
        const deep = Math.min(1, d / 0.65);
        const k = 4 * ((kCells - 1 - j) * kCells + i);
        data[k] = light * ((1 - wet) * (214 - 40 * b) + wet * (120 - 95 * deep));
        data[k + 1] = light * ((1 - wet) * (192 - 40 * b) + wet * (196 - 85 * deep));
        data[k + 2] = light * ((1 - wet) * (148 - 40 * b) + wet * (214 - 45 * deep));
        data[k + 3] = 255;
        west = h;
      }
    }
    const picture = this.canvas.getContext("2d");
    picture.putImageData(this.image, 0, 0);
    context.drawImage(this.canvas, view.x(0), view.y(6), 8 * view.scale, 6 * view.scale);
    this.#drawBoat(context, view, dark);
  }

  /** Seen from above: its floor, and the gunwale, which leans as the boat pitches and rolls. */
  #drawBoat(context, view, dark) {
    const [x, y, , aheadX, aheadY, pitch, roll] = this.object.getHullFloor(0, 7);
    const { length, width, freeboard } = kBoat;
    const outline = [[-0.5, -0.5], [-0.5, 0.5], [0.15, 0.5], [0.5, 0.08], [0.5, -0.08], [0.15, -0.5]];
    for (const [share, color] of [[1, dark ? "#6b4020" : "#7a4a24"], [0.82, dark ? "#a8784c" : "#c8935c"]]) {
      context.beginPath();
      for (const [along, port] of outline) {
        const a = share * along * length - pitch * freeboard;
        const p = share * port * width - roll * freeboard;
        context.lineTo(view.x(x + a * aheadX - p * aheadY), view.y(y + a * aheadY + p * aheadX));
      }
      context.closePath();
      context.fillStyle = color;
      context.fill();
    }
  }
}

// ---- what is pulled by a node ---------------------------------------------------------------------------------------

class Pulled {
  held = null;

  /** The node nearest to a place, of all strands: its number of strand and node, and how far it is. */
  nearest(x, y) {
    const { values, shape: [rows, columns], strides: [row, column, component] } = this.object.position;
    let best = { distance: Infinity };
    for (let r = 0; r < rows; ++r) {
      for (let c = 0; c < columns; ++c) {
        const at = r * row + c * column;
        const distance = Math.hypot(values[at] - x, values[at + component] - y);
        if (distance < best.distance) best = { r, c, distance, z: values[at + 2 * component] };
      }
    }
    return best;
  }
}

// ---- rope -----------------------------------------------------------------------------------------------------------

class Rope extends Pulled {
  static title = "Rope";
  static hint = "Pull the rope. With Cut on, or the right button, draw a line across it. At ∞ it does not stretch at "
    + "all, in steps of any size; lambda ½ swings on, 1 soon rests.";
  static world = { left: -2, right: 2, bottom: -2.55, top: 0.45 };
  static canCut = true;
  static controls = {
    dt: stepSize(),
    stiffness: powers("Stiffness", "N/m", 0, 6, Infinity, true),
    lambda: range("Lambda", "", 0.5, 1, 0.05, 0.5),
    mass: powers("Mass", "kg", -2, 2, 0.5),
  };

  constructor({ stiffness, lambda, mass }) {
    super();
    const springs = 48;
    this.cuts = new Set();
    this.object = new Chain({ strands: 1, springs, components: 2, restLength: 2, mass, stiffness, lambda,
      gravity: [0, -9.81], drag: 0.15, thickness: 0.02, colliders: 1,
      position: Array.from({ length: springs + 1 }, (_, i) => [(2 * i) / springs - 0.4, 0.2]) });
    this.object.setEnd("first", "pinned");
    this.object.setCapsule(0, [0.45, -0.9], [0.45, -0.9], 0.22, 0.1);
  }

  set({ stiffness, lambda, mass }) {
    const { object } = this;
    object.lambda = lambda;
    object.mass = mass;
    if (object.stiffness !== stiffness) {
      object.stiffness = stiffness; // that mends what was cut
      for (const spring of this.cuts) object.cut(0, spring);
    }
    if (this.held !== null) this.#tie(this.held.x, this.held.y);
  }

  #tie(x, y) {
    this.held = { ...this.held, x, y };
    this.object.attach(0, this.held.node, 300 * this.object.mass, 6 * this.object.mass, [x, y]);
  }

  press(x, y, cutting) {
    if (cutting) return;
    const { c: node, distance } = this.nearest(x, y);
    if (distance > 0.6 || node === 0) return;
    this.held = { node };
    this.#tie(x, y);
  }

  drag(x, y, dx, dy, cutting) {
    if (cutting) this.#cut(x - dx, y - dy, x, y);
    else if (this.held !== null) this.#tie(x, y);
  }

  release() {
    if (this.held !== null) this.object.detach(0, this.held.node);
    this.held = null;
  }

  /** Cuts the springs that a line crosses. */
  #cut(x0, y0, x1, y1) {
    const { values, shape: [, nodes], strides: [, node, component] } = this.object.position;
    const side = (ax, ay, bx, by, px, py) => (bx - ax) * (py - ay) - (by - ay) * (px - ax);
    for (let i = 0; i + 1 < nodes; ++i) {
      const [ax, ay] = [values[i * node], values[i * node + component]];
      const [bx, by] = [values[(i + 1) * node], values[(i + 1) * node + component]];
      if (!this.cuts.has(i) && side(x0, y0, x1, y1, ax, ay) * side(x0, y0, x1, y1, bx, by) < 0
        && side(ax, ay, bx, by, x0, y0) * side(ax, ay, bx, by, x1, y1) < 0) {
        this.object.cut(0, i);
        this.cuts.add(i);
        break; // the array may have moved
      }
    }
  }

  energy() {
    const { kinetic, elastic, gravity } = this.object.energy;
    return { kinetic, total: kinetic + elastic + gravity };
  }

  numbers() {
    const strain = this.object.read("strain").reduce((most, s, i) => (this.cuts.has(i) ? most : Math.max(most, s)), 0);
    return { "Stretched by": `${(100 * strain).toPrecision(2)} %`, Iterations: this.object.convergence.iterations };
  }

  draw(context, view, colors) {
    const { values, shape: [, nodes], strides } = this.object.position;
    disc(context, view, 0.45, -0.9, 0.2);
    context.fillStyle = colors.line;
    context.fill();
    context.strokeStyle = colors.ink;
    context.lineWidth = Math.max(2, 0.04 * view.scale);
    context.lineCap = context.lineJoin = "round";
    context.beginPath();
    let from = 0;
    for (const spring of [...this.cuts].sort((a, b) => a - b)) {
      line(context, view, values, strides, from, spring);
      from = spring + 1;
    }
    line(context, view, values, strides, from, nodes - 1);
    context.stroke();
    context.fillStyle = colors.accent;
    disc(context, view, values[0], values[strides[2]], 0.045);
    context.fill();
    if (this.held !== null) {
      disc(context, view, this.held.x, this.held.y, 0.06);
      context.fill();
    }
  }
}

// ---- hair -----------------------------------------------------------------------------------------------------------

class Hair {
  static title = "Hair";
  static hint = "Move the head. The hair keeps its length and stays outside of the head, and wind lifts it.";
  static world = { left: -2, right: 2, bottom: -1.75, top: 1.25 };
  static controls = {
    dt: stepSize(),
    stiffness: powers("Stiffness", "N/m", 0, 6, Infinity, true),
    lambda: range("Lambda", "", 0.5, 1, 0.05, 1),
    wind: range("Wind", "m/s", -8, 8, 0.1, 0),
  };
  static radius = 0.42;

  constructor({ stiffness, lambda, wind }) {
    const [strands, springs] = [44, 12];
    this.head = [0, 0.35];
    this.goal = [0, 0.35];
    this.roots = Array.from({ length: strands }, (_, s) => {
      const angle = Math.PI * (0.06 + (0.88 * s) / (strands - 1));
      return [Math.cos(angle) * Hair.radius, Math.sin(angle) * Hair.radius];
    });
    const length = (s) => 0.85 + 0.25 * Math.sin(s * 12.9898);
    this.object = new Chain({ strands, springs, components: 2, restLength: 1, mass: 0.02, stiffness, lambda,
      gravity: [0, -9.81], drag: 0.6, air: { along: 0.002, across: 0.01 }, wind: [wind, 0], colliders: 1,
      position: this.roots.map(([x, y], s) => Array.from({ length: springs + 1 }, (_, i) => {
        const grown = 1 + ((length(s) * i) / springs) / Hair.radius;
        return [this.head[0] + x * grown, this.head[1] + y * grown];
      })) });
    this.object.enableField("restLength");
    this.object.write("restLength", this.roots.flatMap((_, s) => new Array(springs).fill(length(s) / springs)));
    this.object.setEnd("first", "posed");
    this.object.setCapsule(0, this.head, this.head, Hair.radius - 0.01, 0.1);
  }

  set({ stiffness, lambda, wind }) {
    const { object } = this;
    if (object.stiffness !== stiffness) object.stiffness = stiffness;
    object.lambda = lambda;
    object.wind = [wind, 0];
  }

  /** Before steps that take `seconds` together: the head goes towards where it is drawn. */
  before(seconds) {
    const share = 1 - Math.exp(-14 * seconds);
    const moved = this.head.map((x, i) => Math.min(Math.max((this.goal[i] - x) * share, -8 * seconds), 8 * seconds));
    this.object.setCapsule(0, this.head, this.head, Hair.radius - 0.01, 0.1);
    this.object.setColliderVelocity(0, moved.map((way) => way / seconds));
    this.head = this.head.map((x, i) => x + moved[i]);
    this.object.write("target", this.roots.map(([x, y]) => [this.head[0] + x, this.head[1] + y]), { first: 0, n: 1 });
  }

  press(x, y) {
    this.grip = [this.head[0] - x, this.head[1] - y];
    if (Math.hypot(...this.grip) > 0.8) this.grip = [0, 0];
    this.drag(x, y);
  }

  drag(x, y) {
    const clamp = (v, most) => Math.min(Math.max(v, -most), most);
    this.goal = [clamp(x + this.grip[0], 1.5), clamp(y + this.grip[1], 0.8)];
  }

  release() {}

  energy() {
    const { kinetic, elastic, gravity } = this.object.energy;
    return { kinetic, total: kinetic + elastic + gravity };
  }

  numbers() {
    const { iterations } = this.object.convergence;
    return { Strands: this.roots.length, Iterations: iterations };
  }

  draw(context, view, colors) {
    const { values, shape: [strands, nodes], strides } = this.object.position;
    disc(context, view, ...this.head, Hair.radius);
    context.fillStyle = colors.skin;
    context.fill();
    context.fillStyle = colors.ground;
    for (const side of [-1, 1]) {
      disc(context, view, this.head[0] + side * 0.13, this.head[1] - 0.02, 0.04);
      context.fill();
    }
    context.strokeStyle = colors.hair;
    context.lineWidth = Math.max(1.2, 0.014 * view.scale);
    context.lineJoin = "round";
    context.beginPath();
    for (let s = 0; s < strands; ++s) {
      line(context, view, values.subarray(s * strides[0]), strides, 0, nodes - 1);
    }
    context.stroke();
  }
}

// ---- cloth ----------------------------------------------------------------------------------------------------------

const kCloth = [26, 18];

class Cloth extends Pulled {
  static title = "Cloth";
  static hint = "Pull the flag, and turn the wind. Cloth is stable at any stiffness, mass and step size.";
  static world = { left: -1.35, right: 1.65, bottom: -1.2, top: 1.05 };
  static controls = {
    dt: stepSize(),
    stiffness: powers("Stiffness", "N/m", 1, 6, 3000),
    wind: range("Wind", "m/s", -15, 15, 0.5, 8),
    mass: powers("Mass", "kg", -2, 1, 0.3),
  };

  constructor(settings) {
    super();
    const [nu, nv] = kCloth;
    this.object = new Membrane({ nu, nv, components: 3, restLength: { alongU: 2, alongV: 1.4 }, shear: 200, bend: 0.002,
      gravity: [0, -9.81, 0], drag: 0.1, air: { along: 0.02, across: 0.6 },
      position: Array.from({ length: (nu + 1) * (nv + 1) }, (_, i) => {
        const [u, v] = [(i % (nu + 1)) / nu, Math.floor(i / (nu + 1)) / nv];
        return [2 * u - 1, 1.4 * v - 0.5, 0.12 * Math.sin(7 * u)];
      }) });
    this.object.setEdge("uFirst", "pinned");
    this.time = 0;
    this.set(settings);
  }

  set({ stiffness, wind, mass }) {
    this.object.mass = mass;
    this.object.stiffness = { alongU: stiffness, alongV: stiffness };
    this.wind = wind;
  }

  /** Gusts. */
  before(seconds) {
    this.time += seconds;
    const gust = 1 + 0.35 * Math.sin(1.7 * this.time) + 0.2 * Math.sin(4.1 * this.time);
    this.object.wind = [this.wind * gust, 0, 0.35 * this.wind * Math.sin(2.3 * this.time)];
  }

  press(x, y) {
    const { r: v, c: u, distance, z } = this.nearest(x, y);
    if (distance > 0.5 || u === 0) return;
    this.held = { u, v, z };
    this.drag(x, y);
  }

  drag(x, y) {
    if (this.held === null) return;
    Object.assign(this.held, { x, y });
    this.object.attach(this.held.u, this.held.v, 150, 1, [x, y, this.held.z]);
  }

  release() {
    if (this.held !== null) this.object.detach(this.held.u, this.held.v);
    this.held = null;
  }

  energy() {
    const { kinetic, elastic, gravity } = this.object.energy;
    return { kinetic, total: kinetic + elastic + gravity };
  }

  numbers() {
    const most = this.object.read("strainU").reduce((a, b) => Math.max(a, b), 0);
    return { "Stretched by": `${(100 * most).toPrecision(2)} %`, "Newton steps": this.object.convergence.iterations };
  }

  draw(context, view, colors) {
    const [nu, nv] = kCloth;
    const count = (nu + 1) * (nv + 1);
    this.vertices ??= new Float32Array(6 * count);
    this.object.writeVertices(this.vertices, 24, 0, 12);
    const v = this.vertices;
    const cells = [];
    for (let j = 0; j < nv; ++j) for (let i = 0; i < nu; ++i) cells.push(j * (nu + 1) + i);
    const depth = (k) => v[6 * k + 2] + v[6 * (k + nu + 2) + 2];
    cells.sort((a, b) => depth(a) - depth(b));
    context.lineJoin = "round";
    context.lineWidth = 1;
    for (const k of cells) {
      const corners = [k, k + 1, k + nu + 2, k + nu + 1];
      const normal = corners.reduce((sum, c) => sum + Math.abs(v[6 * c + 5]) + 0.5 * v[6 * c + 3], 0) / 4;
      const shade = 0.55 + 0.45 * Math.min(1, Math.max(0, normal));
      const stripe = Math.floor(k / (nu + 1) / 6) % 2 === 1;
      const [r, g, b] = stripe ? colors.stripe : colors.fabric;
      context.fillStyle = context.strokeStyle = `rgb(${r * shade} ${g * shade} ${b * shade})`;
      context.beginPath();
      corners.forEach((c, n) => context[n ? "lineTo" : "moveTo"](view.x(v[6 * c]), view.y(v[6 * c + 1])));
      context.closePath();
      context.fill();
      context.stroke();
    }
    context.strokeStyle = colors.ink;
    context.lineWidth = Math.max(3, 0.035 * view.scale);
    context.beginPath();
    context.moveTo(view.x(-1.015), view.y(-1.15));
    context.lineTo(view.x(-1.015), view.y(0.97));
    context.stroke();
    if (this.held !== null) {
      disc(context, view, this.held.x, this.held.y, 0.04);
      context.fillStyle = colors.accent;
      context.fill();
    }
  }
}

// ---- drum -----------------------------------------------------------------------------------------------------------

const kDrum = 48;

class Drum {
  static title = "Drum";
  static hint = "Strike the drum. Forward Euler blows it up at any step size, symplectic Euler where the step is too "
    + "long for the stiffness; the implicit step holds, and lambda ½ keeps the energy.";
  static world = { left: -0.95, right: 0.95, bottom: -0.7, top: 0.7 };
  static controls = {
    dt: stepSize(),
    method: choice("Method", kMethods, "implicit"),
    stiffness: powers("Stiffness", "N/m", 0, 8, 10),
    lambda: range("Lambda", "", 0, 1, 0.05, 0.5),
    drag: range("Drag", "1/s", 0, 2, 0.05, 0.1),
  };

  constructor(settings) {
    this.object = new Membrane({ nu: kDrum, nv: kDrum, components: 1, precision: "float64" });
    for (const edge of ["uFirst", "uLast", "vFirst", "vLast"]) this.object.setEdge(edge, "pinned");
    this.set(settings);
    this.press(0.1, 0.1);
  }

  set({ method, stiffness, lambda, drag }) {
    Object.assign(this.object, { method, lambda, drag, stiffness: { alongU: stiffness, alongV: stiffness } });
  }

  press(x, y) {
    const [u, v] = [x - 0.35 * (y / 0.62) + 0.5, y / 0.62 + 0.5];
    if (u <= 0 || u >= 1 || v <= 0 || v >= 1) return;
    const loud = Math.min(3, Math.sqrt(this.object.stiffness.alongU)) * 0.06;
    this.object.impulse(u * kDrum, v * kDrum, 5, [-loud]);
  }

  drag(x, y, dx, dy) {
    this.way = (this.way ?? 0) + Math.hypot(dx, dy);
    if (this.way < 0.12) return;
    this.way = 0;
    this.press(x, y);
  }

  release() {}

  energy() {
    const { kinetic, elastic } = this.object.energy;
    return { kinetic, total: kinetic + elastic };
  }

  numbers() {
    const { stiffness: { alongU }, mass } = this.object;
    return { Pitch: `${digits(Math.sqrt((2 * alongU) / mass) / 2)} Hz`,
      "Symplectic Euler up to": `${digits(1000 * this.object.stableDt())} ms` };
  }

  draw(context, view, colors) {
    const { values, strides: [row, column] } = this.object.position;
    const place = (i, j) => {
      const [u, v] = [i / kDrum - 0.5, 0.5 - j / kDrum];
      const h = Math.min(3, Math.max(-3, values[(kDrum - j) * row + i * column]));
      return [view.x(u + 0.35 * v), view.y(0.62 * v + h * 1.2)];
    };
    context.lineWidth = 1;
    context.lineJoin = "round";
    context.strokeStyle = colors.accent;
    for (let j = 0; j < kDrum; ++j) {
      context.beginPath();
      for (let i = 0; i <= kDrum; ++i) context[i ? "lineTo" : "moveTo"](...place(i, j));
      for (let i = kDrum; i >= 0; --i) context.lineTo(...place(i, j + 1));
      context.closePath();
      context.fillStyle = colors.drum(j / kDrum);
      context.fill();
      context.stroke();
    }
  }
}

export const scenes = { pool: Pool, rope: Rope, hair: Hair, cloth: Cloth, drum: Drum };
