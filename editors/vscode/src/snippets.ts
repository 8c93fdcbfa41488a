/**
 * Reading snippets.
 */

/** The first tab stop, after a quote or slash, without a text or choices of its own. */
const EMPTY_VALUE = /^[^$\\]*(?:\\.[^$\\]*)*["'/](?:\$1(?!\d)|\$\{1\})/;

/** Whether a snippet leaves the cursor in an empty attribute value, or after a part of a path. */
export function startsEmptyValue(snippet: string): boolean {
  return EMPTY_VALUE.test(snippet);
}
