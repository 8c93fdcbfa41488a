#!/usr/bin/env bash
# VS Code for the tests: code-server from the npm registry, which is the workbench and the extension host of
# VS Code 1.100 behind a local port. Native parts are built here, nothing is fetched from anywhere but npm.
#
#   tests/vscode/code-server.sh DIR     install into DIR; does nothing when it is there already
set -euo pipefail
version=4.100.3
[ $# -eq 1 ] || { echo "usage: code-server.sh DIR" >&2; exit 2; }
mkdir -p "$1"
dir=$(cd "$1" && pwd)
stamp="$dir/installed-$version"
[ -e "$stamp" ] && exit 0
case "$(node --version)" in
    v20.*) ;;
    *) echo "code-server $version runs on Node 20; this is $(node --version)" >&2; exit 1 ;;
esac

rm -rf "$dir/app" "$dir/fetched"
mkdir "$dir/fetched"
(cd "$dir/fetched" && npm pack --silent "code-server@$version" >/dev/null && tar -xzf ./*.tgz)
mv "$dir/fetched/package" "$dir/app"
rm -r "$dir/fetched"

# Scripts of packages stay off: some would download programs, and code-server's own wants another package manager.
plain=(--omit=dev --ignore-scripts --no-audit --no-fund --loglevel=error)
app="$dir/app"
(cd "$app" && npm ci "${plain[@]}")
# the lock file of this part does not fit its package.json, which `npm ci` refuses
(cd "$app/lib/vscode" && npm install "${plain[@]}")
(cd "$app/lib/vscode/extensions" && npm ci "${plain[@]}")

# What has to be compiled. The step after node-pty's fails though its addon is built, so the files are looked at.
(cd "$app" && npm rebuild --loglevel=error --build-from-source argon2)
(cd "$app/lib/vscode" && npm rebuild --loglevel=error @vscode/spdlog native-watchdog kerberos node-pty >"$dir/rebuild.log" 2>&1 || true)
modules="$app/lib/vscode/node_modules"
for addon in @vscode/spdlog/build/Release/spdlog native-watchdog/build/Release/watchdog \
    kerberos/build/Release/kerberos node-pty/build/Release/pty; do
    [ -s "$modules/$addon.node" ] || { echo "could not build $addon.node, see $dir/rebuild.log" >&2; exit 1; }
done
ln -sfn node_modules "$modules.asar"
# quick open searches with ripgrep, which its package would download
mkdir -p "$modules/@vscode/ripgrep/bin"
ln -sf "$(command -v rg)" "$modules/@vscode/ripgrep/bin/rg"
touch "$stamp"
