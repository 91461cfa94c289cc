"""Runs the quick start of docs/javascript.md and compares its output with the printed one.

usage: quick_start_test.py NODE PROGRAM EXPECTED
"""

import subprocess
import sys
from pathlib import Path

node, program, expected = sys.argv[1:]
output = subprocess.run([node, program], check=True, capture_output=True, text=True, encoding="utf-8", timeout=60).stdout
if output != Path(expected).read_text(encoding="utf-8"):
    sys.exit(f"the quick start prints\n{output}")
