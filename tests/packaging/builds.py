"""What is handed out: wheel, crate, static program."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile

from common import EXAMPLES, RELEASE, ROOT, TARGET, WORK, Failed, demand, fresh, run, snippet, tool
from hooks import STATIC, quick

# What crates.io takes, in bytes.
MOST_CRATE = 10 * 1024 * 1024

BROKEN = EXAMPLES / "broken_cell"


def finds_defects(program):
    """The program checks an example and finds what is wrong with it."""
    printed = run([program, "check", "--format", "concise", BROKEN], code=1)
    demand("[undefined-macro]" in printed, printed)


def linked_target():
    """The objects of `cargo build --release` once more, by hard links: they are used again, and the programs that they were linked to
    stay where other suites run them, while maturin moves its own."""
    target = fresh("wheel-target")
    shutil.copytree(RELEASE, target / "release", copy_function=os.link, symlinks=True)
    return target


def wheel():
    """The wheel holds both programs and installs into a clean environment."""
    wheels = fresh("wheel")
    command = [tool("maturin"), "build", "--release", "--locked", "--compatibility", "linux", "--out", wheels]
    run(command, CARGO_TARGET_DIR=linked_target())
    (file,) = wheels.glob("xacro_lint-*.whl")
    clean = fresh("wheel-environment")
    run([sys.executable, "-m", "venv", clean])
    run([clean / "bin/pip", "install", "--quiet", "--no-index", file])
    with zipfile.ZipFile(file) as archive:
        (name,) = (name for name in archive.namelist() if name.endswith(".dist-info/METADATA"))
        metadata = archive.read(name).decode()
    version = run([clean / "bin/xacro-lint", "--version"])
    for line in ["License-Expression: MIT OR Apache-2.0", f"Version: {version.split()[-1]}"]:
        demand(f"\n{line}\n" in metadata, f"{line} is missing in\n{metadata[:2000]}")
    finds_defects(clean / "bin/xacro-lint")
    demand("xacro-lsp" in run([clean / "bin/xacro-lsp", "--version"]), "the server runs")
    # and runs without being installed
    command = [tool("uvx"), "--offline", "--no-config", "--from", file, "xacro-lint", "--version"]
    demand(version in run(command, UV_CACHE_DIR=fresh("uv-cache")), "uvx runs the program")
    print(f"   {file.name}, {file.stat().st_size / 1e6:.1f} MB")


# errors, warnings of xacro, and names that look like options
MISUSE = """
import pathlib, warnings
import xacro_lint

for call, text in [
    (lambda: xacro_lint.expand("broken_cell/src/broken_cell/urdf/broken_cell.xacro"), "reference_bals"),
    (lambda: xacro_lint.expand("nowhere.xacro"), "No such file or directory"),
    (lambda: xacro_lint.expand("--help"), "No such file or directory"),
    (lambda: xacro_lint.check(select=["no-such-rule"]), "unknown rule `no-such-rule`"),
]:
    try:
        print(call())
    except xacro_lint.XacroError as problem:
        assert text in str(problem), problem
    else:
        raise AssertionError(text)
finding = xacro_lint.check("broken_cell", select="undefined-macro")[0]
assert (finding.severity, finding.row, finding.column) == ("error", 19, 3), finding
assert all(isinstance(path, pathlib.Path) for path in xacro_lint.files_read("defects/urdf/" + FILE))
"""


def python():
    """The typed package of the wheel: the page's example, wrong uses, types; as a module; from `pip install --target`."""
    environment = WORK / "wheel-environment"
    program = environment / "bin/python"
    demand(program.is_file(), "the step `wheel` comes first")
    plain = {"PATH": "/usr/bin:/bin", "PYTHONDONTWRITEBYTECODE": "1"}
    file = sorted((EXAMPLES / "defects/urdf").iterdir())[0].name
    run([program, "-c", snippet("python.md", "python-api")], cwd=EXAMPLES, **plain)
    run([program, "-c", f"FILE = {file!r}\n{MISUSE}"], cwd=EXAMPLES, **plain)
    version = run([environment / "bin/xacro-lint", "--version"])
    demand(run([program, "-m", "xacro_lint", "--version"], **plain) == version, "it runs as a module")
    (file,) = (WORK / "wheel").glob("xacro_lint-*.whl")
    target = fresh("wheel-target")
    run([environment / "bin/pip", "install", "--quiet", "--no-index", "--target", target, file])
    command = [sys.executable, "-c", "import xacro_lint; print(xacro_lint.find_program())"]
    demand(run(command, PYTHONPATH=target, **plain).strip() == str(target / "bin/xacro-lint"), "its own program")
    with zipfile.ZipFile(file) as archive:
        demand("xacro_lint/py.typed" in archive.namelist(), "py.typed")
    uses = fresh("wheel-types") / "uses.py"
    uses.write_text(snippet("python.md", "python-api"))
    run([tool("mypy"), "--strict", "--python-executable", program, "--cache-dir", uses.parent / "cache", uses])
    run([tool("mypy"), "--strict", "--cache-dir", uses.parent / "cache", ROOT / "editors/python/xacro_lint"])


def crate():
    """The crates are small enough, hold what they need and nothing else, and build from themselves."""
    target = fresh("crates")
    run(["cargo", "package", "--workspace", "--locked", "--allow-dirty", "--no-verify", "--quiet"], CARGO_TARGET_DIR=target)
    sources, held, size = fresh("crate-sources"), {}, 0
    for file in sorted((target / "package").glob("*.crate")):
        demand(file.stat().st_size < MOST_CRATE, f"{file.name} has {file.stat().st_size} bytes")
        size += file.stat().st_size
        with tarfile.open(file) as archive:
            archive.extractall(sources, filter="data")
            held[file.stem] = {pathlib.PurePath(name).parts[1:] for name in archive.getnames()}
    # all files of a package have one date, by which cargo would take those of an earlier run for these
    for file in sources.rglob("*"):
        file.touch()
    (root,) = (names for stem, names in held.items() if re.fullmatch(r"xacro-lsp-[\d.]+", stem))
    tops = {parts[0] for parts in root}
    demand({"src", "README.md", "LICENSE-MIT", "LICENSE-APACHE", "Cargo.lock"} <= tops, tops)
    demand(not tops & {"tests", ".ci", ".github", "target", "editors"}, tops)
    for name, needed in {"docs": ("rules", "mesh-not-found.md"), "viewer": ("dist", "viewer.js"), "rules": ("lib.rs",)}.items():
        (own,) = (names for stem, names in held.items() if stem.startswith(f"xacro-lsp-{name}-"))
        demand(needed in own, f"{'/'.join(needed)} is missing in the crate of {name}")
    check_unpacked(sources, held)
    print(f"   {len(held)} crates, {size / 1e6:.1f} MB")
    sdist(root)


def check_unpacked(sources, stems):
    """The unpacked crates compile with each other, and with nothing of the checkout."""
    (root,) = (sources / stem for stem in stems if re.fullmatch(r"xacro-lsp-[\d.]+", stem))
    others = {re.sub(r"-[\d.]+$", "", stem): sources / stem for stem in stems if sources / stem != root}
    patches = "".join(f'{name} = {{ path = "{folder}" }}\n' for name, folder in others.items())
    (sources / ".cargo").mkdir()
    (sources / ".cargo/config.toml").write_text(f"[patch.crates-io]\n{patches}")
    (root / "Cargo.lock").unlink()
    shutil.copy2(ROOT / "Cargo.lock", root)
    # the dependencies are checked already, as clippy did it
    run(["cargo", "check", "--quiet"], cwd=root, CARGO_TARGET_DIR=TARGET)


def sdist(crate_names):
    """The source distribution holds what the crate does, and what pip needs."""
    folder = fresh("sdist")
    run([tool("maturin"), "sdist", "--out", folder])
    (source,) = folder.glob("*.tar.gz")
    with tarfile.open(source) as archive:
        held = {pathlib.PurePath(name).parts[1:] for name in archive.getnames()}
    made = {(name,) for name in (".cargo_vcs_info.json", "Cargo.toml.orig")}
    needed = (crate_names - made) | {("pyproject.toml",), ("editors", "viewer", "dist", "viewer.js"), ("src", "rules", "lib.rs")}
    demand(needed <= held, f"missing in {source.name}: {sorted(needed - held)[:5]}")


def static():
    """A static program runs where there is nothing else: no libraries, no shell, no folders."""
    for workflow in ("release", "vscode"):
        text = (ROOT / f".github/workflows/{workflow}.yml").read_text()
        demand("linux-musl" not in text and text.count(STATIC) == 2, f"{workflow}.yml builds static programs for Linux")
    variables = quick()
    run(["cargo", "build", "--release", "--locked", "--quiet"], **variables)
    host = variables["CARGO_BUILD_TARGET"]
    program = variables["CARGO_TARGET_DIR"] / host / "release/xacro-lint"
    headers = run(["readelf", "--program-headers", program])
    demand("INTERP" not in headers, f"the program asks for a loader:\n{headers}")
    if os.geteuid() != 0:
        print("   skip the empty root: only root may change it")
        return
    empty = fresh("empty-root")
    shutil.copy2(program, empty)
    for part in ("src", "xacro-lint.toml"):
        if (BROKEN / part).is_dir():
            shutil.copytree(BROKEN / part, empty / part)
    done = subprocess.run(
        ["chroot", empty, "/xacro-lint", "check", "--format", "concise"],
        env={"PATH": os.environ["PATH"]}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
    )
    if "Operation not permitted" in done.stdout and done.returncode == 125:
        print("   skip the empty root: it may not be changed here")
        return
    if done.returncode != 1 or "[undefined-macro]" not in done.stdout:
        raise Failed(f"in an empty root it ended with {done.returncode}:\n{done.stdout}")
    print(f"   {host}, {program.stat().st_size / 1e6:.1f} MB without optimisation")
