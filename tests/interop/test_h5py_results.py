"""A result file reads with h5py and plain names, without any code of ours."""

import math

import pytest

from sample_result import TIMES, sample  # noqa: F401  (a fixture)

h5py = pytest.importorskip("h5py")
np = pytest.importorskip("numpy")


@pytest.fixture
def file(sample):  # noqa: F811
    with h5py.File(sample.directory / "result.vtkhdf", "r") as opened:
        yield opened


def test_the_root_says_what_was_computed(file, sample):  # noqa: F811
    assert file.attrs["status"] == "succeeded"
    assert file.attrs["name"] == "rehearsal"
    assert file.attrs["units"] == "m, kg, s"
    assert file.attrs["dimension"] == sample.dimension.replace("_", " ")
    assert "größer" in file.attrs["scene"]
    assert len(file.attrs["scene_sha256"]) == 64
    assert file.attrs["solver_version"] == "1.2.3"


def test_histories_have_plain_names(file, sample):  # noqa: F811
    assert np.allclose(file["time"][:], np.linspace(0, 2, 21), rtol=1e-15)
    stress = file["probes/tip/stress"]
    assert stress.shape == (21, len(sample.recorded["stress"]))
    assert list(stress.attrs["components"]) == sample.recorded["stress"]
    assert file["probes/middle/pressure"].shape == (21,)
    assert file["probes/tip/time"] == file["time"]
    columns = [row["column"].decode() for row in file["columns"]]
    column = columns.index("tip.displacement.y")
    assert file["probes/tip/displacement"][7, 1] == math.sin(7 * 0.37 + column) + 7
    assert file["energies/kinetic"].shape == file["energies/time"].shape == (21,)
    assert sorted(file["momentum"]) == sorted([*sample.recorded["vector"], "time"])
    assert file["momentum/x"].shape == (21,)
    for row in file["columns"]:
        assert row["dataset"].decode() in file


def test_measures_are_a_table(file):
    deflection, peak = file["measures"][:]
    assert deflection["name"].decode() == "deflection"
    assert deflection["quantity"].decode() == "tip.displacement.y"
    assert deflection["value"] == 0.2525 and deflection["exact"] == 0.25
    assert deflection["tolerance"] == 0.01
    assert deflection["source"].decode() == "a handbook, §1"
    assert math.isnan(peak["exact"]) and math.isnan(peak["error"])


def test_snapshots_are_flat_arrays(file, sample):  # noqa: F811
    assert file["VTKHDF/Points"].shape == (len(TIMES) * sample.particles, 3)
    assert file["VTKHDF/PointData/pressure"].shape == (len(TIMES) * sample.particles,)
    assert list(file["VTKHDF/PointData/body"].attrs["names"]) == ["left", "right"]
