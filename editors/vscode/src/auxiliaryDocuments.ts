/**
 * Unsaved text of files that robots are made from besides xacro: YAML, package.xml, xacro-lint.toml, launch files. The
 * server has to know it, but formats none of these files, so they are no part of the client's document selector.
 */
import * as vscode from "vscode";
import {
  DidChangeTextDocumentNotification,
  DidCloseTextDocumentNotification,
  DidOpenTextDocumentNotification,
} from "vscode-languageclient";
import { isCompanion } from "./languages";
import type { Server } from "./server";

export class AuxiliaryDocuments implements vscode.Disposable {
  /** Documents that the server knows to be open. */
  private readonly announced = new Set<string>();
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly server: Server) {
    this.subscriptions = [
      server.onReady(() => {
        this.announced.clear();
        vscode.workspace.textDocuments.forEach((document) => this.opened(document));
      }),
      vscode.workspace.onDidOpenTextDocument((document) => this.opened(document)),
      vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
        if (contentChanges.length > 0) this.changed(document);
      }),
      vscode.workspace.onDidCloseTextDocument((document) => this.closed(document)),
    ];
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private opened(document: vscode.TextDocument): void {
    if (!isCompanion(document) || !this.server.isRunning) return;
    const uri = document.uri.toString();
    this.announced.add(uri);
    const { languageId, version } = document;
    const textDocument = { uri, languageId, version, text: document.getText() };
    void this.server.tell(DidOpenTextDocumentNotification.type, { textDocument });
  }

  private changed(document: vscode.TextDocument): void {
    const uri = document.uri.toString();
    if (!this.announced.has(uri)) return;
    void this.server.tell(DidChangeTextDocumentNotification.type, {
      textDocument: { uri, version: document.version },
      contentChanges: [{ text: document.getText() }],
    });
  }

  private closed(document: vscode.TextDocument): void {
    const uri = document.uri.toString();
    if (this.announced.delete(uri)) {
      void this.server.tell(DidCloseTextDocumentNotification.type, { textDocument: { uri } });
    }
  }
}
