import type * as vscode from "vscode";
import { isFileScheme } from "./schemes";

/** The languages of robot descriptions. */
export const LANGUAGES: readonly string[] = ["xacro", "urdf"];

/** The scheme of expanded documents. */
export const EXPANDED_SCHEME = "xacro-expanded";

/** Whether a document is a robot description that the server works on. */
export function isRobotDescription(document: vscode.TextDocument): boolean {
  return isFileScheme(document.uri.scheme) && LANGUAGES.includes(document.languageId);
}

/** Whether a document is another file that robots are made from. */
export function isCompanion(document: vscode.TextDocument): boolean {
  if (!isFileScheme(document.uri.scheme)) return false;
  return document.languageId === "yaml" || isCompanionName(document.uri.path) || isLaunchName(document.uri.path);
}

/** Whether a file may call robots with arguments. */
export function isLaunchName(path: string): boolean {
  return /\.launch(\.(py|xml|ya?ml))?$|\/launch\/.*\.py$/i.test(path);
}

/** Whether a file may hold settings of a robot, such as its controllers: the server has findings for these. */
export function isSettingsName(path: string): boolean {
  return /\.ya?ml$/i.test(path) || baseName(path) === ".setup_assistant";
}

/** Whether a file has the name of such a file. */
export function isCompanionName(path: string): boolean {
  return isSettingsName(path) || ["package.xml", "xacro-lint.toml", ".xacro-lint.toml"].includes(baseName(path));
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
