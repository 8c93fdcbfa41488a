// Small helpers for elements. Text from the robot's file only ever goes through `textContent`.

type Props = Partial<{
  class: string;
  text: string;
  title: string;
  type: string;
  role: string;
  tabindex: number;
  onclick: (event: MouseEvent) => void;
}>;

/** A new element with its children. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  props: Props = {},
  ...children: Node[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  if (props.class) element.className = props.class;
  if (props.text !== undefined) element.textContent = props.text;
  if (props.title) element.title = props.title;
  if (props.type) element.setAttribute('type', props.type);
  if (props.role) element.setAttribute('role', props.role);
  if (props.tabindex !== undefined) element.tabIndex = props.tabindex;
  if (props.onclick) element.addEventListener('click', props.onclick as EventListener);
  element.append(...children);
  return element;
}

export function button(text: string, title: string, act: () => void, name = ''): HTMLButtonElement {
  const made = el('button', { text, title, type: 'button', onclick: act });
  made.setAttribute('aria-label', title);
  if (name) made.dataset['action'] = name;
  return made;
}

/** A button that stays down. */
export function toggle(text: string, title: string, on: boolean, act: (on: boolean) => void, name = ''): HTMLButtonElement {
  const made = button(text, title, () => set(made.getAttribute('aria-pressed') !== 'true'), name);
  const set = (now: boolean): void => {
    made.setAttribute('aria-pressed', String(now));
    act(now);
  };
  made.setAttribute('aria-pressed', String(on));
  return made;
}

/** A number short enough to read. */
export function short(value: number, digits = 3): string {
  const text = value.toFixed(digits);
  return text.includes('.') ? text.replace(/\.?0+$/, '').replace(/^-0$/, '0') : text;
}
