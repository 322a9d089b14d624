// How large the package is, in bytes: as it is, by gzip, by Brotli.
//
//   node size.mjs PACKAGE [MOST]    fails if a page with SIMD loads more than MOST bytes by Brotli
import { readFileSync } from "node:fs";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";

const [folder, most = Infinity] = process.argv.slice(2);
const sum = { simd: [0, 0, 0], plain: [0, 0, 0] };
for (const file of ["contdyn-simd.wasm", "contdyn.wasm", "contdyn.mjs", "runtime.mjs"]) {
  const data = readFileSync(`${folder}/${file}`);
  const sizes = [data, gzipSync(data, { level: 9 }), brotliCompressSync(data, {
    params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: data.length },
  })].map(({ length }) => length);
  print(file, sizes);
  for (const build of ["simd", "plain"]) {
    if (!file.endsWith(".wasm") || file.includes("simd") === (build === "simd")) {
      sum[build] = sum[build].map((size, i) => size + sizes[i]);
    }
  }
}
print("what a page with SIMD loads", sum.simd);
print("what a page without loads", sum.plain);

function print(name, sizes) {
  console.log(name.padEnd(28), ...sizes.map((size) => String(size).padStart(9)));
}
if (sum.simd[2] > Number(most)) {
  console.log(`that is more than ${most} bytes by Brotli`);
  process.exitCode = 1;
}
