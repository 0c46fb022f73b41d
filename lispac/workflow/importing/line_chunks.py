"""Chunks of a line from its file, with its format and options."""

from collections.abc import Iterator
from dataclasses import dataclass

from lispac.io.format_types import Choice, FileFormat, PointChunk
from lispac.io.formats import format_of, is_las
from lispac.io.las.las_export import RecordLayout, layout_of_columns, layout_of_las
from lispac.io.point_reader_common import crs_of_options
from lispac.project import LineSource
from lispac.survey.crs import CoordinateSystem
from lispac.workflow.importing.line_points import read_chunks, screen_chunks


@dataclass(frozen=True, eq=False)
class LineChunks:
    """A line read chunk by chunk from its file.

    Attributes
    ----------
    line : LineSource
    format : FileFormat
    choice : mapping
        Complete reading options of the file.
    system : CoordinateSystem or None
        Coordinate system of a georeferenced cloud; None for points in the LiDAR frame.
    """

    line: LineSource
    format: FileFormat
    choice: Choice
    system: CoordinateSystem | None

    @classmethod
    def of(cls, line: LineSource) -> "LineChunks":
        """Open a line of a project with its reading options."""
        options = dict(line.reading.options)
        if line.reading.format:
            format = format_of(line.reading.format)
        elif is_las(line.path):
            format = format_of("las")
        else:
            format = format_of("text")
            options = {"columns": " ".join(name.strip().lower() for name in line.columns)}
        choice = format.complete_options(options)
        return cls(line, format, choice, crs_of_options(choice, line.path))

    def __iter__(self) -> Iterator[PointChunk]:
        chunks = read_chunks(self.format.read(self.line.path, self.choice))
        yield from screen_chunks(chunks, self.choice, self.line.path)

    def pattern(self, first: PointChunk) -> RecordLayout:
        """Layout of the records of a cloud of this line."""
        if self.format.key == "las" and self.line.path.exists():
            return layout_of_las(self.line.path)
        return layout_of_columns(first, standard_time=self.choice["time_base"] == "gps-adjusted")
