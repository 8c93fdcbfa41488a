#!/usr/bin/env bash
# Find or install xacro-lint for the action; its path becomes the output `program`.
#
# Read: INSTALL, PROGRAM, VERSION, REPOSITORY, SERVER, ACTION (see action.yml); RUNNER_TEMP, GITHUB_OUTPUT.
set -euo pipefail

fail() { echo "::error title=xacro-lint::$1"; exit 1; }
done_with() { echo "program=$1" >> "$GITHUB_OUTPUT"; "$1" --version; exit 0; }

if [ -n "${PROGRAM:-}" ]; then
    found=$(command -v -- "$PROGRAM") || fail "there is no program $PROGRAM"
    done_with "$found"
fi

exe=""
case "$(uname -s)-$(uname -m)" in
    Linux-x86_64) target=x86_64-unknown-linux-gnu ;;
    Linux-aarch64) target=aarch64-unknown-linux-gnu ;;
    Darwin-x86_64) target=x86_64-apple-darwin ;;
    Darwin-arm64) target=aarch64-apple-darwin ;;
    MINGW*-x86_64 | MSYS*-x86_64) target=x86_64-pc-windows-msvc; exe=.exe ;;
    *) target="" ;;
esac
folder="$RUNNER_TEMP/xacro-lint"
mkdir -p "$folder"

case "${INSTALL:-release}" in
    source)
        command -v cargo >/dev/null || fail "install: source needs Rust on the runner"
        cargo install --quiet --locked --path "$ACTION" --bin xacro-lint --no-default-features --features cli --root "$folder"
        done_with "$folder/bin/xacro-lint$exe"
        ;;
    release) ;;
    *) fail "install is release or source, not $INSTALL" ;;
esac

[ -n "$target" ] || fail "there is no release for $(uname -sm): use install: source"
# the runner does not always say which action this is: then its folder does (.../_actions/OWNER/NAME/REF)
below=${ACTION#*/_actions/}
if [ -z "${REPOSITORY:-}" ] && [ "$below" != "$ACTION" ]; then
    REPOSITORY=$(echo "$below" | cut -d/ -f1-2)
fi
[ -n "${REPOSITORY:-}" ] || fail "the repository of the releases is not known: set the input repository"

# whatever name of this action the workflow uses, a branch or a commit: the program is that of its version
VERSION=${VERSION:-v$(sed -n 's/^version = "\(.*\)"/\1/p' "$ACTION/Cargo.toml" | head -n 1)}
[[ $VERSION =~ ^v[0-9]+\.[0-9]+\.[0-9]+[-+.0-9A-Za-z]*$ ]] || fail "version is written like v0.1.0, not $VERSION"
from="$SERVER/$REPOSITORY/releases/download/$VERSION"

archive="xacro-lint-$target.tar.gz"
cd "$folder"
for file in "$archive" SHA256SUMS; do
    curl --fail --silent --show-error --location --retry 3 --output "$file" "$from/$file" \
        || fail "$from/$file cannot be had: set version or repository, or use install: source"
done
awk -v name="$archive" '$2 == name' SHA256SUMS > wanted
[ -s wanted ] || fail "$archive is not in SHA256SUMS"
if command -v sha256sum >/dev/null; then sha256sum --check --quiet wanted; else shasum -a 256 --check --quiet wanted; fi \
    || fail "$archive is not what SHA256SUMS says"
tar -xzf "$archive"
done_with "$folder/xacro-lint-$target/xacro-lint$exe"
