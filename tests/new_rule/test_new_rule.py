"""A rule that the script begins: its file, the two lines in its category, its page."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import new_rule  # noqa: E402

HEADINGS = ['Why', 'Reported', 'Not reported', 'How to fix it', 'When to allow it', 'Source']


def begin(test, *arguments, category='conventions'):
    """Run the script on a copy of a category, which is removed after the test; the folders, and what it printed."""
    root = pathlib.Path(tempfile.mkdtemp(prefix='new-rule-'))
    test.addCleanup(shutil.rmtree, root)
    shutil.copytree(new_rule.ROOT / 'src/rules' / category, root / 'src/rules' / category)
    shutil.copy(new_rule.ROOT / 'Cargo.toml', root)
    (root / 'docs/rules').mkdir(parents=True)
    (root / 'docs/rules/taken-name.md').touch()
    done = subprocess.run([sys.executable, new_rule.__file__, *arguments, '--root', root], capture_output=True, text=True)
    return root, root / 'src/rules' / category, done


class Begun(unittest.TestCase):
    def test_file_lines_and_page(self):
        root, folder, done = begin(self, 'conventions', 'capital-letter-in-link-name', '--severity', 'info', '--off')
        self.assertEqual(done.returncode, 0, done.stderr)
        rule = (folder / 'capital_letter_in_link_name.rs').read_text()
        code = re.search(r'code: "(CNV\d{3})"', rule)[1]
        others = ''.join(path.read_text() for path in (new_rule.ROOT / 'src/rules/conventions').glob('*.rs'))
        self.assertNotIn(code, others)
        for line in ('Category::Conventions', 'Severity::Info', 'Activation::Off', 'Check::Document(check)'):
            self.assertIn(line, rule)
        listing = (folder / 'mod.rs').read_text()
        modules = re.findall(r'^mod (\w+);', listing, re.MULTILINE)
        self.assertEqual(modules, sorted(modules))
        self.assertRegex(listing, r'RULES(.|\n)*\n    &capital_letter_in_link_name::RULE,\n\];')
        page = (root / 'docs/rules/capital-letter-in-link-name.md').read_text()
        self.assertEqual(page.splitlines()[0], '# capital-letter-in-link-name')
        self.assertRegex(page.splitlines()[2], rf'^`{code}` · info · off by default · no fix · since 0\.\d+$')
        self.assertEqual(re.findall(r'^## (.*)$', page, re.MULTILINE), HEADINGS)
        self.assertTrue(all(f'```urdf,{kind}' in page for kind in ('bad', 'good')))

    def test_each_kind_of_check(self):
        for kind, (variant, context, looks_at) in new_rule.CHECKS.items():
            _, folder, done = begin(self, 'conventions', 'wrong-thing', '--check', kind)
            self.assertEqual(done.returncode, 0, done.stderr)
            rule = (folder / 'wrong_thing.rs').read_text()
            self.assertIn(f'check: Check::{variant}(check)', rule)
            self.assertIn(f'_cx: &{context}<', rule)
            if looks_at:
                self.assertIn(f'_{kind}: &{looks_at.split("::")[-1]},', rule)

    def test_names_that_are_refused(self):
        for arguments in (('conventions', 'Wrong'), ('conventions', 'taken-name'), ('nowhere', 'wrong-thing')):
            _, _, done = begin(self, *arguments)
            self.assertNotEqual(done.returncode, 0)
            self.assertTrue(done.stderr.startswith('new_rule: '), done.stderr)


if __name__ == '__main__':
    unittest.main()
