// Draws the pictures of docs/vscode.md from the real thing.
//   node pictures.mjs --code-server DIR --vsix FILE --out DIR --work DIR
import { cpSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { CodeServer, Window, fresh, openBrowser, until } from "./workbench.mjs";

const { values } = parseArgs({
  options: {
    "code-server": { type: "string" },
    vsix: { type: "string" },
    out: { type: "string" },
    work: { type: "string" },
  },
});
const repository = join(dirname(fileURLToPath(import.meta.url)), "..", "..");
const size = { width: 1280, height: 720 };

async function problems(window) {
  await window.file("broken_cell.xacro");
  await window.problem("reference_bals");
  await window.editor.click();
  await window.go(19, 12);
  await window.press("Control+.");
  await window.page.locator(".action-widget .monaco-list-row.focused").waitFor();
}

async function expanded(window) {
  await window.file("furniture.xacro");
  await window.status("measuring_cell.xacro");
  await window.command("View: Toggle Primary Side Bar Visibility");
  await window.go(43, 12);
  await window.command("Xacro: Open Expanded URDF to the Side");
  await until("the legs", async () => (await window.drawn("measuring_cell.urdf")).some((text) => text.includes("leg_front_left_joint")));
  await window.editor.click();
  await window.go(41, 20);
  await window.page.locator(".editor-group-container [class*=ced-]").first().waitFor();
}

async function preview(window) {
  await window.file("fenn_macro.xacro");
  await window.status("fenn.xacro");
  await window.command("Focus on Kinematic Tree View");
  await window.page.locator(".sidebar .monaco-list-row", { hasText: "link_6" }).first().waitFor();
  await window.editor.click();
  await window.command("Xacro: Open Preview");
  const data = (name) => window.webview.locator("body").getAttribute(`data-${name}`);
  await until("the robot", async () => (await data("ok")) === "true" && (await data("loading")) === "0");
  await window.webview.locator('[data-joint="joint_2"] input[type=range]').evaluate((input) => {
    input.value = String(Number(input.min) + 0.7 * (Number(input.max) - Number(input.min)));
    input.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await window.go(56, 30);
  await until("the selected link", async () => (await data("selected"))?.split(" ").includes("link_3"));
}

const browser = await openBrowser();
const work = fresh(resolve(values.work));
const server = new CodeServer(resolve(values["code-server"]), join(work, "profile"), {
  settings: { "breadcrumbs.enabled": false, "window.commandCenter": false, "editor.stickyScroll.enabled": false },
});
await server.install(resolve(values.vsix));
await server.start();
for (const [name, example, run] of [
  ["problems", "broken_cell", problems],
  ["expanded", "measuring_cell", expanded],
  ["preview", "measuring_cell", preview],
]) {
  const folder = join(work, name, example);
  cpSync(join(repository, "docs", "examples", example), folder, { recursive: true });
  const window = await Window.open(browser, server, folder, size);
  const file = join(resolve(values.out), `vscode-${name}.png`);
  try {
    await run(window);
    await window.shot(file);
    console.log(file);
  } catch (error) {
    await window.shot(join(work, `${name}-failed.png`));
    console.log(`${name}: ${error.stack}`);
    process.exitCode = 1;
  }
  await window.close();
}
await server.stop();
await browser.close();
