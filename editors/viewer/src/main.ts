import { connect } from './host';

const list = document.createElement('pre');
document.body.append(list);
const host = connect({
  message(message) {
    if (message.type !== 'model') return;
    const model = message.model ?? message.lastGood;
    list.textContent = `revision ${message.revision}: ${model?.links.map((link) => link.name).join(', ') ?? ''}`;
    list.dataset['revision'] = String(message.revision);
  },
  connection(state) {
    document.body.dataset['connection'] = state;
  },
});
host.send({ type: 'ready' });
