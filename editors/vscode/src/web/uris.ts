/**
 * The names of files: the worker has its own folder for each folder of the workspace, whatever file system that is in.
 */

/** The folder of all folders in the worker. */
const TOP = "file:///workspace/";
/** Members whose texts are what they are, whatever they begin with. */
const TEXTS = new Set(["data", "expanded", "message", "newName", "newText", "query", "text", "urdf"]);

export interface Folder {
  /** As the editor writes it. */
  uri: string;
  /** Its name in the worker. */
  name: string;
}

/** Folders with names that are different from each other. */
export function namedFolders(uris: readonly string[]): Folder[] {
  const taken = new Set<string>();
  return uris.map((given) => {
    const uri = given.replace(/\/$/, "");
    const own = uri.slice(uri.lastIndexOf("/") + 1) || "root";
    let name = own;
    for (let count = 2; taken.has(name); count++) name = `${own}-${count}`;
    taken.add(name);
    return { uri, name };
  });
}

export class Names {
  constructor(private readonly folders: readonly Folder[]) {}

  /** A message of the editor in the names of the worker. */
  toWorker(message: unknown): unknown {
    return mapped(message, (text) => this.inWorker(text));
  }

  /** A message of the worker in the names of the editor. */
  fromWorker(message: unknown): unknown {
    return mapped(message, (text, key) => {
      // for which files the server wants to hear of new names
      if (key === "scheme" && text === "file") return this.folders[0]?.uri.split(":", 1)[0] ?? text;
      if (text.startsWith(TOP)) return this.inEditor(text);
      // links in what is written for the reader
      return key === "value" && text.includes(TOP)
        ? text.replace(/file:\/\/\/workspace\/[^\s()<>[\]"'#]*/g, (uri) => this.inEditor(uri))
        : text;
    });
  }

  /** The path in the worker of a file of the editor. */
  path(uri: string): string | undefined {
    const own = this.inWorker(uri);
    return own.startsWith(TOP) ? decodeURIComponent(own.slice("file://".length)) : undefined;
  }

  /** The URI in the editor of a path of the worker. */
  uri(path: string): string {
    return this.inEditor(`file://${encoded(path)}`);
  }

  private inWorker(uri: string): string {
    // of folders in each other, the inner one
    const folder = this.folders
      .filter((each) => uri.startsWith(each.uri) && /^$|^[/#?]/.test(uri.slice(each.uri.length)))
      .sort((one, other) => other.uri.length - one.uri.length)[0];
    return folder ? `${TOP}${folder.name}${uri.slice(folder.uri.length)}` : uri;
  }

  private inEditor(uri: string): string {
    const below = uri.slice(TOP.length);
    const folder = this.folders.find(({ name }) => below.startsWith(name) && /^$|^[/#?]/.test(below.slice(name.length)));
    if (!folder) return uri;
    const [path = "", ...rest] = below.slice(folder.name.length).split(/(?=[#?])/);
    // written as the editor writes it, since URIs are compared by their letters
    return `${folder.uri}${encoded(decodeURIComponent(path))}${rest.join("")}`;
  }
}

/** A path, with every byte escaped that the editor escapes. */
function encoded(path: string): string {
  return encodeURIComponent(path)
    .replaceAll("%2F", "/")
    .replace(/[!'()*]/g, (letter) => `%${letter.charCodeAt(0).toString(16).toUpperCase()}`);
}

function mapped(value: unknown, one: (text: string, key: string) => string, key = ""): unknown {
  if (typeof value === "string") return TEXTS.has(key) ? value : one(value, key);
  if (typeof value !== "object" || value === null) return value;
  if (Array.isArray(value)) {
    return typeof value[0] === "number" ? value : value.map((each) => mapped(each, one, key));
  }
  return Object.fromEntries(Object.entries(value).map(([name, each]) => [one(name, ""), mapped(each, one, name)]));
}
