/**
 * The extension where programs can be started: on the desktop, and in remote windows.
 */
import type * as vscode from "vscode";
import { start, stop } from "./activation";
import { program } from "./program";
import { WorkspaceCheck } from "./workspaceCheck";

export function activate(context: vscode.ExtensionContext): void {
  const server = start(context, program);
  context.subscriptions.push(new WorkspaceCheck(context, server));
}

export function deactivate(): Promise<void> {
  return stop();
}
