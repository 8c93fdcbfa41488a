// A VS Code for tests: code-server on a port of this machine, looked at by a headless Chromium. Every step waits for
// what it needs to see; a step that does not come about fails after `PATIENCE`.
import { spawn } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { join } from "node:path";
import { chromium } from "playwright-core";

export const PATIENCE = 30_000;

const SETTINGS = {
  "telemetry.telemetryLevel": "off",
  "workbench.enableExperiments": false,
  "update.mode": "none",
  "extensions.autoUpdate": false,
  "extensions.autoCheckUpdates": false,
  "extensions.ignoreRecommendations": true,
  "workbench.startupEditor": "none",
  "workbench.tips.enabled": false,
  "workbench.layoutControl.enabled": false,
  "chat.commandCenter.enabled": false,
  "git.enabled": false,
  "github.gitAuthentication": false,
  "npm.fetchOnlinePackageInfo": false,
  "json.schemaDownload.enable": false,
  "files.autoSave": "off",
  "editor.minimap.enabled": false,
  "security.workspace.trust.startupPrompt": "never",
  "security.workspace.trust.banner": "always",
};

/** Waits until `probe` gives something, and gives it. */
export async function until(what, probe, patience = PATIENCE) {
  const end = Date.now() + patience;
  for (;;) {
    const found = await probe();
    if (found) return found;
    if (Date.now() > end) throw new Error(`waited in vain: ${what}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}

async function freePort() {
  return new Promise((done, failed) => {
    const server = createServer();
    server.once("error", failed);
    server.listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => done(port));
    });
  });
}

/** An installation of code-server with a profile of its own. */
export class CodeServer {
  constructor(program, profile, { trust = false, settings = {} } = {}) {
    this.program = program;
    this.profile = profile;
    this.trust = trust;
    this.extensions = join(profile, "extensions");
    mkdirSync(join(profile, "user", "User"), { recursive: true });
    const all = { ...SETTINGS, "security.workspace.trust.enabled": trust, ...settings };
    writeFileSync(join(profile, "user", "User", "settings.json"), JSON.stringify(all, null, 2));
  }

  #spawn(args, stdio) {
    const folders = ["--config", join(this.profile, "config.yaml"), "--user-data-dir", join(this.profile, "user")];
    const entry = join(this.program, "app", "out", "node", "entry.js");
    const env = { ...process.env, EXTENSIONS_GALLERY: '{"serviceUrl":""}' };
    // neither a program of this machine nor packages of its environment have a part in the tests
    for (const name of ["AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "ROS_PACKAGE_PATH"]) delete env[name];
    return spawn(process.execPath, [entry, ...folders, "--extensions-dir", this.extensions, ...args], { env, stdio });
  }

  async install(vsix) {
    const child = this.#spawn(["--install-extension", vsix], ["ignore", "pipe", "pipe"]);
    let said = "";
    child.stdout.on("data", (data) => (said += data));
    child.stderr.on("data", (data) => (said += data));
    const code = await new Promise((done) => child.once("exit", done));
    if (code !== 0 || !said.includes("successfully installed")) throw new Error(`the vsix was not installed: ${said}`);
  }

  async start() {
    this.port = await freePort();
    const args = ["--auth", "none", "--bind-addr", `127.0.0.1:${this.port}`, "--disable-telemetry"];
    args.push("--disable-update-check", "--disable-getting-started-override");
    if (!this.trust) args.push("--disable-workspace-trust");
    this.child = this.#spawn(args, ["ignore", "pipe", "pipe"]);
    this.log = "";
    for (const stream of [this.child.stdout, this.child.stderr]) stream.on("data", (data) => (this.log += data));
    await until("code-server listens", async () => {
      if (this.child.exitCode !== null) throw new Error(`code-server ended: ${this.log}`);
      return fetch(`http://127.0.0.1:${this.port}/healthz`).then(({ ok }) => ok, () => false);
    });
  }

  async stop() {
    if (!this.child || this.child.exitCode !== null) return;
    const ended = new Promise((done) => this.child.once("exit", done));
    this.child.kill();
    await ended;
  }

  /** Whether the installed extension holds a file. */
  hasInside(file) {
    const own = readdirSync(this.extensions).find((name) => name.startsWith("xacro-lsp.xacro-lsp-"));
    return own !== undefined && existsSync(join(this.extensions, own, file));
  }

  /** Process ids of language servers that were started from this profile. */
  servers() {
    const found = [];
    for (const id of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
      try {
        const [command] = readFileSync(`/proc/${id}/cmdline`, "utf8").split("\0");
        if (command.startsWith(this.extensions) && /\/xacro-l(sp|int)$/.test(command)) found.push(Number(id));
      } catch {
        // it ended meanwhile
      }
    }
    return found;
  }

  /** The extension's own log. */
  extensionLog() {
    const logs = join(this.profile, "user", "logs");
    if (!existsSync(logs)) return "";
    const files = readdirSync(logs, { recursive: true }).filter((name) => /xacro-lsp[^/]*\/Xacro[^/]*\.log$/.test(name));
    return files.map((name) => readFileSync(join(logs, name), "utf8")).join("");
  }
}

/** The browser that all windows are opened in. */
export async function openBrowser() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: [
      "--no-sandbox",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      "--disable-quic",
      "--use-gl=angle",
      "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader",
    ],
  });
}

/** A window of the workbench on a folder. */
export class Window {
  static async open(browser, server, folder, size = { width: 1360, height: 860 }) {
    const context = await browser.newContext({ viewport: size });
    await context.grantPermissions(["clipboard-read", "clipboard-write"]);
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE);
    await page.goto(`http://127.0.0.1:${server.port}/?folder=${encodeURIComponent(folder)}`);
    await page.locator(".explorer-folders-view .monaco-list-row").first().waitFor();
    return new Window(context, page, folder);
  }

  constructor(context, page, folder) {
    this.context = context;
    this.page = page;
    this.folder = folder;
  }

  get editor() {
    return this.page.locator(".editor-group-container.active .monaco-editor").first();
  }

  get input() {
    return this.page.locator(".quick-input-widget:not([style*='display: none']) input[type=text]");
  }

  row(text) {
    return this.page.locator(".quick-input-widget .monaco-list-row", { hasText: text }).first();
  }

  async close() {
    await this.context.close();
  }

  async press(keys) {
    await this.page.keyboard.press(keys);
  }

  /** Opens a file by its name and waits for its text. */
  async file(name) {
    const tab = this.page.locator(`.editor-group-container.active .tab.active[data-resource-name="${name}"]`);
    await until(`the file ${name}`, async () => {
      await this.press("Control+P");
      await this.#choose(name, name);
      return tab.waitFor({ timeout: 3000 }).then(() => true, () => false);
    });
    await this.editor.locator(".view-line").first().waitFor();
  }

  /** Types into the open list and takes the first row, once that is the one that is meant. */
  async #choose(typed, text) {
    await this.input.fill(typed);
    await this.page.locator(".quick-input-widget .monaco-list-row.focused", { hasText: text }).first().waitFor();
    await this.press("Enter");
  }

  /** Answers an input box that has this title. */
  async answer(title, text) {
    await this.page.locator(".quick-input-widget .quick-input-title", { hasText: title }).waitFor();
    await until(`the input box ${title}`, async () => {
      await this.input.fill(text);
      return (await this.input.inputValue()) === text && (await this.page.locator(".quick-input-widget .monaco-list-row").count()) === 0;
    });
    await this.press("Enter");
  }

  /** Runs a command by its title. */
  async command(title) {
    await this.press("F1");
    await this.input.fill(`>${title}`);
    await this.row(title).click();
  }

  /** Puts the cursor on a line and column, both counted from one. */
  async go(line, column) {
    await this.press("Control+G");
    await this.input.fill(`:${line}:${column}`);
    await this.press("Enter");
    await this.at(line, column);
  }

  /** Waits until the cursor stands there. */
  async at(line, column) {
    const where = column === undefined ? `Ln ${line},` : `Ln ${line}, Col ${column}`;
    await this.page.locator(".statusbar-item", { hasText: where }).first().waitFor();
  }

  async save() {
    await this.press("Control+S");
  }

  async notification(text) {
    await this.page.locator(".notification-list-item", { hasText: text }).first().waitFor();
  }

  async status(text) {
    await this.page.locator(".statusbar-item", { hasText: text }).first().waitFor();
  }

  /** The row of the problems panel with a text, once there is one. */
  async problem(text) {
    const row = this.page.locator(".markers-panel .monaco-list-row", { hasText: text }).last();
    const filter = this.page.locator(".part.panel").getByPlaceholder(/^Filter/).first();
    await until(`a problem with ${text}`, async () => {
      if (!(await filter.isVisible())) await this.press("Control+Shift+M");
      await filter.fill(text, { timeout: 3000 }).catch(() => undefined);
      return row.waitFor({ timeout: 1500 }).then(() => true, () => false);
    });
    return (await row.innerText()).replace(/\s+/g, " ");
  }

  /** The text of the hover at the cursor, once it holds a text. */
  async hover(text) {
    const shown = this.page.locator(".monaco-hover:visible", { hasText: text }).first();
    return until(`a hover with ${text}`, async () => {
      await this.press("Control+K");
      await this.press("Control+I");
      return shown.innerText({ timeout: 2000 }).catch(() => undefined);
    });
  }

  /** Text of the editors that are seen, as far as it is drawn, each line with plain spaces. */
  async drawn(title) {
    const groups = this.page.locator(".editor-group-container", { has: this.page.locator(`.tab.active[aria-label*="${title}"]`) });
    const lines = await groups.first().locator(".view-line").allInnerTexts();
    return lines.map((line) => line.replaceAll("\u00a0", " "));
  }

  /** The page inside a webview. */
  get webview() {
    return this.page.frameLocator("iframe.webview.ready").frameLocator("#active-frame");
  }

  async shot(path) {
    await this.page.screenshot({ path });
  }
}

/** Throws away what an earlier run left. */
export function fresh(folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  return folder;
}
