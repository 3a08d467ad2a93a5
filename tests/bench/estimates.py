#!/usr/bin/env python3
"""Runs the gallery and variations of it by the real service, and prints what was estimated beside what the jobs took.

    tests/bench/estimates.py [--programs build/release/bin] [--state DIR] [--part I/N]

One job after the other, on a machine that does nothing else: about two minutes. With --state what was measured is
kept, so that parts can follow each other; the table is of all jobs in the state.
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

# Scenes as they are: no finished run is like them, so that these are estimated by MODEL.
GALLERY = """bar_musl bar_usl bar_tlmpm axis_aligned beam_modes blocks_on_incline cantilever_static column_buckling
compliant_bar compressed_cylinder cook_membrane cook_membrane_linear dam_break discs elastica_end_load free_flight
generalized_vortex hanging_bar hanging_rod hertz hollow_sphere hollow_sphere_solid impacting_bars oblique_discs
patch_test patch_test_solid rock_compression rotating_block rotating_disc sliding_block spheres ss_beam taylor_bar
thick_cylinder toggle_frame wave_transmission""".split()

# Other settings of them: where a run of the same method has finished, HISTORY; otherwise MODEL.
VARIATIONS = [
    ("bar_musl", "domain.cell_size=0.0625"),
    ("bar_musl", "domain.cell_size=0.25"),
    ("bar_musl", "numerics.shape_functions=gimp"),
    ("bar_musl", "numerics.shape_functions=quadratic_bspline"),
    ("bar_musl", "numerics.shape_functions=cubic_bspline"),
    ("bar_musl", "numerics.shape_functions=cpdi"),
    ("bar_musl", "numerics.scheme=USAVG"),
    ("bar_musl", "numerics.transfer=APIC"),
    ("bar_musl", "numerics.transfer=XPIC"),
    ("bar_tlmpm", "numerics.shape_functions=quadratic_bspline"),
    ("bar_tlmpm", "domain.cell_size=0.0625"),
    ("discs", "numerics.scheme=USL"),
    ("discs", "numerics.transfer=FMPM"),
    ("compliant_bar", "numerics.shape_functions=quadratic_bspline"),
    ("compliant_bar", "numerics.time_step_fraction=0.25"),
    ("cantilever_static", "domain.cell_size=0.0625"),
    ("taylor_bar", "analysis.end_time=4e-5"),
    ("wave_transmission", "outputs.samples=2000"),
    ("dam_break", "numerics.time_step_fraction=0.3"),
    ("hollow_sphere", "numerics.scheme=MUSL"),
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
    while "wall_seconds" not in json.loads(trajan("estimate", "bar_usl", "-o", "json")):
        time.sleep(1)


def run(trajan, scene, change):
    arguments = [scene, *(["--set", change] if change else [])]
    try:
        job = trajan("submit", *arguments).strip()
    except subprocess.CalledProcessError as refused:
        print(f"{scene} {change}: refused: {refused.stderr.strip().splitlines()[-1]}")
        return
    while json.loads(trajan("show", job, "-o", "json"))["state"] in ("QUEUED", "RUNNING"):
        time.sleep(0.05)


def summary(audit):
    """Errors of the wall time, the processor time and the memory."""
    for source in ("MODEL", "HISTORY", None):
        for figure, actual in (("wall_seconds", "wall_seconds"), ("core_seconds", "core_seconds"),
                               ("memory_bytes", "memory_bytes")):
            ratios = [
                float(job["estimate"][figure]["value"]) / float(job["cost"][actual]) for job in audit["predictions"]
                if figure in job["estimate"] and float(job["cost"][actual]) > 0
                and source in (None, job["estimate"][figure]["source"])
            ]
            if not ratios:
                continue
            near = [sum(abs(ratio - 1) <= limit for ratio in ratios) for limit in (0.1, 0.25)]
            print(f"{source or 'all':8} {figure:13} {len(ratios):3} jobs, within 10 %: {near[0]:3}, "
                  f"within 25 %: {near[1]:3}, median of expected over actual {statistics.median(ratios):.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--state", type=pathlib.Path)
    parser.add_argument("--part", default="1/1", help="for example 2/3; 0/N only measures the machine")
    arguments = parser.parse_args()
    part, parts = (int(number) for number in arguments.part.split("/"))
    jobs = [(scene, "") for scene in GALLERY] + VARIATIONS
    with contextlib.ExitStack() as stack:
        state = arguments.state or pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory()))
        state.mkdir(parents=True, exist_ok=True)
        trajan = stack.enter_context(server(arguments.programs.resolve(), state))
        wait_for_calibration(trajan)
        for scene, change in jobs[(part - 1) * len(jobs) // parts:part * len(jobs) // parts] if part else []:
            run(trajan, scene, change)
        print(trajan("estimate", "--audit"))
        summary(json.loads(trajan("estimate", "--audit", "-o", "json")))


if __name__ == "__main__":
    main()
