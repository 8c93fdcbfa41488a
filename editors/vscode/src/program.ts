/**
 * The server as a program of its own.
 */
import * as os from "node:os";
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/node";
import type { Found, Missing } from "./locate";
import { lintBeside, locateServer } from "./locate";
import type { Launcher } from "./server";

function locate(context: vscode.ExtensionContext): Found | Missing {
  return locateServer({
    setting: vscode.workspace.getConfiguration("xacro.server").get("path", ""),
    extensionPath: context.extensionPath,
    environment: process.env,
    home: os.homedir(),
    windows: process.platform === "win32",
  });
}

/** The program of the command line, which lies beside the server. */
export function lintProgram(context: vscode.ExtensionContext): string | Missing {
  const found = locate(context);
  return "command" in found ? lintBeside(found.command, process.platform === "win32") : found;
}

const find: Launcher["find"] = (context) => {
  const settings = vscode.workspace.getConfiguration("xacro.server");
  const found = locate(context);
  if (!("command" in found)) return found;
  return {
    name: found.command,
    from: found.from,
    client: (options) =>
      new LanguageClient(
        "xacro",
        "Xacro",
        {
          command: found.command,
          args: settings.get<string[]>("args", []),
          options: { env: { ...process.env, ...settings.get<Record<string, string>>("env", {}) } },
        },
        options,
      ),
  };
};

export const program: Launcher = {
  find,
  advice:
    "Install the extension for your platform, or build the program with `cargo install` and name it in `xacro.server.path`.",
};
