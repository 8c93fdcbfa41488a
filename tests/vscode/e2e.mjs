// The extension in a real VS Code.
//   node e2e.mjs --code-server DIR --vsix FILE --out DIR [--only NAME[,NAME]] [--shots]
import assert from "node:assert/strict";
import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { CodeServer, Window, fresh, openBrowser, until } from "./workbench.mjs";

const { values } = parseArgs({
  options: {
    "code-server": { type: "string" },
    vsix: { type: "string" },
    out: { type: "string" },
    only: { type: "string" },
    shots: { type: "boolean", default: false },
  },
});
const examples = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "docs", "examples");
const out = resolve(values.out);
const only = values.only?.split(",");
const tests = [];

/** A test on a copy of an example; `trust` runs it in a VS Code that asks for trust. */
function test(name, example, run, { trust = false } = {}) {
  tests.push({ name, example, run, trust });
}

/** A file of the example: where it is, and its text. */
function source(window, path) {
  const file = join(window.folder, path);
  const text = () => readFileSync(file, "utf8");
  return {
    file,
    text,
    write: (change) => writeFileSync(file, change(text())),
    /** Line and column, from one, of the n-th place where the text stands, behind its first `offset` characters. */
    find(part, offset = 0, nth = 1) {
      let at = -1;
      for (let left = nth; left > 0; left--) at = text().indexOf(part, at + 1);
      assert.ok(at >= 0, `${path} has no ${part}`);
      const before = text().slice(0, at + offset).split("\n");
      return [before.length, before.at(-1).length + 1];
    },
    has: (part) => until(`${path} holds ${part}`, () => text().includes(part)),
  };
}

const CELL = "src/measuring_cell/urdf/measuring_cell.xacro";
const FURNITURE = "src/measuring_cell/urdf/furniture.xacro";
const BROKEN = "src/broken_cell/urdf/broken_cell.xacro";
const GRIPPER = "src/two_joint_gripper_description/urdf/two_joint_gripper.urdf.xacro";
const ARM = "src/two_joint_gripper_description/urdf/arm.xacro";

test("problems", "broken_cell", async (window) => {
  const file = source(window, BROKEN);
  await window.file("broken_cell.xacro");
  const shown = await window.problem("reference_bals");
  const [line, column] = file.find("reference_bals");
  assert.match(shown, /undefined-macro/);
  assert.ok(shown.includes(`[Ln ${line}, Col ${column}]`), `${shown}: not at ${line}:${column}`);
});

async function main() {
  const program = resolve(values["code-server"]);
  const browser = await openBrowser();
  const chosen = tests.filter(({ name }) => !only || only.includes(name));
  let failed = 0;
  for (const trust of [false, true]) {
    const own = chosen.filter((each) => each.trust === trust);
    if (own.length === 0) continue;
    const server = new CodeServer(program, fresh(join(out, trust ? "profile-trust" : "profile")), { trust });
    await server.install(resolve(values.vsix));
    await server.start();
    for (const { name, example, run } of own) {
      const begin = Date.now();
      const folder = join(fresh(join(out, "workspaces", name)), example);
      cpSync(join(examples, example), folder, { recursive: true });
      let window;
      try {
        window = await Window.open(browser, server, folder);
        await run(window, server);
        console.log(`ok   ${name} (${((Date.now() - begin) / 1000).toFixed(1)} s)`);
        if (values.shots) await window.shot(shot(`${name}.png`));
      } catch (error) {
        failed++;
        console.log(`FAIL ${name} (${((Date.now() - begin) / 1000).toFixed(1)} s)\n${error.stack}`);
        await window?.shot(shot(`${name}-failed.png`)).catch(() => undefined);
      }
      await window?.close();
    }
    writeFileSync(join(out, trust ? "extension-trust.log" : "extension.log"), server.extensionLog());
    await server.stop();
  }
  await browser.close();
  console.log(`vscode: ${chosen.length - failed} passed, ${failed} failed`);
  process.exitCode = failed === 0 && chosen.length > 0 ? 0 : 1;
}

function shot(name) {
  const folder = join(out, "shots");
  mkdirSync(folder, { recursive: true });
  return join(folder, name);
}

await main();
