#!/usr/bin/env bash
# The VS Code extension: types and style, grammars, units, and the whole in a real workbench.
#
#   tests/vscode/run.sh            installs what it needs (Debian packages, npm), builds, tests
#
# The web tests run in the extension host of the browser, with the server for WebAssembly.
#
# XACRO_LSP names the server to be put into the extension; without it, one is built. Arguments are passed on to
# e2e.mjs (`--only NAME`, `--shots`).
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$(pwd)
work="$root/target/vscode"
mkdir -p "$work"

missing=""
for need in chromium:chromium rg:ripgrep pkg-config:pkg-config g++:g++ make:make node:nodejs npm:npm; do
    command -v "${need%%:*}" >/dev/null 2>&1 || missing="$missing ${need#*:}"
done
[ -e /usr/include/krb5.h ] || [ -e /usr/include/krb5/krb5.h ] || missing="$missing libkrb5-dev"
pkg-config --exists libsecret-1 2>/dev/null || missing="$missing libsecret-1-dev"
if [ -n "$missing" ]; then
    echo "installing$missing"
    # shellcheck disable=SC2086 # a list of packages
    tests/apt.sh $missing >"$work/apt.log" 2>&1 || { tail -5 "$work/apt.log"; exit 1; }
fi

# Packages as the lock files have them, once for each state of a lock file.
packages() {
    local stamp="$1/node_modules/.of-$(sha256sum "$1/package-lock.json" | cut -c1-16)"
    [ -e "$stamp" ] && return 0
    (cd "$1" && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error)
    touch "$stamp"
}
packages tests/vscode
packages editors/vscode
tests/vscode/code-server.sh "$work/code-server"

echo "types and style"
(cd editors/vscode && npm run --silent check)
echo "grammars and units"
node --test --test-reporter=dot tests/vscode/grammar.test.mjs
(cd editors/vscode && npm run --silent test)

server=${XACRO_LSP:-}
if [ -z "$server" ]; then
    cargo build --release --quiet
    server="${CARGO_TARGET_DIR:-target}/release/xacro-lsp"
fi
if [ -d editors/viewer ]; then
    packages editors/viewer
    (cd editors/viewer && npm run --silent build)
fi
# Packages the extension with what the arguments name; `web` beside the one for this platform.
package() {
    local name=$1
    shift
    node editors/vscode/scripts/package.mjs --out "$work/$name.vsix" "$@" >"$work/package.log" 2>&1 ||
        { cat "$work/package.log"; exit 1; }
    if grep -i warning "$work/package.log"; then echo "vsce warns"; exit 1; fi
    tail -1 "$work/package.log"
}
tests/playground/build.sh server
package xacro-lsp --server "$server"
package xacro-lsp-web --wasm target/playground/xacro_lsp.wasm

node tests/vscode/e2e.mjs --code-server "$work/code-server" --vsix "$work/xacro-lsp.vsix" \
    --web-vsix "$work/xacro-lsp-web.vsix" --out "$work/e2e" "$@"
