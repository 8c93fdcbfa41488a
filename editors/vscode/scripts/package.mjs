// Builds a .vsix for one platform, with the server and the viewer inside.
//   node scripts/package.mjs --server FILE [--target linux-x64] [--viewer FILE] [--out FILE.vsix]
//   node scripts/package.mjs [--wasm FILE] [--target web] [--viewer FILE] [--out FILE.vsix]
// Without --server the result is the universal extension, which looks for the server on the search path; in VS Code for
// the Web it runs the server for WebAssembly, which only this one has (`tests/playground/build.sh server` makes it).
import { execFileSync } from "node:child_process";
import { chmodSync, copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const { values } = parseArgs({
  options: {
    server: { type: "string" },
    target: { type: "string" },
    wasm: { type: "string", default: join(root, "..", "..", "target", "playground", "xacro_lsp.wasm") },
    viewer: { type: "string", default: join(root, "..", "viewer", "dist", "viewer.js") },
    out: { type: "string" },
  },
});
const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
const target = values.target ?? (values.server ? `${process.platform}-${process.arch}` : undefined);

rmSync(join(root, "server"), { recursive: true, force: true });
rmSync(join(root, "viewer"), { recursive: true, force: true });
rmSync(join(root, "wasm"), { recursive: true, force: true });
if (values.server) {
  // the program that editors start, and the one it starts, which lies beside it
  const suffix = target.startsWith("win32") ? ".exe" : "";
  mkdirSync(join(root, "server"));
  for (const [name, from] of [
    ["xacro-lsp", resolve(values.server)],
    ["xacro-lint", join(dirname(resolve(values.server)), `xacro-lint${suffix}`)],
  ]) {
    const program = join(root, "server", `${name}${suffix}`);
    copyFileSync(from, program);
    chmodSync(program, 0o755);
  }
}
const wasm = resolve(values.wasm);
if (!values.server && existsSync(wasm)) {
  mkdirSync(join(root, "wasm"));
  copyFileSync(wasm, join(root, "wasm", "xacro_lsp.wasm"));
} else if (!values.server) {
  console.warn(`no server at ${wasm}: the package does nothing in VS Code for the Web (tests/playground/build.sh server)`);
}
const viewer = resolve(values.viewer);
if (existsSync(viewer)) {
  mkdirSync(join(root, "viewer"));
  copyFileSync(viewer, join(root, "viewer", "viewer.js"));
  const notices = `${viewer}.LEGAL.txt`;
  if (existsSync(notices)) copyFileSync(notices, join(root, "viewer", "viewer.js.LEGAL.txt"));
} else {
  console.warn(`no viewer at ${viewer}: the package has no 3D preview (npm ci && npm run build in editors/viewer)`);
}

// The page of an extension that was installed from a file can show only pictures that are in its text.
const readme = readFileSync(join(root, "README.md"), "utf8").replaceAll(/\.\.\/\.\.\/docs\/images\/([\w-]+\.png)/g, (_, name) => {
  const picture = readFileSync(join(root, "..", "..", "docs", "images", name));
  return `data:image/png;base64,${picture.toString("base64")}`;
});
mkdirSync(join(root, "build"), { recursive: true });
writeFileSync(join(root, "build", "README.md"), readme);

const out = resolve(values.out ?? join(root, `xacro-lsp-${target ?? "universal"}-${version}.vsix`));
mkdirSync(dirname(out), { recursive: true });
const args = ["package", "--no-dependencies", "--no-rewrite-relative-links", "--allow-missing-repository", "--readme-path", "build/README.md", "--out", out];
if (target) args.push("--target", target);
execFileSync(process.execPath, [join(root, "node_modules", "@vscode", "vsce", "vsce"), ...args], { cwd: root, stdio: "inherit" });
console.log(`${out}: ${(statSync(out).size / 1e6).toFixed(2)} MB`);
