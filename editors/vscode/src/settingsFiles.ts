/**
 * Names of links, joints and groups in YAML files beside robots: the parameters of controllers, and settings of MoveIt.
 * YAML is no language of the client, so that the server is no formatter of it; what it knows is asked for here.
 */
import * as vscode from "vscode";
import {
  DefinitionRequest,
  HoverRequest,
  PrepareRenameRequest,
  ReferencesRequest,
  RenameRequest,
} from "vscode-languageclient";
import type { Server } from "./server";

const SETTINGS_FILES: vscode.DocumentSelector = [
  { scheme: "file", language: "yaml" },
  { scheme: "file", pattern: "**/.setup_assistant" },
];

export function registerSettingsFiles(server: Server): vscode.Disposable {
  const at = (document: vscode.TextDocument, position: vscode.Position) => ({
    textDocument: { uri: document.uri.toString() },
    position: { line: position.line, character: position.character },
  });
  const languages = vscode.languages;
  return vscode.Disposable.from(
    languages.registerHoverProvider(SETTINGS_FILES, {
      provideHover: async (document, position, token) =>
        server.from?.asHover(await server.ask(HoverRequest.type, at(document, position), token)),
    }),
    languages.registerDefinitionProvider(SETTINGS_FILES, {
      provideDefinition: async (document, position, token) =>
        server.from?.asDefinitionResult(await server.ask(DefinitionRequest.type, at(document, position), token)),
    }),
    languages.registerReferenceProvider(SETTINGS_FILES, {
      provideReferences: async (document, position, context, token) =>
        server.from?.asReferences(
          await server.ask(ReferencesRequest.type, { ...at(document, position), context }, token),
        ),
    }),
    languages.registerRenameProvider(SETTINGS_FILES, {
      prepareRename: async (document, position, token) => {
        const answer = await server.ask(PrepareRenameRequest.type, at(document, position), token);
        if (!answer || !("placeholder" in answer)) return undefined;
        const range = server.from?.asRange(answer.range);
        return range && { range, placeholder: answer.placeholder };
      },
      provideRenameEdits: async (document, position, newName, token) =>
        server.from?.asWorkspaceEdit(
          await server.askStrictly(RenameRequest.type, { ...at(document, position), newName }, token),
        ),
    }),
  );
}
