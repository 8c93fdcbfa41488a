// The extension in a real VS Code.
//   node e2e.mjs --code-server DIR --vsix FILE --web-vsix FILE --out DIR [--only NAME[,NAME]] [--shots]
import assert from "node:assert/strict";
import { cpSync, existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { CodeServer, Window, fresh, openBrowser, until } from "./workbench.mjs";

const { values } = parseArgs({
  options: {
    "code-server": { type: "string" },
    vsix: { type: "string" },
    "web-vsix": { type: "string" },
    out: { type: "string" },
    only: { type: "string" },
    shots: { type: "boolean", default: false },
  },
});
const examples = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "docs", "examples");
const out = resolve(values.out);
const only = values.only?.split(",");
const tests = [];

const PROFILES = {
  plain: {},
  trust: { trust: true },
  missing: { settings: { "xacro.server.path": "/no/such/program" } },
  // the extension host in the browser: as in VS Code for the Web, nothing of the extension runs on the server
  web: { settings: { "remote.extensionKind": { "xacro-lsp.xacro-lsp": ["web"] } }, vsix: "web-vsix" },
};

/**
 * A test on a copy of an example, in a VS Code with a profile of PROFILES. Tests with the same `share` follow each other
 * in one window, so they must leave the files alone.
 */
function test(name, example, run, { profile = "plain", needs, share = name } = {}) {
  tests.push({ name, example, run, profile, needs, share });
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
const NOT_TAKEN = '<xacro:if value="false"><link name="w${beam_width}"/></xacro:if>';

test("problems", "broken_cell", async (window) => {
  const file = source(window, BROKEN);
  await window.file("broken_cell.xacro");
  const shown = await window.problem("reference_bals");
  const [line, column] = file.find("<xacro:reference_bals");
  assert.match(shown, /undefined-macro/);
  assert.ok(shown.includes(`[Ln ${line}, Col ${column}]`), `${shown}: not at ${line}:${column}`);
});

/** The certain fix of a misspelled macro is the first one, and makes the finding go. */
async function correctsMacro(window) {
  const file = source(window, BROKEN);
  await window.file("broken_cell.xacro");
  await window.problem("reference_bals");
  await window.editor.click();
  await window.go(...file.find("reference_bals", 3));
  await window.press("Control+.");
  // the certain fix comes first
  await window.page.locator(".action-widget .monaco-list-row.focused", { hasText: "reference_balls" }).waitFor();
  await window.press("Enter");
  await window.save();
  await file.has("<xacro:reference_balls");
  await window.page.locator(".markers-panel .monaco-list-row", { hasText: "reference_bals" }).first().waitFor({ state: "hidden" });
}

test("quick-fix", "broken_cell", correctsMacro);

test("completion", "measuring_cell", async (window) => {
  const file = source(window, CELL);
  await window.file("measuring_cell.xacro");
  await window.status("measuring_cell.xacro");
  const [line] = file.find('<link name="world"/>');
  await window.go(line, 3 + '<link name="world"/>'.length);
  await window.press("Enter");
  await window.page.keyboard.type("<xacro:gauge");
  const row = window.page.locator(".suggest-widget.visible .monaco-list-row", { hasText: "gauge_probe" }).first();
  await row.waitFor();
  await until("the call with its parameters", async () => {
    if (await row.isVisible()) await row.click({ timeout: 2000 }).catch(() => undefined);
    await window.save();
    return /^ {2}<xacro:gauge_probe prefix="[^"]*" connected_to="[^"]*"/.test(file.text().split("\n")[line]);
  });
});

test("typing", "measuring_cell", async (window) => {
  const file = source(window, CELL);
  await window.file("measuring_cell.xacro");
  await window.status("measuring_cell.xacro");
  const [line] = file.find('<link name="world"/>');
  await window.go(line, 3 + '<link name="world"/>'.length);
  const shows = (part) => until(`the text ${part}`, async () => (await window.drawn("measuring_cell.xacro")).some((text) => text.includes(part)));
  await window.press("Enter");
  await window.page.keyboard.type("<link name='q'>");
  await shows("<link name='q'></link>");
  await window.press("Enter");
  await until("the end tag in a line of its own", async () => (await window.drawn("measuring_cell.xacro")).some((text) => /^ {2}<\/link>/.test(text)));
  await window.page.keyboard.type("<visual>");
  await shows("    <visual></visual>");
  await window.save();
  await file.has("  <link name='q'>\n    <visual></visual>\n  </link>\n");
});

test("definition", "measuring_cell", async (window) => {
  await window.file("measuring_cell.xacro");
  await window.status("measuring_cell.xacro");
  await window.go(...source(window, CELL).find("<xacro:measuring_table", 12));
  await until("the definition in the included file", async () => {
    await window.press("F12");
    const tab = window.page.locator('.tab.active[data-resource-name="furniture.xacro"]');
    return tab.waitFor({ timeout: 3000 }).then(() => true, () => false);
  });
  const [line] = source(window, FURNITURE).find('<xacro:macro name="measuring_table"');
  await window.at(line);
}, { share: "reading" });

test("not-taken", "two_joint_gripper", async (window) => {
  const robot = source(window, GRIPPER);
  robot.write((text) => text.replace("</robot>", `  ${NOT_TAKEN}\n</robot>`));
  await window.file("two_joint_gripper.urdf.xacro");
  await window.status("two_joint_gripper.urdf.xacro");
  await window.go(...robot.find(NOT_TAKEN, NOT_TAKEN.indexOf("beam_width") + 3));
  const uses = readFileSync(join(window.folder, ARM), "utf8").split("beam_width").length + robot.text().split("beam_width").length - 2;
  const peek = window.page.locator(".peekview-widget").first();
  await until("the references", async () => {
    await window.press("Shift+F12");
    return peek.waitFor({ timeout: 3000 }).then(() => true, () => false);
  });
  await peek.getByText(`References (${uses})`).first().waitFor();
  await window.press("Escape");
  await window.go(...robot.find(NOT_TAKEN, NOT_TAKEN.indexOf("beam_width") + 3));
  await until("the definition in the included file", async () => {
    await window.press("F12");
    const tab = window.page.locator('.tab.active[data-resource-name="arm.xacro"]');
    return tab.waitFor({ timeout: 3000 }).then(() => true, () => false);
  });
});

test("rename", "two_joint_gripper", async (window) => {
  const [arm, robot] = [source(window, ARM), source(window, GRIPPER)];
  // also where the name stands in a branch that is not taken
  robot.write((text) => text.replace("</robot>", `  ${NOT_TAKEN}\n</robot>`));
  await window.file("arm.xacro");
  await window.status("two_joint_gripper.urdf.xacro");
  await window.go(...arm.find('name="beam_width"', 8));
  const box = window.page.locator(".rename-box input, input.rename-input").first();
  await until("the box for the new name", async () => {
    await window.press("F2");
    return box.waitFor({ timeout: 3000 }).then(() => true, () => false);
  });
  await box.fill("beam_side");
  await window.press("Enter");
  // the workbench may save what it renamed at once, so the tab says little
  await until("the new name", async () => (await window.drawn("arm.xacro")).some((text) => text.includes("beam_side")));
  await window.command("File: Save All");
  await arm.has('<xacro:property name="beam_side"');
  await robot.has("beam_side / 2");
  for (const file of [arm, robot]) assert.ok(!file.text().includes("beam_width"), file.file);
});

test("launch", "measuring_cell", async (window) => {
  const robot = source(window, CELL);
  const launch = source(window, "src/measuring_cell/launch/cell.launch.py");
  writeFileSync(join(window.folder, "xacro-lint.toml"), `[[roots]]\nfile = "${CELL}"\nargs = {  }\n`);
  const config = source(window, "xacro-lint.toml");
  launch.write((text) => text.replace("LaunchConfiguration('stylus')]", "LaunchConfiguration('stylus'), ' ']").replace("'0.05'", "'0.08'"));
  // what launch files give, in the robot
  await window.file("measuring_cell.xacro");
  await window.status("measuring_cell.xacro");
  await window.go(...robot.find('name="stylus"', 8));
  assert.match(await window.hover("cell.launch.py"), /0\.08/);
  await window.command("Xacro: Select Root");
  await window.row("cell.launch.py").click();
  await window.status("stylus:=0.08");
  // from the launch file to the robot
  await window.file("cell.launch.py");
  const name = launch.find("' stylus:='", 4);
  await window.go(...name);
  await window.hover("stylus");
  await until("the declaration in the robot", async () => {
    await window.press("F12");
    const tab = window.page.locator('.tab.active[data-resource-name="measuring_cell.xacro"]');
    return tab.waitFor({ timeout: 3000 }).then(() => true, () => false);
  });
  await window.at(robot.find('name="stylus"')[0]);
  // completion in the strings of the launch file, and in the configuration
  const completes = async (row, done) => {
    const shown = window.page.locator(".suggest-widget.visible .monaco-list-row", { hasText: row }).first();
    await until(`${row} among the completions`, async () => {
      await window.press("Control+Space");
      return shown.waitFor({ timeout: 2000 }).then(() => true, () => false);
    });
    await until(`${row} completed`, async () => {
      if (await shown.isVisible()) await shown.click({ timeout: 2000 }).catch(() => undefined);
      await window.save();
      return done();
    });
  };
  await window.file("cell.launch.py");
  await window.go(...launch.find("' ']", 2));
  await completes("artefacts", () => launch.text().includes("' artefacts:=']"));
  await window.file("xacro-lint.toml");
  await window.go(...config.find("args = {  }", 9));
  await completes("stylus", () => config.text().includes("{ stylus =  }"));
  await window.go(...config.find("stylus =  }", 9));
  await completes("0.08", () => config.text().includes('{ stylus = "0.08" }'));
  // an argument gets another name in the robot, in the launch file and in the configuration
  await window.file("cell.launch.py");
  await window.go(...name);
  const box = window.page.locator(".rename-box input, input.rename-input").first();
  await until("the box for the new name", async () => {
    await window.press("F2");
    return box.waitFor({ timeout: 3000 }).then(() => true, () => false);
  });
  await box.fill("tip");
  await window.press("Enter");
  await window.page.locator('.tab[data-resource-name="cell.launch.py"].dirty').waitFor();
  await window.command("File: Save All");
  await robot.has('<xacro:arg name="tip"');
  await launch.has("' tip:='");
  await config.has("{ tip = ");
  assert.ok(launch.text().includes("LaunchConfiguration('stylus')"), "the argument of the launch file is another one");
});

test("rename-beside", "pick_arm", async (window) => {
  const config = "src/pick_arm_moveit_config/config";
  const arm = source(window, "src/pick_arm_description/urdf/arm_macro.xacro");
  const others = [
    source(window, `${config}/pick_arm.srdf`),
    source(window, `${config}/joint_limits.yaml`),
    source(window, `${config}/moveit_controllers.yaml`),
    source(window, "src/pick_arm_bringup/config/controllers.yaml"),
  ];
  await window.file("arm_macro.xacro");
  await window.status("pick_arm.urdf.xacro");
  await window.go(...arm.find('name="${prefix}wrist"', 17));
  const box = window.page.locator(".rename-box input, input.rename-input").first();
  await until("the box for the new name", async () => {
    await window.press("F2");
    return box.waitFor({ timeout: 3000 }).then(() => true, () => false);
  });
  await box.fill("roll");
  await window.press("Enter");
  await window.page.locator('.tab[data-resource-name="arm_macro.xacro"].dirty').waitFor();
  await window.command("File: Save All");
  await arm.has('name="${prefix}roll"');
  for (const file of others) {
    await file.has("left_roll");
    assert.ok(!file.text().includes("wrist"), file.file);
  }
  // a name that is typed in the SRDF and in YAML, and that the robot no longer has
  await window.file("pick_arm.srdf");
  await window.go(...others[0].find("left_roll", 9));
  await window.page.keyboard.type("x");
  assert.match(await window.problem("left_rollx"), /srdf-unknown-joint/);
  await window.file("controllers.yaml");
  await window.go(...others[3].find("left_roll", 9));
  await window.page.keyboard.type("y");
  assert.match(await window.problem("left_rolly"), /controller-unknown-joint/);
});

test("hover", "measuring_cell", async (window) => {
  const file = source(window, FURNITURE);
  await window.file("furniture.xacro");
  await window.status("measuring_cell.xacro");
  await window.go(...file.find("${table_height - top_size[2]}", 16));
  await window.hover("0.67");
}, { share: "reading" });

test("outline", "measuring_cell", async (window) => {
  await window.file("furniture.xacro");
  await window.status("measuring_cell.xacro");
  await window.press("Control+Shift+O");
  for (const name of ["table_height", "granite", "measuring_table"]) await window.row(name).waitFor();
  await window.press("Escape");
}, { share: "reading" });

test("format", "measuring_cell", async (window) => {
  const file = source(window, CELL);
  const good = file.text();
  file.write((text) => text.replace('  <link name="world"/>', '<link     name="world"/>').replace('    <origin xyz="-0.25', '\t\t\t<origin    xyz="-0.25'));
  await window.file("measuring_cell.xacro");
  await window.status("measuring_cell.xacro");
  await window.command("Format Document");
  await window.page.locator('.tab[data-resource-name="measuring_cell.xacro"].dirty').waitFor();
  await window.save();
  await until("the text as it was", () => file.text() === good);
});

test("expanded", "measuring_cell", async (window) => {
  const file = source(window, FURNITURE);
  const before = file.text();
  await window.file("furniture.xacro");
  await window.status("measuring_cell.xacro");
  const [line, column] = file.find('name="table_height" value="0.75"', 29);
  await window.go(...file.find('${table_height}"', 2));
  await window.command("Xacro: Open Expanded URDF to the Side");
  const shows = (part) => until(`the expanded robot shows ${part}`, async () => (await window.drawn("measuring_cell.urdf")).some((text) => text.includes(part)));
  // the cursor leads there
  await shows('xyz="0 0 0.75"');
  await window.editor.click();
  await window.go(line, column);
  await window.press("Delete");
  await window.page.keyboard.type("9");
  await window.go(...file.find('${table_height}"', 2));
  await shows('xyz="0 0 0.95"');
  assert.equal(file.text(), before, "nothing was saved");
  // broken text keeps the last good robot, with a banner
  await window.go(1, 1);
  await window.page.keyboard.type("<");
  await window.page.locator(".codelens-decoration", { hasText: "this is the robot as of" }).first().waitFor();
  await shows('xyz="0 0 0.95"');
  // at any place of the text: in the status bar, in the tab, on the text
  await window.status("this is the robot as of");
  await window.page.locator('.tab[aria-label*="measuring_cell.urdf"][aria-label*="this is the robot as of"], .tab[aria-label*="measuring_cell.urdf"] .monaco-icon-label[class*=decoration]').first().waitFor();
  if (values.shots) await window.shot(shot("expanded-stale.png"));
  await window.press("Backspace");
  await window.page.locator(".statusbar-item", { hasText: "this is the robot as of" }).first().waitFor({ state: "hidden" });
  await window.page.locator(".codelens-decoration", { hasText: "this is the robot as of" }).first().waitFor({ state: "hidden" });
  // and back: the cursor in the expanded text leads to the source
  const group = window.page.locator(".editor-group-container", { has: window.page.locator('.tab.active[aria-label*="measuring_cell.urdf"]') });
  await group.locator(".view-line", { hasText: '<link name="leg_front_left">' }).first().click();
  await window.page.locator(".editor-group-container [class*=ced-]").first().waitFor();
  await window.command("Xacro: Compare Expanded URDF with Saved Version");
  await window.page.locator(".tab.active", { hasText: "saved ↔ now" }).waitFor();
  await window.page.locator(".modified .line-insert").first().waitFor();
  // no source takes its place
  await window.page.waitForTimeout(2500);
  await window.page.locator(".tab.active", { hasText: "saved ↔ now" }).waitFor();
});

test("expanded-reading", "measuring_cell", async (window) => {
  await window.file("furniture.xacro");
  await window.status("measuring_cell.xacro");
  await window.command("Xacro: Open Expanded URDF to the Side");
  const group = window.page.locator(".editor-group-container", { has: window.page.locator('.tab.active[aria-label*="measuring_cell.urdf"]') });
  await group.locator(".view-line").first().click();
  await window.press("Control+Shift+O");
  await window.input.fill("@leg_front_left_joint");
  await window.row("leg_front_left_joint").waitFor();
  await window.press("Enter");
  assert.match(await window.hover("furniture.xacro"), /joint.*leg_front_left_joint.*fixed[^]*from furniture\.xacro:\d+[^]*called at furniture\.xacro:\d+/);
  if (values.shots) await window.shot(shot("expanded-hover.png"));
  await window.page.locator(".monaco-hover:visible a", { hasText: "furniture.xacro" }).first().click();
  await window.page.locator('.tab.active[data-resource-name="furniture.xacro"]').first().waitFor();
}, { share: "reading" });

test("root", "measuring_cell", async (window) => {
  const file = source(window, "src/fenn_support/urdf/fenn_macro.xacro");
  await window.file("fenn_macro.xacro");
  await window.status("fenn.xacro");
  await window.go(...file.find('"${prefix}base_link"', 4));
  assert.doesNotMatch(await window.hover("prefix"), /arm_/);
  await window.command("Xacro: Select Root");
  await window.row("measuring_cell.xacro").click();
  await window.status("measuring_cell.xacro");
  await window.editor.click();
  await window.go(...file.find('"${prefix}base_link"', 4));
  await window.hover("arm_");
  // arguments of the root
  await window.command("Xacro: Set Arguments");
  await window.row(/^\s*stylus/).click();
  await window.answer("stylus", "0.07");
  await window.status("stylus:=0.07");
  const probe = source(window, "src/gauge_probe_support/urdf/gauge_probe_macro.xacro");
  await window.file("gauge_probe_macro.xacro");
  await window.go(...probe.find("${stylus", 3));
  await window.hover("0.07");
  // kept as a preset, taken back, taken again
  await window.command("Xacro: Set Arguments");
  await window.row("Save as preset").click();
  await window.answer("Save as Preset", "long stylus");
  await window.command("Xacro: Set Arguments");
  await window.row("Defaults of the file").click();
  await window.status("2 arguments");
  await window.command("Xacro: Set Arguments");
  await window.row("long stylus").click();
  await window.status("stylus:=0.07");
  // a server that is started again gets told
  await window.command("Xacro: Restart Server");
  await window.page.locator(".statusbar-item", { hasText: "stylus:=0.07" }).waitFor({ state: "hidden" });
  await window.status("stylus:=0.07");
});

test("views", "measuring_cell", async (window) => {
  const file = source(window, FURNITURE);
  await window.file("furniture.xacro");
  await window.status("measuring_cell.xacro");
  await window.command("Focus on Kinematic Tree View");
  const row = (name) => window.page.locator(".sidebar .monaco-list-row", { hasText: name }).first();
  await row("arm_link_1").waitFor();
  await window.page.locator(".sidebar .pane-header", { hasText: "Roots" }).waitFor();
  await row("stylus").waitFor();
  await window.editor.click();
  await window.go(...file.find('name="table_height"', 8));
  await window.go(...file.find('<link name="table_top">', 8));
  await window.page.locator(".sidebar .monaco-list-row.selected", { hasText: "table_top" }).first().waitFor();
  await window.command("Xacro: Show Include Graph");
  await window.webview.locator(".node", { hasText: "joints" }).or(window.webview.locator(".node", { hasText: "fenn_macro.xacro" })).first().waitFor();
  // all of it is seen first, and again with Fit
  const width = () => window.webview.locator("svg").first().evaluate((svg) => [svg.clientWidth || svg.getBoundingClientRect().width, svg.parentElement.clientWidth]);
  const [wide, room] = await width();
  assert.ok(wide <= room + 1, `${wide} of ${room}`);
  await window.webview.locator(".bar button", { hasText: "+" }).click();
  assert.ok((await width())[0] > wide);
  await window.webview.locator(".bar button", { hasText: "Fit" }).click();
  assert.ok(Math.abs((await width())[0] - wide) < 2);
  await window.webview.locator(".node", { hasText: "fenn_macro.xacro" }).first().click();
  await window.page.locator('.tab.active[data-resource-name="fenn_macro.xacro"]').waitFor();
  await window.command("Xacro: Copy Diagnostic Report");
  await window.notification("clipboard");
  const report = await window.page.evaluate(() => navigator.clipboard.readText());
  assert.match(report, /server: xacro-lsp \d+\.\d+\.\d+, running/);
}, { share: "reading" });

// a server may be older than these requests; then the extension says so
test("one-call", "measuring_cell", async (window) => {
  const file = source(window, FURNITURE);
  await window.file("furniture.xacro");
  await window.status("measuring_cell.xacro");
  await window.go(...file.find('name="leg_back_left"', 8));
  await window.command("Xacro: Expand Macro at Cursor");
  const expanded = window.page.locator('.tab[aria-label*="table_leg"]');
  const unknown = window.page.locator(".notification-list-item", { hasText: "has no `xacro/expandAt` yet" });
  await expanded.or(unknown).first().waitFor();
  if (await unknown.isVisible()) return;
  await until("one leg", async () => (await window.drawn("table_leg")).some((text) => text.includes('name="leg_back_left_joint"')));
  await window.editor.click();
  await window.go(...file.find('<origin xyz="0 0 ${-height / 2}"', 3));
  await window.command("Xacro: Select Instance");
  const [line] = file.find('name="leg_back_left"');
  await window.row(`furniture.xacro:${line}`).click();
  await window.status(`table_leg @ furniture.xacro:${line}`);
  await until("the value of the call that was picked alone", async () =>
    (await window.drawn("furniture.xacro")).some((text) => text.includes('<link name="${name}') && /leg_back_left\W*$/.test(text)),
  );
});

test("lenses", "measuring_cell", async (window) => {
  await window.file("furniture.xacro");
  await window.status("measuring_cell.xacro");
  await window.go(1, 1);
  const lens = (text) => window.page.locator(".editor-group-container.active .codelens-decoration a", { hasText: text }).first();
  await lens("4 calls in").click();
  await window.page.locator(".peekview-widget .monaco-list-row").first().waitFor();
  await window.press("Escape");
  await window.page.locator(".peekview-widget").first().waitFor({ state: "hidden" });
  await window.file("measuring_cell.xacro");
  await lens("Expand").click();
  await window.page.locator('.tab[aria-label*="measuring_cell.urdf"]').waitFor();
}, { share: "reading" });

test("untrusted", "broken_cell", async (window, server) => {
  mkdirSync(join(window.folder, ".vscode"), { recursive: true });
  const trap = join(window.folder, "started");
  const program = join(window.folder, "server.sh");
  writeFileSync(program, `#!/bin/sh\ntouch ${trap}\n`, { mode: 0o755 });
  writeFileSync(join(window.folder, ".vscode", "settings.json"), JSON.stringify({ "xacro.server.path": program }));
  await window.page.reload();
  await window.page.locator(".explorer-folders-view .monaco-list-row").first().waitFor();
  await window.page.locator(".part.banner", { hasText: "Restricted Mode" }).or(window.page.locator(".statusbar-item", { hasText: "Restricted Mode" })).first().waitFor();
  await window.file("broken_cell.xacro");
  await window.problem("reference_bals");
  assert.equal(server.servers().length, 1);
  assert.ok(!existsSync(trap), "a program of the workspace was started");
}, { profile: "trust" });

test("no-server", "measuring_cell", async (window, server) => {
  await window.file("measuring_cell.xacro");
  await window.notification("/no/such/program, which is not a program");
  await window.page.locator(".notification-list-item .monaco-button", { hasText: "Open Settings" }).first().waitFor();
  assert.equal(server.servers().length, 0);
  // colors are there all the same
  await window.page.locator(".view-line span[class*=mtk]", { hasText: "measuring_table" }).first().waitFor();
}, { profile: "missing" });

test("restart", "broken_cell", async (window, server) => {
  const messages = () => window.page.locator(".notification-list-item-message").allInnerTexts();
  /** Ends the server while it owes answers. */
  const crash = async (id) => {
    process.kill(id, "SIGSTOP");
    await window.page.keyboard.type(" ");
    await window.press("Control+Space");
    await window.page.waitForTimeout(500);
    process.kill(id, "SIGKILL");
  };
  await window.file("broken_cell.xacro");
  await window.problem("reference_bals");
  await window.editor.click();
  await window.go(...source(window, BROKEN).find('<link name="world"/>', 6));
  const [first] = server.servers();
  await crash(first);
  await window.notification("stopped unexpectedly and was restarted");
  const second = await until("another server", () => server.servers().find((id) => id !== first));
  await window.page.waitForTimeout(2000);
  assert.equal((await messages()).length, 1, (await messages()).join("; "));
  await window.command("Notifications: Clear All Notifications");
  // it answers: a new mistake is found
  await window.editor.click();
  await window.go(...source(window, BROKEN).find("xacro:broken_probe", 12));
  await window.page.keyboard.type("x");
  await window.problem("brokenx_probe");
  await window.editor.click();
  await crash(second);
  await window.notification("stopped twice");
  await window.page.waitForTimeout(2000);
  assert.equal((await messages()).length, 1, (await messages()).join("; "));
  assert.equal(server.servers().length, 0);
  // commands say so, once, and can start it
  await window.status("xacro");
  for (const title of ["Xacro: Set Arguments", "Xacro: Open Preview", "Xacro: Open Expanded URDF to the Side"]) {
    // the workbench closes a message before it shows the same again: none is left to be taken for the next one
    await window.command("Notifications: Clear All Notifications");
    await until("no message", async () => (await messages()).length === 0);
    await window.command(title);
    await window.notification("language server is not running");
    await window.page.waitForTimeout(1000);
    assert.equal((await messages()).length, 1, (await messages()).join("; "));
  }
  if (values.shots) await window.shot(shot("not-running.png"));
  await window.page.locator(".notification-list-item .monaco-button", { hasText: "Restart" }).first().click();
  await until("a third server", () => server.servers().length === 1);
  await window.status("broken_cell.xacro");
  await window.problem("brokenx_probe");
});

test("values", "measuring_cell", async (window) => {
  const file = source(window, CELL);
  await window.file("measuring_cell.xacro");
  await window.status("measuring_cell.xacro");
  const [line] = file.find('<link name="world"/>');
  const list = window.page.locator(".suggest-widget.visible");
  const row = (text) => list.locator(".monaco-list-row", { hasText: text }).first();
  for (const [typed, attribute, value] of [
    ["<joint name='q' type='fixed'><parent li", "link", "world"],
    ["<mesh file", "filename", "package://measuring_cell/"],
  ]) {
    await window.go(line, 3 + '<link name="world"/>'.length);
    await window.press("Enter");
    await window.page.keyboard.type(typed);
    await row(attribute).waitFor();
    await window.press("Tab");
    // nothing is typed
    await row(value).waitFor();
    if (values.shots) await window.shot(shot(`values-${attribute}.png`));
    await window.press("Escape");
    await window.press("Escape");
    await window.command("File: Revert File");
  }
  // where there are no values, nothing says so
  await window.go(line, 3 + '<link name="world"/>'.length);
  await window.press("Enter");
  await window.page.keyboard.type("<link na");
  await row("name").waitFor();
  await window.press("Tab");
  await until("the attribute", async () => (await window.drawn("measuring_cell.xacro")).some((text) => text.includes('<link name=""')));
  await window.page.waitForTimeout(1000);
  assert.equal(await window.page.locator(".suggest-widget.visible").count(), 0);
});

test("end-tag", "measuring_cell", async (window) => {
  const file = source(window, CELL);
  const before = file.text().split("</link>").length;
  await window.file("measuring_cell.xacro");
  await window.status("measuring_cell.xacro");
  const [line] = file.find('<link name="world"/>');
  await window.go(line, 3 + '<link name="world"/>'.length);
  const shows = (part) => until(`the text ${part}`, async () => (await window.drawn("measuring_cell.xacro")).some((text) => part.test(text)));
  await window.press("Enter");
  await window.page.keyboard.type("<link name='q'>");
  await shows(/<link name='q'><\/link>/);
  await window.press("Enter");
  await shows(/^ {2}<\/link>/);
  await window.page.keyboard.type("<visual/>");
  await window.press("Enter");
  // by habit, though it is there already
  await window.page.keyboard.type("</link>", { delay: 60 });
  await window.page.waitForTimeout(1000);
  await window.save();
  await file.has("<visual/>");
  if (values.shots) await window.shot(shot("end-tag-typed.png"));
  assert.equal(file.text().split("</link>").length, before + 1, file.text());
  assert.doesNotMatch(file.text(), /<linklink|<\/link><\/link>/);
});

test("configure-rule", "broken_cell", async (window) => {
  writeFileSync(join(window.folder, "xacro-lint.toml"), "# ours\n[severity]\n");
  await window.file("broken_cell.xacro");
  await window.problem("reference_bals");
  await window.editor.click();
  await window.go(...source(window, BROKEN).find("reference_bals", 3));
  await window.press("Control+.");
  await window.page.locator(".action-widget .monaco-list-row.focused").waitFor();
  const chosen = window.page.locator(".action-widget .monaco-list-row.focused", { hasText: "Disable `undefined-macro` for this project" });
  await until("the action", async () => {
    if ((await chosen.count()) > 0) return true;
    await window.press("ArrowDown");
    return false;
  });
  await window.press("Enter");
  await window.page.locator('.tab[data-resource-name="xacro-lint.toml"].dirty').waitFor();
  await window.command("File: Save All");
  await source(window, "xacro-lint.toml").has("undefined-macro");
  await window.page.locator(".markers-panel .monaco-list-row", { hasText: "reference_bals" }).first().waitFor({ state: "hidden" });
});

test("rule-page", "broken_cell", async (window) => {
  await window.file("broken_cell.xacro");
  await window.problem("reference_bals");
  await window.page.locator(".markers-panel .monaco-list-row a", { hasText: "undefined-macro" }).first().click();
  await window.page.locator('.tab.active[aria-label*="undefined-macro"]').waitFor();
  await until("the page of the rule", async () => (await window.drawn("undefined-macro")).some((text) => text.includes("undefined-macro")));
});

test("presets", "measuring_cell", async (window) => {
  const configuration = (long) => `[[roots]]\nfile = "${CELL}"\nargs = { stylus = "0.05" }\npresets.long = { stylus = "${long}" }\npresets.short = { stylus = "0.03" }\n`;
  writeFileSync(join(window.folder, "xacro-lint.toml"), configuration("0.2"));
  await window.file("measuring_cell.xacro");
  await window.status("stylus:=0.05");
  await window.command("Xacro: Set Arguments");
  const rows = window.page.locator(".quick-input-widget .monaco-list-row");
  await window.row("short").waitFor();
  const names = (await rows.allInnerTexts()).map((text) => text.replace(/\s+/g, " ").trim());
  if (values.shots) await window.shot(shot("presets-list.png"));
  assert.ok(names[0].includes("default") && names[1].includes("long") && names[1].includes("stylus:=0.2"), names.join("; "));
  await window.row("long").click();
  await window.status("stylus:=0.2");
  // remembered by its name: with what it means when the window is loaded again
  writeFileSync(join(window.folder, "xacro-lint.toml"), configuration("0.3"));
  await window.page.waitForTimeout(1000);
  await Promise.all([window.page.waitForEvent("load"), window.command("Developer: Reload Window")]);
  await window.status("stylus:=0.3");
  await window.command("Xacro: Set Arguments");
  await window.row("default").click();
  await window.status("stylus:=0.05");
});

/** Rows of the problems panel with a text. */
async function problems(window, text) {
  await window.problem(text);
  const rows = await window.page.locator(".markers-panel .monaco-list-row", { hasText: text }).allInnerTexts();
  return rows.map((row) => row.replace(/\s+/g, " "));
}

test("check-workspace", "measuring_cell", async (window, server) => {
  // a finding of each kind: in an open and in a closed file, with the preset that is looked at and with another one
  const robot = source(window, CELL);
  const ghost = '  <xacro:if value="${stylus_now > 0.1}"><joint name="ghost" type="fixed"><parent link="world"/><child link="ghost_link"/></joint></xacro:if>\n';
  const always = '  <joint name="always" type="fixed"><parent link="world"/><child link="always_link"/></joint>\n';
  robot.write((text) => text.replace("</robot>", `${ghost}${always}</robot>`).replace('  <link name="world"/>', '  <xacro:property name="stylus_now" value="$(arg stylus)"/>\n  <link name="world"/>'));
  writeFileSync(join(window.folder, "other.urdf"), '<robot name="other"><link name="base"/><joint name="closed" type="fixed"><parent link="base"/><child link="closed_link"/></joint></robot>\n');
  writeFileSync(join(window.folder, "xacro-lint.toml"), `[[roots]]\nfile = "${CELL}"\nargs = { stylus = "0.05" }\npresets.long = { stylus = "0.2" }\n[[roots]]\nfile = "other.urdf"\n`);
  await window.file("measuring_cell.xacro");
  await window.problem("always_link");
  await window.command("Xacro: Check Workspace");
  await window.notification("with all robots and presets: 3 errors in 2 files");
  if (values.shots) await window.shot(shot("check-workspace-message.png"));
  await window.page.locator(".notification-list-item .monaco-button", { hasText: "Show Problems" }).first().click();
  assert.match((await problems(window, "closed_link")).join(), /closed_link.*xacro-lint/);
  assert.match((await problems(window, "ghost_link")).join(), /stylus:=0\.2/);
  // what the server shows is not shown again
  assert.equal((await problems(window, "always_link")).length, 1);
  if (values.shots) {
    await window.page.locator(".part.panel").getByPlaceholder(/^Filter/).first().fill("");
    await window.shot(shot("check-workspace-problems.png"));
  }
  // in a file that is opened, the server's takes its place
  await window.file("other.urdf");
  await until("one finding, of the server", async () => {
    const rows = await problems(window, "closed_link");
    return rows.length === 1 && /closed_link.* xacro undefined-link/.test(rows[0]);
  });
  // fixed, and checked again by the task
  writeFileSync(join(window.folder, "other.urdf"), '<robot name="other"><link name="base"/></robot>\n');
  robot.write((text) => text.replace(ghost, "").replace(always, "").replace(/ *<xacro:property name="stylus_now".*\n/, ""));
  await window.command("Tasks: Run Task");
  // the one that ran is the first of the list
  await window.row("check workspace").click();
  await window.notification("with all robots and presets: no findings");
  assert.equal(server.servers().length, 1, "the program of the check ended");
});

test("activation", "measuring_cell", async (window, server) => {
  await window.file("measuring_cell.xacro");
  await window.status("measuring_cell.xacro");
  await window.command("Developer: Show Running Extensions");
  const row = window.page.locator(".runtime-extensions-editor .monaco-list-row", { hasText: "Xacro and URDF" }).first();
  await row.waitFor();
  const shown = (await row.innerText()).replace(/\s+/g, " ");
  const time = /Activation: (\d+)ms/.exec(shown);
  assert.ok(time, shown);
  console.log(`     activation: ${time[1]} ms; ${/activated in [\d.]+ ms/.exec(server.extensionLog())?.[0]}`);
}, { share: "reading" });

test("preview", "measuring_cell", async (window) => {
  const file = source(window, FURNITURE);
  await window.file("furniture.xacro");
  await window.status("measuring_cell.xacro");
  await window.go(...file.find('name="table_height"', 8));
  await window.command("Xacro: Open Preview");
  const page = window.webview;
  const body = (name) => page.locator("body").getAttribute(`data-${name}`);
  await until("the robot with its meshes", async () => (await body("ok")) === "true" && (await body("loading")) === "0");
  const canvas = page.locator("canvas").first();
  // pixels that changed since the last call; the first call sees none
  const changed = () =>
    canvas.evaluate((element) => {
      const { width, height } = element;
      const copy = new OffscreenCanvas(width, height).getContext("2d");
      copy.drawImage(element, 0, 0);
      const { data } = copy.getImageData(0, 0, width, height);
      const before = window.pixelsBefore ?? data;
      window.pixelsBefore = data;
      let count = 0;
      for (let at = 0; at < data.length; at += 4) {
        const differs = [0, 1, 2].some((channel) => Math.abs(data[at + channel] - before[at + channel]) > 8);
        if (differs) count++;
      }
      return data.length === before.length ? count : -1;
    });
  await changed();
  await until("a still picture", async () => (await changed()) === 0);
  // a slider moves the arm
  const slider = page.locator('[data-joint="arm_joint_2"] input[type=range]');
  await slider.evaluate((input) => {
    input.value = String(Number(input.min) + 0.8 * (Number(input.max) - Number(input.min)));
    input.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await until("other pixels", async () => (await changed()) > 200);
  await until("a still picture again", async () => (await changed()) === 0);
  // typing moves it too, without saving
  const revision = Number(await body("revision"));
  await window.editor.click();
  await window.go(...file.find('name="table_height" value="0.75"', 29));
  await window.press("Delete");
  await window.page.keyboard.type("9");
  await until("the next revision", async () => Number(await body("revision")) > revision);
  await until("pixels of a higher table", async () => (await changed()) > 200);
  // a click on a link leads to its source
  await until("the leg under the pointer", async () => {
    const position = await canvas.evaluate((element) => {
      const { stage, views } = window.xacroViewer;
      const view = views.get("main");
      const center = view.box("leg_front_right").getCenter(stage.camera.position.clone()).project(stage.camera);
      const { width, height } = element.getBoundingClientRect();
      return { x: ((center.x + 1) / 2) * width, y: ((1 - center.y) / 2) * height };
    });
    await canvas.click({ position });
    return (await body("selected"))?.includes("leg_front_right");
  });
  const [line] = file.find('<link name="${name}">');
  await window.at(line);
  // the cursor outlines what the text makes
  await window.editor.click();
  await window.go(...file.find('<link name="${ball.name}">', 8));
  await until("the balls outlined", async () => (await body("selected"))?.includes("ball_near"));
  // a window that is loaded again shows it again
  await window.save();
  await window.page.locator('.tab[data-resource-name="furniture.xacro"]:not(.dirty)').waitFor();
  await Promise.all([window.page.waitForEvent("load"), window.command("Developer: Reload Window")]);
  await until("the robot after a reload", async () => (await body("ok").catch(() => null)) === "true");
}, { needs: "viewer/viewer.js" });

const web = { profile: "web", share: "web" };

test("web-problems", "broken_cell", async (window, server) => {
  const file = source(window, BROKEN);
  await window.file("broken_cell.xacro");
  for (const [part, message, rule] of [
    ["<xacro:reference_bals", "reference_bals", "undefined-macro"],
    ['<property name="stylus_length"', "`property` is missing", "unprefixed-xacro-tag"],
    ['<child link="probe_body"', "has more than one parent joint", "multiple-parents"],
  ]) {
    const shown = await window.problem(message);
    assert.ok(shown.includes(rule) && shown.includes(`[Ln ${file.find(part)[0]}, `), shown);
  }
  // names of files that are read by nobody are known, too
  assert.match(await window.problem("Link_3.stl"), /mesh-case-mismatch/);
  assert.deepEqual(server.servers(), [], "no program runs");
}, web);

test("web-reading", "broken_cell", async (window) => {
  const file = source(window, BROKEN);
  await window.file("broken_cell.xacro");
  await window.editor.click();
  await window.go(...file.find("{stylus_length}", 3));
  assert.match(await window.hover("stylus_length"), /0\.05/);
  await window.go(...file.find("<xacro:measuring_table", 12));
  await until("the definition in the included file", async () => {
    await window.press("F12");
    const tab = window.page.locator('.tab.active[data-resource-name="furniture.xacro"]');
    return tab.waitFor({ timeout: 3000 }).then(() => true, () => false);
  });
}, web);

test("web-typing", "broken_cell", async (window) => {
  const file = source(window, BROKEN);
  await window.file("broken_cell.xacro");
  await window.editor.click();
  const [line] = file.find('<link name="world"/>');
  await window.go(line, 3 + '<link name="world"/>'.length);
  await window.press("Enter");
  await window.page.keyboard.type("<xacro:refer", { delay: 60 });
  await window.page.locator(".suggest-widget.visible .monaco-list-row", { hasText: "reference_balls" }).first().waitFor();
  await window.press("Escape");
  await window.command("File: Revert File");
  await window.page.locator(".tab.dirty").waitFor({ state: "detached" });
  // a keystroke makes a finding
  await window.go(...file.find("xacro:broken_probe", 12));
  await window.page.keyboard.type("x");
  await window.problem("brokenx_probe");
  await window.command("File: Revert File");
}, web);

test("web-files", "broken_cell", async (window) => {
  // what other programs do to the files is seen
  source(window, "src/broken_cell/urdf/furniture.xacro").write((text) => text.replace('name="table_height" value="0.75"', 'name="table_hight" value="0.75"'));
  await window.file("broken_cell.xacro");
  assert.match(await window.problem("table_height"), /is not defined/);
}, web);

test("web-quick-fix", "broken_cell", correctsMacro, web);

test("web-preview", "measuring_cell", async (window) => {
  await window.file("measuring_cell.xacro");
  await window.status("measuring_cell.xacro");
  await window.command("Xacro: Open Preview");
  const body = (name) => window.webview.locator("body").getAttribute(`data-${name}`);
  // the meshes come by messages, too
  await until("the robot with its meshes", async () => (await body("ok")) === "true" && (await body("loading")) === "0");
}, { profile: "web", needs: "viewer/viewer.js" });

async function main() {
  const program = resolve(values["code-server"]);
  const browser = await openBrowser();
  const chosen = tests.filter(({ name }) => !only || only.includes(name));
  let failed = 0;
  let skipped = 0;
  for (const [profile, options] of Object.entries(PROFILES)) {
    const own = chosen.filter((each) => each.profile === profile);
    if (own.length === 0) continue;
    const server = new CodeServer(program, fresh(join(out, `profile-${profile}`)), options);
    await server.install(resolve(values[options.vsix ?? "vsix"]));
    await server.start();
    for (const share of new Set(own.map((each) => each.share))) {
      const group = own.filter((each) => each.share === share);
      const lacking = group.find(({ needs }) => needs && !server.hasInside(needs));
      if (lacking) {
        skipped += group.length;
        console.log(`skip ${share}: the extension has no ${lacking.needs}`);
        continue;
      }
      failed += await runGroup(browser, server, share, group);
    }
    writeFileSync(join(out, `extension-${profile}.log`), server.extensionLog());
    await server.stop();
  }
  await browser.close();
  console.log(`vscode: ${chosen.length - failed - skipped} passed, ${failed} failed${skipped > 0 ? `, ${skipped} skipped` : ""}`);
  process.exitCode = failed === 0 && chosen.length > 0 ? 0 : 1;
}

/** How often a test may try: keys and menus of a real workbench are lost now and then on a busy machine. */
const TURNS = 3;

/** Runs tests in one window; the number of those that failed. */
async function runGroup(browser, server, share, group) {
  const [{ example }] = group;
  const open = (place) => {
    const folder = join(fresh(join(out, "workspaces", place)), example);
    cpSync(join(examples, example), folder, { recursive: true });
    return Window.open(browser, server, folder);
  };
  let failed = 0;
  let window;
  for (const { name, run } of group) {
    for (let turn = 1; turn <= TURNS; turn++) {
      const begin = Date.now();
      const took = () => `${((Date.now() - begin) / 1000).toFixed(1)} s`;
      try {
        window ??= await open(turn === 1 ? share : `${name}-${turn}`);
        await run(window, server);
        console.log(`ok   ${name} (${took()})`);
        if (values.shots) await window.shot(shot(`${name}.png`));
        break;
      } catch (error) {
        const last = turn === TURNS;
        failed += last ? 1 : 0;
        console.log(`${last ? "FAIL" : "once more:"} ${name} (${took()})\n${error.stack}`);
        await window?.shot(shot(`${name}-failed-${turn}.png`)).catch(() => undefined);
        // what the failed one left must not disturb the next
        await window?.close();
        window = undefined;
      }
    }
  }
  await window?.close();
  return failed;
}

function shot(name) {
  const folder = join(out, "shots");
  mkdirSync(folder, { recursive: true });
  return join(folder, name);
}

await main();
