"""Installs the package with pip, without a network, into a new folder, and runs the examples of its first docstring there.

usage: install.py FOLDER
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[2] / "bindings" / "python"
CHECK = """
import doctest, waywright
test = doctest.DocTestParser().get_doctest(waywright.__doc__, {}, "waywright", None, 0)
result = doctest.DocTestRunner().run(test)
assert result.failed == 0 and result.attempted > 2, result
print(waywright.__file__)
"""


def main(arguments):
    folder = Path(arguments[0])
    shutil.rmtree(folder, ignore_errors=True)
    pip = [sys.executable, "-m", "pip", "install", "--no-index", "--no-build-isolation", "--no-deps"]
    subprocess.run([*pip, "--target", folder, PACKAGE], check=True)
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    # The current folder comes first in the search for packages, and that of the test contains the package of the build.
    run = subprocess.run(
        [sys.executable, "-c", CHECK], env=environment, cwd=folder, check=True, capture_output=True, text=True
    )
    assert Path(run.stdout.strip()).is_relative_to(folder.resolve()), run.stdout
    for name in ("py.typed", "_core.pyi"):
        assert (folder / "waywright" / name).exists(), name
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
