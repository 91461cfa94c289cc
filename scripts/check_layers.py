#!/usr/bin/env python3
"""Refuses an include that points up the layers, or out of them.

usage: check_layers.py [ROOT]

Prints `FILE:LINE: what is wrong` for each such include and exits 1; exits 0 when there is none.
"""

import re
import sys
from pathlib import Path

# Each layer of src/, and the layers it may include besides itself.
LAYERS = {
    "base": set(),
    "memory": {"base"},
    "exact": {"base", "memory"},
    "mesh": {"base", "memory"},
    "locate": {"base", "memory", "exact", "mesh"},
    "delaunay": {"base", "memory", "exact", "mesh", "locate"},
    "constraint": {"base", "memory", "exact", "mesh", "locate", "delaunay"},
    "path": {"base", "memory", "exact", "mesh", "locate", "delaunay", "constraint"},
    "io": {"base", "exact", "mesh", "locate", "delaunay", "constraint"},
}

# Public headers that name single values; all layers but `mesh` may use those of what lies below them. The other public
# headers stand on the whole library.
VALUES = {"point.hpp", "id.hpp", "error.hpp", "memory_use.hpp"}
PUBLIC = {
    "base": set(),
    "memory": {"memory_use.hpp"},
    "exact": VALUES | {"predicate_counts.hpp"},
    "mesh": {"id.hpp", "error.hpp", "memory_use.hpp"},
    "locate": VALUES | {"job_system.hpp"},
    "delaunay": VALUES,
    "constraint": VALUES | {"item.hpp", "mesh_snapshot.hpp", "ray.hpp"},
    "path": VALUES | {"item.hpp", "path.hpp"},
    "io": None,
}

# What the benchmarks may look into, to compare arithmetics.
BENCH_LAYERS = {"base", "exact", "mesh", "locate", "delaunay", "constraint"}

SOURCE_SUFFIXES = {".cpp", ".hpp", ".h", ".ipp"}
CHECKED_FOLDERS = ["include", "src", "tools", "examples", "bench", "tests"]
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>|(\S+))')


def includes_of(text):
    """Yields (line number, path, whether quoted) for each include; a path given by a macro comes as None."""
    for number, line in enumerate(text.splitlines(), start=1):
        match = INCLUDE.match(line)
        if match:
            quoted, angled, _ = match.groups()
            yield number, quoted or angled, quoted is not None


def is_standard(path):
    """Whether an include between <> names a header of the C++ standard library."""
    return re.fullmatch(r"[a-z_]+", path) is not None


class Checker:
    def __init__(self, root):
        self.root = root

    def fault(self, file, path, quoted):
        """Says what is wrong with an include in `file` (relative to the root), or returns None."""
        if path is None:
            return "an include by macro cannot be checked"
        if ".." in Path(path).parts:
            return f"'{path}': write includes from an include root, without '..'"
        head, *rest = Path(path).parts
        part = file.parts[0]
        if head == "waywright" and rest:
            return self.public_fault(file, Path(*rest).as_posix())
        if head in LAYERS and (self.root / "src" / path).is_file():
            return self.layer_fault(file, head)
        if quoted:
            return self.own_fault(file, path)
        if is_standard(path):
            return None
        if part == "include":
            return f"<{path}>: public headers include the standard library and one another only"
        if file.parts[:2] == ("src", "base"):
            return None  # what depends on the compiler may include the compiler's own headers
        if part == "src" and head != "boost":
            return f"<{path}>: the library uses the standard library and Boost only"
        if part in ("tools", "examples") and head == "boost":
            return f"<{path}>: Boost is the library's private matter"
        return None

    def public_fault(self, file, header):
        part = file.parts[0]
        if is_oracle(file):
            return "the oracle shares nothing with the library; only its adapter knows both"
        if part != "src" or len(file.parts) == 2:
            return None
        allowed = PUBLIC.get(file.parts[1])
        if allowed is None or header in allowed:
            return None
        return f"{file.parts[1]} does not know waywright/{header}"

    def layer_fault(self, file, layer):
        part = file.parts[0]
        if part == "include":
            return f"a public header includes {layer}, which is private"
        if part == "tools" and layer == "base":
            return None
        if part in ("tools", "examples"):
            return f"{part} use the public headers only, not {layer}"
        if part == "bench" and layer not in BENCH_LAYERS:
            return f"bench may not look into {layer}"
        if part == "tests":
            return "the oracle shares nothing with the library" if is_oracle(file) else None
        if part == "src" and len(file.parts) > 2:
            own = file.parts[1]
            if layer != own and layer not in LAYERS[own]:
                return f"{own} may not include {layer}"
        return None

    def own_fault(self, file, path):
        """An include of a file that is neither public nor in a layer: it must be the including part's own."""
        part = file.parts[0]
        roots = {"src": ["src"], "tests": ["tests"], "bench": ["bench"]}.get(part, [])
        if part == "src" and len(file.parts) > 2:
            roots = []  # what lies in src/ itself stands above all layers
        candidates = [self.root / file.parent / path] + [self.root / root / path for root in roots]
        found = next((candidate for candidate in candidates if candidate.is_file()), None)
        if found is None:
            return f'"{path}": not a public header, not a lower layer, and not {part}\'s own'
        if is_oracle(file) and found.parent.name != "oracle":
            return f'"{path}": the oracle stands alone'
        return None

    def check(self):
        faults = []
        for folder in CHECKED_FOLDERS:
            for absolute in sorted((self.root / folder).rglob("*")):
                if absolute.suffix not in SOURCE_SUFFIXES:
                    continue
                file = absolute.relative_to(self.root)
                if folder == "src" and len(file.parts) > 2 and file.parts[1] not in LAYERS:
                    faults.append(f"{file}:1: src/{file.parts[1]} is no layer that this check knows")
                    continue
                for number, path, quoted in includes_of(absolute.read_text(encoding="utf-8")):
                    fault = self.fault(file, path, quoted)
                    if fault:
                        faults.append(f"{file}:{number}: {fault}")
        return faults


def is_oracle(file):
    return file.parts[:2] == ("tests", "oracle") and not file.stem.startswith("adapter")


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
