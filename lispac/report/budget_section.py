"""The tables of the error budget of a point at a distance."""

from lispac.report.blocks import Block, Bullets, Column, Paragraph, Table, rows
from lispac.report.budget_values import BeamErrors, Budget, ErrorSource
from lispac.report.wording import UNKNOWN


def budget_blocks(found: Budget) -> list[Block]:
    """A table for each direction of the beam, and what they rest on."""
    blocks: list[Block] = [_table(found, beam) for beam in found.beams]
    return [*blocks, Paragraph("What the error budget rests on:"), Bullets(found.in_words)]


def _table(found: Budget, beam: BeamErrors) -> Table:
    columns = (
        Column("Source", "left"),
        *(
            Column(f"{name}\nat {distance:g} m")
            for distance in found.distances_m
            for name in ("Horizontal", "Vertical", "Across")
        ),
    )
    return Table(
        f"Error of a point, 1 sigma, beam {beam.beam} (cm)",
        columns,
        rows(
            [each.source, *_cells(each, len(found.distances_m))]
            for each in (*beam.sources, beam.before, beam.after)
        ),
    )


def _cells(each: ErrorSource, distances: int) -> list[str]:
    if each.at_distance is None:
        return [UNKNOWN] * (3 * distances)
    return [
        f"{100 * value:.2f}"
        for e in each.at_distance
        for value in (e.horizontal_m, e.vertical_m, e.across_beam_m)
    ]
