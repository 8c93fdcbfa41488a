"""What is excluded, and what the result holds."""

import xml.etree.ElementTree as ElementTree

from ament_xacro_lint import main as linter

ROBOT = '<robot name="r"><link name="a"/><joint name="j" type="fixed"><parent link="a"/><child link="{}"/></joint><link name="b"/></robot>'


def run(folder, monkeypatch, *options):
    """The exit code, and the result file."""
    monkeypatch.chdir(folder)
    code = linter.main(["--xunit-file", "results/xacro_lint.xunit.xml", *options])
    return code, ElementTree.parse(folder / "results/xacro_lint.xunit.xml").getroot()


def test_findings_fail(tmp_path, monkeypatch):
    (tmp_path / "r.urdf").write_text(ROBOT.format("c"))
    code, suite = run(tmp_path, monkeypatch)
    assert code == 1
    assert int(suite.get("failures")) == len(suite.findall("testcase/failure")) > 0


def test_excluded_files_are_not_reported(tmp_path, monkeypatch):
    (tmp_path / "old").mkdir()
    (tmp_path / "old/r.urdf").write_text(ROBOT.format("c"))
    (tmp_path / "s.urdf").write_text(ROBOT.format("b"))
    for pattern in ["old", "old/r.urdf", "r.*"]:
        code, suite = run(tmp_path, monkeypatch, "--exclude", pattern)
        assert (code, suite.get("failures")) == (0, "0")


def test_nothing_to_check_passes(tmp_path, monkeypatch):
    code, suite = run(tmp_path, monkeypatch)
    assert (code, suite.get("tests"), suite.get("failures")) == (0, "1", "0")


def test_a_missing_program_fails_and_says_what_to_type(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(linter, "find_program", lambda: None)
    code, suite = run(tmp_path, monkeypatch)
    assert code == 1
    assert "pip install xacro-lint" in suite.find("testcase/failure").get("message")
    assert "pip install xacro-lint" in capsys.readouterr().err


def test_wrong_options_fail(tmp_path, monkeypatch):
    code, suite = run(tmp_path, monkeypatch, "--args", "--select", "no-such-rule")
    assert code == linter.UNUSABLE
    assert "no-such-rule" in suite.find("testcase/failure").get("message")
