import * as vscode from "vscode";

/** The languages of robot descriptions. */
export const LANGUAGES: readonly string[] = ["xacro", "urdf"];

/** The scheme of expanded documents. */
export const EXPANDED_SCHEME = "xacro-expanded";

/** Whether a document is a robot description that the server works on. */
export function isRobotDescription(document: vscode.TextDocument): boolean {
  return document.uri.scheme === "file" && LANGUAGES.includes(document.languageId);
}

/** The last part of a path or URI. */
export function baseName(uri: string): string {
  const path = uri.split(/[?#]/, 1)[0] ?? uri;
  const name = path.slice(path.lastIndexOf("/") + 1);
  try {
    return decodeURIComponent(name);
  } catch {
    return name;
  }
}
