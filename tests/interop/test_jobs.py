"""Checking, submitting, watching and ending jobs."""

import math

import grpc
import pytest

import scenes
import service


@pytest.fixture(scope="module")
def messages():
    from trajan.v1 import jobs_pb2
    return jobs_pb2


def call_fails(call, request, code):
    with pytest.raises(grpc.RpcError) as caught:
        answer = call(request)
        if hasattr(answer, "__next__"):
            list(answer)
    assert caught.value.code() == code, caught.value
    return caught.value


def sequences(watched):
    return [message.event.sequence for message in watched if message.HasField("event")]


def test_check_reports_every_mistake_at_once(jobs, messages, ten_mistakes):
    answer = jobs.CheckScene(messages.CheckSceneRequest(scene=ten_mistakes))
    assert {violation.path for violation in answer.violations} == scenes.TEN_PATHS
    assert all(violation.problem and violation.remedy for violation in answer.violations)
    assert not answer.HasField("plan")


def test_check_of_a_good_scene_plans_it(jobs, messages, bar):
    answer = jobs.CheckScene(messages.CheckSceneRequest(scene=bar))
    assert not answer.violations
    # 20 by 2 cells of 2 by 2 particles.
    assert answer.plan.particles == 160
    assert answer.plan.active_cells == 40
    assert answer.plan.steps * answer.plan.time_step >= bar.analysis.end_time * (1 - 1e-9)
    assert answer.plan.time_step_limit
    assert sum(attribute.bytes_per_particle for attribute in answer.plan.attributes) > 0


def test_a_bad_scene_is_refused_with_the_violations_of_check(jobs, messages, ten_mistakes):
    error = call_fails(jobs.SubmitJob, messages.SubmitJobRequest(scene=ten_mistakes), grpc.StatusCode.INVALID_ARGUMENT)
    details = service.error_details(error)
    assert details.reason == "INVALID_SCENE"
    assert list(details.violations) == list(jobs.CheckScene(messages.CheckSceneRequest(scene=ten_mistakes)).violations)


def test_the_same_request_id_gives_the_same_job(submit, ended_job, bar):
    assert submit(bar, request_id="the ended job").job_id == ended_job.job_id


def test_the_same_request_id_for_another_request_is_an_error(jobs, messages, ended_job, bar):
    request = messages.SubmitJobRequest(scene=bar, request_id="the ended job", priority=5)
    call_fails(jobs.SubmitJob, request, grpc.StatusCode.ALREADY_EXISTS)


def test_a_watch_tells_the_whole_story_in_order(messages, submit, watch, bar):
    watched = watch(submit(bar).job_id)
    assert watched[0].HasField("job"), "the first message is the current state"
    assert sequences(watched) == list(range(1, len(sequences(watched)) + 1))
    states = [message.event.state for message in watched if message.event.HasField("state")]
    assert states == [messages.QUEUED, messages.RUNNING, messages.SUCCEEDED]
    assert watched[-1].job.state == messages.SUCCEEDED
    assert watched[-1].job.last_sequence == sequences(watched)[-1]


def test_a_watch_resumes_without_gap_or_repetition(jobs, messages, submit, watch, bar):
    job = submit(bar)
    seen = []
    call = jobs.WatchJob(messages.WatchJobRequest(job_id=job.job_id))
    for message in call:
        seen += sequences([message])
        if len(seen) == 2:
            break
    call.cancel()
    seen += sequences(watch(job.job_id, after=seen[-1]))
    assert seen == list(range(1, len(seen) + 1))
    assert seen == sequences(watch(job.job_id)), "nor does a later watch see anything else"


def test_a_watch_from_beyond_the_last_event_is_an_error(jobs, messages, ended_job):
    request = messages.WatchJobRequest(job_id=ended_job.job_id, after_sequence=ended_job.last_sequence + 1)
    call_fails(jobs.WatchJob, request, grpc.StatusCode.OUT_OF_RANGE)


def test_a_running_job_can_be_cancelled_twice(jobs, messages, submit, watch, long_bar):
    job = submit(long_bar)
    for message in jobs.WatchJob(messages.WatchJobRequest(job_id=job.job_id)):
        if message.event.HasField("progress"):
            break
    jobs.CancelJob(messages.CancelJobRequest(job_id=job.job_id, reason="enough seen"))
    assert watch(job.job_id)[-1].job.state == messages.CANCELLED
    again = jobs.CancelJob(messages.CancelJobRequest(job_id=job.job_id))
    assert again.state == messages.CANCELLED


def test_an_ended_job_can_be_deleted_and_a_running_one_cannot(jobs, messages, submit, watch, bar, long_bar):
    ended, running = submit(bar).job_id, submit(long_bar).job_id
    watch(ended)
    call_fails(jobs.DeleteJob, messages.DeleteJobRequest(job_id=running), grpc.StatusCode.FAILED_PRECONDITION)
    jobs.CancelJob(messages.CancelJobRequest(job_id=running))
    jobs.DeleteJob(messages.DeleteJobRequest(job_id=ended))
    call_fails(jobs.GetJob, messages.GetJobRequest(job_id=ended), grpc.StatusCode.NOT_FOUND)


@pytest.mark.parametrize("name", ["GetJob", "CancelJob", "DeleteJob", "WatchJob", "StreamHistory", "ReadResult"])
def test_a_job_that_nobody_submitted_is_not_found(jobs, messages, name):
    request = getattr(messages, name + "Request")(job_id="nobody-submitted-this")
    call_fails(getattr(jobs, name), request, grpc.StatusCode.NOT_FOUND)


def test_a_job_gives_its_scene_back(jobs, messages, ended_job, bar):
    assert jobs.GetJob(messages.GetJobRequest(job_id=ended_job.job_id, with_scene=True)).scene == bar
    assert not jobs.GetJob(messages.GetJobRequest(job_id=ended_job.job_id)).HasField("scene")


def test_lists_come_in_pages_newest_first(jobs, messages, submit, bar):
    ids = [submit(bar, labels={"series": "pages", "number": str(i)}).job_id for i in range(3)]
    request = messages.ListJobsRequest(labels={"series": "pages"}, page_size=2)
    first = jobs.ListJobs(request)
    request.page_token = first.next_page_token
    second = jobs.ListJobs(request)
    assert [job.job_id for job in [*first.jobs, *second.jobs]] == ids[::-1]
    assert first.next_page_token and not second.next_page_token
    request.page_token = "not one of yours"
    call_fails(jobs.ListJobs, request, grpc.StatusCode.INVALID_ARGUMENT)


def test_measures_come_with_exact_values_and_errors(ended_job):
    last, largest = ended_job.measures
    assert last.quantity == "tip.displacement.x" and not last.HasField("exact")
    exact = 0.1 / (math.pi / 2 * math.sqrt(100 / (1 - 0.25**2)))
    # A few roundings, and a difference of numbers that are nearly equal.
    assert largest.exact == pytest.approx(exact, rel=1e-14)
    assert largest.error == pytest.approx((largest.value - exact) / exact, rel=1e-10)
    assert abs(largest.error) < largest.tolerance
