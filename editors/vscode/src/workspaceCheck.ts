/**
 * The check of the whole workspace: a task that runs `xacro-lint check`, which looks at every robot with every preset.
 * Its findings stand in the list of problems beside those of the server, without those that the server shows itself.
 */
import { spawn } from "node:child_process";
import * as path from "node:path";
import * as vscode from "vscode";
import type { Finding, Shown, Spot } from "./findings";
import { checkArguments, findingsOf, isShown, lineOf, summary } from "./findings";
import { lintProgram } from "./program";
import { withPage } from "./rulePages";
import type { Server } from "./server";

const TYPE = "xacro";
const TASK = "check workspace";
/** The exit codes of a check that came to its end: without and with findings. */
const CHECKED = [0, 1];
const DELAY_MS = 200;

interface Definition extends vscode.TaskDefinition {
  /** Further options of `xacro-lint check`. */
  args?: unknown;
}

export class WorkspaceCheck implements vscode.TaskProvider, vscode.Disposable {
  private readonly collection = vscode.languages.createDiagnosticCollection("xacro-check");
  /** By folder, so that a check of one folder leaves the others alone. */
  private readonly findings = new Map<string, Finding[]>();
  private timer: NodeJS.Timeout | undefined;
  private readonly subscriptions: vscode.Disposable[];

  constructor(
    private readonly context: vscode.ExtensionContext,
    private readonly server: Server,
  ) {
    this.subscriptions = [
      this.collection,
      vscode.tasks.registerTaskProvider(TYPE, this),
      vscode.commands.registerCommand("xacro.checkWorkspace", () => this.run()),
      vscode.languages.onDidChangeDiagnostics(() => this.showSoon()),
      // places in a text that was changed are wrong, and the server knows better
      vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
        if (contentChanges.length > 0) this.forget(document.uri);
      }),
    ];
  }

  provideTasks(): vscode.Task[] {
    return (vscode.workspace.workspaceFolders ?? []).map((folder) => this.task(folder, { type: TYPE, task: TASK }));
  }

  resolveTask(task: vscode.Task): vscode.Task | undefined {
    const { definition, scope } = task;
    if (definition.task !== TASK) return undefined;
    const folder = typeof scope === "object" ? scope : vscode.workspace.workspaceFolders?.[0];
    return folder && this.task(folder, definition);
  }

  dispose(): void {
    clearTimeout(this.timer);
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private async run(): Promise<void> {
    const tasks = this.provideTasks();
    if (tasks.length === 0) void vscode.window.showInformationMessage("Open a folder first.");
    for (const task of tasks) await vscode.tasks.executeTask(task);
  }

  private task(folder: vscode.WorkspaceFolder, definition: Definition): vscode.Task {
    const execution = new vscode.CustomExecution(() => Promise.resolve(this.terminal(folder, definition)));
    // no matcher: the findings are taken from the output with their ranges
    const task = new vscode.Task(definition, folder, TASK, TYPE, execution, []);
    task.detail = "Check every robot of the folder, with every preset";
    task.presentationOptions = { reveal: vscode.TaskRevealKind.Silent, clear: true, showReuseMessage: false };
    return task;
  }

  private terminal(folder: vscode.WorkspaceFolder, definition: Definition): vscode.Pseudoterminal {
    const write = new vscode.EventEmitter<string>();
    const close = new vscode.EventEmitter<number>();
    const abort = new AbortController();
    const say = (line: string): void => write.fire(`${line.replaceAll(/\r?\n/g, "\r\n")}\r\n`);
    return {
      onDidWrite: write.event,
      onDidClose: close.event,
      open: () => {
        const checked = vscode.window.withProgress(
          { location: vscode.ProgressLocation.Window, title: `Checking ${folder.name}` },
          () => this.check(folder, definition, say, abort.signal),
        );
        void checked.then((code) => close.fire(code));
      },
      close: () => abort.abort(),
    };
  }

  /** Runs the program, shows what it found; its exit code. */
  private async check(
    folder: vscode.WorkspaceFolder,
    definition: Definition,
    say: (line: string) => void,
    signal: AbortSignal,
  ): Promise<number> {
    const more = Array.isArray(definition.args) ? definition.args.filter((one) => typeof one === "string") : [];
    const args = checkArguments(this.server.settingsOf(folder.uri), more);
    const program = lintProgram(this.context);
    if (typeof program !== "string") {
      say(program.message);
      void vscode.window.showErrorMessage(`xacro: ${program.message}.`);
      return 2;
    }
    say(`xacro-lint ${args.join(" ")}`);
    const { code, output, errors } = await run(program, args, folder.uri.fsPath, signal);
    if (errors !== "") say(errors.trimEnd());
    const found = CHECKED.includes(code) ? findingsOf(output) : undefined;
    if (signal.aborted) return code;
    if (!found) {
      this.server.output.error(`check workspace: exit code ${code}: ${errors}`);
      void vscode.window.showErrorMessage(
        `xacro: the workspace could not be checked: ${errors.trim().split("\n")[0] ?? ""}`,
      );
      return code === 0 ? 2 : code;
    }
    found.forEach((finding) => say(lineOf(finding)));
    say(summary(found));
    const inFolder = (spot: Spot): Spot => ({ ...spot, file: path.resolve(folder.uri.fsPath, spot.file) });
    this.findings.set(
      folder.uri.toString(),
      found.map((finding) => ({
        ...finding,
        ...inFolder(finding),
        related: finding.related.map((place) => ({ ...place, ...inFolder(place) })),
      })),
    );
    this.show();
    void tell(folder, found);
    // findings are a result: with another code, the terminal says that the program failed
    return 0;
  }

  private forget(uri: vscode.Uri): void {
    let forgot = false;
    for (const [folder, list] of this.findings) {
      const left = list.filter(({ file }) => file !== uri.fsPath);
      forgot ||= left.length < list.length;
      this.findings.set(folder, left);
    }
    if (forgot) this.show();
  }

  private showSoon(): void {
    if (this.findings.size === 0) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.show(), DELAY_MS);
  }

  /** Puts what the server does not show into the list of problems. */
  private show(): void {
    const shown = shownByServer();
    const byFile = new Map<string, Finding[]>();
    for (const finding of [...this.findings.values()].flat()) {
      if (isShown(finding, shown)) continue;
      byFile.set(finding.file, [...(byFile.get(finding.file) ?? []), finding]);
    }
    const files: string[] = [];
    this.collection.forEach((uri) => void files.push(uri.fsPath));
    for (const file of files) if (!byFile.has(file)) this.collection.delete(vscode.Uri.file(file));
    for (const [file, list] of byFile) {
      const uri = vscode.Uri.file(file);
      // what is set again is an event again
      if (this.collection.get(uri)?.length !== list.length) this.collection.set(uri, list.map(diagnosticOf));
    }
  }
}

async function tell(folder: vscode.WorkspaceFolder, found: readonly Finding[]): Promise<void> {
  const show = "Show Problems";
  const picked = await vscode.window.showInformationMessage(
    `Checked ${folder.name} with all robots and presets: ${summary(found)}.`,
    ...(found.length > 0 ? [show] : []),
  );
  if (picked === show) await vscode.commands.executeCommand("workbench.actions.view.problems");
}

function shownByServer(): Shown[] {
  return vscode.languages.getDiagnostics().flatMap(([uri, list]) =>
    list
      .filter(({ source }) => source === "xacro")
      .map(({ code, message, range }) => ({
        rule: typeof code === "object" ? String(code.value) : String(code ?? ""),
        message,
        file: uri.fsPath,
        line: range.start.line,
      })),
  );
}

const SEVERITIES: Readonly<Record<string, vscode.DiagnosticSeverity>> = {
  error: vscode.DiagnosticSeverity.Error,
  warning: vscode.DiagnosticSeverity.Warning,
  info: vscode.DiagnosticSeverity.Information,
  hint: vscode.DiagnosticSeverity.Hint,
};

function diagnosticOf(finding: Finding): vscode.Diagnostic {
  const severity = SEVERITIES[finding.severity] ?? vscode.DiagnosticSeverity.Information;
  const made = new vscode.Diagnostic(rangeOf(finding), finding.message, severity);
  made.source = "xacro-lint";
  made.code = finding.rule;
  made.relatedInformation = finding.related.map(
    (place) =>
      new vscode.DiagnosticRelatedInformation(
        new vscode.Location(vscode.Uri.file(place.file), rangeOf(place)),
        place.message,
      ),
  );
  return withPage(made);
}

function rangeOf({ line, column, endLine, endColumn }: Spot): vscode.Range {
  return new vscode.Range(line, column, endLine, endColumn);
}

/** Runs a program to its end. */
function run(
  program: string,
  args: readonly string[],
  cwd: string,
  signal: AbortSignal,
): Promise<{ code: number; output: string; errors: string }> {
  return new Promise((done) => {
    const own = vscode.workspace.getConfiguration("xacro.server").get<Record<string, string>>("env", {});
    const child = spawn(program, args, { cwd, env: { ...process.env, ...own }, signal });
    let [output, errors] = ["", ""];
    child.stdout.setEncoding("utf8").on("data", (data: string) => (output += data));
    child.stderr.setEncoding("utf8").on("data", (data: string) => (errors += data));
    child.once("error", (error) => done({ code: 2, output, errors: String(error) }));
    child.once("close", (code) => done({ code: code ?? 2, output, errors }));
  });
}
