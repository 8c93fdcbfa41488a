"""Makes a failing program smaller while it goes on failing in the same way."""
import copy
import re
import time

ATTRIBUTE = re.compile(r'''\s+[\w:.-]+\s*=\s*("[^"]*"|'[^']*')''')
TAG = re.compile(r'<!--.*?-->|<!\[CDATA\[.*?\]\]>|<(/?)[^\s<>/!?"\'=]+', re.S)
TOKENS = re.compile(r'(<!--.*?-->|<[^<>]*>)', re.S)


def tag_end(text, at):
    """Where the tag ends that is open at `at`; quoted values may hold `>`."""
    while at < len(text) and text[at] != '>':
        if text[at] in '"\'':
            at = text.find(text[at], at + 1)
            if at < 0:
                return len(text)
        at += 1
    return at + 1


def elements(text):
    """(start, end of the start tag, start of the end tag, end) of each element but the outermost."""
    found, open_tags = [], []
    for tag in TAG.finditer(text):
        if tag.group(1) is None:
            continue
        end = tag_end(text, tag.end())
        if tag.group(1):
            if open_tags:
                start, inner = open_tags.pop()
                found.append((start, inner, tag.start(), end))
        elif text[end - 2] == '/':
            found.append((tag.start(), end, end, end))
        else:
            open_tags.append((tag.start(), end))
    return [span for span in found if span[3] - span[0] < len(text.strip()) * 0.98 or span[0] > 200]


class Minimiser:
    """`fails(program)` tells whether a program still shows the difference."""

    def __init__(self, fails, seconds):
        self.fails, self.end = fails, time.monotonic() + seconds

    def out_of_time(self):
        return time.monotonic() > self.end

    def run(self, program):
        """The smallest program found."""
        best = copy.deepcopy(program)
        size = None
        while size != self.size(best) and not self.out_of_time():
            size = self.size(best)
            best = self.without_files(best)
            best = self.without_arguments(best)
            for path in sorted(best.files, key=lambda p: -len(best.files[p])):
                best = self.fewer_elements(best, path)
            for split in (self.by_lines, self.by_tokens, self.by_attributes, self.by_characters):
                for path in sorted(best.files, key=lambda p: -len(best.files[p])):
                    best = self.shorter_file(best, path, split)
        return best

    def size(self, program):
        return sum(len(data) for data in program.files.values()), len(program.files), len(program.args)

    def attempt(self, best, change):
        """The program after `change(copy)`, if it still fails, else `best`."""
        if self.out_of_time():
            return best
        candidate = copy.copy(best)
        candidate.files, candidate.args, candidate.env = dict(best.files), list(best.args), dict(best.env)
        change(candidate)
        return candidate if self.fails(candidate) else best

    def without_files(self, best):
        for path in list(best.files):
            if path != 'input.xacro':
                best = self.attempt(best, lambda p, path=path: p.files.pop(path))
        return best

    def without_arguments(self, best):
        for arg in list(best.args):
            best = self.attempt(best, lambda p, arg=arg: p.args.remove(arg))
        for name in list(best.env):
            best = self.attempt(best, lambda p, name=name: p.env.pop(name))
        return best

    def fewer_elements(self, best, path):
        """Leave out whole elements, the largest first; put others' content in their place."""
        tried = 0
        while not self.out_of_time():
            text = best.files[path].decode('utf-8', 'replace')
            found = sorted(elements(text), key=lambda e: e[0] - e[3])
            if tried >= 2 * len(found):
                return best
            start, inner, inner_end, end = found[tried // 2]
            kept = text[inner:inner_end] if tried % 2 else ''
            if tried % 2 and inner == end:
                tried += 1
                continue
            after = self.attempt(best, lambda p: p.files.__setitem__(path, (text[:start] + kept + text[end:]).encode()))
            tried += after is best
            best = after
        return best

    def shorter_file(self, best, path, split):
        """Leave out pieces of one file: ever smaller runs of what `split` gives."""
        try:
            pieces = split(best.files[path].decode())
        except UnicodeDecodeError:
            return best
        step = max(1, len(pieces) // 2)
        while pieces and not self.out_of_time():
            start, shrunk = 0, False
            while start < len(pieces):
                rest = pieces[:start] + pieces[start + step:]
                after = self.attempt(best, lambda p, rest=rest: p.files.__setitem__(path, ''.join(rest).encode()))
                if after is best:
                    start += step
                else:
                    best, pieces, shrunk = after, rest, True
            if step == 1 and not shrunk:
                break
            step = step if shrunk and step == 1 else max(1, step // 2)
        return best

    def by_lines(self, text):
        return text.splitlines(keepends=True)

    def by_tokens(self, text):
        return [piece for piece in TOKENS.split(text) if piece]

    def by_attributes(self, text):
        """Attributes one by one, and what stands between them."""
        pieces, end = [], 0
        for found in ATTRIBUTE.finditer(text):
            pieces += [text[end:found.start()], found.group()]
            end = found.end()
        return [piece for piece in pieces + [text[end:]] if piece]

    def by_characters(self, text):
        """Characters, once the file is small."""
        return list(text) if len(text) < 1200 else [text]
