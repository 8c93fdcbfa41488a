/**
 * Where the server program is: the setting, the one inside the extension, the search path.
 */
import * as fs from "node:fs";
import * as path from "node:path";

/** A server that was found, and by which step. */
export interface Found {
  command: string;
  from: "setting" | "extension" | "PATH";
}

/** Why there is none, in words for the user. */
export interface Missing {
  message: string;
}

/** What the search looks at; given by the caller so that it can be tested. */
export interface Surroundings {
  /** Value of `xacro.server.path`. */
  setting: string;
  extensionPath: string;
  environment: Readonly<Record<string, string | undefined>>;
  home: string;
  windows: boolean;
}

export function serverName(windows: boolean): string {
  return windows ? "xacro-lsp.exe" : "xacro-lsp";
}

/** The program of the command line in the folder of a server. */
export function lintBeside(server: string, windows: boolean): string | Missing {
  const program = path.join(path.dirname(server), windows ? "xacro-lint.exe" : "xacro-lint");
  return isProgram(program, windows) ? program : { message: `${program} was not found` };
}

/** Finds the server; a setting that names no program is an error and not passed over. */
export function locateServer(around: Surroundings): Found | Missing {
  const setting = expandHome(around.setting.trim(), around.home);
  if (setting !== "") {
    if (setting.includes("/") || setting.includes("\\")) {
      if (isProgram(setting, around.windows)) return { command: setting, from: "setting" };
      return { message: `\`xacro.server.path\` is set to ${setting}, which is not a program` };
    }
    const named = onPath(setting, around);
    if (named !== undefined) return { command: named, from: "setting" };
    return { message: `\`xacro.server.path\` is set to ${setting}, which is not on the search path` };
  }
  const name = serverName(around.windows);
  const bundled = path.join(around.extensionPath, "server", name);
  if (isProgram(bundled, around.windows)) return { command: bundled, from: "extension" };
  const found = onPath(name, around);
  if (found !== undefined) return { command: found, from: "PATH" };
  return { message: "the program `xacro-lsp` was not found; this build of the extension does not bundle it" };
}

function expandHome(file: string, home: string): string {
  return file === "~" || file.startsWith("~/") ? path.join(home, file.slice(1)) : file;
}

function onPath(name: string, around: Surroundings): string | undefined {
  const variable = around.environment.PATH ?? around.environment.Path ?? "";
  // cargo installs programs here; editors started from a menu often do not have it on the path
  const folders = [...variable.split(around.windows ? ";" : ":"), path.join(around.home, ".cargo", "bin")];
  return folders
    .filter((folder) => path.isAbsolute(folder))
    .map((folder) => path.join(folder, name))
    .find((file) => isProgram(file, around.windows));
}

function isProgram(file: string, windows: boolean): boolean {
  try {
    if (!fs.statSync(file).isFile()) return false;
    if (!windows) fs.accessSync(file, fs.constants.X_OK);
    return true;
  } catch {
    return false;
  }
}
