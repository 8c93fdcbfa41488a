// Bundles the extension and its webview scripts into dist/.
//   node scripts/build.mjs [--production] [--watch] [--tests]
import { readdirSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import * as esbuild from "esbuild";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const has = (flag) => process.argv.includes(flag);
const production = has("--production");

const common = { bundle: true, minify: production, sourcemap: production ? false : "linked", logLevel: "warning", absWorkingDir: root };
const host = { ...common, platform: "node", format: "cjs", target: "node18", external: ["vscode"] };
const web = { ...common, platform: "browser", target: "es2022", mainFields: ["browser", "module", "main"] };
const page = { ...common, platform: "browser", format: "iife", target: "es2022" };
const builds = [
  { ...host, entryPoints: ["src/extension.ts"], outfile: "dist/extension.js", mainFields: ["module", "main"] },
  // where no program can be started: the extension, and the worker that the server runs in
  { ...web, format: "cjs", external: ["vscode"], entryPoints: ["src/browser.ts"], outfile: "dist/browser.js" },
  { ...web, format: "iife", entryPoints: ["src/web/worker.ts"], outfile: "dist/worker.js" },
  { ...page, entryPoints: ["src/webview/graph.ts"], outfile: "dist/graph.js" },
];
if (has("--tests")) {
  const tests = readdirSync(join(root, "test")).filter((name) => name.endsWith(".test.ts"));
  builds.push({ ...host, sourcemap: "inline", entryPoints: tests.map((name) => `test/${name}`), outdir: "dist/test" });
}

rmSync(join(root, "dist"), { recursive: true, force: true });
if (has("--watch")) {
  for (const options of builds) await (await esbuild.context(options)).watch();
} else {
  await Promise.all(builds.map((options) => esbuild.build(options)));
}
