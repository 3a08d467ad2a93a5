"""Measures the way of data: solver to disk, disk to client.

    stream.py FOLDER [--output FOLDER]

FOLDER has `trajan` and `trajand`. A private server runs two scenes: one that writes large snapshots, whose rate is
compared with dd's (with fsync, to the same disk, in the same run), and one with long histories, which are then streamed
to a client that only counts bytes, and to `trajan history`, which writes them as CSV. Streams are medians of several.
Prints a table and writes `stream.json`.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

MIB = 1 << 20
STREAMS = 5  # of each kind

SCENE = """
name: "stream"
domain {{ dimension: PLANE_STRAIN lower {{ x: -1 y: -1 }} upper {{ x: 2 y: 2 }} cell_size: {cell} }}
materials {{ name: "solid" density: 1000 linear_elastic {{ youngs_modulus: 1000 poissons_ratio: 0.3 }} }}
bodies {{
  name: "square" material: "solid"
  geometry {{ box {{ lower {{ x: 0 y: 0 }} upper {{ x: 1 y: 1 }} }} }}
  initial_velocity {{ x: "1e-3 * x" }}
}}
analysis {{ end_time: {end} explicit_dynamics {{}} }}
numerics {{ time_step: {step} }}
outputs {{ samples: {samples} snapshots: {snapshots}
{probes}}}
"""


def scene(cell, steps, samples, snapshots, probes=0):
    """Of so many steps, a sample after each of them or of every few."""
    step = cell / 10
    text = "".join(
        f'  probes {{ name: "p{i}" nearest {{ x: {(i % 50 + 0.5) / 50} y: {(i // 50 % 50 + 0.5) / 50} }} '
        f"fields: POSITION fields: VELOCITY fields: STRESS }}\n"
        for i in range(probes)
    )
    return SCENE.format(cell=cell, end=step * steps, step=step, samples=samples, snapshots=snapshots, probes=text)


class Server:
    """`trajan serve` with a state of its own."""

    def __init__(self, programs, state):
        self.trajan = programs / "trajan"
        self.environment = os.environ | {"XDG_STATE_HOME": str(state), "HOME": str(state)}
        self.environment.pop("TRAJAN_SERVER", None)
        self.process = subprocess.Popen(
            [self.trajan, "serve", "--workers", "1", "--log-level", "warning"], env=self.environment, stdout=subprocess.DEVNULL
        )
        while subprocess.run([self.trajan, "ls"], env=self.environment, capture_output=True, check=False).returncode:
            if self.process.poll() is not None:
                sys.exit("stream: the server ended")
            time.sleep(0.1)
        self.socket = next(pathlib.Path(state).rglob("*.sock"))

    def run(self, *words, **more):
        done = subprocess.run([self.trajan, *words], env=self.environment, capture_output=True, text=True, check=False, **more)
        if done.returncode:
            sys.exit(f"stream: trajan {' '.join(words)}: {done.stderr}")
        return done.stdout

    def finished_job(self, text):
        """(job, seconds until it ended)"""
        begin = time.monotonic()
        job = self.run("submit", "-", input=text).strip()
        self.run("watch", job)
        return job, time.monotonic() - begin

    def processor_seconds(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def close(self):
        self.process.terminate()
        self.process.wait()


def dd_rate(folder, size):
    """Bytes per second of dd with fsync."""
    path = folder / "dd"
    begin = time.monotonic()
    subprocess.run(
        ["dd", "if=/dev/zero", f"of={path}", "bs=1M", f"count={size // MIB}", "conv=fsync"], capture_output=True, check=True
    )
    rate = size // MIB * MIB / (time.monotonic() - begin)
    path.unlink()
    return rate


def write_rate(server, state):
    """Of a run whose snapshots are nearly all that it does."""
    job, seconds = server.finished_job(scene(cell=1 / 160, steps=40, samples=40, snapshots=40))
    size = max(path.stat().st_size for path in pathlib.Path(state).rglob("result.vtkhdf"))
    cost = json.loads(server.run("show", job, "-o", "json")).get("cost", {})
    return size, seconds, cost


def stream(server, method, request):
    """(bytes, seconds, processor seconds of the server) of a stream that a client only counts."""
    import grpc

    options = [("grpc.max_receive_message_length", -1)]
    with grpc.insecure_channel(f"unix:{server.socket}", options=options) as channel:
        call = channel.unary_stream(f"/trajan.v1.Jobs/{method}")
        before, begin, size = server.processor_seconds(), time.monotonic(), 0
        for message in call(request):
            size += len(message)
        return size, time.monotonic() - begin, server.processor_seconds() - before


def csv(server, job, size):
    """As `stream`, of the same history as text that nobody reads."""
    before, begin = server.processor_seconds(), time.monotonic()
    subprocess.run([server.trajan, "history", job], env=server.environment, stdout=subprocess.DEVNULL, check=True)
    return size, time.monotonic() - begin, server.processor_seconds() - before


def median_row(streams):
    """Of (bytes, seconds, processor seconds of the server)."""
    return {
        "bytes": streams[0][0],
        "bytes_per_s": statistics.median(size / seconds for size, seconds, _ in streams),
        "server_processor_s_per_GB": statistics.median(processor / (size / 1e9) for size, _, processor in streams),
    }


def string_field(number, text):
    """A protobuf field, so that no generated code is needed."""
    data = text.encode()
    return bytes([number << 3 | 2, len(data)]) + data


def measure(programs):
    rows = {}
    with tempfile.TemporaryDirectory(prefix="trajan-") as folder:
        state = pathlib.Path(folder)
        server = Server(programs, state)
        try:
            size, seconds, cost = write_rate(server, state)
            disk = dd_rate(state, size)
            rows["snapshots"] = {"bytes": size, "bytes_per_s": size / seconds, "over_dd": size / seconds / disk, "cost": cost}
            rows["dd"] = {"bytes": size, "bytes_per_s": disk}
            job, _ = server.finished_job(scene(cell=1 / 4, steps=10000, samples=10000, snapshots=1, probes=200))
            request = string_field(1, job)
            rows["history"] = median_row([stream(server, "StreamHistory", request) for _ in range(STREAMS)])
            rows["history.csv"] = median_row([csv(server, job, rows["history"]["bytes"]) for _ in range(STREAMS)])
            rows["result file"] = median_row([stream(server, "ReadResult", request) for _ in range(STREAMS)])
        finally:
            server.close()
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("build/bench"))
    options = parser.parse_args()
    rows = measure(options.programs.resolve())
    print(f"{'what':<12} {'MB':>7} {'MB/s':>8} {'of dd':>6} {'server s/GB':>12}")
    for name, row in rows.items():
        print(
            f"{name:<12} {row['bytes'] / 1e6:7.0f} {row['bytes_per_s'] / 1e6:8.1f} {row.get('over_dd', float('nan')):6.2f} "
            f"{row.get('server_processor_s_per_GB', float('nan')):12.2f}".replace("nan", "  –")
        )
    options.output.mkdir(parents=True, exist_ok=True)
    (options.output / "stream.json").write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    main()
