/**
 * Under which robot each file is shown: what the server says, and what the user picked and is kept in the workspace.
 */
import * as vscode from "vscode";
import { baseName, isRobotDescription } from "./languages";
import * as protocol from "./protocol";
import type { Root, Roots } from "./protocol";
import type { Server } from "./server";

const PICKS = "xacro.picks";

/** Arguments in the words that a command line would use. */
export function argumentsText(args: Record<string, string> | undefined): string {
  return Object.entries(args ?? {})
    .map(([name, value]) => `${name}:=${value}`)
    .join(" ");
}

/** Whether two roots are the same run of the same robot: preset and arguments. */
export function sameRoot(one: Root | null | undefined, other: Root | null | undefined): boolean {
  if (!one || !other) return !one && !other;
  const [a, b] = [one.args ?? {}, other.args ?? {}];
  const names = new Set([...Object.keys(a), ...Object.keys(b)]);
  return isSameRun(one, other) && [...names].every((name) => a[name] === b[name]);
}

/**
 * What a pick means now. A preset that nothing was added to is taken as it is in the configuration or the launch file,
 * which may have changed since; none when it is gone.
 */
export function resolved(pick: Root, candidates: readonly Root[]): Root | undefined {
  if (pick.preset === undefined || pick.args) return pick;
  const known = candidates.find((candidate) => isSameRun(candidate, pick));
  return known && { uri: pick.uri, preset: pick.preset, args: known.args ?? {} };
}

export class Contexts implements vscode.Disposable {
  private readonly changed = new vscode.EventEmitter<void>();
  /** The file that is looked at, its root or arguments changed. */
  readonly onChange = this.changed.event;
  private shown: vscode.TextDocument | undefined;
  private answer: Roots | undefined;
  /** The call that was picked, by file. */
  private readonly instances = new Map<string, string | null>();
  private asked = 0;
  private timer: NodeJS.Timeout | undefined;
  private readonly subscriptions: vscode.Disposable[] = [];

  constructor(
    private readonly server: Server,
    private readonly memory: vscode.Memento,
  ) {
    this.shown = activeDescription();
    server.on(protocol.contextChanged, ({ textDocument, instance }) => {
      this.instances.set(textDocument.uri, instance);
      this.refreshSoon();
    });
    this.subscriptions.push(
      this.changed,
      server.onReady(() => void this.reapply()),
      server.onGone(() => {
        this.instances.clear();
        this.take(undefined);
      }),
      vscode.window.onDidChangeActiveTextEditor(() => this.look()),
      vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
        if (contentChanges.length > 0 && isRobotDescription(document)) this.refreshSoon();
      }),
      vscode.workspace.onDidCloseTextDocument((document) => {
        if (document === this.shown) {
          this.shown = activeDescription();
          void this.refresh();
        }
      }),
    );
  }

  /** The robot description that was looked at last. */
  get document(): vscode.TextDocument | undefined {
    return this.shown;
  }

  /** What the server says about it. */
  get roots(): Roots | undefined {
    return this.answer;
  }

  /** The active root of the file that is looked at. */
  get active(): Root | undefined {
    return this.answer?.active ?? undefined;
  }

  /** The call that the file is looked at in, when one was picked: `leg @ robot.urdf.xacro:41`. */
  get instance(): string | undefined {
    return this.instances.get(this.shown?.uri.toString() ?? "") ?? undefined;
  }

  /** Pick a root, for the file that is looked at and all open files that it reaches; none: automatically. */
  async pick(root: Root | undefined): Promise<void> {
    const previous = this.active;
    const picks = this.picks().filter((pick) => pick.uri !== root?.uri && pick.uri !== previous?.uri);
    await this.memory.update(PICKS, root ? [root, ...picks] : picks);
    for (const document of vscode.workspace.textDocuments.filter(isRobotDescription)) {
      const textDocument = { uri: document.uri.toString() };
      const known = await this.server.ask(protocol.roots, { textDocument });
      const wanted = root && (resolved(root, known?.candidates ?? this.answer?.candidates ?? []) ?? root);
      const reached = root
        ? reaches(known, root) || document === this.shown
        : known?.active?.uri === previous?.uri;
      if (reached) await this.server.askForUser(protocol.setRoot, { root: wanted ?? null, textDocument });
    }
    await this.refresh();
  }

  /** Ask again. */
  async refresh(): Promise<void> {
    clearTimeout(this.timer);
    const document = this.shown;
    const turn = ++this.asked;
    if (!document) {
      this.take(undefined);
      return;
    }
    const textDocument = { uri: document.uri.toString() };
    let answer = await this.server.ask(protocol.roots, { textDocument });
    const pick = answer && this.pickFor(answer);
    if (answer && pick && !sameRoot(pick, answer.active)) {
      await this.server.ask(protocol.setRoot, { root: pick, textDocument });
      answer = await this.server.ask(protocol.roots, { textDocument });
    }
    if (turn === this.asked) this.take(answer);
  }

  dispose(): void {
    clearTimeout(this.timer);
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private picks(): Root[] {
    return this.memory.get<Root[]>(PICKS, []);
  }

  /** What was picked for a file, as it is now. */
  private pickFor(answer: Roots): Root | undefined {
    const pick = this.picks().find((root) => reaches(answer, root));
    return pick && resolved(pick, answer.candidates);
  }

  /** A server that was started knows nothing of what was picked. */
  private async reapply(): Promise<void> {
    for (const document of vscode.workspace.textDocuments.filter(isRobotDescription)) {
      const textDocument = { uri: document.uri.toString() };
      const answer = await this.server.ask(protocol.roots, { textDocument });
      const pick = answer && this.pickFor(answer);
      if (pick && !sameRoot(pick, answer.active)) {
        await this.server.ask(protocol.setRoot, { root: pick, textDocument });
      }
    }
    await this.refresh();
  }

  private look(): void {
    const document = activeDescription();
    if (document && document !== this.shown) {
      this.shown = document;
      void this.refresh();
    }
  }

  private refreshSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.refresh(), 150);
  }

  private take(answer: Roots | undefined): void {
    this.answer = answer;
    this.changed.fire();
  }
}

/** Words for a root in a list. */
export function rootLabel(root: Root): string {
  return root.label ?? baseName(root.uri);
}

/** Whether two roots are the same run of the same file; the values of its arguments may have been set since. */
export function isSameRun(a: Root, b: Root | null | undefined): boolean {
  return a.uri === b?.uri && a.preset === b.preset;
}

function reaches(answer: Roots | undefined, root: Root): boolean {
  return answer?.candidates.some((candidate) => candidate.uri === root.uri) === true;
}

function activeDescription(): vscode.TextDocument | undefined {
  const document = vscode.window.activeTextEditor?.document;
  return document && isRobotDescription(document) ? document : undefined;
}
