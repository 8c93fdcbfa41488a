"""Builds the programs for Windows with MinGW on Debian, and a command that runs them under Wine.

The standard library for Windows is built from the source that Debian packages beside its own compiler; the packages are
unpacked, not installed. What was built is kept as long as no file of the programs changes.
"""
import hashlib
import os
import shutil
import subprocess
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
HOME = REPOSITORY / 'target' / 'windows'
TARGET = 'x86_64-pc-windows-gnu'
COMPILER = ['rustc-web', 'libstd-rust-web-1.96', 'libstd-rust-web-dev', 'rust-web-src', 'libllvm22']
WINE = '/usr/lib/wine/wine64'
# Wine 8 lacks a library that the standard library takes random numbers from
RANDOM = '''#include <windows.h>
BOOLEAN NTAPI SystemFunction036(PVOID, ULONG);
__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE to, SIZE_T count) { return SystemFunction036(to, (ULONG)count); }
'''
ENVIRONMENT = {'WINEDEBUG': '-all', 'WINEPREFIX': str(HOME / 'prefix')}
# what the drive of Wine adds to the paths of this system
WRAPPER = '''#!/bin/bash
export WINEDEBUG=-all WINEPREFIX={prefix}
plain='{filter}'
{{ {wine} {program} "$@" 2>&3 | sed -u "$plain"; exit "${{PIPESTATUS[0]}}"; }} 3> >(sed -u "$plain" >&2)
'''
FILTER = 's#file:///Z:/#file:///#g; s#Z:/#/#g'


def run(*command, **options):
    subprocess.run([str(part) for part in command], check=True, **options)


def install():
    if not shutil.which('x86_64-w64-mingw32-gcc') or not Path(WINE).exists():
        run('apt-get', 'update', '-qq')
        run('apt-get', 'install', '-y', '-qq', 'gcc-mingw-w64-x86-64-win32', 'binutils-mingw-w64-x86-64')
        run('apt-get', 'install', '-y', '-qq', '--no-install-recommends', 'wine64')


def compiler():
    """The path of a compiler that can build its own standard library."""
    root, script = HOME / 'root', HOME / 'rustc'
    if not script.exists():
        debs = HOME / 'debs'
        debs.mkdir(parents=True, exist_ok=True)
        run('apt-get', 'download', *COMPILER, cwd=debs)
        for deb in debs.glob('*.deb'):
            run('dpkg', '-x', deb, root)
        library = root / 'usr/lib/rustlib/src'
        library.mkdir(parents=True, exist_ok=True)
        source = next((root / 'usr/src').glob('rustc-*'))
        if not (library / 'rust').exists():
            (library / 'rust').symlink_to(source)
        script.write_text(f'#!/bin/sh\nLD_LIBRARY_PATH={root}/usr/lib/x86_64-linux-gnu exec {root}/usr/bin/rustc "$@"\n')
        script.chmod(0o755)
    return script


def content():
    """A hash of all that the programs are built from."""
    listed = subprocess.run(
        ['git', 'ls-files', '-co', '--exclude-standard', 'src', 'docs', 'editors/viewer', 'Cargo.toml', 'Cargo.lock', 'tests/windows/build.py'],
        cwd=REPOSITORY, check=True, capture_output=True, text=True).stdout.split('\n')
    state = hashlib.sha256()
    for name in sorted(filter(None, listed)):
        path = REPOSITORY / name
        if path.is_file():
            state.update(name.encode() + b'\0' + path.read_bytes())
    return state.hexdigest()


def build():
    """Build the programs if anything changed; the folder that holds them."""
    HOME.mkdir(parents=True, exist_ok=True)
    folder, stamp = HOME / 'bin', HOME / 'content'
    now = content()
    install()
    if stamp.exists() and stamp.read_text() == now:
        return folder
    settings = {'RUSTC_BOOTSTRAP': '1', 'RUSTC': str(compiler()), 'CARGO_TARGET_DIR': str(HOME / 'target'),
                'CARGO_TARGET_X86_64_PC_WINDOWS_GNU_LINKER': 'x86_64-w64-mingw32-gcc',
                'CARGO_PROFILE_RELEASE_OPT_LEVEL': '1', 'CARGO_PROFILE_RELEASE_CODEGEN_UNITS': '16',
                'CARGO_PROFILE_RELEASE_STRIP': 'true'}
    run('cargo', 'build', '--quiet', '--release', '--target', TARGET, '-Zbuild-std=std,panic_unwind', '--bins',
        cwd=REPOSITORY, env=dict(os.environ, **settings))
    folder.mkdir(exist_ok=True)
    for name in ('xacro-lint.exe', 'xacro-lsp.exe'):
        shutil.copy2(HOME / 'target' / TARGET / 'release' / name, folder / name)
    source = HOME / 'random.c'
    source.write_text(RANDOM)
    run('x86_64-w64-mingw32-gcc', '-shared', '-o', folder / 'bcryptprimitives.dll', source, '-ladvapi32')
    stamp.write_text(now)
    return folder


def command(folder, name, is_filtered):
    """A script that runs a program under Wine; filtered, its output names paths as this system does."""
    script = HOME / (name + ('-filtered' if is_filtered else ''))
    program = folder / f'{name}.exe'
    if is_filtered:
        text = WRAPPER.format(prefix=HOME / 'prefix', filter=FILTER, wine=WINE, program=program)
    else:
        text = f'#!/bin/sh\nexport WINEDEBUG=-all WINEPREFIX={HOME}/prefix\nexec {WINE} {program} "$@"\n'
    script.write_text(text)
    script.chmod(0o755)
    return script
