import assert from "node:assert/strict";
import { chmodSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { bannerText, callText, firstLink, linkOfLine } from "../src/expandedText";
import { symbolsAt, symbolsOf } from "../src/expandedSymbols";
import { checkArguments, findingsOf, isShown, lineOf, summary } from "../src/findings";
import { includesOf } from "../src/includes";
import { lintBeside, locateServer } from "../src/locate";
import { fromViewer } from "../src/previewMessages";
import { chosenSettings } from "../src/settings";
import { startsEmptyValue } from "../src/snippets";
import { Names, namedFolders } from "../src/web/uris";
import { layout } from "../src/webview/layout";

describe("the server is found", () => {
  let folder = "";
  const around = (setting: string, environment: Record<string, string> = {}, extension = "none") => ({
    setting,
    extensionPath: join(folder, extension),
    environment,
    home: join(folder, "home"),
    windows: false,
  });
  const program = (...parts: string[]): string => {
    const file = join(folder, ...parts);
    mkdirSync(join(file, ".."), { recursive: true });
    writeFileSync(file, "");
    chmodSync(file, 0o755);
    return file;
  };

  before(() => {
    folder = mkdtempSync(join(tmpdir(), "xacro-locate-"));
  });
  after(() => rmSync(folder, { recursive: true }));

  test("by the setting, then in the extension, then on the search path, then where cargo puts it", () => {
    assert.ok("message" in locateServer(around("")));
    const cargo = program("home", ".cargo", "bin", "xacro-lsp");
    assert.deepEqual(locateServer(around("")), { command: cargo, from: "PATH" });
    const onPath = program("bin", "xacro-lsp");
    const path = { PATH: `relative:${join(folder, "bin")}` };
    assert.deepEqual(locateServer(around("", path)), { command: onPath, from: "PATH" });
    const bundled = program("extension", "server", "xacro-lsp");
    assert.deepEqual(locateServer(around("", path, "extension")), { command: bundled, from: "extension" });
    const own = program("home", "own");
    assert.deepEqual(locateServer(around("~/own", path, "extension")), { command: own, from: "setting" });
    assert.deepEqual(locateServer(around("xacro-lsp", path)), { command: onPath, from: "setting" });
  });

  test("the program of the command line lies beside it", () => {
    const server = program("both", "xacro-lsp");
    assert.ok("message" in (lintBeside(server, false) as object));
    const lint = program("both", "xacro-lint");
    assert.equal(lintBeside(server, false), lint);
  });

  test("a setting that names nothing is an error, never passed over", () => {
    program("bin", "xacro-lsp");
    const found = locateServer(around("/no/such/program", { PATH: join(folder, "bin") }));
    assert.ok("message" in found && found.message.includes("/no/such/program"));
    const plain = join(folder, "plain");
    writeFileSync(plain, "");
    chmodSync(plain, 0o644);
    assert.ok("message" in locateServer(around(plain)), "a file that cannot be started is no program");
  });
});

describe("settings", () => {
  test("only what somebody chose is sent", () => {
    const values: Record<string, object> = {
      "xacro.target": {},
      "xacro.format.lineWidth": { globalValue: 90, workspaceFolderValue: 100 },
      "xacro.format.selfClose": { workspaceValue: true },
      "xacro.diagnostics.rules": { globalValue: { a: "off", b: "hint" }, workspaceValue: { b: "error" } },
      "xacro.server.path": { globalValue: "/x" },
    };
    assert.deepEqual(
      chosenSettings(Object.keys(values), (key) => values[key]),
      {
        format: { lineWidth: 100, selfClose: true },
        diagnostics: { rules: { a: "off", b: "error" } },
      },
    );
  });
});

describe("the link of a line", () => {
  const lines = `<robot name="r">
  <link name="world"/>
  <link name="arm">
    <visual>
      <origin xyz="0 0 1"/>
    </visual>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="world"/>
    <child link="arm"/>
  </joint>
  <gazebo reference="arm">
    <mu1>0.3</mu1>
  </gazebo>
  <ros2_control name="c" type="system">
    <joint name="shoulder">
      <param name="min">0</param>
    </joint>
  </ros2_control>
</robot>`.split("\n");
  const table: [line: number, link: string | undefined][] = [
    [0, undefined],
    [1, "world"],
    [4, "arm"],
    [7, "arm"],
    [8, "arm"],
    [12, "arm"],
    [14, undefined],
    [16, undefined],
  ];
  for (const [line, link] of table) {
    test(`line ${line} is ${link ?? "none"}`, () => assert.equal(linkOfLine(lines, line), link));
  }

  test("the first link of a text", () => {
    assert.equal(firstLink(lines.slice(2).join("\n")), "arm");
    assert.equal(firstLink("<joint/>"), undefined);
  });

  test("a line behind the end counts as the last one", () => {
    assert.equal(linkOfLine(['<link name="a"/>'], 9), "a");
  });
});

test("calls of a macro in a list", () => {
  assert.equal(callText("macro `leg` in `leg` at robot.xacro:7"), "leg @ robot.xacro:7");
  assert.equal(callText("call of `leg`"), "call of `leg`");
});

test("the banner counts errors and says when", () => {
  const time = new Date(2026, 0, 2, 3, 4, 5);
  assert.equal(bannerText(1, time), "1 error in the sources: this is the robot as of 03:04:05");
  assert.match(bannerText(2, time), /^2 errors /);
});

describe("messages of the viewer", () => {
  const range = { start: { line: 1, character: 2 }, end: { line: 3, character: 4 } };
  const location = { uri: "file:///a.xacro", range };

  test("known ones come through, with nothing besides what is known", () => {
    assert.deepEqual(fromViewer({ type: "ready", more: 1 }), { type: "ready" });
    assert.deepEqual(fromViewer({ type: "open", location }), { type: "open", location });
    assert.deepEqual(fromViewer({ type: "select", link: "a", joint: 3 }), { type: "select", link: "a" });
    assert.deepEqual(fromViewer({ type: "mesh", mesh: "m1" }), { type: "mesh", mesh: "m1" });
    assert.deepEqual(fromViewer({ type: "root", root: { uri: "file:///a", args: { x: "1", y: 2 } }, compare: null }), {
      type: "root",
      root: { uri: "file:///a", args: { x: "1" } },
      compare: null,
    });
  });

  test("others do not", () => {
    const others = [
      null,
      "ready",
      [],
      {},
      { type: "eval" },
      { type: "mesh", mesh: 1 },
      { type: "open", location: { uri: "command:rm", range } },
      { type: "open", location: { uri: "file:///a", range: { start: { line: -1, character: 0 }, end: range.end } } },
      { type: "root", root: { uri: "https://example.org" } },
    ];
    for (const message of others) assert.equal(fromViewer(message), undefined, JSON.stringify(message));
  });
});

test("includes of a text, with the places of their file names", () => {
  const text = `<robot>
  <!-- <xacro:include filename="no.xacro"/> -->
  <xacro:include filename="a.xacro"/>
  <xacro:include ns="x"
                 filename='$(find p)/b.xacro'/>
  <include filename="no.xacro"/>
</robot>`;
  assert.deepEqual(includesOf(text), [
    { filename: "a.xacro", line: 2, start: 27, end: 34 },
    { filename: "$(find p)/b.xacro", line: 4, start: 27, end: 44 },
  ]);
});

describe("the layout of graphs", () => {
  test("each node stands behind all that point to it", () => {
    const places = layout(
      ["a", "b", "c", "d"],
      [
        ["a", "b"],
        ["a", "c"],
        ["b", "c"],
        ["a", "d"],
      ],
    );
    assert.deepEqual(
      ["a", "b", "c", "d"].map((id) => places.get(id)?.column),
      [0, 1, 2, 1],
    );
    assert.notEqual(places.get("b")?.row, places.get("d")?.row);
  });

  test("circles end", () => {
    const places = layout(
      ["a", "b"],
      [
        ["a", "b"],
        ["b", "a"],
        ["a", "a"],
      ],
    );
    assert.equal(places.size, 2);
  });
});

describe("files of a workspace in the worker", () => {
  const names = new Names(namedFolders(["vscode-vfs://github/acme/cell", "memfs:/acme%20ltd/cell/", "memfs:/acme%20ltd/cell/inner"]));

  test("have other names there, and their own in the editor", () => {
    for (const [own, there] of [
      ["vscode-vfs://github/acme/cell", "file:///workspace/cell"],
      ["vscode-vfs://github/acme/cell/a%20b%28c%29.xacro", "file:///workspace/cell/a%20b%28c%29.xacro"],
      ["memfs:/acme%20ltd/cell/x#L3", "file:///workspace/cell-2/x#L3"],
      ["memfs:/acme%20ltd/cell/inner/x", "file:///workspace/inner/x"],
    ] as const) {
      assert.deepEqual(names.toWorker({ uri: own }), { uri: there });
      assert.deepEqual(names.fromWorker({ uri: there }), { uri: own });
    }
    assert.equal(names.path("memfs:/acme%20ltd/cell/a%20b"), "/workspace/cell-2/a b");
    assert.equal(names.uri("/workspace/cell-2/a b"), "memfs:/acme%20ltd/cell/a%20b");
    // as the server may write it
    assert.deepEqual(names.fromWorker(["file:///workspace/cell/a(b).xacro"]), ["vscode-vfs://github/acme/cell/a%28b%29.xacro"]);
  });

  test("are found as keys and in links, not in texts", () => {
    const [own, there] = ["vscode-vfs://github/acme/cell/x", "file:///workspace/cell/x"];
    assert.deepEqual(names.fromWorker({ changes: { [there]: [{ newText: there }] } }), { changes: { [own]: [{ newText: there }] } });
    assert.deepEqual(names.fromWorker({ value: `see [x](${there}#L2), ${there}` }), { value: `see [x](${own}#L2), ${own}` });
    assert.deepEqual(names.toWorker({ contentChanges: [{ text: own }], data: [1, 2] }), { contentChanges: [{ text: own }], data: [1, 2] });
  });

  test("of no folder stay as they are", () => {
    for (const uri of ["vscode-vfs://github/acme/cellar/x", "untitled:Untitled-1", "file:///workspace/other/x"]) {
      assert.deepEqual(names.fromWorker(names.toWorker([uri])), [uri]);
    }
    assert.equal(names.path("untitled:Untitled-1"), undefined);
  });

  test("are asked about by the scheme of the workspace", () => {
    assert.deepEqual(names.fromWorker({ filters: [{ scheme: "file" }] }), { filters: [{ scheme: "vscode-vfs" }] });
  });
});

describe("the check of the workspace", () => {
  const one = (name: string, severity: string, row: number, related: object[] = []) => ({
    ...{ name, severity, message: `about ${name} [root a.xacro]`, filename: "urdf/a.xacro" },
    ...{ location: { row, column: 3 }, end_location: { row, column: 9 }, related },
  });
  const call = { filename: "urdf/b.xacro", location: { row: 7, column: 1 }, end_location: { row: 7, column: 5 }, message: "in this call" };

  test("has the settings that were chosen", () => {
    const settings = { packagePaths: ["../ws"], diagnostics: { rules: { "zero-mass": "off" } } };
    assert.deepEqual(checkArguments(settings, ["--show", "info"]), [
      ...["check", "--format", "json", "--settings", JSON.stringify(settings), "--show", "info"],
    ]);
    assert.deepEqual(checkArguments({}, []), ["check", "--format", "json"]);
  });

  test("takes findings from the output", () => {
    const list = findingsOf(JSON.stringify([one("orphan-link", "error", 2), one("zero-mass", "warning", 4)]));
    assert.ok(list?.[0] && list[1]);
    assert.equal(lineOf(list[0]), "urdf/a.xacro:2:3: error: about orphan-link [root a.xacro] [orphan-link]");
    assert.deepEqual([list[1].line, list[1].column, list[1].endLine, list[1].endColumn], [3, 2, 3, 8]);
    assert.equal(summary(list), "1 error, 1 warning in 1 file");
    assert.equal(summary([]), "no findings");
    assert.deepEqual(findingsOf("[]"), []);
    for (const output of ["", "error: no such file", "{}"]) assert.equal(findingsOf(output), undefined, output);
  });

  test("does not show again what the server shows", () => {
    const [finding] = findingsOf(JSON.stringify([one("orphan-link", "info", 2, [call])])) ?? [];
    assert.ok(finding);
    const shown = { rule: "orphan-link", message: "about orphan-link", file: "urdf/a.xacro", line: 1 };
    assert.ok(isShown(finding, [shown]));
    assert.ok(isShown(finding, [{ ...shown, file: "urdf/b.xacro", line: 6 }]), "at the call");
    assert.ok(!isShown(finding, []));
    assert.ok(!isShown(finding, [{ ...shown, line: 2 }]), "another line");
    assert.ok(!isShown(finding, [{ ...shown, rule: "zero-mass" }]), "another rule");
    assert.ok(!isShown(finding, [{ ...shown, message: "another", file: "urdf/b.xacro", line: 6 }]), "another one at the call");
  });

  test("is understood by the problem matcher", () => {
    const manifest = JSON.parse(readFileSync("package.json", "utf8")) as {
      contributes: { problemPatterns: { regexp: string }[] };
    };
    const pattern = new RegExp(manifest.contributes.problemPatterns[0]?.regexp ?? "^$");
    const parts = pattern.exec("src/a b/robot.xacro:10:27: error: mesh `a.stl` of link [x] differs [mesh-case-mismatch]");
    assert.deepEqual(parts?.slice(1), ["src/a b/robot.xacro", "10", "27", "error", "mesh `a.stl` of link [x] differs", "mesh-case-mismatch"]);
    assert.equal(pattern.exec("note: 9 errors in 4 files"), null);
  });
});

test("snippets that leave the cursor in an empty value", () => {
  const empty = ['filename="$1"$0', 'link="${1}"/>', "package://x/$1", "file://\\$(find a)/$1", 'xacro:x prefix="$1" b="$2"/>'];
  for (const snippet of empty) assert.ok(startsEmptyValue(snippet), snippet);
  const others = ['xyz="${1:0 0 0}"', 'optional="${1|true,false|}"$0', 'name="${1:joint}"><parent link="${2}"/>', 'name="$0"', "\\$(find $1)/", 'a="$10"'];
  for (const snippet of others) assert.ok(!startsEmptyValue(snippet), snippet);
});

test("the outline of an expanded text", () => {
  const text = `<robot name="r">
  <!-- <link name="none"/> -->
  <link name="a">
    <visual><material name="red"/></visual>
  </link>
  <joint name="j" type="fixed">
    <parent link="a"/>
    <child link="b"/>
  </joint>
  <gazebo reference="a"><sensor name="s" type="camera"/></gazebo>
</robot>`;
  const [robot] = symbolsOf(text);
  assert.deepEqual(
    robot?.children.map(({ element, name, detail, first, last }) => [element, name, detail, first, last]),
    [
      ["link", "a", "", 2, 4],
      ["joint", "j", "fixed, a → b", 5, 8],
      ["gazebo", "a", "", 9, 9],
    ],
  );
  assert.deepEqual([robot.first, robot.last], [0, 10]);
  assert.deepEqual(symbolsAt([robot], 7).map(({ name }) => name), ["r", "j"]);
  assert.deepEqual(symbolsAt([robot], 9).map(({ name }) => name), ["r", "a", "s"]);
  assert.deepEqual(symbolsOf("<robot></a><"), [{ element: "robot", name: "robot", detail: "", first: 0, last: 0, children: [] }]);
});
