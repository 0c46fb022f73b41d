"""Preferences of the user for all projects, read and stored."""

from dataclasses import dataclass, replace
from pathlib import Path

from lispac.gui.app.point_colours import Scale
from lispac.gui.app.settings import DEFAULT_POINT_SIZE_PX, THEMES, AppSettings
from lispac.gui.viewport.decimation import Budget


@dataclass(frozen=True)
class Preferences:
    """Preferences with one value for each field of the settings dialogue.

    Attributes
    ----------
    language : code of the language; empty for that of the system
    point_size : size of a drawn point, pixels
    point_budget : largest number of points drawn at rest
    convention : key of the program in whose convention reports also give the boresight, or empty
    scanner, pos : names of the default sensors of new projects; empty for none
    angles, lengths : keys of the units shown
    cache : folder that contains the cache; None for the default folder of the system
    theme : one of `settings.THEMES`
    scale : colour scale of measured values at the points
    """

    language: str = ""
    point_size: int = DEFAULT_POINT_SIZE_PX
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
        scanner, pos = settings.default_sensors
        return cls(
            settings.chosen_language, settings.point_size, settings.point_budget,
            settings.report_choice().convention, scanner, pos, *settings.units,
            settings.cache_folder, settings.theme, settings.colour_scale,
        )  # fmt: skip

    def save(self, settings: AppSettings) -> None:
        """Store the preferences in the settings.

        Raises
        ------
        InputError
            If the folder of the cache cannot be used or its choice cannot be stored; all other
            preferences are stored.
        """
        settings.language = self.language
        settings.point_size = self.point_size
        settings.point_budget = self.point_budget
        choice = replace(settings.report_choice(), convention=self.convention)
        settings.save_report_choice(choice)
        settings.default_sensors = (self.scanner, self.pos)
        settings.units = (self.angles, self.lengths)
        settings.theme, settings.colour_scale = self.theme, self.scale
        settings.sync()
        settings.cache_folder = self.cache
