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
  const group = make("g", { transform: `translate(${x} ${y})`, class: node.missing ? "node missing" : "node" });
  group.append(
    make("title", {}, `${node.label}\n${node.detail}`),
    make("rect", { width: BOX.width, height: BOX.height, rx: 5 }),
    make("text", { x: 12, y: 20, class: "name" }, cut(node.label, 30)),
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
  const picture = make("svg", { width, height, viewBox: `0 0 ${width} ${height}`, role: "group" });
  for (const [from, to] of graph.edges) {
    const [a, b] = [at(from), at(to)];
    const [x1, y1, x2, y2] = [a.x + BOX.width, a.y + BOX.height / 2, b.x, b.y + BOX.height / 2];
    const bend = Math.max(30, Math.abs(x2 - x1) / 2);
    const path = `M${x1} ${y1} C${x1 + bend} ${y1} ${x2 - bend} ${y2} ${x2 - 5} ${y2}`;
    picture.append(make("path", { d: path, class: "edge" }), make("path", { d: `M${x2} ${y2} l-7 -4 v8 z`, class: "tip" }));
  }
  for (const node of graph.nodes) {
    const { x, y } = at(node.id);
    picture.append(box(node, x, y));
  }
  document.body.append(picture);
}

draw();
