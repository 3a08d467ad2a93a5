"""What counts as a goal that is met, and that the report says all there is to say."""

import json
import pathlib
import tempfile
import unittest

from validation import publish, report
from validation.section import Row, Section


def row(**changes):
    return Row(**{"what": "w", "true": 2.0, "source": "s", "trajan": 2.001, "settings": "x", "core_seconds": 1.0} | changes)


class Rows(unittest.TestCase):
    def test_errors_are_shares_of_the_true_value_or_of_a_scale(self):
        self.assertAlmostEqual(row().error, 0.0005)
        self.assertAlmostEqual(row(true=0.0, trajan=0.3, scale=10.0).error, 0.03)

    def test_a_goal_wants_the_error_and_to_be_nearer_than_the_dissertation(self):
        self.assertIsNone(row().met)
        self.assertTrue(row(goal=1e-3).met)
        self.assertFalse(row(goal=1e-4).met)
        self.assertTrue(row(goal=1e-3, printed=2.002).met)
        self.assertFalse(row(goal=1e-3, printed=2.0001).met)

    def test_what_is_not_a_number_meets_no_goal(self):
        self.assertFalse(row(goal=1e-3, trajan=float("nan")).met)


class Sections(unittest.TestCase):
    def section(self, *rows):
        section = Section(1, "title", "source", "4 cells", None, None, False)
        section.rows = list(rows)
        return section

    def test_a_miss_must_have_a_reason(self):
        self.assertFalse(self.section(row(goal=1e-9)).accounted_for)
        self.assertTrue(self.section(row(goal=1e-9, why="of course")).accounted_for)

    def test_a_failure_is_told(self):
        section = self.section()
        section.failure = "boom"
        self.assertFalse(section.accounted_for)
        self.assertIn("boom", report.markdown([section]))
        self.assertIn("failed: case 1", report.verdict([section]))

    def test_the_report_has_all_rows_reasons_and_tables(self):
        section = self.section(
            row(what="good", goal=1e-2), row(what="bad", goal=1e-9, why="of course"), row(what="other"),
            row(what="theirs", own=True),
        )
        section.table("numbers:", ["a", "b"], [["1", "2"]])
        with tempfile.TemporaryDirectory() as folder:
            report.write([section], pathlib.Path(folder))
            text = (pathlib.Path(folder) / "report.md").read_text(encoding="utf-8")
            data = json.loads((pathlib.Path(folder) / "report.json").read_text(encoding="utf-8"))
        expected = "1 of 2 goals met", "| good |", "| bad |", "| other |", "| theirs |", "of course", "4 cells", "| 1 | 2 |"
        for part in expected:
            self.assertIn(part, text)
        self.assertEqual([one["met"] for one in data[0]["rows"]], [True, False, None, None])

    def test_the_summary_takes_the_place_between_the_marks(self):
        section = self.section(row(goal=1e-2, printed=2.5), row(goal=1e-9, trajan=2.002), row(trajan=9.0))
        once = publish.with_summary(f"before\n\n{publish.BEGIN}\nold\n{publish.END}\n\nafter\n", [section])
        self.assertTrue(once.startswith("before\n") and once.endswith(f"{publish.END}\n\nafter\n"))
        self.assertIn("| 1 title: source | 1 of 2 | 0.1 % (1e-07 %); 0.05 % (1 %) | 25 % | 0.0 |", once)
        self.assertNotIn("old", once)
        self.assertEqual(publish.with_summary(once, [section]), once)


if __name__ == "__main__":
    unittest.main()
