#!/usr/bin/env python3
"""Refuses code that not every compiler or system supports, except in the few files that contain it on purpose.

usage: check_portable.py [ROOT]

Prints `FILE:LINE: what is wrong` for each such construct and exits 1; exits 0 when there is none. Checks all code that every
target builds: the library, its headers, the command, the examples and the program tests/determinism.
"""

import re
import sys
from dataclasses import dataclass
from pathlib import Path

FOLDERS = ["include", "src", "bindings", "tools", "examples", "tests/determinism", "tests/support"]
SUFFIXES = {".cpp", ".hpp", ".h", ".ipp"}

# The only files for code that depends on the compiler.
COMPILER_FILES = {
    "src/base/compiler.hpp",  # builtins, attributes, integers of 128 bits
    "src/base/ieee.hpp",  # flags that break floating-point arithmetic
    "src/base/float_environment.hpp",  # the processor's rounding mode
    "include/waywright/export.hpp",  # visibility of symbols
    "bindings/c/waywright.h",  # visibility of symbols
    "bindings/wasm/module.cpp",  # imports of a WebAssembly module
}
SYSTEM_FILES = COMPILER_FILES | {
    "src/base/system.cpp",
    "tools/waywright/platform.cpp",
}
# The code that determines meshes and the lengths of paths.
LIBRARY = ("include/", "src/")


@dataclass(frozen=True)
class Rule:
    pattern: str
    advice: str
    homes: frozenset | set = frozenset()  # the files that may contain it
    where: tuple = ("",)  # the folders that must not contain it


TO_COMPILER = "belongs in src/base/compiler.hpp"
TO_SYSTEM = "belongs in tools/waywright/platform.cpp"
RULES = [
    Rule(r"__builtin_\w+", TO_COMPILER, COMPILER_FILES),
    Rule(r"__attribute__|__declspec|__forceinline", TO_COMPILER, COMPILER_FILES),
    Rule(r"\[\[(?:[^\]]*\W)?(?:gnu|clang|msvc)::\w+|\[\[\s*using\b", TO_COMPILER, COMPILER_FILES),
    Rule(r"\b__u?int128(?:_t)?\b|__SIZEOF_INT128__", TO_COMPILER, COMPILER_FILES),
    Rule(r"__extension__|__typeof__|\btypeof\b|__restrict", TO_COMPILER, COMPILER_FILES),
    Rule(r"\b_mm\w*_\w+|\b\w*mmintrin\b|\barm_neon\b", TO_COMPILER, COMPILER_FILES),
    Rule(r"__GNUC__|__clang__|_MSC_VER|__EMSCRIPTEN__", TO_COMPILER, COMPILER_FILES),
    Rule(r"#\s*pragma\s+(?!once\b)\w+|\b_Pragma\b", TO_COMPILER, COMPILER_FILES),
    Rule(r"#\s*include\s*<(?:unistd|fcntl|io|windows|pthread|dlfcn|poll)\.h>|#\s*include\s*<sys/", TO_SYSTEM, SYSTEM_FILES),
    Rule(r"\bSIGPIPE\b|\bisatty\b|\bfileno\b|\b_WIN32\b", TO_SYSTEM, SYSTEM_FILES),
    Rule(
        r"\blong\s+double\b",
        "differs in size and rounding between targets; use double",
        {"tests/support/disc_oracle_paths.cpp"},  # takes its tolerance from the number of digits
    ),
    Rule(r"(?<!long )\blong\b(?!\s+(?:long|double))", "differs in size between targets; use std::int64_t or std::ptrdiff_t"),
    Rule(r"\bchars_format\b", "belongs in src/base/number_text.cpp", {"src/base/number_text.cpp"}),
    Rule(r"std::bit_cast\b", "is missing in libc++ 13; use base::bit_cast", {"src/base/compiler.hpp"}),
    Rule(r"std::(?:ranges|views)::", "is missing in libc++ 14; use the algorithms of C++17"),
    Rule(
        r"std::(?:hypot|pow|exp2?|log(?:2|10)?|sin|cos|tan|a(?:sin|cos|tan2?)|cbrt|fma)\(",
        "is rounded differently by different libraries; use + - * / and sqrt",
        where=LIBRARY,
    ),
]


def code_lines(text):
    """Yields (number, line) without comments and without the text of strings."""
    text = re.sub(r"/\*.*?\*/", lambda match: "\n" * match.group().count("\n"), text, flags=re.DOTALL)
    for number, line in enumerate(text.splitlines(), start=1):
        line = re.sub(r'"(?:\\.|[^"\\])*"', '""', line)
        yield number, line.split("//", 1)[0]


def faults_of(name, text):
    rules = [rule for rule in RULES if name not in rule.homes and name.startswith(rule.where)]
    for number, line in code_lines(text):
        for rule in rules:
            match = re.search(rule.pattern, line)
            if match:
                yield f"{name}:{number}: '{match.group().strip()}' {rule.advice}"


def check(root):
    faults = []
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in SUFFIXES:
                faults += faults_of(file.relative_to(root).as_posix(), file.read_text(encoding="utf-8"))
    return faults


def main(arguments):
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    if not (root / "src").is_dir():
        print(f"{root}: no folder src", file=sys.stderr)
        return 2
    faults = check(root)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
