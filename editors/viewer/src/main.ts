// The viewer: takes models in, shows them, and says what was clicked.

import * as THREE from 'three';
import { Banner } from './banner';
import { Details } from './details';
import { button, el, short } from './dom';
import { connect } from './host';
import { JointPanel } from './joints';
import type { FromHost, Location, Model, ModelMessage, SelectMessage, Side } from './messages';
import { Meshes } from './meshes';
import { Pointer } from './pointer';
import { ProgramsPanel } from './programs';
import { RobotView } from './robot';
import { Share } from './share';
import { Stage } from './stage';
import { State } from './state';
import { applyStyle } from './style';
import { label, Toolbar } from './toolbar';
import { TreePanel } from './tree';
import { Values } from './values';

applyStyle();
const state = new State();
const { layers, settings, views, latest, times } = state;
const stage = new Stage();
const CORNER = new THREE.Vector3(1.1, -1.3, 0.75);

const values = new Values(() => {
  for (const view of views.values()) view.pose();
  joints.show();
  details.update();
});
stage.orbit.addEventListener('start', () => (state.touched = true));
// panels and the list of errors take room from the picture: a view that nobody turned still shows the whole robot
stage.resized = () => {
  if (state.fitted && !state.touched) fit();
};
stage.before.push((now) => values.step(now));

const joints = new JointPanel(values, { select: (name) => selectJoint(name) });
const details = new Details({
  open: (link, location) => tell({ link }, location),
  fade: (link, share) => {
    for (const view of views.values()) view.fade(link, share);
  },
  position: (joint) => values.get(joint),
});
const tree = new TreePanel({
  select: (link, shift) => selectLink(link, shift),
  focus: (link) => focus(link),
  show: (link, on) => {
    for (const view of views.values()) view.show(link, on);
    tree.eyes();
  },
  hidden: () => views.get('main')?.hidden ?? new Set(),
}, details.element);
const programs = new ProgramsPanel((location) => host.send({ type: 'open', location }));
const toolbar = new Toolbar(layers, {
  root: (root, compare) => {
    if (!compare) close('compare');
    host.send({ type: 'root', root, compare });
  },
  layer: (layer, on) => {
    layers[layer] = on;
    if (layer === 'grid') stage.grid = on;
    for (const view of views.values()) view.applyLayers();
  },
  fit: () => fit(),
  parallel: (on) => (stage.parallel = on),
  picture: () => savePicture(),
  urdf: () => saveUrdf(),
  copy: () => share.copy(),
  measure: (on) => pointer.measure(on),
  panel: (which, on) => {
    const panels = { left: tree, right: joints, programs };
    panels[which].element.hidden = !on;
    stage.invalidate();
  },
  help: () => (help.hidden = !help.hidden),
});
const banner = new Banner({
  open: (location) => host.send({ type: 'open', location }),
  select: (link) => selectLink(link, false),
});
const status = el('div', { class: 'status' });
const tip = el('div', { class: 'tip' });
const menu = el('div', { class: 'menu', role: 'menu' });
const help = el('div', { class: 'help' });
const empty = el('div', { class: 'empty', text: 'waiting for the robot …' });
for (const box of [banner.element, tip, menu, help]) box.hidden = true;
stage.element.append(status, empty, help);
const app = el('div', {}, toolbar.element, banner.element, tree.element, stage.element, joints.element, programs.element);
app.id = 'app';
document.body.append(app, toolbar.menu, menu, tip);
// in half a window the joints stay: they are what a preview is opened for
const closed = innerWidth < 460 ? '[data-action=tree], [data-action=joints]' : innerWidth < 900 ? '[data-action=tree]' : '';
if (closed) app.querySelectorAll<HTMLElement>(closed).forEach((one) => one.click());
stage.recolor();

const pointer = new Pointer(stage, () => [...views.values()], values, {
  hover: showTip,
  click: (_, link, shift) => selectLink(link, shift),
  clickNothing: () => select([], []),
  menu: openMenu,
  dragging: (joint) => {
    if (joint !== state.held) joints.mark(joint ? [joint] : state.selected.joints, true);
    state.held = joint;
  },
});

const host = connect({
  message: receive,
  view: (text) => share.take(text),
  connection: (state) => {
    document.body.dataset['connection'] = state;
    if (state === 'refused') empty.textContent = 'this address is no longer valid: open the preview again';
    showState();
  },
});
// not every editor can give the URDF
toolbar.urdf.hidden = document.body.dataset['host'] === 'webview';
const share = new Share({
  stage, values, layers, views,
  main: () => latest.get('main'),
  touched: () => state.touched,
  touch: () => ([state.touched, state.fitted] = [true, true]),
  selected: () => state.selected.links,
  select: (links) => {
    select(links, links.flatMap((link) => find(link)?.view.jointAbove(link)?.name ?? []));
    tree.eyes();
  },
  switch: (layer) => toolbar.switch(layer),
  parallel: () => toolbar.parallel.click(),
  beside: () => toolbar.compared,
  root: (root, beside) => toolbar.select(root, beside),
  remember: (text) => host.remember(text),
}, host.remembered);
stage.element.append(share.notice);
const meshes = new Meshes(host, () => showState());
host.send({ type: 'ready' });

function receive(message: FromHost): void {
  switch (message.type) {
    case 'model':
      return show(message);
    case 'select':
      return take(message);
    case 'closed':
      return close(message.side);
    case 'settings':
      if (message.fps) stage.maxFps = Math.min(240, Math.max(1, message.fps));
      if (message.meshMaxMB) settings.meshMaxMB = message.meshMaxMB;
      if (message.urdf) toolbar.urdf.hidden = false;
      if (message.theme) document.documentElement.className = message.theme;
      return stage.recolor();
    case 'mesh':
    case 'urdf':
  }
}

/** Show a model, unless a newer one came before. */
function show(message: ModelMessage): void {
  const { side } = message;
  const known = latest.get(side);
  if (known && known.id === message.id && known.revision >= message.revision) return;
  latest.set(side, message);
  times.set(message.revision, new Date().toLocaleTimeString());
  if (times.size > 500) times.delete(times.keys().next().value ?? 0);
  const model = message.model ?? message.lastGood;
  let view = views.get(side);
  if (!view) {
    view = new RobotView(side, stage, meshes, values, layers, settings, () => showState());
    // a second robot looks like the first
    for (const name of views.get('main')?.hidden ?? []) view.hidden.add(name);
    views.set(side, view);
    view.select(outlined());
  }
  if (model) view.model = model;
  const models = [...views.values()].map((one) => one.model);
  values.update(models);
  state.busy = true;
  if (model) view.update(model);
  state.busy = false;
  meshes.keep(models);
  if (side === 'main') {
    toolbar.update(message);
    programs.update(message.programs);
    tree.update(view.model);
  }
  joints.update(together(models));
  if (!state.fitted && view.model.links.length > 0) fit(CORNER);
  showDetails();
  sideLabels();
  showState();
  if (side === 'main') share.came();
}

/** The joints of all sides, each once. */
function together(models: Model[]): Model {
  const [main] = models;
  if (!main || models.length === 1) return main ?? { robot: '', links: [], joints: [], meshes: {} };
  const names = new Set<string>();
  const all = models.flatMap((model) => model.joints).filter((joint) => !names.has(joint.name) && names.add(joint.name));
  return { ...main, joints: all };
}

function close(side: Side): void {
  views.get(side)?.dispose();
  views.delete(side);
  latest.delete(side);
  stage.removePane(side);
  sideLabels();
  showState();
}

/** Say which side is which, while there are two. */
function sideLabels(): void {
  const shown = [...latest].map(([side, { root, choices }]) => [side, label(root, choices)] as const);
  stage.title(new Map(views.size < 2 ? [] : shown));
}

/** Write down what is shown: revision, errors, what is missing. */
function showState(): void {
  if (state.busy) return;
  const main = latest.get('main');
  const view = views.get('main');
  empty.hidden = !!view && view.model.links.length > 0;
  if (main && !empty.hidden) empty.textContent = 'this file makes no links';
  const lost = document.body.dataset['connection'] === 'lost' ? ' · connection lost, trying again' : '';
  const pending = [...views.values()].reduce((all, one) => all + one.loading, meshes.pending);
  if (view && view.model.links.length > 0 && pending === 0 && !state.fitted) {
    // with all its meshes for the first time
    state.fitted = true;
    if (!state.touched) fit(CORNER);
  }
  const loading = meshes.pending > 0 ? ` · ${meshes.progress}` : '';
  status.textContent = main ? `revision ${main.revision} · ${times.get(main.revision) ?? ''} · Z is up${loading}${lost}` : lost;
  document.body.dataset['revision'] = String(main?.revision ?? 0);
  document.body.dataset['ok'] = String(main?.ok ?? '');
  document.body.dataset['loading'] = String(pending);
  banner.update(state);
  stage.invalidate();
}

function find(link: string): { model: Model; view: RobotView } | undefined {
  for (const view of views.values()) if (view.model.links.some((one) => one.name === link)) return { model: view.model, view };
  return undefined;
}

/** The links that are selected, by themselves or by the joints that hold them. */
function outlined(): Set<string> {
  const links = new Set(state.selected.links);
  for (const { model } of views.values()) {
    for (const joint of model.joints) if (state.selected.joints.has(joint.name)) links.add(joint.child);
  }
  return links;
}

/** Outline links and mark joints. */
function select(links: Iterable<string>, moved: Iterable<string>): void {
  state.selected = { links: new Set(links), joints: new Set(moved) };
  document.body.dataset['selected'] = [...state.selected.links, ...state.selected.joints].join(' ');
  const names = outlined();
  for (const view of views.values()) view.select(names);
  tree.mark(names, true);
  joints.mark(state.selected.joints, true);
  showDetails();
}

/** Write down the link that is selected, when it is one. */
function showDetails(): void {
  const [name] = state.selected.links.size > 0 ? state.selected.links : outlined();
  const found = name === undefined ? undefined : find(name);
  details.show(found?.view, name);
}

function selectLink(name: string, call: boolean): void {
  const link = find(name)?.model.links.find((one) => one.name === name);
  if (!link) return;
  const above = find(name)?.view.jointAbove(name);
  select([name], above ? [above.name] : []);
  tell({ link: name }, call ? (link.call ?? link.origin) : link.origin);
}

function selectJoint(name: string): void {
  const joint = values.joint(name);
  if (!joint) return;
  select([joint.child], [name]);
  tell({ joint: name }, joint.origin);
}

function tell(what: { link: string } | { joint: string }, location: Location | undefined): void {
  state.sends('link' in what ? what.link : what.joint);
  host.send({ type: 'select', ...what, ...(location ? { location } : {}) });
}

/** The cursor in the source is somewhere else. */
function take(message: SelectMessage): void {
  // what was clicked here comes back, perhaps when something else is selected by now
  if (state.isAnswer(message)) return;
  if (message.link !== undefined && state.selected.links.has(message.link)) return;
  if (message.joint !== undefined && state.selected.joints.has(message.joint)) return;
  const links = message.links ?? (message.link === undefined ? [] : [message.link]);
  const names = message.joints ?? (message.joint === undefined ? [] : [message.joint]);
  select(links, names);
}

/** The picture as it is, as a file. */
function savePicture(): void {
  stage.draw();
  save('png', stage.canvas.toDataURL('image/png'));
}

/** The robot with the arguments chosen, as a file. */
function saveUrdf(): void {
  host.urdf().then(
    (text) => {
      const url = URL.createObjectURL(new Blob([text], { type: 'application/xml' }));
      save('urdf', url);
      setTimeout(() => URL.revokeObjectURL(url), 60_000);
    },
    (error: unknown) => share.say(error instanceof Error ? error.message : String(error)),
  );
}

function save(ending: string, url: string): void {
  const link = el('a');
  link.download = `${views.get('main')?.model.robot || 'robot'}.${ending}`;
  link.href = url;
  link.click();
}

function fit(direction?: THREE.Vector3): void {
  const box = new THREE.Box3();
  for (const view of views.values()) box.union(view.box());
  stage.fit(box, direction);
}

function focus(link: string): void {
  const box = find(link)?.view.box(link);
  if (box) stage.fit(box);
}

function showTip(view: RobotView | undefined, link: string | undefined, at: { x: number; y: number }): void {
  tip.hidden = link === undefined || !menu.hidden;
  if (!view || link === undefined) return;
  const own = view.model.links.find((one) => one.name === link);
  const mass = own?.inertial ? `${short(own.inertial.mass, 4)} kg` : 'no inertia';
  const standsIn = own && view.standsIn(own) ? [el('small', { text: 'no visual: the collision shape is shown' })] : [];
  const chain = view.chain(link);
  const way = chain.length > 7 ? [...chain.slice(0, 5), '…', chain[chain.length - 1] ?? ''] : chain;
  tip.replaceChildren(el('b', { text: link }), el('small', { text: mass }), ...standsIn, el('small', { text: way.reverse().join(' → ') }));
  tip.style.left = `${Math.min(at.x + 14, innerWidth - 330)}px`;
  tip.style.top = `${Math.min(at.y + 14, innerHeight - 90)}px`;
}

function openMenu(view: RobotView, link: string, at: { x: number; y: number }): void {
  tip.hidden = true;
  const own = view.model.links.find((one) => one.name === link);
  const joint = view.jointAbove(link);
  const entry = (text: string, name: string, act: () => void): HTMLButtonElement =>
    button(text, text, () => {
      menu.hidden = true;
      act();
    }, name);
  const entries = [
    entry(`Go to ${link}`, 'go-link', () => selectLink(link, false)),
    ...(own?.call ? [entry('Go to the call that made it', 'go-call', () => selectLink(link, true))] : []),
    ...(joint ? [entry(`Go to joint ${joint.name}`, 'go-joint', () => selectJoint(joint.name))] : []),
    entry('Copy name', 'copy', () => void navigator.clipboard?.writeText(link).catch(() => undefined)),
    entry('Show in tree', 'in-tree', () => {
      if (tree.element.hidden) app.querySelector<HTMLElement>('[data-action=tree]')?.click();
      select([link], []);
    }),
    entry('Fill the picture with it', 'focus', () => focus(link)),
    entry('Hide', 'hide', () => {
      for (const one of views.values()) one.show(link, false);
      tree.eyes();
    }),
  ];
  menu.replaceChildren(...entries);
  menu.hidden = false;
  menu.style.left = `${Math.min(at.x, innerWidth - 230)}px`;
  menu.style.top = `${Math.min(at.y, innerHeight - 30 * entries.length)}px`;
  entries[0]?.focus();
}

const keys: Record<string, [string, () => void]> = {
  f: ['whole robot', () => fit()],
  r: ['joints to zero', () => values.reset()],
  m: ['measure', () => toolbar.measure.click()],
  v: ['visual', () => toolbar.switch('visual')],
  c: ['collision', () => toolbar.switch('collision')],
  x: ['frames', () => toolbar.switch('frames')],
  n: ['names', () => toolbar.switch('names')],
  a: ['joint axes', () => toolbar.switch('axes')],
  i: ['inertia', () => toolbar.switch('inertia')],
  o: ['centers of mass', () => toolbar.switch('com')],
  b: ['bounding box', () => toolbar.switch('bbox')],
  g: ['grid', () => toolbar.switch('grid')],
  '1': ['from the front', () => fit(new THREE.Vector3(1, 0, 0.001))],
  '2': ['from the left', () => fit(new THREE.Vector3(0, 1, 0.001))],
  '3': ['from above', () => fit(new THREE.Vector3(-0.001, 0, 1))],
  '4': ['from a corner', () => fit(CORNER)],
  p: ['parallel projection', () => toolbar.parallel.click()],
  '/': ['search', () => tree.focusSearch()],
  '?': ['these keys', () => (help.hidden = !help.hidden)],
};
for (const [key, [text]] of Object.entries(keys)) help.append(el('span', { text }), el('kbd', { text: key.toUpperCase() }));

addEventListener('keydown', (event) => {
  if (event.key === 'Escape') {
    for (const box of [menu, help, tip]) box.hidden = true;
    toolbar.closeMenu();
    if (toolbar.measure.getAttribute('aria-pressed') === 'true') toolbar.measure.click();
    return;
  }
  const typing = event.target instanceof HTMLElement && event.target.matches('input:not([type=range], [type=checkbox]), select');
  if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
  const act = keys[event.key.toLowerCase()];
  if (!act) return;
  event.preventDefault();
  act[1]();
});
addEventListener('pointerdown', (event) => {
  if (!(event.target instanceof Node)) return;
  if (!menu.contains(event.target)) menu.hidden = true;
  const opener = event.target instanceof HTMLElement && event.target.dataset['action'] === 'layers';
  if (!toolbar.menu.contains(event.target) && !opener) toolbar.closeMenu();
}, { capture: true });
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => stage.recolor());
new MutationObserver(() => stage.recolor()).observe(document.body, { attributes: true, attributeFilter: ['class'] });

// for tests, and for the curious in the console
Object.assign(window, { xacroViewer: { stage, views, values, layers, meshes } });
