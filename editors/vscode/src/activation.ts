/**
 * Puts the parts of the extension together.
 */
import * as vscode from "vscode";
import { AuxiliaryDocuments } from "./auxiliaryDocuments";
import { Contexts } from "./contexts";
import { ExpandedDocuments } from "./expanded";
import { registerExpandedReading } from "./expandedReading";
import { CursorSync } from "./cursorSync";
import { IncludeGraph } from "./includeGraph";
import { isRobotDescription } from "./languages";
import { Pickers, plain } from "./pickers";
import * as protocol from "./protocol";
import type { TreeNode } from "./protocol";
import { Preview } from "./preview";
import { diagnosticReport } from "./report";
import { isFileScheme } from "./schemes";
import type { CommandHandler, Launcher } from "./server";
import { Server } from "./server";
import { registerRulePages } from "./rulePages";
import { registerSettingsFiles } from "./settingsFiles";
import { serverCommands } from "./serverCommands";
import { Status } from "./status";
import { KinematicTree, RootsView } from "./views";

let running: Server | undefined;

/** Starts the extension, with a server that `launcher` finds. */
export function start(context: vscode.ExtensionContext, launcher: Launcher): Server {
  const begin = performance.now();
  const commands = new Map<string, CommandHandler>();
  const server = new Server(context, commands, launcher);
  running = server;
  const contexts = new Contexts(server, context.workspaceState);
  const documents = new ExpandedDocuments(server, contexts);
  const pickers = new Pickers(server, contexts, context.workspaceState);
  const graph = new IncludeGraph(server, contexts, context.extensionUri);
  const tree = new KinematicTree(server, contexts, documents);
  const preview = new Preview(server, contexts, context.extensionUri, context.workspaceState);
  for (const [name, handler] of serverCommands(server)) commands.set(name, handler);
  context.subscriptions.push(
    server,
    new AuxiliaryDocuments(server),
    registerSettingsFiles(server),
    registerRulePages(),
    registerExpandedReading(server, documents),
    contexts,
    documents,
    graph,
    tree,
    preview,
    new CursorSync(server, documents),
    new RootsView(contexts),
    new Status(server, contexts),
    vscode.workspace.onDidChangeConfiguration((event) => {
      if (event.affectsConfiguration("xacro.server")) void server.restart();
    }),
  );

  const command = (name: string, run: (...args: never[]) => unknown): void => {
    context.subscriptions.push(vscode.commands.registerCommand(name, run));
  };
  command("xacro.openExpanded", (uri?: vscode.Uri) => fileOf(uri, contexts).then((file) => documents.open(file)));
  command("xacro.openPreview", () => preview.open());
  command("xacro.compareExpanded", () => documents.compare(contexts.document, "saved"));
  command("xacro.compareCommitted", () => documents.compare(contexts.document, "committed"));
  command("xacro.expandMacro", () => expandMacro(server, documents));
  command("xacro.pickRoot", () => pickers.pickRoot());
  command("xacro.pickArguments", (_uri?: unknown, name?: unknown, values?: unknown) =>
    typeof name === "string" ? pickers.pickArgument(name, values) : pickers.pickArguments(),
  );
  command("xacro.pickInstance", () => pickers.pickInstance());
  command("xacro.showIncludeGraph", () => graph.show());
  command("xacro.restartServer", () => server.restart());
  command("xacro.showOutput", () => server.output.show());
  command("xacro.refreshViews", () => contexts.refresh());
  command("xacro.roots.select", (item: { root: protocol.Root }) => contexts.pick({ uri: item.root.uri }));
  command("xacro.tree.copyName", (node: TreeNode) => vscode.env.clipboard.writeText(node.link));
  command("xacro.copyReport", async () => {
    await vscode.env.clipboard.writeText(await diagnosticReport(context.extension, server, contexts));
    void vscode.window.showInformationMessage("Copied the diagnostic report to the clipboard.");
  });

  openByItself(preview, contexts, context);
  server.output.info(`activated in ${(performance.now() - begin).toFixed(1)} ms`);
  void server.start();
  return server;
}

export async function stop(): Promise<void> {
  await running?.stop();
  running = undefined;
}

/** With `xacro.preview.autoOpen`, the first robot of a window is shown in the preview without being asked for. */
function openByItself(preview: Preview, contexts: Contexts, context: vscode.ExtensionContext): void {
  const waiting = contexts.onChange(() => {
    if (!contexts.active || contexts.roots?.candidates.length === 0) return;
    waiting.dispose();
    if (vscode.workspace.getConfiguration("xacro").get<boolean>("preview.autoOpen", false) && !preview.isOpen) {
      void preview.open();
    }
  });
  context.subscriptions.push(waiting);
}

/** The file that a command of an editor's title is about, or the one that is looked at. */
async function fileOf(uri: vscode.Uri | undefined, contexts: Contexts): Promise<vscode.TextDocument | undefined> {
  if (uri instanceof vscode.Uri && isFileScheme(uri.scheme)) return vscode.workspace.openTextDocument(uri);
  return contexts.document;
}

async function expandMacro(server: Server, documents: ExpandedDocuments): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  if (!editor || !isRobotDescription(editor.document)) {
    void vscode.window.showInformationMessage("Put the cursor on a macro call in a xacro file first.");
    return;
  }
  const answer = await server.askForUser(protocol.expandAt, {
    textDocument: { uri: editor.document.uri.toString() },
    position: plain(editor.selection.active),
  });
  if (answer === null) {
    void vscode.window.showInformationMessage("There is nothing to expand at the cursor.");
  }
  if (answer) await documents.showFragment(answer);
}
