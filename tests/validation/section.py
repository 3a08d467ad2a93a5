"""What a case puts into the report: rows, pictures and remarks."""

import pathlib
import string
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Places of scenes: templates of the validation's own, and the gallery's.
SCENES = (pathlib.Path(__file__).parent / "scenes", ROOT / "client" / "scenes")


def text_of(scene, values):
    """A scene's file, in which `values` stand for $name."""
    (file,) = [path for folder in SCENES for path in folder.glob(f"{scene}.textproto")][:1]
    return string.Template(file.read_text(encoding="utf-8")).substitute(values)


@dataclass
class Row:
    """A number: what the dissertation prints, what is true, what Trajan finds.

    Errors are shares of `scale`, by default of the true value. `goal` is the largest error allowed; a row without
    one is shown for comparison. `why` explains a row that misses its goal or is worse than the dissertation. `own`: at
    the dissertation's own resolution, or by other functions for about the cost of that; such a row has no goal.
    """

    what: str
    true: float
    source: str
    trajan: float
    settings: str
    core_seconds: float
    printed: float | None = None
    printed_reference: float | None = None
    goal: float | None = None
    scale: float | None = None
    why: str = ""
    own: bool = False

    def _error(self, value):
        return abs(value - self.true) / abs(self.true if self.scale is None else self.scale)

    @property
    def error(self):
        return self._error(self.trajan)

    @property
    def printed_error(self):
        """Of the dissertation's value against the same true one."""
        return None if self.printed is None else self._error(self.printed)

    @property
    def met(self):
        """Within the goal and nearer to the truth than the dissertation; None for a row without a goal."""
        if self.goal is None:
            return None
        return self.error <= self.goal and (self.printed is None or self.error < self.printed_error)


class Section:
    """A case under way: runs its scenes and collects what the report says of it."""

    def __init__(self, number, title, source, resolution, service, folder, quick):
        self.number, self.title, self.source = number, title, source
        self.resolution = resolution  # what the dissertation says of its cells and points
        self.quick = quick
        self.rows = []
        self.pictures = []  # (file name, caption)
        self.remarks = []
        self.tables = []  # (caption, headings, lines of text cells)
        self.failure = ""
        self.core_seconds = 0.0
        self._service, self._folder = service, folder

    def run(self, name, scene, **values):
        """The Result of a scene's file, in which `values` stand for $name."""
        result = self._service.run(f"{self.number:02}/{name}", text_of(scene, values))
        self.core_seconds += result.core_seconds
        print(f"  {name}: {result.core_seconds:.2f} core-seconds", flush=True)
        return result

    def sweep(self, name, path, settings, scene, **values):
        """The Results of a study on the server, one for each setting of the field with this path."""
        results = self._service.sweep(f"{self.number:02}/{name}", text_of(scene, values), path, settings)
        spent = sum(result.core_seconds for result in results)
        self.core_seconds += spent
        print(f"  {name}: {len(results)} runs, {spent:.2f} core-seconds", flush=True)
        return results

    def row(self, *arguments, **fields):
        self.rows.append(Row(*arguments, **fields))

    def remark(self, text):
        """A paragraph of Markdown."""
        self.remarks.append(" ".join(text.split()))

    def table(self, caption, headings, lines):
        """A table of text beside the rows."""
        self.tables.append((caption, headings, lines))

    def picture(self, name, figure, caption):
        """Keeps a matplotlib figure and closes it."""
        from matplotlib import pyplot

        file = f"{self.number:02}_{name}.png"
        figure.tight_layout()
        figure.savefig(self._folder / file, dpi=120)
        pyplot.close(figure)
        self.pictures.append((file, caption))

    @property
    def accounted_for(self):
        """All goals are met, or the report says why not."""
        return not self.failure and all(row.met is not False or row.why for row in self.rows)
