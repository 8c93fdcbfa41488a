/**
 * Choosing a root, its arguments, and the call that a macro is looked at in.
 */
import * as vscode from "vscode";
import { argumentsText, isSameRun, rootLabel } from "./contexts";
import type { Contexts } from "./contexts";
import { callText } from "./expandedText";
import { isRobotDescription } from "./languages";
import * as protocol from "./protocol";
import type { Argument, Root, Roots } from "./protocol";
import type { Server } from "./server";

const PRESETS = "xacro.presets";
/** Calls of a macro that are listed, at most. */
const MOST_INSTANCES = 200;

/** Sets of arguments with names, by root. */
type Presets = Record<string, Record<string, Record<string, string>>>;

interface Choice extends vscode.QuickPickItem {
  run?: () => Promise<void>;
}

export class Pickers {
  constructor(
    private readonly server: Server,
    private readonly contexts: Contexts,
    private readonly memory: vscode.Memento,
  ) {}

  async pickRoot(): Promise<void> {
    if (!this.ready()) return;
    await this.contexts.refresh();
    const { roots, active } = this.contexts;
    const choices: Choice[] = (roots?.candidates ?? []).map((candidate) => ({
      label: `${isSameRun(candidate, active) ? "$(check)" : "$(blank)"} ${rootLabel(candidate)}`,
      description: [candidate.preset, argumentsText(candidate.args)].filter(Boolean).join(" · "),
      detail: `$(blank) ${vscode.workspace.asRelativePath(vscode.Uri.parse(candidate.uri))}`,
      run: () => this.contexts.pick(asPicked(candidate)),
    }));
    choices.push(
      { label: "", kind: vscode.QuickPickItemKind.Separator },
      { label: "$(sync) Automatic", description: "the nearest root", run: () => this.contexts.pick(undefined) },
      { label: "$(folder-opened) Another file…", run: () => this.pickFile() },
    );
    await choose(choices, "Robot for this file", "Select Root");
  }

  async pickArguments(): Promise<void> {
    if (!this.ready()) return;
    await this.contexts.refresh();
    const { roots, active } = this.contexts;
    if (!active || !roots) {
      void vscode.window.showInformationMessage("No root includes this file, so there are no arguments to set.");
      return;
    }
    const presets = Object.entries(this.presets()[active.uri] ?? {});
    const choices: Choice[] = [
      ...this.presetChoices(active, roots),
      ...presets.map(([name, args]) => ({
        label: `$(bookmark) ${name}`,
        description: argumentsText(args),
        run: () => this.contexts.pick({ uri: active.uri, args }),
      })),
    ];
    if (choices.length > 0) {
      choices.unshift({ label: "presets", kind: vscode.QuickPickItemKind.Separator });
      choices.push({ label: "arguments", kind: vscode.QuickPickItemKind.Separator });
    }
    choices.push(
      ...roots.args.map((argument) => ({
        label: argument.name,
        description: argument.value ?? "no value",
        ...(argument.doc === undefined ? {} : { detail: argument.doc }),
        run: () => this.setArgument(active, argument),
      })),
    );
    choices.push({ label: "", kind: vscode.QuickPickItemKind.Separator });
    if (Object.keys(active.args ?? {}).length > 0) {
      choices.push(
        { label: "$(add) Save as preset…", run: () => this.savePreset(active) },
        {
          label: "$(discard) Defaults of the file",
          run: () => this.contexts.pick({ uri: active.uri, args: {} }),
        },
      );
    }
    if (presets.length > 0) {
      choices.push({ label: "$(trash) Delete preset…", run: () => this.deletePreset(active) });
    }
    await choose(choices, `Arguments of ${rootLabel(active)}`, "Set Arguments");
  }

  /** The runs of a robot that the configuration and launch files name, the default first; none if it has one run. */
  private presetChoices(active: Root, { candidates }: Roots): Choice[] {
    const runs = candidates.filter(({ uri }) => uri === active.uri);
    if (runs.every(({ preset }) => preset === undefined)) return [];
    const sorted = [...runs].sort((a, b) => Number(a.preset !== undefined) - Number(b.preset !== undefined));
    return sorted.map((run) => ({
      label: `${isSameRun(run, active) ? "$(check)" : "$(blank)"} ${run.preset ?? "default"}`,
      description: argumentsText(run.args) || "arguments of the file",
      run: () => this.contexts.pick(asPicked(run)),
    }));
  }

  /** Ask for the value of one argument; `values` are known to be good ones. */
  async pickArgument(name: string, values: unknown): Promise<void> {
    if (!this.ready()) return;
    await this.contexts.refresh();
    const { roots, active } = this.contexts;
    if (!active) return this.pickArguments();
    const argument = roots?.args.find((known) => known.name === name) ?? { name };
    const known = Array.isArray(values) ? values.filter((value) => typeof value === "string") : [];
    await this.setArgument(active, argument, known);
  }

  async pickInstance(): Promise<void> {
    const editor = vscode.window.activeTextEditor;
    if (!editor || !isRobotDescription(editor.document)) return;
    const place = (await enclosingMacro(editor)) ?? editor.selection.active;
    const at = { textDocument: { uri: editor.document.uri.toString() }, position: plain(place) };
    const first = await this.server.askForUser(protocol.expandAt, { ...at, instance: 0 });
    if (first === undefined) return;
    if (first?.kind !== "macro" || first.instances === 0) {
      void vscode.window.showInformationMessage("Put the cursor in a called macro, or on a macro call.");
      return;
    }
    const set = async (instance: number | null): Promise<void> => {
      await this.server.askForUser(protocol.setInstance, { ...at, instance });
      await this.contexts.refresh();
    };
    const choices: Choice[] = [
      { label: "$(list-unordered) All calls", run: () => set(null) },
      { label: "", kind: vscode.QuickPickItemKind.Separator },
    ];
    for (let instance = 0; instance < Math.min(first.instances, MOST_INSTANCES); instance++) {
      const one = instance === 0 ? first : await this.server.ask(protocol.expandAt, { ...at, instance });
      if (!one) continue;
      const description = `${instance + 1} of ${first.instances}`;
      choices.push({ label: callText(one.title), description, run: () => set(instance) });
    }
    await choose(choices, "Macro call for values", "Select Instance");
  }

  private ready(): boolean {
    if (!this.server.isReady()) return false;
    if (!this.contexts.document) {
      void vscode.window.showInformationMessage("Open a xacro or URDF file first.");
      return false;
    }
    return true;
  }

  private async pickFile(): Promise<void> {
    const picked = await vscode.window.showOpenDialog({
      filters: { "Robot descriptions": ["xacro", "urdf"] },
      title: "Select Root",
      canSelectMany: false,
    });
    const file = picked?.[0];
    if (file) await this.contexts.pick({ uri: file.toString() });
  }

  private async setArgument(root: Root, argument: Argument, known: readonly string[] = []): Promise<void> {
    const value = await askValue(argument, known);
    if (value === undefined) return;
    const args = { ...root.args, [argument.name]: value };
    await this.contexts.pick({ ...asPicked(root), args });
  }

  private presets(): Presets {
    return this.memory.get<Presets>(PRESETS, {});
  }

  private async savePreset(root: Root): Promise<void> {
    const name = await vscode.window.showInputBox({
      title: "Save as Preset",
      prompt: argumentsText(root.args),
      placeHolder: "Name of the preset",
    });
    if (name === undefined || name.trim() === "") return;
    const all = this.presets();
    const own = { ...all[root.uri], [name.trim()]: root.args ?? {} };
    await this.memory.update(PRESETS, { ...all, [root.uri]: own });
  }

  private async deletePreset(root: Root): Promise<void> {
    const all = this.presets();
    const own = all[root.uri] ?? {};
    const name = await vscode.window.showQuickPick(Object.keys(own), { title: "Delete Preset" });
    if (name === undefined) return;
    const left = Object.fromEntries(Object.entries(own).filter(([key]) => key !== name));
    await this.memory.update(PRESETS, { ...all, [root.uri]: left });
  }
}

/** A position as the protocol has it. */
export function plain(position: vscode.Position): { line: number; character: number } {
  return { line: position.line, character: position.character };
}

/** The macro around the cursor, where its element begins. */
async function enclosingMacro(editor: vscode.TextEditor): Promise<vscode.Position | undefined> {
  const symbols = await vscode.commands.executeCommand<vscode.DocumentSymbol[] | undefined>(
    "vscode.executeDocumentSymbolProvider",
    editor.document.uri,
  );
  let found: vscode.Position | undefined;
  const walk = (list: readonly vscode.DocumentSymbol[]): void => {
    for (const symbol of list.filter(({ range }) => range.contains(editor.selection.active))) {
      // behind the `<`, where the tag's name is
      if (symbol.kind === vscode.SymbolKind.Function) found = symbol.range.start.translate(0, 1);
      walk(symbol.children);
    }
  };
  walk(symbols ?? []);
  return found;
}

/** A run as it is remembered: a preset by its name alone, since its arguments may change. */
function asPicked({ uri, args, preset }: Root): Root {
  if (preset !== undefined) return { uri, preset };
  return { uri, args: args ?? {} };
}

async function choose(choices: Choice[], placeHolder: string, title: string): Promise<void> {
  const picked = await vscode.window.showQuickPick(choices, {
    placeHolder,
    title,
    matchOnDescription: true,
    matchOnDetail: true,
  });
  await picked?.run?.();
}

async function askValue(argument: Argument, known: readonly string[]): Promise<string | undefined> {
  const value = argument.value ?? "";
  const truths = [
    ["true", "false"],
    ["True", "False"],
  ].find((pair) => pair.includes(value));
  const values = [...new Set([...known, ...(truths ?? [])])].filter((one) => one !== value);
  if (values.length > 0) {
    const other = "$(edit) Another value…";
    const now = value === "" ? [] : [value];
    const answer = await vscode.window.showQuickPick([...values, ...now, other], {
      title: argument.name,
      placeHolder: value === "" ? "no value" : `now ${value}`,
    });
    if (answer !== other) return answer;
  }
  return vscode.window.showInputBox({ title: argument.name, value, prompt: argument.doc ?? "New value" });
}
