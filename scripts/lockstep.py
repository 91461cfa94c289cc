#!/usr/bin/env python3
"""Plays the lockstep game of examples/lockstep: a host, a second player and a machine that joins late, each a process.

usage: lockstep.py PROGRAM [--expect-desync] [OPTION...]

PROGRAM is lockstep_game. Prints what each process prints, and exits with 1 if a process fails or if their final states
differ. The OPTIONs go to all processes; an option for one of them has its name in front, as in `--join:threads 2`. With
`--expect-desync`, the states must differ, and the processes must say so.

  --no-watcher  without the machine that joins late
"""

import subprocess
import sys


def options_of(role, arguments):
    """Returns the options for one process. `arguments` are pairs of a name and a value."""
    for name, value in zip(arguments[::2], arguments[1::2]):
        target, colon, rest = name.removeprefix("--").partition(":")
        if not colon:
            yield from (name, value)
        elif target == role:
            yield from (f"--{rest}", value)


def play(program, watchers, arguments):
    """Yields (role, exit status, output) for each process."""

    def start(role, *first):
        command = [program, *first, *options_of(role, arguments)]
        return role, subprocess.Popen(command, stdout=subprocess.PIPE, text=True)

    host = start("host", "--host", "--watchers", str(watchers))
    port = host[1].stdout.readline().split()[-1]
    processes = [host, start("join", "--join", port)]
    processes += [start("watch", "--watch", port) for _ in range(watchers)]
    for role, process in processes:
        try:
            output, _ = process.communicate(timeout=600)
        except subprocess.TimeoutExpired:
            process.kill()
            output, _ = process.communicate()
        yield role, process.returncode, output


def main(arguments):
    if not arguments or arguments[0] in ("-h", "--help"):
        print(__doc__, file=sys.stderr)
        return 2
    program, *rest = arguments
    flags = {"--expect-desync", "--no-watcher"}
    watchers = 0 if "--no-watcher" in rest else 1
    expects_desync = "--expect-desync" in rest
    results = list(play(program, watchers, [word for word in rest if word not in flags]))
    for role, status, output in results:
        for line in output.splitlines():
            print(f"{role:5}  {line}")
        print(f"{role:5}  exit status {status}")
    final = {line for _, _, output in results for line in output.splitlines() if line.startswith("final: ")}
    if expects_desync:
        return 0 if any(status == 1 and "first difference" in output for _, status, output in results) else 1
    if len(final) != 1:
        print("the final states differ")
    return 0 if len(final) == 1 and all(status == 0 for _, status, _ in results) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
