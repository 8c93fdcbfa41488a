// What the viewer knows, apart from what is drawn.

import type { ModelMessage, SelectMessage, Side } from './messages';
import type { Layers, RobotView } from './robot';

const ANSWERED_WITHIN_MS = 2000;

export class State {
  readonly layers: Layers = {
    visual: true, collision: false, frames: false, names: false, axes: false, inertia: false, com: false, bbox: false, grid: true,
  };
  readonly settings = { meshMaxMB: 64 };
  readonly views = new Map<Side, RobotView>();
  /** The newest model of each side. */
  readonly latest = new Map<Side, ModelMessage>();
  /** When a revision came. */
  readonly times = new Map<number, string>();
  selected: { links: Set<string>; joints: Set<string> } = { links: new Set(), joints: new Set() };
  /** The whole robot was shown once. */
  fitted = false;
  /** The user turned the camera. */
  touched = false;
  /** A model is being taken over: nothing is final yet. */
  busy = false;
  /** The joint that is dragged. */
  held: string | undefined;
  /** What was clicked here last: the program says it back to all viewers, also to this one. */
  private sent = { name: '', until: 0 };

  sends(name: string): void {
    this.sent = { name, until: performance.now() + ANSWERED_WITHIN_MS };
  }

  /** Whether a message says back what was clicked here. */
  isAnswer({ link, joint }: SelectMessage): boolean {
    const { name, until } = this.sent;
    return performance.now() < until && (link === name || joint === name);
  }
}
