/**
 * The views of the side bar: the kinematic tree, and the roots with their arguments.
 */
import * as vscode from "vscode";
import { argumentsText, isSameRun, rootLabel } from "./contexts";
import type { Contexts } from "./contexts";
import type { ExpandedDocuments } from "./expanded";
import { firstLink, linkOfLine } from "./expandedText";
import { toRange } from "./cursorSync";
import { isRobotDescription } from "./languages";
import { plain } from "./pickers";
import * as protocol from "./protocol";
import type { Argument, Root, TreeNode } from "./protocol";
import type { Server } from "./server";

const FOLLOW_MS = 120;

export class KinematicTree implements vscode.TreeDataProvider<TreeNode>, vscode.Disposable {
  private readonly changed = new vscode.EventEmitter<undefined>();
  readonly onDidChangeTreeData = this.changed.event;
  private nodes: TreeNode[] = [];
  private byLink = new Map<string, TreeNode>();
  private below = new Map<string | undefined, TreeNode[]>();
  private readonly view: vscode.TreeView<TreeNode>;
  private turn = 0;
  private timer: NodeJS.Timeout | undefined;
  private readonly subscriptions: vscode.Disposable[];

  constructor(
    private readonly server: Server,
    private readonly contexts: Contexts,
    private readonly documents: ExpandedDocuments,
  ) {
    this.view = vscode.window.createTreeView("xacro.tree", { treeDataProvider: this, showCollapseAll: true });
    this.subscriptions = [
      this.changed,
      this.view,
      contexts.onChange(() => void this.refresh()),
      this.view.onDidChangeVisibility(() => void this.refresh()),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => this.moved(textEditor)),
    ];
  }

  getTreeItem(node: TreeNode): vscode.TreeItem {
    const children = this.below.get(node.link) ?? [];
    const state = vscode.TreeItemCollapsibleState;
    const item = new vscode.TreeItem(node.link, children.length > 0 ? state.Expanded : state.None);
    item.id = node.link;
    item.iconPath = new vscode.ThemeIcon(node.parent === undefined ? "home" : "symbol-class");
    item.description = [node.joint, node.mass === undefined ? undefined : mass(node.mass)]
      .filter((part) => part !== undefined)
      .join(" · ");
    item.tooltip = [
      `link ${node.link}`,
      node.joint === undefined ? "the root of the tree" : `child of joint ${node.joint}, parent ${node.parent ?? "?"}`,
      node.mass === undefined ? "no mass" : mass(node.mass),
    ].join("\n");
    item.contextValue = "link";
    item.command = {
      command: "vscode.open",
      title: "Go to Source",
      arguments: [
        vscode.Uri.parse(node.location.uri),
        { selection: toRange(node.location.range), preserveFocus: true, preview: true },
      ],
    };
    return item;
  }

  getChildren(node?: TreeNode): TreeNode[] {
    if (node) return this.below.get(node.link) ?? [];
    return this.nodes.filter(({ parent }) => parent === undefined || !this.byLink.has(parent));
  }

  getParent(node: TreeNode): TreeNode | undefined {
    return node.parent === undefined ? undefined : this.byLink.get(node.parent);
  }

  async refresh(): Promise<void> {
    if (!this.view.visible) return;
    const turn = ++this.turn;
    const document = this.contexts.document;
    const answer =
      document && (await this.server.ask(protocol.tree, { textDocument: { uri: document.uri.toString() } }));
    if (turn !== this.turn) return;
    this.nodes = answer?.nodes ?? [];
    this.byLink = new Map(this.nodes.map((node) => [node.link, node]));
    this.below = new Map();
    for (const node of this.nodes) {
      const siblings = this.below.get(node.parent) ?? [];
      siblings.push(node);
      this.below.set(node.parent, siblings);
    }
    const active = this.contexts.active;
    this.view.description = active ? rootLabel(active) : "";
    const problems = answer?.problems.length ?? 0;
    if (problems > 0) {
      this.view.message = `${problems} ${problems === 1 ? "error" : "errors"}: only a part of the robot is shown`;
    } else if (answer && this.nodes.length === 0) {
      this.view.message = "This file does not define a robot.";
    } else {
      this.view.message = "";
    }
    this.changed.fire(undefined);
    const editor = vscode.window.activeTextEditor;
    if (editor) this.moved(editor);
  }

  dispose(): void {
    clearTimeout(this.timer);
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private moved(editor: vscode.TextEditor): void {
    clearTimeout(this.timer);
    if (!this.view.visible || !isRobotDescription(editor.document)) return;
    this.timer = setTimeout(() => void this.follow(editor), FOLLOW_MS);
  }

  /** Select the link that the text at the cursor makes. */
  private async follow(editor: vscode.TextEditor): Promise<void> {
    const turn = this.turn;
    const link = await this.linkAt({
      textDocument: { uri: editor.document.uri.toString() },
      position: plain(editor.selection.active),
    });
    if (turn !== this.turn) return;
    const node = link === undefined ? undefined : this.byLink.get(link);
    if (node && this.view.visible) await this.view.reveal(node, { select: true, focus: false });
  }

  /** The first link that a place makes. */
  private async linkAt(at: protocol.ExpandAtParams): Promise<string | undefined> {
    const answer = await this.server.ask(protocol.toExpanded, at);
    const [first] = answer?.instances ?? [];
    if (answer && first) {
      const text = await this.documents.textOf(answer.root.uri);
      return text === undefined ? undefined : linkOfLine(text.split("\n"), first.range.start.line);
    }
    // a macro call makes nothing by its own text
    const call = await this.server.ask(protocol.expandAt, at);
    return call?.kind === "macro" ? firstLink(call.expanded) : undefined;
  }
}

type RootsItem = { root: Root } | { argument: Argument };

export class RootsView implements vscode.TreeDataProvider<RootsItem>, vscode.Disposable {
  private readonly changed = new vscode.EventEmitter<undefined>();
  readonly onDidChangeTreeData = this.changed.event;
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly contexts: Contexts) {
    const view = vscode.window.createTreeView<RootsItem>("xacro.roots", { treeDataProvider: this });
    const show = (): void => {
      view.message = contexts.roots && !contexts.active ? "No root includes this file." : "";
      this.changed.fire(undefined);
    };
    this.subscriptions = [this.changed, view, contexts.onChange(show)];
  }

  getTreeItem(item: RootsItem): vscode.TreeItem {
    const state = vscode.TreeItemCollapsibleState;
    if ("argument" in item) {
      const made = new vscode.TreeItem(item.argument.name, state.None);
      made.description = item.argument.value ?? "no value";
      made.iconPath = new vscode.ThemeIcon("symbol-parameter");
      made.command = { command: "xacro.pickArguments", title: "Set Arguments" };
      return made;
    }
    const { root } = item;
    const { roots, active } = this.contexts;
    const isActive = isSameRun(root, active);
    const has = isActive && (roots?.args.length ?? 0) > 0;
    const made = new vscode.TreeItem(rootLabel(root), has ? state.Expanded : state.None);
    made.resourceUri = vscode.Uri.parse(root.uri);
    made.iconPath = new vscode.ThemeIcon(isActive ? "pass-filled" : "circle-large-outline");
    const args = argumentsText(isActive ? active?.args : root.args);
    made.description = [root.preset, args, isActive ? roots?.reason : ""].filter(Boolean).join(" · ");
    made.tooltip = vscode.workspace.asRelativePath(made.resourceUri);
    made.contextValue = isActive ? "activeRoot" : "root";
    made.command = { command: "vscode.open", title: "Open", arguments: [made.resourceUri] };
    return made;
  }

  getChildren(item?: RootsItem): RootsItem[] {
    const { roots, active } = this.contexts;
    if (item) {
      const isActive = "root" in item && isSameRun(item.root, active);
      return isActive ? (roots?.args ?? []).map((argument) => ({ argument })) : [];
    }
    const candidates: Root[] = roots ? roots.candidates : [];
    const known = candidates.some((candidate) => isSameRun(candidate, active));
    return [...(active && !known ? [active] : []), ...candidates].map((root) => ({ root }));
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }
}

function mass(kilograms: number): string {
  return `${Number(kilograms.toPrecision(4))} kg`;
}
