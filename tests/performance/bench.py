"""Runs step_benchmark on 1, 2 and 4 ranks and sums up; prints one JSON object last.

bench.py --build BUILD_FOLDER [--against OTHER_BUILD_FOLDER] [--record FILE]

With --against, two builds are measured in turns on 2 ranks and their ratio is reported: on a machine that does other
work too, only what was measured side by side can be compared.
"""

import argparse
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def measure(build, ranks, folder=None, program="step_benchmark"):
    """The JSON of one run of the benchmark."""
    command = ["mpirun", "-n", str(ranks), "--oversubscribe", str(build / "bin" / program)]
    if folder:
        command += ["--folder", str(folder)]
    done = subprocess.run(command, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout.strip().splitlines()[-1])


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


def summary(runs):
    """The figures that bars are set on, from the runs by number of ranks (2 at least)."""
    two = runs[2]
    rigid, elastic = two["rigid"], two["elastic"]
    result = {
        "rigid_double_ns": rigid["ns"],
        "rigid_single_ns": runs["single"]["rigid"]["ns"] if "single" in runs else None,
        "elastic_double_ns": elastic["ns"],
        "elastic_over_rigid": elastic["ns"] / rigid["ns"],
        "triad_gb_s": two["triad_gb_s"],
        "traffic_bound_ns": two["traffic_bound_ns"],
        "rigid_over_bound": rigid["ns"] / two["traffic_bound_ns"],
        "allocations_per_step": max(two[name]["allocations_per_step"] for name in samples(two)),
        "bytes_per_cell_rigid": rigid["bytes_per_cell"],
        "bytes_per_cell_elastic": elastic["bytes_per_cell"],
        "statistics_share": rigid["phases"]["statistics"]["ns"] / rigid["ns"],
    }
    for name in samples(two):
        if name not in ("rigid", "elastic"):
            result[f"{name}_over_rigid"] = two[name]["ns"] / rigid["ns"]
    if 1 in runs:
        result["efficiency_2"] = runs[1]["rigid"]["ns"] / (2 * rigid["ns"])
        # What the memory gives two ranks, over twice what it gives one.
        result["triad_efficiency_2"] = two["triad_gb_s"] / (2 * runs[1]["triad_gb_s"])
    return result


def compare(build, other):
    """Both builds in turns; the ratio of their medians, below 1 where `build` is faster."""
    speeds = {build: [], other: []}
    for _ in range(5):
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
    folder = pathlib.Path(tempfile.mkdtemp(dir=options.build))
    try:
        (folder / "checkpoints").mkdir()
        runs = {ranks: measure(options.build, ranks, folder if ranks == 2 else None) for ranks in (1, 2, 4)}
        if (options.build / "bin" / "step_benchmark_single").exists():
            runs["single"] = measure(options.build, 2, program="step_benchmark_single")
        for run in runs.values():
            show(run)
        result = summary(runs)
        written = runs[2]["elastic"]["checkpoint"]
        result["checkpoint_over_dd"] = written["dd_seconds"] / written["seconds"]
    finally:
        shutil.rmtree(folder)
    if options.record:
        options.record.write_text(json.dumps({"summary": result, "runs": runs}, indent=1) + "\n")
    sys.stdout.flush()
    print(json.dumps(result))


if __name__ == "__main__":
    main()
