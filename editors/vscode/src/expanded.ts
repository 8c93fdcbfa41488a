/**
 * Expanded robots as read-only documents that follow their sources while these are typed.
 */
import * as vscode from "vscode";
import { bannerText } from "./expandedText";
import { committedTexts } from "./git";
import { EXPANDED_SCHEME, baseName, isRobotDescription } from "./languages";
import * as protocol from "./protocol";
import type { ExpandError, ExpandedAt } from "./protocol";
import type { Server } from "./server";
import type { Contexts } from "./contexts";
import { isFileScheme } from "./schemes";
import { StaleMark, openError } from "./staleMark";
import type { Stale } from "./staleMark";

/** Pause after a keystroke before the robot is expanded again. */
const DELAY_MS = 40;

/** What a robot is compared with: the saved files, or the last commit. */
export type Version = "saved" | "committed";

/** One robot as it was expanded last. */
interface Robot {
  text: string;
  /** When `text` was made, if errors came up since. */
  time: Date;
  errors: ExpandError[];
  ok: boolean;
  /** The texts of earlier versions, as far as they were asked for. */
  earlier: Partial<Record<Version, string>>;
  running?: Promise<void>;
  again: boolean;
}

export class ExpandedDocuments
  implements vscode.TextDocumentContentProvider, vscode.CodeLensProvider, vscode.Disposable
{
  private readonly robots = new Map<string, Robot>();
  private readonly fragments = new Map<string, string>();
  private readonly changed = new vscode.EventEmitter<vscode.Uri>();
  private readonly banners = new vscode.EventEmitter<void>();
  readonly onDidChange = this.changed.event;
  readonly onDidChangeCodeLenses = this.banners.event;
  private timer: NodeJS.Timeout | undefined;
  private readonly mark: StaleMark;
  private readonly subscriptions: vscode.Disposable[];

  constructor(
    private readonly server: Server,
    private readonly contexts: Contexts,
  ) {
    const soon = (): void => this.updateSoon();
    this.mark = new StaleMark((uri) => this.staleOf(uri));
    this.subscriptions = [
      this.mark,
      this.changed,
      this.banners,
      vscode.workspace.registerTextDocumentContentProvider(EXPANDED_SCHEME, this),
      vscode.languages.registerCodeLensProvider({ scheme: EXPANDED_SCHEME }, this),
      contexts.onChange(soon),
      server.onReady(soon),
      vscode.workspace.onDidChangeTextDocument(({ document }) => {
        if (isFileScheme(document.uri.scheme)) this.updateSoon();
      }),
      vscode.workspace.onDidSaveTextDocument(soon),
      vscode.workspace.onDidCloseTextDocument(({ uri }) => this.forget(uri)),
    ];
  }

  provideTextDocumentContent(uri: vscode.Uri): string | Promise<string> {
    const query = new URLSearchParams(uri.query);
    const fragment = query.get("fragment");
    if (fragment !== null) return this.fragments.get(fragment) ?? "";
    const root = query.get("root") ?? "";
    const robot = this.robots.get(root);
    const version = query.get("version");
    if (version !== null) return robot?.earlier[version as Version] ?? "";
    return robot ? robot.text : this.update(root).then(() => this.robots.get(root)?.text ?? "");
  }

  provideCodeLenses(document: vscode.TextDocument): vscode.CodeLens[] {
    const robot = this.robots.get(rootOf(document.uri) ?? "");
    const [first] = robot?.errors ?? [];
    if (!robot || robot.ok || !first) return [];
    const top = new vscode.Range(0, 0, 0, 0);
    const title = `$(warning) ${bannerText(robot.errors.length, robot.time)}`;
    return [new vscode.CodeLens(top, { ...openError(first), title, tooltip: first.message })];
  }

  /** Errors of the sources that a document is older than. */
  private staleOf(uri: vscode.Uri): Stale | undefined {
    const robot = this.robots.get(rootOf(uri) ?? "");
    return robot && !robot.ok && robot.errors.length > 0 ? robot : undefined;
  }

  /** Show the robot that a file belongs to, beside it. */
  async open(document: vscode.TextDocument | undefined): Promise<void> {
    const root = await this.rootFor(document);
    if (root === undefined) return;
    const uri = expandedUri(root);
    await this.update(root);
    const shown = vscode.window.visibleTextEditors.find((editor) => sameUri(editor.document.uri, uri));
    await vscode.window.showTextDocument(uri, {
      viewColumn: shown?.viewColumn ?? vscode.ViewColumn.Beside,
      preserveFocus: true,
      preview: false,
    });
  }

  /** What the changes since an earlier version make of a robot. */
  async compare(document: vscode.TextDocument | undefined, version: Version): Promise<void> {
    const expanded = vscode.window.activeTextEditor?.document.uri;
    const root = (expanded && rootOf(expanded)) ?? (await this.rootFor(document));
    if (root === undefined) return;
    await this.update(root);
    if (!(await this.expandEarlier(root, version))) return;
    const name = baseName(expandedUri(root).path);
    await vscode.commands.executeCommand(
      "vscode.diff",
      expandedUri(root, version),
      expandedUri(root),
      `${name} (${version} ↔ now)`,
      // a preview editor would give way to the next file that is shown
      { preview: false },
    );
  }

  /** Expand an earlier version of a robot; whether there is one. */
  private async expandEarlier(root: string, version: Version): Promise<boolean> {
    const texts = version === "saved" ? {} : await committedTexts(vscode.Uri.parse(root));
    if (!texts) {
      void vscode.window.showInformationMessage("The robot is not in an open Git repository.");
      return false;
    }
    const answer = await this.server.askForUser(protocol.expand, { textDocument: { uri: root }, texts });
    const robot = this.robots.get(root);
    if (!answer || !robot) return false;
    if (!answer.ok) {
      void vscode.window.showWarningMessage("The earlier version has errors; only a part of it is shown.");
    }
    robot.earlier[version] = answer.urdf;
    this.changed.fire(expandedUri(root, version));
    return true;
  }

  /** Show what one place expands to. */
  async showFragment(expanded: ExpandedAt): Promise<void> {
    const name = expanded.title.replace(/[^\w.-]+/g, "_").replace(/^_+|_+$/g, "").slice(0, 60) || expanded.kind;
    this.fragments.set(name, expanded.expanded);
    const uri = vscode.Uri.from({
      scheme: EXPANDED_SCHEME,
      path: `/${name}.urdf`,
      query: new URLSearchParams({ fragment: name }).toString(),
    });
    this.changed.fire(uri);
    await vscode.window.showTextDocument(uri, {
      viewColumn: vscode.ViewColumn.Beside,
      preserveFocus: true,
      preview: true,
    });
  }

  /** The text of a robot as it is now. */
  async textOf(root: string): Promise<string | undefined> {
    const answer = await this.server.ask(protocol.expand, { textDocument: { uri: root } });
    return answer?.urdf;
  }

  /** Whether the text of an expanded document fits its sources, so that places can be mapped. */
  isCurrent(uri: vscode.Uri): boolean {
    return this.robots.get(rootOf(uri) ?? "")?.ok === true;
  }

  dispose(): void {
    clearTimeout(this.timer);
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private async rootFor(document: vscode.TextDocument | undefined): Promise<string | undefined> {
    if (!document || !isRobotDescription(document)) {
      void vscode.window.showInformationMessage("Open a xacro or URDF file first.");
      return undefined;
    }
    const textDocument = { uri: document.uri.toString() };
    const answer = await this.server.askForUser(protocol.roots, { textDocument });
    if (!answer) return undefined;
    return answer.active?.uri ?? textDocument.uri;
  }

  private updateSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      for (const root of this.robots.keys()) void this.update(root);
    }, DELAY_MS);
  }

  /** Expand again; while one expansion runs, further wishes become one. */
  private update(root: string): Promise<void> {
    const robot = this.robots.get(root) ?? { text: "", time: new Date(), errors: [], ok: false, again: false, earlier: {} };
    this.robots.set(root, robot);
    robot.again = true;
    if (robot.running) return robot.running;
    robot.running = (async () => {
      while (wanted(robot)) await this.expandOnce(root, robot);
      delete robot.running;
    })();
    return robot.running;
  }

  private async expandOnce(root: string, robot: Robot): Promise<void> {
    const saved = !vscode.workspace.textDocuments.some((document) => document.isDirty);
    const answer = await this.server.ask(protocol.expand, { textDocument: { uri: root } });
    if (!answer) return;
    robot.errors = answer.errors;
    robot.ok = answer.ok;
    // a broken robot never replaces a whole one
    if (answer.ok || robot.text === "") {
      const differs = robot.text !== answer.urdf;
      robot.text = answer.urdf;
      robot.time = new Date();
      if (differs) this.changed.fire(expandedUri(root));
    }
    if (answer.ok && saved && robot.earlier.saved !== undefined && robot.earlier.saved !== answer.urdf) {
      robot.earlier.saved = answer.urdf;
      this.changed.fire(expandedUri(root, "saved"));
    }
    this.banners.fire();
    this.mark.update();
  }

  private forget(uri: vscode.Uri): void {
    const root = rootOf(uri);
    if (root !== undefined) this.robots.delete(root);
  }
}

/** Takes the wish for another expansion, if there is one. */
function wanted(robot: Robot): boolean {
  const { again } = robot;
  robot.again = false;
  return again;
}

/** The document with a robot in it, as it is now or was. */
export function expandedUri(root: string, version?: Version): vscode.Uri {
  const stem = baseName(root).replace(/(\.urdf)?\.xacro$|\.urdf$/, "");
  const query = new URLSearchParams(version ? { root, version } : { root });
  return vscode.Uri.from({ scheme: EXPANDED_SCHEME, path: `/${stem}.urdf`, query: query.toString() });
}

/** The root of an expanded document; none for earlier versions and fragments. */
export function rootOf(uri: vscode.Uri): string | undefined {
  if (uri.scheme !== EXPANDED_SCHEME) return undefined;
  const query = new URLSearchParams(uri.query);
  return query.has("version") ? undefined : (query.get("root") ?? undefined);
}

function sameUri(one: vscode.Uri, other: vscode.Uri): boolean {
  return one.toString() === other.toString();
}
