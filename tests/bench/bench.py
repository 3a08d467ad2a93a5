"""Runs the benchmark, each measurement in a process of its own, and prints a table.

    bench.py PROGRAM [--particles N,N] [--threads N,N] [--case TEXT] [--output FOLDER] [--against FILE]
             [--count-by PROGRAM]

PROGRAM is `trajan_bench`, and that to count by `count_instructions`: then `bench.json` has instructions per particle and
step, of kernels for x86-64-v3 and 2000 particles, and what share of them each function has. FOLDER (default build/bench)
gets `bench.json` and `roofline.png`. Without --particles all cases run at 10^5 particles, the colliding discs also at 10^3,
10^4 and 10^6; without --threads the discs and the block run on one and two threads, the others on one. --against compares
with another `bench.json`.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "instructions"))
import count

DISCS, BLOCK = "discs/MUSL", "block/MUSL"


def run_program(program, *words):
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"bench: {' '.join(map(str, words))}: {done.stderr.strip() or 'exit ' + str(done.returncode)}")
    return done.stdout


def wanted(program, options):
    """(case, particles, threads) of everything to be measured."""
    for case in run_program(program, "--list").split():
        if options.case not in case:
            continue
        sizes = options.particles or ([1e3, 1e4, 1e5, 1e6] if case == DISCS else [1e5])
        for particles in sizes:
            threads = options.threads or ([1, 2] if case in (DISCS, BLOCK) and particles >= 1e5 else [1])
            for count in threads:
                yield case, particles, count


def summary(row, machine):
    """The row's figures: medians and spreads over repetitions, and ratios to what the machine can do."""
    median = statistics.median(row["ns"])
    spread = 0.0
    if len(row["ns"]) > 2:
        quartiles = statistics.quantiles(row["ns"], n=4)
        spread = (quartiles[2] - quartiles[0]) / median
    figures = {
        "median_ns": median,
        "spread": spread,
        "solver_bytes_per_particle": row["solver_bytes"] / row["particles"],
        "peak_bytes_per_particle": row["peak_bytes"] / row["particles"],
    }
    if row["explicit"]:
        memory_ns = 1e9 * row["bytes_moved"] / machine["triad_bytes_per_s"]
        arithmetic_ns = 2e9 * row["multiply_adds"] / machine["multiply_add_flop_per_s"]
        figures["over_memory_limit"] = median * row["threads"] / memory_ns
        figures["over_arithmetic_limit"] = median * row["threads"] / arithmetic_ns
    return figures


def name_of(row):
    return f"{row['case']} {row['particles']:.0e} x{row['threads']}".replace("e+0", "e")


def print_row(row):
    ratios = ""
    if row["explicit"]:
        ratios = f"{row['bytes_moved']:7.0f} {row['over_memory_limit']:7.1f} {row['over_arithmetic_limit']:7.1f} {row['start_s']:8.3f}"
    print(
        f"{row['case']:<36} {row['particles']:>9} {row['threads']:>2} {row['median_ns']:9.1f} {100 * row['spread']:5.0f}% "
        f"{row['solver_bytes_per_particle']:7.0f} {row['peak_bytes_per_particle']:7.0f} {ratios}",
        flush=True,
    )


def measure(program, options):
    machine = json.loads(run_program(program, "--machine"))
    print(
        f"{machine['instruction_set']}: triad {machine['triad_bytes_per_s'] / 1e9:.1f} GB/s, "
        f"multiply-adds {machine['multiply_add_flop_per_s'] / 1e9:.1f} Gflop/s, one core"
    )
    print(
        f"{'case':<36} {'particles':>9} {'th':>2} {'ns':>9} {'spread':>6} {'B/part':>7} {'peak':>7} "
        f"{'B/step':>7} {'/memory':>7} {'/arith.':>7} {'start s':>8}"
    )
    rows = []
    for case, particles, threads in wanted(program, options):
        row = json.loads(run_program(program, case, particles, threads))
        row.update(summary(row, machine))
        print_row(row)
        rows.append(row)
    print("ns: per particle and step, median; spread: between its quartiles; B/part: bytes per particle of the solver;")
    print("peak: of the process; B/step: moved per particle and step, by counting; /memory, /arith.: times what memory")
    print("(B/step at the triad's speed) and arithmetic (multiply-adds of the transfers alone) would take")
    return {"date": time.strftime("%Y-%m-%d %H:%M"), "processors": os.cpu_count(), "machine": machine, "rows": rows}


def add_instructions(result, program):
    """To the rows of one thread, and prints which functions they are in."""
    print("\ninstructions per particle and step; the functions with the largest shares of them, in %")
    counts = count.count(program)
    for row in result["rows"]:
        if row["case"] not in counts or row["threads"] > 1:
            continue
        row["instructions"], _, row["profile"] = counts[row["case"]]
        print(f"{row['case']:<36} {row['particles']:>9} {row['instructions']:7.0f}  {count.largest(row['profile'])}")


def draw_roofline(result, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    machine, rows = result["machine"], [row for row in result["rows"] if row["explicit"] and row["threads"] == 1]
    if not rows:
        return
    figure, axes = plt.subplots(figsize=(9, 6))
    intensities = [2 * row["multiply_adds"] / row["bytes_moved"] for row in rows]
    edges = [min(intensities) / 2, max(intensities) * 4]
    bandwidth, peak = machine["triad_bytes_per_s"] / 1e9, machine["multiply_add_flop_per_s"] / 1e9
    steps = [edges[0] * (edges[1] / edges[0]) ** (i / 200) for i in range(201)]
    axes.loglog(steps, [min(peak, bandwidth * x) for x in steps], color="black")
    axes.text(2, bandwidth * 2 * 1.3, f"triad {bandwidth:.1f} GB/s", ha="right")
    axes.text(edges[1], peak * 1.05, f"multiply-adds {peak:.0f} Gflop/s", ha="right")
    for row, intensity in zip(rows, intensities):
        speed = 2 * row["multiply_adds"] / row["median_ns"]
        axes.plot(intensity, speed, "o", markersize=4)
        axes.annotate(name_of(row), (intensity, speed), fontsize=6, xytext=(3, 3), textcoords="offset points")
    axes.set_xlabel("flop of the transfers per byte moved, by counting")
    axes.set_ylabel("Gflop/s of the transfers, one thread")
    axes.grid(True, which="both", linewidth=0.3)
    figure.tight_layout()
    figure.savefig(path, dpi=150)


def compare(result, other):
    """Prints the ratio of each row to the other result's; marks those beyond both spreads."""
    before = {(row["case"], row["particles"], row["threads"]): row for row in other["rows"]}
    triads = [one["machine"]["triad_bytes_per_s"] / 1e9 for one in (other, result)]
    print(f"\nagainst {other['date']}; triad {triads[0]:.1f} GB/s then, {triads[1]:.1f} now")
    print(f"{'case':<36} {'particles':>9} {'th':>2} {'before':>8} {'now':>8} {'ratio':>6}  bytes")
    changed = 0
    for row in result["rows"]:
        old = before.get((row["case"], row["particles"], row["threads"]))
        if old is None:
            print(f"{row['case']:<36} {row['particles']:>9} {row['threads']:>2} {'new':>8}")
            continue
        ratio = row["median_ns"] / old["median_ns"]
        beyond = abs(ratio - 1) > max(row["spread"] + old["spread"], 0.02)
        changed += beyond
        mark = ("slower" if ratio > 1 else "faster") if beyond else ""
        bytes_ratio = row["solver_bytes"] / old["solver_bytes"]
        print(
            f"{row['case']:<36} {row['particles']:>9} {row['threads']:>2} {old['median_ns']:8.1f} {row['median_ns']:8.1f} "
            f"{ratio:6.2f}  {bytes_ratio:5.2f} {mark}"
        )
    print(f"{changed} rows changed by more than both spreads together")


def numbers(kind):
    return lambda text: [kind(float(word)) for word in text.split(",")]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--particles", type=numbers(float), help="sizes, for example 1e3,1e6,1e7")
    parser.add_argument("--threads", type=numbers(int), help="for example 1,2")
    parser.add_argument("--case", default="", help="only cases whose name has this in it")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("build/bench"))
    parser.add_argument("--count-by", type=pathlib.Path, metavar="PROGRAM", help="count instructions too")
    parser.add_argument("--against", type=pathlib.Path, help="another bench.json to compare with")
    options = parser.parse_args()
    other = json.loads(options.against.read_text()) if options.against else None
    result = measure(options.program, options)
    if options.count_by:
        add_instructions(result, options.count_by)
    options.output.mkdir(parents=True, exist_ok=True)
    (options.output / "bench.json").write_text(json.dumps(result, indent=1) + "\n")
    draw_roofline(result, options.output / "roofline.png")
    print(f"written: {options.output}/bench.json, {options.output}/roofline.png")
    if other:
        compare(result, other)


if __name__ == "__main__":
    main()
