/**
 * The extension where no program can be started: in VS Code for the Web.
 */
import * as vscode from "vscode";
import { start, stop } from "./activation";
import { takeSchemesAsFiles } from "./schemes";
import { worker } from "./web/client";

export function activate(context: vscode.ExtensionContext): void {
  takeSchemesAsFiles((vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri.scheme));
  const server = start(context, worker);
  context.subscriptions.push(
    vscode.commands.registerCommand("xacro.checkWorkspace", () => {
      void vscode.window.showInformationMessage(
        "VS Code for the Web cannot start the program that checks the workspace. To check open files with all presets, set `xacro.diagnostics.contexts` to `all`.",
      );
    }),
    // the server is given the files of its folders when it begins
    vscode.workspace.onDidChangeWorkspaceFolders(({ added }) => {
      takeSchemesAsFiles(added.map(({ uri }) => uri.scheme));
      void server.restart();
    }),
  );
}

export function deactivate(): Promise<void> {
  return stop();
}
