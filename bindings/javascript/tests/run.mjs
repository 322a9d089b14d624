// The package's tests: node --expose-gc run.mjs PACKAGE simd|plain. The scenes of bindings/conformance are played too,
// and at the end every function of the library must have been called with success.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import test, { after } from "node:test";

// Counts successful calls, in front of what the package sees of the library.
const calls = new Map();
const { instantiate } = WebAssembly;
let memory;
WebAssembly.instantiate = async (...given) => {
  const made = await instantiate.apply(WebAssembly, given);
  const exports = {};
  for (const [name, value] of Object.entries((made.instance ?? made).exports)) {
    exports[name] = typeof value !== "function" ? value : (...values) => {
      const result = value(...values);
      if (result === 0 || !/^cd_(chain|membrane|water)_/.test(name) || result === undefined) {
        calls.set(name, (calls.get(name) ?? 0) + 1);
      }
      return result;
    };
  }
  ({ memory } = exports);
  return { exports };
};

const { camel, contdyn, folder, build, kinds } = await import("./support.mjs");
const { Chain, ContdynError, Membrane, Node, Water } = contdyn;
const bindings = new URL("../../", import.meta.url);
const api = JSON.parse(await readFile(new URL("api.json", bindings), "utf8"));

const refused = (status, message, call) => assert.throws(call, (error) => {
  assert(error instanceof ContdynError && error instanceof Error && error.name === "ContdynError");
  assert.equal(error.status, status);
  assert.match(error.message, message);
  return true;
});

const makers = {
  chain: () => {
    const rope = new Chain({ strands: 2, springs: 3, components: 3, restLength: 1, gravity: [0, -9.81, 0] });
    rope.position = Array.from({ length: 8 }, (_, i) => [i % 4 / 3, 0, i]);
    rope.colliders = 1;
    rope.loads = true;
    return rope;
  },
  membrane: () => {
    const cloth = new Membrane({ nu: 4, nv: 3, components: 3, restLength: { alongU: 1, alongV: 1 } });
    cloth.position = Array.from({ length: 20 }, (_, i) => [i % 5 / 4, Math.floor(i / 5) / 3, 0]);
    cloth.colliders = 1;
    cloth.loads = true;
    return cloth;
  },
  water: () => {
    const pool = new Water({ nx: 5, ny: 4, dx: 1, dy: 2, depth: 1 });
    pool.hulls = { count: 1, nAlong: 1, nAcross: 1 };
    pool.setDisc(0, 1, 1);
    return pool;
  },
};

/** Makes objects until the memory has had to grow: what is larger than one makes it grow again. */
function useUp() {
  const before = memory.buffer.byteLength;
  const made = [];
  while (memory.buffer.byteLength === before) made.push(new Water({ nx: 100, ny: 100, dx: 1, dy: 1 }));
  return made;
}

// ---- the whole API ----

test("the scenes of bindings/conformance give the same hashes", async () => {
  await import("./conformance.mjs");
});

test("the version is that of api.json and package.json", async () => {
  const { version } = JSON.parse(await readFile(`${folder}/package.json`, "utf8"));
  assert.equal(contdyn.VERSION, api.version);
  assert.equal(contdyn.versionString(), api.version);
  assert.equal(version, api.version);
  assert.equal(contdyn.version(), api.macros.reduce((sum, { value }) => sum * 1000 + value, 0));
  assert.match(contdyn.buildInfo(), /WebAssembly|wasm/i);
  assert.equal(contdyn.runnableKernels(), 1);
  const water = new contdyn.Water({ nx: 5, ny: 3, dx: 1, dy: 1, precision: "float32" });
  const shape = { kind: "water", first: 5, second: 3, components: 1, precision: "float32" };
  assert.deepEqual(contdyn.savedShape(water.save()), shape);
  water.dispose();
});

test("enumerations have api.json's names and values, and nothing inherited", () => {
  for (const { name, values } of api.enums) {
    const table = contdyn[name.slice(3).split("_").map((part) => part[0].toUpperCase() + part.slice(1)).join("")];
    assert.deepEqual({ ...table }, Object.fromEntries(values.map(({ short, value }) => [camel(short), value])));
    assert(Object.isFrozen(table) && !("toString" in table));
  }
  assert.equal(contdyn.statusName("errorValue"), "CD_ERROR_VALUE");
});

test("every property takes what it reads", () => {
  for (const [name, make] of Object.entries(makers)) {
    const object = make();
    for (const { short, object: of } of api.functions) {
      const key = camel(short.slice(4));
      const property = Object.getOwnPropertyDescriptor(kinds[name].prototype, key);
      if (of !== name || !short.startsWith("get_") || !property?.get) continue;
      const value = object[key];
      assert.notEqual(value, undefined, `${name}.${key}`);
      if (property.set) object[key] = value;
      assert.deepEqual(object[key], value, `${name}.${key}`);
    }
  }
});

const kNumbers = { lambda: 0.5, tolerance: 0.01, dt: 0.01, indexSize: 4, stride: 64, positionOffset: 0,
  normalOffset: 12, depthOffset: null, nX: 1, nY: 1, mostIterations: 5 };

/** How many numbers describe a hull's pose and motion, and its one plate. */
const kCounts = { get_hull: 1, set_hull: 1, set_hull_pose: 7, get_hull_pose: 7, get_hull_floor: 7,
  set_hull_velocity: 6, get_hull_velocity: 6, set_hull_force: 6, get_hull_force: 6, get_hull_load: 6 };

/** Arguments that a function of api.json takes, as far as its parameters tell. */
function arguments_of({ parameters, short }, object, other) {
  const components = object.shape.components ?? 2;
  return parameters.filter((p) => p.direction !== "out" || p.role === "bytes").flatMap((p) => {
    if (p.role === "length" && short.startsWith("get_hull")) return [kCounts[short]];
    if (p.role === "self" || p.role === "length" || p.role === "callbacks") return [];
    if (p.role === "handle") return [other];
    if (p.role === "bytes") return [new Uint8Array(1 << 14)];
    if (p.role === "array") {
      if (p.times === p.length) return [Array.from({ length: components }, (_, i) => Array.from({ length: components },
        (_, j) => Number(i === j)))];
      return [new Float64Array(p.length === "n" ? p.times : kCounts[short] ?? components).fill(1)];
    }
    if (p.base === "cd_field") return [object instanceof Water ? "source" : "force"];
    if (p.base.startsWith("cd_")) return [camel(api.enums.find(({ name }) => name === p.base).values[0].short)];
    if (p.base === "int32_t") return [false];
    return [camel(p.name) in kNumbers ? kNumbers[camel(p.name)] : (p.base === "double" ? 1 : 0)];
  });
}

test("every method can be called", () => {
  for (const [name, make] of Object.entries(makers)) {
    for (const f of api.functions) {
      const key = camel(f.short);
      if (f.object !== name || /^(readF|writeF|view$|load$|stableDt$)/.test(key)) continue;
      const method = kinds[name].prototype[key === "create" ? "step" : key === "destroy" ? "dispose" : key];
      if (typeof method !== "function" || calls.get(f.name) > 0) continue;
      const object = make();
      object[key](...arguments_of(f, object, make()));
    }
  }
  assert(new Chain({ strands: 1, springs: 3, components: 1 }).stableDt() > 0);
  assert(makers.water().stableDt() > 0);
  for (const name of ["chain", "membrane"]) assert.equal(makers[name]().getColliderLoad(0).length, 6);
  assert(new Membrane({ nu: 3, nv: 3, components: 1 }).stableDt() > 0);
});

// ---- objects ----

test("options make an object and set its properties in their order", () => {
  const rope = new Chain({ strands: 1, springs: 2, components: 2, precision: "float32", restLength: 1,
    stiffness: Infinity, gravity: [0, -9.81], position: [[0, 0], [0.5, 0], [1, 0]] });
  assert.deepEqual(rope.shape, { strands: 1, springs: 2, components: 2, precision: "float32" });
  assert.equal(rope.stiffness, Infinity);
  assert.deepEqual(rope.read("position"), new Float32Array([0, 0, 0.5, 0, 1, 0]));
  refused("errorValue", /new Chain: the option springs is missing/, () => new Chain({ strands: 1, components: 2 }));
  refused("errorValue", /no option stifness/, () => new Chain({ strands: 1, springs: 1, components: 2, stifness: 2 }));
  refused("errorValue", /no option shape/, () => new Chain({ strands: 1, springs: 1, components: 2, shape: {} }));
  refused("errorValue", /components is 5/, () => new Chain({ strands: 1, springs: 1, components: 5 }));
  refused("errorValue", /must be an object/, () => new Water());
});

test("a property of several numbers keeps those that are left out", () => {
  const sheet = new Membrane({ nu: 3, nv: 3, components: 3 });
  sheet.stiffness = { alongU: 3, alongV: 4 };
  sheet.stiffness = { alongV: 5 };
  assert.deepEqual(sheet.stiffness, { alongU: 3, alongV: 5 });
  refused("errorValue", /alongW is none of alongU, alongV/, () => { sheet.stiffness = { alongW: 5 }; });
  refused("errorValue", /must be an object/, () => { sheet.stiffness = 5; });
});

test("errors carry the library's message and status", () => {
  const rope = makers.chain();
  refused("errorValue", /^cd_chain_set_mass: mass is -1/, () => { rope.mass = -1; });
  refused("errorRange", /^cd_chain_impulse: /, () => rope.impulse(0, 9, [0, 0, 1]));
  refused("errorDisabled", /^cd_chain_read_f64: /, () => rope.read("force"));
  refused("errorUnsupported", /^cd_chain_set_lambda|^cd_chain_step/, () => {
    rope.lambda = 0.25;
    rope.step(0.01);
  });
});

test("what C's types do not hold is refused, never cut short", () => {
  const rope = makers.chain();
  const before = rope.hash();
  for (const count of [-1, 1.5, 2 ** 32, NaN, "1", null]) {
    refused("errorRange", /count is .*must be an integer/, () => rope.step(0.01, count));
  }
  refused("errorValue", /mass is "2", must be a number/, () => { rope.mass = "2"; });
  refused("errorValue", /ring is 1, must be true or false/, () => { rope.ring = 1; });
  refused("errorValue", /number 1 is "2"/, () => { rope.gravity = [0, "2", 0]; });
  refused("errorValue", /gravity is a BigInt64Array, must be an array of numbers/, () => {
    rope.gravity = new BigInt64Array(3);
  });
  refused("errorRange", /range's first is 100, must be at most 4/, () => rope.read("position", { first: 100 }));
  refused("errorEnum", /method is "euler", must be one of "implicit"/, () => { rope.method = "euler"; });
  refused("errorEnum", /kind is 1, must be one of/, () => rope.setEnd("first", Node.pinned));
  refused("errorEnum", /field is "depth", a chain has position/, () => rope.read("depth"));
  refused("errorRange", /cd_chain_set_gravity: /, () => { rope.gravity = [1, 2]; });
  refused("errorRange", /normal has 2 numbers, must be 3/, () => rope.setPlane(0, [0, 0, 0], [0, 1]));
  refused("errorRange", /at has 3 numbers, must be a multiple of 2/, () => makers.water().sample([1, 2, 3]));
  refused("errorHandle", /source is an object, must be a Chain/, () => rope.copyState(makers.water()));
  refused("errorHandle", /source is null/, () => rope.copyState(null));
  assert.equal(rope.hash(), before);
});

test("a property that there is none of cannot be set, but by a class that extends one of these", () => {
  for (const make of Object.values(makers)) assert.throws(() => { make().misspelt = 1; }, TypeError);
  class Named extends Chain {
    name = "rope";
  }
  assert.equal(new Named({ strands: 1, springs: 2, components: 2 }).name, "rope");
});

test("a disposed object refuses every call", () => {
  const rope = makers.chain();
  const { position } = rope;
  assert(position.values.length > 0);
  assert.equal(rope.disposed, false);
  rope.dispose();
  rope.dispose();
  assert.equal(rope.disposed, true);
  refused("errorHandle", /this Chain has been disposed of/, () => rope.mass);
  refused("errorHandle", /disposed/, () => rope.step(0.01));
  refused("errorHandle", /disposed/, () => position.values);
  refused("errorHandle", /disposed/, () => makers.chain().copyState(rope));
  refused("errorHandle", /must be a Chain/, () => Chain.prototype.step.call(makers.water(), 0.01));
  refused("errorHandle", /must be a Chain/, () => Chain.prototype.step.call({}, 0.01));
});

test("Symbol.dispose disposes", { skip: !Symbol.dispose }, () => {
  const rope = makers.chain();
  rope[Symbol.dispose]();
  assert(rope.disposed);
});

test("memory goes back: by dispose, by the garbage collector, and when options are refused", async () => {
  const options = { nx: 400, ny: 400, dx: 1, dy: 1 };
  for (let i = 0; i < 5; ++i) new Water(options).dispose();
  const before = memory.buffer.byteLength;
  for (let i = 0; i < 50; ++i) new Water(options).dispose();
  assert.equal(memory.buffer.byteLength, before);
  for (let i = 0; i < 50; ++i) refused("errorValue", /gravity/, () => new Water({ ...options, gravity: -1 }));
  assert.equal(memory.buffer.byteLength, before);
  const collect = async (enough = Infinity) => { // what is collected is told later, on a busy machine much later
    for (let i = 0; i < (enough < Infinity ? 2000 : 10) && calls.get("cd_water_destroy") < enough; ++i) {
      globalThis.gc();
      await new Promise((done) => setTimeout(done, 10));
    }
    return calls.get("cd_water_destroy");
  };
  const destroyed = await collect();
  for (let i = 0; i < 20; ++i) new Water(options);
  assert.equal(await collect(destroyed + 20), destroyed + 20);
});

// ---- numbers ----

test("fields are written and read as arrays of either precision, nested rows, one number, and in part", () => {
  const pool = makers.water();
  pool.write("bed", Float32Array.of(0.1, 0.2), { firstX: 1, firstY: 2, nX: 2, nY: 1 });
  assert.deepEqual([...pool.read("bed", { firstY: 2, nY: 1 })], [0, Math.fround(0.1), Math.fround(0.2), 0, 0]);
  const out = new Float32Array(20);
  assert.equal(pool.read("depth", undefined, out), out);
  assert.deepEqual(out, new Float32Array(20).fill(1));
  assert.equal(pool.read("velocityX").length, 24);
  assert.equal(pool.read("velocityY").length, 25);
  pool.depth = 2;
  assert.equal(pool.volume, 80);
  refused("errorRange", /cd_water_write_f64/, () => pool.write("depth", [1, 2, 3]));
  refused("errorRange", /cd_water_read_f64/, () => pool.read("depth", {}, new Float64Array(3)));
  refused("errorRange", /firstX is -1/, () => pool.read("depth", { firstX: -1 }));
  refused("errorValue", /range's first is none of firstX/, () => pool.read("depth", { first: 1 }));
  refused("errorValue", /range is 1, must be an object with some of firstX/, () => pool.write("depth", 2, 1));
  assert.throws(() => { pool.depth[0] = 1; }, TypeError);
  refused("errorValue", /out is an object/, () => pool.read("depth", {}, []));
  const rope = makers.chain();
  assert.equal(rope.read("pin").length, 8); // per strand in ropes
  assert.equal(new Chain({ strands: 2, springs: 3, components: 3 }).read("pin").length, 4);
  const ring = new Chain({ strands: 2, springs: 3, components: 2, ring: true });
  ring.enableField("stiffness");
  assert.equal(ring.read("stiffness").length, 4);
  const tube = new Membrane({ nu: 3, nv: 4, components: 3, ring: { alongU: true, alongV: false } });
  tube.enableField("stiffnessU");
  tube.enableField("stiffnessV");
  assert.deepEqual([tube.read("stiffnessU").length, tube.read("stiffnessV").length], [20, 16]);
});

test("views show the state through steps and the memory's growth, or fail", () => {
  const rope = makers.chain();
  const view = rope.position;
  assert.deepEqual(view.shape, [2, 4, 3]);
  const old = view.values;
  const same = () => {
    const dense = rope.read("position");
    for (let s = 0; s < 2; ++s) {
      for (let n = 0; n < 4; ++n) {
        for (let c = 0; c < 3; ++c) assert.equal(view.at(s, n, c), dense[(s * 4 + n) * 3 + c]);
      }
    }
  };
  same();
  rope.step(0.01, 3);
  assert.equal(view.values, old);
  same();
  const other = makers.chain();
  other.position = view;
  other.velocity = rope.velocity;
  other.write("tension", rope.read("tension"));
  assert.deepEqual([other.position.dense(), other.read("velocity")], [rope.read("position"), rope.read("velocity")]);
  const made = useUp();
  assert.equal(old.length, 0); // detached: reads undefined
  same();
  for (const object of made) object.dispose();
  rope.enableField("force");
  const force = rope.view("force");
  assert.equal(force.at(1, 1, 1), 0);
  rope.disableField("force");
  refused("errorDisabled", /cd_chain_view/, () => force.values);
  refused("errorUnsupported", /cd_chain_view/, () => rope.view("pin"));
  refused("errorRange", /index 4 is outside/, () => view.at(0, 4, 0));
  const cloth = makers.membrane();
  assert.deepEqual(cloth.position.shape, [4, 5, 3]);
  assert.equal(cloth.position.at(3, 1, 0), 0.25);
  assert.deepEqual(cloth.read("position", { nU: 1, firstV: 3 }, new Float32Array(3)), Float32Array.of(0, 1, 0));
  const pool = new Water({ nx: 3, ny: 2, dx: 1, dy: 1, precision: "float32", depth: [[1, 2, 3], [4, 5, 6]] });
  assert.deepEqual(pool.depth.shape, [2, 3]);
  assert(pool.depth.values instanceof Float32Array);
  assert.equal(pool.depth.at(1, 0), 4);
  assert.deepEqual(pool.velocityX.shape, [2, 4]);
});

test("a write takes what a view shows, even if the memory has to grow for it", () => {
  const nx = 1500;
  const from = new Chain({ strands: 1, springs: nx * nx - 1, components: 1, precision: "float32" });
  const into = new Chain({ strands: 1, springs: nx * nx - 1, components: 1, precision: "float32" });
  from.write("position", 1);
  from.gravity = [0]; // gives back what the last call had its arguments in
  const made = useUp();
  const { values } = from.position;
  assert.equal(values.length, nx * nx);
  const before = memory.buffer.byteLength;
  into.write("position", values);
  assert(memory.buffer.byteLength > before);
  assert.deepEqual(into.read("position", { first: nx * nx - 2 }), Float32Array.of(1, 1));
  for (const object of [from, into, ...made]) object.dispose();
});

test("a state is kept as bytes", () => {
  const rope = makers.chain();
  rope.step(0.01, 5);
  const bytes = rope.save();
  assert(bytes instanceof Uint8Array && bytes.length === rope.saveSize());
  const other = makers.chain();
  other.load(bytes);
  assert.equal(other.hash(), rope.hash());
  assert.equal(typeof rope.hash(), "bigint");
  assert.equal(other.steps, 5);
  const damaged = bytes.slice();
  damaged[40] ^= 1;
  refused("errorFormat", /cd_chain_load/, () => other.load(damaged));
  refused("errorMismatch", /cd_chain_load/, () => new Chain({ strands: 1, springs: 3, components: 3 }).load(bytes));
  refused("errorValue", /bytes is "x", must be a buffer/, () => other.load("x"));
  other.load(bytes.buffer);
  assert.equal(other.hash(), rope.hash());
});

test("vertices and indices go into the caller's buffers, and leave bytes between alone", () => {
  const cloth = makers.membrane();
  const vertices = new Float32Array(20 * 8).fill(7);
  cloth.writeVertices(vertices, 32, 0, 12);
  assert.deepEqual([...vertices.subarray(8, 16)], [0.25, 0, 0, 0, 0, 1, 7, 7]);
  cloth.writeVertices(vertices.fill(7), 32, 0, null);
  assert.equal(vertices[5], 7);
  const indices = new Uint16Array(cloth.indexCount);
  cloth.writeIndices(indices, 2);
  assert.equal(Math.max(...indices), 19);
  const pool = makers.water();
  const wet = new Uint32Array(pool.getIndexCount(true));
  pool.writeIndices(true, wet, 4);
  assert.equal(wet.length, 6 * 4 * 3);
});

test("several results come as an object", () => {
  const rope = makers.chain();
  assert.deepEqual(Object.keys(rope.energy), ["kinetic", "elastic", "gravity"]);
  rope.setCapsule(0, [0, 0, 0], [0, 0, 1], 0.25, 0.5);
  const { shape, first, second, radius, friction } = rope.getCollider(0);
  assert.deepEqual({ shape, first, second, radius, friction }, { shape: "capsule", first: Float64Array.of(0, 0, 0),
    second: Float64Array.of(0, 0, 1), radius: 0.25, friction: 0.5 });
  const pool = makers.water();
  const { surface, normal, velocity } = pool.sample([[1, 1], [2, 300]], "nearest");
  assert.deepEqual([surface, normal, velocity], [Float64Array.of(1, 1), Float64Array.of(0, 0, 1, 0, 0, 1),
    new Float64Array(4)]);
  pool.setSide("xFirst", "open", 2, 0.5);
  assert.deepEqual(pool.getSide("xFirst"), { kind: "open", value: 2, rate: 0.5 });
  pool.setInflowDepth("xFirst", 0.25);
  assert.equal(pool.getInflowDepth("xFirst"), 0.25);
  assert(pool.addVolume(2, 2, 2, 0.5) > 0.49);
  assert.equal(pool.account.initial, 40);
});

// ---- loading ----

test("loading twice is loading once; loading otherwise is refused", async () => {
  await contdyn.load();
  await assert.rejects(contdyn.load({ simd: build !== "simd" }), { status: "errorUnsupported" });
});

test("before it is loaded every call says so", async () => {
  const fresh = await import(new URL(`file://${folder}/runtime.mjs?fresh`));
  assert.throws(() => fresh.wasm.cd_version(), { status: "errorUnsupported", message: /await load\(\) first/ });
  await assert.rejects(fresh.load({ source: new Response("", { status: 404, statusText: "gone" }) }), /404 gone/);
  await assert.rejects(fresh.load({ source: new Uint8Array(8) }), WebAssembly.CompileError);
  const data = await readFile(`${folder}/contdyn.wasm`);
  await fresh.load({ source: new Response(data, { headers: { "content-type": "application/wasm" } }) });
  assert.equal(fresh.wasm.cd_version(), contdyn.version());
});

after(() => {
  const every = api.functions.filter(({ short, parameters }) => short === "create"
    || !parameters.some(({ role }) => role === "callbacks"));
  const never = every.map(({ name }) => name).filter((name) => !calls.get(name));
  if (never.length > 0) {
    console.log(`never called with success: ${never.join(", ")}`);
    process.exitCode = 1;
  }
});
