"""A private server and the command-line client, as a user has them."""

import contextlib
import json
import os
import pathlib
import subprocess
import tempfile
from dataclasses import dataclass

import h5py

PATIENCE = 3600  # seconds until a job is given up


@dataclass
class Result:
    """A finished job: its result file, its measures by name and the core-seconds that it took."""

    file: pathlib.Path
    core_seconds: float
    measures: dict

    def history(self, probe, field):
        """Times, shape (rows,), and a probe's values, shape (rows, components), or (rows,) if there is one component."""
        with h5py.File(self.file) as file:
            group = file["probes"][probe]
            values = group[field][:]
            return group["time"][:], values[:, 0] if values.ndim == 2 and values.shape[1] == 1 else values

    def column(self, group, name):
        """A column of the energies, the momentum, the reactions or the modes by its name."""
        with h5py.File(self.file) as file:
            return file[group][name][:]

    def snapshot(self, *fields, index=-1):
        """Of a snapshot (the last by default): current positions, shape (particles, 3), and the fields named."""
        with h5py.File(self.file) as file:
            root = file["VTKHDF"]
            steps = root["Steps"]
            count = int(root["NumberOfPoints"][steps["PartOffsets"][index]])
            starts = [steps["PointOffsets"], *(steps["PointDataOffsets"][field] for field in fields)]
            data = [root["Points"], *(root["PointData"][field] for field in fields)]
            return [values[start[index] : start[index] + count] for start, values in zip(starts, data)]


def descendants(process):
    """A process and all its descendants, by id."""
    found = [process]
    for parent in found:
        for task in pathlib.Path(f"/proc/{parent}/task").glob("*/children"):
            with contextlib.suppress(OSError):
                found += [int(child) for child in task.read_text().split()]
    return found


def processor_seconds(process):
    """Of a process, its descendants and those of them that have ended and were waited for."""
    ticks = 0
    for one in descendants(process):
        with contextlib.suppress(OSError):
            fields = pathlib.Path(f"/proc/{one}/stat").read_text().rpartition(")")[2].split()
            ticks += sum(int(field) for field in fields[11:15])  # utime, stime, cutime, cstime: proc(5)
    return ticks / os.sysconf("SC_CLK_TCK")


class Service:
    """Runs scenes through `trajan submit`, `watch` and `fetch` on a server of its own with one single-threaded worker."""

    def __init__(self, programs, folder, reuse=False):
        self._program = str(programs / "trajan")
        self._folder = folder
        self._reuse = reuse
        self._exits = contextlib.ExitStack()

    def __enter__(self):
        # The socket's path must be short.
        state = self._exits.enter_context(tempfile.TemporaryDirectory())
        self._environment = dict(os.environ, XDG_STATE_HOME=state)
        self._environment.pop("TRAJAN_SERVER", None)
        log = self._exits.enter_context(open(self._folder / "server.log", "w", encoding="utf-8"))
        options = ["--workers", "1", "--threads-per-worker", "1", "--log-level", "warning"]
        self._server = subprocess.Popen(
            [self._program, "serve", "--no-calibrate", *options], env=self._environment, stdout=subprocess.PIPE, stderr=log
        )
        self._exits.callback(lambda: (self._server.terminate(), self._server.wait(), self._server.stdout.close()))
        if b"listening" not in self._server.stdout.readline():
            raise RuntimeError(f"the server did not start; see {self._folder / 'server.log'}")
        return self

    def __exit__(self, *_):
        self._exits.close()

    def call(self, *arguments, text=None, accept=(0,)):
        """What `trajan` prints; raises RuntimeError if it ends with another code than those accepted."""
        done = subprocess.run(
            [self._program, *arguments], env=self._environment, input=text, text=True, capture_output=True,
            timeout=PATIENCE,
        )
        if done.returncode not in accept:
            raise RuntimeError(f"trajan {' '.join(arguments)}: {done.stderr}")
        return done.stdout

    def run(self, name, scene):
        """The result of a scene given as text; raises RuntimeError if there is none. `name` is a folder of the report."""
        folder = self._folder / name
        kept = self._kept(folder, scene)
        if kept:
            return kept
        before = processor_seconds(self._server.pid)
        job = self.call("submit", "-", text=scene).strip()
        self.call("watch", job, accept=(0, 1))  # 1: it failed, which its state says, or missed a tolerance
        spent = processor_seconds(self._server.pid) - before
        told = json.loads(self.call("show", job, "-o", "json"))
        return self._keep(folder, scene, job, told, spent)

    def sweep(self, name, scene, path, values):
        """The results of a study of a scene, one for each value of a field, given by its path."""
        folders = [self._folder / name / str(value) for value in values]
        texts = [f"{scene}\n# {path}={value}\n" for value in values]
        kept = [self._kept(folder, text) for folder, text in zip(folders, texts)]
        if all(kept):
            return kept
        over = f"{path}={','.join(map(str, values))}"
        study = self.call("sweep", "-", "--over", over, "--detach", text=scene).strip()
        self.call("watch", study, accept=(0, 1))
        runs = json.loads(self.call("show", study, "-o", "json"))["runs"]
        return [
            self._keep(folder, text, run["job_id"], run, run.get("cost", {}).get("core_seconds", 0.0))
            for folder, text, run in zip(folders, texts, runs)
        ]

    def _kept(self, folder, text):
        """The result of an earlier validation, if it may be used and is of the same scene."""
        costs = folder / "run.json"
        if not (self._reuse and costs.exists() and (folder / "scene.textproto").read_text(encoding="utf-8") == text):
            return None
        return Result(folder / "result.vtkhdf", **json.loads(costs.read_text(encoding="utf-8")))

    def _keep(self, folder, text, job, told, spent):
        """Fetches the files of a finished job, of which `told` says state and measures."""
        if told["state"] != "SUCCEEDED":
            raise RuntimeError(f"{folder.name}: {told['state']}: {told.get('failure', '')}")
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "run.json").unlink(missing_ok=True)
        (folder / "scene.textproto").write_text(text, encoding="utf-8")
        self.call("fetch", job, "--directory", str(folder))
        measures = {measure["name"]: measure.get("value") for measure in told.get("measures", [])}
        (folder / "run.json").write_text(json.dumps({"core_seconds": spent, "measures": measures}), encoding="utf-8")
        return Result(folder / "result.vtkhdf", spent, measures)
