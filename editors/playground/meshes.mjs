// The meshes that the pages of the rules describe in a few words, such as `box 0.1 flipped`; tests/meshes/mod.rs makes the same.

/** A binary STL. */
export function stl(recipe) {
  const words = recipe.split(' ');
  const number = (at) => Number(words[at]);
  const three = (at) => [number(at), number(at + 1), number(at + 2)];
  const shapes = { box: () => block([number(1), number(1), number(1)]), block: () => block(three(1)), sphere: () => sphere(number(1), number(2)) };
  let triangles = shapes[words[0]]();
  const behind = (word, otherwise, value) => (words.includes(word) ? value(words.indexOf(word) + 1) : otherwise);
  const at = behind('at', [0, 0, 0], three);
  const times = behind('times', 1, number);
  triangles = triangles.map((corners) => corners.map((point) => point.map((part, axis) => (part + at[axis]) * times)));
  if (words.includes('open')) triangles.splice(-2);
  const turned = words.includes('inverted') ? triangles.length : words.includes('flipped') ? 1 : 0;
  for (const corners of triangles.slice(0, turned)) [corners[1], corners[2]] = [corners[2], corners[1]];
  const bytes = Buffer.alloc(84 + 50 * triangles.length);
  bytes.write(words.includes('solid') ? 'solid part' : 'part');
  bytes.writeUInt32LE(triangles.length, 80);
  triangles.forEach((corners, n) => corners.flat().forEach((part, k) => bytes.writeFloatLE(part, 84 + 50 * n + 12 + 4 * k)));
  return words.includes('cut') ? bytes.subarray(0, bytes.length - 20) : bytes;
}

function block(size) {
  const corner = (i) => size.map((side, axis) => ((i >> axis) & 1 ? side / 2 : -side / 2));
  const sides = [[0, 2, 3, 1], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6], [4, 5, 7, 6]];
  return sides.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]).map((side) => side.map(corner));
}

function sphere(radius, rings) {
  const point = (ring, step) => {
    const [polar, around] = [(Math.PI * ring) / rings, (2 * Math.PI * (step % rings)) / rings];
    const width = ring === 0 || ring === rings ? 0 : Math.sin(polar);
    return [width * Math.cos(around), width * Math.sin(around), Math.cos(polar)].map((part) => part * radius);
  };
  const triangles = [];
  for (let ring = 0; ring < rings; ring++) {
    for (let step = 0; step < rings; step++) {
      const [a, b, c, d] = [point(ring, step), point(ring, step + 1), point(ring + 1, step), point(ring + 1, step + 1)];
      if (ring > 0) triangles.push([a, d, b]);
      if (ring + 1 < rings) triangles.push([a, c, d]);
    }
  }
  return triangles;
}
