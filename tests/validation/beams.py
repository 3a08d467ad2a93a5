"""Parts of the scene `beam`: its ends, and what can be done with it."""

LENGTH, HEIGHT, MODULUS, RATIO, DENSITY = 8.0, 1.0, 3000.0, 0.3, 1.0


def nodes(name, x, cell, condition):
    """A condition on all nodes of the grid that the edge at x may touch."""
    low, high = -2 * cell, HEIGHT + 2 * cell
    return (
        f'boundaries {{ name: "{name}" nodes {{ box {{ lower {{ x: {x} y: {low} }} upper {{ x: {x} y: {high} }} }} }} '
        f"{condition} }}"
    )


def hinge(name, edge, kind, within=""):
    """An edge, or a part of it, held in the transverse direction."""
    surface = f'surface {{ body: "beam" edge: {edge} {within} }}'
    return f'boundaries {{ name: "{name}" hinge {{ {surface} kind: {kind} axes: Y }} }}'


def end(kind, edge, length, cell, patch=HEIGHT / 4):
    """The text of an end of one of beam_frequencies.py's kinds."""
    name, x = f"{edge.lower()}_end", 0 if edge == "LEFT" else length
    if kind == "clamped":
        return nodes(name, x, cell, "fixed {}")
    if kind == "hinged":
        return nodes(name, x, cell, "fixed { axes: Y }")
    if kind == "mean":
        return hinge(name, edge, "MEAN")
    if kind == "patch":
        low, high = (HEIGHT - patch) / 2, (HEIGHT + patch) / 2
        return hinge(name, edge, "WHOLE", f"within {{ box {{ lower {{ x: {x} y: {low} }} upper {{ x: {x} y: {high} }} }} }}")
    return ""


def values(ends, cell, length=LENGTH, particles=2, shapes="linear", scheme="TLMPM", **text):
    """What the scene's template wants; `text` gives motion, loads, analysis, outputs and measures."""
    left, right = (end(kind, edge, length, cell) for kind, edge in zip(ends, ("LEFT", "RIGHT")))
    # Faces of the domain are supports, where wide functions end; elsewhere there is room for them.
    room = 4 * cell
    return {
        "cell": cell, "length": length, "particles": particles, "shapes": shapes, "scheme": scheme,
        "left": -room if ends[0] == "free" else 0, "right": length + room if ends[1] == "free" else length,
        "below": -room, "above": HEIGHT + room, "supports": f"{left}\n{right}",
        "motion": "", "loads": "", "measures": "",
    } | text
