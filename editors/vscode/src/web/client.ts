/**
 * The server in a worker, and the client that talks to it.
 */
import * as vscode from "vscode";
import {
  AbstractMessageReader,
  AbstractMessageWriter,
  DidChangeWatchedFilesNotification,
  FileChangeType,
  LanguageClient,
} from "vscode-languageclient/browser";
import type {
  DataCallback,
  Disposable,
  LanguageClientOptions,
  Message,
  MessageTransports,
} from "vscode-languageclient/browser";
import type { Launcher } from "../server";
import { Files } from "./files";
import type { Changes, FromWorker, ToWorker } from "./messages";
import { Names, namedFolders } from "./uris";

/** The server, below the extension. */
const PROGRAM = ["wasm", "xacro_lsp.wasm"];

export const worker: Launcher = {
  find: ({ extensionUri }, output) => ({
    name: PROGRAM.join("/"),
    from: "extension",
    client: (options) => new WorkerClient(extensionUri, output, options),
  }),
};

class WorkerClient extends LanguageClient {
  constructor(
    private readonly extensionUri: vscode.Uri,
    private readonly output: vscode.LogOutputChannel,
    options: LanguageClientOptions,
  ) {
    const workspace = {
      ...options.middleware?.workspace,
      // `Files` tells of them, when the worker has them
      didChangeWatchedFile: () => Promise.resolve(),
    };
    // the worker of this moment is made below
    super("xacro", "Xacro", { ...options, middleware: { ...options.middleware, workspace } }, undefined as unknown as Worker);
  }

  protected override async createMessageTransports(): Promise<MessageTransports> {
    const begin = performance.now();
    const names = new Names(namedFolders((vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri.toString())));
    const read = (...parts: string[]) => vscode.workspace.fs.readFile(vscode.Uri.joinPath(this.extensionUri, ...parts));
    const [script, wasm] = await Promise.all([read("dist", "worker.js"), read(...PROGRAM)]);
    const port = new Port(script);
    const files = new Files(names, this.output, (changes) => {
      port.post({ files: changes });
      this.filesChanged(changes, names);
    });
    port.onWanted = (paths) => void files.give(paths);
    try {
      const [all] = await Promise.all([files.all(), port.start(wasm)]);
      port.post({ files: all });
    } catch (error) {
      files.dispose();
      port.dispose();
      throw error;
    }
    this.output.info(`the worker is ready after ${Math.round(performance.now() - begin)} ms`);
    const reader = new Reader(port, names, () => files.dispose());
    return { reader, writer: new Writer(port, names), detached: false };
  }

  private filesChanged({ put, names: came, removed }: Changes, names: Names): void {
    const event = (type: FileChangeType) => (path: string) => ({ uri: names.uri(path), type });
    const changes = [
      ...put.map(([path]) => path).map(event(FileChangeType.Changed)),
      ...came.map(event(FileChangeType.Created)),
      ...removed.map(event(FileChangeType.Deleted)),
    ];
    if (changes.length > 0 && this.isRunning()) {
      void this.sendNotification(DidChangeWatchedFilesNotification.type, { changes });
    }
  }
}

/** The way to a worker. */
class Port {
  onMessage: (message: string) => void = () => undefined;
  onWanted: (paths: string[]) => void = () => undefined;
  onFailed: (reason: string) => void = () => undefined;
  private onReady: () => void = () => undefined;

  private readonly worker: Worker;

  constructor(script: Uint8Array) {
    // the page cannot load it by its name, which may be one of a file system of the editor
    const url = URL.createObjectURL(new Blob([script as BlobPart], { type: "text/javascript" }));
    const worker = new Worker(url);
    this.worker = worker;
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
      if ("message" in data) this.onMessage(data.message);
      else if ("wanted" in data) this.onWanted(data.wanted);
      else if ("ready" in data) this.onReady();
      else this.onFailed(data.failed);
    };
    worker.onerror = ({ message }) => this.onFailed(message);
  }

  start(wasm: Uint8Array): Promise<void> {
    return new Promise((done, failed) => {
      this.onReady = done;
      this.onFailed = (reason) => failed(new Error(reason));
      this.post({ wasm });
    });
  }

  post(message: ToWorker): void {
    this.worker.postMessage(message);
  }

  dispose(): void {
    this.worker.terminate();
  }
}

class Reader extends AbstractMessageReader {
  constructor(
    private readonly port: Port,
    private readonly names: Names,
    private readonly ended: () => void,
  ) {
    super();
    port.onFailed = (reason) => {
      this.fireError(new Error(reason));
      this.dispose();
      this.fireClose();
    };
  }

  listen(callback: DataCallback): Disposable {
    this.port.onMessage = (message) => callback(this.names.fromWorker(JSON.parse(message)) as Message);
    return { dispose: () => (this.port.onMessage = () => undefined) };
  }

  override dispose(): void {
    this.ended();
    this.port.dispose();
  }
}

class Writer extends AbstractMessageWriter {
  constructor(
    private readonly port: Port,
    private readonly names: Names,
  ) {
    super();
  }

  write(message: Message): Promise<void> {
    this.port.post({ message: JSON.stringify(this.names.toWorker(message)) });
    return Promise.resolve();
  }

  end(): void {
    // the worker ends with the reader
  }
}
