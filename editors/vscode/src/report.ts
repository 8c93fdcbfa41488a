/**
 * What a report of a defect should hold, and nothing that tells of the workspace but names of files.
 */
import * as vscode from "vscode";
import { argumentsText, rootLabel } from "./contexts";
import type { Contexts } from "./contexts";
import { log } from "./protocol";
import type { Server } from "./server";

/** Lines of the server's log in a report. */
const MOST_LINES = 20;

function machine(): string {
  return typeof process === "object" ? `${process.platform} ${process.arch}` : "browser";
}

export async function diagnosticReport(
  extension: vscode.Extension<unknown>,
  server: Server,
  contexts: Contexts,
): Promise<string> {
  const { version } = extension.packageJSON as { version: string };
  const configured = vscode.workspace.getConfiguration("xacro");
  const counts = new Map<string, number>();
  for (const [, list] of vscode.languages.getDiagnostics()) {
    for (const { source, code } of list) {
      if (source !== "xacro") continue;
      const name = typeof code === "object" ? String(code.value) : String(code ?? "?");
      counts.set(name, (counts.get(name) ?? 0) + 1);
    }
  }
  const { active, document, roots } = contexts;
  const { env, ...rest } = configured.get<{ env?: object }>("server", {});
  // values of environment variables may be secrets
  const shown = { ...configured, server: { ...rest, env: Object.keys(env ?? {}) } };
  const lines = (await server.ask(log, null)) ?? [];
  const chosen = JSON.stringify(shown, undefined, 2);
  return [
    "## xacro diagnostic report",
    "",
    `- extension: ${version}`,
    `- editor: ${vscode.env.appName} ${vscode.version}, ${vscode.env.remoteName ?? "local"}, ${machine()}`,
    `- server: ${server.about}`,
    `- workspace: ${vscode.workspace.workspaceFolders?.length ?? 0} folders, ${vscode.workspace.isTrusted ? "trusted" : "not trusted"}`,
    `- file: ${document ? vscode.workspace.asRelativePath(document.uri) : "none"}`,
    `- root: ${active ? `${rootLabel(active)} ${argumentsText(active.args)}`.trim() : "none"} (${roots?.reason ?? "?"})`,
    `- problems: ${[...counts].map(([name, count]) => `${name} ${count}`).join(", ") || "none"}`,
    "",
    "```json",
    chosen,
    "```",
    "",
    "Log of the server:",
    "",
    "```text",
    ...lines.slice(-MOST_LINES),
    "```",
    "",
  ].join("\n");
}
