"""Fields of the standard deviations of the POS."""

import numpy as np

from lispac.adjustment.model.stochastic_model import (
    ASSUMED_ATTITUDE_SIGMA_DEG,
    ASSUMED_POSITION_SIGMA,
)
from lispac.gui.widgets import TripleField, number
from lispac.language import N_, gettext
from lispac.project import Triple
from lispac.survey.trajectory import TrajectoryAccuracy


class PosSigmaFields:
    """Fields of the standard deviations of position (metres) and attitude (degrees)."""

    def __init__(self, prefix: str) -> None:
        self.position = _triple(prefix, " m", 100, _POSITION_TEXTS)
        self.attitude = _triple(prefix, " °", 90, _ATTITUDE_TEXTS)

    def set_enabled(self, is_enabled: bool) -> None:
        """Enable or disable all fields."""
        self.position.setEnabled(is_enabled)
        self.attitude.setEnabled(is_enabled)

    def values(self) -> tuple[Triple | None, Triple | None]:
        """Standard deviations of position and attitude; None for those that nobody gave."""
        position, attitude = (
            None if field.is_assumed else field.value() for field in (self.position, self.attitude)
        )
        return position, attitude

    def show_values(self, position: Triple | None, attitude_deg: Triple | None) -> None:
        """Show given standard deviations, or the assumed ones for None."""
        for field, given, assumed in (
            (self.position, position, ASSUMED_POSITION_SIGMA),
            (self.attitude, attitude_deg, ASSUMED_ATTITUDE_SIGMA_DEG),
        ):
            if given is None:
                field.show_assumed(assumed)
            else:
                field.set_value(given)

    def show_medians(self, accuracy: TrajectoryAccuracy) -> None:
        """Show the medians of the standard deviations of an accuracy file."""
        self.position.set_value(np.median(accuracy.position, axis=0).tolist())
        self.attitude.set_value(np.degrees(np.median(accuracy.attitude, axis=0)).tolist())


_POSITION_TEXTS = (
    ("n", N_("North"), N_("Position sigma, north"),
     N_("Standard deviation of the north position, metres")),
    ("e", N_("East"), N_("Position sigma, east"),
     N_("Standard deviation of the east position, metres")),
    ("d", N_("Down"), N_("Position sigma, down"), N_("Standard deviation of the height, metres")),
)  # fmt: skip
_ATTITUDE_TEXTS = (
    ("roll", N_("Roll"), N_("Roll sigma"), N_("Standard deviation of roll, degrees")),
    ("pitch", N_("Pitch"), N_("Pitch sigma"), N_("Standard deviation of pitch, degrees")),
    ("heading", N_("Heading"), N_("Heading sigma"),
     N_("Standard deviation of the heading, degrees")),
)  # fmt: skip
"""Last part of the field's name, its title, its name in messages, and its tip."""


def _triple(
    prefix: str, suffix: str, high: float, texts: tuple[tuple[str, str, str, str], ...]
) -> TripleField:
    """Three fields of a standard deviation with the unit ``suffix``, from 0 to ``high``."""
    return TripleField(
        [gettext(title) for _, title, _, _ in texts],
        [
            number(
                f"{prefix}_{axis}", suffix=suffix, decimals=4, low=0, high=high, step=0.001,
                title=gettext(name), tip=gettext(tip),
            )
            for axis, _, name, tip in texts
        ],
    )  # fmt: skip
