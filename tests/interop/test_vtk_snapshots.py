"""VTK reads every snapshot of a result file, and the XDMF file beside it, with the right values."""

import pytest

from sample_result import SOLID, TIMES, sample  # noqa: F401  (a fixture)

np = pytest.importorskip("numpy")
vtk_to_numpy = pytest.importorskip("vtkmodules.util.numpy_support").vtk_to_numpy
vtkHDFReader = pytest.importorskip("vtkmodules.vtkIOHDF").vtkHDFReader


def expected(sample, step, what, kind):  # noqa: F811
    return np.array(sample.stored(step, what, kind)).T


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


def check_common(grid, sample, step):  # noqa: F811
    assert grid.GetNumberOfPoints() == sample.particles
    assert grid.GetNumberOfCells() == sample.particles
    points = vtk_to_numpy(grid.GetPoints().GetData())
    assert np.array_equal(points, expected(sample, step, "position", "vector").astype(points.dtype))
    for name in ("velocity", "displacement"):
        assert np.array_equal(array(grid, name), expected(sample, step, name, "vector")), name
    assert np.array_equal(array(grid, "pressure"), sample.component(step, "pressure", 0))
    assert np.array_equal(array(grid, "particle_number"), np.arange(sample.particles))
    assert np.array_equal(array(grid, "body"), np.arange(sample.particles) // sample.body_particles)


def test_vtk_reads_every_snapshot(sample):  # noqa: F811
    reader = vtkHDFReader()
    reader.SetFileName(str(sample.directory / "result.vtkhdf"))
    assert times_of(reader) == TIMES
    # Also backwards: a reader may ask for any time.
    for step in [0, 1, 2, 3, 4, 2, 0]:
        grid = grid_at(reader, TIMES[step])
        check_common(grid, sample, step)
        assert grid.GetVerts().GetNumberOfCells() == sample.particles
        for name in ("stress", "deformation_gradient"):
            assert np.array_equal(array(grid, name), expected(sample, step, name, name)), name


def test_vtk_reads_every_snapshot_through_the_xdmf_file(sample):  # noqa: F811
    reader = pytest.importorskip("vtkmodules.vtkIOXdmf2").vtkXdmfReader()
    reader.SetFileName(str(sample.directory / "result.xmf2"))
    assert times_of(reader) == TIMES
    for step, time in enumerate(TIMES):
        grid = grid_at(reader, time)
        check_common(grid, sample, step)
        for name in ("stress", "deformation_gradient"):
            for component, values in zip(SOLID[name], sample.stored(step, name, name)):
                assert np.array_equal(array(grid, f"{name}_{component}"), values), (name, component)
