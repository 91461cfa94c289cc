"""Tests what scripts/extract_quick_start.py extracts from a README."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "extract_quick_start.py"

README = """# Title

```sh
./dev demo
```

```cpp
int main() {}
```

It prints

```text
first
```

```cpp
not this
```

```text
nor this
```
"""


class ExtractQuickStart(unittest.TestCase):
    def extract(self, readme, *language):
        with tempfile.TemporaryDirectory() as folder:
            files = [Path(folder) / name for name in ("README.md", "code.cpp", "output.txt")]
            files[0].write_text(readme, encoding="utf-8")
            result = subprocess.run([sys.executable, SCRIPT, *files, *language], check=False, capture_output=True)
            return result.returncode, *(file.read_text() if file.exists() else None for file in files[1:])

    def test_takes_the_first_blocks(self):
        self.assertEqual(self.extract(README), (0, "int main() {}\n", "first\n"))

    def test_takes_the_blocks_of_another_language(self):
        page = "```c\nint main(void);\n```\n" + README
        self.assertEqual(self.extract(page, "c"), (0, "int main(void);\n", "first\n"))

    def test_refuses_a_readme_without_output(self):
        self.assertEqual(self.extract(README.replace("```text", "```")), (1, None, None))

    def test_refuses_a_readme_without_code(self):
        self.assertEqual(self.extract(README.replace("```cpp", "```c")), (1, None, None))


if __name__ == "__main__":
    unittest.main()
