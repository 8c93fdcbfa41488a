/**
 * What happens after the server's edits while typing: where the cursor stays, and which list opens by itself.
 */
import * as vscode from "vscode";
import { startsEmptyValue } from "./snippets";

type Completions = vscode.CompletionItem[] | vscode.CompletionList | null | undefined;

/** Lets the list of values open after an item that leaves the cursor in an empty value. */
export function withValueLists(completions: Completions): Completions {
  const items = Array.isArray(completions) ? completions : (completions?.items ?? []);
  for (const item of items) {
    const { insertText } = item;
    if (item.command || !(insertText instanceof vscode.SnippetString) || !startsEmptyValue(insertText.value)) continue;
    // as by itself: where there are no values, nothing says so
    item.command = { command: "editor.action.triggerSuggest", title: "Values", arguments: [{ auto: true }] };
  }
  return completions;
}

/**
 * Inserts an end tag behind the cursor; whether it did. As an ordinary edit it would take the cursor along.
 */
export async function closeTag(
  document: vscode.TextDocument,
  position: vscode.Position,
  edits: vscode.TextEdit[] | null | undefined,
): Promise<boolean> {
  const [edit] = edits ?? [];
  const editor = vscode.window.activeTextEditor;
  if (!edit || edits?.length !== 1 || editor?.document !== document) return false;
  if (!edit.range.isEmpty || !edit.range.start.isEqual(position) || !edit.newText.startsWith("</")) return false;
  const snippet = new vscode.SnippetString().appendTabstop(0).appendText(edit.newText);
  return editor.insertSnippet(snippet, position, { undoStopBefore: false, undoStopAfter: false });
}
