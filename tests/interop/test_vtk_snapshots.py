"""VTK reads every snapshot of a result file, and the XDMF file beside it, with the right values."""

import pytest

import sample_result as sample
from sample_result import directory  # noqa: F401  (a fixture)

np = pytest.importorskip("numpy")
vtk_to_numpy = pytest.importorskip("vtkmodules.util.numpy_support").vtk_to_numpy
vtkHDFReader = pytest.importorskip("vtkmodules.vtkIOHDF").vtkHDFReader


def expected(step, what, components):
    return np.array([[sample.particle_value(step, p, what, c) for c in components] for p in range(sample.PARTICLES)])


def grid_at(reader, time):
    reader.UpdateTimeStep(time)
    grid = reader.GetOutputDataObject(0)
    while grid.IsA("vtkMultiBlockDataSet"):
        grid = grid.GetBlock(0)
    return grid


def times_of(reader):
    reader.UpdateInformation()
    information = reader.GetOutputInformation(0)
    key = reader.GetExecutive().TIME_STEPS()
    return [information.Get(key, i) for i in range(information.Length(key))]


def array(grid, name):
    values = grid.GetPointData().GetArray(name)
    assert values is not None, f"no array {name}"
    return vtk_to_numpy(values)


def check_common(grid, step):
    assert grid.GetNumberOfPoints() == sample.PARTICLES
    assert grid.GetNumberOfCells() == sample.PARTICLES
    points = vtk_to_numpy(grid.GetPoints().GetData())
    assert np.array_equal(points[:, :2], expected(step, "position", (0, 1)).astype(points.dtype))
    assert not points[:, 2].any()
    for name in ("velocity", "displacement"):
        values = array(grid, name)
        assert values.shape == (sample.PARTICLES, 3)
        assert np.array_equal(values[:, :2], expected(step, name, (0, 1))), name
        assert not values[:, 2].any()
    assert np.array_equal(array(grid, "particle_number"), np.arange(sample.PARTICLES))
    assert np.array_equal(array(grid, "body"), np.arange(sample.PARTICLES) // sample.BODY_PARTICLES)


def test_vtk_reads_every_snapshot(directory):  # noqa: F811
    reader = vtkHDFReader()
    reader.SetFileName(str(directory / "result.vtkhdf"))
    assert times_of(reader) == sample.TIMES
    # Also backwards: a reader may ask for any time.
    for step in [0, 1, 2, 3, 4, 2, 0]:
        grid = grid_at(reader, sample.TIMES[step])
        check_common(grid, step)
        assert grid.GetVerts().GetNumberOfCells() == sample.PARTICLES
        # Stored as xx, yy, zz, xy, yz, xz; recorded as xx, yy, xy, zz.
        stress = array(grid, "stress")
        assert np.array_equal(stress[:, :4], expected(step, "stress", (0, 1, 3, 2)))
        assert not stress[:, 4:].any()


def test_vtk_reads_every_snapshot_through_the_xdmf_file(directory):  # noqa: F811
    reader = pytest.importorskip("vtkmodules.vtkIOXdmf2").vtkXdmfReader()
    reader.SetFileName(str(directory / "result.xmf2"))
    assert times_of(reader) == sample.TIMES
    for step, time in enumerate(sample.TIMES):
        grid = grid_at(reader, time)
        check_common(grid, step)
        for name, component in (("stress_xx", 0), ("stress_yy", 1), ("stress_xy", 2), ("stress_zz", 3)):
            assert np.array_equal(array(grid, name), expected(step, "stress", (component,))[:, 0]), name
