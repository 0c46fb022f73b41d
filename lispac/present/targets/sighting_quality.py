"""Quality of the sightings, as values and table."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from lispac.geometry.frames import east_north_up
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.picked_targets import Target
from lispac.present.angles import floats
from lispac.present.tables import COUNT, MILLIMETRES, PERCENT, Column, Format, Table
from lispac.targets.sighting_quality import SightingQuality

RATING_TEXTS: Mapping[str, str] = {
    "good": N_("Good."),
    "doubtful": N_("Doubtful."),
    "poor": N_("Poor."),
}


RANGE_METRES = Format("m", 1)
"""Format of ranges and distances to the trajectory."""
EXTENT_METRES = Format("m", 2)
"""Format of the width and height of a surface."""


@dataclass(frozen=True)
class SightingQualityValues:
    """Quality of a sighting; None if a value does not apply or is not known.

    ``boresight_error_rms_m`` is the part of the RMS that an error of the boresight can explain;
    curvature and roughness are rated without it.
    """

    target: str
    line: str
    rating: str
    reasons: tuple[Message, ...]
    points: int
    rms_m: float
    range_m: float
    density_per_m2: float | None
    incidence_deg: float | None
    coverage: float
    visible_share: float | None = None
    extent_m: tuple[float, ...] | None = None
    curvature_m: float | None = None
    roughness_m: float | None = None
    boresight_error_rms_m: float | None = None
    edited_by_hand: bool = False


def sighting_quality_values(
    target: str, line: str, quality: SightingQuality, *, edited_by_hand: bool = False
) -> SightingQualityValues:
    """Quality of one sighting as values."""
    incidence = quality.incidence
    return SightingQualityValues(
        target=target,
        line=line,
        rating=quality.rating,
        reasons=quality.reasons,
        points=quality.points,
        rms_m=quality.rms,
        range_m=quality.range,
        density_per_m2=quality.density,
        incidence_deg=None if incidence is None else float(np.degrees(incidence)),
        coverage=quality.coverage,
        visible_share=quality.visible_share,
        extent_m=None if quality.extent is None else floats(quality.extent),
        curvature_m=quality.curvature,
        roughness_m=quality.roughness,
        boresight_error_rms_m=quality.smear,
        edited_by_hand=edited_by_hand,
    )


def quality_list(
    qualities: Mapping[tuple[str, str], SightingQuality], targets: Iterable[Target]
) -> tuple[SightingQualityValues, ...]:
    """Qualities of the sightings of targets as rows; they are given by target and line."""
    edited = {(t.name, s.line) for t in targets for s in t.sightings if s.by_hand}
    return tuple(
        sighting_quality_values(*key, each, edited_by_hand=key in edited)
        for key, each in qualities.items()
    )


def rating_text(quality: SightingQualityValues) -> str:
    """Rating with its reasons, in the language in use."""
    edited = [gettext("The points of this sighting were edited manually.")]
    return " ".join(
        [
            gettext(RATING_TEXTS[quality.rating]),
            *map(message_text, quality.reasons),
            *(edited if quality.edited_by_hand else ()),
        ]
    )


@dataclass(frozen=True)
class PickedSightingValues:
    """Points of a target in one line, and the RMS distance from the surface.

    The last three values are those of a sphere; ``centre_m`` is north, west, up from the origin of
    the local frame, ``visible_share`` the share of the surface that the line has seen.
    """

    points: int
    rms_m: float
    quality: SightingQualityValues
    centre_m: tuple[float, ...] | None = None
    sphere_radius_m: float | None = None
    visible_share: float | None = None

    def coordinate(self, axis: int) -> float | None:
        """East, north or up of the centre of a sphere, metres; None for a plane."""
        return None if self.centre_m is None else float(east_north_up(self.centre_m)[axis])


PICKED_SIGHTINGS_TABLE = Table[PickedSightingValues](
    "Sightings",
    (
        Column("quality.target", "Target"),
        Column("quality.line", "Line"),
        Column("points", "Points", COUNT),
        Column("rms_m", "RMS", MILLIMETRES),
        Column("quality.rating", "Quality"),
    ),
)
"""Table of the command line; the window shows the sightings as a tree."""
CENTRE_METRES = Format("m", 3, is_grouped=False)
PICKED_SPHERES_TABLE = Table[PickedSightingValues](
    "",
    (
        Column("quality.line", "Line"),
        Column(lambda row: row.coordinate(0), "East", CENTRE_METRES),
        Column(lambda row: row.coordinate(1), "North", CENTRE_METRES),
        Column(lambda row: row.coordinate(2), "Up", CENTRE_METRES),
        Column("sphere_radius_m", "Radius", CENTRE_METRES),
        Column("visible_share", "Surface seen", PERCENT, has_unit_in_cells=True),
    ),
)
QUALITY_TABLE = Table[SightingQualityValues](
    N_("Quality of each sighting of targets and validation planes"),
    (
        Column("target", N_("Target")),
        Column("line", N_("Line")),
        Column("points", N_("Points\nfound"), COUNT),
        Column("rms_m", N_("RMS"), MILLIMETRES),
        Column("range_m", N_("Range"), RANGE_METRES),
        Column("density_per_m2", N_("Points\nper m²"), COUNT),
        Column("incidence_deg", N_("Incidence"), Format("deg", 0)),
        Column("coverage", N_("Coverage"), PERCENT),
        Column("visible_share", N_("Extent\nobserved"), PERCENT),
        Column(rating_text, N_("Quality"), is_wide=True),
    ),
)
