#!/usr/bin/env python3
"""Checks what the compiler does not: which folder may include what, and how long a file may be.

Prints one `file:line: error: …` per violation; exit code 1 if there is one.
"""

import re
import subprocess
import sys

MAXIMUM_LINES = {".h": 150, ".cpp": 400}

# Headers that only one place may include: pattern -> folders.
OWNERS = {
    r"(H5\w*|hdf5\w*)\.h$": ("solver/results/", "client/snapshot_file", "tests/"),
    r"sqlite3\.h$": ("server/store", "tests/"),
    r"\.pb\.h$|^(grpcpp|google/protobuf)/": ("proto/", "server/", "client/", "tests/"),
    r"^server/": ("server/", "tests/"),
    r"^client/": ("client/", "tests/"),
    r"^solver/": ("solver/", "server/", "tests/"),
    r"intrin\.h$": ("solver/transfers/intrinsics.h", "solver/executors/thread_pool.cpp", "proto/crc32c.h"),
    r"^muParser": ("solver/model/expression.cpp", "client/exact_histories.cpp"),
}

# What the solver's folders must not know of each other. Validation alone may ask which schemes and transfers
# there are and which time step they allow.
FORBIDDEN = {
    "solver/scene/": r"^solver/(?!scene/)",
    "solver/materials/": r"^solver/(?!materials/|scene/|executors/)",
    "solver/shapes/": r"^solver/(?!shapes/|scene/|executors/)",
    "solver/executors/": r"^solver/(?!executors/|scene/)",
    "solver/model/": r"^solver/(?!model/|scene/|executors/layout\.h|materials/material\.h|schemes/(scheme|time_step)\.h|transfers/transfer\.h)",
    "solver/surfaces/": r"^solver/(boundaries|loads|analyses|results|measures)/",
    "solver/boundaries/": r"^solver/(?!boundaries/|surfaces/|model/|scene/|executors/)",
    "solver/transfers/": r"^solver/(materials|boundaries|loads|model|simulation|analyses|results|measures)/",
    "solver/schemes/": r"^solver/(analyses|results|measures)/",
    "solver/implicit/": r"^solver/(analyses|results|measures)/",
    "solver/analyses/": r"^solver/(results|measures)/",
    "solver/accuracy/": r"^solver/(?!accuracy/)",
    "solver/measures/": r"^solver/(?!measures/|model/|recorder\.h)",
    "solver/results/": r"^solver/(?!results/|model/|scene/|recorder\.h)",
}

INCLUDE = re.compile(r'#include\s+["<]([^">]+)[">]')


def forbidden_includes(file, lines):
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        header = match.group(1)
        for pattern, folders in OWNERS.items():
            if re.search(pattern, header) and not file.startswith(folders):
                yield number, f"only {' and '.join(folders)} may include {header}"
        for folder, pattern in FORBIDDEN.items():
            if file.startswith(folder) and re.search(pattern, header):
                yield number, f"{folder} must not know {header}"


def violations(file):
    with open(file, encoding="utf-8") as source:
        lines = source.read().splitlines()
    yield from forbidden_includes(file, lines)
    maximum = MAXIMUM_LINES[file[file.rindex(".") :]]
    if len(lines) > maximum:
        yield len(lines), f"more than {maximum} lines: does it have one subject?"


def main():
    files = subprocess.run(["git", "ls-files", "*.h", "*.cpp"], check=True, capture_output=True, text=True)
    found = 0
    for file in files.stdout.split():
        for number, message in violations(file):
            print(f"{file}:{number}: error: {message}")
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
