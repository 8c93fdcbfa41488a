#!/usr/bin/env bash
# Build the site of docs/ into target/site, with mdBook of a fixed version.
#
#   tests/site/build.sh [mdbook arguments, such as --open]
set -eu
cd "$(dirname "$0")/../.."

version=0.5.4
tools="$PWD/target/site-tools"
if [ "$("$tools/bin/mdbook" --version 2>/dev/null)" != "mdbook v$version" ]; then
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
