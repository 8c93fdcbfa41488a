#!/usr/bin/env bash
# Run the check for the action: annotations on standard output, a report in a file, the exit code as an output.
#
# Read: PROGRAM, PATHS, CHANGED, OPTIONS (lists, one a line), ANNOTATIONS, SARIF; GITHUB_OUTPUT.
set -euo pipefail

# Lines of $1 to the list `lines`; blanks around them and empty lines are dropped.
lines=()
read_lines() {
    lines=()
    local line
    while IFS= read -r line || [ -n "$line" ]; do
        line="${line#"${line%%[![:space:]]*}"}"
        line="${line%"${line##*[![:space:]]}"}"
        [ -z "$line" ] || lines+=("$line")
    done <<< "$1"
}

command=("$PROGRAM" check)
read_lines "${OPTIONS:-}"
command+=(${lines[@]+"${lines[@]}"})
read_lines "${CHANGED:-}"
if [ ${#lines[@]} -gt 0 ]; then
    command+=(--changed)
else
    read_lines "${PATHS:-.}"
fi
# a name that begins with a dash is a name
for path in ${lines[@]+"${lines[@]}"}; do
    case "$path" in -*) path="./$path" ;; esac
    command+=("$path")
done

format=concise
[ "${ANNOTATIONS:-true}" != true ] || format=github
code=0
"${command[@]}" --format "$format" || code=$?
if [ "$code" -gt 1 ]; then
    echo "::error title=xacro-lint::the check could not run (exit code $code)"
    exit "$code"
fi
if [ -n "${SARIF:-}" ]; then
    "${command[@]}" --format sarif --exit-zero > "$SARIF"
    echo "sarif-file=$SARIF" >> "$GITHUB_OUTPUT"
fi
echo "exit-code=$code" >> "$GITHUB_OUTPUT"
