/**
 * The cursor goes along between sources and expanded documents.
 */
import * as vscode from "vscode";
import type { ExpandedDocuments } from "./expanded";
import { expandedUri, rootOf } from "./expanded";
import { EXPANDED_SCHEME, isRobotDescription } from "./languages";
import { plain } from "./pickers";
import * as protocol from "./protocol";
import type { Server } from "./server";

const DELAY_MS = 60;

export class CursorSync implements vscode.DefinitionProvider, vscode.Disposable {
  private readonly mark = vscode.window.createTextEditorDecorationType({
    backgroundColor: new vscode.ThemeColor("editor.wordHighlightStrongBackground"),
    overviewRulerColor: new vscode.ThemeColor("editorOverviewRuler.wordHighlightStrongForeground"),
    overviewRulerLane: vscode.OverviewRulerLane.Center,
  });
  private timer: NodeJS.Timeout | undefined;
  private turn = 0;
  private readonly subscriptions: vscode.Disposable[];

  constructor(
    private readonly server: Server,
    private readonly documents: ExpandedDocuments,
  ) {
    this.subscriptions = [
      this.mark,
      vscode.languages.registerDefinitionProvider({ scheme: EXPANDED_SCHEME }, this),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => this.moved(textEditor)),
      vscode.window.onDidChangeVisibleTextEditors(() => {
        const editor = vscode.window.activeTextEditor;
        if (editor) this.moved(editor);
      }),
    ];
  }

  async provideDefinition(
    document: vscode.TextDocument,
    position: vscode.Position,
  ): Promise<vscode.Location[]> {
    const root = rootOf(document.uri);
    if (root === undefined || !this.documents.isCurrent(document.uri)) return [];
    const answer = await this.server.ask(protocol.toSource, { root, position: plain(position) });
    return (answer?.locations ?? []).map(
      ({ uri, range }) => new vscode.Location(vscode.Uri.parse(uri), toRange(range)),
    );
  }

  dispose(): void {
    clearTimeout(this.timer);
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private moved(editor: vscode.TextEditor): void {
    // only the editor that the user is in leads: what is moved along must not move others
    if (editor !== vscode.window.activeTextEditor) return;
    if (!vscode.workspace.getConfiguration("xacro").get<boolean>("expanded.syncCursor", true)) return;
    clearTimeout(this.timer);
    if (rootOf(editor.document.uri) !== undefined) {
      this.timer = setTimeout(() => void this.toSource(editor), DELAY_MS);
    } else if (isRobotDescription(editor.document) && visibleExpanded().length > 0) {
      this.timer = setTimeout(() => void this.toExpanded(editor), DELAY_MS);
    }
  }

  private async toExpanded(editor: vscode.TextEditor): Promise<void> {
    const turn = ++this.turn;
    const answer = await this.server.ask(protocol.toExpanded, {
      textDocument: { uri: editor.document.uri.toString() },
      position: plain(editor.selection.active),
    });
    if (!answer || !this.isLatest(turn)) return;
    const shown = expandedUri(answer.root.uri).toString();
    for (const expanded of visibleExpanded()) {
      if (expanded.document.uri.toString() !== shown || !this.documents.isCurrent(expanded.document.uri)) continue;
      const ranges = answer.instances.map(({ range }) => toRange(range));
      this.show(expanded, ranges);
    }
  }

  private async toSource(editor: vscode.TextEditor): Promise<void> {
    const root = rootOf(editor.document.uri);
    const turn = ++this.turn;
    if (root === undefined || !this.documents.isCurrent(editor.document.uri)) return;
    const position = plain(editor.selection.active);
    const answer = await this.server.ask(protocol.toSource, { root, position });
    const origin = answer?.locations[0];
    if (!origin || !this.isLatest(turn)) return;
    const uri = vscode.Uri.parse(origin.uri);
    const source = await this.sourceEditor(uri, editor);
    if (source && this.isLatest(turn)) this.show(source, [toRange(origin.range)]);
  }

  private isLatest(turn: number): boolean {
    return turn === this.turn;
  }

  /** An editor with a file, in the column where sources are, without taking the focus. */
  private async sourceEditor(
    uri: vscode.Uri,
    expanded: vscode.TextEditor,
  ): Promise<vscode.TextEditor | undefined> {
    const visible = vscode.window.visibleTextEditors;
    const there = visible.find((editor) => editor.document.uri.toString() === uri.toString());
    if (there) return there;
    const beside = visible.find((editor) => isRobotDescription(editor.document) && editor !== expanded);
    const viewColumn = beside?.viewColumn ?? vscode.ViewColumn.One;
    if (viewColumn === expanded.viewColumn) return undefined;
    return vscode.window.showTextDocument(uri, { viewColumn, preserveFocus: true, preview: true });
  }

  private show(editor: vscode.TextEditor, ranges: vscode.Range[]): void {
    for (const other of vscode.window.visibleTextEditors) {
      if (other !== editor) other.setDecorations(this.mark, []);
    }
    editor.setDecorations(this.mark, ranges);
    const [first] = ranges;
    const isSeen = ranges.some((range) => editor.visibleRanges.some((seen) => seen.contains(range.start)));
    if (first && !isSeen) editor.revealRange(first, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
  }
}

/** A range of the protocol. */
export function toRange(range: {
  start: { line: number; character: number };
  end: { line: number; character: number };
}): vscode.Range {
  return new vscode.Range(range.start.line, range.start.character, range.end.line, range.end.character);
}

function visibleExpanded(): vscode.TextEditor[] {
  return vscode.window.visibleTextEditors.filter(({ document }) => rootOf(document.uri) !== undefined);
}
