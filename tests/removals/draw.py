"""Changes drawn from many workspaces: kinds by turns, removals and renames by turns.

Each leaves a robot that can be expanded, and takes something from it that a file beside it uses. Of one description, one thing of a
kind is taken. Workspaces without anything of a kind give their turn to others.
"""
import collections
import pathlib
import random
import re
import tempfile
import xml.etree.ElementTree

from run import (RENAMED, Removal, applied, beside_files, changed, copied, definitions, descriptions, element, findings, fresh, gives,
                 interfaces_used, is_found, place_of, read, robot, run, tell, uses)

KINDS = ('link', 'joint', 'group', 'interface')
# the definition of a group
GROUP = r'<group\s+name="(%s)"\s*>'
# names of a description that are tried
MOST_NAMES = 12


class Workspace:
    """A copy of a workspace, with the changes that it offers."""

    def __init__(self, command, source, into, chance):
        self.command, self.chance = command, chance
        self.folder = copied(source, into)
        self.before, self.texts = findings(command, self.folder), beside_files(self.folder)
        self.robots = {}
        self.seen = set()
        self.offers = {}

    def told(self, edits):
        """What the linter says of a change that it did not say before."""
        with applied(edits):
            return list(fresh(findings(self.command, self.folder), self.before))

    def next(self, kind, is_rename):
        """The next change of a kind, with the texts that it gives; None when there is no more."""
        if (kind, is_rename) not in self.offers:
            self.offers[kind, is_rename] = self.offered(kind, is_rename)
        return next(self.offers[kind, is_rename], None)

    def shuffled(self, items):
        return self.chance.sample(items, len(items))

    def offered(self, kind, is_rename):
        of_kind = {'group': self.groups, 'interface': self.interfaces}.get(kind, lambda rename: self.named(kind, rename))
        for removal, texts in of_kind(is_rename):
            if (removal.file, removal.start) not in self.seen:
                self.seen.add((removal.file, removal.start))
                yield removal, texts

    def robots_by_chance(self):
        for path in self.shuffled(descriptions(self.folder)):
            if path not in self.robots:
                self.robots[path] = robot(self.command, self.folder, path)
            if self.robots[path]:
                yield self.robots[path]

    def named(self, kind, is_rename):
        """Links or joints."""
        for root, tree, files, beside in self.robots_by_chance():
            texts = {file: read(file) for file in beside}
            names = tree['links'] if kind == 'link' else [joint['name'] for joint in tree['joints']]
            used = [name for name in names if uses(name, texts)]
            for name in self.shuffled(used)[:MOST_NAMES]:
                place = gives(self.command, self.folder, root, kind, name) and place_of(self.command, self.folder, root, files, kind, name)
                if not place:
                    continue
                removal = Removal(kind, name, *place)
                edits = changed(removal, files, is_rename)
                with applied(edits):
                    is_it = self.is_expanded(root) and not gives(self.command, self.folder, root, kind, name)
                if is_it:
                    yield removal, edits
                    break

    def is_expanded(self, root):
        return run(self.command, self.folder, 'expand', root).rstrip().endswith(b'>')

    def groups(self, is_rename):
        """Groups of SRDFs that something in the same package refers to."""
        for file in self.shuffled(sorted(file for file in self.texts if '.srdf' in pathlib.Path(file).name)):
            text = self.texts[file]
            package = package_of(file)
            near = [words for other, words in self.texts.items() if other != file and package in pathlib.Path(other).parents]
            for name in self.shuffled(sorted(set(re.findall(GROUP % '[^"$]+', text)))):
                place = next(definitions(text, 'group', name), None)
                # settings are for all SRDFs of the package: one that has the group is enough
                is_elsewhere = any('<robot' in words and re.search(GROUP % re.escape(name), words) for words in near)
                settings = [] if is_elsewhere else [words for words in near if '<robot' not in words]
                if place and any(refers_to_group(words, name) for words in [text, *settings]):
                    removal = Removal('group', name, file, *place)
                    yield removal, changed(removal, (), is_rename)
                    break

    def hardware(self, root):
        """What the hardware of an expanded robot offers, as (joint, kind, interface)."""
        try:
            tree = xml.etree.ElementTree.fromstring(run(self.command, self.folder, 'expand', root))
        except (RuntimeError, xml.etree.ElementTree.ParseError):
            return set()
        return {(joint.get('name'), inner.tag, inner.get('name')) for joint in tree.iterfind('ros2_control/joint') for inner in joint}

    def interfaces(self, is_rename):
        """Interfaces of hardware that controllers ask for."""
        for root, _, files, beside in self.robots_by_chance():
            wanted = {(joint, kind + '_interface', name) for file in beside if not file.endswith('.srdf')
                      for kind in ('command', 'state') for joint, name in interfaces_used(read(file), kind)}
            needed = wanted and wanted & self.hardware(root)
            if not needed:
                continue
            places = [(file, match) for file in files for match in re.finditer(r'<(?:command|state)_interface\s+name="(\w+)"', read(file))]
            for file, match in self.shuffled(places)[:MOST_NAMES]:
                end = element(read(file), match.start())
                if not end:
                    continue
                removal = Removal('interface', match.group(1), file, match.start(), end)
                edits = changed(removal, (), is_rename)
                with applied(edits):
                    after = self.hardware(root)
                if after and needed - after:
                    yield removal, edits
                    break


def package_of(file):
    """The folder of the package that a file is in; without one, its own."""
    parents = pathlib.Path(file).parents
    return next((folder for folder in parents if (folder / 'package.xml').is_file()), parents[0])


def refers_to_group(text, name):
    """Whether a text refers to a group: in an SRDF, or in settings of MoveIt."""
    word = re.escape(name)
    in_srdf = r'\b(?:parent_)?group="%s"|<group\s+name="%s"\s*/>' % (word, word)
    if '<robot' in text:
        return re.search(in_srdf, re.sub(r'<!--.*?-->', '', text, flags=re.S)) is not None
    is_about_groups = 'kinematics_solver' in text or 'planner_configs' in text
    return is_about_groups and re.search(r'^\s*%s:' % word, text, re.M) is not None or \
        re.search(r'group_name:\s*"?%s"?\s*(#|$)' % word, text, re.M) is not None


def changes(command, folders, options):
    """How many drawn changes were found by kind."""
    chance = random.Random(options.seed)
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as into:
        known = {}
        for number in range(options.count):
            kind, is_rename = KINDS[number % len(KINDS)], number // len(KINDS) % 2 == 1
            for source in chance.sample(folders, len(folders)):
                if source not in known:
                    known[source] = Workspace(command, source, into, chance)
                offer = known[source].next(kind, is_rename)
                if offer:
                    break
            else:
                continue
            workspace, (removal, edits) = known[source], offer
            new = workspace.told(edits)
            if any(RENAMED in message and re.search('unknown|undefined', rule) for rule, _, _, message in new):
                # other robots read a part of it, which was renamed too: then only where the definition is
                new = workspace.told({removal.file: edits[removal.file]})
            found = is_found(removal, new, workspace.folder, workspace.texts)
            counts[kind, found] += 1
            if options.verbose or not found:
                tell(removal, is_rename, workspace.folder, found, new)
    return counts
