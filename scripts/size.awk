# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Read by scripts/print-size. From a linker's map, gcc's stack figures and the relocations of a library, in this order, to the bytes that
# the feature set `set` takes of each kind of memory and the deepest stack of its calls, as CSV: code,rodata,data,bss,stack,helpers; the
# chain of calls that takes that stack goes to the file `chains`. What a function calls is what the relocations of its section name,
# called or not: a bound. Variables: set; call: bytes of a return address that the stack figures leave out; callers: the objects whose
# functions may call through a pointer, and tests: the functions it may point to; visits: functions that are handed to a walk, which calls
# them: its frames lie between, those of whatever of walk.c the same function calls.

function kind_of(section)
{
    if (section ~ /^\.(text|iwram)/) return "code"
    if (section ~ /^\.(rodata|progmem)/) return "rodata"
    if (section ~ /^\.(data|sdata|tdata)/) return "data"
    if (section ~ /^(\.bss|\.sbss|\.tbss|COMMON)/) return "bss"
    return ""
}

# awk's own numbers know no hexadecimal.
function from_hex(text,   value, i)
{
    for (i = 3; i <= length(text); i++) value = value * 16 + index("123456789abcdef", tolower(substr(text, i, 1)))
    return value
}

# gcc's stack figures leave out the last number of a clone's name: way.isra for way.isra.0.
function plain(name)  { sub(/\.[0-9]+$/, "", name); return name }
function base(path)   { sub(/.*[\/(]/, "", path); sub(/\.[a-z]+\)?$/, "", path); return path }
function fail(text)   { print set ": " text > "/dev/stderr"; failed = 1; exit 1 }

BEGIN { count = split(callers, names, " "); for (i = 1; i <= count; i++) is_caller[names[i]] = 1
        count = split(tests, names, " ");   for (i = 1; i <= count; i++) is_test[names[i]] = 1
        count = split(visits, names, " ");  for (i = 1; i <= count; i++) is_visit[names[i]] = 1 }

# --- the map: one line ` SECTION ADDRESS SIZE FILE`, or two where the name is long

/^Linker script and memory map/ { in_map = 1 }
FILENAME ~ /\.map$/ && in_map && /^ [.A-Z]/ && NF == 1 { section = $1; next }
FILENAME ~ /\.map$/ && in_map && /^ [.A-Z]/ && NF >= 4 { section = $1; $1 = "" ; $0 = $0 }
FILENAME ~ /\.map$/ && in_map && section != "" && $1 ~ /^0x/ && $2 ~ /^0x/ {
    kind = kind_of(section)
    if ($3 ~ /libtuff\.a\(/) bytes[kind] += from_hex($2)
    else if ($3 ~ /\.a\(/ && kind != "") bytes["helpers"] += from_hex($2)
}
FILENAME ~ /\.map$/ { section = ""; next }

# --- gcc's figures: FILE:LINE:COLUMN:FUNCTION <tab> BYTES <tab> KIND

FILENAME ~ /\.su$/ {
    split($0, field, "\t")
    sub(/.*:/, "", field[1])
    if (field[3] == "dynamic") fail("no bound for the stack of " field[1])
    key = base(FILENAME) SUBSEP plain(field[1])
    if (!(key in frame) || field[2] > frame[key]) frame[key] = field[2] + 0
    next
}

# --- readelf: the object, the section of the caller, the called in the fifth column

/^File: /                                       { object = base($2); next }
/^Relocation section '\.rela?\.text\./          { caller = $3; gsub(/^'\.rela?\.text\.|'$/, "", caller); next }
/^Relocation section /                          { caller = ""; next }
caller != "" && $1 ~ /^[0-9a-f]+$/ && NF >= 5 && $5 !~ /^\.(rodata|data|bss|L)/ {
    callee = $5
    sub(/^\.text\./, "", callee)
    edge = object SUBSEP caller
    if (index(calls[edge] " ", " " callee " ") == 0) calls[edge] = calls[edge] " " callee
}

# The node of a name: a function of the same object, else the one of that name; "": none of the library's.
function node_of(name, from,   key)
{
    if ((from SUBSEP plain(name)) in frame) return from SUBSEP name
    return name in home ? home[name] SUBSEP name : ""
}

function object_of(node) { return substr(node, 1, index(node, SUBSEP) - 1) }
function name_of(node)   { return substr(node, index(node, SUBSEP) + 1) }

function reach(node,   list, i, n, next_node)
{
    if (node in reached) return
    reached[node] = 1
    n = split(calls[node], list, " ")
    for (i = 1; i <= n; i++) {
        next_node = node_of(list[i], object_of(node))
        if (next_node != "") reach(next_node)
    }
}

# A call through a pointer may reach each test that the set has linked.
function add_pointers(   node, other)
{
    for (node in reached) {
        if (!(object_of(node) in is_caller)) continue
        for (other in reached) {
            if (other != node && name_of(other) in is_test) calls[node] = calls[node] " " name_of(other)
        }
    }
}

# The deepest stack from a node on; below[node] is the next of the chain.
function depth(node,   list, i, n, next_node, deepest, d, walk)
{
    if (node in known) return known[node]
    if (node in busy) fail(name_of(node) " calls itself")
    busy[node] = 1
    n = split(calls[node], list, " ")
    walk = walk_below(node, list, n)
    for (i = 1; i <= n; i++) {
        next_node = node_of(list[i], object_of(node))
        if (next_node == "" || next_node == node) continue
        d = depth(next_node) + (plain(name_of(next_node)) in is_visit ? walk : 0)
        if (d > deepest) { deepest = d; below[node] = next_node; between[node] = d - depth(next_node) }
    }
    delete busy[node]
    return known[node] = deepest + own_stack(node)
}

# What the walks that a function starts take; list: the n functions that it calls.
function walk_below(node, list, n,   i, next_node, deepest)
{
    for (i = 1; i <= n; i++) {
        next_node = node_of(list[i], object_of(node))
        if (object_of(next_node) != "walk" || next_node == node || plain(name_of(next_node)) in is_visit) continue
        if (depth(next_node) > deepest) deepest = depth(next_node)
    }
    return deepest + 0
}

# The callers of tests/size/sets.c are the game's own.
function own_stack(node)
{
    if (object_of(node) == "sets") return 0
    return frame[object_of(node) SUBSEP plain(name_of(node))] + call
}

END {
    if (failed) exit 1
    for (key in frame) home[name_of(key)] = object_of(key)
    root = "sets" SUBSEP "set_" set
    reach(root)
    add_pointers()
    stack = depth(root)
    printf "%d,%d,%d,%d,%d,%d\n", bytes["code"], bytes["rodata"], bytes["data"], bytes["bss"], stack, bytes["helpers"]
    for (node = below[root]; node != ""; node = below[node]) {
        if (object_of(node) != "sets") chain = chain (chain == "" ? "" : " > ") name_of(node) " " own_stack(node) \
            (between[node] ? " > the walk " between[node] : "")
    }
    print stack ": " chain > chains
}
