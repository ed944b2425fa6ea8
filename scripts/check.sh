# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Read by the check scripts: each fact is one call, which prints `ok`, `not ok` or `skip` and the fact; `finish` ends the script
# with the line that scripts/run-tests reads. A folder $work of its own is removed at the end.
set -u

CC=${CC:-cc}
CXX=${CXX:-c++}
float=-DTUFF_SCALAR=TUFF_FLOAT
q16=-DTUFF_SCALAR=TUFF_Q16_16
warnings='-Wall -Wextra -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -pedantic -Werror'
passed=0
failed=0
skipped=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# holds FACT COMMAND...: the command must succeed; its output is shown if it does not.
holds() {
    fact=$1
    shift
    if "$@" >"$work/output" 2>&1 </dev/null; then
        passed=$((passed + 1))
        echo "ok - $fact"
    else
        failed=$((failed + 1))
        sed 's/^/    /' "$work/output"
        echo "not ok - $fact"
        echo "    command: $*"
    fi
}

# refused FACT TEXT COMMAND...: the command must fail, and its output must hold the text.
refused() {
    fact=$1
    text=$2
    shift 2
    holds "$fact" refuses "$text" "$@"
}
refuses() {
    text=$1
    shift
    if "$@" >"$work/refusal" 2>&1; then
        echo "no error from: $*"
        return 1
    fi
    if grep -qF -e "$text" "$work/refusal"; then return 0; fi
    cat "$work/refusal"
    echo "the error does not say: $text"
    return 1
}

# readme_programs: the C blocks of the README that hold a main, each into a file of its own, $work/readme-N.c; lists them.
readme_programs() {
    awk -v work="$work" '
        /^```c[[:space:]]*$/ { inside = 1; text = ""; next }
        /^```/ && inside     { inside = 0; if (text ~ /int main/) printf "%s", text > (work "/readme-" ++count ".c"); next }
        inside               { text = text $0 "\n" }' README.md
    ls "$work"/readme-*.c
}

# skip FACT REASON: where CI is set nothing may be missing.
skip() {
    if test -n "${CI:-}"; then
        failed=$((failed + 1))
        echo "not ok - $1 ($2)"
    else
        skipped=$((skipped + 1))
        echo "skip - $1 ($2)"
    fi
}

finish() {
    echo "checks: $passed ok, $failed not ok, $skipped skipped"
    test "$failed" = 0
}
