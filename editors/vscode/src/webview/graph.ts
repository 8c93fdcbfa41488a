/** Draws the include graph. Runs in a webview. */
import { layout } from "./layout";
import type { Graph, GraphNode } from "../includeGraph";

declare function acquireVsCodeApi(): { postMessage(message: unknown): void };

const SVG = "http://www.w3.org/2000/svg";
const BOX = { width: 230, height: 46, gapX: 70, gapY: 18, margin: 20 };

const editor = acquireVsCodeApi();
const graph = JSON.parse(document.getElementById("data")?.textContent ?? "null") as Graph;

function make<K extends keyof SVGElementTagNameMap>(
  name: K,
  attributes: Record<string, string | number>,
  text?: string,
): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  if (text !== undefined) element.textContent = text;
  return element;
}

function cut(text: string, most: number): string {
  return text.length > most ? `…${text.slice(text.length - most + 1)}` : text;
}

function box(node: GraphNode, x: number, y: number): SVGGElement {
  const kinds = ["node", node.missing ? "missing" : "", node.beside ? "beside" : ""].filter(Boolean).join(" ");
  const group = make("g", { transform: `translate(${x} ${y})`, class: kinds });
  const title = node.beside ? `${node.label} (${node.beside})` : node.label;
  group.append(
    make("title", {}, `${title}\n${node.detail}`),
    make("rect", { width: BOX.width, height: BOX.height, rx: 5 }),
    make("text", { x: 12, y: 20, class: "name" }, cut(title, 30)),
    make("text", { x: 12, y: 36, class: "detail" }, cut(node.detail, 38)),
  );
  if (!node.missing) {
    const open = (): void => editor.postMessage({ type: "open", uri: node.id });
    group.setAttribute("tabindex", "0");
    group.setAttribute("role", "link");
    group.addEventListener("click", open);
    group.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") open();
    });
  }
  return group;
}

function draw(): void {
  const places = layout(
    graph.nodes.map(({ id }) => id),
    graph.edges,
  );
  const at = (id: string): { x: number; y: number } => {
    const { column, row } = places.get(id) ?? { column: 0, row: 0 };
    return {
      x: BOX.margin + column * (BOX.width + BOX.gapX),
      y: BOX.margin + row * (BOX.height + BOX.gapY),
    };
  };
  const all = graph.nodes.map(({ id }) => at(id));
  const width = Math.max(...all.map(({ x }) => x)) + BOX.width + BOX.margin;
  const height = Math.max(...all.map(({ y }) => y)) + BOX.height + BOX.margin;
  const picture = make("svg", { viewBox: `0 0 ${width} ${height}`, role: "group" });
  const beside = new Set(graph.nodes.filter((node) => node.beside).map(({ id }) => id));
  for (const [from, to] of graph.edges) {
    const [a, b] = [at(from), at(to)];
    const [x1, y1, x2, y2] = [a.x + BOX.width, a.y + BOX.height / 2, b.x, b.y + BOX.height / 2];
    const bend = Math.max(30, Math.abs(x2 - x1) / 2);
    const path = `M${x1} ${y1} C${x1 + bend} ${y1} ${x2 - bend} ${y2} ${x2 - 5} ${y2}`;
    const kind = beside.has(to) ? "edge beside" : "edge";
    picture.append(make("path", { d: path, class: kind }), make("path", { d: `M${x2} ${y2} l-7 -4 v8 z`, class: "tip" }));
  }
  for (const node of graph.nodes) {
    const { x, y } = at(node.id);
    picture.append(box(node, x, y));
  }
  const frame = document.createElement("div");
  frame.className = "frame";
  frame.append(picture);
  document.body.append(zoomBar(frame, picture, { width, height }), frame);
}

/** Buttons and Ctrl+wheel to zoom; first, and with "Fit", the whole graph is seen. */
function zoomBar(frame: HTMLElement, picture: SVGSVGElement, size: { width: number; height: number }): HTMLElement {
  let scale = 1;
  let fitted = true;
  const set = (wanted: number): void => {
    scale = Math.min(4, Math.max(0.05, wanted));
    picture.setAttribute("width", String(size.width * scale));
    picture.setAttribute("height", String(size.height * scale));
  };
  const fit = (): void => {
    fitted = true;
    // names in a small graph stay as large as they are
    set(Math.min(1, frame.clientWidth / size.width, frame.clientHeight / size.height));
  };
  const zoom = (factor: number, x = frame.clientWidth / 2, y = frame.clientHeight / 2): void => {
    fitted = false;
    const [left, top, old] = [frame.scrollLeft + x, frame.scrollTop + y, scale];
    set(scale * factor);
    frame.scrollTo(left * (scale / old) - x, top * (scale / old) - y);
  };
  frame.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15, event.clientX, event.clientY);
    },
    { passive: false },
  );
  addEventListener("keydown", (event) => {
    const act = { "+": () => zoom(1.25), "=": () => zoom(1.25), "-": () => zoom(0.8), f: fit, "0": fit }[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
  });
  new ResizeObserver(() => {
    if (fitted) fit();
  }).observe(frame);
  const bar = document.createElement("div");
  bar.className = "bar";
  const buttons: [string, string, () => void][] = [
    ["Fit", "show the whole graph (F)", fit],
    ["+", "zoom in (+, Ctrl+wheel)", () => zoom(1.25)],
    ["−", "zoom out (-, Ctrl+wheel)", () => zoom(0.8)],
  ];
  for (const [text, title, act] of buttons) {
    const button = document.createElement("button");
    button.textContent = text;
    button.title = title;
    button.setAttribute("aria-label", title);
    button.addEventListener("click", act);
    bar.append(button);
  }
  return bar;
}

draw();
