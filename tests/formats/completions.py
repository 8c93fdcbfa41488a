"""Completion, asked for in the shells themselves."""
import os
import shutil
import subprocess

# What is typed, and what must be offered.
CASES = [
    ("ch", "check"),
    ("check --fo", "--format"),
    ("check --format ", "sarif"),
    ("check --format sar", "sarif"),
    ("fix --unsafe", "--unsafe-fixes"),
    ("explain --", "--help"),
]

# A terminal for the line editor of zsh, in which Tab lists what is offered.
ZSH = """
zmodload zsh/zpty
zpty shell "TERM=dumb zsh -f -i"
zpty -w shell "PROMPT=; RPROMPT=; unsetopt zle_bracketed_paste 2>/dev/null; fpath=($1 \\$fpath); autoload -Uz compinit; compinit -u -d $1/dump; zstyle ':completion:*' list-prompt ''; bindkey '^I' list-choices; LISTMAX=1000; print READY"
text=
while zpty -r shell part 2>/dev/null; do text+=$part; [[ $text == *$'\\n'READY* ]] && break; done
zpty -w -n shell "xacro-lint $2"$'\\t'
text=
for i in {1..40}; do
    sleep 0.1
    while zpty -r -t shell part 2>/dev/null; do text+=$part; done
    [[ $text == *$3* ]] && break
done
zpty -d shell
print -r -- "$text"
"""


def bash(program, script, typed, _):
    words = ["xacro-lint", *typed.split(" ")]
    quoted = " ".join(f"'{word}'" for word in words)
    code = (f"source {script}; COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; "
            f"_xacro__lint xacro-lint '{words[-1]}' '{words[-2]}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    return ["bash", "--norc", "-c", code]


def fish(program, script, typed, _):
    return ["fish", "--no-config", "-c", f"source {script}; complete -C 'xacro-lint {typed}'"]


def zsh(program, script, typed, expected):
    return ["zsh", "-f", "-c", ZSH, "zsh", os.path.dirname(script), typed, expected]


def check(program, work):
    """What is not offered in the shells that are there; each that is not is named."""
    wrong = []
    for shell, ask in (("bash", bash), ("fish", fish), ("zsh", zsh)):
        if not shutil.which(shell):
            wrong.append(f"there is no {shell} to try completion in")
            continue
        folder = os.path.join(work, shell)
        os.makedirs(folder, exist_ok=True)
        script = os.path.join(folder, "_xacro-lint")
        with open(script, "w") as file:
            subprocess.run([program, "completions", shell], stdout=file, check=True)
        for typed, expected in CASES:
            ran = subprocess.run(ask(program, script, typed, expected), capture_output=True, text=True, timeout=60)
            if expected not in ran.stdout:
                wrong.append(f"{shell} does not offer {expected} for `xacro-lint {typed}`: {ran.stdout!r} {ran.stderr!r}")
    return wrong
