/** Layers of a graph: where each node stands when edges point to the right. */

export interface Place {
  column: number;
  row: number;
}

/**
 * Each node one column behind the furthest one that points to it; edges that close a circle do not count. Rows
 * follow the mean row of those that point there.
 */
export function layout(ids: readonly string[], edges: readonly (readonly [string, string])[]): Map<string, Place> {
  const columns = columnsOf(ids, edges);
  const places = new Map<string, Place>();
  const width = Math.max(0, ...columns.values());
  for (let column = 0; column <= width; column++) {
    const here = ids.filter((id) => columns.get(id) === column);
    const mean = (id: string): number => {
      const rows = edges.filter(([, to]) => to === id).map(([from]) => places.get(from)?.row ?? 0);
      return rows.length === 0 ? 0 : rows.reduce((sum, row) => sum + row, 0) / rows.length;
    };
    const order = here.map((id) => ({ id, mean: mean(id) })).sort((a, b) => a.mean - b.mean);
    order.forEach(({ id }, row) => places.set(id, { column, row }));
  }
  return places;
}

function columnsOf(ids: readonly string[], edges: readonly (readonly [string, string])[]): Map<string, number> {
  const columns = new Map(ids.map((id) => [id, 0]));
  // a path has fewer steps than there are nodes; more means a circle
  for (const _ of ids) {
    let moved = false;
    for (const [from, to] of edges) {
      const wanted = (columns.get(from) ?? 0) + 1;
      if (from === to || (columns.get(to) ?? 0) >= wanted || wanted >= ids.length) continue;
      columns.set(to, wanted);
      moved = true;
    }
    if (!moved) break;
  }
  return columns;
}
