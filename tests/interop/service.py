"""A client of the service that shares no code with the product: stubs from the published schema, Python's gRPC."""

import pathlib
import subprocess
import sys

import grpc

ROOT = pathlib.Path(__file__).resolve().parents[2]


def generate_stubs(folder):
    """Compiles proto/ for Python into `folder` and makes it importable."""
    schemas = [str(path) for path in sorted((ROOT / "proto").glob("trajan/v1/*.proto"))]
    plugin = subprocess.run(["which", "grpc_python_plugin"], check=True, capture_output=True, text=True).stdout.strip()
    subprocess.run(
        ["protoc", "-I", str(ROOT / "proto"), f"--python_out={folder}", f"--grpc_out={folder}",
         f"--plugin=protoc-gen-grpc={plugin}", *schemas],
        check=True)
    sys.path.insert(0, str(folder))


def error_details(error):
    """The ErrorDetails that a failed call carries."""
    from trajan.v1 import jobs_pb2
    metadata = dict(error.trailing_metadata())
    return jobs_pb2.ErrorDetails.FromString(metadata["trajan-error-bin"])


def wait_until_ready(address, process, seconds=30):
    """A channel to a server that has just been started; fails at once if the server ended."""
    channel = grpc.insecure_channel(address)
    ready = grpc.channel_ready_future(channel)
    for _ in range(10 * seconds):
        try:
            ready.result(timeout=0.1)
            return channel
        except grpc.FutureTimeoutError:
            assert process.poll() is None, f"the server ended with {process.returncode}"
    raise AssertionError(f"the server does not answer at {address}")


def crc32c(data):
    """CRC-32C (Castagnoli), reflected polynomial 0x82f63b78, as in RFC 3720 appendix B.4."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc = _CRC_TABLE[(crc ^ byte) & 0xFF] ^ (crc >> 8)
    return crc ^ 0xFFFFFFFF


def _crc_table_entry(byte):
    for _ in range(8):
        byte = (byte >> 1) ^ (0x82F63B78 if byte & 1 else 0)
    return byte


_CRC_TABLE = [_crc_table_entry(byte) for byte in range(256)]
