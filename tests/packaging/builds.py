"""What is handed out: wheel, crate, static program."""

import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import zipfile

from common import EXAMPLES, ROOT, TARGET, WORK, Failed, demand, fresh, run, tool
from hooks import QUICK

# What crates.io takes, in bytes.
MOST_CRATE = 10 * 1024 * 1024

BROKEN = EXAMPLES / "broken_cell"

# How the programs of a release for Linux are linked.
STATIC = "-C target-feature=+crt-static"


def finds_defects(program):
    """The program checks an example and finds what is wrong with it."""
    printed = run([program, "check", "--format", "concise", BROKEN], code=1)
    demand("[undefined-macro]" in printed, printed)


def wheel():
    """The wheel holds both programs and installs into a clean environment."""
    wheels = fresh("wheel")
    # the objects of `cargo build --release` are used again
    command = [tool("maturin"), "build", "--release", "--locked", "--compatibility", "linux", "--out", wheels]
    run(command, CARGO_TARGET_DIR=TARGET)
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


def crate():
    """The crate is small enough, holds what it needs and nothing else, and builds from itself."""
    # verifying compiles the unpacked crate, beside the objects of the tests
    run(["cargo", "package", "--locked", "--allow-dirty", "--quiet"], CARGO_TARGET_DIR=TARGET)
    file = max((TARGET / "package").glob("xacro-lsp-*.crate"), key=lambda path: path.stat().st_mtime)
    size = file.stat().st_size
    demand(size < MOST_CRATE, f"{file.name} has {size} bytes")
    with tarfile.open(file) as archive:
        names = [pathlib.PurePath(name).parts[1:] for name in archive.getnames()]
    tops = {parts[0] for parts in names}
    demand({"src", "docs", "build.rs", "README.md", "LICENSE-MIT", "LICENSE-APACHE", "Cargo.lock"} <= tops, tops)
    demand(not tops & {"tests", ".ci", ".github", "target"}, tops)
    print(f"   {file.name}, {size / 1e6:.1f} MB, {len(names)} files")
    # the source distribution holds the same, and what pip needs
    folder = fresh("sdist")
    run([tool("maturin"), "sdist", "--out", folder])
    (source,) = folder.glob("*.tar.gz")
    with tarfile.open(source) as archive:
        held = {pathlib.PurePath(name).parts[1:] for name in archive.getnames()}
    made = {(name,) for name in (".cargo_vcs_info.json", "Cargo.toml.orig")}
    missing = set(names) - held - made
    demand(not missing and ("pyproject.toml",) in held, f"missing in {source.name}: {sorted(missing)[:5]}")


def static():
    """A static program runs where there is nothing else: no libraries, no shell, no folders."""
    host = next(line for line in run(["rustc", "-vV"]).splitlines() if line.startswith("host: ")).split()[1]
    for workflow in ("release", "vscode"):
        text = (ROOT / f".github/workflows/{workflow}.yml").read_text()
        demand("linux-musl" not in text and text.count(STATIC) == 2, f"{workflow}.yml builds static programs for Linux")
    command = ["cargo", "build", "--release", "--locked", "--quiet", "--bin", "xacro-lint", "--target", host]
    run([*command, "--no-default-features", "--features", "cli"], **QUICK, RUSTFLAGS=STATIC)
    program = QUICK["CARGO_TARGET_DIR"] / host / "release/xacro-lint"
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
