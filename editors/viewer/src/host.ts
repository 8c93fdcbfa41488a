// Where the viewer runs: in a webview of an editor, which passes messages on, or in a browser, which holds a
// WebSocket to the server on this machine. Everything else in the viewer knows only `Host`.

import type { FromHost, MeshMessage, ToHost, UrdfMessage } from './messages';

export interface Host {
  send(message: ToHost): void;
  /** The bytes of a file of the model. */
  mesh(id: string): Promise<ArrayBuffer>;
  /** The expanded robot. */
  urdf(): Promise<string>;
  /** What was remembered in this tab. */
  readonly remembered: string;
  /** Remember what is shown, for when the page is loaded again. */
  remember(view: string): void;
}

/** What the viewer does with messages, and with the state of the connection. */
export interface Listener {
  message(message: FromHost): void;
  connection(state: 'open' | 'lost' | 'refused'): void;
  /** A view was pasted into the address. */
  view(text: string): void;
}

interface VsCodeApi {
  postMessage(message: unknown): void;
  setState?(state: unknown): void;
  getState?(): unknown;
}

declare function acquireVsCodeApi(): VsCodeApi;

/** The host this page runs in. */
export function connect(listener: Listener): Host {
  return typeof acquireVsCodeApi === 'function' ? webview(listener) : browser(listener);
}

function webview(listener: Listener): Host {
  document.body.dataset['host'] = 'webview';
  const editor = acquireVsCodeApi();
  const waiting = new Map<string, { done: (bytes: ArrayBuffer) => void; failed: (error: Error) => void }[]>();
  const answer = (message: MeshMessage): void => {
    for (const { done, failed } of waiting.get(message.mesh) ?? []) {
      if (message.data === undefined) failed(new Error(message.error ?? 'the file cannot be read'));
      else void bytesOf(message.data).then(done, failed);
    }
    waiting.delete(message.mesh);
  };
  const saved: ((message: UrdfMessage) => void)[] = [];
  const state = editor.getState?.();
  window.addEventListener('message', (event: MessageEvent<unknown>) => {
    if (!isMessage(event.data)) return;
    if (event.data.type === 'mesh') answer(event.data);
    else if (event.data.type === 'urdf') saved.splice(0).forEach((take) => take(event.data as UrdfMessage));
    else listener.message(event.data);
  });
  // not before the caller has its host
  queueMicrotask(() => listener.connection('open'));
  return {
    send: (message) => editor.postMessage(message),
    remembered: typeof state === 'string' ? state : '',
    remember: (view) => editor.setState?.(view),
    urdf: () =>
      new Promise((done, failed) => {
        saved.push(({ text, error }) => (text === undefined ? failed(new Error(error ?? 'there is no URDF')) : done(text)));
        editor.postMessage({ type: 'urdf' } satisfies ToHost);
      }),
    mesh: (id) =>
      new Promise((done, failed) => {
        const list = waiting.get(id) ?? [];
        list.push({ done, failed });
        waiting.set(id, list);
        if (list.length === 1) editor.postMessage({ type: 'mesh', mesh: id } satisfies ToHost);
      }),
  };
}

function browser(listener: Listener): Host {
  const fragment = new URLSearchParams(location.hash.slice(1));
  const token = fragment.get('token') ?? kept();
  const id = Number(fragment.get('id') ?? '0');
  let secret = fragment.has('token') ? `token=${token}&` : '';
  const remembered = location.hash.slice(1);
  const remember = (view: string): void => history.replaceState(null, '', `#${secret}id=${id}${view ? `&${view}` : ''}`);
  // what people copy from the address bar must not let others in
  const hide = (): void => {
    if (!secret || !keep(token)) return;
    secret = '';
    remember(view(remembered));
  };
  addEventListener('hashchange', () => {
    const given = location.hash.slice(1);
    if (new URLSearchParams(given).has('token')) location.reload();
    else listener.view(given);
  });
  const queue: ToHost[] = [];
  let socket: WebSocket | undefined;
  let greeted = false;
  let pause = 250;
  const open = (): void => {
    socket = new WebSocket(`ws://${location.host}/socket`);
    greeted = false;
    socket.onopen = () => {
      socket?.send(JSON.stringify({ type: 'hello', token, id }));
      greeted = true;
      pause = 250;
      for (const message of queue.splice(0)) socket?.send(JSON.stringify(message));
      listener.connection('open');
    };
    socket.onmessage = (event: MessageEvent<unknown>) => {
      if (typeof event.data !== 'string') return;
      const message: unknown = JSON.parse(event.data);
      if (!isMessage(message)) return;
      hide();
      listener.message(message);
    };
    socket.onclose = (event) => {
      greeted = false;
      // 4001: the token is wrong; trying again would not help
      listener.connection(event.code === 4001 ? 'refused' : 'lost');
      if (event.code !== 4001) setTimeout(open, (pause = Math.min(pause * 2, 5000)));
    };
  };
  open();
  return {
    send: (message) => {
      if (greeted && socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
      else if (message.type !== 'ready') queue.push(message);
    },
    mesh: async (id) => {
      const answer = await fetch(`/mesh/${encodeURIComponent(id)}`, { headers: { 'X-Xacro-Token': token } });
      if (!answer.ok) throw new Error(await answer.text());
      return answer.arrayBuffer();
    },
    urdf: async () => {
      const answer = await fetch(`/urdf/${id}`, { headers: { 'X-Xacro-Token': token } });
      if (!answer.ok) throw new Error(await answer.text());
      return answer.text();
    },
    remembered,
    remember,
  };
}

/** A fragment without what is of this tab alone. */
function view(fragment: string): string {
  return fragment.split('&').filter((part) => !/^(token|id)=/.test(part)).join('&');
}

const KEY = 'xacro-preview-token';

/** The token that this tab came with. */
function kept(): string {
  try {
    return sessionStorage.getItem(KEY) ?? '';
  } catch {
    return '';
  }
}

/** Keep the token for when the page is loaded again, in this tab alone; whether that is allowed. */
function keep(token: string): boolean {
  try {
    sessionStorage.setItem(KEY, token);
    return true;
  } catch {
    return false;
  }
}

function isMessage(value: unknown): value is FromHost {
  const types = ['model', 'select', 'mesh', 'urdf', 'settings', 'closed'];
  if (typeof value !== 'object' || value === null || !('type' in value)) return false;
  return typeof value.type === 'string' && types.includes(value.type);
}

async function bytesOf(data: ArrayBuffer | Uint8Array | string): Promise<ArrayBuffer> {
  if (data instanceof ArrayBuffer) return data;
  if (typeof data !== 'string') return data.slice().buffer as ArrayBuffer;
  // the browser decodes it in the background
  return (await fetch(`data:application/octet-stream;base64,${data}`)).arrayBuffer();
}
