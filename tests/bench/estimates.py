#!/usr/bin/env python3
"""Estimates scenes of the gallery and variations of them by the real service, runs them, and prints both.

    tests/bench/estimates.py [--programs build/release/bin] [--state DIR] [--part I/N]

One job after the other, on a machine that does nothing else: about four minutes. Each is estimated twice: by a probe
of a part of it, as `trajan estimate` does, and without one, as of every job that is submitted (MODEL, or HISTORY where
a job of the same scene has finished). With --state what was measured is kept, so that parts can follow each other.
"""

import argparse
import contextlib
import json
import os
import pathlib
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

PROBE = 0.8  # seconds, as `trajan estimate` has them by default
FINER = "domain.cell_size={}"

# Scenes and what is changed in them, so that most take longer than the probe.
JOBS = [
    # explicit, bar and plane: schemes, transfers, shape functions
    ("bar_musl", [FINER.format(0.0625)]),
    ("bar_usl", [FINER.format(0.0625)]),
    ("bar_tlmpm", [FINER.format(0.0625)]),
    ("bar_musl", ["numerics.shape_functions=gimp"]),
    ("bar_musl", ["numerics.shape_functions=quadratic_bspline"]),
    ("bar_musl", ["numerics.shape_functions=cubic_bspline"]),
    ("bar_musl", ["numerics.shape_functions=cpdi"]),
    ("bar_musl", ["numerics.scheme=USAVG"]),
    ("bar_musl", ["numerics.transfer=XPIC"]),
    ("bar_tlmpm", ["numerics.shape_functions=quadratic_bspline"]),
    ("compliant_bar", []),
    ("compliant_bar", ["numerics.shape_functions=quadratic_bspline"]),
    ("compliant_bar", ["numerics.time_step_fraction=0.25"]),
    ("ss_beam", []),
    ("cantilever_static", ["analysis.relaxation={}", "numerics.scheme=TLMPM"]),
    ("free_flight", []),
    ("axis_aligned", []),
    ("generalized_vortex", []),
    ("rotating_block", []),
    ("wave_transmission", []),
    ("discs", [FINER.format(0.025)]),
    ("discs", [FINER.format(0.025), "numerics.transfer=FMPM"]),
    ("hanging_rod", [FINER.format(0.0009765625)]),
    # fluids, plasticity, damage
    ("dam_break", []),
    ("taylor_bar", []),
    ("taylor_bar", ["numerics.scheme=TLMPM", "numerics.shape_functions=linear"]),
    ("rock_compression", [FINER.format(1)]),
    ("compressed_cylinder", [FINER.format(0.03125)]),
    # contact
    ("blocks_on_incline", []),
    ("oblique_discs", []),
    ("hertz", []),
    ("impacting_bars", [FINER.format(0.005)]),
    ("sliding_block", [FINER.format(0.03125)]),
    # axisymmetric
    ("hollow_sphere", [FINER.format(0.03125)]),
    ("hollow_sphere", ["numerics.scheme=MUSL", FINER.format(0.03125)]),
    ("thick_cylinder", [FINER.format(0.015625)]),
    ("rotating_disc", [FINER.format(0.0078125)]),
    # solid
    ("spheres", []),
    ("hollow_sphere_solid", []),
    ("patch_test_solid", [FINER.format(0.125)]),
    # implicit: load steps, arc length, motions; modes, buckling
    ("cantilever_static", [FINER.format(0.05)]),
    ("elastica_end_load", []),
    ("elastica_end_load", ["numerics.shape_functions=linear", "domain.cell_size=0.25"]),
    ("cook_membrane", [FINER.format(1)]),
    ("cook_membrane_linear", [FINER.format(0.5)]),
    ("toggle_frame", []),
    ("bar_tlmpm", ["analysis.implicit_dynamics={time_steps: 40}"]),
    ("beam_modes", [FINER.format(0.03125)]),
    ("column_buckling", [FINER.format(0.03125)]),
]


@contextlib.contextmanager
def server(programs, state):
    environment = dict(os.environ, XDG_STATE_HOME=str(state))
    environment.pop("TRAJAN_SERVER", None)
    log = open(state / "server.log", "a")
    process = subprocess.Popen(
        [programs / "trajan", "serve", "--workers", "1", "--threads-per-worker", "1", "--log-level", "info"],
        env=environment, stdout=subprocess.PIPE, stderr=log, text=True)
    process.stdout.readline()

    def trajan(*arguments):
        return subprocess.run([programs / "trajan", *arguments], env=environment, check=True, capture_output=True,
                              text=True).stdout

    yield trajan
    process.terminate()
    process.wait()


def wait_for_calibration(trajan):
    while "wall_seconds" not in json.loads(trajan("estimate", "bar_usl", "--probe", "0", "-o", "json")):
        time.sleep(1)


FIGURES = ("wall_seconds", "core_seconds", "memory_bytes", "steps")


def expected(estimate, figure):
    """Value, interval and source of a figure; nothing if the estimate has none."""
    found = estimate.get(figure)
    return found and (float(found["value"]), float(found["low"]), float(found["high"]), found["source"])


def run(trajan, scene, changes):
    """Estimates and runs; nothing if the scene is refused."""
    arguments = [scene, *(word for change in changes for word in ("--set", change))]
    try:
        by_probe = json.loads(trajan("estimate", *arguments, "--probe", str(PROBE), "-o", "json"))
        at_once = json.loads(trajan("estimate", *arguments, "--probe", "0", "-o", "json"))
        job = trajan("submit", *arguments).strip()
    except subprocess.CalledProcessError as refused:
        print(f"{scene} {' '.join(changes)}: refused: {refused.stderr.strip()}")
        return None
    while (shown := json.loads(trajan("show", job, "-o", "json")))["state"] in ("QUEUED", "RUNNING"):
        time.sleep(0.05)
    if shown["state"] != "SUCCEEDED":
        print(f"{scene} {' '.join(changes)}: {shown['state']}")
        return None
    actual = {figure: float(shown["cost"].get(figure, 0)) for figure in FIGURES[:3]}
    actual["steps"] = float(shown["progress"]["step"])
    name = " ".join([scene, *(change.split(".", 1)[1] for change in changes)])
    row = [f"{name:52.52} {actual['wall_seconds']:7.2f}"]
    for figure in FIGURES:
        for estimate in (by_probe, at_once):
            figures = expected(estimate, figure)
            row.append(f"{figures[0] / actual[figure]:5.2f}{figures[3][0]}" if figures else "     -")
    print(" ".join(row), flush=True)
    return by_probe, at_once, actual


def summary(runs):
    """How near the figures were, how often their intervals held."""
    for which, name in ((0, "with a probe"), (1, "without")):
        for figure in FIGURES:
            by_source = {}
            for run_of in runs:
                figures = expected(run_of[which], figure)
                if figures and run_of[2][figure] > 0:
                    for source in ("all", figures[3]):
                        by_source.setdefault(source, []).append((*figures[:3], run_of[2][figure]))
            for source, found in by_source.items():
                ratios = [value / actual for value, _, _, actual in found]
                tenth, quarter = (sum(abs(ratio - 1) <= limit for ratio in ratios) for limit in (0.1, 0.25))
                held = sum(low <= actual <= high for _, low, high, actual in found)
                shares = [f"{what} {number} ({100 * number / len(found):.0f} %)" for what, number in
                          (("within 10 %", tenth), ("within 25 %", quarter), ("in the interval", held))]
                print(f"{name:12} {figure:12} {source:7} {len(found):2} runs: {', '.join(shares)}, "
                      f"median {statistics.median(ratios):.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--state", type=pathlib.Path)
    parser.add_argument("--part", default="1/1", help="for example 2/3; 0/N only measures the machine")
    arguments = parser.parse_args()
    part, parts = (int(number) for number in arguments.part.split("/"))
    with contextlib.ExitStack() as stack:
        state = arguments.state or pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory()))
        state.mkdir(parents=True, exist_ok=True)
        trajan = stack.enter_context(server(arguments.programs.resolve(), state))
        wait_for_calibration(trajan)
        chosen = JOBS[(part - 1) * len(JOBS) // parts:part * len(JOBS) // parts] if part else []
        print("Expected over actual: with a probe, without (P: PROBE, M: MODEL, H: HISTORY)")
        print(" " * 52 + "  TOOK S " + " ".join(f"{name:>13}" for name in ("WALL", "CORE", "MEMORY", "STEPS")))
        runs = [found for scene, changes in chosen if (found := run(trajan, scene, changes))]
        print()
        summary(runs)


if __name__ == "__main__":
    main()
