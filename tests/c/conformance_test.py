"""Runs world scripts by the command and through the C interface, and compares all answers and hashes.

usage: conformance_test.py COMMAND RUN_SCRIPT FOLDER FILE_OR_FOLDER...

COMMAND is the program waywright, RUN_SCRIPT the program tests/c/run_script.c. Runs each script twice: as it is, and with a
hash after each operation, many queries between them and a wrong hash of a tick. Writes the longer scripts to FOLDER. If a
script contains answers in comments, compares the answers of the command with them.
"""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "support"))
from world_scripts import answers, check_known, with_queries  # noqa: E402


def scripts_of(paths):
    for path in map(Path, paths):
        yield from sorted(path.glob("*.wws")) if path.is_dir() else [path]


def main(arguments):
    command, run_script, folder, *paths = arguments
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    count, kinds = 0, {}
    for script in scripts_of(paths):
        text, longer = script.read_text(encoding="utf-8"), folder / script.name
        longer.write_text(with_queries(text), encoding="utf-8")
        check_known(script, text, answers([command, "run", script]))
        for each in (script, longer):
            expected, actual = answers([command, "run", each]), answers([run_script, each])
            for here, there in zip(expected, actual):
                if here != there:
                    sys.exit(f"{each}: the command answers\n{here}\nand C answers\n{there}")
            if len(expected) != len(actual):
                sys.exit(f"{each}: {len(expected)} answers of the command, {len(actual)} of C")
            count += len(expected)
            for answer in expected:
                kinds[answer["op"]] = kinds.get(answer["op"], 0) + 1
    if len(kinds) < 8:
        sys.exit(f"only these kinds of lines have answers: {kinds}")
    print(f"{count} equal answers: {kinds}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
