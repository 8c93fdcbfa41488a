// Colors follow the editor where it says what they are, else the system.

const CSS = `
:root { color-scheme: light dark;
  --bg: var(--vscode-editor-background, #f4f5f7); --fg: var(--vscode-editor-foreground, #1d2430);
  --panel: var(--vscode-sideBar-background, #ffffff); --line: var(--vscode-panel-border, #d5d9e0);
  --muted: var(--vscode-descriptionForeground, #616b7a); --accent: var(--vscode-focusBorder, #1f6feb);
  --input: var(--vscode-input-background, #ffffff); --hover: var(--vscode-list-hoverBackground, #eef1f5);
  --chosen: var(--vscode-list-activeSelectionBackground, #d7e6fd);
  --chosen-fg: var(--vscode-list-activeSelectionForeground, #10243f);
  --error: var(--vscode-editorError-foreground, #c62828); --error-bg: var(--vscode-inputValidation-errorBackground, #fdecea);
  --grid: #c3c9d2; --grid-strong: #98a2b0; }
@media (prefers-color-scheme: dark) { :root:not(.light) {
  --bg: var(--vscode-editor-background, #1b1e24); --fg: var(--vscode-editor-foreground, #e3e7ee);
  --panel: var(--vscode-sideBar-background, #23272f); --line: var(--vscode-panel-border, #363c47);
  --muted: var(--vscode-descriptionForeground, #9aa4b2); --accent: var(--vscode-focusBorder, #58a6ff);
  --input: var(--vscode-input-background, #1b1e24); --hover: var(--vscode-list-hoverBackground, #2c323c);
  --chosen: var(--vscode-list-activeSelectionBackground, #1f3f69);
  --chosen-fg: var(--vscode-list-activeSelectionForeground, #eaf2ff);
  --error: var(--vscode-editorError-foreground, #ff8a80); --error-bg: var(--vscode-inputValidation-errorBackground, #4a2323);
  --grid: #3a414c; --grid-strong: #59626f; } }
:root.dark, body.vscode-dark, body.vscode-high-contrast {
  --bg: var(--vscode-editor-background, #1b1e24); --fg: var(--vscode-editor-foreground, #e3e7ee);
  --panel: var(--vscode-sideBar-background, #23272f); --line: var(--vscode-panel-border, #363c47);
  --muted: var(--vscode-descriptionForeground, #9aa4b2); --accent: var(--vscode-focusBorder, #58a6ff);
  --input: var(--vscode-input-background, #1b1e24); --hover: var(--vscode-list-hoverBackground, #2c323c);
  --chosen: var(--vscode-list-activeSelectionBackground, #1f3f69);
  --chosen-fg: var(--vscode-list-activeSelectionForeground, #eaf2ff);
  --error: var(--vscode-editorError-foreground, #ff8a80); --error-bg: var(--vscode-inputValidation-errorBackground, #4a2323);
  --grid: #3a414c; --grid-strong: #59626f; }
body.vscode-light { --grid: #c3c9d2; --grid-strong: #98a2b0; }
:root.dark { color-scheme: dark; } :root.light { color-scheme: light; }
* { box-sizing: border-box; }
html, body { height: 100%; margin: 0; padding: 0 !important; overflow: hidden; background: var(--bg); color: var(--fg);
  font: 13px/1.4 var(--vscode-font-family, system-ui, -apple-system, "Segoe UI", sans-serif); }
#app { display: grid; height: 100%; grid-template: auto auto minmax(0, 1fr) auto / auto minmax(0, 1fr) auto; }
button, input, select { font: inherit; color: inherit; }
button { background: transparent; border: 1px solid transparent; border-radius: 5px; padding: 2px 8px; min-height: 26px; cursor: pointer; white-space: nowrap; }
button:hover { background: var(--hover); }
button[aria-pressed=true] { background: var(--chosen); color: var(--chosen-fg); }
button:focus-visible, input:focus-visible, select:focus-visible, [tabindex]:focus-visible, canvas:focus-visible {
  outline: 2px solid var(--accent); outline-offset: -1px; }
input[type=text], input[type=number], input[type=search], select { background: var(--input); border: 1px solid var(--line);
  border-radius: 5px; padding: 2px 6px; min-height: 26px; min-width: 0; }
input[type=range] { accent-color: var(--accent); min-width: 0; }
.bar { grid-column: 1 / 4; max-height: 60vh; overflow: auto; display: flex; flex-wrap: wrap; gap: 4px 6px; align-items: center; padding: 5px 8px;
  background: var(--panel); border-bottom: 1px solid var(--line); }
.bar .name { font-weight: 600; margin: 0 6px 0 2px; max-width: 22em; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.bar .tools { display: flex; gap: 2px; margin-left: auto; } .bar .tools button { padding: 2px 7px; }
.bar select { max-width: 13em; }
.bar label:not([hidden]) { display: flex; gap: 5px; align-items: center; color: var(--muted); }
.bar .args { display: flex; flex-wrap: wrap; gap: 4px 8px; max-height: 62px; overflow: auto; }
.bar .args.many { order: 1; flex-basis: 100%; max-height: none; overflow: visible; display: grid; grid-template-columns: repeat(auto-fill, minmax(195px, 1fr)); gap: 3px 12px; }
.bar .args.many label { min-width: 0; } .bar .args.many label span { flex: 1; } .bar .args.many input { width: 7.5em; flex: none; }
.bar .args label span { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.bar .args.many label span { white-space: normal; overflow-wrap: anywhere; line-height: 1.15; }
.bar .args:empty { display: none; }
.bar .args input { width: 8em; }
#app > .panel, #app > .view { grid-row: 3; } #app > .panel.left { grid-column: 1; } #app > .panel.right { grid-column: 3; }
.panel { background: var(--panel); overflow: hidden; display: flex; flex-direction: column; width: 260px; min-height: 0; }
.panel.left { resize: horizontal; min-width: 150px; max-width: 50vw; border-right: 1px solid var(--line); } .panel.right { border-left: 1px solid var(--line); width: 330px; }
.panel[hidden] { display: none; }
.panel header { display: flex; gap: 4px; align-items: center; padding: 6px 8px; flex-wrap: wrap; }
.panel header b { flex: 1; font-weight: 600; } .panel header input { flex: 1; width: 100%; }
.scroll { overflow: auto; flex: 1; padding: 0 4px 8px; min-height: 0; }
.view { position: relative; min-width: 0; min-height: 0; overflow: hidden; grid-column: 2; }
.view canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; touch-action: none; outline-offset: -3px !important; }
.labels { position: absolute; inset: 0; overflow: hidden; pointer-events: none; }
.labels span { position: absolute; left: 0; top: 0; white-space: nowrap; font-size: 11px; padding: 0 4px; border-radius: 3px;
  background: color-mix(in srgb, var(--panel) 82%, transparent); color: var(--fg); will-change: transform; }
.labels .measure { font-weight: 600; background: var(--accent); color: #fff; } .labels .missing { background: #b0108f; color: #fff; }
.labels .undrawn { background: #7a5200; color: #fff; }
.details { border-top: 1px solid var(--line); padding: 2px 8px 8px; overflow: auto; max-height: 50%; flex: none; }
.details[hidden] { display: none; } .details header { padding: 4px 0; } .details header b { overflow: hidden; text-overflow: ellipsis; }
.details header button { color: var(--accent); text-decoration: underline; padding: 0 4px; min-height: 22px; }
.details dl { display: grid; grid-template-columns: auto minmax(0, 1fr); gap: 1px 8px; margin: 0; font-size: 12px; }
.details dt { color: var(--muted); max-width: 7.5em; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.details dd { margin: 0; white-space: pre-line; font-variant-numeric: tabular-nums; user-select: text; }
.details label { display: flex; gap: 8px; align-items: center; color: var(--muted); margin-top: 4px; } .details label input { flex: 1; }
.programs { grid-column: 1 / 4; grid-row: 4; max-height: 38vh; overflow: auto; background: var(--panel); border-top: 1px solid var(--line); padding: 6px 10px; }
.programs[hidden] { display: none; } .programs p { margin: 2px 0; color: var(--muted); }
.programs dl { display: grid; grid-template-columns: auto minmax(0, 1fr); gap: 1px 10px; margin: 0 0 6px; }
.programs dt { color: var(--muted); } .programs dd { margin: 0; }
.programs table { border-collapse: collapse; width: 100%; } .programs th { text-align: left; font-weight: 600; white-space: nowrap; }
.programs th, .programs td { padding: 3px 12px 3px 0; vertical-align: top; border-top: 1px solid var(--line); user-select: text; }
.programs small { display: block; color: var(--muted); } .programs .rejected { color: var(--error); }
.programs td button { color: var(--accent); text-decoration: underline; padding: 0; min-height: 20px; display: block; }
.titles { position: absolute; inset: 0; pointer-events: none; }
.titles .title { position: absolute; top: 0; bottom: 0; padding: 8px 12px; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.titles .title + .title { border-left: 1px solid var(--line); }
.row, .head { user-select: none; }
.row { display: flex; align-items: center; gap: 6px; padding: 1px 4px; border-radius: 4px; cursor: default; min-height: 24px; }
.row:hover { background: var(--hover); } .row[aria-selected=true] { background: var(--chosen); color: var(--chosen-fg); }
.row .text { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; flex: 1; }
.row small { color: var(--muted); margin-left: 6px; } .row[aria-selected=true] small { color: inherit; opacity: .8; }
.row button { min-height: 20px; padding: 0 5px; opacity: .55; } .row button:hover, .row button:focus-visible { opacity: 1; }
.row.hidden-link .text { opacity: .45; text-decoration: line-through; }
.joint { padding: 5px 6px 6px; border-bottom: 1px solid var(--line); } .joint[data-on=true] { background: var(--hover); }
.joint .head, .joint .body { display: flex; gap: 6px; align-items: center; }
.joint .head { cursor: pointer; } .joint .head .text { flex: 1; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.joint small { color: var(--muted); white-space: nowrap; } .joint .body input[type=range] { flex: 1; }
.joint .body input[type=number] { width: 70px; text-align: right; } .joint .body .unit { color: var(--muted); width: 1.6em; }
.joint .body .other { width: 5.2em; text-align: right; font-variant-numeric: tabular-nums; }
.joint .head button { min-height: 20px; padding: 0 6px; }
.wheel { flex: 1; height: 20px; border: 1px solid var(--line); border-radius: 10px; cursor: ew-resize; touch-action: none;
  background-image: repeating-linear-gradient(90deg, var(--muted) 0 1px, transparent 1px 12px); background-position-x: 0; opacity: .85; }
.banner { grid-column: 1 / 4; background: var(--error-bg); color: var(--fg); border-bottom: 1px solid var(--error);
  padding: 5px 10px; max-height: 30vh; overflow: auto; }
.banner summary { cursor: pointer; }
.banner[hidden], .menu[hidden], .tip[hidden], .help[hidden] { display: none; }
.banner b { color: var(--error); } .banner ul { margin: 4px 0 0; padding: 0; list-style: none; }
.banner li button { width: 100%; text-align: left; white-space: normal; } .banner li small { color: var(--muted); margin-left: 8px; }
.status { position: absolute; left: 8px; bottom: 8px; color: var(--muted); font-size: 11px; pointer-events: none;
  background: color-mix(in srgb, var(--bg) 70%, transparent); padding: 1px 6px; border-radius: 4px; }
.notice { position: absolute; left: 50%; bottom: 34px; transform: translateX(-50%); max-width: 90%; padding: 6px 12px; border-radius: 6px;
  background: var(--panel); border: 1px solid var(--line); box-shadow: 0 4px 18px rgb(0 0 0 / .2); z-index: 5; }
.notice[hidden] { display: none; } .notice input { width: 100%; margin-top: 4px; }
.menu, .tip, .help { position: absolute; background: var(--panel); border: 1px solid var(--line); border-radius: 6px; z-index: 5;
  box-shadow: 0 4px 18px rgb(0 0 0 / .2); }
.menu { padding: 4px; display: flex; flex-direction: column; min-width: 170px; } .menu button { text-align: left; }
.menu label { display: flex; gap: 8px; padding: 3px 8px; align-items: center; border-radius: 4px; } .menu label:hover { background: var(--hover); }
.menu kbd, .help kbd { margin-left: auto; color: var(--muted); font: 11px ui-monospace, monospace; }
.tip { padding: 5px 9px; pointer-events: none; max-width: 320px; } .tip small { color: var(--muted); display: block; }
.help { right: 8px; bottom: 8px; padding: 10px 14px; display: grid; grid-template-columns: auto auto; gap: 2px 18px; }
.empty { position: absolute; inset: 0; display: grid; place-content: center; color: var(--muted); text-align: center; pointer-events: none; }
.empty[hidden] { display: none; }
@media (max-width: 760px) { .panel { width: 200px; } .panel.right { width: 230px; } .panel.right header b, .joint .body .other { display: none; }
  .bar select { max-width: 10em; } .bar .tools { gap: 0; } .bar .tools button { padding: 2px 6px; } }
`;

export function applyStyle(): void {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(CSS);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
}

/** A color of the theme as it is now. */
export function themeColor(name: string): string {
  return getComputedStyle(document.body).getPropertyValue(name).trim() || '#808080';
}
