#!/usr/bin/env bash
# Build the playground into target/playground/site, with what it holds: the program for WebAssembly and the viewer.
set -eu
cd "$(dirname "$0")/../.."

tests/playground/build.sh
# the tests of the viewer may have built it already
if [ ! -f editors/viewer/dist/viewer.js ]; then
    npm ci --prefix editors/viewer --silent --no-audit --no-fund
    npm run build --prefix editors/viewer --silent
fi
# the worker holds the scripts of the package, which are written in TypeScript
npm ci --prefix editors/playground --silent --no-audit --no-fund
npm run build --prefix editors/playground --silent
