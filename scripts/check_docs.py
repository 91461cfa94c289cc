#!/usr/bin/env python3
"""Checks the quotations and the links in the Markdown pages.

usage: check_docs.py [ROOT]

- Each ```cpp block in docs/guides must be in one of the examples (a .cpp or .hpp file in examples or its folders), and each
  ```text block in the expected output of an example (a .txt file there): the same lines in the same order, apart from their common indentation.
- Each link to a file of the project must lead to an existing file or folder.

Prints `FILE:LINE: what is wrong` for each fault and exits 1; exits 0 when there is none.
"""

import re
import sys
import textwrap
from pathlib import Path

# The files that the blocks of each language quote.
SOURCES = {"cpp": "*.[ch]pp", "text": "*.txt"}
FENCE = re.compile(r"^```(\w*)$")
LINK = re.compile(r"\[[^\]]*\]\(([^)\s#]+)(?:#[^)]*)?\)")


def blocks_of(text):
    """Yields (number of the first line, language, code) for each fenced block."""
    language = None
    for number, line in enumerate(text.splitlines(), start=1):
        match = FENCE.match(line)
        if language is None and match:
            language, first, lines = match[1], number + 1, []
        elif language is not None and line == "```":
            yield first, language, lines
            language = None
        elif language is not None:
            lines.append(line)


def is_quoted(lines, source):
    """Returns whether the source contains these lines, one after the other."""
    source = source.splitlines()
    wanted = textwrap.dedent("\n".join(lines))
    starts = range(len(source) - len(lines) + 1)
    return any(textwrap.dedent("\n".join(source[i : i + len(lines)])) == wanted for i in starts)


def quote_faults(page, examples):
    for first, language, lines in blocks_of(page.read_text(encoding="utf-8")):
        if language not in SOURCES:
            continue
        sources = sorted(examples.rglob(SOURCES[language]))
        if not any(is_quoted(lines, source.read_text(encoding="utf-8")) for source in sources):
            yield first, f"these lines are in no file {SOURCES[language]} of examples; quote an example as it is"


def link_faults(page):
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), start=1):
        for target in LINK.findall(line):
            if ":" not in target and not (page.parent / target).exists():
                yield number, f"the link to {target} leads nowhere"


def check(root):
    for page in [*sorted(root.glob("*.md")), *sorted((root / "docs").rglob("*.md"))]:
        faults = list(link_faults(page))
        if page.parent == root / "docs" / "guides":
            faults += quote_faults(page, root / "examples")
        for number, fault in sorted(faults):
            yield f"{page.relative_to(root).as_posix()}:{number}: {fault}"


def main(arguments):
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    if not (root / "docs" / "guides").is_dir():
        print(f"{root}: no folder docs/guides", file=sys.stderr)
        return 2
    faults = list(check(root))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
