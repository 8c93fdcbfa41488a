#!/usr/bin/env bash
# Put the editors of the tests in place; what is there already stays.
#
#   install.sh neovim SUITE FOLDER   Neovim of a Debian suite (trixie: 0.10, sid: newer), unpacked beside the system
#   install.sh helix FOLDER          Helix of Debian trixie, unpacked likewise
#   install.sh emacs                 Emacs with eglot (29 or newer), from bookworm-backports when the system's is older
#   install.sh packages FOLDER NAME...   Debian packages of scripts, unpacked into FOLDER
#   install.sh scripts SUITE FOLDER NAME...   the same of a Debian suite
#   install.sh tmux | vim | luacheck | stylua FOLDER
#
# Unpacked programs bring their own C library along, so that the system stays as it is.
set -euo pipefail

mirror() {
    { cat /etc/apt/sources.list.d/*.sources /etc/apt/sources.list 2>/dev/null || true; } |
        sed -n -e 's/^URIs: *//p' -e 's/^deb \(\[[^]]*\] \)\{0,1\}\(http[^ ]*\).*/\2/p' | sed -n 1p
}

sources() { # FILE SUITE
    local uri
    uri=$(mirror)
    cat > "$1" <<SOURCES
Types: deb
URIs: ${uri:-http://deb.debian.org/debian}
Suites: $2
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
SOURCES
}

# Lists of a Debian suite in a folder of their own, and the options with which apt-get reads them.
options=()
lists() { # SUITE FOLDER
    local state=$2/apt
    rm -rf "$state" && mkdir -p "$state/sources" "$state/lists/partial" "$state/cache/archives/partial"
    touch "$state/status"
    sources "$state/sources/suite.sources" "$1"
    options=(
        -q -y -o Dir::Etc::SourceList=/dev/null -o "Dir::Etc::SourceParts=$state/sources"
        -o Dir::Etc::PreferencesParts=/dev/null -o "Dir::State::Lists=$state/lists"
        -o "Dir::State::status=$state/status" -o "Dir::Cache=$state/cache"
        -o Acquire::Languages=none -o APT::Sandbox::User=root -o Acquire::Retries=3
    )
    apt-get "${options[@]}" update > "$2/log" 2>&1 || { tail -5 "$2/log"; return 1; }
}

# Unpack PACKAGE of SUITE with everything it needs into FOLDER/root.
unpack() { # SUITE PACKAGE FOLDER
    rm -rf "$3" && mkdir -p "$3"
    lists "$1" "$3" &&
        apt-get "${options[@]}" install --download-only --no-install-recommends "$2" >> "$3/log" 2>&1 ||
        { tail -5 "$3/log"; return 1; }
    local package
    for package in "$3"/apt/cache/archives/*.deb; do dpkg-deb -x "$package" "$3/root"; done
    rm -rf "$3/apt"
}

# A starter that runs a program of FOLDER/root with the libraries there.
starter() { # FOLDER NAME PROGRAM OPTIONS SETTING...
    local folder=$1 name=$2 program=$3 options=$4
    shift 4
    local libraries
    libraries=$(dirname "$(find "$folder/root/usr/lib" "$folder/root/lib" -name 'ld-linux-*' -path '*-linux-*' 2>/dev/null | head -1)")
    libraries=${libraries#"$folder/root/"}
    {
        echo '#!/bin/sh'
        echo 'root=$(dirname "$(readlink -f "$0")")/root'
        printf 'export %s\n' "$@"
        echo "libraries=\$root/$libraries"
        echo "exec \"\$libraries\"/ld-linux-*.so.* --argv0 $name --library-path \"\$libraries\" \"\$root/$program\" $options \"\$@\""
    } > "$folder/$name"
    chmod +x "$folder/$name"
    "$folder/$name" --version | head -1
}

whole() { mkdir -p "$1" && (cd "$1" && pwd); }

ready() { [ -x "$1" ] && "$1" --version 2>/dev/null | head -1; }

system() { # PACKAGE...
    "$(dirname "$0")/../apt.sh" "$@" > /dev/null
}

case ${1:-} in
    neovim)
        folder=$(whole "$3")
        ready "$folder/nvim" && exit
        unpack "$2" neovim "$folder"
        starter "$folder" nvim usr/bin/nvim '--cmd "set runtimepath+=$root/usr/lib/nvim"' 'VIMRUNTIME="$root/usr/share/nvim/runtime"' \
            "LUA_CPATH=\"\$(echo \"\$root\"/usr/lib/*/lua/5.1)/?.so;;\""
        ;;
    helix)
        folder=$(whole "$2")
        ready "$folder/hx" && exit
        unpack trixie hx "$folder"
        starter "$folder" hx usr/lib/hx/hx '' 'HELIX_RUNTIME="$root/usr/lib/hx/runtime"'
        ;;
    emacs)
        version() { emacs --version 2>/dev/null | sed -n '1s/[^0-9]*\([0-9]*\).*/\1/p'; }
        [ "$(version || true)" -ge 29 ] 2>/dev/null && exit
        if apt-cache policy emacs-nox 2>/dev/null | grep -q 'Candidate: 1:\(29\|[3-9]\)'; then
            system emacs-nox
        else
            # the packages of the system and, for this command alone, those of its backports
            parts=$(mktemp -d)
            trap 'rm -rf "$parts"' EXIT
            cp /etc/apt/sources.list.d/*.sources "$parts" 2>/dev/null || true
            sources "$parts/backports.sources" bookworm-backports
            apt-get -q -o "Dir::Etc::SourceParts=$parts" update > /dev/null
            apt-get -q -y -o "Dir::Etc::SourceParts=$parts" install --no-install-recommends \
                -t bookworm-backports emacs-nox > /dev/null
        fi
        emacs --version | head -1
        ;;
    scripts)
        folder=$(whole "$3")
        [ -e "$folder/ready" ] && exit
        cd "$folder"
        lists "$2" "$folder"
        shift 3
        apt-get "${options[@]}" download "$@" >> log 2>&1 || { tail -5 log; exit 1; }
        for package in *.deb; do dpkg-deb -x "$package" root; done
        rm -rf apt ./*.deb
        touch ready
        ;;
    packages)
        folder=$(whole "$2")
        [ -e "$folder/ready" ] && exit
        cd "$folder"
        shift 2
        apt-get download -q "$@" > /dev/null 2>&1 || { apt-get update -q > /dev/null && apt-get download -q "$@" > /dev/null; }
        for package in *.deb; do dpkg-deb -x "$package" .; done
        touch ready
        ;;
    vim) command -v vim > /dev/null || system vim ;;
    tmux) command -v tmux > /dev/null || system tmux ;;
    luacheck) command -v luacheck > /dev/null || system lua-check ;;
    stylua)
        [ -x "$2/node_modules/.bin/stylua" ] && exit
        mkdir -p "$2" && npm install --silent --no-audit --no-fund --prefix "$2" @johnnymorganz/stylua-bin@2.5.2
        ;;
    *) sed -n '2,11p' "$0" >&2; exit 2 ;;
esac
