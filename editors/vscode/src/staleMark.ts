/**
 * The mark of an expanded document that is older than its sources: in its tab, on its text, in the status bar, so that it
 * is seen wherever the document is scrolled to.
 */
import * as vscode from "vscode";
import { bannerText } from "./expandedText";
import { EXPANDED_SCHEME } from "./languages";
import type { ExpandError } from "./protocol";

export interface Stale {
  errors: readonly ExpandError[];
  /** When the text was made. */
  time: Date;
}

export class StaleMark implements vscode.FileDecorationProvider, vscode.Disposable {
  private readonly changed = new vscode.EventEmitter<undefined>();
  readonly onDidChangeFileDecorations = this.changed.event;
  private readonly faded = vscode.window.createTextEditorDecorationType({ opacity: "0.55", isWholeLine: true });
  private readonly item = vscode.window.createStatusBarItem("xacro.status.expanded", vscode.StatusBarAlignment.Left, 0);
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly staleOf: (uri: vscode.Uri) => Stale | undefined) {
    this.item.name = "Xacro: expanded URDF";
    this.item.backgroundColor = new vscode.ThemeColor("statusBarItem.warningBackground");
    this.subscriptions = [
      this.changed,
      this.faded,
      this.item,
      vscode.window.registerFileDecorationProvider(this),
      vscode.window.onDidChangeVisibleTextEditors(() => this.mark()),
    ];
  }

  provideFileDecoration(uri: vscode.Uri): vscode.FileDecoration | undefined {
    const stale = uri.scheme === EXPANDED_SCHEME ? this.staleOf(uri) : undefined;
    if (!stale) return undefined;
    const text = bannerText(stale.errors.length, stale.time);
    return new vscode.FileDecoration("!", text, new vscode.ThemeColor("list.warningForeground"));
  }

  /** Whether documents are older than their sources has changed. */
  update(): void {
    this.changed.fire(undefined);
    this.mark();
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private mark(): void {
    this.item.hide();
    for (const editor of vscode.window.visibleTextEditors) {
      const { document } = editor;
      if (document.uri.scheme !== EXPANDED_SCHEME) continue;
      const stale = this.staleOf(document.uri);
      const all = new vscode.Range(0, 0, document.lineCount, 0);
      editor.setDecorations(this.faded, stale ? [all] : []);
      if (stale) this.show(stale);
    }
  }

  private show({ errors, time }: Stale): void {
    const [first] = errors;
    this.item.text = `$(warning) ${bannerText(errors.length, time)}`;
    this.item.tooltip = first?.message ?? "";
    if (first) this.item.command = openError(first);
    this.item.show();
  }
}

/** Opens the place of an error. */
export function openError({ message, location }: ExpandError): vscode.Command {
  const { line, character } = location.range.start;
  const selection = new vscode.Range(line, character, line, character);
  const options = { selection, viewColumn: vscode.ViewColumn.One };
  return { command: "vscode.open", title: message, arguments: [vscode.Uri.parse(location.uri), options] };
}
