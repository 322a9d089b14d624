// The page in a headless browser: node page.mjs FOLDER CHROMIUM [PICTURES]. FOLDER has demo and contdyn in it; with
// PICTURES, what each scene looks like goes to that folder.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { Browser, serve, until } from "./browser.mjs";

const [folder, program, pictures] = process.argv.slice(2);
const { port, close } = await serve(folder);
const browser = new Browser(program);
const pause = (ms) => new Promise((done) => setTimeout(done, ms));

const told = (name) => `parseFloat([...document.querySelectorAll("dt")].find((at) =>
  at.textContent === ${JSON.stringify(name)})?.nextSibling.textContent)`;
const number = (name) => browser.run(told(name));

/** How many colors the picture has, and a number that differs where it does. */
const seen = () => browser.run(`(() => {
  const canvas = document.getElementById("picture");
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  const words = new Uint32Array(data.buffer);
  let sum = 0;
  for (const word of words) sum = (Math.imul(sum, 31) + word) | 0;
  return { colors: new Set(words).size, sum };
})()`);

const box = () => browser.run(`(() => {
  const { x, y, width, height } = document.getElementById("picture").getBoundingClientRect();
  return { x, y, width, height };
})()`);

const open = async (name, width = 1200, height = 860, dark = false) => {
  await browser.open("about:blank", width, height, dark);
  await browser.open(`http://127.0.0.1:${port}/demo/#${name}`, width, height, dark);
  await browser.until('document.querySelectorAll("#numbers dt").length > 3', `${name} runs`);
};

const set = (id, value) => browser.run(`(() => {
  const input = document.getElementById(${JSON.stringify(id)});
  input.value = ${JSON.stringify(value)};
  input.dispatchEvent(new Event("input"));
})()`);

/** Where a drag begins and which way it goes, in shares of the picture. */
const drags = { pool: [0.2, 0.75, 0.35, -0.2], rope: [0.42, 0.35, -0.3, -0.25], hair: [0.5, 0.3, 0.35, -0.1],
  cloth: [0.3, 0.55, 0.35, -0.25], drum: [0.4, 0.5, 0.2, 0.1] };

/** Drags, and holds until what is looked for has come. */
async function drag([x, y, dx, dy], touch, held) {
  const at = await box();
  const point = (share) => ({ x: at.x + at.width * (x + share * dx), y: at.y + at.height * (y + share * dy) });
  const steps = 12;
  const send = (mouse, tap, share) => (touch ? browser.touch(tap, tap === "touchEnd" ? [] : [point(share)])
    : browser.mouse(mouse, point(share).x, point(share).y));
  await send("mousePressed", "touchStart", 0);
  for (let i = 1; i <= steps; ++i) {
    await send("mouseMoved", "touchMove", i / steps);
    await pause(25);
  }
  await held();
  await send("mouseReleased", "touchEnd", 1);
}

async function energyRises(name, act) {
  if (name === "cloth") await set("wind", 0);
  if (name === "rope") await set("lambda", 1);
  await pause(["rope", "cloth", "hair"].includes(name) ? 2000 : 600);
  const before = await number("Energy");
  await act(() => browser.until(`${told("Energy")} > ${before + 1e-4 * Math.abs(before)}`,
    `${name} gains energy by a touch, from ${before} J`));
}

try {
  for (const name of Object.keys(drags)) {
    await open(name);
    const first = await seen();
    assert(first.colors > 15, `${name} shows ${first.colors} colors`);
    await until(async () => (await seen()).sum !== first.sum, `${name} moves`);
    await energyRises(name, (held) => drag(drags[name], false, held));
    assert.equal(await browser.run('document.getElementById("message").textContent'), "");
    const [frames, cost] = [await number("Frames a second"), await number("Time a step")];
    console.log(`${name.padEnd(6)} ${frames} frames a second, ${cost} ms a step`);
    if (pictures) {
      for (const [width, dark] of [[1200, false], [1200, true], [390, false], [390, true]]) {
        await open(name, width, width > 600 ? 860 : 1300, dark);
        await pause(1500);
        writeFileSync(`${pictures}/${name}-${width}-${dark ? "dark" : "light"}.png`, await browser.picture());
      }
    }
  }

  // a phone: nothing is wider than the screen, and fingers are answered
  await open("drum", 390, 844);
  assert(await browser.run("document.documentElement.scrollWidth <= innerWidth"), "it is wider than 390 pixels");
  await energyRises("drum", (held) => drag(drags.drum, true, held));

  // keys alone: a strike by the space bar, a pause, a reset
  await open("drum");
  await browser.run('document.getElementById("picture").focus()');
  await energyRises("drum", async (struck) => {
    await browser.key("keyDown", " ", "Space");
    await browser.key("keyUp", " ", "Space");
    await struck();
  });
  await browser.key("keyDown", "p");
  await until(async () => {
    const { sum } = await seen();
    await pause(300);
    return (await seen()).sum === sum;
  }, "it rests while it is paused");

  // the boat goes where it is pulled, however slow the machine is
  await open("pool");
  const first = await number("Boat");
  await drag([3.9 / 8, 1 - 2.1 / 6, -0.2, 0], false, () => browser.until(`${told("Boat")} < ${first - 0.5}`,
    `the boat is pulled from ${first} m to ${first - 0.5} m`));

  // the rope falls apart where it is cut
  await open("rope");
  await set("lambda", 1);
  await pause(2000);
  await browser.key("keyDown", "c");
  const energy = await number("Energy");
  await drag([0.3, 0.25, 0.5, 0.02], false, () => undefined);
  await browser.until(`${told("Energy")} < ${energy - 1}`, `what is cut falls, from ${energy} J`);

  // forward Euler blows up, the implicit step does not, of the same drum
  for (const [method, blows] of [["implicit", false], ["forwardEuler", true]]) {
    await open("drum");
    await set("stiffness", 6);
    await set("method", method);
    await pause(blows ? 0 : 3000);
    if (blows) await browser.until('!document.getElementById("message").hidden', "forward Euler blows up");
    assert.equal(await browser.run('document.getElementById("message").textContent.includes("blew up")'), blows);
  }
  assert.deepEqual(browser.errors, []);
} finally {
  await browser.close();
  close();
}
