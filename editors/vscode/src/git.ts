/**
 * Texts of the last commit, from the Git extension that comes with the editor.
 */
import * as vscode from "vscode";

/** The part of the Git extension's interface that is used here. */
interface Repository {
  readonly rootUri: vscode.Uri;
  diffWithHEAD(): Promise<{ uri: vscode.Uri; originalUri: vscode.Uri }[]>;
  show(ref: string, path: string): Promise<string>;
}

interface GitExtension {
  getAPI(version: 1): { getRepository(uri: vscode.Uri): Repository | null };
}

/** What can change a robot. */
const FILES = /\.(xacro|urdf|srdf|sdf|xml|ya?ml)$/i;

/**
 * By URI, the texts that files had in the last commit, of those that differ from it now, unsaved ones too.
 * Undefined: the file is in no repository, or there is no Git.
 */
export async function committedTexts(file: vscode.Uri): Promise<Record<string, string> | undefined> {
  const extension = vscode.extensions.getExtension<GitExtension>("vscode.git");
  if (!extension) return undefined;
  const repository = await extension.activate().then(
    (git) => git.getAPI(1).getRepository(file),
    () => null,
  );
  if (!repository) return undefined;
  const changed = await repository.diffWithHEAD();
  const root = repository.rootUri.path.replace(/\/?$/, "/");
  const unsaved = vscode.workspace.textDocuments.filter(({ isDirty, uri }) => isDirty && uri.path.startsWith(root));
  const uris = new Map<string, vscode.Uri>();
  for (const uri of [...changed.map(({ originalUri }) => originalUri), ...unsaved.map(({ uri }) => uri)]) {
    if (uri.scheme === "file" && FILES.test(uri.path)) uris.set(uri.toString(), uri);
  }
  const texts: Record<string, string> = {};
  await Promise.all(
    [...uris].map(async ([name, uri]) => {
      // a file that is new since has no earlier text
      const text = await repository.show("HEAD", uri.fsPath).catch(() => undefined);
      if (text !== undefined) texts[name] = text;
    }),
  );
  return texts;
}
