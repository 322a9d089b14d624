// The reference in a headless browser: node reference_page.mjs FOLDER CHROMIUM PYTHON REFERENCE [PICTURES]. PYTHON runs
// the program REFERENCE, which makes it in FOLDER; with PICTURES, what it looks like goes to that folder.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "../../bindings/javascript/tests/browser.mjs";

const [folder, program, python, reference, pictures] = process.argv.slice(2);
assert.equal(spawnSync(python, ["-B", reference, folder], { stdio: "inherit" }).status, 0);
const page = pathToFileURL(join(folder, "index.html")).href;
const browser = new Browser(program);

async function open(anchor, width, dark = false) {
  await browser.open("about:blank", width, 1000, dark);
  await browser.until('location.href === "about:blank"', "an empty page");
  await browser.open(page + anchor, width, 1000, dark);
  await browser.until('document.readyState === "complete" && !!document.getElementById("search")', "the page");
}

const shown = () => browser.run(`[...document.querySelectorAll("main [data-item]")]
  .filter((item) => item.getClientRects().length).map((item) => item.id)`);
const find = (text) => browser.run(`(() => {
  const field = document.getElementById("search");
  field.value = ${JSON.stringify(text)};
  field.dispatchEvent(new Event("input"));
})()`);
const press = async (key) => {
  for (const type of ["keyDown", "keyUp"]) await browser.key(type, key);
};

try {
  // Nothing is wider than the window, and what a link leads to is in sight below the head.
  const anchors = ["#cd_chain", "#cd_chain_set_bed", "#water.CD_MASK", "#cd_distance", "#chain.h-parameters"];
  const backs = new Set();
  for (const width of [390, 1200])
    for (const dark of [false, true])
      for (const anchor of anchors) {
        await open(anchor, width, dark);
        const where = `${anchor}, ${width} pixels`;
        assert.equal(await browser.run("document.documentElement.scrollWidth"), width, `${where}: too wide`);
        const top = await browser.run(`document.querySelector(":target").getBoundingClientRect().top
          - document.querySelector("header").getBoundingClientRect().bottom`);
        assert(top >= 0 && top < 200, `${where}: ${top} pixels below the head`);
        backs.add(`${dark} ${await browser.run("getComputedStyle(document.body).backgroundColor")}`);
        const name = `${anchor.slice(1)}-${width}${dark ? "-dark" : ""}.png`;
        if (pictures) writeFileSync(join(pictures, name), await browser.picture());
      }
  assert.equal(new Set([...backs].map((back) => back.split(" ").slice(1).join(" "))).size, 2, [...backs].join("; "));

  // Contents: beside the text where there is room, else folded.
  assert.equal(await browser.run('document.querySelector(".contents").open'), true);
  await open("", 390);
  assert.equal(await browser.run('document.querySelector(".contents").open'), false);

  // The search, by keys alone.
  await open("", 1200);
  const every = await shown();
  await press("/");
  assert.equal(await browser.run("document.activeElement.id"), "search");
  assert.equal(await browser.run('document.getElementById("search").value'), "", "the key itself is no word");
  await find("wind");
  const winds = every.filter((name) => name.toLowerCase().includes("wind"));
  assert((await shown()).filter((name) => winds.includes(name)).length === winds.length && winds.length > 4);
  assert.deepEqual((await shown()).filter((name) => !winds.includes(name)), ["cd_field"]); // that CD_WIND is one of
  assert.equal(await browser.run('document.getElementById("found").textContent'), `${winds.length} found`);
  await find("SET rest chain");
  assert.deepEqual((await shown()).sort(), ["cd_chain_get_rest_angle", "cd_chain_get_rest_length",
    "cd_chain_set_rest_angle", "cd_chain_set_rest_length"]);
  await browser.run('document.getElementById("search").form.requestSubmit()');
  await browser.until('location.hash === "#cd_chain_set_rest_length"', "the first that was found");
  await find("capstan, or no such word");
  assert.deepEqual(await shown(), []);
  assert.equal(await browser.run('document.getElementById("found").textContent'), "none");
  await find("manning's roughness"); // in no name, but in the text
  assert.deepEqual((await shown()).sort(), ["cd_water_get_manning", "cd_water_set_manning"]);
  await browser.run('location.hash = "#cd_chain_step"'); // which the search hides
  await browser.until('document.getElementById("cd_chain_step").getClientRects().length > 0', "where a link leads");
  assert.deepEqual(await shown(), every);
  await press("/");
  await find("wind");
  await press("Escape");
  assert.deepEqual(await shown(), every);
  assert.deepEqual(browser.errors, []);
} finally {
  await browser.close();
}
