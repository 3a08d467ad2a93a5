"""The command line against real servers: what a person does, with cuts and interrupts."""

import contextlib
import csv
import hashlib
import io
import json
import os
import pathlib
import re
import signal
import subprocess
import time

import pytest

PROGRAMS = pathlib.Path(os.environ["TRAJAN_BIN"])
TRAJAN = PROGRAMS / "trajan"
PATIENCE = 120  # seconds until a test is given up; nothing is measured against it

SCENE = """
name: "bar"
domain { dimension: PLANE_STRESS lower { x: 0 y: 0 } upper { x: 12 y: 1 } cell_size: 0.5 }
materials { name: "steel" density: 1 linear_elastic { youngs_modulus: 100 poissons_ratio: 0 } }
bodies { name: "bar" material: "steel" geometry { box { lower { x: 0 y: 0 } upper { x: 10 y: 1 } } }
         initial_velocity { x: "0.1 * sin(pi * x / 20)" } }
boundaries { name: "wall" nodes { box { lower { x: 0 y: 0 } upper { x: 0 y: 1 } } } fixed { axes: X } }
analysis { end_time: %g }
outputs { samples: 100 snapshots: 2
          probes { name: "tip" nearest { x: 10 y: 0.5 } fields: DISPLACEMENT } }
measures { name: "tip" quantity: "tip.displacement.x" extreme { kind: MAGNITUDE } }
"""

TEN_MISTAKES = """nmae: "bar"
domain { dimension: PLANE_STRES lower { x: 0 y: 0 } upper { x: 12 y: 1 } cell_size: -0.5 }
materials { name: "steel" density: "heavy" linear_elastic { youngs_modulus: 100 poissons_ratio: 0.7 } }
bodies { name: "bar" material: "stel" geometry { disc { centre { x: 1 y: 0.5 } radius: 0 } } colour: 3 }
analysis { end_time: -1 }
outputs { probes { name: "tip" nearest { x: 1 y: 0.5 } fields: DISPLACMENT } }
"""


@pytest.fixture
def environment(tmp_path):
    """A person of one's own: nothing of the machine's configuration or servers is seen."""
    result = {key: value for key, value in os.environ.items() if key not in ("TRAJAN_SERVER",)}
    result.update(HOME=str(tmp_path), XDG_STATE_HOME=str(tmp_path / "s"), XDG_CONFIG_HOME=str(tmp_path / "c"))
    return result


@pytest.fixture
def trajan(environment, tmp_path):
    def call(*arguments, text=None, expect=0):
        done = subprocess.run([TRAJAN, *arguments], env=environment, cwd=tmp_path, input=text, text=True,
                              capture_output=True, timeout=PATIENCE)
        assert done.returncode == expect, f"{arguments}: {done.returncode}\n{done.stdout}\n{done.stderr}"
        return done

    return call


@pytest.fixture
def start_server(environment):
    """Starts a server at the default place, found by the client without being told; the last one is ended."""
    processes = []

    def start():
        process = subprocess.Popen([TRAJAN, "serve", "--workers", "1", "--no-calibrate", "--log-level", "warning"], env=environment,
                                   stdout=subprocess.PIPE, text=True)
        processes.append(process)
        assert "listening" in process.stdout.readline()
        return process

    yield start
    for process in processes:
        process.terminate()
        process.wait(PATIENCE)


@pytest.fixture
def server(start_server):
    return start_server()


def submit(trajan, end_time=1.0):
    return trajan("submit", "-", text=SCENE % end_time).stdout.strip()


def test_run_needs_no_server_and_brings_back_results(trajan, tmp_path):
    (tmp_path / "bar.textproto").write_text(SCENE % 1)
    done = trajan("run", "bar.textproto", "--directory", "out", "--no-picture")
    assert "MEASURE" in done.stdout
    assert {"result.vtkhdf", "history.csv"} <= {file.name for file in (tmp_path / "out").iterdir()}
    with open(tmp_path / "out" / "history.csv") as table:
        assert len(list(csv.reader(table))) == 1 + 101


def test_check_shows_ten_mistakes_at_once_with_their_places(trajan, tmp_path):
    (tmp_path / "bad.textproto").write_text(TEN_MISTAKES)
    done = trajan("check", "bad.textproto", expect=2)
    places = [line.split(": error:")[0] for line in done.stderr.splitlines() if ": error:" in line]
    expected = {"1:1", "2:21", "2:85", "3:36", "3:97", "4:32", "4:88", "4:94", "5:22", "6:64"}
    assert {place.removeprefix("bad.textproto:") for place in places} == expected
    assert 'did you mean "name"?' in done.stderr
    assert 'error: bodies[0].material: there is no material "stel"\n' in done.stderr
    assert 'hint: did you mean "steel"? (materials: steel)\n' in done.stderr
    assert 'did you mean "DISPLACEMENT"?' in done.stderr


def test_the_plan_says_who_asked_for_what_and_what_each_sweep_does(trajan):
    table = trajan("check", "discs", "--plan").stdout
    assert [line.split() for line in table.splitlines() if line.startswith("velocity.x")] == [
        ["velocity.x", "8", "scheme", "MUSL"],
        ["velocity.x", "8", "scheme", "MUSL"],
    ], "of particles and of nodes"
    plan = json.loads(trajan("check", "discs", "--plan", "-o", "json").stdout)
    stages = [sweep["of_bodies"][0]["stages"] for sweep in plan["sweeps"]]
    assert len(stages) == 2 and "deform (neo_hookean)" in stages[1]
    assert "several tables" in trajan("check", "discs", "--plan", "-o", "csv", expect=2).stderr


def test_a_bad_scene_is_never_queued(trajan, server):
    trajan("submit", "-", text=TEN_MISTAKES, expect=2)
    assert json.loads(trajan("ls", "-o", "json").stdout).get("jobs", []) == []


def test_the_same_request_id_makes_one_job(trajan, server):
    first = trajan("submit", "-", "--request-id", "a", text=SCENE % 1).stdout
    assert trajan("submit", "-", "--request-id", "a", text=SCENE % 1).stdout == first
    assert len(trajan("ls", "-o", "jsonl").stdout.splitlines()) == 1


def test_the_job_has_the_scene_with_the_fields_that_were_set(trajan, server):
    job = trajan("submit", "-", "--set", "analysis.end_time=0.5", "--set", "description=half as long",
                 text=SCENE % 1).stdout.strip()
    scene = trajan("show", job, "--scene").stdout
    assert "end_time: 0.5" in scene and 'description: "half as long"' in scene
    assert "not PATH=VALUE" in trajan("submit", "-", "--set", "=", text=SCENE % 1, expect=2).stderr


def test_watch_detaches_on_an_interrupt_and_resumes(trajan, server, environment):
    job = submit(trajan, end_time=20000)
    watcher = subprocess.Popen([TRAJAN, "watch", job], env=environment, stderr=subprocess.PIPE, text=True)
    watcher.stderr.readline()  # it follows
    watcher.send_signal(signal.SIGINT)
    _, said = watcher.communicate(timeout=PATIENCE)
    assert watcher.returncode == 130
    assert f"trajan watch {job}" in said
    trajan("cancel", job)
    assert "cancelled" in trajan("watch", job, expect=1).stderr


@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGTERM])
def test_followers_survive_a_restart_of_the_server(trajan, start_server, environment, end):
    server = start_server()
    job = submit(trajan, end_time=2000)
    watcher = subprocess.Popen([TRAJAN, "watch", job, "-o", "jsonl"], env=environment, stdout=subprocess.PIPE, text=True)
    follower = subprocess.Popen([TRAJAN, "history", job, "tip", "--follow", "-o", "jsonl"], env=environment,
                                stdout=subprocess.PIPE, text=True)
    told = [watcher.stdout.readline()]
    rows = [follower.stdout.readline() for _ in range(10)]  # in mid-stream
    server.send_signal(end)
    server.wait(PATIENCE)
    start_server()
    told += watcher.stdout.read().splitlines()
    rows += follower.stdout.read().splitlines()
    assert watcher.wait(PATIENCE) == follower.wait(PATIENCE) == 0
    told = [json.loads(line) for line in told]
    sequence = [int(line["event"]["sequence"]) for line in told if "event" in line]
    assert sequence == list(range(1, len(sequence) + 1))
    assert told[-1]["job"]["state"] == "SUCCEEDED"
    assert int(told[-1]["job"]["last_sequence"]) == len(sequence)
    assert [json.loads(row)["row"] for row in rows] == list(range(101))


def test_an_interrupted_run_brings_back_what_was_recorded(environment, tmp_path):
    run = subprocess.Popen([TRAJAN, "run", "-", "-O", "out", "--no-picture"], env=environment, cwd=tmp_path, text=True,
                           stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    run.stdin.write(SCENE % 20000)
    run.stdin.close()
    run.stdin = None
    while not re.search("[1-9]0 %", run.stderr.readline()):  # at least the first tenth is done
        pass
    run.send_signal(signal.SIGINT)
    files, said = run.communicate(timeout=PATIENCE)
    assert run.returncode == 130, said
    assert "incomplete" in said
    assert {pathlib.Path(line).name for line in files.splitlines()} >= {"result.vtkhdf", "history.csv"}
    with open(tmp_path / "out" / "history.csv") as table:
        assert 10 <= len(list(csv.reader(table))) - 1 < 101


def children_of(process):
    """Of any of its threads."""
    tasks = pathlib.Path(f"/proc/{process}/task").glob("*/children")
    return [int(child) for task in tasks for child in task.read_text().split()]


def test_a_second_interrupt_leaves_at_once(environment, tmp_path):
    run = subprocess.Popen([TRAJAN, "run", "-", "-O", "out"], env=dict(environment, TMPDIR=tmp_path), cwd=tmp_path, text=True,
                           stdin=subprocess.PIPE, stderr=subprocess.PIPE)
    run.stdin.write(SCENE % 20000)
    run.stdin.close()
    while "running" not in run.stderr.readline():
        pass
    (server,) = children_of(run.pid)
    workers = children_of(server)
    os.kill(server, signal.SIGSTOP)  # it cannot stop the job
    run.send_signal(signal.SIGINT)
    while "stopping" not in run.stderr.readline():
        pass
    run.send_signal(signal.SIGINT)
    assert run.wait(PATIENCE) == 130
    for process in [server, *workers]:
        with contextlib.suppress(ProcessLookupError):
            os.kill(process, signal.SIGTERM)
            os.kill(process, signal.SIGCONT)
    assert not (tmp_path / "out").exists()


def test_a_scene_in_latin_1_is_refused_with_its_place(trajan, tmp_path):
    (tmp_path / "latin.textproto").write_bytes((SCENE % 1).replace("bar", "Tr\u00e4ger").encode("latin-1"))
    assert "latin.textproto:2:10: error: the byte 0xE4 is not valid UTF-8" in trajan("check", "latin.textproto", expect=2).stderr


def test_follow_prints_every_row_once(trajan, server):
    job = submit(trajan, end_time=20)
    rows = list(csv.reader(io.StringIO(trajan("history", job, "tip", "--follow").stdout)))
    assert rows[0] == ["time", "tip.displacement.x", "tip.displacement.y"]
    times = [float(row[0]) for row in rows[1:]]
    assert len(times) == 101 and times == sorted(set(times))
    tail = [json.loads(line) for line in trajan("history", job, "tip", "--from-row", "90", "-o", "jsonl").stdout.splitlines()]
    assert [row["row"] for row in tail] == list(range(90, 101))


def test_fetch_goes_on_after_a_cut_and_replaces_what_is_wrong(trajan, server, tmp_path):
    job = submit(trajan)
    trajan("watch", job)
    trajan("fetch", job, "-O", "whole")
    whole = (tmp_path / "whole" / "result.vtkhdf").read_bytes()
    told = json.loads(trajan("show", job, "-o", "json").stdout)["result"]["sha256"]
    assert hashlib.sha256(whole).hexdigest() == told
    (tmp_path / "cut").mkdir()
    part = tmp_path / "cut" / f"result.vtkhdf.{job}.part"
    part.write_bytes(whole[:1000])
    assert "going on" in trajan("fetch", job, "-O", "cut").stderr
    assert (tmp_path / "cut" / "result.vtkhdf").read_bytes() == whole
    part.write_bytes(b"x" * 1000)
    (tmp_path / "cut" / "result.vtkhdf").unlink()
    trajan("fetch", job, "-O", "cut")
    assert (tmp_path / "cut" / "result.vtkhdf").read_bytes() == whole


def test_unknown_jobs_and_absent_servers_have_their_exit_codes(trajan, server):
    trajan("show", "no-such-job", expect=4)
    trajan("--server", "unix:/nonexistent/socket", "ls", expect=3)
    trajan("chekc", expect=2)
    trajan("run", "cantilver", expect=4)


def test_sweep_prints_a_table_and_answers_it_again_from_what_is_there(trajan, server):
    arguments = ["sweep", "-", "--over", "analysis.end_time=0.5:1:2", "--over", "numerics.scheme=MUSL,USL", "-o", "csv"]
    first = list(csv.DictReader(io.StringIO(trajan(*arguments, text=SCENE % 1).stdout)))
    assert [(row["analysis.end_time"], row["numerics.scheme"]) for row in first] == [
        ("0.5", "MUSL"), ("0.5", "USL"), ("1", "MUSL"), ("1", "USL")]
    assert all(row["state"] == "succeeded" and float(row["core_seconds"]) > 0 for row in first)
    again = list(csv.DictReader(io.StringIO(trajan(*arguments, text=SCENE % 1).stdout)))
    assert [row["tip"] for row in again] == [row["tip"] for row in first]
    assert [row["answered_by"] for row in again] == [row["job"] for row in first]
    listed = [json.loads(line) for line in trajan("ls", "-o", "jsonl").stdout.splitlines()]
    assert [job["study"]["kind"] for job in listed] == ["sweep", "sweep"]
    study = listed[0]["job_id"]
    assert len(trajan("ls", "--study", study, "-o", "jsonl").stdout.splitlines()) == 4
    assert len(json.loads(trajan("show", study, "-o", "json").stdout)["runs"]) == 4
    assert "TIP" in trajan("watch", study).stdout
    trajan("rm", study)
    trajan("show", study, expect=4)


def test_a_sweep_with_mistakes_is_never_queued(trajan, server):
    said = trajan("sweep", "-", "--over", "domain.cell_size=0.5,-1", "--detach", text=SCENE % 1, expect=2).stderr
    assert "domain.cell_size=-1" in said
    assert "not PATH=VALUES" in trajan("sweep", "-", "--over", "x", text=SCENE % 1, expect=2).stderr
    assert "did you mean" in trajan("sweep", "-", "--over", "domain.cel_size=1", text=SCENE % 1, expect=2).stderr
    assert json.loads(trajan("ls", "-o", "json").stdout).get("jobs", []) == []


def test_a_study_says_how_far_the_measures_are_off(trajan, tmp_path):
    (tmp_path / "bar.textproto").write_text(SCENE % 0.5)
    told = json.loads(trajan("study", "bar.textproto", "--finest", "0.125", "-o", "json").stdout)
    assert [run["settings"] for run in told["runs"]] == [["0.5"], ["0.25"], ["0.125"]]
    (claim,) = told["convergences"]
    assert claim["cell_sizes"] == [0.5, 0.25, 0.125]
    assert ("band" in claim) != bool(claim["no_claim"])
    trajan("study", "bar.textproto", "--levels", "2", expect=2)


def test_a_tradeoff_marks_the_best_and_draws_them(trajan, tmp_path):
    (tmp_path / "bar.textproto").write_text(SCENE % 0.5 + 'measures { name: "quarter" quantity: "tip.displacement.x" final {} exact: "0.04" }')
    arguments = ["--over", "domain.cell_size=0.5,0.25", "--over", "numerics.shape_functions=linear,bernstein,gimp"]
    told = json.loads(trajan("tradeoff", "bar.textproto", *arguments, "--picture", "trade.png", "-o", "json").stdout)
    assert len(told["runs"]) == 4 and any(run["pareto"] for run in told["runs"])
    assert told["trade"]["measure"] == "quarter" and told["trade"]["skipped"][0]["combinations"] == 2
    assert (tmp_path / "trade.png").read_bytes().startswith(b"\x89PNG")
    assert "TOLERANCE" in trajan("tradeoff", "bar.textproto", *arguments).stdout
    trajan("tradeoff", "bar.textproto", "--measure", "tap", expect=2)


def test_a_run_within_a_tolerance_tells_value_band_settings_and_cost_and_brings_its_files(trajan, server):
    told = trajan("run", "hanging_rod", "--tolerance", "end_displacement=0.5%", "--no-picture").stdout
    value, band = map(float, re.search(r"end_displacement = (\S+) \+- (\S+)", told).groups())
    assert band <= 0.005 * value
    assert abs(value - 0.25949267) <= band  # the scene's exact value, which a target does not look at
    assert "core-seconds" in told and "domain.cell_size=" in told and "result.vtkhdf" in told
    job = json.loads(trajan("ls", "-o", "jsonl").stdout.splitlines()[0])
    assert job["study"]["kind"] == "target" and job["settings"]["cell_size"] > 0
    shown = trajan("show", job["job_id"]).stdout
    assert "answer of" in shown and "answer     end_displacement" in shown
    trajan("fetch", job["job_id"])
    trajan("plot", job["job_id"], "--picture", "rod.png")
    repeated = trajan("run", "hanging_rod", "--tolerance", "end_displacement=0.5%", "--no-picture").stdout
    assert "0 with the runs that led to it" in repeated, "nothing was computed again"


def test_a_tolerance_beyond_the_budget_is_no_answer(trajan, server):
    beyond = ("run", "hanging_rod", "--tolerance", "end_displacement=0.0000001%", "--budget")
    done = trajan(*beyond, "0.000001", expect=1)
    # One run has no band. The budget for a second is what the service says it takes, on a machine however slow.
    takes = float(re.search(r"next run would take about (\S+)", done.stdout)[1])
    done = trajan(*beyond, str(2 * takes), expect=1)
    assert "NOT REACHED" in done.stdout and "+-" in done.stdout
    assert "TOLERANCE_NOT_REACHED" in done.stderr
    trajan("submit", "hanging_rod", "--tolerance", "end=1%", expect=2)
    trajan("submit", "hanging_rod", "--tolerance", "end_displacement", expect=2)


def test_presets_change_the_cells_and_the_job_tells_the_settings(trajan, server):
    for preset, cell_size in (("preview", 0.03125), ("standard", 0.015625), ("reference", 0.0078125)):
        job = trajan("submit", "hanging_rod", "--fidelity", preset).stdout.strip()
        told = json.loads(trajan("show", job, "-o", "json").stdout)
        assert told["settings"]["cell_size"] == cell_size
        assert told["settings"]["numerics"]["scheme"] == "TLMPM"


def test_plot_and_render_draw_pictures(trajan, server, tmp_path):
    job = submit(trajan)
    trajan("watch", job)
    for suffix, start in ((".png", b"\x89PNG"), (".svg", b"<?xml")):
        trajan("plot", job, "-O", f"history{suffix}")
        trajan("plot", job, "tip", "--spectrum", "-O", f"spectrum{suffix}")
        trajan("render", job, "--field", "stress.xx", "-O", f"particles{suffix}")
        for name in ("history", "spectrum", "particles"):
            assert (tmp_path / f"{name}{suffix}").read_bytes().startswith(start)


# Particles on nodes of linear functions: energy comes from nowhere, step by step.
SHAKEN = """
name: "shaken"
domain { dimension: BAR lower { x: 0 } upper { x: 12 } cell_size: 1 }
materials { name: "solid" density: 1 linear_elastic { youngs_modulus: 100 poissons_ratio: 0.3 } }
bodies { name: "block" material: "solid" geometry { box { lower { x: 4.25 } upper { x: 7.25 } } }
         initial_velocity { x: "0.001*sin(41*x)" } }
analysis { end_time: 8 }
numerics { scheme: "USF" time_step: 0.05 }
outputs { samples: 10 snapshots: 1 }
"""


def test_a_doubtful_result_is_told_and_a_wrong_one_is_none(trajan, tmp_path):
    (tmp_path / "shaken.textproto").write_text(SHAKEN)
    told = trajan("run", "shaken.textproto", expect=1).stderr
    assert "warning: the result is doubtful from time 0.8" in told
    assert "DIVERGED: energy has come from nowhere" in told
