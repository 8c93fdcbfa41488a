/**
 * Which URIs are those of files: on the Web, those of the workspace's own file system too.
 */
const files = new Set(["file"]);

/** Takes URIs of these schemes as those of files, as those of workspace folders are. */
export function takeSchemesAsFiles(schemes: readonly string[]): void {
  for (const scheme of schemes) files.add(scheme);
}

export function fileSchemes(): string[] {
  return [...files];
}

/** Whether a URI is that of a file; other schemes could name commands. */
export function isFileUri(uri: string): boolean {
  return isFileScheme(uri.slice(0, uri.indexOf(":")));
}

export function isFileScheme(scheme: string): boolean {
  return files.has(scheme);
}
