"""A line chunk by chunk from its file, with how it is read."""

from collections.abc import Iterator
from dataclasses import dataclass

from lispac.io.formats import format_of, is_las
from lispac.io.las_export import Pattern, pattern_of_columns, pattern_of_las
from lispac.io.points import system_of
from lispac.io.registry import Choice, Format, PointChunk
from lispac.project import LineSource
from lispac.survey.crs import CoordinateSystem
from lispac.workflow.line_points import read_chunks, screened


@dataclass(frozen=True, eq=False)
class Chunks:
    """A line as it comes in, chunk by chunk, from its file.

    Attributes
    ----------
    line : LineSource
    format : Format
    choice : mapping
        Complete reading options of the file.
    system : CoordinateSystem or None
        Of a cloud that is georeferenced already; None for points in the LiDAR frame.
    """

    line: LineSource
    format: Format
    choice: Choice
    system: CoordinateSystem | None

    @classmethod
    def of(cls, line: LineSource) -> "Chunks":
        """How a line of a project is read."""
        given = dict(line.reading.options)
        if line.reading.format:
            format = format_of(line.reading.format)
        elif is_las(line.path):
            format = format_of("las")
        else:
            format = format_of("text")
            given = {"columns": " ".join(name.strip().lower() for name in line.columns)}
        choice = format.settled(given)
        return cls(line, format, choice, system_of(choice, line.path))

    def __iter__(self) -> Iterator[PointChunk]:
        chunks = read_chunks(self.format.read(self.line.path, self.choice))
        yield from screened(chunks, self.choice, self.line.path)

    def pattern(self, first: PointChunk) -> Pattern:
        """Layout of the records of its cloud."""
        if self.format.key == "las" and self.line.path.exists():
            return pattern_of_las(self.line.path)
        return pattern_of_columns(first, standard_time=self.choice["time_base"] == "gps-adjusted")
