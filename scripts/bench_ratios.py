#!/usr/bin/env python3
"""Turns the JSON output of benchmark runs into a table that compares the library with its rivals.

usage: bench_ratios.py FILE...

Each FILE is the output of `./dev bench --benchmark_out=FILE --benchmark_out_format=json`, best with
`--benchmark_repetitions=5 --benchmark_enable_random_interleaving`, so that all contenders run under the same conditions.
Several files count as one longer run. Prints a Markdown table: for each workload and contender the median time of an
operation in microseconds, the spread of the repetitions (the width of their middle half in per cent of the median), the
number of vertices, and for rivals the ratio ours / rival (below 1: the library is faster). If a contender failed at a
workload, its row contains the error. A second table lists the benchmarks without a time of an operation, with the medians
of their counters.
"""

import json
import statistics
import sys
from collections import defaultdict

OURS = "waywright"
FAILED = "failed: "
OF_EACH_RUN = (  # numbers of a run that are not counters
    "family_index",
    "per_family_instance_index",
    "repetitions",
    "repetition_index",
    "threads",
    "iterations",
    "real_time",
    "cpu_time",
)
TIMED_BY = ("manual_time", "process_time", "real_time")  # suffixes that the benchmark library adds to names


def is_ours(contender):
    return contender == OURS or contender.startswith(OURS + "_")


def each_run(file_names):
    """Yields (parts of the name, results) of each run, in the order in which the program registered the benchmarks."""
    for file_name in file_names:
        with open(file_name, encoding="utf-8") as file:
            report = json.load(file)
        # Interleaving changes the order of the runs.
        for run in sorted(report["benchmarks"], key=lambda run: run["family_index"]):
            if run.get("run_type") != "aggregate":
                yield [part for part in run["run_name"].split("/") if ":" not in part and part not in TIMED_BY], run


def read_counters(file_names):
    """Returns {benchmark: {counter: [value, ...]}} of the benchmarks without a time of an operation."""
    counters = defaultdict(lambda: defaultdict(list))
    for parts, run in each_run(file_names):
        if run.get("error_occurred") or "per_op" in run:
            continue
        for name, value in run.items():
            if isinstance(value, (int, float)) and not isinstance(value, bool) and name not in OF_EACH_RUN:
                counters["/".join(parts)][name].append(value)
    return counters


def read_runs(file_names):
    """Returns {workload: {contender: [(microseconds, vertices), ...]}} in the order of their registration.

    For a contender that failed, the list contains the error, a string, instead.
    """
    runs = defaultdict(lambda: defaultdict(list))
    for parts, run in each_run(file_names):
        workload, contender = "/".join(parts[:-1]), parts[-1]
        if run.get("error_occurred"):
            if run["error_message"].startswith(FAILED):
                runs[workload][contender] = [run["error_message"]]
        elif "per_op" in run:
            runs[workload][contender].append((run["per_op"] * 1e6, round(run.get("vertices", 0))))
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
    runs = read_runs(arguments)
    if runs:
        print("| workload | contender | µs per operation | spread | vertices | ours / rival |")
        print("| --- | --- | ---: | ---: | ---: | ---: |")
    for workload, contenders in runs.items():
        for row in rows_of(workload, contenders):
            print("| " + " | ".join(row) + " |")
    counters = read_counters(arguments)
    if counters:
        print("\n" * bool(runs) + "| benchmark | medians |")
        print("| --- | --- |")
    for benchmark, values in counters.items():
        print(f"| {benchmark} | " + ", ".join(f"{name} {number(statistics.median(v))}" for name, v in values.items()) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
