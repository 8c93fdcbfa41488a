/**
 * The language server: started, watched, restarted once when it dies.
 */
import * as vscode from "vscode";
import { CloseAction, ErrorAction, State, Trace } from "vscode-languageclient";
import type {
  BaseLanguageClient,
  CloseHandlerResult,
  ErrorHandler,
  LanguageClientOptions,
  Middleware,
  NotificationType,
  RequestType,
} from "vscode-languageclient";
import { LANGUAGES, isCompanionName, isSettingsName } from "./languages";
import { withPage } from "./rulePages";
import { fileSchemes } from "./schemes";
import { closeTag, withValueLists } from "./typing";
import { chosenSettings } from "./settings";

/** A second end within this time is not followed by another start. */
const RESTART_WINDOW_MS = 3 * 60_000;
/** JSON-RPC: the other side has no such request. */
const METHOD_NOT_FOUND = -32601;

/** Handlers of commands that the server puts into code lenses. */
export type CommandHandler = (args: unknown[], next: () => Promise<unknown>) => Promise<unknown>;

/** A server that can be started. */
export interface Launched {
  /** What it is called in messages. */
  name: string;
  /** By which step it was found. */
  from: string;
  client: (options: LanguageClientOptions) => BaseLanguageClient;
}

/** Finds a server. */
export interface Launcher {
  /** The server, or why there is none. */
  find: (context: vscode.ExtensionContext, output: vscode.LogOutputChannel) => Launched | { message: string };
  /** What the user can do when there is none. */
  advice?: string;
}

export class Server implements vscode.Disposable {
  readonly output: vscode.LogOutputChannel;
  private client: BaseLanguageClient | undefined;
  private found: Launched | undefined;
  private starting: Promise<void> = Promise.resolve();
  private lastEnd = Number.NEGATIVE_INFINITY;
  private readonly ready = new vscode.EventEmitter<BaseLanguageClient>();
  private readonly gone = new vscode.EventEmitter<void>();
  /** Each time a server is ready to be asked. */
  readonly onReady = this.ready.event;
  /** Each time it ended. */
  readonly onGone = this.gone.event;

  constructor(
    private readonly context: vscode.ExtensionContext,
    private readonly serverCommands: ReadonlyMap<string, CommandHandler>,
    private readonly launcher: Launcher,
  ) {
    this.output = vscode.window.createOutputChannel("Xacro", { log: true });
  }

  /** What turns answers of the server into values of VS Code. */
  get from(): BaseLanguageClient["protocol2CodeConverter"] | undefined {
    return this.client?.protocol2CodeConverter;
  }

  /** Whether requests are answered. */
  get isRunning(): boolean {
    return this.client?.isRunning() === true;
  }

  /** Which program runs and what it says of itself. */
  get about(): string {
    const info = this.client?.initializeResult?.serverInfo;
    const program = this.found ? `${this.found.name} (${this.found.from})` : "no program";
    return `${info?.name ?? "xacro-lsp"} ${info?.version ?? "?"}, ${this.isRunning ? "running" : "not running"}, ${program}`;
  }

  start(): Promise<void> {
    this.starting = this.starting.then(() => this.startNow());
    return this.starting;
  }

  restart(): Promise<void> {
    this.lastEnd = Number.NEGATIVE_INFINITY;
    this.starting = this.starting.then(async () => {
      await this.stopNow();
      await this.startNow();
    });
    return this.starting;
  }

  stop(): Promise<void> {
    this.starting = this.starting.then(() => this.stopNow());
    return this.starting;
  }

  /** Asks the server; `undefined` when there is none, when it does not know the request, or when it failed. */
  async ask<P, R>(
    type: RequestType<P, R, void>,
    params: P,
    token?: vscode.CancellationToken,
  ): Promise<R | undefined> {
    try {
      return await this.askStrictly(type, params, token);
    } catch (error) {
      this.output.debug(`${type.method}: ${String(error)}`);
      return undefined;
    }
  }

  /** Asks the server; an error of the server is thrown. */
  async askStrictly<P, R>(
    type: RequestType<P, R, void>,
    params: P,
    token?: vscode.CancellationToken,
  ): Promise<R | undefined> {
    const client = this.client;
    if (client?.isRunning() !== true) return undefined;
    return client.sendRequest(type, params, token);
  }

  /** Asks in a command of the user: `undefined` after the reason was shown. */
  async askForUser<P, R>(type: RequestType<P, R, void>, params: P): Promise<R | undefined> {
    if (!this.isReady()) return undefined;
    try {
      return await this.askStrictly(type, params);
    } catch (error) {
      const unknown = (error as { code?: unknown }).code === METHOD_NOT_FOUND;
      void vscode.window.showWarningMessage(
        unknown
          ? `This xacro language server does not support \`${type.method}\`; update it.`
          : `xacro: ${error instanceof Error ? error.message : String(error)}`,
      );
      return undefined;
    }
  }

  /** Whether requests are answered, for a command of the user: if not, the user is told and can start the server. */
  isReady(): boolean {
    if (!this.isRunning) void this.tellNotRunning();
    return this.isRunning;
  }

  async tell<P>(type: NotificationType<P>, params: P): Promise<void> {
    if (this.client?.isRunning() === true) await this.client.sendNotification(type, params);
  }

  on<P>(type: NotificationType<P>, handler: (params: P) => void): void {
    const listen = (client: BaseLanguageClient): void => {
      client.onNotification(type, handler);
    };
    this.context.subscriptions.push(this.onReady(listen));
    if (this.client) listen(this.client);
  }

  dispose(): void {
    this.output.dispose();
    this.ready.dispose();
    this.gone.dispose();
  }

  private async startNow(): Promise<void> {
    const found = this.launcher.find(this.context, this.output);
    if ("message" in found) {
      this.found = undefined;
      this.output.error(found.message);
      void this.tellMissing(found.message);
      return;
    }
    this.found = found;
    this.output.info(`server: ${found.name} (${found.from})`);
    const client = found.client(this.options());
    this.client = client;
    client.onDidChangeState(({ newState }) => {
      // also after the restart that the client makes by itself
      if (newState === State.Running) this.ready.fire(client);
      if (newState === State.Stopped) this.gone.fire();
    });
    try {
      await client.start();
      const trace = vscode.workspace.getConfiguration("xacro").get<string>("trace.server", "off");
      await client.setTrace(Trace.fromString(trace));
    } catch (error) {
      this.output.error(`the server could not be started: ${String(error)}`);
      void this.tellMissing(`${found.name} could not be started`);
    }
  }

  private async stopNow(): Promise<void> {
    const client = this.client;
    this.client = undefined;
    if (!client) return;
    try {
      await client.stop();
    } catch {
      // it is gone already
    }
    await client.dispose().catch(() => undefined);
  }

  private options(): LanguageClientOptions {
    return {
      documentSelector: [...fileSchemes(), "untitled"].flatMap((scheme) =>
        LANGUAGES.map((language) => ({ scheme, language })),
      ),
      outputChannel: this.output,
      traceOutputChannel: this.output,
      initializationOptions: this.initialOptions(),
      errorHandler: this.errorHandler(),
      middleware: this.middleware(),
      markdown: { isTrusted: false, supportHtml: false },
    };
  }

  private errorHandler(): ErrorHandler {
    return {
      // what is written into a pipe that closes right now is no news: `closed` follows
      error: () => ({ action: ErrorAction.Continue, handled: true }),
      closed: (): CloseHandlerResult => {
        const now = Date.now();
        const again = now - this.lastEnd < RESTART_WINDOW_MS;
        this.lastEnd = now;
        if (again) {
          void this.tellStopped();
          return { action: CloseAction.DoNotRestart, handled: true };
        }
        this.output.warn("the server stopped unexpectedly and is restarted");
        void vscode.window.showWarningMessage(
          "The xacro language server stopped unexpectedly and was restarted.",
        );
        return { action: CloseAction.Restart, handled: true };
      },
    };
  }

  private async tellNotRunning(): Promise<void> {
    const again = "Restart";
    const picked = await vscode.window.showWarningMessage("The xacro language server is not running.", again);
    if (picked === again) await this.restart();
  }

  private async tellStopped(): Promise<void> {
    this.output.error("the server stopped again and is not restarted");
    const again = "Restart";
    const output = "Show Output";
    const picked = await vscode.window.showErrorMessage(
      "The xacro language server stopped twice within three minutes and was not restarted.",
      again,
      output,
    );
    if (picked === again) await this.restart();
    if (picked === output) this.output.show();
  }

  private async tellMissing(reason: string): Promise<void> {
    if (this.launcher.advice === undefined) {
      void vscode.window.showErrorMessage(`xacro: ${reason}. Only syntax highlighting works.`);
      return;
    }
    const open = "Open Settings";
    const how = "How to Install";
    const picked = await vscode.window.showErrorMessage(
      `xacro: ${reason}. ${this.launcher.advice} Until then, only syntax highlighting works.`,
      open,
      how,
    );
    if (picked === open) {
      await vscode.commands.executeCommand("workbench.action.openSettings", "xacro.server.path");
    }
    if (picked === how) {
      const readme = vscode.Uri.joinPath(this.context.extensionUri, "README.md");
      await vscode.commands.executeCommand("markdown.showPreview", readme);
    }
  }

  private middleware(): Middleware {
    return {
      workspace: {
        configuration: (params) =>
          params.items.map((item) => {
            const scope = item.scopeUri === undefined ? undefined : vscode.Uri.parse(item.scopeUri);
            return item.section === undefined || item.section === "xacro" ? this.settingsOf(scope) : null;
          }),
      },
      // what the server knows for its text alone is not checked as a robot
      handleDiagnostics: (uri, diagnostics, next) => {
        next(uri, isCompanionName(uri.path) && !isSettingsName(uri.path) ? [] : diagnostics.map(withPage));
      },
      provideCompletionItem: async (document, position, context, token, next) =>
        withValueLists(await next(document, position, context, token)),
      provideOnTypeFormattingEdits: async (document, position, character, options, token, next) => {
        const edits = await next(document, position, character, options, token);
        return character === ">" && (await closeTag(document, position, edits)) ? [] : edits;
      },
      executeCommand: (command, args, next) => {
        const handler = this.serverCommands.get(command);
        const inner = async (): Promise<unknown> => (await next(command, args)) as unknown;
        return handler ? handler(args as unknown[], inner) : inner();
      },
    };
  }

  /**
   * The settings; findings are pushed, since those of an edit come before the whole robot is checked; and what of the
   * server's own protocol is known here.
   */
  private initialOptions(): Record<string, unknown> {
    const settings = this.settingsOf(undefined);
    const diagnostics = settings.diagnostics as Record<string, unknown> | undefined;
    const client = { contextChanged: true, lensCommands: true, expandedDocuments: true };
    return { ...settings, diagnostics: { ...diagnostics, pull: false }, client };
  }

  /** The settings that somebody chose, for a folder. */
  settingsOf(scope: vscode.Uri | undefined): Record<string, unknown> {
    const configuration = vscode.workspace.getConfiguration(undefined, scope ?? null);
    return chosenSettings(this.keys(), (key) => configuration.inspect(key));
  }

  private keys(): string[] {
    const manifest = this.context.extension.packageJSON as {
      contributes: { configuration: { properties: object }[] };
    };
    return manifest.contributes.configuration.flatMap((page) => Object.keys(page.properties));
  }
}
