/**
 * Commands that the server puts into code lenses. It answers them with data; here they become what the user wants.
 */
import * as vscode from "vscode";
import { toRange } from "./cursorSync";
import type { CommandHandler, Server } from "./server";

interface Argument {
  textDocument?: { uri?: unknown };
  uri?: unknown;
  position?: { line: number; character: number };
}

interface Place {
  uri: string;
  range: { start: { line: number; character: number }; end: { line: number; character: number } };
}

export function serverCommands(server: Server): [string, CommandHandler][] {
  const forFile =
    (command: string): CommandHandler =>
    async ([argument]) => {
      const uri = uriOf(argument);
      if (uri) await vscode.window.showTextDocument(uri, { preserveFocus: false });
      const position = (argument as Argument | undefined)?.position;
      const editor = vscode.window.activeTextEditor;
      if (position && editor) {
        const at = new vscode.Position(position.line, position.character);
        editor.selection = new vscode.Selection(at, at);
      }
      return vscode.commands.executeCommand(command, uri);
    };
  return [
    ["xacro.expand", forFile("xacro.openExpanded")],
    ["xacro.expandAt", forFile("xacro.expandMacro")],
    ["xacro.preview", forFile("xacro.openPreview")],
    [
      "xacro.setArgs",
      async ([argument]) => {
        const uri = uriOf(argument);
        if (uri) await vscode.window.showTextDocument(uri, { preserveFocus: false });
        const { name, values } = (argument ?? {}) as { name?: unknown; values?: unknown };
        return vscode.commands.executeCommand("xacro.pickArguments", uri, name, values);
      },
    ],
    [
      "xacro.showReferences",
      async (args, next) => {
        const answer = await next();
        const [argument] = args as [Argument | undefined];
        const uri = uriOf(argument);
        if (!uri || !argument?.position || !Array.isArray(answer)) return undefined;
        const places = (answer as Place[]).map(
          (place) => new vscode.Location(vscode.Uri.parse(place.uri), toRange(place.range)),
        );
        const { line, character } = argument.position;
        server.output.debug(`${places.length} calls`);
        return vscode.commands.executeCommand(
          "editor.action.showReferences",
          uri,
          new vscode.Position(line, character),
          places,
        );
      },
    ],
  ];
}

function uriOf(argument: unknown): vscode.Uri | undefined {
  const { textDocument, uri } = (argument ?? {}) as Argument;
  const text = textDocument?.uri ?? uri;
  return typeof text === "string" ? vscode.Uri.parse(text) : undefined;
}
