#!/usr/bin/env python3
"""Refuses headers of the library that only one file includes and no test: such a header belongs into this file.

usage: check_headers.py [ROOT]

Prints `FILE:1: only OTHER includes this header` for each such header under src and exits 1; exits 0 when there is none.
"""

import re
import sys
from pathlib import Path

FOLDERS = ("include", "src", "bindings", "tools", "examples", "bench", "tests")
SUFFIXES = {".hpp", ".inl", ".h", ".cpp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def users_of_headers(root):
    """Returns for each header, as an include names it, the files that include it."""
    users = {}
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in SUFFIXES:
                for path in set(INCLUDE.findall(file.read_text(encoding="utf-8"))):
                    users.setdefault(path, []).append(file.relative_to(root).as_posix())
    return users


def check(root):
    users = users_of_headers(root)
    faults = []
    for header in sorted((root / "src").rglob("*.hpp")):
        path = header.relative_to(root / "src")
        including = users.get(path.as_posix(), [])
        if len(including) == 1 and not including[0].startswith("tests/"):
            faults.append(f"src/{path.as_posix()}:1: only {including[0]} includes this header")
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
