/**
 * The extension where programs can be started: on the desktop, and in remote windows.
 */
import type * as vscode from "vscode";
import { start, stop } from "./activation";
import { program } from "./program";

export function activate(context: vscode.ExtensionContext): void {
  start(context, program);
}

export function deactivate(): Promise<void> {
  return stop();
}
