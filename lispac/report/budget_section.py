"""The tables of the error budget of a point at a distance."""

from lispac.language import gettext
from lispac.message_texts import message_text
from lispac.present.error_budget import BeamErrors, ErrorBudgetValues, ErrorSource
from lispac.present.text_format import UNKNOWN, centimetres, shortest_number
from lispac.report.document_blocks import Block, Bullets, Column, Paragraph, Table, as_rows


def budget_blocks(budget: ErrorBudgetValues) -> list[Block]:
    """A table for each direction of the beam, and the assumptions."""
    blocks: list[Block] = [_beam_table(budget, beam) for beam in budget.beams]
    return [
        *blocks,
        Paragraph(gettext("Assumptions of the error budget:")),
        Bullets(tuple(map(message_text, budget.messages))),
    ]


def _beam_table(budget: ErrorBudgetValues, beam: BeamErrors) -> Table:
    components = (gettext("Horizontal"), gettext("Vertical"), gettext("Across\nbeam"))
    distances = [
        gettext("at {distance} m", distance=shortest_number(d)) for d in budget.distances_m
    ]
    columns = (
        Column(gettext("Source"), "left"),
        *(Column(f"{name}\n{distance}") for distance in distances for name in components),
    )
    return Table(
        gettext("Error of a point, 1 sigma (cm); beam {beam}", beam=beam.beam),
        columns,
        as_rows(
            [str(each.source), *_source_cells(each, len(budget.distances_m))]
            for each in (*beam.sources, beam.before, beam.after)
        ),
    )


def _source_cells(each: ErrorSource, distances: int) -> list[str]:
    if each.at_distance is None:
        return [UNKNOWN] * (3 * distances)
    return [
        centimetres(value)
        for error in each.at_distance
        for value in (error.horizontal_m, error.vertical_m, error.across_beam_m)
    ]
