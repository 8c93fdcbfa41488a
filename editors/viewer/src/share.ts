// Views that can be shared: copied as text, pasted into another preview of the robot, kept when the page is loaded again.

import { el } from './dom';
import type { ModelMessage, Root, Side } from './messages';
import { LAYERS, type Layer, type Layers, type RobotView } from './robot';
import type { Stage } from './stage';
import type { Values } from './values';
import { read, type RobotText, shared, type ViewText, write } from './view_text';

export interface Shown {
  stage: Stage;
  values: Values;
  layers: Layers;
  views: Map<Side, RobotView>;
  main: () => ModelMessage | undefined;
  /** Whether the user turned the camera; from then on the robot is not fitted any more. */
  touched: () => boolean;
  touch: () => void;
  selected: () => Iterable<string>;
  select: (links: string[]) => void;
  switch: (layer: Layer) => void;
  parallel: () => void;
  /** The root that is shown for comparison. */
  beside: () => Root | null;
  root: (root: Root, beside: Root | null) => void;
  remember: (text: string) => void;
}

const LOOK_MS = 500;
/** The robot with other arguments has to come within this time. */
const PATIENCE_MS = 5000;
const NOTICE_MS = 6000;

export class Share {
  readonly notice = el('div', { class: 'notice', role: 'status' });
  private wanted: { view: ViewText; until: number } | undefined;
  private pictures = 0;
  private text = '';
  private timer = 0;

  constructor(private readonly shown: Shown, remembered: string) {
    this.notice.hidden = true;
    const view = read(remembered);
    if (view) this.wanted = { view, until: Infinity };
    addEventListener('paste', (event) => {
      if (event.target instanceof HTMLElement && event.target.matches('input, textarea')) return;
      this.take(event.clipboardData?.getData('text/plain') ?? '');
    });
    setInterval(() => this.remember(), LOOK_MS);
  }

  /** Say something for a while. */
  say(text: string, field?: HTMLInputElement): void {
    this.notice.replaceChildren(el('span', { text }), ...(field ? [field] : []));
    this.notice.hidden = false;
    clearTimeout(this.timer);
    if (!field) this.timer = setTimeout(() => (this.notice.hidden = true), NOTICE_MS);
  }

  /** Put what is shown on the clipboard; where that is not allowed, into a field to copy it from. */
  copy(): void {
    const view = this.view(true);
    if (!view) return this.say('no robot is shown yet');
    const text = shared(view);
    const asked = navigator.clipboard?.writeText(text) ?? Promise.reject(new Error('no clipboard'));
    asked.then(
      () => this.say('view copied: paste it (Ctrl+V) into a preview of the same robot'),
      () => {
        const field = el('input', { type: 'text', title: 'the view as text' });
        [field.value, field.readOnly] = [text, true];
        this.say('copy this text, and paste it (Ctrl+V) into a preview of the same robot', field);
        field.select();
      },
    );
  }

  /** Show a view that was pasted. */
  take(text: string): void {
    const view = read(text);
    const main = this.shown.main();
    if (!view || !main) return;
    const file = fileOf(main.root);
    if (view.file !== file) return this.say(`this view is of ${view.file}, not of ${file}`);
    this.text = '';
    this.wanted = { view, until: performance.now() + PATIENCE_MS };
    const root = rootOf(view, main);
    const beside = besideOf(view, main);
    if (!same(root, main.root) || !same(beside, this.shown.beside())) this.shown.root(root, beside);
    this.came();
  }

  /** A model came: what is wanted may be possible now. */
  came(): void {
    const main = this.shown.main();
    if (!this.wanted || !main) return;
    const { view, until } = this.wanted;
    if (view.file !== fileOf(main.root) || performance.now() > until) return void (this.wanted = undefined);
    if (until === Infinity) return this.take(write(view));
    if (same(rootOf(view, main), main.root)) this.wanted = undefined;
    this.apply(view);
  }

  private apply(view: ViewText): void {
    const { shown } = this;
    for (const layer of LAYERS) if (shown.layers[layer] !== view.show.includes(layer)) shown.switch(layer);
    for (const robot of shown.views.values()) {
      const links = new Set(robot.model.links.map(({ name }) => name));
      robot.hidden.clear();
      for (const name of view.hide) if (links.has(name)) robot.hidden.add(name);
      for (const name of new Set([...robot.opacity.keys(), ...view.opacity.keys()])) {
        robot.fade(name, Math.min(1, Math.max(0.1, view.opacity.get(name) ?? 1)));
      }
      robot.applyLayers();
    }
    shown.values.place(view.joints);
    shown.select(view.select);
    if (shown.stage.parallel !== view.parallel) shown.parallel();
    if (!view.camera) return;
    shown.stage.camera.position.fromArray(view.camera);
    shown.stage.orbit.target.fromArray(view.camera, 3);
    shown.stage.orbit.update();
    shown.touch();
  }

  private remember(): void {
    const { stage } = this.shown;
    if (stage.pictures === this.pictures || this.wanted) return;
    this.pictures = stage.pictures;
    const view = this.view(this.shown.touched());
    const text = view ? write(view) : '';
    if (!text || text === this.text) return;
    this.text = text;
    this.shown.remember(text);
  }

  private view(camera: boolean): ViewText | undefined {
    const { stage, values, layers, views, selected } = this.shown;
    const main = this.shown.main();
    const robot = views.get('main');
    if (!main || !robot) return undefined;
    const beside = this.shown.beside();
    return {
      ...textOf(main.root),
      ...(beside ? { beside: textOf(beside) } : {}),
      joints: values.moved(),
      ...(camera ? { camera: [...stage.camera.position.toArray(), ...stage.orbit.target.toArray()] } : {}),
      parallel: stage.parallel,
      show: LAYERS.filter((layer) => layers[layer]),
      hide: [...robot.hidden],
      opacity: new Map([...robot.opacity].filter(([, share]) => share < 1)),
      select: [...selected()],
    };
  }
}

function fileOf({ uri }: Root): string {
  return decodeURIComponent(uri.split('/').pop() ?? uri);
}

/** The robot of a view here: only arguments that it has, and a preset that there is. */
function rootOf(view: ViewText, main: ModelMessage): Root {
  const declared = new Set(main.args.map(({ name }) => name));
  const args = Object.fromEntries(Object.entries(view.args).filter(([name]) => declared.has(name)));
  const known = main.choices.some(({ uri, preset }) => uri === main.root.uri && preset === view.preset);
  const preset = view.preset !== undefined && known ? { preset: view.preset } : {};
  return { uri: main.root.uri, ...(Object.keys(args).length > 0 ? { args } : {}), ...preset };
}

/** The root that a view compares with, if it is one of those to choose from. */
function besideOf({ beside }: ViewText, main: ModelMessage): Root | null {
  if (!beside) return null;
  const wanted = key(beside);
  return main.choices.find((root) => key(textOf(root)) === wanted) ?? null;
}

function textOf(root: Root): RobotText {
  const { preset, args } = root;
  return { file: fileOf(root), ...(preset === undefined ? {} : { preset }), args: args ?? {} };
}

function same(one: Root | null, other: Root | null): boolean {
  if (!one || !other) return one === other;
  return one.uri === other.uri && key(textOf(one)) === key(textOf(other));
}

function key({ file, preset, args }: RobotText): string {
  return JSON.stringify([file, Object.entries(args).sort(), preset ?? null]);
}
