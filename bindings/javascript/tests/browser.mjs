// A headless Chromium, spoken to over a pipe by its DevTools protocol, and a server of static files for it.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";

const kTypes = { ".html": "text/html", ".css": "text/css", ".mjs": "text/javascript", ".wasm": "application/wasm" };

/** Serves a folder; its port. */
export async function serve(folder) {
  const server = createServer(async (request, response) => {
    const path = normalize(new URL(request.url, "http://localhost").pathname);
    const file = join(folder, path.endsWith("/") ? `${path}index.html` : path);
    try {
      const data = await readFile(file);
      response.writeHead(200, { "content-type": kTypes[extname(file)] ?? "application/octet-stream" }).end(data);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return { port: server.address().port, close: () => server.close() };
}

/** Waits until something is true: a machine that does much else is slow, and no less right. */
export async function until(holds, what, seconds = 60) {
  const end = Date.now() + 1000 * seconds;
  while (!(await holds())) {
    if (Date.now() > end) throw new Error(`not within ${seconds} s: ${what}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}

export class Browser {
  #process;
  #profile = mkdtempSync(join(tmpdir(), "contdyn-browser-"));
  #waiting = new Map();
  #last = 0;
  #session;
  /** What went to the console as an error, and exceptions that nothing caught. */
  errors = [];

  constructor(program) {
    this.#process = spawn(program, ["--headless", "--no-sandbox", "--remote-debugging-pipe", "--hide-scrollbars",
      "--disable-gpu", "--disable-dev-shm-usage", `--user-data-dir=${this.#profile}`, "about:blank"],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"], detached: true });
    let text = "";
    this.#process.stdio[4].on("data", (data) => {
      text += data;
      const parts = text.split("\0");
      text = parts.pop();
      for (const part of parts) this.#hear(JSON.parse(part));
    });
    this.#process.on("exit", () => {
      for (const { fail } of this.#waiting.values()) fail(new Error("the browser ended"));
    });
  }

  #hear({ id, result, error, method, params }) {
    if (id) {
      const { done, fail } = this.#waiting.get(id);
      this.#waiting.delete(id);
      if (error) fail(new Error(error.message));
      else done(result);
    } else if (method === "Runtime.exceptionThrown") {
      this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    } else if (method === "Runtime.consoleAPICalled" && ["error", "assert"].includes(params.type)) {
      this.errors.push(params.args.map((value) => value.value ?? value.description).join(" "));
    } else if (method === "Log.entryAdded" && params.entry.level === "error") {
      this.errors.push(`${params.entry.text} ${params.entry.url ?? ""}`);
    }
  }

  send(method, params = {}) {
    const id = ++this.#last;
    this.#process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: this.#session })}\0`);
    return new Promise((done, fail) => this.#waiting.set(id, { done, fail }));
  }

  async open(url, width, height, dark = false) {
    if (!this.#session) {
      const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
      ({ sessionId: this.#session } = await this.send("Target.attachToTarget", { targetId, flatten: true }));
      for (const domain of ["Runtime", "Log", "Page"]) await this.send(`${domain}.enable`);
    }
    await this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: width < 600 });
    await this.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: dark ? "dark"
      : "light" }] });
    await this.send("Page.navigate", { url });
  }

  async run(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, returnByValue: true,
      awaitPromise: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /** Waits until an expression is true; until then it may throw. */
  until(expression, what) {
    return until(() => this.run(expression).catch(() => false), what).catch((error) => {
      throw new Error(`${error.message}; errors: ${this.errors.join("; ")}`);
    });
  }

  mouse(type, x, y) {
    const button = type === "mouseMoved" ? {} : { button: "left", clickCount: 1 };
    return this.send("Input.dispatchMouseEvent", { type, x, y, buttons: type === "mouseReleased" ? 0 : 1, ...button });
  }

  touch(type, points) {
    return this.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  }

  key(type, key, code = key) {
    return this.send("Input.dispatchKeyEvent", { type, key, code, text: type === "keyDown" && key.length === 1 ? key
      : undefined });
  }

  async picture() {
    const { data } = await this.send("Page.captureScreenshot", { format: "png" });
    return Buffer.from(data, "base64");
  }

  async close() {
    const ended = new Promise((done) => this.#process.on("exit", done));
    process.kill(-this.#process.pid, "SIGKILL"); // the group: what the browser has started would go on writing
    await ended;
    // what is still at its end may hold files yet
    await until(() => {
      try {
        rmSync(this.#profile, { recursive: true, force: true });
        return true;
      } catch {
        return false;
      }
    }, "the browser's folder is removed");
  }
}
