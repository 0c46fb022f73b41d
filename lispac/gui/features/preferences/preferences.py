"""Preferences of the user for all projects, read and stored."""

from dataclasses import dataclass
from pathlib import Path

from lispac.gui.app.point_colours import Scale
from lispac.gui.app.settings import POINT_SIZE, THEMES, AppSettings
from lispac.gui.viewport.decimation import Budget


@dataclass(frozen=True)
class Preferences:
    """Preferences with one value for each field of the settings dialogue.

    Attributes
    ----------
    language : code, empty for that of the system
    point_size : pixels
    point_budget : points drawn at rest, at most
    convention : key of the system that reports state the boresight for too; empty for none
    scanner, pos : names in the sensor library that new projects begin with; empty for none
    angles, lengths : keys of the units shown
    cache : folder that the cache lies in; None for the system's
    theme : one of `settings.THEMES`
    scale : of the colours of what is measured at the points
    """

    language: str = ""
    point_size: int = POINT_SIZE
    point_budget: int = Budget().resting
    convention: str = ""
    scanner: str = ""
    pos: str = ""
    angles: str = "degrees"
    lengths: str = "metres"
    cache: Path | None = None
    theme: str = THEMES[0]
    scale: Scale = "viridis"

    @classmethod
    def of(cls, settings: AppSettings) -> "Preferences":
        """Read the preferences from the settings."""
        scanner, pos = settings.usual_sensors
        return cls(
            settings.language_chosen, settings.point_size, settings.point_budget,
            settings.report_choice()[2], scanner, pos, *settings.units,
            settings.cache_folder, settings.theme, settings.colour_scale,
        )  # fmt: skip

    def save(self, settings: AppSettings) -> None:
        """Store the preferences in the settings.

        Raises
        ------
        InputError
            Where the cache cannot be where it is wanted, or the choice of it not be written; all
            else is kept.
        """
        settings.language = self.language
        settings.point_size = self.point_size
        settings.point_budget = self.point_budget
        template, page, _, language = settings.report_choice()
        settings.save_report_choice((template, page, self.convention, language))
        settings.usual_sensors = (self.scanner, self.pos)
        settings.units = (self.angles, self.lengths)
        settings.theme, settings.colour_scale = self.theme, self.scale
        settings.sync()
        settings.cache_folder = self.cache
