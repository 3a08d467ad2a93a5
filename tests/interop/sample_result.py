"""The result files that write_sample_result leaves, and the values that must be in them."""

import os
import pathlib
import subprocess

import pytest

TIMES = [0.0, 0.5, 1.0, 1.5, 2.0]
SAMPLES_PER_SNAPSHOT = 5
BODIES = 2

PLANE = {
    "vector": ["x", "y"],
    "stress": ["xx", "yy", "xy", "zz"],
    "deformation_gradient": ["xx", "xy", "yx", "yy", "zz"],
}
SOLID = {
    "vector": ["x", "y", "z"],
    "stress": ["xx", "yy", "zz", "xy", "yz", "xz"],
    "deformation_gradient": ["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"],
}


class Sample:
    """Two blocks of 8 particles along each axis, and a directory with result.vtkhdf and result.xmf2."""

    def __init__(self, dimension, directory):
        self.dimension = dimension
        self.directory = directory
        self.recorded = SOLID if dimension == "solid" else PLANE
        self.body_particles = 8 ** len(self.recorded["vector"])
        self.particles = BODIES * self.body_particles
        writer = pathlib.Path(os.environ["TRAJAN_BIN"]).parent / "tests" / "write_sample_result"
        subprocess.run([writer, directory, dimension], check=True)

    def component(self, step, what, number):
        """A component of a field at all particles, as in rehearsal.cpp."""
        return [float(step * SAMPLES_PER_SNAPSHOT) + 1e-3 * particle + 10.0 * number + 1000.0 * len(what)
                for particle in range(self.particles)]

    def stored(self, step, what, kind):
        """The columns that a field has in the file: all components of a solid, 0 where the scene has none."""
        recorded = self.recorded[kind]
        return [self.component(step, what, recorded.index(name)) if name in recorded else [0.0] * self.particles
                for name in SOLID[kind]]


@pytest.fixture(scope="module", params=["plane_strain", "axisymmetric", "solid"])
def sample(request, tmp_path_factory):
    return Sample(request.param, tmp_path_factory.mktemp(request.param))
