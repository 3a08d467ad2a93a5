"""The result file that write_sample_result leaves, and the values that must be in it."""

import os
import pathlib
import subprocess

import pytest

TIMES = [0.0, 0.5, 1.0, 1.5, 2.0]
SAMPLES_PER_SNAPSHOT = 5
PARTICLES = 128  # two blocks of 8 x 8
BODY_PARTICLES = 64


def particle_value(step, particle, what, component):
    """As in rehearsal.cpp."""
    return float(step * SAMPLES_PER_SNAPSHOT) + 1e-3 * particle + 10.0 * component + 1000.0 * len(what)


@pytest.fixture(scope="module")
def directory(tmp_path_factory):
    """Where the sample's result.vtkhdf and result.xmf2 are."""
    path = tmp_path_factory.mktemp("sample")
    writer = pathlib.Path(os.environ["TRAJAN_BIN"]).parent / "tests" / "write_sample_result"
    subprocess.run([writer, path], check=True)
    return path
