/**
 * The quick fix that sets the severity of a rule: in xacro-lint.toml where there is one, else in the settings.
 */
import * as vscode from "vscode";
import { LANGUAGES } from "./languages";
import { severityEdit } from "./severityTable";

const COMMAND = "xacro.configureRule";
const KEY = "diagnostics.rules";
const SEVERITIES = ["error", "warning", "info", "hint", "off"];

export function registerConfigureRule(): vscode.Disposable {
  return vscode.Disposable.from(
    vscode.languages.registerCodeActionsProvider([...LANGUAGES], {
      provideCodeActions: (document, _range, { diagnostics }) => {
        const rules = diagnostics.filter(({ source }) => source === "xacro" || source === "xacro-lint").map(ruleOf);
        return [...new Set(rules)].filter(Boolean).map((rule) => {
          const action = new vscode.CodeAction(`Configure rule ${rule}…`, vscode.CodeActionKind.QuickFix);
          action.command = { command: COMMAND, title: action.title, arguments: [rule, document.uri] };
          return action;
        });
      },
    }),
    vscode.commands.registerCommand(COMMAND, configure),
  );
}

function ruleOf({ code }: vscode.Diagnostic): string {
  return typeof code === "object" ? String(code.value) : String(code ?? "");
}

async function configure(rule: string, uri: vscode.Uri): Promise<void> {
  const settings = vscode.workspace.getConfiguration("xacro", uri);
  const set = settings.get<Record<string, string>>(KEY, {});
  // settings win over the file
  const file = rule in set ? undefined : await configurationOf(uri);
  const severity = await vscode.window.showQuickPick(SEVERITIES, {
    title: `Severity of ${rule}`,
    placeHolder: file ? `In ${vscode.workspace.asRelativePath(file)}` : "In the settings of the workspace",
  });
  if (severity === undefined) return;
  if (!file || !(await writeFile(file, rule, severity))) {
    const own = settings.inspect<Record<string, string>>(KEY)?.workspaceValue;
    const target = vscode.workspace.workspaceFolders ? vscode.ConfigurationTarget.Workspace : vscode.ConfigurationTarget.Global;
    await settings.update(KEY, { ...(vscode.workspace.workspaceFolders ? own : set), [rule]: severity }, target);
  }
}

/** The closest configuration of a file, in the workspace. */
async function configurationOf(uri: vscode.Uri): Promise<vscode.Uri | undefined> {
  const top = vscode.workspace.getWorkspaceFolder(uri)?.uri;
  if (!top) return undefined;
  for (let folder = vscode.Uri.joinPath(uri, ".."); folder.path.startsWith(top.path); folder = vscode.Uri.joinPath(folder, "..")) {
    for (const name of ["xacro-lint.toml", ".xacro-lint.toml"]) {
      const file = vscode.Uri.joinPath(folder, name);
      if (await vscode.workspace.fs.stat(file).then(() => true, () => false)) return file;
    }
    if (folder.path === "/") break;
  }
  return undefined;
}

async function writeFile(file: vscode.Uri, rule: string, severity: string): Promise<boolean> {
  const document = await vscode.workspace.openTextDocument(file);
  const clean = !document.isDirty;
  const change = severityEdit(document.getText(), rule, severity);
  if (!change) return false;
  const lineEnd = document.getText() !== "" && !document.getText().endsWith("\n") ? "\n" : "";
  const edit = new vscode.WorkspaceEdit();
  if (lineEnd !== "" && change.from >= document.lineCount) {
    edit.insert(file, document.lineAt(document.lineCount - 1).range.end, lineEnd + change.text);
  } else edit.replace(file, new vscode.Range(change.from, 0, change.to, 0), change.text);
  const done = await vscode.workspace.applyEdit(edit);
  return done && (!clean || (await document.save()));
}
