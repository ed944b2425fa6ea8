# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Read by the scripts that get tools: has_... look for one, need names the package of one that is missing, and get_tools installs them on
# Debian and Ubuntu, as root or through sudo. Elsewhere it says what is missing and fails. Optional ones may be missing where
# they cannot be installed.

has_command() { command -v "$1" >/dev/null 2>&1; }
has_c()       { printf '%s\n' "$1" | ${CC:-cc} -E -x c - >/dev/null 2>&1; }
has_cxx()     { printf '%s\n' "$1" | ${CXX:-c++} -E -x c++ - >/dev/null 2>&1; }

missing=
optional=
need() { missing="$missing $1"; }
like() { optional="$optional $1"; }

# get_tools WHAT-FOR
get_tools() {
    if test -z "$missing$optional"; then return 0; fi
    as_root=
    if test "$(id -u)" != 0; then as_root=sudo; fi
    if ! has_command apt-get || { test -n "$as_root" && ! has_command sudo; }; then
        if test -z "$missing"; then return 0; fi
        echo "The $1 need what this machine lacks; the names are those of Debian's packages:$missing" >&2
        return 1
    fi

    echo "Installing for the $1, by apt:$missing$optional"
    log=$(mktemp)
    trap 'rm -f "$log"' EXIT
    apt="$as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=1200 -o Acquire::Retries=3"
    # A foreign package source that does not answer is no reason to stop; the installation tells.
    $apt update > "$log" 2>&1 || true
    # shellcheck disable=SC2086
    if ! $apt install -y --no-install-recommends $missing $optional >> "$log" 2>&1; then
        cat "$log" >&2
        echo "apt could not install:$missing$optional" >&2
        return 1
    fi
}
