"""The command line against real servers: what a person does, with cuts and interrupts."""

import csv
import hashlib
import io
import json
import os
import pathlib
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
def server(environment):
    """A server at the default place, found by the client without being told."""
    process = subprocess.Popen([TRAJAN, "serve", "--workers", "1", "--log-level", "warning"], env=environment,
                               stdout=subprocess.PIPE, text=True)
    assert "listening" in process.stdout.readline()
    yield process
    process.terminate()
    process.wait(PATIENCE)


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
    assert 'did you mean "DISPLACEMENT"?' in done.stderr


def test_a_bad_scene_is_never_queued(trajan, server):
    trajan("submit", "-", text=TEN_MISTAKES, expect=2)
    assert json.loads(trajan("ls", "-o", "json").stdout).get("jobs", []) == []


def test_the_same_request_id_makes_one_job(trajan, server):
    first = trajan("submit", "-", "--request-id", "a", text=SCENE % 1).stdout
    assert trajan("submit", "-", "--request-id", "a", text=SCENE % 1).stdout == first
    assert len(trajan("ls", "-o", "jsonl").stdout.splitlines()) == 1


def test_watch_detaches_on_an_interrupt_and_resumes(trajan, server, environment):
    job = submit(trajan, end_time=400)
    watcher = subprocess.Popen([TRAJAN, "watch", job], env=environment, stderr=subprocess.PIPE, text=True)
    assert job or watcher.stderr.readline()
    watcher.stderr.readline()  # it follows
    watcher.send_signal(signal.SIGINT)
    _, said = watcher.communicate(timeout=PATIENCE)
    assert watcher.returncode == 130
    assert f"trajan watch {job}" in said
    trajan("cancel", job)
    assert "cancelled" in trajan("watch", job, expect=1).stderr


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


def test_plot_and_render_draw_pictures(trajan, server, tmp_path):
    job = submit(trajan)
    trajan("watch", job)
    for suffix, start in ((".png", b"\x89PNG"), (".svg", b"<?xml")):
        trajan("plot", job, "-O", f"history{suffix}")
        trajan("plot", job, "tip", "--spectrum", "-O", f"spectrum{suffix}")
        trajan("render", job, "--field", "stress.xx", "-O", f"particles{suffix}")
        for name in ("history", "spectrum", "particles"):
            assert (tmp_path / f"{name}{suffix}").read_bytes().startswith(start)
