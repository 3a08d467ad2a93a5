"""Histories, streamed and stored, and the result file."""

import hashlib
import math

import grpc
import h5py
import numpy
import pytest

import service


@pytest.fixture(scope="module")
def messages():
    from trajan.v1 import jobs_pb2
    return jobs_pb2


@pytest.fixture(scope="module")
def stream(jobs, messages):
    """A history as (columns, first row, times, values), checked to be without gaps."""
    def stream(job_id, **fields):
        columns, first, time, values = None, None, [], []
        for part in jobs.StreamHistory(messages.StreamHistoryRequest(job_id=job_id, **fields)):
            if columns is None:
                columns, first = list(part.columns), part.first_row
            assert part.first_row == first + len(time)
            assert len(part.values) == len(part.time) * len(columns)
            time += part.time
            values += part.values
        return columns, first, numpy.array(time), numpy.array(values).reshape(len(time), len(columns))
    return stream


@pytest.fixture(scope="module")
def result(jobs, messages, ended_job, tmp_path_factory):
    """The result file, read through the service."""
    path = tmp_path_factory.mktemp("result") / "result.vtkhdf"
    chunks = jobs.ReadResult(messages.ReadResultRequest(job_id=ended_job.job_id))
    path.write_bytes(b"".join(chunk.data for chunk in chunks))
    return path


def test_a_history_streams_while_the_job_runs(jobs, messages, submit, stream, long_bar):
    job_id = submit(long_bar).job_id
    time, values = [], []
    for part in jobs.StreamHistory(messages.StreamHistoryRequest(job_id=job_id, follow=True)):
        time += part.time
        values += part.values
        if len(time) >= 3:
            # Minutes before its end, so that these rows cannot have come from an ended job.
            jobs.CancelJob(messages.CancelJobRequest(job_id=job_id))
    stored = stream(job_id)
    assert len(stored[2]) < long_bar.outputs.samples
    numpy.testing.assert_array_equal(time, stored[2])
    numpy.testing.assert_array_equal(values, stored[3].ravel())


def test_a_followed_history_equals_the_stored_one(submit, stream, bar):
    job = submit(bar)
    live = stream(job.job_id, follow=True)
    stored = stream(job.job_id)
    assert live[0] == stored[0] and live[1] == stored[1] == 0
    numpy.testing.assert_array_equal(live[2], stored[2])
    numpy.testing.assert_array_equal(live[3], stored[3])
    assert len(stored[2]) == bar.outputs.samples + 1


def test_a_history_has_the_columns_and_rows_asked_for(stream, ended_job):
    columns, _, _, values = stream(ended_job.job_id)
    some, first, time, part = stream(ended_job.job_id, columns=["tip.velocity", "energies.kinetic"], first_row=390)
    assert some == ["tip.velocity.x", "tip.velocity.y", "energies.kinetic"]
    assert first == 390 and len(time) == 11
    numpy.testing.assert_array_equal(part, values[390:, [columns.index(name) for name in some]])


def test_a_column_that_does_not_exist_is_not_found_and_the_others_are_named(jobs, messages, ended_job):
    with pytest.raises(grpc.RpcError) as caught:
        list(jobs.StreamHistory(messages.StreamHistoryRequest(job_id=ended_job.job_id, columns=["tip.colour"])))
    assert caught.value.code() == grpc.StatusCode.NOT_FOUND
    assert "tip.displacement.x" in caught.value.details()


def test_samples_lie_where_the_scene_wants_them(stream, ended_job, bar):
    time = stream(ended_job.job_id)[2]
    expected = numpy.arange(401) * bar.analysis.end_time / 400
    # Hit exactly, up to the rounding of i * end / samples.
    numpy.testing.assert_allclose(time, expected, rtol=4 * numpy.finfo(float).eps)


def test_the_result_arrives_whole_in_checked_chunks(jobs, messages, ended_job):
    digest, size = hashlib.sha256(), 0
    for number, chunk in enumerate(jobs.ReadResult(messages.ReadResultRequest(job_id=ended_job.job_id))):
        assert chunk.offset == size
        assert len(chunk.data) <= 1 << 20
        assert chunk.crc32c == service.crc32c(chunk.data)
        if number == 0:
            assert chunk.total_size == ended_job.result.size
            assert chunk.sha256 == ended_job.result.sha256
        digest.update(chunk.data)
        size += len(chunk.data)
    assert size == ended_job.result.size
    assert digest.hexdigest() == ended_job.result.sha256
    assert ended_job.result.complete


def test_an_interrupted_download_goes_on(jobs, messages, ended_job, result):
    half = ended_job.result.size // 2
    rest = jobs.ReadResult(messages.ReadResultRequest(job_id=ended_job.job_id, offset=half))
    assert b"".join(chunk.data for chunk in rest) == result.read_bytes()[half:]


def test_an_offset_beyond_the_end_is_an_error(jobs, messages, ended_job):
    with pytest.raises(grpc.RpcError) as caught:
        list(jobs.ReadResult(messages.ReadResultRequest(job_id=ended_job.job_id, offset=ended_job.result.size + 1)))
    assert caught.value.code() == grpc.StatusCode.OUT_OF_RANGE


def column_of_file(file, column):
    """The history named `column` by the plain names in the file."""
    group, *names = column.split(".")
    if group in ("energies", "momentum", "reactions"):
        return file[group][".".join(names)][:]
    dataset = file["probes"][group][names[0]]
    if len(names) == 1:
        return dataset[:]
    components = [name.decode() if isinstance(name, bytes) else name for name in dataset.attrs["components"]]
    return dataset[:, components.index(names[1])]


def test_the_file_holds_the_streamed_values_under_plain_names(stream, ended_job, result):
    columns, _, time, values = stream(ended_job.job_id)
    with h5py.File(result, "r") as file:
        numpy.testing.assert_array_equal(file["probes/tip/time"][:], time)
        numpy.testing.assert_array_equal(file["energies/time"][:], time)
        for number, column in enumerate(columns):
            numpy.testing.assert_array_equal(column_of_file(file, column), values[:, number], err_msg=column)


def test_the_file_holds_the_measures_of_the_job(ended_job, result):
    with h5py.File(result, "r") as file:
        rows = file["measures"][:]
    assert [row["name"].decode() for row in rows] == [measure.name for measure in ended_job.measures]
    assert [row["value"] for row in rows] == [measure.value for measure in ended_job.measures]
    assert math.isnan(rows[0]["exact"]) and rows[1]["exact"] == ended_job.measures[1].exact


def test_the_file_says_which_scene_it_is_of(result, bar):
    from google.protobuf import text_format
    from trajan.v1 import scene_pb2
    with h5py.File(result, "r") as file:
        assert text_format.Parse(file.attrs["scene"], scene_pb2.Scene()) == bar
