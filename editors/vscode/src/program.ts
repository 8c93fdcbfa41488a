/**
 * The server as a program of its own.
 */
import * as os from "node:os";
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/node";
import { locateServer } from "./locate";
import type { Launcher } from "./server";

const find: Launcher["find"] = (context) => {
  const settings = vscode.workspace.getConfiguration("xacro.server");
  const found = locateServer({
    setting: settings.get("path", ""),
    extensionPath: context.extensionPath,
    environment: process.env,
    home: os.homedir(),
    windows: process.platform === "win32",
  });
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
