// What calls and steps cost: node step.mjs PACKAGE simd|plain, the least of many rounds.
import { pathToFileURL } from "node:url";

const [folder, build] = process.argv.slice(2);
const { Chain, Membrane, Water, load } = await import(pathToFileURL(`${folder}/contdyn.mjs`));
await load({ simd: build === "simd" });

function least(run, calls, rounds = 40) {
  let best = Infinity;
  for (let round = 0; round < rounds; ++round) {
    const start = performance.now();
    for (let i = 0; i < calls; ++i) run();
    best = Math.min(best, (performance.now() - start) / calls);
  }
  return best * 1000;
}
const print = (name, microseconds) => console.log(`${name.padEnd(52)} ${microseconds.toFixed(3).padStart(10)} us`);

const small = new Chain({ strands: 1, springs: 10, components: 3, mass: 1, stiffness: 10 });
const values = new Float64Array(33);
print("get a number: chain.mass", least(() => small.mass, 20000));
print("set a number: chain.mass = 1", least(() => { small.mass = 1; }, 20000));
print("set gravity, an array of 3", least(() => { small.gravity = values.subarray(0, 3); }, 5000));
print("read positions of 11 nodes into an array", least(() => small.read("position", undefined, values), 5000));
const { position } = small;
print("position.values, without a copy", least(() => position.values, 20000));
print("chain, 11 nodes, 3 components: step", least(() => small.step(0.01), 5000));

const nodes = Float64Array.from({ length: 1001 * 3 }, (_, i) => (i % 3 === 0 ? i / 3003 : 0));
const chain = new Chain({ strands: 1, springs: 1000, components: 3, stiffness: 1e4, position: nodes });
chain.setEnd("first", "pinned");
chain.gravity = [0, -9.81, 0];
print("chain, 1001 nodes: step", least(() => chain.step(0.01), 100));
const rope = new Chain({ strands: 16, springs: 40, components: 3, restLength: 1, stiffness: Infinity,
  gravity: [0, -9.81, 0] });
rope.position = Float64Array.from({ length: 16 * 41 * 3 }, (_, i) => (i % 3 === 0 ? (i / 3 % 41) / 40 : 0));
rope.setEnd("first", "pinned");
print("rope, 16 strands of 41 nodes: step", least(() => rope.step(1 / 60), 5));
const drum = new Membrane({ nu: 64, nv: 64, components: 1, stiffness: { alongU: 100, alongV: 100 } });
for (const edge of ["uFirst", "uLast", "vFirst", "vLast"]) drum.setEdge(edge, "pinned");
drum.impulse(20, 20, 6, [1]);
print("drum, 65 x 65 nodes: step", least(() => drum.step(0.01), 20));
const cloth = new Membrane({ nu: 24, nv: 24, components: 3, stiffness: { alongU: 1e4, alongV: 1e4 },
  position: Float64Array.from({ length: 625 * 3 }, (_, i) => [(i / 3 | 0) % 25 / 24, (i / 75 | 0) / 24, 0][i % 3]) });
cloth.restLength = { alongU: 1, alongV: 1 };
cloth.gravity = [0, -9.81, 0];
cloth.setEdge("vLast", "pinned");
print("cloth, 25 x 25 nodes: step", least(() => cloth.step(1 / 60), 5));
for (const [nx, momentum] of [[128, "linear"], [256, "linear"], [256, "advected"]]) {
  const pool = new Water({ nx, ny: nx, dx: 0.1, dy: 0.1, precision: "float32", momentum, depth: 1 });
  pool.splash(nx * 0.03, nx * 0.04, 1, 0.5);
  print(`water, ${nx} x ${nx} cells, ${momentum}: step`, least(() => pool.step(1 / 60), 1, 30));
}
