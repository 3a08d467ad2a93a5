"""Tables 2 and 3: a bar under ten axial loads, without and with lateral contraction."""

import numpy as np

from validation import beams

TITLE = "Static bar"
SOURCE = "section 4.1.2, tables 2 and 3"
RESOLUTION = "8 cells of 1, 192 points"

LENGTH, HEIGHT, MODULUS = 8.0, 1.0, 3e5
LOADS = np.arange(10, 101, 10)
# Printed: displacement and transverse strain by "elasticity", the same by the dissertation's MPM.
PRINTED = {
    0.0: (
        (2.667e-4, 5.333e-4, 8e-4, 1.0667e-3, 1.3333e-3, 1.6e-3, 1.8667e-3, 2.1333e-3, 2.4e-3, 2.6667e-3),
        (0.0,) * 10,
        (2.728e-4, 5.455e-4, 8.182e-4, 1.0908e-3, 1.3632e-3, 1.6356e-3, 1.908e-3, 2.1802e-3, 2.4523e-3, 2.77e-3),
        (0.0,) * 10,
    ),
    0.3: (
        (2.427e-4, 4.853e-4, 7.28e-4, 9.707e-4, 1.2133e-3, 1.456e-3, 1.6987e-3, 1.9413e-3, 2.184e-3, 2.4267e-3),
        (-9e-6, -1.8e-5, -2.7e-5, -3.6e-5, -4.6e-5, -5.5e-5, -6.4e-5, -7.3e-5, -8.2e-5, -9.1e-5),
        (2.421e-4, 4.846e-4, 7.275e-4, 9.708e-4, 1.2144e-3, 1.4585e-3, 1.7029e-3, 1.9478e-3, 2.193e-3, 2.4387e-3),
        (-8e-6, -1.6e-5, -2.5e-5, -3.4e-5, -4.3e-5, -5.2e-5, -6.1e-5, -7.1e-5, -8e-5, -9e-5),
    ),
}
GOAL = 1e-3
LINEAR = "linear functions, cells of 1 as in the dissertation, 25 points each (there 24)"


def exact(state, ratio):
    """Strains along and across the bar per load, for small strains."""
    if state == "PLANE_STRESS":
        return 1 / MODULUS, -ratio / MODULUS
    return (1 - ratio**2) / MODULUS, -ratio * (1 + ratio) / MODULUS


def found(result):
    """Displacement of the end and transverse strain at the ten loads."""
    _, position = result.history("end", "position")
    _, displacement = result.history("end", "displacement")
    _, strain = result.history("end", "strain")
    # The last particle lies before the end.
    to_the_end = LENGTH - (position[0, 0] - displacement[0, 0])
    return displacement[1:, 0] + strain[1:, 0] * to_the_end, strain[1:, 1]


def run(section):
    section.remark("""The bar may contract freely at its wall, so that the exact strain is uniform. Table 3 prints
        PL/AE times 1 - nu^2, the factor of plane strain, for displacements, although the text says plane stress; its
        transverse strains are nu (1 - nu^2) P/AE, which is neither state. Both states are computed; the dissertation's
        errors are taken against each.""")
    for ratio in (0.0, 0.3):
        for state in ("PLANE_STRESS", "PLANE_STRAIN") if ratio else ("PLANE_STRESS",):
            rows(section, ratio, state, pull(section, f"nu_{ratio}_{state.lower()}", ratio, state))
    if not section.quick:
        result = pull(section, "quadratic", 0.3, "PLANE_STRESS", **beams.BEST)
        rows(section, 0.3, "PLANE_STRESS", result, f"{beams.BEST_NAME}, cells of 1, 16 points each", loads=LOADS[-1:])


def pull(section, name, ratio, state, shapes="linear", particles=5, layout=""):
    return section.run(
        name, "static_bar", dimension=state, ratio=ratio, cell=1, particles=particles,
        analysis="quasi_static { load_steps: 10 }", scheme="TLMPM", shapes=shapes, layout=layout,
    )


def rows(section, ratio, state, result, functions=LINEAR, loads=LOADS):
    """Rows of the loads; functions other than the dissertation's have no goals."""
    settings, own = f"quasi-static, {functions}", functions != LINEAR
    name = state.lower().replace("_", " ")
    along, across = exact(state, ratio)
    references, reference_strains, printed, printed_strains = PRINTED[ratio]
    for i, (load, end, strain) in enumerate(zip(LOADS, *found(result))):
        if load not in loads:
            continue
        section.row(
            f"nu {ratio}, {name}, P {load}: end displacement", along * load * LENGTH, "Hooke's law", end, settings,
            result.core_seconds, printed[i], references[i], None if own else GOAL, own=own,
        )
        if ratio:
            section.row(
                f"nu {ratio}, {name}, P {load}: transverse strain", across * load, "Hooke's law", strain, settings,
                result.core_seconds, printed_strains[i], reference_strains[i], None if own else GOAL, own=own,
            )
