// Loads the package as built: node TEST PACKAGE simd|plain.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

export const [folder, build] = process.argv.slice(2);
const url = pathToFileURL(`${folder}/contdyn.mjs`);
export const contdyn = await import(url);
await contdyn.load({ simd: build === "simd" });
assert.equal(contdyn.kernelsName("plain"), build === "simd" ? "SIMD128" : "plain");

export const kinds = { chain: contdyn.Chain, membrane: contdyn.Membrane, water: contdyn.Water };
export const camel = (name) => name.replace(/_([a-z0-9])/g, (_, letter) => letter.toUpperCase());
