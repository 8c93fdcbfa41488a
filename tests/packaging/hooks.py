"""pre-commit itself: hooks built from source (`language: rust`) and hooks from the wheel."""

import re
import shutil
import sys
import time

from common import ROOT, TARGET, WORK, blocks, demand, fresh, run, tool, with_tools
from fixture import BROKEN_MAST, CROOKED, FIXABLE, LIFTER, MAST, Repository

# How the programs of a release for Linux are linked.
STATIC = "-C target-feature=+crt-static"


def quick():
    """Variables of a build where seconds count, not the speed of the program. All such builds share their objects."""
    host = next(line for line in run(["rustc", "-vV"]).splitlines() if line.startswith("host: ")).split()[1]
    return {
        "CARGO_TARGET_DIR": TARGET / "packaging/quick",
        "CARGO_BUILD_TARGET": host,
        "CARGO_PROFILE_RELEASE_OPT_LEVEL": "0",
        "CARGO_PROFILE_RELEASE_CODEGEN_UNITS": "16",
        "CARGO_PROFILE_RELEASE_STRIP": "none",
        "RUSTFLAGS": STATIC,
    }


def manifest():
    """pre-commit accepts the list of hooks, and they take the files that are meant."""
    run([tool("pre-commit"), "validate-manifest", ROOT / ".pre-commit-hooks.yaml"])


def source():
    """A commit that breaks a robot by a file that it includes is stopped, by hooks that pre-commit builds with cargo."""
    hooks = sources()
    repository = Repository("hooks-source", {})
    repository.write("urdf/mast.xacro", BROKEN_MAST)
    home = fresh("pre-commit-source")
    variables = {"PATH": with_tools(), "PRE_COMMIT_HOME": home, **quick()}

    rev = run(["git", "rev-parse", "HEAD"], cwd=hooks).strip()
    names = ["xacro-lint", "xacro-lint-fix", "xacro-format"]
    lines = [f"repos:\n- repo: {hooks}\n  rev: {rev}\n  hooks:\n"] + [f"  - id: {name}\n" for name in names]
    repository.write(".pre-commit-config.yaml", "".join(lines))
    scenario(repository, variables)


def wheel():
    """The same by the wheel, with the configuration of docs/pre-commit.md."""
    wheels = list((WORK / "wheel").glob("*.whl"))
    demand(len(wheels) == 1, "the step `wheel` comes first")
    local = [text for text in blocks("pre-commit.md", "yaml") if "repo: local" in text]
    demand(len(local) == 1, "docs/pre-commit.md has one configuration for the wheel")
    repository = Repository("hooks-wheel", {})
    repository.write("urdf/mast.xacro", BROKEN_MAST)
    fixing, formatting = hook(local[0], "xacro-lint-fix"), hook(local[0], "xacro-format")
    fixing = fixing.replace("xacro-lint check", "xacro-lint fix")
    formatting = formatting.replace("xacro-lint check --changed --format concise", "xacro-lint format")
    repository.write(".pre-commit-config.yaml", local[0] + fixing + formatting)
    home, index = fresh("pre-commit-wheel"), fresh("index")
    # pre-commit builds an empty package of its own with it
    run([tool("pip"), "download", "--quiet", "--no-deps", "--dest", index, "setuptools"])
    # nothing from PyPI takes the place of the wheel
    links = f"{WORK / 'wheel'} {index}"
    variables = {"PATH": with_tools(), "PRE_COMMIT_HOME": home, "PIP_FIND_LINKS": links, "PIP_NO_INDEX": "1"}
    scenario(repository, variables)


def mirror():
    """The same by the mirror, whose hooks install the wheel."""
    wheels = list((WORK / "wheel").glob("*.whl"))
    demand(len(wheels) == 1, "the step `wheel` comes first")
    filled = fresh("filled")
    sums = filled / "SHA256SUMS"
    version = re.search(r"xacro_lint-([^-]+)-", wheels[0].name)[1]
    names = set(re.findall(r"@SHA256:([^@]+(?:@VERSION@[^@]*)?)@", templates()))
    sums.write_text("".join(f"{'0' * 64}  {name.replace('@VERSION@', version)}\n" for name in names))
    run([sys.executable, ROOT / "docs/packaging/fill.py", "owner/name", version, sums, filled])
    hooks = filled / "pre-commit-mirror"
    run([tool("pre-commit"), "validate-manifest", hooks / ".pre-commit-hooks.yaml"])
    same = (ROOT / ".pre-commit-hooks.yaml").read_text().replace("language: rust", "language: python")
    demand(same.split("\n-")[1:] == (hooks / ".pre-commit-hooks.yaml").read_text().split("\n-")[1:], "the hooks are the same")
    commit_all(hooks)

    index = fresh("mirror-index")
    run([tool("pip"), "download", "--quiet", "--no-deps", "--dest", index, "setuptools"])
    links = {"PIP_FIND_LINKS": f"{WORK / 'wheel'} {index}", "PIP_NO_INDEX": "1"}
    variables = {"PATH": with_tools(), "PRE_COMMIT_HOME": fresh("pre-commit-mirror"), **links}
    repository = Repository("hooks-mirror", {})
    repository.write("urdf/mast.xacro", BROKEN_MAST)
    rev = run(["git", "rev-parse", "HEAD"], cwd=hooks).strip()
    listed = "".join(f"  - id: {name}\n" for name in ["xacro-lint", "xacro-lint-fix", "xacro-format"])
    repository.write(".pre-commit-config.yaml", f"repos:\n- repo: {hooks}\n  rev: {rev}\n  hooks:\n{listed}")
    start = time.monotonic()
    run([tool("pre-commit"), "install-hooks"], cwd=repository.folder, **variables)
    print(f"   installed in a fresh cache in {time.monotonic() - start:.1f} s")
    scenario(repository, variables)


def templates():
    """The text of all templates."""
    files = (file for file in (ROOT / "docs/packaging").rglob("*") if file.is_file() and file.suffix != ".pyc")
    return "".join(file.read_text() for file in files)


def commit_all(folder):
    """A repository of what is in a folder."""
    run(["git", "init", "--quiet"], cwd=folder)
    run(["git", "add", "."], cwd=folder)
    person = ["-c", "user.name=Nobody", "-c", "user.email=nobody@example.org"]
    run(["git", *person, "commit", "--quiet", "--message", "Sources"], cwd=folder)


def hook(configuration, name):
    """The hook of a configuration under another name."""
    own = configuration[configuration.index("      - id:") :]
    return own.replace("id: xacro-lint\n", f"id: {name}\n").replace("name: xacro-lint\n", f"name: {name}\n")


def sources():
    """The sources as they are here, changes that are not committed too, as a repository for pre-commit."""
    folder = fresh("hooks-repository")
    listed = run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"])
    for name in filter(None, listed.split("\0")):
        path = ROOT / name
        # what a build needs, and the hooks
        top = name.split("/")[0]
        if top in ("src", "docs", "Cargo.toml", "Cargo.lock", ".pre-commit-hooks.yaml") or name.startswith("editors/viewer/"):
            if path.is_file():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(path, folder / name)
    commit_all(folder)
    return folder


def expect_defect(printed):
    demand("urdf/mast.xacro:8:26: error: property `hight` is not defined" in printed, printed)
    demand("cart" not in printed, f"a robot that does not include the changed file is no news:\n{printed}")


def scenario(repository, variables):
    """Commits that the hooks stop, and those that they let pass."""
    run([tool("pre-commit"), "install"], cwd=repository.folder, **variables)
    repository.git("add", ".")
    # the robot includes the changed file; only that one is passed
    expect_defect(repository.commit("Mast", code=1, **variables))
    # right, and with something left to be committed
    repository.write("urdf/mast.xacro", MAST.replace("  <xacro:macro", "  <!-- a mast -->\n  <xacro:macro"))
    repository.git("add", ".")
    repository.commit("Mast", **variables)

    repository.write("urdf/lifter.urdf.xacro", FIXABLE)
    repository.git("add", ".")
    printed = repository.commit("Comment", code=1, **variables)
    demand("files were modified by this hook" in printed, printed)
    demand(repository.read("urdf/lifter.urdf.xacro") == LIFTER, "the hook deletes the comment")

    repository.write("urdf/lifter.urdf.xacro", CROOKED)
    repository.git("add", ".")
    printed = repository.commit("Indentation", code=1, **variables)
    demand("formatted 1 file" in printed, printed)
    demand(repository.read("urdf/lifter.urdf.xacro") == LIFTER, "the hook indents the file")
    # files of other kinds are nobody's business
    repository.git("reset", "--quiet", "--hard")
    repository.write("README.md", "a robot\n")
    repository.git("add", ".")
    printed = repository.commit("Text", **variables)
    demand("no files to check" in printed, printed)
