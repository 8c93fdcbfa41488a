// Colours for what highlight.js does not know: xacro and URDF are XML; findings, and the marks below bad examples.
(() => {
  'use strict';

  const SAID = [
    [/^(error)(\[|:)/, 'said-error'],
    [/^(warning)(\[|:)/, 'said-warning'],
    [/^(info|hint|note)(\[|:)/, 'said-info'],
    [/^ *(-->|:::) /, 'said-quiet'],
    [/^\[exit \d+\]$/, 'said-quiet'],
    [/^\$ /, 'said-command'],
  ];

  // names and options stay in one piece
  for (const code of document.querySelectorAll('p code, li code')) {
    if (code.textContent.length < 24) code.classList.add('short');
  }

  const escaped = (text) => text.replace(/[&<>]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[c]);
  const span = (kind, html) => `<span class="${kind}">${html}</span>`;

  /** A line of a terminal. */
  function said(line) {
    const found = SAID.find(([pattern]) => pattern.test(line));
    if (found) return span(found[1], escaped(line));
    const mark = /^( *\| *)(\^+)(.*)$/.exec(line);
    return mark ? escaped(mark[1]) + span('said-mark', mark[2]) + escaped(mark[3]) : escaped(line);
  }

  for (const code of document.querySelectorAll('code.language-console')) {
    code.innerHTML = code.textContent.split('\n').map(said).join('\n');
  }

  for (const code of document.querySelectorAll('code.language-urdf, code.language-xacro')) {
    const html = window.hljs ? window.hljs.highlight('xml', code.textContent).value : escaped(code.textContent);
    const marked = html.split('\n').map((line) => {
      if (/^ *\^+$/.test(line)) return span('said-mark', line);
      return line.startsWith('//- ') ? span('said-quiet', line) : line;
    });
    code.innerHTML = marked.join('\n');
  }

  // the bad example of a rule, to be changed and checked in the browser
  const [, rule] = /\/rules\/([a-z0-9-]+)\.html$/.exec(location.pathname) ?? [];
  const bad = document.querySelector('code.bad');
  if (rule && bad) {
    const link = document.createElement('a');
    link.href = `../playground/index.html#rule=${rule}`;
    link.className = 'try';
    link.textContent = 'Open in the playground';
    bad.closest('pre').after(link);
  }
})();
