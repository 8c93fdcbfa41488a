/**
 * Which file includes which, below a root: found by following the links that the server knows. The files beside the robot,
 * which name its links and joints, are shown as well.
 */
import * as vscode from "vscode";
import { RequestType } from "vscode-languageclient";
import type { DocumentLink } from "vscode-languageclient";
import { rootLabel } from "./contexts";
import type { Contexts } from "./contexts";
import { includesOf } from "./includes";
import { baseName } from "./languages";
import { tree } from "./protocol";
import type { Server } from "./server";
import { webviewPage } from "./webviewPage";
import { isFileUri } from "./schemes";

const links = new RequestType<{ textDocument: { uri: string } }, DocumentLink[] | null, void>(
  "textDocument/documentLink",
);

/** Files of one graph, at most. */
const MOST_FILES = 500;

export interface GraphNode {
  id: string;
  label: string;
  detail: string;
  missing: boolean;
  /** For a file beside the robot: what it is for. */
  beside?: string;
}

export interface Graph {
  title: string;
  nodes: GraphNode[];
  edges: [from: string, to: string][];
}

export class IncludeGraph implements vscode.Disposable {
  private panel: vscode.WebviewPanel | undefined;

  constructor(
    private readonly server: Server,
    private readonly contexts: Contexts,
    private readonly extensionUri: vscode.Uri,
  ) {}

  async show(): Promise<void> {
    await this.contexts.refresh();
    const root = this.contexts.active;
    const start = root?.uri ?? this.contexts.document?.uri.toString();
    if (start === undefined) {
      void vscode.window.showInformationMessage("Open a xacro or URDF file first.");
      return;
    }
    const graph = await this.graphOf(start, root ? rootLabel(root) : baseName(start));
    const panel = this.panel ?? this.createPanel();
    this.panel = panel;
    panel.title = `Includes of ${graph.title}`;
    panel.webview.html = webviewPage(panel.webview, this.extensionUri, {
      title: panel.title,
      script: ["dist", "graph.js"],
      style: ["media", "graph.css"],
      data: graph,
    });
    panel.reveal(undefined, true);
  }

  dispose(): void {
    this.panel?.dispose();
  }

  private createPanel(): vscode.WebviewPanel {
    const panel = vscode.window.createWebviewPanel(
      "xacro.includeGraph",
      "Includes",
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      {
        enableScripts: true,
        localResourceRoots: ["dist", "media"].map((folder) => vscode.Uri.joinPath(this.extensionUri, folder)),
      },
    );
    panel.onDidDispose(() => (this.panel = undefined));
    panel.webview.onDidReceiveMessage((message: unknown) => {
      const { type, uri } = (message ?? {}) as { type?: unknown; uri?: unknown };
      if (type !== "open" || typeof uri !== "string" || !isFileUri(uri)) return;
      void vscode.window.showTextDocument(vscode.Uri.parse(uri), { viewColumn: vscode.ViewColumn.One });
    });
    return panel;
  }

  private async graphOf(start: string, title: string): Promise<Graph> {
    const nodes = new Map<string, GraphNode>();
    const edges: [string, string][] = [];
    const open = [start];
    nodes.set(start, node(start));
    for (let uri = open.shift(); uri !== undefined && nodes.size < MOST_FILES; uri = open.shift()) {
      const from = uri;
      const known = (await this.server.ask(links, { textDocument: { uri } })) ?? [];
      for (const include of includesOf(await textOf(uri))) {
        const link = known.find(
          ({ range }) => range.start.line === include.line && range.start.character <= include.end && range.end.character >= include.start,
        );
        const target = link?.target ?? `missing:${from}#${include.filename}`;
        if (!nodes.has(target)) {
          nodes.set(target, link?.target ? node(target) : missing(target, include.filename));
          if (link?.target) open.push(target);
        }
        edges.push([from, target]);
      }
    }
    const robot = await this.server.ask(tree, { textDocument: { uri: start } });
    for (const { uri, kind } of robot?.beside ?? []) {
      if (nodes.has(uri)) continue;
      nodes.set(uri, { ...node(uri), beside: kind });
      edges.push([start, uri]);
    }
    return { title, nodes: [...nodes.values()], edges };
  }
}

function node(uri: string): GraphNode {
  const detail = vscode.workspace.asRelativePath(vscode.Uri.parse(uri));
  return { id: uri, label: baseName(uri), detail, missing: false };
}

function missing(id: string, filename: string): GraphNode {
  return { id, label: filename, detail: "not found, or depends on values", missing: true };
}

async function textOf(uri: string): Promise<string> {
  const open = vscode.workspace.textDocuments.find((document) => document.uri.toString() === uri);
  if (open) return open.getText();
  try {
    return new TextDecoder().decode(await vscode.workspace.fs.readFile(vscode.Uri.parse(uri)));
  } catch {
    return "";
  }
}
