"""The cases by number: each is a module with TITLE, SOURCE, RESOLUTION and run(section)."""

import importlib

CASES = {
    1: "static_bar",
    2: "axial_vibration",
    3: "static_cantilever",
    4: "static_simple_beam",
    5: "forced_vibration",
    6: "free_vibration",
    7: "nonlinear_free_vibration",
    8: "vertical_bar",
    9: "large_deflection",
    10: "column",
    11: "bamboo",
    12: "discretisation",
}


def load(number):
    return importlib.import_module(f"validation.cases.{CASES[number]}")
