#!/usr/bin/env python3
"""Adds up the JUnit reports in a folder; the last line is `N passed, N failed[, N skipped]`.

A stage that left NAME.failed but no failed test in NAME.xml (it did not build, or died) counts as one failure. A shard
of a test program counts as the tests that its own report names, in NAME/tests/shards beside the folder.
"""

import sys
import xml.etree.ElementTree as xml
from pathlib import Path


def outcome(case):
    if case.find("failure") is not None or case.find("error") is not None:
        return "failed"
    skipped = case.find("skipped")
    if skipped is not None:
        return "skipped"
    # CTest: a test that could not be started has the status "notrun" or "fail".
    return "passed" if case.get("status", "run") == "run" else "failed"


def outcomes(case, shards):
    """Of a test (its name and outcome), or of the tests of a shard."""
    told = outcome(case)
    report = shards / f"{case.get('name')}.xml"
    if not report.exists():
        return [(case.get("name"), told)]
    tests = [(f"{test.get('classname')}.{test.get('name')}", outcome(test)) for test in xml.parse(report).iter("testcase")]
    # Whatever made the program fail besides its tests is a failure of its own: a leak, for example.
    if told == "failed" and all(result != "failed" for _, result in tests):
        tests.append((case.get("name"), "failed"))
    return tests


def main(folder):
    total = {"passed": 0, "failed": 0, "skipped": 0}
    for stage in sorted({path.stem for path in folder.iterdir()}):
        count = dict.fromkeys(total, 0)
        report = folder / f"{stage}.xml"
        if report.exists():
            shards = folder.parent / stage / "tests" / "shards"
            for case in xml.parse(report).iter("testcase"):
                for name, result in outcomes(case, shards):
                    count[result] += 1
                    if result == "failed":
                        print(f"FAILED {stage}: {name}")
        if (folder / f"{stage}.failed").exists() and not count["failed"]:
            print(f"FAILED {stage}: it did not build or did not finish")
            count["failed"] = 1
        print(f"{stage}: " + ", ".join(f"{number} {name}" for name, number in count.items()))
        for name, number in count.items():
            total[name] += number
    line = f"{total['passed']} passed, {total['failed']} failed"
    print(line + (f", {total['skipped']} skipped" if total["skipped"] else ""))
    return 1 if total["failed"] or not total["passed"] else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
