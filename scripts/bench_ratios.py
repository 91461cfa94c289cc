#!/usr/bin/env python3
"""Turns the JSON output of benchmark runs into a table that compares the library with its rivals.

usage: bench_ratios.py FILE...

Each FILE is the output of `./dev bench --benchmark_out=FILE --benchmark_out_format=json`, best with
`--benchmark_repetitions=5 --benchmark_enable_random_interleaving`, so that all contenders run under the same conditions.
Several files count as one longer run. Prints a Markdown table: for each workload and contender the median time of an
operation in microseconds, the spread of the repetitions (the width of their middle half in per cent of the median), the
number of vertices, and for rivals the ratio ours / rival (below 1: the library is faster). If a contender failed at a
workload, its row contains the error.
"""

import json
import statistics
import sys
from collections import defaultdict

OURS = "waywright"
FAILED = "failed: "
TIMED_BY = ("manual_time", "process_time", "real_time")  # suffixes that the benchmark library adds to names


def is_ours(contender):
    return contender == OURS or contender.startswith(OURS + "_")


def read_runs(file_names):
    """Returns {workload: {contender: [(microseconds, vertices), ...]}} in the order of their registration.

    For a contender that failed, the list contains the error, a string, instead.
    """
    runs = defaultdict(lambda: defaultdict(list))
    for file_name in file_names:
        with open(file_name, encoding="utf-8") as file:
            report = json.load(file)
        # Interleaving changes the order of the runs.
        for run in sorted(report["benchmarks"], key=lambda run: run["family_index"]):
            if run.get("run_type") == "aggregate":
                continue
            parts = [part for part in run["run_name"].split("/") if ":" not in part and part not in TIMED_BY]
            workload, contender = "/".join(parts[:-1]), parts[-1]
            if not run.get("error_occurred"):
                runs[workload][contender].append((run["per_op"] * 1e6, round(run.get("vertices", 0))))
            elif run["error_message"].startswith(FAILED):
                runs[workload][contender] = [run["error_message"]]
    return runs


def has_failed(runs):
    return isinstance(runs[0], str)


def median_time(runs):
    return statistics.median(time for time, _ in runs)


def spread(times):
    """Returns the width of the middle half in per cent of the median, or None for fewer than three times."""
    if len(times) < 3:
        return None
    low, _, high = statistics.quantiles(times, n=4, method="inclusive")
    return 100 * (high - low) / statistics.median(times)


def number(value):
    if value >= 100:
        return f"{value:,.0f}"
    return f"{value:.3g}" if value >= 1 else f"{value:.2f}"


def rows_of(workload, contenders):
    ours = [name for name in contenders if is_ours(name)]
    rivals = [name for name in contenders if not is_ours(name)]
    for name in ours + rivals:
        if has_failed(contenders[name]):
            yield [workload, name, contenders[name][0], "", "", ""]
            continue
        median = median_time(contenders[name])
        width = spread([time for time, _ in contenders[name]])
        ratio = ""
        if OURS in contenders and not has_failed(contenders[OURS]) and not is_ours(name):
            ratio = f"{median_time(contenders[OURS]) / median:.2f}"
        vertices = {count for _, count in contenders[name]}
        yield [
            workload,
            name,
            number(median),
            "" if width is None else f"{width:.0f} %",
            " or ".join(f"{count:,}" for count in sorted(vertices) if count),
            ratio,
        ]


def main(arguments):
    if not arguments or arguments[0].startswith("-"):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    print("| workload | contender | µs per operation | spread | vertices | ours / rival |")
    print("| --- | --- | ---: | ---: | ---: | ---: |")
    for workload, contenders in read_runs(arguments).items():
        for row in rows_of(workload, contenders):
            print("| " + " | ".join(row) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
