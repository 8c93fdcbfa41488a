/**
 * Outline and hover of expanded documents: what the elements are, and which source made them.
 */
import * as vscode from "vscode";
import type { ExpandedDocuments } from "./expanded";
import { rootOf } from "./expanded";
import { symbolsAt, symbolsOf } from "./expandedSymbols";
import type { Symbol } from "./expandedSymbols";
import { EXPANDED_SCHEME, baseName } from "./languages";
import { plain } from "./pickers";
import * as protocol from "./protocol";
import type { Role, SourceLocation } from "./protocol";
import type { Server } from "./server";

const KINDS: Readonly<Record<string, vscode.SymbolKind>> = {
  robot: vscode.SymbolKind.Module,
  link: vscode.SymbolKind.Class,
  joint: vscode.SymbolKind.Event,
};

/** What a place of a source is to the text that it made. */
const ROLES: Readonly<Record<Role, string>> = {
  origin: "from",
  call: "called at",
  argument: "argument at",
  include: "included at",
};

export function registerExpandedReading(server: Server, documents: ExpandedDocuments): vscode.Disposable {
  const selector = { scheme: EXPANDED_SCHEME };
  return vscode.Disposable.from(
    vscode.languages.registerDocumentSymbolProvider(selector, {
      provideDocumentSymbols: (document) => symbolsOf(document.getText()).map((symbol) => asSymbol(symbol, document)),
    }),
    vscode.languages.registerHoverProvider(selector, {
      provideHover: async (document, position) => {
        const root = rootOf(document.uri);
        if (root === undefined) return undefined;
        const text = new vscode.MarkdownString();
        const inner = symbolsAt(symbolsOf(document.getText()), position.line).at(-1);
        if (inner) {
          const detail = inner.detail === "" ? "" : ` — ${inner.detail}`;
          text.appendMarkdown(`**${inner.element}** \`${inner.name}\``).appendText(detail);
        }
        if (!documents.isCurrent(document.uri)) {
          text.appendMarkdown("\n\nThe sources have errors, so places in them are not known.");
          return new vscode.Hover(text);
        }
        const answer = await server.ask(protocol.toSource, { root, position: plain(inElement(document, position)) });
        for (const place of answer?.locations ?? []) text.appendMarkdown(`\n\n${placeText(place)}`);
        return text.value === "" ? undefined : new vscode.Hover(text);
      },
    }),
  );
}

/** The element that begins on a line, when a place is in the line's indentation, which belongs to the one around it. */
function inElement(document: vscode.TextDocument, position: vscode.Position): vscode.Position {
  const indentation = document.lineAt(position).firstNonWhitespaceCharacterIndex;
  return position.character <= indentation ? position.with({ character: indentation + 1 }) : position;
}

/** One place of the source as a link. */
function placeText({ uri, range, role }: SourceLocation): string {
  const line = range.start.line + 1;
  const label = `${baseName(uri).replaceAll(/[[\]\\]/g, "\\$&")}:${line}`;
  return `${ROLES[role]} [${label}](${uri}#L${line},${range.start.character + 1})`;
}

function asSymbol(symbol: Symbol, document: vscode.TextDocument): vscode.DocumentSymbol {
  const start = new vscode.Position(symbol.first, document.lineAt(symbol.first).firstNonWhitespaceCharacterIndex);
  const range = new vscode.Range(start, document.lineAt(symbol.last).range.end);
  const kind = KINDS[symbol.element] ?? vscode.SymbolKind.Object;
  const name = symbol.name === "" ? symbol.element : symbol.name;
  const made = new vscode.DocumentSymbol(name, symbol.detail || symbol.element, kind, range, new vscode.Range(start, document.lineAt(symbol.first).range.end));
  made.children = symbol.children.map((child) => asSymbol(child, document));
  return made;
}
