"""Measures a step on 1, 2 and 4 ranks and sums up; prints one JSON object last.

bench.py --build BUILD_FOLDER [--against OTHER_BUILD_FOLDER] [--record FILE]

A machine that does other work too is now faster and now slower: only what was measured side by side can be compared. So
one rank, two, and two in single precision take turns; times are medians over the turns, ratios medians of those
within a turn. With --against, two builds are measured in turns on 2 ranks and their ratio is reported.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
TURNS = 5


def measure(build, ranks, program="step_benchmark", options=()):
    """The JSON of one run of the benchmark."""
    command = ["mpirun", "-n", str(ranks), "--oversubscribe", str(build / "bin" / program), *options]
    done = subprocess.run(command, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout.strip().splitlines()[-1])


def measure_in_turns(build):
    """One {1: run, 2: run, "single": run} a turn, "single" where it was built."""
    once = ("--repetitions", "1")
    turns = []
    for _ in range(TURNS):
        turn = {ranks: measure(build, ranks, options=once) for ranks in (1, 2)}
        if (build / "bin" / "step_benchmark_single").exists():
            turn["single"] = measure(build, 2, "step_benchmark_single", once)
        turns.append(turn)
    return turns


def measure_checkpoint(build):
    """A checkpoint of the case with a layer, on 2 ranks, and dd, in turns."""
    with tempfile.TemporaryDirectory(dir=build) as folder:
        options = ("--sample", "elastic", "--repetitions", "1", "--folder", folder)
        return measure(build, 2, options=options)["elastic"]["checkpoint"]


def median_of(values):
    """The median of numbers; of dictionaries of them, key by key; of anything else, which is the same, the first."""
    first = values[0]
    if isinstance(first, dict):
        return {key: median_of([value[key] for value in values]) for key in first}
    return statistics.median(values) if isinstance(first, (int, float)) else first


def median_run(runs):
    """What one run would have been."""
    result = median_of(runs)
    for name in samples(result):
        speeds = [run[name]["ns"] for run in runs]
        result[name].update(ns_min=min(speeds), ns_max=max(speeds))
    return result


def samples(run):
    """The names of what was measured: "rigid", "elastic" (the default formulation) and the other formulations."""
    return [name for name in run if name == "rigid" or name.startswith("elastic")]


def show(run):
    """One table a run, for people."""
    for name in samples(run):
        sample = run[name]
        grid = " x ".join(map(str, sample["grid"]))
        print(f"{name}, {grid}, {run['precision']}, {run['ranks']} ranks: {sample['ns']:.1f} ns per cell and step "
              f"({sample['ns_min']:.1f} to {sample['ns_max']:.1f}), {sample['bytes_per_cell']:.0f} bytes per cell, "
              f"{sample['allocations_per_step']:.0f} allocations a step")
        for phase, record in sample["phases"].items():
            if record["ns"] > 0.005:
                print(f"    {phase:14} {record['ns']:8.2f} ns, of a processor {record['processor_ns']:8.2f} ns, "
                      f"{record['messages']:6.0f} messages, {record['bytes'] / 1e6:8.2f} MB a step")


def median_ratio(turns, above, below):
    """Both are functions of a turn."""
    return statistics.median(above(turn) / below(turn) for turn in turns)


def summary(turns):
    """The figures that bars are set on."""
    two = median_run([turn[2] for turn in turns])

    def rigid(turn):
        return turn[2]["rigid"]["ns"]

    def over_rigid(name):
        return median_ratio(turns, lambda turn: turn[2][name]["ns"], rigid)

    result = {
        "rigid_double_ns": two["rigid"]["ns"],
        "rigid_single_ns": None,
        "elastic_double_ns": two["elastic"]["ns"],
        "elastic_over_rigid": over_rigid("elastic"),
        "triad_gb_s": two["triad_gb_s"],
        "traffic_bound_ns": two["traffic_bound_ns"],
        "rigid_over_bound": median_ratio(turns, rigid, lambda turn: turn[2]["traffic_bound_ns"]),
        "efficiency_2": median_ratio(turns, lambda turn: turn[1]["rigid"]["ns"], lambda turn: 2 * rigid(turn)),
        # What the memory gives two ranks, over twice what it gives one.
        "triad_efficiency_2": median_ratio(turns, lambda turn: turn[2]["triad_gb_s"],
                                           lambda turn: 2 * turn[1]["triad_gb_s"]),
        "allocations_per_step": max(turn[2][name]["allocations_per_step"] for turn in turns for name in samples(two)),
        "bytes_per_cell_rigid": two["rigid"]["bytes_per_cell"],
        "bytes_per_cell_elastic": two["elastic"]["bytes_per_cell"],
        "statistics_share": two["rigid"]["phases"]["statistics"]["ns"] / two["rigid"]["ns"],
    }
    if "single" in turns[0]:
        result["rigid_single_ns"] = statistics.median(turn["single"]["rigid"]["ns"] for turn in turns)
        result["single_over_double"] = median_ratio(turns, lambda turn: turn["single"]["rigid"]["ns"], rigid)
    for name in samples(two):
        if name not in ("rigid", "elastic"):
            result[f"{name}_over_rigid"] = over_rigid(name)
    return result


def compare(build, other):
    """Both builds in turns; the ratio of their medians, below 1 where `build` is faster."""
    speeds = {build: [], other: []}
    for _ in range(TURNS):
        for each in (build, other):
            speeds[each].append(measure(each, 2))
    ratio = {}
    for name in samples(speeds[build][0]):
        if name not in speeds[other][0]:
            continue
        new, old = ([run[name]["ns"] for run in speeds[each]] for each in (build, other))
        ratio[name] = {"new_ns": statistics.median(new), "old_ns": statistics.median(old),
                       "new_ns_min": min(new), "old_ns_min": min(old),
                       "ratio": statistics.median(new) / statistics.median(old), "ratio_of_minima": min(new) / min(old)}
    return ratio


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--against", type=pathlib.Path)
    parser.add_argument("--record", type=pathlib.Path, help="file for everything measured, JSON")
    options = parser.parse_args()
    if options.against:
        print(json.dumps(compare(options.build, options.against)))
        return
    turns = measure_in_turns(options.build)
    runs = {ranks: median_run([turn[ranks] for turn in turns]) for ranks in turns[0]}
    runs[4] = measure(options.build, 4)
    for run in runs.values():
        show(run)
    result = summary(turns)
    result["checkpoint_over_dd"] = measure_checkpoint(options.build)["over_dd"]
    if options.record:
        options.record.write_text(json.dumps({"summary": result, "runs": runs, "turns": turns}, indent=1) + "\n")
    sys.stdout.flush()
    print(json.dumps(result))


if __name__ == "__main__":
    main()
