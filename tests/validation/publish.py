"""The report of all cases as a page of the project, and its summary in the project's README."""

import shutil

from validation import report

HEADINGS = ("case", "goals met", "largest error and its goal", "the dissertation's", "core-seconds")
BEGIN = "<!-- Written by ./dev validate --publish; do not edit. -->"
END = "<!-- end -->"


def largest_errors(rows):
    """Of the rows of each goal: "0.071 % (0.1 %); 0.34 % (1 %)"."""
    goals = sorted({row.goal for row in rows})
    largest = {goal: max(row.error for row in rows if row.goal == goal) for goal in goals}
    return "; ".join(f"{report.percent(error)} ({report.percent(goal)})" for goal, error in largest.items())


def summary(sections):
    """A line of each case."""
    lines = []
    for section in sections:
        rows = [row for row in section.rows if row.goal is not None]
        printed = [row.printed_error for row in rows if row.printed is not None]
        lines.append((
            f"{section.number} {section.title}: {section.source}", f"{sum(row.met for row in rows)} of {len(rows)}",
            largest_errors(rows), report.percent(max(printed)) if printed else "no numbers",
            f"{section.core_seconds:.0f}" if section.core_seconds >= 1 else f"{section.core_seconds:.1f}",
        ))
    return report.markdown_table(HEADINGS, lines)


def with_summary(readme, sections):
    """The text of a README whose lines between the two marks are the summary."""
    before, _, rest = readme.partition(BEGIN)
    _, _, after = rest.partition(END)
    return "\n".join([before + BEGIN, "", *summary(sections), "", END]) + after


def publish(sections, folder, project):
    """Copies the report and its pictures from the folder, and writes the summary."""
    page = project / "tests/validation/report"
    shutil.rmtree(page, ignore_errors=True)
    page.mkdir()
    shutil.copy(folder / "report.md", page / "README.md")
    for section in sections:
        for picture, _ in section.pictures:
            shutil.copy(folder / picture, page)
    readme = project / "README.md"
    readme.write_text(with_summary(readme.read_text(encoding="utf-8"), sections), encoding="utf-8")
