/**
 * The 3D preview: the viewer in a webview, and messages between it and the server.
 *
 * The page comes from the extension alone, gets everything by messages, and is not believed: each of its messages is
 * checked before anything is done with it. docs/preview.md of the repository describes both sides.
 */
import * as vscode from "vscode";
import { NotificationType, RequestType } from "vscode-languageclient";
import { rootLabel, sameRoot } from "./contexts";
import type { Contexts } from "./contexts";
import { toRange } from "./cursorSync";
import { isRobotDescription } from "./languages";
import { plain } from "./pickers";
import type { FromViewer, Place } from "./previewMessages";
import { fromViewer } from "./previewMessages";
import type { Root } from "./protocol";
import type { Server } from "./server";
import { webviewPage } from "./webviewPage";

/** The viewer, below the extension. */
const VIEWER = ["viewer", "viewer.js"];
const VIEW_TYPE = "xacro.preview";
const FOLLOW_MS = 60;

interface ToServerSelect {
  id: number;
  link?: string;
  joint?: string;
  location?: Place;
}

interface FromServerSelect extends ToServerSelect {
  links?: string[];
  joints?: string[];
}

const subscribe = new RequestType<{ root: Root }, { id: number }, void>("xacro/preview/subscribe");
const unsubscribe = new RequestType<{ id: number }, null, void>("xacro/preview/unsubscribe");
const changeRoot = new RequestType<{ id: number; root: Root; compare?: Root | null }, null, void>(
  "xacro/preview/setRoot",
);
const mesh = new RequestType<{ id: number; mesh: string }, { data: string; name: string }, void>(
  "xacro/preview/mesh",
);
const urdf = new RequestType<{ id: number }, { urdf: string }, void>("xacro/preview/urdf");
const model = new NotificationType<{ id: number; root?: Root; side?: string }>("xacro/preview/model");
const selectByServer = new NotificationType<FromServerSelect>("xacro/preview/select");
const selectByUser = new NotificationType<ToServerSelect>("xacro/preview/select");

function fromBase64(text: string): Uint8Array {
  if (typeof Buffer === "function") return new Uint8Array(Buffer.from(text, "base64"));
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}

export class Preview implements vscode.WebviewPanelSerializer, vscode.Disposable {
  private panel: vscode.WebviewPanel | undefined;
  private id: number | undefined;
  private root: Root | undefined;
  /** The root of the file that is looked at, when the preview last went along with it. */
  private followed: Root | undefined;
  /** A click in the preview waits for the server to say where it leads. */
  private clicked = false;
  private turn = 0;
  private timer: NodeJS.Timeout | undefined;
  private readonly subscriptions: vscode.Disposable[];

  constructor(
    private readonly server: Server,
    private readonly contexts: Contexts,
    private readonly extensionUri: vscode.Uri,
    private readonly memory: vscode.Memento,
  ) {
    server.on(model, (params) => this.modelCame(params));
    server.on(selectByServer, (params) => this.selected(params));
    this.subscriptions = [
      vscode.window.registerWebviewPanelSerializer(VIEW_TYPE, this),
      contexts.onChange(() => this.followRoot()),
      server.onReady(() => void this.begin()),
      server.onGone(() => (this.id = undefined)),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor, kind }) => {
        // what a click in the preview moved must not come back as a wish of the user
        if (kind !== undefined || textEditor === vscode.window.activeTextEditor) this.followCursor(textEditor);
      }),
      vscode.window.onDidChangeActiveColorTheme(() => this.sendSettings()),
      vscode.workspace.onDidChangeConfiguration((event) => {
        if (event.affectsConfiguration("xacro.preview")) this.sendSettings();
      }),
    ];
  }

  get isOpen(): boolean {
    return this.panel !== undefined;
  }

  /** Show the robot that the file in front belongs to. */
  async open(): Promise<void> {
    if (!this.server.isReady()) return;
    await this.contexts.refresh();
    const root = this.contexts.active;
    if (!root) {
      void vscode.window.showInformationMessage(
        this.contexts.document
          ? "No root includes this file, so there is no robot to show."
          : "Open a xacro or URDF file first.",
      );
      return;
    }
    if (this.panel) {
      this.panel.reveal(undefined, true);
      if (!sameRoot(root, this.root)) await this.show(root);
      return;
    }
    if (!(await this.hasViewer())) {
      void vscode.window.showWarningMessage("This build of the extension does not include the 3D viewer.");
      return;
    }
    const panel = vscode.window.createWebviewPanel(
      VIEW_TYPE,
      "Preview",
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { ...this.options(), retainContextWhenHidden: true },
    );
    this.root = root;
    this.adopt(panel);
  }

  deserializeWebviewPanel(panel: vscode.WebviewPanel): Promise<void> {
    this.root = this.memory.get<Root>("xacro.preview.root");
    panel.webview.options = this.options();
    this.adopt(panel);
    return Promise.resolve();
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.panel?.dispose();
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private async hasViewer(): Promise<boolean> {
    const viewer = vscode.Uri.joinPath(this.extensionUri, ...VIEWER);
    return vscode.workspace.fs.stat(viewer).then(
      () => true,
      () => false,
    );
  }

  private options(): vscode.WebviewOptions {
    const viewer = vscode.Uri.joinPath(this.extensionUri, ...VIEWER.slice(0, -1));
    return { enableScripts: true, localResourceRoots: [viewer, vscode.Uri.joinPath(this.extensionUri, "media")] };
  }

  private adopt(panel: vscode.WebviewPanel): void {
    this.panel?.dispose();
    this.panel = panel;
    this.followed = this.contexts.active;
    panel.iconPath = vscode.Uri.joinPath(this.extensionUri, "images", "file.svg");
    panel.webview.onDidReceiveMessage((message: unknown) => {
      const known = fromViewer(message);
      if (known) void this.onMessage(known);
      else this.server.output.warn("the preview sent an invalid message");
    });
    panel.onDidDispose(() => {
      if (this.panel !== panel) return;
      this.panel = undefined;
      void this.end();
    });
    this.title();
    panel.webview.html = webviewPage(panel.webview, this.extensionUri, {
      title: "Preview",
      script: VIEWER,
      style: ["media", "preview.css"],
    });
  }

  private title(): void {
    if (this.panel && this.root) this.panel.title = `Preview ${rootLabel(this.root)}`;
  }

  private async onMessage(message: FromViewer): Promise<void> {
    switch (message.type) {
      case "ready":
        this.sendSettings();
        return this.begin();
      case "open":
        return this.go(message.location);
      case "select":
        if (message.location) await this.go(message.location);
        this.clicked = !message.location && (message.link ?? message.joint) !== undefined;
        if (this.id === undefined) return;
        return this.server.tell(selectByUser, {
          id: this.id,
          ...(message.link === undefined ? {} : { link: message.link }),
          ...(message.joint === undefined ? {} : { joint: message.joint }),
          ...(message.location === undefined ? {} : { location: message.location }),
        });
      case "root":
        this.root = message.root;
        this.title();
        await this.memory.update("xacro.preview.root", message.root);
        if (this.id === undefined) return;
        await this.server.askForUser(changeRoot, { id: this.id, root: message.root, compare: message.compare });
        if (message.compare === null) this.post("closed", { side: "compare" });
        return;
      case "mesh":
        return this.sendMesh(message.mesh);
      case "urdf":
        return this.sendUrdf();
    }
  }

  /** Subscribe, or subscribe again. */
  private async begin(): Promise<void> {
    const root = this.root ?? this.contexts.active;
    if (!this.panel || !root || !this.server.isRunning) return;
    const turn = ++this.turn;
    await this.end();
    const answer = await this.server.askForUser(subscribe, { root });
    if (!answer) return;
    if (turn !== this.turn) {
      await this.server.ask(unsubscribe, answer);
      return;
    }
    this.id = answer.id;
    this.root = root;
    this.title();
    await this.memory.update("xacro.preview.root", root);
    for (const early of this.early.splice(0)) if (early.id === answer.id) this.post("model", early);
    const editor = vscode.window.activeTextEditor;
    if (editor) this.followCursor(editor);
  }

  /** Models that came before the answer that names their subscription. */
  private readonly early: { id: number }[] = [];

  private modelCame(params: { id: number; root?: Root; side?: string }): void {
    if (params.id === this.id) return this.post("model", params);
    if (this.id === undefined) this.early.splice(0, Math.max(0, this.early.length - 3), params);
  }

  private async end(): Promise<void> {
    const id = this.id;
    this.id = undefined;
    if (id !== undefined) await this.server.ask(unsubscribe, { id });
  }

  private async show(root: Root): Promise<void> {
    this.root = root;
    this.title();
    await this.memory.update("xacro.preview.root", root);
    if (this.id === undefined) return this.begin();
    await this.server.ask(changeRoot, { id: this.id, root });
  }

  /** Another root or other arguments were picked for the file that is looked at. */
  private followRoot(): void {
    const active = this.contexts.active;
    if (!this.panel || !active || sameRoot(active, this.followed)) return;
    this.followed = active;
    if (!sameRoot(active, this.root)) void this.show(active);
  }

  private followCursor(editor: vscode.TextEditor): void {
    clearTimeout(this.timer);
    if (this.id === undefined || !isRobotDescription(editor.document)) return;
    this.timer = setTimeout(() => {
      if (this.id === undefined) return;
      const at = plain(editor.selection.active);
      const location = { uri: editor.document.uri.toString(), range: { start: at, end: at } };
      void this.server.tell(selectByUser, { id: this.id, location });
    }, FOLLOW_MS);
  }

  private selected(params: FromServerSelect): void {
    if (params.id !== this.id) return;
    this.post("select", params);
    if (this.clicked && params.location && (params.link ?? params.joint) !== undefined) {
      this.clicked = false;
      void this.go(params.location);
    }
  }

  private async sendMesh(id: string): Promise<void> {
    if (this.id === undefined) return;
    try {
      const answer = await this.server.askStrictly(mesh, { id: this.id, mesh: id });
      if (!answer) return;
      const bytes = fromBase64(answer.data);
      this.post("mesh", { mesh: id, data: bytes });
    } catch (error) {
      this.post("mesh", { mesh: id, error: error instanceof Error ? error.message : String(error) });
    }
  }

  /** The robot as it is shown, for the viewer to save. */
  private async sendUrdf(): Promise<void> {
    if (this.id === undefined) { this.post("urdf", { error: "the language server does not run" }); return; }
    try {
      const answer = await this.server.askStrictly(urdf, { id: this.id });
      this.post("urdf", answer ? { text: answer.urdf } : { error: "the language server did not answer" });
    } catch (error) {
      this.post("urdf", { error: error instanceof Error ? error.message : String(error) });
    }
  }

  private sendSettings(): void {
    const settings = vscode.workspace.getConfiguration("xacro.preview");
    const { Light, HighContrastLight } = vscode.ColorThemeKind;
    const kind = vscode.window.activeColorTheme.kind;
    this.post("settings", {
      fps: settings.get("fps", 60),
      meshMaxMB: settings.get("meshMaxMB", 64),
      urdf: true,
      theme: kind === Light || kind === HighContrastLight ? "light" : "dark",
    });
  }

  private post(type: string, message: object): void {
    void this.panel?.webview.postMessage({ ...message, type });
  }

  /** Put the cursor on a place in a source, beside the preview. */
  private async go(place: Place): Promise<void> {
    const uri = vscode.Uri.parse(place.uri);
    const visible = vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === uri.toString());
    const source = visible ?? vscode.window.visibleTextEditors.find(({ document }) => isRobotDescription(document));
    const column = source?.viewColumn;
    const viewColumn = column ?? (this.panel?.viewColumn === vscode.ViewColumn.One ? vscode.ViewColumn.Beside : vscode.ViewColumn.One);
    const range = toRange(place.range);
    const selection = new vscode.Range(range.start, range.start);
    const editor = await vscode.window.showTextDocument(uri, { viewColumn, selection, preview: true });
    editor.revealRange(range, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
  }
}
