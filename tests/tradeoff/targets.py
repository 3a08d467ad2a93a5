"""Targets by the real service: is the true error within the tolerance, and what does that cost?

    python3 -m tradeoff.targets [--quick] [--programs BUILD/bin] [SCENE…]      (from tests/)

For every case `trajan submit SCENE --tolerance MEASURE=0.5%` on a fresh server, which does not look at exact values and
has no findings; then, by brute force, all combinations of the settings below on the grids of `trajan tradeoff`, of which
the cheapest within the tolerance is what the target is measured against; then on two more grids, which tradeoffs do
not have. Costs are of the run that answers, and of all runs of the target. Each case is done on three servers; every cost
is the middle one. --quick does each once, and leaves the brute force and the dear cases out. The whole takes some minutes.
Ends with 1 if a true error is above the tolerance.
"""

import argparse
import json
import math
import pathlib
import sys
import tempfile
from statistics import median

from validation.service import Service

TOLERANCE = 0.005
FAIR = 3  # times the cost of the cheapest setting within the tolerance
FUNCTIONS = "numerics.shape_functions=linear,quadratic_bspline,cubic_bspline"
MODES = ["analysis.modal.mass=CONSISTENT,LUMPED", FUNCTIONS]
STEPS = ["numerics.shape_functions=linear,quadratic_bspline", "numerics.time_step_fraction=0.5,0.9"]
TOTAL = ["numerics.scheme=TLMPM"]
AT_ONCE = ["analysis.damping=0", "analysis.quasi_static={}", "outputs.samples=1", "outputs.snapshots=1"]

# Scene, measure, whether it is cheap, and of the brute force what is changed in all runs and what is varied.
CASES = [
    ("beam_modes", "first_frequency", True, TOTAL, MODES),
    ("beam_modes", "third_frequency", True, TOTAL, MODES),
    ("column_buckling", "critical_factor", True, TOTAL, [FUNCTIONS]),
    ("hanging_rod", "end_displacement", True, TOTAL + AT_ONCE, [FUNCTIONS]),
    ("hanging_bar", "end_displacement", True, TOTAL + AT_ONCE, [FUNCTIONS]),
    ("rotating_disc", "hoop_stress_at_the_axis", True, TOTAL + AT_ONCE, [FUNCTIONS]),
    ("rock_compression", "peak", True, [], ["numerics.scheme=TLMPM,MUSL", *STEPS]),
    ("cantilever_static", "tip_deflection", False, TOTAL, [FUNCTIONS]),
    ("elastica_end_load", "tip_deflection", False, TOTAL, [FUNCTIONS]),
    ("elastica_uniform_load", "tip_deflection", False, TOTAL, [FUNCTIONS]),
    ("toggle_frame", "snap_load", False, TOTAL, [FUNCTIONS]),
    ("compliant_bar", "first_extension", False, TOTAL, STEPS),
    ("nonlinear_beam", "frequency", False, TOTAL, STEPS),
    ("ss_beam", "first_frequency", False, TOTAL, STEPS),
]
GRIDS = (2, 1)  # times the cells of the scene; a half is never the cheapest, where one of these is within the tolerance
OTHER_GRIDS = (4, 4 / 3)


def cell_size_of(scene_text):
    return float(scene_text.split("cell_size:")[1].split()[0])


def measure_of(run, name):
    return next((measure for measure in run.get("measures", []) if measure["name"] == name), None)


def submit_target(service, scene, measure):
    """The ended target as `trajan show -o json` tells it."""
    job = service.call("submit", scene, "--tolerance", f"{measure}={100 * TOLERANCE}%").strip()
    service.call("watch", job, accept=(0, 1))
    return json.loads(service.call("show", job, "-o", "json"))


def within_tolerance(service, scene, measure, changes, dials, grids):
    """Core-seconds of the runs within the tolerance by their settings; cells that do not fit the scene are left out."""
    size = cell_size_of(service.call("scenes", scene))
    arguments = [word for change in changes for word in ("--set", change)]
    arguments += [word for dial in dials for word in ("--over", dial)]
    found = {}
    for grid in grids:
        try:
            study = service.call("sweep", scene, *arguments, "--over", f"domain.cell_size={size * grid!r}", "--detach")
        except RuntimeError:
            continue
        service.call("watch", study.strip(), accept=(0, 1))
        for run in json.loads(service.call("show", study.strip(), "-o", "json"))["runs"]:
            value = measure_of(run, measure)
            if value and abs(value["error"]) <= TOLERANCE:
                found["; ".join(run["settings"])] = run["cost"]["core_seconds"]
    return found


def trial_of(programs, case, brute_force):
    """On a server of its own: the ended target, and what settings within the tolerance cost on two grids and others."""
    scene, measure, _, changes, dials = case
    with tempfile.TemporaryDirectory() as folder, Service(programs, pathlib.Path(folder)) as service:
        study = submit_target(service, scene, measure)
        grids = (GRIDS, OTHER_GRIDS) if brute_force else ()
        return study, *(within_tolerance(service, scene, measure, changes, dials, some) for some in grids)


def cheapest(trials):
    """The middle of each setting's costs, of the setting for which that is least."""
    found = [(median(cost[setting] for cost in trials), setting) for setting in trials[0]]
    return min(found, default=(math.nan, "none"))


def row_of(trials, measure):
    """A case's row of the table, its true error, its band, and its cost over that of the cheapest setting on two grids
    and on all."""
    study = trials[0][0]
    answers = [trial[0].get("answer", {}) for trial in trials]
    if not all(answer.get("reached") for answer in answers):
        reason = answers[0].get("end", study["job"].get("failure"))
        return f"NOT REACHED: {reason} |", math.inf, 0, math.inf, math.inf
    error = abs(measure_of(study["runs"][answers[0].get("run", 0)], measure)["error"])
    band = answers[0]["band"] / abs(answers[0]["value"])
    runs = [trial[0]["runs"][answer.get("run", 0)] for trial, answer in zip(trials, answers)]
    cost = median(run["cost"]["core_seconds"] for run in runs)
    total = median(answer["core_seconds"] for answer in answers)
    row = f"{'; '.join(runs[0]['settings'])} | {100 * error:.3f} % | {100 * band:.3f} % | {len(study['runs'])} | "
    row += f"{cost:.3f} | {total:.3f} |"
    if len(trials[0]) == 1:
        return row, error, band, math.nan, math.nan
    on_two = cheapest([trial[1] for trial in trials])
    on_all = min(on_two, cheapest([trial[2] for trial in trials]))
    row += f" {on_two[0]:.3f} | {on_two[1]} | {cost / on_two[0]:.1f} | {total / on_two[0]:.1f} | {cost / on_all[0]:.1f} |"
    return row, error, band, cost / on_two[0], cost / on_all[0]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--programs", type=pathlib.Path, default=pathlib.Path("../build/release/bin"))
    asked = parser.parse_args()
    cases = [case for case in CASES if (case[2] or not asked.quick) and (not asked.scenes or case[0] in asked.scenes)]
    print("| scene | measure | answered by | true error | band | runs | core-seconds of the answer | of all runs |"
          + ("" if asked.quick else " cheapest | by | answer / cheapest | all / cheapest | answer / cheapest on 4 grids |"))
    print("|---|---|---|--:|--:|--:|--:|--:|" + ("" if asked.quick else "--:|---|--:|--:|--:|"))
    found = []
    for case in cases:
        scene, measure = case[:2]
        trials = [trial_of(asked.programs.resolve(), case, not asked.quick) for _ in range(1 if asked.quick else 3)]
        row, *numbers = row_of(trials, measure)
        print(f"| {scene} | {measure} | {row}", flush=True)
        found.append(numbers)
    within = sum(error <= TOLERANCE for error, *_ in found)
    print(f"\n{within} of {len(cases)} true errors are within {100 * TOLERANCE} %, "
          f"{sum(error <= band for error, band, *_ in found)} within their bands")
    if not asked.quick:
        fair = [sum(row[column] <= FAIR for row in found) for column in (2, 3)]
        print(f"{fair[0]} of {len(cases)} answers cost at most {FAIR} times what the cheapest setting on two grids does, "
              f"{fair[1]} what that on all four does")
    return within < len(cases)


if __name__ == "__main__":
    sys.exit(main())
