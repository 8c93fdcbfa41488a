/**
 * The page around a script in a webview: nothing from anywhere but the extension, no script but the one named.
 */
import * as vscode from "vscode";

export interface Page {
  title: string;
  /** Path below the extension. */
  script: string[];
  style: string[];
  /** For the script, as JSON in the element `data`. */
  data?: unknown;
  body?: string;
  isModule?: boolean;
}

export function webviewPage(webview: vscode.Webview, extensionUri: vscode.Uri, page: Page): string {
  const nonce = btoa(String.fromCharCode(...crypto.getRandomValues(new Uint8Array(16))));
  const uri = (parts: string[]): string =>
    webview.asWebviewUri(vscode.Uri.joinPath(extensionUri, ...parts)).toString();
  const policy = [
    "default-src 'none'",
    `script-src 'nonce-${nonce}'`,
    `style-src ${webview.cspSource} 'unsafe-inline'`,
    "img-src blob: data:",
    "connect-src blob: data:",
    "worker-src blob:",
    `font-src ${webview.cspSource} data:`,
  ].join("; ");
  // `<` must not end the element that the data stands in
  const data = JSON.stringify(page.data ?? null).replaceAll("<", "\\u003c");
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(page.title)}</title>
<link rel="stylesheet" href="${uri(page.style)}">
</head>
<body>
${page.body ?? ""}
<script type="application/json" id="data" nonce="${nonce}">${data}</script>
<script nonce="${nonce}"${page.isModule === true ? ' type="module"' : ""} src="${uri(page.script)}"></script>
</body>
</html>`;
}

function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
}
