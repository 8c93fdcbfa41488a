"""Makes a failing program smaller while it goes on failing in the same way."""
import copy
import re
import time

ATTRIBUTE = re.compile(r'''\s+[\w:.-]+\s*=\s*("[^"]*"|'[^']*')''')
TOKENS = re.compile(r'(<!--.*?-->|<[^<>]*>)', re.S)


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
