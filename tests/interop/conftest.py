import os
import pathlib
import shutil
import signal
import subprocess
import tempfile

import pytest

import scenes
import service


@pytest.fixture(scope="session", autouse=True)
def stubs(tmp_path_factory):
    service.generate_stubs(tmp_path_factory.mktemp("stubs"))


@pytest.fixture(scope="session")
def channel(stubs):
    """A channel to a server of our own, which must end cleanly when it is asked to."""
    # Not pytest's folder: the path of a Unix socket has at most 107 bytes.
    folder = pathlib.Path(tempfile.mkdtemp(prefix="trajan-"))
    address = f"unix:{folder}/api"
    program = pathlib.Path(os.environ["TRAJAN_BIN"]) / "trajand"
    process = subprocess.Popen([program, "serve", "--no-calibrate", "--listen", address, "--state", folder / "state"])
    try:
        with service.wait_until_ready(address, process) as channel:
            yield channel
        process.send_signal(signal.SIGTERM)
        assert process.wait(timeout=60) == 0
    finally:
        process.kill()
        process.wait()
        shutil.rmtree(folder)


@pytest.fixture(scope="session")
def jobs(channel):
    from trajan.v1 import jobs_pb2_grpc
    return jobs_pb2_grpc.JobsStub(channel)


def parse_scene(text):
    from google.protobuf import text_format
    from trajan.v1 import scene_pb2
    return text_format.Parse(text, scene_pb2.Scene())


@pytest.fixture(scope="session")
def bar(stubs):
    return parse_scene(scenes.VIBRATING_BAR % {"end_time": 2, "samples": 400})


@pytest.fixture(scope="session")
def long_bar(stubs):
    """The same vibration for minutes; a test that submits it must cancel it."""
    return parse_scene(scenes.VIBRATING_BAR % {"end_time": 1e5, "samples": 40000})


@pytest.fixture(scope="session")
def ten_mistakes(stubs):
    return parse_scene(scenes.TEN_MISTAKES)


@pytest.fixture(scope="session")
def submit(jobs):
    from trajan.v1 import jobs_pb2

    def submit(scene, **fields):
        return jobs.SubmitJob(jobs_pb2.SubmitJobRequest(scene=scene, **fields))
    return submit


@pytest.fixture(scope="session")
def watch(jobs):
    """All messages of a job's events after `after`, to the end."""
    from trajan.v1 import jobs_pb2

    def watch(job_id, after=0):
        return list(jobs.WatchJob(jobs_pb2.WatchJobRequest(job_id=job_id, after_sequence=after)))
    return watch


@pytest.fixture(scope="session")
def ended_job(submit, watch, bar):
    """The vibrating bar, run to its end."""
    from trajan.v1 import jobs_pb2
    job = watch(submit(bar, request_id="the ended job").job_id)[-1].job
    assert job.state == jobs_pb2.SUCCEEDED, job
    return job
