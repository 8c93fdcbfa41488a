// What is shown, as one line of text that people can send to each other: `file=arm.urdf.xacro&show=visual,grid&joint.elbow=0.8`.

/** A robot, as a view names it. */
export interface RobotText {
  /** Name of its file, without folders. */
  file: string;
  preset?: string;
  args: Record<string, string>;
}

export interface ViewText extends RobotText {
  /** The robot that is shown for comparison. */
  beside?: RobotText;
  /** Radians or meters. */
  joints: Map<string, number>;
  /** Position of the camera and what it looks at. */
  camera?: number[];
  parallel: boolean;
  /** Layers that are on. */
  show: string[];
  /** Links that are hidden, that are seen through, that are selected. */
  hide: string[];
  opacity: Map<string, number>;
  select: string[];
}

/** So that people see what it is. */
const BEGIN = 'xacro-view#';

export function shared(view: ViewText): string {
  return BEGIN + write(view);
}

export function write(view: ViewText): string {
  const text = new URLSearchParams({ file: view.file, show: view.show.join(',') });
  append(text, '', view);
  if (view.beside) {
    text.append('beside', view.beside.file);
    append(text, 'beside.', view.beside);
  }
  for (const [name, value] of view.joints) text.append(`joint.${name}`, rounded(value));
  if (view.camera) text.append('camera', view.camera.map(rounded).join(','));
  if (view.parallel) text.append('parallel', '1');
  for (const name of view.hide) text.append('hide', name);
  for (const [name, share] of view.opacity) text.append(`opacity.${name}`, rounded(share));
  for (const name of view.select) text.append('select', name);
  return text.toString();
}

function append(text: URLSearchParams, before: string, { preset, args }: RobotText): void {
  if (preset !== undefined) text.append(`${before}preset`, preset);
  for (const [name, value] of Object.entries(args)) text.append(`${before}arg.${name}`, value);
}

/** The view that a text names: one that was copied, or the end of an address. Nothing in other texts. */
export function read(given: string): ViewText | undefined {
  const text = new URLSearchParams(given.trim().replace(/^[^#]*#/, ''));
  const file = text.get('file');
  if (!file) return undefined;
  const named = (kind: string): [string, string][] =>
    [...text].filter(([key]) => key.startsWith(`${kind}.`)).map(([key, value]) => [key.slice(kind.length + 1), value]);
  const numbers = (kind: string): Map<string, number> =>
    new Map(named(kind).map(([name, value]) => [name, Number(value)] as const).filter(([, value]) => Number.isFinite(value)));
  const camera = (text.get('camera') ?? '').split(',').map(Number);
  const robot = (of: string, before: string): RobotText => {
    const preset = text.get(`${before}preset`);
    return { file: of, ...(preset === null ? {} : { preset }), args: Object.fromEntries(named(`${before}arg`)) };
  };
  const beside = text.get('beside');
  return {
    ...robot(file, ''),
    ...(beside ? { beside: robot(beside, 'beside.') } : {}),
    joints: numbers('joint'),
    ...(camera.length === 6 && camera.every(Number.isFinite) ? { camera } : {}),
    parallel: text.get('parallel') === '1',
    show: (text.get('show') ?? '').split(','),
    hide: text.getAll('hide'),
    opacity: numbers('opacity'),
    select: text.getAll('select'),
  };
}

function rounded(value: number): string {
  return String(Number(value.toFixed(5)));
}
