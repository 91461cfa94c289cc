#!/usr/bin/env python3
"""Extracts the quick start from a page: its first ```cpp block, and its output, the ```text block that follows.

usage: extract_quick_start.py PAGE CODE_FILE OUTPUT_FILE [LANGUAGE]

LANGUAGE takes the place of `cpp`.
"""

import re
import sys
from pathlib import Path

BLOCKS = r"^```{}\n(?P<code>.*?)^```$.*?^```text\n(?P<output>.*?)^```$"


def main(arguments):
    if len(arguments) not in (3, 4):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    page, code_file, output_file = map(Path, arguments[:3])
    language = arguments[3] if len(arguments) == 4 else "cpp"
    blocks = re.compile(BLOCKS.format(re.escape(language)), re.MULTILINE | re.DOTALL)
    match = blocks.search(page.read_text(encoding="utf-8"))
    if match is None:
        print(f"{page}: no ```{language} block with a ```text block after it", file=sys.stderr)
        return 1
    code_file.write_text(match["code"], encoding="utf-8")
    output_file.write_text(match["output"], encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
