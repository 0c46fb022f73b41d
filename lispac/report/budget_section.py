"""The tables of the error budget of a point at a distance."""

from lispac.language import gettext
from lispac.message_texts import message_text
from lispac.report.blocks import Block, Bullets, Column, Paragraph, Table, rows
from lispac.report.budget_values import BeamErrors, Budget, ErrorSource
from lispac.report.wording import UNKNOWN, cm, shortest


def budget_blocks(found: Budget) -> list[Block]:
    """A table for each direction of the beam, and the assumptions."""
    blocks: list[Block] = [_table(found, beam) for beam in found.beams]
    return [
        *blocks,
        Paragraph(gettext("Assumptions of the error budget:")),
        Bullets(tuple(map(message_text, found.in_words))),
    ]


def _table(found: Budget, beam: BeamErrors) -> Table:
    components = (gettext("Horizontal"), gettext("Vertical"), gettext("Across\nbeam"))
    distances = [gettext("at {distance} m", distance=shortest(d)) for d in found.distances_m]
    columns = (
        Column(gettext("Source"), "left"),
        *(Column(f"{name}\n{distance}") for distance in distances for name in components),
    )
    return Table(
        gettext("Error of a point, 1 sigma (cm); beam {beam}", beam=beam.beam),
        columns,
        rows(
            [str(each.source), *_cells(each, len(found.distances_m))]
            for each in (*beam.sources, beam.before, beam.after)
        ),
    )


def _cells(each: ErrorSource, distances: int) -> list[str]:
    if each.at_distance is None:
        return [UNKNOWN] * (3 * distances)
    return [
        cm(value)
        for error in each.at_distance
        for value in (error.horizontal_m, error.vertical_m, error.across_beam_m)
    ]
