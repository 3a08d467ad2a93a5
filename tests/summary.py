#!/usr/bin/env python3
"""Adds up the JUnit reports in a folder; the last line is `N passed, N failed[, N skipped]`.

A stage that left NAME.failed but no failed test in NAME.xml (it did not build, or died) counts as one failure.
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


def main(folder):
    total = {"passed": 0, "failed": 0, "skipped": 0}
    for stage in sorted({path.stem for path in folder.iterdir()}):
        count = dict.fromkeys(total, 0)
        report = folder / f"{stage}.xml"
        if report.exists():
            for case in xml.parse(report).iter("testcase"):
                result = outcome(case)
                count[result] += 1
                if result == "failed":
                    print(f"FAILED {stage}: {case.get('name')}")
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
