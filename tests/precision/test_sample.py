"""The sample of findings: strata, determinism, files that a copy lacks, figures of a judged sheet."""
import collections
import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import sample  # noqa: E402


def finding(rule, severity='error', row=1, message='something is wrong', filename='urdf/robot.xacro'):
    return {'name': rule, 'severity': severity, 'message': message, 'filename': filename, 'help': None,
            'location': {'row': row, 'column': 3}}


def many(rule, severity, repositories, each):
    """`each` findings of a rule in each of some repositories."""
    return [found for name in range(repositories)
            for found in sample.collect('owner/robot%d' % name, [finding(rule, severity, row) for row in range(each)])]


class Drawing(unittest.TestCase):
    def test_a_rule_and_a_repository_fill_only_their_share(self):
        found = many('wrong-name', 'error', 10, 9) + many('wrong-number', 'error', 1, 40) + many('rare', 'error', 1, 1)
        drawn = sample.draw(found, 'error', 16, 1)
        self.assertEqual(collections.Counter(f.rule for f in drawn), {'wrong-name': 12, 'wrong-number': 3, 'rare': 1})
        self.assertLessEqual(max(collections.Counter(f.repository for f in drawn if f.rule == 'wrong-name').values()), 3)
        warnings = sample.draw(many('wrong-name', 'warning', 10, 9), 'warning', 8, 1)
        self.assertEqual(len(warnings), 8)
        self.assertLessEqual(max(collections.Counter(f.repository for f in warnings).values()), 2)

    def test_too_few_are_filled_up(self):
        drawn = sample.draw(many('wrong-name', 'error', 2, 30), 'error', 20, 1)
        self.assertEqual((len(drawn), len(set(drawn))), (20, 20))
        self.assertEqual(len(sample.draw(many('wrong-name', 'error', 1, 5), 'error', 20, 1)), 5)

    def test_a_rare_rule_is_not_crowded_out(self):
        found = [f for rule in 'abcdefgh' for f in many(rule, 'error', 5, 5)] + many('rare', 'error', 1, 1)
        self.assertIn('rare', {f.rule for f in sample.draw(found, 'error', 20, 1)})

    def test_the_seed_decides(self):
        found = many('wrong-name', 'error', 20, 5)
        self.assertEqual(sample.draw(found, 'error', 12, 7), sample.draw(found[::-1], 'error', 12, 7))
        self.assertNotEqual(sample.draw(found, 'error', 12, 7), sample.draw(found, 'error', 12, 8))

    def test_files_that_the_copy_lacks(self):
        missing = finding('mesh-not-found', message='mesh `package://p/meshes/arm.stl` is not found')
        self.assertEqual(sample.collect('o/r', [missing], ['p/meshes/arm.stl', '']), [])
        self.assertEqual(len(sample.collect('o/r', [missing], ['p/meshes/leg.stl'])), 1)
        self.assertEqual(len(sample.collect('o/r', [missing], ['p/meshes/rm.stl', 'forearm.stl'])), 1)
        leg = {**missing, 'message': '`package://p/meshes/leg.stl`', 'location': {'row': 7, 'column': 1}}
        group = {**missing, 'related': [leg]}
        self.assertEqual([f.place for f in sample.collect('o/r', [group], ['p/meshes/arm.stl'])], ['urdf/robot.xacro:7:1'])
        self.assertEqual(sample.collect('o/r', [group], ['p/meshes/arm.stl', 'p/meshes/leg.stl']), [])
        call = {**missing, 'related': [{'message': 'in this call: eye:=libeye.so body:=leg.stl'}]}
        self.assertEqual(sample.collect('o/r', [call], ['p/meshes/arm.stl']), [])
        library = finding('mesh-not-found', message='mesh `libarm.so` is not found')
        self.assertEqual(len(sample.collect('o/r', [library], ['p/libarm.so'])), 1)
        folder = finding('installed-file-not-found', message='folder `meshes/` to install does not exist', filename='CMakeLists.txt')
        self.assertEqual(sample.collect('o/r', [folder], ['meshes/arm.stl']), [])
        self.assertEqual(len(sample.collect('o/r', [folder], ['meshes2/arm.stl'])), 1)
        other = finding('include-not-found', message='arm.stl is not found')
        self.assertEqual(len(sample.collect('o/r', [other], ['p/meshes/arm.stl'])), 1)

    def test_only_errors_and_warnings(self):
        found = sample.collect('o/r', [finding('a', 'info'), finding('b', 'hint'), finding('c', 'warning')])
        self.assertEqual([f.rule for f in found], ['c'])


class Checkouts(unittest.TestCase):
    def test_no_workspace(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, expected in (('src', 2), ('checkouts', 0)):
                pathlib.Path(folder, name).mkdir()
                command = [sys.executable, sample.__file__, name, '--bin', 'none', '--seed', '1', '--out', 'sheet.csv']
                run = subprocess.run(command, cwd=folder, capture_output=True, check=False)
                self.assertEqual(run.returncode, expected, run.stderr)


class Summary(unittest.TestCase):
    def sheet(self, verdicts):
        folder = self.enterContext(tempfile.TemporaryDirectory()) if hasattr(self, 'enterContext') else tempfile.mkdtemp()
        path = pathlib.Path(folder, 'sheet.csv')
        sample.write_sheet(path, many('wrong, "name"', 'error', 1, len(verdicts)))
        with open(path, encoding='utf-8', newline='') as text:
            rows = list(csv.DictReader(text))
        with open(path, 'w', encoding='utf-8', newline='') as text:
            out = csv.DictWriter(text, sample.COLUMNS)
            out.writeheader()
            out.writerows({**row, 'verdict': verdict} for row, verdict in zip(rows, verdicts))
        return path

    def test_figures(self):
        text = sample.summary(self.sheet(['true', 'True', 'false', 'doubtful', 'noise', '']))
        self.assertIn('| wrong, "name" | error | 6 | 2 | 1 | 1 | 1 | 40.0 % |', text)
        self.assertIn('| all | error | 6 | 2 | 1 | 1 | 1 | 40.0 % |', text)
        self.assertIn('1 of 6 findings are not judged yet', text)

    def test_an_unknown_verdict_is_an_error(self):
        with self.assertRaisesRegex(ValueError, 'row 3: unknown verdict `yes`'):
            sample.summary(self.sheet(['true', 'yes']))


if __name__ == '__main__':
    unittest.main()
