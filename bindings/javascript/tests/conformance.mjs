// The scenes of bindings/conformance: the same hashes as in every other language.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { build, camel, contdyn, kinds } from "./support.mjs";

const bindings = new URL("../../", import.meta.url);
const scenes = await readFile(new URL("conformance/scenes.txt", bindings), "utf8");
const api = JSON.parse(await readFile(new URL("api.json", bindings), "utf8"));

const names = new Map();
const numbers = new Map();
for (const { values } of api.enums) {
  for (const { name, short, value } of values) {
    names.set(name, camel(short));
    numbers.set(name, value);
  }
}
const functions = new Map(api.functions.map((f) => [`${f.object} ${f.short}`, f]));

/** Line and words of each statement; lines that begin with a space go on with it. */
function* statements() {
  let last = null;
  for (const [i, line] of scenes.split("\n").entries()) {
    if (line.startsWith(" ")) last.words.push(...line.trim().split(/\s+/));
    else if (line !== "" && !line.startsWith("#")) {
      if (last) yield last;
      last = { number: i + 1, words: line.split(" ") };
    }
  }
  yield last;
}

/** The words as this language has them: numbers, names, arrays, null. */
function taken(words, precision) {
  const values = [];
  let into = values;
  for (const word of words) {
    if (word === "[") into = [];
    else if (word === "]") {
      values.push(into);
      into = values;
    } else if (word === "null") into.push(null);
    else if (word === "precision") into.push(precision);
    else if (names.has(word)) into.push(into === values ? names.get(word) : numbers.get(word));
    else into.push(word === "INFINITY" ? Infinity : Number(word));
    assert(!Number.isNaN(into.at(-1)), word);
  }
  return values;
}

class Player {
  constructor(precision) {
    this.precision = precision;
  }

  create(name, words) {
    this.name = name;
    this.Kind = kinds[name];
    const create = functions.get(`${name} create`).parameters.filter((p) => p.role === "value");
    const values = taken(words, this.precision);
    this.options = Object.fromEntries(create.map((p, i) => [camel(p.name), values[i]]));
    this.object = new this.Kind(this.options);
  }

  again(fill) {
    const last = this.object;
    this.object = new this.Kind(this.options);
    fill(last);
    last.dispose();
  }

  call(name, words) {
    const { object } = this;
    const values = taken(words, this.precision);
    const { parameters } = functions.get(`${this.name} ${name}`);
    const inputs = parameters.filter((p) => p.direction !== "out" && ["value", "array"].includes(p.role));
    for (const [i, p] of inputs.entries()) if (p.base === "int32_t") values[i] = values[i] !== 0;
    if (name === "write_f32" || name === "write_f64") {
      const [field, ...place] = values;
      const array = name === "write_f32" ? new Float32Array(place.pop()) : place.pop();
      const range = inputs.slice(1, -1).map((p, i) => [camel(p.name), place[i]]);
      object.write(field, array, Object.fromEntries(range));
    } else if (camel(name) in object) object[camel(name)](...values);
    else {
      const property = camel(name.replace(/^set_/, ""));
      assert(property in object, `${this.name} has no ${property}`);
      object[property] = values.length === 1 ? values[0]
        : Object.fromEntries(inputs.map((p, i) => [camel(p.name), values[i]]));
    }
  }

  play([word, ...words]) {
    if (word === "create") this.create(words[0], words.slice(1));
    else if (word === "copy") this.again((last) => this.object.copyState(last));
    else if (word === "save_and_load") this.again((last) => this.object.load(last.save()));
    else if (word === "hash") assert.equal(this.object.hash(), BigInt(words[this.precision === "float32" ? 0 : 1]));
    else if (word === "refused") {
      const before = this.object.hash();
      assert.throws(() => this.call(words[1], words.slice(2)), { name: "ContdynError", status: names.get(words[0]) });
      if (words[0] !== "CD_ERROR_TOLERANCE" && words[0] !== "CD_ERROR_DIVERGED") {
        assert.equal(this.object.hash(), before);
      }
    } else this.call(word, words);
  }
}

let played = 0;
let hashes = 0;
for (const precision of Object.keys(contdyn.Precision)) {
  let player;
  for (const { number, words } of statements()) {
    try {
      if (words[0] === "scene") {
        player?.object.dispose();
        player = new Player(precision);
        played += 1;
      } else {
        player.play(words);
        hashes += words[0] === "hash";
      }
    } catch (error) {
      error.message = `scenes.txt:${number}: ${words.slice(0, 3).join(" ")}, ${precision}: ${error.message}`;
      throw error;
    }
  }
}
assert(played > 6 && hashes > 20);
console.log(`${played} scenes, ${hashes} hashes, ${build}`);
