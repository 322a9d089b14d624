// Compiled, not run: what users write, and what the types refuse.
import { Chain, ContdynError, load, Membrane, Node, Water } from "contdyn";
import type { Field, Method, Status, View, WaterOptions } from "contdyn";

async function use(): Promise<void> {
  await load({ simd: false });
  const rope = new Chain({ strands: 1, springs: 10, components: 2, restLength: 1, gravity: [0, -9.81] });
  rope.position = [[0, 0], [1, 0]];
  rope.position = new Float32Array(22);
  rope.setEnd("first", "pinned");
  const method: Method = rope.method;
  rope.method = method;
  const view: View = rope.position;
  rope.position = view;
  const first: number = view.values[view.strides[0]] + view.at(0, 1, 1);
  const { kinetic, elastic }: { kinetic: number; elastic: number } = rope.energy;
  const hash: bigint = rope.hash();
  const state: Uint8Array = rope.save();
  rope.load(state);
  rope.tolerance = { tolerance: 1e-8 };
  rope.write("pin", [Node.pinned], { first: 3, n: 1 });
  const into: Float32Array = rope.read("velocity", {}, new Float32Array(22));
  const options: WaterOptions = { nx: 4, ny: 4, dx: 1, dy: 1, depth: 1, momentum: "advected" };
  const pool = new Water(options);
  const normals: Float64Array = pool.sample([[1, 2]]).normal;
  pool.setSide("xFirst", "open", 1);
  pool.writeVertices(new ArrayBuffer(512), 32, 0, null, null);
  const field: Field = "strain";
  new Membrane({ nu: 2, nv: 2, components: 3 }).impulse(1, 1, 1, [0, 0, 1]);
  try {
    rope.step(1 / 60);
  } catch (error) {
    if (error instanceof ContdynError && error.status === "errorDiverged") rope.reset();
    const status: Status = (error as ContdynError).status;
    console.log(status);
  }
  rope.dispose();
  rope[Symbol.dispose]();
  console.log(first, kinetic, elastic, hash, into, normals, field);

  // @ts-expect-error: no such method
  rope.method = "euler";
  // @ts-expect-error: of water only
  rope.read("depth");
  // @ts-expect-error: to be read only
  rope.time = 1;
  // @ts-expect-error: a chain needs components
  new Chain({ strands: 1, springs: 10 });
  // @ts-expect-error: in a name
  rope.setEnd("first", 1);
  // @ts-expect-error: a number
  rope.mass = "1";
}
void use;
