// Bundles the viewer into dist/viewer.js, with the worker that reads meshes as a text in it. A file that would stay the same
// is left alone: cargo builds the programs, which hold it, again whenever it was written.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const root = dirname(fileURLToPath(import.meta.url));
const common = {
  absWorkingDir: root,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  legalComments: "eof",
  logLevel: "warning",
  write: false,
  metafile: true,
};

const worker = await build({ ...common, entryPoints: ["src/mesh_worker.ts"], outfile: "dist/worker.js" });
const [{ text }] = worker.outputFiles;

/** `import source from 'mesh-worker'` */
const asText = {
  name: "mesh-worker",
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^mesh-worker$/ }, ({ path }) => ({ path, namespace: "text" }));
    onLoad({ filter: /.*/, namespace: "text" }, () => ({ contents: text, loader: "text" }));
  },
};
const page = await build({ ...common, entryPoints: ["src/main.ts"], outfile: "dist/viewer.js", plugins: [asText] });

// large files take seconds to read, in which a page that read them itself would answer to nothing
const loaders = Object.keys(page.metafile.inputs).filter((name) => name.includes("/jsm/loaders/"));
if (loaders.length > 0) throw new Error(`meshes are read by the worker alone, but the page contains ${loaders.join(", ")}`);

mkdirSync(join(root, "dist"), { recursive: true });
for (const { path, contents } of page.outputFiles) {
  if (!existsSync(path) || !readFileSync(path).equals(contents)) writeFileSync(path, contents);
}
