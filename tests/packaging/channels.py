"""The files for other channels, filled for a release that there is not, and read by what can be installed from registries."""

import json
import re
import sys
import tomllib

import tree
from common import ROOT, demand, fresh, run, tool

VERSION = "1.2.3"
NAMED = re.compile(r"xacro-lint-[\w-]+\.(?:tar\.gz|zip)")


def files():
    """Every template can be filled, names only what a release has, and is what its reader expects."""
    folder = fresh("channels")
    sums = folder / "SHA256SUMS"
    sums.write_text("".join(f"{number:064x}  {name}\n" for number, name in enumerate(sorted(assets()), 1)))
    filled = folder / "filled"
    run([sys.executable, ROOT / "docs/packaging/fill.py", "owner/name", VERSION, sums, filled])
    for file in filter(lambda file: file.is_file(), filled.rglob("*")):
        text = file.read_text()
        demand("@OWNER" not in text and "@SHA256" not in text and "@VERSION" not in text, f"{file.name} is not filled")
        unknown = set(NAMED.findall(text)) - assets()
        demand(not unknown, f"{file.name}: the release has no {unknown}")

    run([tool("hadolint"), filled / "container/Dockerfile"])
    buildifier = ROOT / "tests/packaging/node_modules/.bin/buildifier"
    run([buildifier, "--mode=check", "--lint=warn", "--warnings=-module-docstring", *sorted((filled / "bazel").iterdir())])
    tree.parse("nix", filled / "nix/flake.nix")
    tree.parse("ruby", filled / "homebrew/xacro-lint.rb")
    # conda-forge says which library of C is meant
    recipe = (
        "import sys\nfrom rattler_build import Stage0Recipe, VariantConfig\n"
        "Stage0Recipe.from_file(sys.argv[1]).render(VariantConfig({'c_stdlib': ['sysroot']}))"
    )
    run([tool("python"), "-c", recipe, filled / "conda/recipe.yaml"])
    for file in [*filled.rglob("*.json")]:
        json.loads(file.read_text())
    for file in [*filled.rglob("*.toml"), ROOT / "editors/zed/Cargo.toml", ROOT / "editors/zed/extension.toml"]:
        tomllib.loads(file.read_text())
    yaml = "import sys, yaml\nfor name in sys.argv[1:]: list(yaml.safe_load_all(open(name)))"
    run([tool("python"), "-c", yaml, *filled.rglob("*.yaml"), *filled.rglob("*.yml")])


def assets():
    """The files of a release that templates may name, from the release workflow."""
    text = (ROOT / ".github/workflows/release.yml").read_text()
    targets = set(re.findall(r"target: ([\w-]+)", text))
    demand(len(targets) == 5, f"release.yml has 5 targets: {targets}")
    demand('"out/xacro-lint-$TARGET.zip"' in text, "release.yml makes a zip for Windows")
    archives = {f"xacro-lint-{target}.tar.gz" for target in targets}
    return archives | {"xacro-lint-x86_64-pc-windows-msvc.zip", f"xacro_lint-{VERSION}.tar.gz"}
