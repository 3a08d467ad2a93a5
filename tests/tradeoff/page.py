"""Writes the page of ./dev tradeoff: python3 -m tradeoff.page FOLDER, with the studies' JSON and pictures in FOLDER."""

import json
import pathlib
import shutil
import sys

HERE = pathlib.Path(__file__).parent
PROJECT = HERE.parent.parent

# Scene, what is asked, and the sentence to take from it.
SCENES = {
    "cantilever_static": (
        "Static deflection of a beam",
        "For static answers take implicit load steps: relaxation by explicit steps costs two to seven times as much for "
        "the same error, and where a beam is thick linear functions are cheaper than quadratic ones.",
    ),
    "bar_musl": (
        "Waves in a bar",
        "For waves take explicit steps and linear functions, by USL or in TLMPM with nine tenths of the largest time step; "
        "implicit steps as long as the samples of the histories cost fifteen to forty times as much and stay at 1 %, "
        "whatever the cells: there the time steps err.",
    ),
    "beam_modes": (
        "Frequency of a beam",
        "For frequencies take modes with a lumped mass and linear functions: with the same cells and at about the "
        "same cost consistent masses err half as much again, and quadratic B-splines, which cost more, nearly three times "
        "as much.",
    ),
    "nonlinear_beam": (
        "Frequency of a beam at a large amplitude",
        "Take linear functions in TLMPM and nine tenths of the largest time step: of bending, their stiffness and their "
        "lumped mass err in opposite directions, while with B-splines the mass alone errs; they need eight cells over the "
        "height for half a per cent.",
    ),
    "elastica_uniform_load": (
        "Large deflection of a slender beam",
        "Slender beams bend by quadratic B-splines, also with cells that are larger than the beam is high; linear functions "
        "lock, and err several times as much at the same cost. The 0.2 % that stay are in part what the elastica leaves "
        "out: a beam's shear and extension.",
    ),
    "taylor_bar": (
        "Taylor's bar",
        "For impacts that flow take explicit steps and the updated configuration, MUSL with linear or quadratic functions: "
        "linear functions in TLMPM lock, and implicit steps cost twenty times as much for the same error.",
    ),
}

HEAD = """# What accuracy costs

Written by `./dev tradeoff`; do not edit. Every line is a method on three grids, every point a run: the error of one
measure against its exact value over the core-seconds that the run took. The broad line is the best of all.

The processor: {machine}. Of runs of less than a tenth of a core-second the most is start-up; every run was
timed once.
"""


def cheapest_table(study):
    trade = study["trade"]
    lines = ["| within | core-seconds | settings |", "|--:|--:|---|"]
    for cheapest in trade["cheapest"]:
        share = f"{100 * cheapest['tolerance']:g} %"
        if "run" in cheapest:
            run = study["runs"][cheapest["run"]]
            settings = ", ".join(f"{dial} {value}" for dial, value in zip(study["dials"], run["settings"]))
            lines.append(f"| {share} | {run['cost']['core_seconds']:.2g} | {settings} |")
        else:
            lines.append(f"| {share} | – | |")
    return "\n".join(lines)


def section(folder, scene):
    title, sentence = SCENES[scene]
    study = json.loads((folder / f"{scene}.json").read_text(encoding="utf-8"))
    shutil.copy(folder / f"{scene}.svg", HERE / f"{scene}.svg")
    runs = [run for run in study["runs"] if run["state"] == "SUCCEEDED"]
    seconds = sum(run["cost"]["core_seconds"] for run in runs)
    return (
        f"## {title}\n\n{sentence}\n\n![{title}: error over core-seconds]({scene}.svg)\n\n"
        f"`{scene}`, {study['trade']['measure']}; {len(runs)} of {len(study['runs'])} runs succeeded, {seconds:.0f} "
        f"core-seconds in all.\n\n{cheapest_table(study)}\n"
    )


def main():
    folder = pathlib.Path(sys.argv[1])
    first = json.loads((folder / "beam_modes.json").read_text(encoding="utf-8"))
    parts = [HEAD.format(machine=first["runs"][0]["cost"]["machine"]), *(section(folder, scene) for scene in SCENES)]
    (HERE / "README.md").write_text("\n".join(parts), encoding="utf-8")


if __name__ == "__main__":
    main()
