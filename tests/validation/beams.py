"""Parts of the scene `beam`: its ends, and what can be done with it."""

import numpy as np

LENGTH, HEIGHT, MODULUS, RATIO, DENSITY = 8.0, 1.0, 3000.0, 0.3, 1.0

STATIONS = 33  # cross-sections whose mean displacement is recorded, evenly from end to end

# What integrates exactly and converges fast, where displacements or modes are solved for.
BEST = {"particles": 4, "shapes": "quadratic_bspline", "layout": "\n  particle_layout: GAUSS"}
BEST_NAME = "quadratic B-splines at Gauss points"


def stations(cell, length=LENGTH):
    """Probes of the mean over cross-sections."""
    text = []
    for i, x in enumerate(np.linspace(0, length, STATIONS)):
        box = f"box {{ lower {{ x: {x - cell / 2} y: 0 }} upper {{ x: {x + cell / 2} y: {HEIGHT} }} }}"
        text.append(f'probes {{ name: "station_{i}" mean {{ {box} }} fields: [POSITION, DISPLACEMENT] }}')
    return "\n".join(text)


def deflections(result):
    """Of the stations: times, places x at rest, and displacements across the beam, shape (times, stations)."""
    x, across = [], []
    for i in range(STATIONS):
        time, moved = result.history(f"station_{i}", "displacement")
        x.append(result.history(f"station_{i}", "position")[1][0, 0] - moved[0, 0])
        across.append(moved[:, 1])
    return time, np.array(x), np.array(across).T


def free_end(x, across, length=LENGTH):
    """The deflection at the free end, which bends nowhere: straight on from the last two stations with particles of their
    own. Of stations `across`, the last axis."""
    before = np.flatnonzero(x < x[-1])[-1]
    slope = (across[..., -1] - across[..., before]) / (x[-1] - x[before])
    return across[..., -1] + slope * (length - x[-1])


def modes(result):
    """Bending modes found by the modal analysis: frequencies, places x at rest, displacements across, (modes, stations)."""
    frequencies = result.column("modes", "frequency")[1:]
    _, x, across = deflections(result)
    along = np.array([result.history(f"station_{i}", "displacement")[1][1:, 0] for i in range(STATIONS)]).T
    bends = np.abs(across[1:]).max(axis=1) > np.abs(along).max(axis=1)
    return frequencies[bends], x, across[1:][bends]


def modal(count):
    """Analysis and samples for the lowest modes, rigid and axial ones among them."""
    return f"end_time: {count} modal {{}}", f"samples: {count}"


def nodes(name, x, cell, condition):
    """A condition on all nodes of the grid that the edge at x may touch."""
    low, high = -2 * cell, HEIGHT + 2 * cell
    return (
        f'boundaries {{ name: "{name}" nodes {{ box {{ lower {{ x: {x} y: {low} }} upper {{ x: {x} y: {high} }} }} }} '
        f"{condition} }}"
    )


def hinge(name, edge, kind, within="", axes="Y"):
    """An edge, or a part of it, held."""
    surface = f'surface {{ body: "beam" edge: {edge} {within} }}'
    return f'boundaries {{ name: "{name}" hinge {{ {surface} kind: {kind} axes: {axes} }} }}'


def end(kind, edge, length, cell, patch=HEIGHT / 4):
    """The text of an end of one of the kinds of beam_elements.py."""
    name, x = f"{edge.lower()}_end", 0 if edge == "LEFT" else length
    if kind == "clamped":
        return nodes(name, x, cell, "fixed {}")
    if kind == "axial":
        return nodes(name, x, cell, "fixed { axes: X }") + hinge(f"{name}_mean", edge, "MEAN")
    if kind == "hinged":
        return nodes(name, x, cell, "fixed { axes: Y }")
    if kind == "mean":
        return hinge(name, edge, "MEAN")
    if kind == "patch":
        low, high = (HEIGHT - patch) / 2, (HEIGHT + patch) / 2
        return hinge(name, edge, "WHOLE", f"within {{ box {{ lower {{ x: {x} y: {low} }} upper {{ x: {x} y: {high} }} }} }}")
    return ""


def axially_held():
    """What keeps a beam on two hinges in its place along itself: the mean over an edge, which nothing pushes."""
    return hinge("axial_support", "LEFT", "MEAN", axes="X")


def end_shear(load, time):
    """A load across the right end, distributed as the parabola of beam theory."""
    return (
        f'loads {{ name: "end_shear" edge_traction {{ body: "beam" edge: RIGHT traction {{ y: {load} }} '
        f'profile: "6 * y * (1 - y)" }} time {{ {time} }} }}'
    )


def top_load(load, time):
    """A load per length on the upper edge."""
    return (
        f'loads {{ name: "top_load" edge_traction {{ body: "beam" edge: TOP traction {{ y: {load} }} }} '
        f"time {{ {time} }} }}"
    )


def body_load(load, time):
    """A load per length, distributed over the cross-section."""
    return f'loads {{ name: "body_load" body_force {{ acceleration {{ y: {load / DENSITY} }} }} time {{ {time} }} }}'


def values(ends, cell, length=LENGTH, particles=2, shapes="linear", scheme="TLMPM", axial_support="", modulus=MODULUS,
           **text):
    """What the scene's template wants; `text` gives motion, loads, analysis, outputs and measures."""
    left, right = (end(kind, edge, length, cell) for kind, edge in zip(ends, ("LEFT", "RIGHT")))
    # Faces of the domain are supports, where wide functions end; elsewhere there is room for them.
    room = 4 * cell
    return {
        "cell": cell, "length": length, "modulus": modulus, "particles": particles, "shapes": shapes, "scheme": scheme,
        "left": -room if ends[0] == "free" else 0, "right": length + room if ends[1] == "free" else length,
        "below": -room, "above": HEIGHT + room, "supports": f"{left}\n{right}\n{axial_support}",
        "motion": "", "loads": "", "measures": "", "layout": "", "transfer": "",
    } | text
