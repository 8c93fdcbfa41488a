// The findings: marks in the editor, and the list below it.

import type { Diagnostic } from '@codemirror/lint';
import type { Text } from '@codemirror/state';
import type { Finding, Fix, Position } from '../../wasm/src/types';
import { el } from './dom';
import { range } from './places';

export interface Listener {
  open(path: string, place: { location: Position; end_location: Position }): void;
  fix(fix: Fix): void;
}

const ORDER = ['error', 'warning', 'info', 'hint'];

/** The marks of one file. */
export function diagnostics(findings: Finding[], path: string, text: Text, listener: Listener): Diagnostic[] {
  return findings.filter(({ filename }) => filename === path).map((finding) => ({
    ...range(text, finding),
    severity: finding.severity,
    source: finding.name,
    message: finding.message + (finding.help ? `\nhelp: ${finding.help}` : ''),
    actions: finding.fix ? [{ name: title(finding.fix), apply: () => finding.fix && listener.fix(finding.fix) }] : [],
  }));
}

function title({ message, applicability }: Fix): string {
  const sentence = message.slice(0, 1).toUpperCase() + message.slice(1);
  return applicability === 'safe' ? sentence : `${sentence} (changes the robot)`;
}

/** The page of a rule, in the documentation around the playground. */
function page(name: string): string {
  return `../rules/${name}.html`;
}

/** The list of all findings, the worst first. */
export function list(findings: Finding[], error: string | undefined, listener: Listener): HTMLElement[] {
  const sorted = [...findings].sort((a, b) => ORDER.indexOf(a.severity) - ORDER.indexOf(b.severity));
  const count = (severity: string): number => findings.filter((one) => one.severity === severity).length;
  const counts = ORDER.filter((one) => count(one) > 0).map((one) => `${count(one)} ${one}${count(one) > 1 && one !== 'info' ? 's' : ''}`);
  const head = el('h2', { text: error ?? (counts.join(', ') || 'no findings') });
  return [head, el('ul', {}, ...sorted.map((finding) => row(finding, listener)))];
}

function row(finding: Finding, listener: Listener): HTMLElement {
  const { filename, location, fix, help, name, severity } = finding;
  const place = `${filename}:${location.row}:${location.column}`;
  const button = el('button', { type: 'button', class: 'finding', onclick: () => listener.open(filename, finding) },
    el('span', { class: `severity ${severity}`, text: severity }),
    el('span', { class: 'message', text: finding.message }),
    el('small', { text: finding.places > 1 ? `${place} and ${finding.places - 1} more` : place }));
  const item = el('li', { 'data-rule': name }, button, el('a', { href: page(name), target: '_blank', text: name }));
  if (help) item.append(el('small', { class: 'help', text: `help: ${help}` }));
  if (fix) item.append(el('button', { type: 'button', class: `fix ${fix.applicability}`, onclick: () => listener.fix(fix), text: title(fix) }));
  return item;
}
