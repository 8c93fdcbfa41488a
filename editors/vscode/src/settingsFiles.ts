/**
 * Files beside robots: names of links and joints in YAML, arguments of the robot in launch files, and xacro-lint.toml.
 * These are no languages of the client, so that the server is no formatter of them; what it knows is asked for here.
 */
import * as vscode from "vscode";
import {
  CompletionRequest,
  DefinitionRequest,
  HoverRequest,
  PrepareRenameRequest,
  ReferencesRequest,
  RenameRequest,
} from "vscode-languageclient";
import type { Server } from "./server";

const at = (document: vscode.TextDocument, position: vscode.Position) => ({
  textDocument: { uri: document.uri.toString() },
  position: { line: position.line, character: position.character },
});

const filters = (...patterns: string[]) => patterns.map((pattern) => ({ scheme: "file", pattern }));

const CONFIGURATION = filters("**/{xacro-lint,.xacro-lint}.toml");
const LAUNCH = filters("**/*.launch", "**/*.launch.{py,xml,yaml,yml}", "**/launch/**/*.py");
const WITH_NAMES = [{ scheme: "file", language: "yaml" }, ...filters("**/.setup_assistant"), ...LAUNCH];

export function registerSettingsFiles(server: Server): vscode.Disposable {
  return vscode.Disposable.from(
    vscode.languages.registerHoverProvider([...WITH_NAMES, ...CONFIGURATION], {
      provideHover: async (document, position, token) =>
        server.from?.asHover(await server.ask(HoverRequest.type, at(document, position), token)),
    }),
    vscode.languages.registerDefinitionProvider(WITH_NAMES, {
      provideDefinition: async (document, position, token) =>
        server.from?.asDefinitionResult(await server.ask(DefinitionRequest.type, at(document, position), token)),
    }),
    vscode.languages.registerReferenceProvider(WITH_NAMES, {
      provideReferences: async (document, position, context, token) =>
        server.from?.asReferences(
          await server.ask(ReferencesRequest.type, { ...at(document, position), context }, token),
        ),
    }),
    registerRename(server),
    registerCompletion(server, LAUNCH, [" ", "'", '"', "{"]),
    registerCompletion(server, CONFIGURATION, [" ", "'", '"', "{", "[", ".", "/"]),
  );
}

function registerRename(server: Server): vscode.Disposable {
  return vscode.languages.registerRenameProvider(WITH_NAMES, {
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
  });
}

function registerCompletion(
  server: Server,
  selector: vscode.DocumentSelector,
  triggers: string[],
): vscode.Disposable {
  const provider: vscode.CompletionItemProvider = {
    provideCompletionItems: async (document, position, token) =>
      server.from?.asCompletionResult(
        await server.ask(CompletionRequest.type, at(document, position), token),
        undefined,
        token,
      ),
  };
  return vscode.languages.registerCompletionItemProvider(selector, provider, ...triggers);
}
