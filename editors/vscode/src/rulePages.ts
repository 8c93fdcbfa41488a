/**
 * The pages of rules as read-only documents: where a click on the code of a problem leads.
 */
import * as vscode from "vscode";

const SCHEME = "xacro-rule";

export function registerRulePages(): vscode.Disposable {
  return vscode.workspace.registerTextDocumentContentProvider(SCHEME, {
    provideTextDocumentContent: async (uri) => {
      const rule = uri.path.replace(/^\/|\.md$/g, "");
      const page = await vscode.commands.executeCommand<string | undefined>("xacro.explain", { rule });
      return page ?? `There is no page about the rule \`${rule}\`.\n`;
    },
  });
}

/** Where the page of a rule is. */
export function rulePage(rule: string): vscode.Uri {
  return vscode.Uri.from({ scheme: SCHEME, path: `/${rule}.md` });
}

/** Lets the code of a diagnostic lead to the page of its rule, when the server names no address. */
export function withPage(diagnostic: vscode.Diagnostic): vscode.Diagnostic {
  if (diagnostic.source === "xacro" && typeof diagnostic.code === "string") {
    diagnostic.code = { value: diagnostic.code, target: rulePage(diagnostic.code) };
  }
  return diagnostic;
}
