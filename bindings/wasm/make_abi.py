#!/usr/bin/env python3
"""Writes the binary interface of the WebAssembly module, from the C headers.

usage: make_abi.py ABI.ts LAYOUT.cpp EXPORTS.txt HEADER...

Writes ABI.ts, with the constants, the layouts of the structs and the types of the functions; LAYOUT.cpp, which makes the
compiler check these layouts; and EXPORTS.txt, the list of the functions that the module exports.
"""

import json
import re
import sys
from pathlib import Path

# What JavaScript does itself: it reads and writes files. The functions with functions of C as parameters, which module.h
# replaces. Snapshots for other threads: the module has one thread.
OMITTED = re.compile(
    r"ww_set_allocator|ww_scene_read|\w*_file|ww_world_save|ww_world_load|ww_world_attempt|ww_replay_writer_create|ww_replay_run"
    r"|ww_world_publish|ww_snapshot_\w+|ww_version|ww_text_read|ww_(item|location)_kind_name|ww_fill_rule_name"
    r"|ww_path_(algorithm|status)_name|ww_path_algorithm_by_name|ww_world_find_paths"
)
# The constants that the wrapper uses, and the structs that it does not use. The rest would only make the package larger.
CONSTANTS = re.compile(r"WW_(OK|BUFFER_TOO_SMALL|INVALID_ARGUMENT|CHANGE_\w+|PATH_FOUND|PIECE_LINE|FLOAT64)")
UNUSED_STRUCTS = re.compile(r"ww_(point|box|allocator|job_system|portal|\w+_hash|triangle|constrained_edge|output|input)")
SIZES = {"double": 8, "uint64_t": 8, "int64_t": 8, "uint32_t": 4, "int32_t": 4, "size_t": 4, "uint8_t": 1, "char": 1}

COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
ALIAS = re.compile(r"^typedef (?P<old>\w+) (?P<new>\w+);", re.MULTILINE)
STRUCT = re.compile(r"^typedef struct (?P<name>\w+) {(?P<body>.*?)^} \w+;", re.MULTILINE | re.DOTALL)
CONSTANT = re.compile(r"\b(?P<name>WW_[A-Z0-9_]+) = (?P<value>-?\d+)")
MEMBER = re.compile(r"^(?:const )?(?:struct )?(?P<type>\w+)(?P<star>[\s*]*?(?:const\s*\*)?)\s*(?P<name>\w+)(?:\[(?P<count>\d+)\])?$")
FUNCTION = re.compile(r"^WW_API (?P<result>[\w* ]+?[ *])(?P<name>ww_\w+)\((?P<parameters>[^;]*?)\);", re.MULTILINE | re.DOTALL)


class Header:
    def __init__(self, text):
        text = COMMENT.sub("", text)
        self.aliases = {match["new"]: match["old"] for match in ALIAS.finditer(text)}
        self.structs = {}
        for match in STRUCT.finditer(text):
            self.add_struct(match["name"], match["body"])
        self.constants = [(match["name"], int(match["value"])) for match in CONSTANT.finditer(text)]
        self.functions = [
            (match["name"], match["result"].strip(), [each.strip() for each in match["parameters"].split(",")])
            for match in FUNCTION.finditer(text)
            if not OMITTED.fullmatch(match["name"])
        ]

    def base(self, name):
        while name in self.aliases:
            name = self.aliases[name]
        return name

    def size_and_alignment(self, name):
        name = self.base(name)
        if name in self.structs:
            return self.structs[name]["size"], self.structs[name]["alignment"]
        return SIZES[name], SIZES[name]

    def add_struct(self, name, body):
        """Lays a struct out as clang does for wasm32: each member at the next multiple of its alignment."""
        members, offset, largest = {}, 0, 1
        for line in filter(None, (" ".join(part.split()) for part in body.split(";"))):
            pointer = re.match(r"^.*\(\*(?P<name>\w+)\)\(.*\)$", line)
            match = pointer or MEMBER.match(line)
            if match is None:
                sys.exit(f"make_abi.py: cannot read the member '{line}' of {name}")
            if pointer or "*" in line:
                size = alignment = 4
            else:
                size, alignment = self.size_and_alignment(match["type"])
                size *= int(match["count"] or 1)
            offset = -(-offset // alignment) * alignment
            members[match["name"]] = offset
            offset += size
            largest = max(largest, alignment)
        size = -(-offset // largest) * largest
        self.structs[name] = {"size": size, "alignment": largest, "members": members}

    def is_long(self, parameter):
        return "*" not in parameter and self.base(parameter.removeprefix("const ").split()[0]) in ("uint64_t", "int64_t")


def camel(name):
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


def parameters_of(header, parameters):
    """Returns the names and the types in TypeScript of the parameters of a function."""
    if parameters == ["void"]:
        return []
    return [
        (camel(re.search(r"(\w+)$", each)[1]) + "_", "bigint" if header.is_long(each) else "number") for each in parameters
    ]


def write_abi(header):
    lines = ["// Written by make_abi.py from the C headers. Do not edit.", ""]
    lines += [f"export const {name} = {value};" for name, value in header.constants if CONSTANTS.fullmatch(name)]
    lines += ["", "/** The sizes of the structs, and the offsets of their members. */"]
    for name, struct in header.structs.items():
        if UNUSED_STRUCTS.fullmatch(name):
            continue
        members = {"size_": struct["size"], **{camel(member): offset for member, offset in struct["members"].items()}}
        text = ", ".join(f"{member}: {offset}" for member, offset in members.items())
        lines.append(f"export const {name} = {{ {text} }} as const;")
    lines += ["", "/** The functions of the module. Pointers and structs are addresses. */", "export interface Functions {"]
    for name, result, parameters in header.functions:
        result = "void" if result == "void" else "bigint" if header.is_long(result) else "number"
        types = ", ".join(f"{each}: {kind}" for each, kind in parameters_of(header, parameters))
        lines.append(f"  readonly {name}: ({types}) => {result};")
    lines += ["}", "", "/** Returns the functions with each trap given to `trapped`, which throws. */"]
    lines += ["export function guarded(raw: Functions, trapped: (reason: unknown) => never): Functions {", "  return {"]
    for name, _, parameters in header.functions:
        names = ", ".join("abcdefghijklm"[: len(parameters_of(header, parameters))])
        lines.append(f"    {name}: ({names}) => {{ try {{ return raw.{name}({names}); }} catch (x) {{ return trapped(x); }} }},")
    return "\n".join([*lines, "  };", "}", ""])


def write_layout(header):
    lines = ["// Written by make_abi.py. Compares the layouts in abi.ts with the compiler's.", "#include <cstddef>"]
    lines += ["", '#include "wasm/module.h"', "", "// NOLINTBEGIN"]
    for name, struct in header.structs.items():
        lines.append(f"static_assert(sizeof({name}) == {struct['size']});")
        for member, offset in struct["members"].items():
            lines.append(f"static_assert(offsetof({name}, {member}) == {offset});")
    return "\n".join([*lines, "// NOLINTEND", ""])


def main(arguments):
    abi, layout, exports, *headers = map(Path, arguments)
    header = Header("\n".join(path.read_text(encoding="utf-8") for path in headers))
    names = [name for name, _, _ in header.functions] + ["malloc", "free", "stackSave", "stackRestore"]
    for path, text in (
        (abi, write_abi(header)),
        (layout, write_layout(header)),
        (exports, json.dumps([f"_{name}" if not name.startswith("stack") else name for name in names]) + "\n"),
    ):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
