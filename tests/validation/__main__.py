"""Runs cases of the dissertation through a server of its own and writes the report.

Exit code: 0 if every row meets its goal or says why not, 1 if one does not or a case failed.
"""

import argparse
import pathlib
import sys
import traceback

from validation import report
from validation.cases import CASES, load
from validation.publish import publish
from validation.section import Section
from validation.service import Service

ROOT = pathlib.Path(__file__).resolve().parents[2]


def arguments():
    parser = argparse.ArgumentParser(prog="./dev validate", description=__doc__)
    names = ", ".join(f"{number} {name}" for number, name in CASES.items())
    parser.add_argument("cases", nargs="*", metavar="CASE", help=f"a number or name; default all: {names}")
    parser.add_argument("--quick", action="store_true", help="only what takes a minute in all")
    parser.add_argument("--reuse", action="store_true", help="keep the results of scenes that have not changed")
    parser.add_argument("--publish", action="store_true", help="of all cases: the page in tests/validation, the README's table")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release/bin", help="where trajan is")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build/validation", help="where the report goes")
    chosen = parser.parse_args()
    known = {str(number): number for number in CASES} | {name: number for number, name in CASES.items()}
    unknown = [case for case in chosen.cases if case not in known]
    if unknown:
        parser.error(f"there is no case {', '.join(unknown)}; cases are {names}")
    if chosen.publish and (chosen.cases or chosen.quick):
        parser.error("--publish is of all cases, whole")
    chosen.numbers = sorted({known[case] for case in chosen.cases} or CASES)
    return chosen


def run(number, service, chosen):
    module = load(number)
    section = Section(number, module.TITLE, module.SOURCE, module.RESOLUTION, service, chosen.folder, chosen.quick)
    print(f"case {number}: {module.TITLE}", flush=True)
    try:
        module.run(section)
    except Exception:  # one case must not take the others with it
        section.failure = traceback.format_exc()
        print(section.failure, file=sys.stderr)
    return section


def main():
    chosen = arguments()
    chosen.folder.mkdir(parents=True, exist_ok=True)
    with Service(chosen.programs, chosen.folder, chosen.reuse) as service:
        sections = [run(number, service, chosen) for number in chosen.numbers]
    report.write(sections, chosen.folder)
    if chosen.publish:
        publish(sections, chosen.folder, ROOT)
    print(report.verdict(sections))
    print(f"report: {chosen.folder / 'report.md'}")
    return 0 if all(section.accounted_for for section in sections) else 1


if __name__ == "__main__":
    sys.exit(main())
