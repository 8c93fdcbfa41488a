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
import { fileSchemes } from "./schemes";
import type { Server } from "./server";

const at = (document: vscode.TextDocument, position: vscode.Position) => ({
  textDocument: { uri: document.uri.toString() },
  position: { line: position.line, character: position.character },
});

const filters = (...patterns: string[]) =>
  fileSchemes().flatMap((scheme) => patterns.map((pattern) => ({ scheme, pattern })));

export function registerSettingsFiles(server: Server): vscode.Disposable {
  const configuration = filters("**/{xacro-lint,.xacro-lint}.toml");
  const launch = filters("**/*.launch", "**/*.launch.{py,xml,yaml,yml}", "**/launch/**/*.py");
  const yaml = fileSchemes().map((scheme) => ({ scheme, language: "yaml" }));
  const withNames = [...yaml, ...filters("**/.setup_assistant"), ...launch];
  return vscode.Disposable.from(
    vscode.languages.registerHoverProvider([...withNames, ...configuration], {
      provideHover: async (document, position, token) =>
        server.from?.asHover(await server.ask(HoverRequest.type, at(document, position), token)),
    }),
    vscode.languages.registerDefinitionProvider(withNames, {
      provideDefinition: async (document, position, token) =>
        server.from?.asDefinitionResult(await server.ask(DefinitionRequest.type, at(document, position), token)),
    }),
    vscode.languages.registerReferenceProvider(withNames, {
      provideReferences: async (document, position, context, token) =>
        server.from?.asReferences(
          await server.ask(ReferencesRequest.type, { ...at(document, position), context }, token),
        ),
    }),
    registerRename(server, withNames),
    registerCompletion(server, launch, [" ", "'", '"', "{"]),
    registerCompletion(server, configuration, [" ", "'", '"', "{", "[", ".", "/"]),
  );
}

function registerRename(server: Server, selector: vscode.DocumentSelector): vscode.Disposable {
  return vscode.languages.registerRenameProvider(selector, {
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
