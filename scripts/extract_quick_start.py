#!/usr/bin/env python3
"""Extracts the quick start from README.md: its first ```cpp block, and its output, the ```text block that follows.

usage: extract_quick_start.py README CODE_FILE OUTPUT_FILE
"""

import re
import sys
from pathlib import Path

BLOCKS = re.compile(r"^```cpp\n(?P<code>.*?)^```$.*?^```text\n(?P<output>.*?)^```$", re.MULTILINE | re.DOTALL)


def main(arguments):
    if len(arguments) != 3:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    readme, code_file, output_file = map(Path, arguments)
    match = BLOCKS.search(readme.read_text(encoding="utf-8"))
    if match is None:
        print(f"{readme}: no ```cpp block with a ```text block after it", file=sys.stderr)
        return 1
    code_file.write_text(match["code"], encoding="utf-8")
    output_file.write_text(match["output"], encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
