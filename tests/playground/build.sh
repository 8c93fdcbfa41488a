#!/usr/bin/env bash
# Build the program for WebAssembly into target/playground/xacro_lint.wasm, or with `server` as the argument, the
# language server into target/playground/xacro_lsp.wasm.
#
# With the target of rustup where it is installed (`rustup target add wasm32-unknown-unknown`), else with the compiler
# of Debian (packages of `rust-web`), which is unpacked below target and not installed.
set -eu
cd "$(dirname "$0")/../.."

target=wasm32-unknown-unknown
out="$PWD/target/playground"
mkdir -p "$out"
export RUSTFLAGS="-Clink-arg=-zstack-size=16777216" CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/target}"
host=$(rustc --version --verbose | sed -n 's/^host: //p')
sysroot=$(rustc --print sysroot)
extra=()
if [ ! -d "$sysroot/lib/rustlib/$target" ]; then
    tools="$out/rust-web"
    usr="$tools/root/usr"
    if [ ! -x "$usr/bin/rustc" ]; then
        command -v apt-get >/dev/null || { echo "run: rustup target add $target" >&2; exit 1; }
        rm -rf "$tools"
        mkdir -p "$tools/debs" "$tools/root"
        # lists that came with a system may know an older compiler alone
        apt-get update -qq || [ "$(apt-cache policy rustc-web)" ]
        # the newest libraries, of which each needs its own version of LLVM
        std=$(apt-cache depends --important libstd-rust-web-dev | sed -n 's/.*Depends: \(libstd-rust-web-[0-9.]*\)$/\1/p' | head -n 1)
        llvm=$(apt-cache depends --important "$std" | sed -n 's/.*Depends: \(libllvm[0-9]*\)$/\1/p' | head -n 1)
        (cd "$tools/debs" && apt-get download -qq rustc-web "$std" libstd-rust-web-dev rust-web-src "$llvm")
        for package in "$tools"/debs/*.deb; do dpkg -x "$package" "$tools/root"; done
        rm -r "$tools/debs"
    fi
    # not a link: the compiler finds its library by the folder that it lies in; builds beside this do the same
    printf '#!/bin/sh\nLD_LIBRARY_PATH=%s exec %s "$@"\n' "$usr/lib/${host%%-*}-linux-gnu" "$usr/bin/rustc" >"$tools/rustc.$$"
    chmod +x "$tools/rustc.$$"
    # cargo builds everything again when the compiler was written
    if cmp -s "$tools/rustc.$$" "$tools/rustc"; then rm "$tools/rustc.$$"; else mv "$tools/rustc.$$" "$tools/rustc"; fi
    # its standard library comes as source
    export RUSTC_BOOTSTRAP=1 RUSTC="$tools/rustc"
    export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER="$sysroot/lib/rustlib/$host/bin/rust-lld"
    extra=(-Zbuild-std=std,panic_abort)
fi
name=xacro_lint
features=()
if [ "${1:-}" = server ]; then
    name=xacro_lsp
    features=(--features server)
fi
# both programs come out under one name: what is built beside this must not be taken for it
if command -v flock >/dev/null; then exec 9>"$out/lock" && flock 9; fi
cargo rustc --quiet --locked -p xacro-lsp-wasm --lib --crate-type cdylib --profile wasm --target "$target" \
    "${features[@]}" "${extra[@]}"
built="$CARGO_TARGET_DIR/$target/wasm/wasm.wasm"
# the same bytes are left alone, so that what holds them is not built again
cmp -s "$built" "$out/$name.wasm" || cp "$built" "$out/$name.wasm"
