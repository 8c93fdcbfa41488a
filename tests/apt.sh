#!/usr/bin/env bash
# Install packages of Debian: one caller at a time, since suites run beside each other and apt-get does not wait.
#
#   tests/apt.sh PACKAGE...
set -eu
exec 9>"${TMPDIR:-/tmp}/xacro-lsp-apt.lock"
flock 9
apt-get update -qq
apt-get install -y -qq --no-install-recommends "$@"
