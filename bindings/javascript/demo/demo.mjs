// The page: its loop, its controls, its pointer and keys.
import { ContdynError, kernelsName, load } from "../contdyn/contdyn.mjs";
import { frame, scenes } from "./scenes.mjs";

const $ = (id) => document.getElementById(id);
const picture = $("picture");
const chart = $("chart");
const kHistory = 10; // seconds
const kMostPerFrame = 60; // steps; a machine that is too slow shows slow motion

let Scene;
let scene;
let settings = {};
let paused = false;
let cutting = false;
let broken = false;
let owed = 0; // seconds that no step has made yet
let history = [];
let colors;
const meter = { frames: 0, since: 0, rate: 0, steps: 0, time: 0, cost: 0 };

// ---- scenes ---------------------------------------------------------------------------------------------------------

function open(name) {
  Scene = scenes[name];
  settings = Object.fromEntries(Object.entries(Scene.controls).map(([key, { value }]) => [key, value]));
  $("hint").textContent = Scene.hint;
  $("cut").hidden = !Scene.canCut;
  setCutting(false);
  showControls();
  reset();
}

function reset() {
  scene?.object.dispose();
  broken = false;
  say("");
  owed = 0;
  history = [];
  attempt(() => {
    scene = new Scene(settings);
  });
}

/** What a call refuses is said on the page; what goes wrong otherwise is an error of the page. */
function attempt(action) {
  try {
    action();
    return true;
  } catch (error) {
    if (!(error instanceof ContdynError)) throw error;
    if (error.status === "errorTolerance") return true; // the step was made, only less exactly
    if (error.status === "errorDiverged") {
      broken = true;
      say("It blew up: the numbers have left the finite range. Take another method or a shorter step, and reset.");
    } else {
      say(error.message);
    }
    return false;
  }
}

function say(text) {
  $("message").textContent = text;
  $("message").hidden = text === "";
}

// ---- controls -------------------------------------------------------------------------------------------------------

function showControls() {
  $("controls").replaceChildren(...Object.entries(Scene.controls).map(([key, control]) => {
    const label = document.createElement("label");
    const output = document.createElement("output");
    const input = control.choices ? document.createElement("select") : document.createElement("input");
    input.id = key;
    if (control.choices) {
      for (const [value, text] of Object.entries(control.choices)) input.add(new Option(text, value));
      input.value = settings[key];
    } else {
      Object.assign(input, { type: "range", min: control.min, max: control.max, step: control.step });
      input.value = control.at(settings[key]);
      output.textContent = control.show(settings[key]);
    }
    input.addEventListener("input", () => {
      settings[key] = control.choices ? input.value : control.of(Number(input.value));
      if (!control.choices) output.textContent = control.show(settings[key]);
      if (!broken) {
        say("");
        attempt(() => scene.set(settings));
      }
    });
    label.append(control.label, output, input);
    return label;
  }));
}

function setCutting(on) {
  cutting = on;
  $("cut").setAttribute("aria-pressed", String(on));
}

function setPaused(on) {
  paused = on;
  $("pause").setAttribute("aria-pressed", String(on));
}

// ---- the loop -------------------------------------------------------------------------------------------------------

let last = performance.now();

function tick(now) {
  const passed = Math.min(0.1, Math.max(0, (now - last) / 1000));
  last = now;
  if (!paused && !broken) advance(passed);
  draw();
  measure(now);
  requestAnimationFrame(tick);
}

function advance(passed) {
  const { dt } = settings;
  owed += passed;
  const count = Math.min(kMostPerFrame, Math.floor(owed / dt));
  if (count === 0) return;
  owed = Math.min(owed - count * dt, dt);
  const start = performance.now();
  attempt(() => {
    scene.before?.(count * dt);
    scene.object.step(dt, count);
  });
  meter.cost += performance.now() - start;
  meter.steps += count;
  const { kinetic, total } = scene.energy();
  meter.time += count * dt;
  history.push({ time: meter.time, kinetic, total });
  while (history[0].time < meter.time - kHistory) history.shift();
}

function sized(canvas) {
  const ratio = devicePixelRatio || 1;
  const { clientWidth: width, clientHeight: height } = canvas;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width, height };
}

function draw() {
  const { context, width, height } = sized(picture);
  const view = frame(Scene.world, width, height);
  if (!scene.object.disposed) scene.draw(context, view, colors);
  if (cursor.shown) {
    context.strokeStyle = colors.accent;
    context.lineWidth = 2;
    context.beginPath();
    context.arc(cursor.x * width, cursor.y * height, 11, 0, 2 * Math.PI);
    context.stroke();
  }
  drawChart();
}

function drawChart() {
  const { context, width, height } = sized(chart);
  const finite = history.filter(({ total }) => Number.isFinite(total));
  if (finite.length < 2) return;
  const low = Math.min(0, ...finite.map(({ total }) => total));
  const high = Math.max(...finite.flatMap(({ total, kinetic }) => [total, kinetic]), low + 1e-12);
  const x = (time) => width * (1 - (meter.time - time) / kHistory);
  const y = (value) => height - 5 - ((height - 10) * (value - low)) / (high - low);
  for (const [key, color] of [["kinetic", colors.kinetic], ["total", colors.accent]]) {
    context.strokeStyle = color;
    context.lineWidth = 1.75;
    context.beginPath();
    finite.forEach((at, i) => context[i ? "lineTo" : "moveTo"](x(at.time), y(at[key])));
    context.stroke();
  }
}

function measure(now) {
  meter.frames += 1;
  if (now - meter.since < 400) return;
  meter.rate = (1000 * meter.frames) / (now - meter.since);
  const { kinetic, total } = history.at(-1) ?? { kinetic: 0, total: 0 };
  const shown = (value) => (Math.abs(value) < 1e5 ? value.toPrecision(4) : value.toExponential(2));
  const numbers = {
    Energy: `${shown(total)} J`,
    "of that kinetic": `${shown(kinetic)} J`,
    "Time a step": meter.steps ? `${(meter.cost / meter.steps).toFixed(3)} ms` : "–",
    "Frames a second": meter.rate.toFixed(0),
    ...(broken ? {} : scene.numbers()),
    Instructions: kernelsName("plain"),
  };
  $("numbers").replaceChildren(...Object.entries(numbers).flatMap(([name, value]) => [
    Object.assign(document.createElement("dt"), { textContent: name }),
    Object.assign(document.createElement("dd"), { textContent: value })]));
  Object.assign(meter, { frames: 0, since: now, steps: 0, cost: 0 });
}

// ---- pointer and keys -----------------------------------------------------------------------------------------------

const cursor = { x: 0.5, y: 0.5, shown: false, pressed: false }; // of the keyboard, in shares of the picture
let pointer = null;

function place(x, y) {
  return frame(Scene.world, picture.clientWidth, picture.clientHeight).back(x, y);
}

function press(x, y, cuts) {
  const at = place(x, y);
  pointer = { at, cuts };
  if (!broken) attempt(() => scene.press(...at, cuts));
}

function drag(x, y) {
  if (!pointer) return;
  const at = place(x, y);
  const [dx, dy] = [at[0] - pointer.at[0], at[1] - pointer.at[1]];
  pointer.at = at;
  if (!broken) attempt(() => scene.drag(...at, dx, dy, pointer.cuts));
}

function release() {
  if (pointer && !broken) attempt(() => scene.release());
  pointer = null;
}

picture.addEventListener("pointerdown", (event) => {
  if (pointer) return;
  picture.setPointerCapture(event.pointerId);
  cursor.shown = false;
  press(event.offsetX, event.offsetY, cutting || (Scene.canCut && event.button === 2));
});
picture.addEventListener("pointermove", (event) => drag(event.offsetX, event.offsetY));
picture.addEventListener("pointerup", release);
picture.addEventListener("pointercancel", release);
picture.addEventListener("contextmenu", (event) => event.preventDefault());

const kWays = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

picture.addEventListener("keydown", (event) => {
  const way = kWays[event.key];
  const [width, height] = [picture.clientWidth, picture.clientHeight];
  if (way) {
    cursor.shown = true;
    cursor.x = Math.min(1, Math.max(0, cursor.x + 0.025 * way[0]));
    cursor.y = Math.min(1, Math.max(0, cursor.y + 0.033 * way[1]));
    if (cursor.pressed) drag(cursor.x * width, cursor.y * height);
  } else if (event.key === " " || event.key === "Enter") {
    cursor.shown = true;
    if (!event.repeat && !pointer) {
      cursor.pressed = true;
      press(cursor.x * width, cursor.y * height, cutting);
    }
  } else {
    return;
  }
  event.preventDefault();
});
picture.addEventListener("keyup", (event) => {
  if ((event.key === " " || event.key === "Enter") && cursor.pressed) {
    cursor.pressed = false;
    release();
  }
});
picture.addEventListener("blur", () => {
  cursor.shown = false;
  if (cursor.pressed) release();
  cursor.pressed = false;
});

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("select")) return;
  const key = event.key.toLowerCase();
  if (key === "r") reset();
  else if (key === "p") setPaused(!paused);
  else if (key === "c" && Scene.canCut) setCutting(!cutting);
});
$("reset").addEventListener("click", reset);
$("pause").addEventListener("click", () => setPaused(!paused));
$("cut").addEventListener("click", () => setCutting(!cutting));

// ---- colors ---------------------------------------------------------------------------------------------------------

const darkness = matchMedia("(prefers-color-scheme: dark)");

function readColors() {
  const style = getComputedStyle(document.documentElement);
  const color = (name) => style.getPropertyValue(`--${name}`).trim();
  const dark = darkness.matches;
  colors = { dark, ink: color("ink"), line: color("line"), accent: color("accent"), kinetic: color("kinetic"),
    ground: color("ground"), skin: dark ? "#c99b7a" : "#e8b48e", hair: dark ? "#e2c08a" : "#5a3a1e",
    fabric: dark ? [214, 96, 78] : [196, 62, 44], stripe: dark ? [222, 226, 232] : [244, 240, 232],
    drum: (share) => `hsl(208 ${dark ? 32 : 55}% ${dark ? 14 + 14 * share : 84 + 10 * share}%)` };
}
darkness.addEventListener("change", readColors);

// ---- start ----------------------------------------------------------------------------------------------------------

try {
  await load();
  readColors();
  for (const [name, { title }] of Object.entries(scenes)) {
    const label = document.createElement("label");
    const input = Object.assign(document.createElement("input"), { type: "radio", name: "scene", value: name });
    input.addEventListener("change", () => open(name));
    label.append(input, title);
    $("scenes").append(label);
  }
  const first = Object.keys(scenes).find((name) => location.hash === `#${name}`) ?? "pool";
  document.querySelector(`#scenes [value=${first}]`).checked = true;
  open(first);
  meter.since = last = performance.now();
  requestAnimationFrame(tick);
} catch (error) {
  $("hint").textContent = `It could not be loaded: ${error.message}`;
  throw error;
}
