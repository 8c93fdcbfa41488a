// The program, away from the thread that draws.

import { Linter } from '../../wasm/src/index';
import type { Answer, Calls, Changes, Question, Reply, Request } from './messages';

let linter: Linter | undefined;

function program(): Linter {
  if (!linter) throw new Error('the program was not started');
  return linter;
}

function put(changes: Changes): void {
  for (const [path, content] of changes) {
    if (content === null) program().remove(path);
    else program().put(path, content);
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

function update(changes: Changes, question: Question): Answer {
  put(changes);
  const began = performance.now();
  const { extendSelect, args } = question;
  const checked = attempt(() => program().check({ extendSelect }));
  const time = performance.now() - began;
  const robots = attempt(() => program().robots()).value ?? [];
  const robot = question.robot ?? robots[0];
  const answer: Answer = { findings: checked.value ?? [], robots, robot, expanded: undefined, time };
  let error = checked.error;
  if (robot !== undefined) {
    const expanded = attempt(() => program().expand(robot, args));
    answer.expanded = expanded.value;
    error ??= expanded.error;
    if (question.model) answer.model = attempt(() => program().call({ call: 'model', file: robot, args })).value;
  }
  return error === undefined ? answer : { ...answer, error };
}

const calls: { [K in keyof Calls]: (take: Calls[K]['take']) => Calls[K]['give'] | Promise<Calls[K]['give']> } = {
  start: async ({ wasm }) => {
    linter = await Linter.create(wasm);
    return linter.version();
  },
  update: ({ changes, question }) => update(changes, question),
  fix: ({ extendSelect, args }) => program().fix({ extendSelect, args }),
  select: (what) => program().call({ call: 'select', ...what }),
  mesh: ({ id }) => program().mesh(id),
};

addEventListener('message', (event: MessageEvent<Request>) => {
  const { id, name, take } = event.data;
  const call = calls[name] as (take: unknown) => unknown;
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
