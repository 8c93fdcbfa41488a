/**
 * The files of the workspace, for a server that cannot read them: it is given the texts of robots before it begins, of
 * all other files the names, and their content when it asks for it.
 */
import * as vscode from "vscode";
import type { Changes } from "./messages";
import type { Names } from "./uris";

/** Most files whose names are given. */
const MOST_FILES = 20_000;
/** Most files that are read before the server begins; the others are read when it asks. */
const MOST_FIRST = 4_000;
/** Most bytes of all files together. */
const MOST_BYTES = 256 * 1024 * 1024;
/** How many files are read at once. */
const AT_ONCE = 32;
/** Changes that come together are told together. */
const TOGETHER_MS = 50;
/** What describes robots and packages. */
const FIRST =
  /\.(xacro|urdf|srdf|sdf|world|xml|ya?ml|toml|launch|in)$|\.launch\.py$|\/launch\/[^/]*\.py$|\/(CMakeLists\.txt|setup\.(py|cfg)|\.gitignore|\.gitattributes|\.setup_assistant)$/i;

export class Files implements vscode.Disposable {
  /** Bytes that were given, by path. */
  private readonly given = new Map<string, number>();
  /** What was asked for, and is too much or cannot be read. */
  private readonly refused = new Set<string>();
  private bytes = 0;
  private isFull = false;
  private readonly changed = new Map<string, vscode.Uri>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly watcher = vscode.workspace.createFileSystemWatcher("**/*");

  /** `tell` gives files to the server, whose state changed since it began. */
  constructor(
    private readonly names: Names,
    private readonly output: vscode.LogOutputChannel,
    private readonly tell: (changes: Changes) => void,
  ) {
    const note = (uri: vscode.Uri): void => {
      const path = this.names.path(uri.toString());
      if (path === undefined) return;
      this.changed.set(path, uri);
      this.timer ??= setTimeout(() => void this.look(), TOGETHER_MS);
    };
    this.watcher.onDidCreate(note);
    this.watcher.onDidChange(note);
    this.watcher.onDidDelete(note);
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.watcher.dispose();
  }

  /** All files of the workspace. */
  async all(): Promise<Changes> {
    const begin = performance.now();
    const listed = await Promise.all((vscode.workspace.workspaceFolders ?? []).map(({ uri }) => list(uri)));
    const found = listed.flat().sort((one, other) => depth(one) - depth(other));
    const uris = found.slice(0, MOST_FILES);
    if (found.length > uris.length) this.warn(`The workspace has more than ${MOST_FILES} files`);
    const first = uris.filter(({ path }) => FIRST.test(path));
    const put = await this.read(first.slice(0, MOST_FIRST));
    const read = new Set(put.map(([path]) => path));
    const paths = uris.map((uri) => this.names.path(uri.toString())).filter((path) => path !== undefined);
    const names = paths.filter((path) => !read.has(path));
    const ms = Math.round(performance.now() - begin);
    this.output.info(`files: ${put.length} read (${this.bytes} bytes), ${names.length} known by name, ${ms} ms`);
    return { put, names, removed: [] };
  }

  /** The content of files of which only the names were given. */
  async give(paths: string[]): Promise<void> {
    const asked = paths.filter((path) => !this.refused.has(path) && !this.given.has(path));
    if (asked.length === 0) return;
    const put = await this.read(asked.map((path) => vscode.Uri.parse(this.names.uri(path))));
    const read = new Set(put.map(([path]) => path));
    for (const path of asked) if (!read.has(path)) this.refused.add(path);
    this.output.debug(`files: ${put.length} of ${asked.length} read that the server asked for`);
    if (put.length > 0) this.tell({ put, names: [], removed: [] });
  }

  /** Reads files, as many as there is room for. */
  private async read(uris: vscode.Uri[]): Promise<[string, Uint8Array][]> {
    const read: [string, Uint8Array][] = [];
    const left = [...uris].reverse();
    const one = async (): Promise<void> => {
      for (let uri = left.pop(); uri; uri = left.pop()) {
        const path = this.names.path(uri.toString());
        const content = path !== undefined && (await this.content(uri));
        if (path === undefined || !content) continue;
        this.bytes += content.length - (this.given.get(path) ?? 0);
        this.given.set(path, content.length);
        read.push([path, content]);
      }
    };
    await Promise.all(Array.from({ length: AT_ONCE }, one));
    return read;
  }

  /** What a file holds; nothing when it cannot be read or is too much. */
  private async content(uri: vscode.Uri): Promise<Uint8Array | undefined> {
    try {
      const { size } = await vscode.workspace.fs.stat(uri);
      if (this.bytes + size > MOST_BYTES) {
        this.warn(`The files of the robots have more than ${MOST_BYTES / 1024 / 1024} MB`);
        return undefined;
      }
      return await vscode.workspace.fs.readFile(uri);
    } catch (error) {
      this.output.debug(`files: ${uri.toString()}: ${String(error)}`);
      return undefined;
    }
  }

  /** Tells of files that came, changed or went. */
  private async look(): Promise<void> {
    this.timer = undefined;
    const changed = [...this.changed];
    this.changed.clear();
    const changes: Changes = { put: [], names: [], removed: [] };
    const read: vscode.Uri[] = [];
    for (const [path, uri] of changed) {
      this.refused.delete(path);
      const stat = await vscode.workspace.fs.stat(uri).then((found) => found, () => undefined);
      if (!stat) changes.removed.push(path);
      else if (stat.type & vscode.FileType.Directory) await this.folderCame(uri, changes, read);
      else if (this.given.has(path) || FIRST.test(uri.path)) read.push(uri);
      else changes.names.push(path);
    }
    for (const path of changes.removed) {
      for (const [own, size] of this.given) {
        if (own !== path && !own.startsWith(`${path}/`)) continue;
        this.bytes -= size;
        this.given.delete(own);
        if (own !== path) changes.removed.push(own);
      }
    }
    changes.put = await this.read(read);
    this.tell(changes);
  }

  /** A folder that came brings its files. */
  private async folderCame(folder: vscode.Uri, changes: Changes, read: vscode.Uri[]): Promise<void> {
    for (const uri of await walk(folder)) {
      const path = this.names.path(uri.toString());
      if (FIRST.test(uri.path)) read.push(uri);
      else if (path !== undefined && !this.given.has(path)) changes.names.push(path);
    }
  }

  /** Says once that something is left out. */
  private warn(reason: string): void {
    this.output.warn(`${reason}; the rest is not read.`);
    if (this.isFull) return;
    this.isFull = true;
    void vscode.window.showWarningMessage(
      `${reason}; xacro in the browser does not read the rest. Exclude folders with \`files.exclude\`, or open a smaller folder.`,
    );
  }
}

/** The files of a folder, without those that the settings exclude. */
async function list(folder: vscode.Uri): Promise<vscode.Uri[]> {
  const found = await vscode.workspace.findFiles(new vscode.RelativePattern(folder, "**/*"), undefined, MOST_FILES + 1);
  // some file systems cannot be searched
  return found.length > 0 ? found : walk(folder);
}

/** The files of a folder, without hidden folders and packages of Node. */
async function walk(folder: vscode.Uri): Promise<vscode.Uri[]> {
  const found: vscode.Uri[] = [];
  let level = [folder];
  while (level.length > 0 && found.length <= MOST_FILES) {
    const lists = await Promise.all(
      level.map((uri) => vscode.workspace.fs.readDirectory(uri).then((entries) => ({ uri, entries }), () => ({ uri, entries: [] }))),
    );
    level = [];
    for (const { uri, entries } of lists) {
      for (const [name, type] of entries) {
        const child = vscode.Uri.joinPath(uri, name);
        // links to folders could lead back
        if (type & vscode.FileType.File) found.push(child);
        else if (type === vscode.FileType.Directory && !name.startsWith(".") && name !== "node_modules") level.push(child);
      }
    }
  }
  return found;
}

function depth(uri: vscode.Uri): number {
  return uri.path.split("/").length;
}
