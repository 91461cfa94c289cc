#!/usr/bin/env python3
"""Refuses includes that the layers forbid: of a higher room, or of headers outside. Refuses headers that include each other.

usage: check_layers.py [ROOT]

Prints `FILE:LINE: what is wrong` for each such include and exits 1; exits 0 when there is none. A room is a folder. The
table ROOMS says for each room what it may include, without exceptions. The table PUBLIC_HEADERS says to which room
a public header belongs.
"""

import re
import sys
from dataclasses import dataclass
from pathlib import Path

# The public headers by the room to which they belong. Each room may include the public headers of the rooms that it may
# include, unless ROOMS says otherwise. waywright.hpp belongs to no room.
PUBLIC_HEADERS = {
    "values": {
        "agent",
        "assert",
        "error",
        "export",
        "hashes",
        "id",
        "item",
        "location",
        "memory_use",
        "mesh_snapshot",
        "point",
        "version",
    },
    "threads": {"job_system"},
    "exact": {"predicate_counts"},
    "clearance": {"clearance"},
    "path": {"path"},
    "world": {
        "change",
        "owned",
        "path_search",
        "query_context",
        "world",
        "world_options",
        "world_snapshot",
    },
    "watch": {"path_watch"},
    "io": {"replay", "save", "scenario", "scene", "script"},
    "svg": {"svg"},
}
HOME = {f"{header}.hpp": room for room, headers in PUBLIC_HEADERS.items() for header in headers}
ALL = None  # every public header, or any library
OF_ITS_ROOMS = "of its rooms"


@dataclass(frozen=True)
class Room:
    rooms: frozenset  # the rooms that it may include besides itself
    public: object = OF_ITS_ROOMS  # the public headers that it may include: those of its rooms and its own, ALL, or a set
    libraries: tuple = ()  # prefixes of permitted <> headers besides the standard library; ALL for any


def room(rooms, public=OF_ITS_ROOMS, libraries=()):
    return Room(frozenset(rooms), frozenset(public) if isinstance(public, set) else public, libraries)


BOOST = ("boost/",)
NUMBERS = {"base", "values", "memory"}
TRIANGULATION = NUMBERS | {"threads", "exact", "mesh", "locate", "delaunay"}
NAVIGATION = TRIANGULATION | {"constraint"}
WORLD = NAVIGATION | {"text", "clearance", "nav", "path"}

# By folder. A file belongs to the room with the longest folder name that contains it.
ROOMS = {
    "include/waywright": room([], ALL),
    "src/base": room([], libraries=ALL),
    "src/values": room(["base"]),
    "src/memory": room(["base", "values"], {"memory_use.hpp"}),
    "src/text": room(["base", "values"]),
    "src/threads": room(["base", "values"]),
    "src/exact": room(NUMBERS, libraries=BOOST),
    "src/mesh": room(NUMBERS, {"id.hpp", "error.hpp", "memory_use.hpp"}),
    "src/locate": room(NUMBERS | {"threads", "exact", "mesh"}),
    "src/delaunay": room(TRIANGULATION - {"delaunay"}),
    "src/constraint": room(TRIANGULATION | {"text"}),
    "src/clearance": room(NAVIGATION),
    "src/nav": room(NAVIGATION),
    "src/path": room(NAVIGATION | {"clearance", "nav"}),
    "src/world": room(WORLD, ALL),
    "src/watch": room(WORLD | {"world"}, ALL),
    "src/io": room(["base", "text"], ALL),
    "src/svg": room(["base", "text"], ALL),
    "bindings/python": room([], ALL, ("pybind11/",)),
    "bindings/c": room([], ALL, ("stddef.h", "stdint.h")),
    "bindings/wasm": room(["c"], ALL, ("malloc.h",)),
    "tools": room(["base", "text"], ALL, ALL),
    "tools/formats": room(["base", "text"], ALL, ALL),
    "examples": room([], ALL),
    "examples/lockstep": room([], ALL, BOOST),
    "bench": room(NAVIGATION | {"text"}, ALL, ALL),
    "tests": room(WORLD | {"world", "watch", "io", "svg", "formats", "oracle", "bench"}, ALL, ALL),
    "tests/oracle": room([], libraries=ALL),
}

FOLDERS = ("include", "src", "bindings", "tools", "examples", "bench", "tests")
HEADERS = {".hpp", ".inl", ".h"}
SUFFIXES = HEADERS | {".cpp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>|(\S+))')


def includes_of(text):
    """Yields (line number, path, whether quoted) for each include. The path is None if a macro gives it."""
    for number, line in enumerate(text.splitlines(), start=1):
        match = INCLUDE.match(line)
        if match:
            quoted, angled, _ = match.groups()
            yield number, quoted or angled, quoted is not None


def is_standard(path):
    """Returns whether an include between <> names a header of the C++ standard library."""
    return re.fullmatch(r"[a-z_]+", path) is not None


def room_of(file):
    """Returns the folder of ROOMS that contains a file, or None. The file's path is relative to the root."""
    folders = [folder.as_posix() for folder in file.parents if folder.as_posix() in ROOMS]
    return folders[0] if folders else None


class Checker:
    def __init__(self, root):
        self.root = root
        self.edges = {}  # by header: the headers of its room that it includes

    def find(self, file, path):
        """Returns the file, relative to the root, that an include between quotes names, or None."""
        part = file.parts[0]
        for folder in (file.parent, Path(part), Path("src"), Path("include"), Path("bench"), Path("tools")):
            if (self.root / folder / path).is_file():
                return folder / path
        return None

    def fault(self, file, path, quoted):
        """Returns what is wrong with an include in `file` (relative to the root), or None."""
        here = room_of(file)
        if path is None:
            return "an include by macro cannot be checked"
        if ".." in Path(path).parts:
            return f"'{path}': write includes from an include root, without '..'"
        target = self.find(file, path)
        if target is None:
            return self.library_fault(here, path, quoted)
        there = room_of(target)
        if there is None:
            return f"'{path}' is in no room that this check knows"
        if there == "include/waywright":
            if not self.knows(here, target.name):
                return f"{here} does not know waywright/{target.name}"
            if here == there:
                self.edges.setdefault(file, set()).add(target)
                home, other = HOME.get(file.name), HOME.get(target.name)
                if home is not None and other not in {home} | ROOMS[f"src/{home}"].rooms and not self.knows_all(home):
                    return f"waywright/{file.name} belongs to {home}, which does not know waywright/{target.name}"
            return None
        if not quoted:
            return f"<{path}>: write the project's own headers between quotes"
        if there != here and Path(there).name not in ROOMS[here].rooms and not there.startswith(f"{here}/"):
            return f"{here} may not include {there}"
        if there == here and file.suffix in HEADERS and target.suffix in HEADERS:
            self.edges.setdefault(file, set()).add(target)
        return None

    @staticmethod
    def knows_all(home):
        return ROOMS[f"src/{home}"].public is ALL

    @staticmethod
    def knows(here, header):
        """Returns whether a file of the room `here` may include a public header."""
        public = ROOMS[here].public
        if public != OF_ITS_ROOMS:
            return public is ALL or header in public
        return HOME.get(header) in ROOMS[here].rooms | {Path(here).name}

    def library_fault(self, here, path, quoted):
        if quoted:
            return f'"{path}": there is no such file'
        libraries = ROOMS[here].libraries
        if is_standard(path) or libraries is None or path.startswith(libraries or "//"):
            return None
        return f"<{path}>: {here} may not include this library"

    def cycles(self):
        """Reports each header that includes itself through others."""
        for start in sorted(self.edges):
            seen, waiting = set(), list(self.edges[start])
            while waiting:
                header = waiting.pop()
                if header == start:
                    yield f"{start}:1: includes itself through other headers"
                    break
                if header not in seen:
                    seen.add(header)
                    waiting.extend(self.edges.get(header, ()))

    def check(self):
        faults = []
        for folder in FOLDERS:
            for absolute in sorted((self.root / folder).rglob("*")):
                if absolute.suffix not in SUFFIXES:
                    continue
                file = absolute.relative_to(self.root)
                if room_of(file) is None:
                    faults.append(f"{file}:1: {file.parent} is no room that this check knows")
                    continue
                for number, path, quoted in includes_of(absolute.read_text(encoding="utf-8")):
                    fault = self.fault(file, path, quoted)
                    if fault:
                        faults.append(f"{file}:{number}: {fault}")
        return faults + list(self.cycles())


def main(arguments):
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    if not (root / "src").is_dir():
        print(f"{root}: no folder src", file=sys.stderr)
        return 2
    faults = Checker(root).check()
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
