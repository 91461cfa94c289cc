"""Compares the symbols that the C library exports with bindings/c/symbols.txt, with the functions of waywright.h and with
the table in docs/languages.md.

usage: symbols_test.py NM READELF LIBRARY ROOT SONAME
"""

import re
import subprocess
import sys
from pathlib import Path


def exported_by(nm, library):
    """Returns the names of the functions that a library exports. The name of a version is an absolute symbol: kind A."""
    run = subprocess.run([nm, "-D", "--defined-only", library], check=True, capture_output=True, text=True)
    symbols = [line.split()[1:3] for line in run.stdout.splitlines()]
    return {name.split("@")[0] for kind, name in symbols if kind != "A"}


# The classes whose member functions the table must name. The other classes are mostly data.
CLASSES = {
    "world.hpp": "World",
    "path_search.hpp": "PathSearch",
    "path.hpp": "Path",
    "path_watch.hpp": "PathWatch",
    "replay.hpp": "ReplayWriter",
}
MEMBER = re.compile(r"^  (?:\[\[nodiscard\]\] )?(?:static )?(?:const )?[A-Za-z][\w:<>]*(?:<[\w:, ]+>+)?[&*]? (?P<name>[a-z_]+)\(", re.MULTILINE)


# The functions outside of classes. The table has one row for the arithmetic in point.hpp.
FREE = re.compile(r"^(?:\[\[nodiscard\]\] )?WAYWRIGHT_API [^;{(]*?\b(?P<name>[a-z_]\w*)\(", re.MULTILINE)


def free_functions_of(root):
    """Yields the functions outside of classes that the table must name: `save_world`."""
    for header in sorted(Path(root, "include/waywright").glob("*.hpp")):
        if header.name != "point.hpp":
            yield from sorted({match["name"] for match in FREE.finditer(header.read_text(encoding="utf-8"))})


def members_of(root):
    """Yields the public functions of C++ that the table must name: `World::insert`."""
    for header, name in CLASSES.items():
        text = Path(root, "include/waywright", header).read_text(encoding="utf-8")
        body = re.search(rf"^(?:class|struct) WAYWRIGHT_API {name} {{$(.*?)^}};$", text, re.MULTILINE | re.DOTALL)[1]
        functions = {match["name"] for match in MEMBER.finditer(body.partition(" private:")[0])}
        yield from (f"{name}::{function}" for function in sorted(functions))


def main(arguments):
    nm, readelf, library, root, soname = arguments
    folder = Path(root, "bindings/c")
    listed = (folder / "symbols.txt").read_text(encoding="utf-8").split()
    header = (folder / "waywright.h").read_text(encoding="utf-8")
    page = Path(root, "docs/languages.md").read_text(encoding="utf-8")
    rows = [line.split(" | ") for line in page.splitlines() if line.startswith("| ")]
    in_cpp, in_c = ("\n".join(row[column] for row in rows) for column in (1, 2))
    named = {
        "the library exports": exported_by(nm, library),
        "waywright.h declares": set(re.findall(r"^WW_API [^;(]*?(ww_\w+)\(", header, re.MULTILINE)),
        # The table also names four types.
        "docs/languages.md names": set(re.findall(r"`(ww_\w+)`", in_c)) - {"ww_status", "ww_shape", "ww_agent", "ww_job_system"},
    }
    faults = [f"{what} {name}; symbols.txt does not" for what, names in named.items() for name in names - set(listed)]
    faults += [f"symbols.txt has {name}; not so: {what}" for what, names in named.items() for name in set(listed) - names]
    members = list(members_of(root))
    faults += [f"docs/languages.md does not name {member}" for member in members if f"`{member}`" not in in_cpp]
    functions = list(free_functions_of(root))
    faults += [f"docs/languages.md does not name {name}()" for name in functions if not re.search(rf"`{name}\b", in_cpp)]
    if listed != sorted(set(listed)):
        faults.append("symbols.txt is not sorted")
    dynamic = subprocess.run([readelf, "-d", library], check=True, capture_output=True, text=True).stdout
    if f"[{soname}]" not in dynamic or not re.search(r"\.so\.\d+\.\d+$", soname):
        faults.append(f"the soname is not {soname}, with two numbers:\n{dynamic}")
    print("\n".join(faults) if faults else f"{len(listed)} functions in C; in C++ {len(members)} members and {len(functions)} others")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
