// The program, away from the thread that draws.

import { Linter } from '../../wasm/src/index';
import type { Answer, Calls, Changes, Question, Reply, Request } from './messages';

let started: Promise<Linter> | undefined;

/** The program, once it is there: questions that come before it wait. */
function program(): Promise<Linter> {
  if (!started) throw new Error('the program was not started');
  return started;
}

function put(linter: Linter, changes: Changes): void {
  for (const [path, content] of changes) {
    if (content === null) linter.remove(path);
    else linter.put(path, content);
  }
}

/** A value, or what is wrong with the question: one answer that fails does not take the others along. */
function attempt<T>(ask: () => T): { value?: T; error?: string } {
  try {
    return { value: ask() };
  } catch (error) {
    return { error: error instanceof Error ? error.message : String(error) };
  }
}

function update(linter: Linter, changes: Changes, question: Question): Answer {
  put(linter, changes);
  const began = performance.now();
  const { extendSelect, args } = question;
  const checked = attempt(() => linter.check({ extendSelect }));
  const time = performance.now() - began;
  const robots = attempt(() => linter.robots()).value ?? [];
  const robot = question.robot ?? robots[0];
  const answer: Answer = { findings: checked.value ?? [], robots, robot, expanded: undefined, time };
  let error = checked.error;
  if (robot !== undefined) {
    const expanded = attempt(() => linter.expand(robot, args));
    answer.expanded = expanded.value;
    error ??= expanded.error;
    if (question.model) answer.model = attempt(() => linter.call({ call: 'model', file: robot, args })).value;
  }
  return error === undefined ? answer : { ...answer, error };
}

const calls: { [K in keyof Calls]: (take: Calls[K]['take']) => Promise<Calls[K]['give']> } = {
  start: async ({ wasm }) => {
    started = Linter.create(wasm);
    return (await started).version();
  },
  update: async ({ changes, question }) => update(await program(), changes, question),
  fix: async ({ extendSelect, args }) => (await program()).fix({ extendSelect, args }),
  select: async (what) => (await program()).call({ call: 'select', ...what }),
  mesh: async ({ id }) => (await program()).mesh(id),
};

addEventListener('message', (event: MessageEvent<Request>) => {
  const { id, name, take } = event.data;
  const call = calls[name] as (take: unknown) => Promise<unknown>;
  void (async () => {
    let reply: Reply;
    try {
      reply = { id, give: await call(take) };
    } catch (error) {
      reply = { id, error: error instanceof Error ? error.message : String(error) };
    }
    postMessage(reply);
  })();
});
