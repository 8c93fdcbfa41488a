/**
 * The status bar: root, arguments, problems of the robot that is looked at.
 */
import * as vscode from "vscode";
import { argumentsText, rootLabel } from "./contexts";
import type { Contexts } from "./contexts";
import { counted } from "./findings";
import { EXPANDED_SCHEME, isRobotDescription } from "./languages";
import type { Server } from "./server";

const LONGEST = 32;

export class Status implements vscode.Disposable {
  private readonly root = item("xacro.status.root", "Xacro: root", 103, "xacro.pickRoot");
  private readonly args = item("xacro.status.args", "Xacro: arguments", 102, "xacro.pickArguments");
  private readonly problems = item(
    "xacro.status.problems",
    "Xacro: problems",
    101,
    "workbench.actions.view.problems",
  );
  private readonly subscriptions: vscode.Disposable[];

  constructor(
    private readonly server: Server,
    private readonly contexts: Contexts,
  ) {
    const update = (): void => this.update();
    this.subscriptions = [
      this.root,
      this.args,
      this.problems,
      contexts.onChange(update),
      server.onReady(update),
      server.onGone(update),
      vscode.window.onDidChangeActiveTextEditor(update),
      vscode.languages.onDidChangeDiagnostics(() => this.updateProblems()),
    ];
    this.update();
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private update(): void {
    const { document, roots, active } = this.contexts;
    if (!document || !this.isLookedAt()) {
      for (const each of [this.root, this.args, this.problems]) each.hide();
      return;
    }
    if (!this.server.isRunning) {
      this.root.text = "$(circle-slash) xacro";
      this.root.tooltip = "The xacro language server is not running. Select to start it.";
      this.root.command = "xacro.restartServer";
      this.root.show();
      this.args.hide();
      this.problems.hide();
      return;
    }
    this.root.command = "xacro.pickRoot";
    const { instance } = this.contexts;
    this.root.text = `$(type-hierarchy) ${instance ?? (active ? rootLabel(active) : "no root")}`;
    this.root.tooltip = active
      ? tooltip(`**${rootLabel(active)}** is the robot for this file.`, roots?.reason)
      : tooltip("No root includes this file; it is checked alone.", undefined);
    this.root.show();
    this.updateArguments();
    this.updateProblems();
  }

  private updateArguments(): void {
    const { roots, active } = this.contexts;
    if (!active || !roots || roots.args.length === 0) return this.args.hide();
    const chosen = argumentsText(active.args);
    const count = roots.args.length;
    const text = chosen === "" ? `${count} ${count === 1 ? "argument" : "arguments"}` : chosen;
    this.args.text = `$(settings) ${text.length > LONGEST ? `${text.slice(0, LONGEST - 1)}…` : text}`;
    const lines = roots.args.map((arg) => `${arg.name}:=${arg.value ?? "?"}`);
    this.args.tooltip = new vscode.MarkdownString("Arguments of the root").appendCodeblock(
      lines.join("\n"),
      "text",
    );
    this.args.show();
  }

  private updateProblems(): void {
    if (!this.server.isRunning || !this.isLookedAt()) return this.problems.hide();
    const count = { errors: 0, warnings: 0 };
    for (const [, list] of vscode.languages.getDiagnostics()) {
      for (const { source, severity } of list) {
        if (source !== "xacro" && source !== "xacro-lint") continue;
        if (severity === vscode.DiagnosticSeverity.Error) count.errors++;
        if (severity === vscode.DiagnosticSeverity.Warning) count.warnings++;
      }
    }
    const none = count.errors + count.warnings === 0;
    this.problems.text = none ? "$(pass)" : `$(error) ${count.errors} $(warning) ${count.warnings}`;
    this.problems.tooltip = none
      ? "xacro: no errors, no warnings"
      : `xacro: ${counted(count.errors, "error")}, ${counted(count.warnings, "warning")}`;
    this.problems.show();
  }

  private isLookedAt(): boolean {
    const editor = vscode.window.activeTextEditor;
    // a panel such as the preview has the focus: what was shown stays
    if (!editor) return this.contexts.document !== undefined;
    return isRobotDescription(editor.document) || editor.document.uri.scheme === EXPANDED_SCHEME;
  }
}

function item(id: string, name: string, priority: number, command: string): vscode.StatusBarItem {
  const made = vscode.window.createStatusBarItem(id, vscode.StatusBarAlignment.Left, priority - 100);
  made.name = name;
  made.command = command;
  return made;
}

function tooltip(first: string, reason: string | undefined): vscode.MarkdownString {
  const text = new vscode.MarkdownString(first);
  if (reason !== undefined) text.appendMarkdown("\n\nWhy: ").appendText(reason);
  return text.appendMarkdown("\n\nSelect to choose another one.");
}
