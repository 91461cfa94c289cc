"""Compares the code in docs/c.md with the tests: each block after the quick start must be in snippets_test.c as it is.

usage: snippets_test.py ROOT
"""

import sys
from pathlib import Path


def main(arguments):
    root = Path(arguments[0])
    sys.path.insert(0, str(root / "scripts"))
    import check_docs

    source = (root / "tests/c/snippets_test.c").read_text(encoding="utf-8")
    blocks = [
        (first, lines)
        for first, language, lines in check_docs.blocks_of((root / "docs/c.md").read_text(encoding="utf-8"))
        if language == "c"
    ]
    missing = [first for first, lines in blocks[1:] if not check_docs.is_quoted(lines, source)]
    for first in missing:
        print(f"docs/c.md:{first}: these lines are not in tests/c/snippets_test.c")
    if len(blocks) < 2:
        print("docs/c.md has no code after the quick start")
        return 1
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
