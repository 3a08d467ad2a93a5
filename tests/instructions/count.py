#!/usr/bin/env python3
"""Counts instructions of steps by callgrind and holds them to budgets.

    count.py PROGRAM [--print]

PROGRAM is `count_instructions`. All counts are per particle and step, in implicit analyses per Newton's iteration, on
one thread, of kernels for x86-64-v3 and of all else by -O1, as GCC 12 compiles them. What libraries do is left out of
iterations: factorizations choose their loops by the processor. Counts differ by less than 0.05 % from run to run.
--print shows them and holds nothing.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

# Of some 2000 particles: 2 % over what was counted when the budget was last set. Who makes steps cheaper lowers it.
BUDGETS = {
    "discs/MUSL": 376,
    "discs/MUSL/float": 340,
    "discs/MUSL/turned": 488,
    "discs/USL": 324,
    "discs/MUSL/neo_hookean": 374,
    "discs/MUSL/contact": 405,
    "discs/MUSL/gimp": 546,
    "discs/MUSL/quadratic_bspline": 512,
    "discs/MUSL/quadratic_bspline/float": 460,
    "discs/MUSL/quadratic_bspline/APIC": 596,
    "discs/MUSL/quadratic_bspline/APIC/float": 522,
    "discs/MUSL/cubic_bspline": 644,
    "bar/TLMPM": 239,
    "bar/TLMPM/neo_hookean": 226,
    "bar/TLMPM/neo_hookean/loaded": 231,
    "bar/TLMPM/neo_hookean/float": 120,
    "bar/TLMPM/quadratic_bspline": 407,
    "block/MUSL": 467,
    "block/MUSL/drifting": 700,
    "block/MUSL/float": 329,
    "block/TLMPM/neo_hookean": 433,
    "block/TLMPM/neo_hookean/loaded": 455,
    "block/TLMPM/neo_hookean/float": 311,
    "block/MUSL/quadratic_bspline": 1376,
    "block/MUSL/quadratic_bspline/float": 1076,
    "block/MUSL/quadratic_bspline/APIC": 1608,
    "block/MUSL/cubic_bspline": 2042,
    "column/TLMPM/damage": 470,
    "column/MUSL/damage": 458,
    "bar/implicit_static": 7004,
    "bar/implicit_dynamic": 11023,
}

# (what, more than what, by at most this share of it, why)
SHARES = [
    ("unused/law", "unused/nothing", 0.005, "a law that no body has"),
    ("unused/wall", "unused/nothing", 0.005, "a condition on nodes that no body reaches"),
    ("unused/probe", "unused/nothing", 0.005, "a probe between samples"),
    ("unused/plane", "unused/nothing", 0.005, "a rigid plane that no body reaches"),
    # It is used, by the nodes of nine tiles, of which 8000 particles do not have many; and with it nodes are updated
    # after all particles.
    ("unused/force", "unused/nothing", 0.017, "a force on one particle"),
    ("domain/far", "domain/near", 0.01, "a domain a million times larger than the bodies"),
    ("outputs/probes", "outputs/samples", 0.01, "two probes with a sample every ten steps"),
    # At a sample velocities catch up with positions: less than another step.
    ("outputs/samples", "outputs/none", 0.08, "a sample every ten steps"),
]

# What a snapshot every ten steps adds, in instructions per particle and step: no share, for steps may become cheaper.
# It is what is collected for it; another thread stores it, which would add as much as the steps themselves.
SNAPSHOTS = 143


def function_of(line):
    """The bare name in a line such as fn=void trajan::x86_64_v3::locate<...>(trajan::Block&)."""
    name = line[3:].replace("(anonymous namespace)", "").split(" [")[0]
    for brackets in (r"<[^<>]*>", r"\([^()]*\)", r"\{[^{}]*\}"):
        while re.search(brackets, name):
            name = re.sub(brackets, "", name)
    words = [word for word in re.split(r"::| ", name) if word not in ("", "const", "operator")]
    return words[-1] if words else "others"


def instructions_of(dump, program):
    """{function: its instructions, those that it calls not included}; program: of functions in this file alone."""
    own, function, file, is_of_called = {}, "", "", False
    for line in dump.splitlines():
        if line.startswith("ob="):
            file = line[3:]
        elif line.startswith("fn="):
            function = function_of(line)
        elif line.startswith("calls="):
            is_of_called = True
        elif re.match(r"[-+*0-9]", line):
            if not is_of_called and file.startswith(program):
                own[function] = own.get(function, 0) + int(line.split()[1])
            is_of_called = False
    return own


def count(program):
    """{name: (instructions per particle and step, bytes of the solver, profile)}"""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "count"
        words = ["valgrind", "--tool=callgrind", "--compress-strings=no"]
        words += ["--toggle-collect=counted_steps", "--dump-after=counted_steps"]
        done = subprocess.run(
            [*words, f"--callgrind-out-file={out}", program], capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            sys.exit(done.stderr)
        counts = {}
        for number, line in enumerate(done.stdout.splitlines(), start=1):
            name, particles, steps, memory = line.split()
            dump = out.with_name(f"count.{number}").read_text()
            own = instructions_of(dump, str(pathlib.Path(program).resolve()) if "/implicit_" in name else "")
            total = sum(own.values())
            profile = {function: cost / total for function, cost in sorted(own.items(), key=lambda item: -item[1])}
            counts[name] = (total / int(particles) / int(steps), int(memory), profile)
    return counts


def largest(profile):
    return ", ".join(f"{function} {100 * share:.0f}" for function, share in list(profile.items())[:8])


def violations(counts):
    for name, budget in BUDGETS.items():
        if counts[name][0] > budget:
            yield f"{name}: {counts[name][0]:.1f} instructions per particle and step, budget {budget}"
    for name, plain, share, what in SHARES:
        more = counts[name][0] / counts[plain][0] - 1
        if more > share:
            yield f"{what} costs {100 * more:.2f} %, at most {100 * share} % ({name} over {plain})"
    snapshots = counts["outputs/snapshots"][0] - counts["outputs/samples"][0]
    if snapshots > SNAPSHOTS:
        yield f"snapshots cost {snapshots:.1f} instructions per particle and step, budget {SNAPSHOTS}"
    if counts["domain/far"][1] != counts["domain/near"][1]:
        yield "a larger domain takes more memory"


def main():
    counts = count(sys.argv[1])
    for name, (instructions, memory, profile) in counts.items():
        print(f"{name:<36} {instructions:9.2f} instructions, {memory} bytes; in %: {largest(profile)}")
    if "--print" in sys.argv:
        return 0
    found = list(violations(counts))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
