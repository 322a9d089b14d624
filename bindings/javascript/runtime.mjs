// What contdyn.mjs, which is made from ../api.json, stands on: the library's loading, its memory, its objects' lives.

/** What a call of the library, or its binding, refused. `status` is a name of `Status`. */
export class ContdynError extends Error {
  constructor(status, message) {
    super(message);
    this.name = "ContdynError";
    this.status = status;
  }
}

const refuse = (status, message) => {
  throw new ContdynError(status, message);
};

// ---- enumerations ---------------------------------------------------------------------------------------------------

const names = new WeakMap();

/** Names and values of an enumeration, which nothing inherited is mistaken for. */
export function enumeration(values) {
  const table = Object.freeze(Object.assign(Object.create(null), values));
  names.set(table, new Map(Object.entries(table).map(([name, value]) => [value, name])));
  return table;
}

export function member(table, name, parameter) {
  const value = typeof name === "string" ? table[name] : undefined;
  if (value === undefined) {
    refuse("errorEnum", `${parameter} is ${shown(name)}, must be one of ${Object.keys(table).map(shown).join(", ")}`);
  }
  return value;
}

export const nameOf = (table, value) => names.get(table).get(value);

// ---- loading --------------------------------------------------------------------------------------------------------

/** The library's functions; until `load` is done nothing but an error. */
export let wasm = new Proxy({}, {
  get: () => refuse("errorUnsupported", "the library is not loaded: await load() first"),
});
let loading = null;
let loaded = null;
let statuses;
let out; // where calls leave their results: 16 of up to 8 bytes
let scratch; // the first block of memory for arguments
const kOut = 128;
const kScratch = 1 << 16;

// A function of one instruction of SIMD128, i8x16.splat: only engines that have these instructions take it.
const kSimdProbe = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65,
  0, 253, 15, 11]);

/** Loads the library, once; awaited again it does nothing more. */
export function load(options = {}) {
  if (loading) {
    for (const [name, value] of Object.entries(options)) {
      if (value !== loaded[name]) {
        const message = `the library is loaded already, with another ${name}`;
        return Promise.reject(new ContdynError("errorUnsupported", message));
      }
    }
    return loading;
  }
  loaded = options;
  loading = instantiate(options).then((exports) => beginWith(exports));
  loading.catch(() => (loading = loaded = null));
  return loading;
}

async function instantiate({ simd = WebAssembly.validate(kSimdProbe), source }) {
  const file = source ?? (simd ? new URL("./contdyn-simd.wasm", import.meta.url)
    : new URL("./contdyn.wasm", import.meta.url));
  // The library does nothing outside of its memory; its C library's printf names a system's files all the same.
  const imports = { wasi_snapshot_preview1: new Proxy({}, { get: () => () => 8, has: () => true }) };
  const made = await resolved(await file, imports);
  const { exports } = made.instance ?? made;
  exports._initialize?.();
  return exports;
}

async function resolved(file, imports) {
  if (file instanceof WebAssembly.Module || file instanceof ArrayBuffer || ArrayBuffer.isView(file)) {
    return WebAssembly.instantiate(file, imports);
  }
  if (typeof Response === "function" && file instanceof Response) return streamed(file, imports);
  const base = globalThis.location?.href ?? import.meta.url;
  const url = file instanceof URL ? file : new URL(file, base);
  if (url.protocol !== "file:") return streamed(await fetch(url), imports);
  const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ "node:fs/promises");
  return WebAssembly.instantiate(await readFile(url), imports);
}

async function streamed(response, imports) {
  if (!response.ok) refuse("errorUnsupported", `${response.url}: ${response.status} ${response.statusText}`);
  const typed = response.headers.get("content-type")?.startsWith("application/wasm");
  return typed && WebAssembly.instantiateStreaming ? WebAssembly.instantiateStreaming(response, imports)
    : WebAssembly.instantiate(await response.arrayBuffer(), imports);
}

function beginWith(exports) {
  wasm = exports;
  out = wasm.malloc(kOut);
  scratch = { address: wasm.malloc(kScratch), size: kScratch };
}

/** Called by contdyn.mjs, which knows the enumeration. */
export function knowStatuses(table) {
  statuses = table;
}

// ---- memory ---------------------------------------------------------------------------------------------------------

// The memory's buffer is another one whenever it has grown; what showed the old one is then empty.
let data = new DataView(new ArrayBuffer(0));
const memory = () => {
  if (data.buffer !== wasm.memory.buffer) data = new DataView(wasm.memory.buffer);
  return data;
};

let used = 0;
let blocks = []; // what did not fit into scratch

/** Begins a call's arguments: those of the last call are gone. */
export function begin() {
  used = 0;
  if (blocks.length > 0) {
    for (const block of blocks) wasm.free(block);
    blocks = [];
  }
}

/** Room for a call's arguments. */
export function take(bytes) {
  if (used + bytes <= scratch.size) {
    const address = scratch.address + used;
    used += (bytes + 15) & ~15;
    return address;
  }
  const block = bytes < 2 ** 32 ? wasm.malloc(bytes) : 0;
  if (block === 0) refuse("errorMemory", `no memory for ${bytes} bytes of arguments`);
  blocks.push(block);
  return block >>> 0;
}

/** Numbers as a typed array or a flat array; nested arrays are rows. */
function flat(values, parameter) {
  if (values instanceof View) return values.dense();
  if (values instanceof BigInt64Array || values instanceof BigUint64Array) {
    refuse("errorValue", `${parameter} is a ${values.constructor.name}, must be an array of numbers`);
  }
  if (ArrayBuffer.isView(values) && !(values instanceof DataView)) return values;
  if (!Array.isArray(values)) refuse("errorValue", `${parameter} is ${shown(values)}, must be an array of numbers`);
  const numbers = values.some(Array.isArray) ? values.flat(Infinity) : values;
  const wrong = numbers.findIndex((value) => typeof value !== "number");
  if (wrong >= 0) refuse("errorValue", `${parameter}: number ${wrong} is ${shown(numbers[wrong])}`);
  return numbers;
}

const nothing = { address: 0, length: 0 };

/** Copies numbers into the library's memory. */
export function put(values, Kind, parameter, optional) {
  if (optional && values == null) return nothing;
  return putFlat(flat(values, parameter), Kind);
}

function putFlat(numbers, Kind) {
  const { length } = numbers;
  if (numbers.buffer === wasm.memory.buffer) numbers = numbers.slice(); // room for it may move it
  const address = take(length * Kind.BYTES_PER_ELEMENT);
  new Kind(wasm.memory.buffer, address, length).set(numbers);
  return { address, length };
}

/** Copies bytes into the library's memory. */
export function putBytes(values, parameter) {
  const bytes = bytesOf(values, parameter);
  return putFlat(bytes, Uint8Array);
}

/** Copies bytes that a call has written to where the caller has them. */
export function getBytes(values, { address, length }) {
  bytesOf(values).set(new Uint8Array(wasm.memory.buffer, address, length));
}

function bytesOf(values, parameter) {
  if (values instanceof ArrayBuffer) return new Uint8Array(values);
  if (!ArrayBuffer.isView(values)) refuse("errorValue", `${parameter} is ${shown(values)}, must be a buffer`);
  return new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
}

/** A copy of numbers from the library's memory. */
export const got = (address, Kind, length) => new Kind(wasm.memory.buffer, address, length).slice();

/** How many items of `times` numbers an array has. */
export function items({ length }, times, parameter) {
  if (length % times !== 0) refuse("errorRange", `${parameter} has ${length} numbers, must be a multiple of ${times}`);
  return length / times;
}

/** An array must have as many numbers as the others of its call ask for. */
export function expect(array, length, parameter) {
  if (array !== nothing && array.length !== length) {
    refuse("errorRange", `${parameter} has ${array.length} numbers, must be ${length}`);
  }
}

// ---- numbers --------------------------------------------------------------------------------------------------------

const shown = (value) => (typeof value === "string" ? JSON.stringify(value) : typeof value === "bigint" ? `${value}n`
  : typeof value === "object" && value !== null ? "an object" : String(value));

export function number(value, parameter) {
  if (typeof value !== "number") refuse("errorValue", `${parameter} is ${shown(value)}, must be a number`);
  return value;
}

export function size(value, parameter) {
  if (!Number.isInteger(value) || value < 0 || value > 0xffffffff) {
    refuse("errorRange", `${parameter} is ${shown(value)}, must be an integer from 0 to 4294967295`);
  }
  return value;
}

/** null stands for SIZE_MAX. */
export const sizeOrNone = (value, parameter) => (value === null ? 0xffffffff : size(value, parameter));

export function flag(value, parameter) {
  if (typeof value !== "boolean") refuse("errorValue", `${parameter} is ${shown(value)}, must be true or false`);
  return value ? 1 : 0;
}

/** Where result number k of a call is written. */
export const result = (k) => out + 8 * k;
export const real = (k) => memory().getFloat64(out + 8 * k, true);
export const integer = (k) => memory().getInt32(out + 8 * k, true);
export const whole = (k) => memory().getUint32(out + 8 * k, true);
export const count = (k) => Number(memory().getBigUint64(out + 8 * k, true));
export const bits = (k) => memory().getBigUint64(out + 8 * k, true);

/** A text of the library. */
export function text(address) {
  const bytes = new Uint8Array(wasm.memory.buffer, address);
  return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
}

/** Throws what a call that failed says. */
export function check(status) {
  if (status !== 0) refuse(nameOf(statuses, status), text(wasm.cd_error_message()));
}

// ---- objects --------------------------------------------------------------------------------------------------------

const forgotten = typeof FinalizationRegistry === "function"
  ? new FinalizationRegistry(({ destroy, address }) => destroy(address)) : null;

/** Owns an object of the library. */
export class Handle {
  #address;
  #destroy;
  #components;

  /** What `create` left as result 0 is owned from here on. */
  constructor(destroy, components) {
    this.#address = whole(0);
    this.#destroy = destroy;
    this.#components = components;
    forgotten?.register(this, { destroy, address: this.#address }, this);
  }

  /** Releases the object: every call on it throws from now on. Again does nothing. */
  dispose() {
    if (this.#address === 0) return;
    forgotten?.unregister(this);
    this.#destroy(this.#address);
    this.#address = 0;
  }

  get disposed() {
    return this.#address === 0;
  }

  static addressOf(object, Class, parameter) {
    if (typeof object !== "object" || object === null || !(#address in object) || !(object instanceof Class)) {
      refuse("errorHandle", `${parameter} is ${shown(object)}, must be a ${Class.name}`);
    }
    if (object.#address === 0) refuse("errorHandle", `this ${object.constructor.name} has been disposed of`);
    return object.#address;
  }

  static componentsOf(object) {
    return object.#components;
  }
}
if (Symbol.dispose) Handle.prototype[Symbol.dispose] = Handle.prototype.dispose;

export const addressOf = Handle.addressOf;
export const componentsOf = Handle.componentsOf;

/** Options of a constructor, of which `needed` must be there. */
export function optionsOf(options, name, needed) {
  if (typeof options !== "object" || options === null) {
    refuse("errorValue", `new ${name}: options are ${shown(options)}, must be an object`);
  }
  for (const key of needed) {
    if (options[key] === undefined) refuse("errorValue", `new ${name}: the option ${key} is missing`);
  }
  return options;
}

/** Options beyond those that an object is made with are properties, set in their order. */
export function assign(object, options, madeWith) {
  try {
    for (const [key, value] of Object.entries(options)) if (!madeWith.includes(key)) assignOne(object, key, value);
  } catch (error) {
    object.dispose();
    throw error;
  }
}

function assignOne(object, key, value) {
  const property = Object.getOwnPropertyDescriptor(Object.getPrototypeOf(object), key)
    ?? Object.getOwnPropertyDescriptor(object.constructor.prototype, key);
  if (!property?.set) refuse("errorValue", `new ${object.constructor.name}: there is no option ${key}`);
  object[key] = value;
}

/** A property of several numbers is set as an object; what it leaves out stays as it is. */
export function several(value, present, parameter, known) {
  if (typeof value !== "object" || value === null) {
    refuse("errorValue", `${parameter} is ${shown(value)}, must be an object with ${known.join(", ")}`);
  }
  for (const key of Object.keys(value)) {
    if (!known.includes(key)) refuse("errorValue", `${parameter}.${key} is none of ${known.join(", ")}`);
  }
  return known.every((key) => key in value) ? value : { ...present(), ...value };
}

// ---- fields ---------------------------------------------------------------------------------------------------------

// How many places a field has along the two directions of each kind of object, in the order of the C functions' ranges.
const kExtents = {
  chain(object, { per, ownInRopes }) {
    const { strands, springs } = object.shape;
    const own = per.includes("strand") && (!ownInRopes || object.restLength > 0);
    return [own ? strands : 1, springs + Number(per.includes("spring") ? object.ring : 1)];
  },
  membrane(object, { per }, field) {
    const { nu, nv } = object.shape;
    const ring = per.includes("spring") ? object.ring : {};
    return [nu + Number(field.endsWith("U") ? ring.alongU : 1), nv + Number(field.endsWith("V") ? ring.alongV : 1)];
  },
  water(object, { per }) {
    const { nx, ny } = object.shape;
    return [nx + Number(per.includes("x-face")), ny + Number(per.includes("y-face"))];
  },
};

const known = (kind, field) => kind.fields[field]
  ?? refuse("errorEnum", `field is ${shown(field)}, a ${kind.name} has ${Object.keys(kind.fields).join(", ")}`);

/** The arguments of a range that the caller gave parts of: whatever is left out is all the rest. */
function placeOf(object, kind, field, range) {
  const extents = kExtents[kind.name](object, known(kind, field), field);
  if (range === null || typeof range !== "object") {
    refuse("errorValue", `the range is ${range}, must be an object with some of ${kind.range.join(", ")}`);
  }
  for (const key of Object.keys(range)) {
    if (!kind.range.includes(key)) refuse("errorValue", `the range's ${key} is none of ${kind.range.join(", ")}`);
  }
  const starts = kind.range.filter((key) => key.startsWith("first"));
  const counts = kind.range.filter((key) => !key.startsWith("first"));
  const place = {};
  starts.forEach((start, i) => {
    place[start] = size(range[start] ?? 0, start);
    if (place[start] > extents[i]) {
      refuse("errorRange", `the range's ${start} is ${place[start]}, must be at most ${extents[i]}`);
    }
    place[counts[i]] = size(range[counts[i]] ?? Math.max(0, extents[i] - place[start]), counts[i]);
  });
  const values = counts.reduce((product, key) => product * place[key], 1);
  return { place: kind.range.map((key) => place[key]), values: values * componentsIn(object, kind, field) };
}

const componentsIn = (object, kind, field) => (kind.fields[field].components ? componentsOf(object) : 1);

const suffixOf = (Kind) => (Kind === Float32Array ? "f32" : "f64");

export function readField(object, kind, field, range = {}, target) {
  const address = addressOf(object, kind.Class);
  const { place, values } = placeOf(object, kind, field, range);
  if (target && !(target instanceof Float32Array || target instanceof Float64Array)) {
    refuse("errorValue", `out is ${shown(target)}, must be a Float32Array or a Float64Array`);
  }
  const Kind = target ? target.constructor : kindOf(object);
  const length = target ? target.length : values;
  begin();
  const room = take(length * Kind.BYTES_PER_ELEMENT);
  check(wasm[`cd_${kind.name}_read_${suffixOf(Kind)}`](address, kind.Field[field], ...place, room, length));
  if (!target) return got(room, Kind, length);
  target.set(new Kind(wasm.memory.buffer, room, length));
  return target;
}

export function writeField(object, kind, field, values, range = {}) {
  const address = addressOf(object, kind.Class);
  const { place, values: length } = placeOf(object, kind, field, range);
  if (typeof values === "number") values = new Float64Array(length).fill(values);
  const numbers = flat(values, "values");
  const Kind = numbers instanceof Float32Array ? Float32Array : Float64Array;
  begin();
  const { address: from, length: given } = putFlat(numbers, Kind);
  check(wasm[`cd_${kind.name}_write_${suffixOf(Kind)}`](address, kind.Field[field], ...place, from, given));
}

const kindOf = (object) => (object.shape.precision === "float32" ? Float32Array : Float64Array);

/** A field in the library's memory, for as long as the object has it. */
class View {
  #object;
  #kind;
  #field;
  #Kind;
  #values = null;

  constructor(object, kind, field) {
    this.#object = object;
    this.#kind = kind;
    this.#field = field;
    this.#Kind = kindOf(object);
    const extents = kExtents[kind.name](object, kind.fields[field], field);
    this.#seek();
    const steps = extents.map((_, i) => whole(i + 1));
    const directions = kind.reversed ? [1, 0] : [0, 1]; // as read orders them
    const inner = kind.fields[field].components ? [componentsOf(object)] : [];
    this.shape = Object.freeze([...directions.map((i) => extents[i]), ...inner]);
    this.strides = Object.freeze([...directions.map((i) => steps[i]), ...inner.map(() => whole(3))]
      .map((stride) => stride / this.#Kind.BYTES_PER_ELEMENT));
    Object.freeze(this); // its numbers are in values
  }

  /** Where the field is; its strides are results 1 to 3. */
  #seek() {
    const { name, Class, Field } = this.#kind;
    const address = addressOf(this.#object, Class);
    check(wasm[`cd_${name}_view`](address, Field[this.#field], result(0), result(1), result(2), result(3)));
    return whole(0);
  }

  get values() {
    const address = this.#seek();
    const shown = this.#values;
    if (shown?.buffer === wasm.memory.buffer && shown.byteOffset === address) return shown;
    const length = this.shape.reduce((last, extent, i) => last + (extent - 1) * this.strides[i], 1);
    return (this.#values = new this.#Kind(wasm.memory.buffer, address, length));
  }

  /** A copy, in the order of `read`. */
  dense() {
    const { values, shape, strides } = this;
    const copied = new this.#Kind(shape.reduce((product, extent) => product * extent, 1));
    let k = 0;
    const copy = (dimension, at) => {
      if (dimension === shape.length) copied[k++] = values[at];
      else for (let i = 0; i < shape[dimension]; ++i) copy(dimension + 1, at + i * strides[dimension]);
    };
    copy(0, 0);
    return copied;
  }

  at(...place) {
    const at = place.reduce((sum, i, d) => {
      if (!(i >= 0 && i < this.shape[d])) refuse("errorRange", `index ${i} is outside of [0, ${this.shape[d]})`);
      return sum + i * this.strides[d];
    }, 0);
    return this.values[at];
  }
}

export function viewField(object, kind, field) {
  known(kind, field);
  return new View(object, kind, field);
}
