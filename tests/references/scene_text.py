"""What the references' tests read from scenes: constants, and expressions evaluated by NumPy."""

import pathlib
import re

import numpy as np

SCENES = pathlib.Path(__file__).parent.parent.parent / "client" / "scenes"
FUNCTIONS = {name: getattr(np, name) for name in ("sin", "cos", "sqrt", "exp")} | {"ln": np.log, "pi": np.pi}


def text(scene):
    return (SCENES / f"{scene}.textproto").read_text(encoding="utf-8")


def evaluate(expression, **variables):
    """muParser's `^` is Python's `**`, and `lambda` no keyword of it; the gallery uses nothing else that differs, but
    for `? :`."""
    names = {name.replace("lambda", "lambda_"): value for name, value in variables.items()}
    python = re.sub(r"\blambda\b", "lambda_", expression.replace("^", "**"))
    return eval(python, {"__builtins__": {}}, FUNCTIONS | names)


def constants(scene):
    """All constants of a scene by name; each may use those before it."""
    values = {}
    for name, value in re.findall(r'constants \{ name: "(\w+)" value: "([^"]*)" \}', text(scene)):
        values[name] = float(evaluate(value, **values))
    return values


def constant(scene, name):
    """A constant of a scene."""
    return constants(scene)[name]


def vector_expression(scene, field):
    """The two components of the first `field { x: … y: … }`, each of one or more strings."""
    block = re.search(field + r"\s*\{(.*?)\n?\s*\}", text(scene), re.DOTALL).group(1)
    parts = re.split(r"\b[xy]:", re.sub(r'"\s*\n\s*"', "", block))[1:]
    return [re.search(r'"([^"]*)"', part).group(1) for part in parts]
