"""An open project with its survey and its result."""

import numpy as np

from lispac.adjustment.result import AdjustmentResult
from lispac.message_texts import message_text
from lispac.progress import Progress, no_progress
from lispac.project import Project, Triple
from lispac.workflow.project.survey import Survey, data_key, load_survey


class LoadedProject:
    """A project with its survey, which is read when it is first needed.

    Parameters
    ----------
    progress : callable
        Function that receives the progress of each step.
    """

    def __init__(
        self, project: Project, survey: Survey | None = None, *, progress: Progress = no_progress
    ) -> None:
        self.project = project
        self._survey = survey
        self._key = data_key(project)
        self._progress = progress

    def __repr__(self) -> str:
        targets = len(self.project.targets)
        return f"<lispac.{type(self).__name__} {self.project.name}: {targets} targets>"

    @property
    def survey(self) -> Survey:
        """Trajectory and lines, read on first access and after a change of data settings."""
        if self._survey is None or self._key != data_key(self.project):
            self._survey = load_survey(self.project, progress=self._progress)
            self._key = data_key(self.project)
        return self._survey

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes on assumptions and excluded data of the reading, as texts."""
        return tuple(map(message_text, self.survey.notes))

    @property
    def result(self) -> AdjustmentResult:
        """Result of the adjustment; angles in radians.

        Raises
        ------
        ProjectError
            If nothing has been estimated, or an edit has cleared the result since.
        """
        self.project.mounting("estimated")
        assert self.project.result is not None
        return self.project.result

    @property
    def boresight_deg(self) -> Triple:
        """Estimated roll, pitch, yaw in degrees."""
        roll, pitch, yaw = np.degrees(self.result.angles).tolist()
        return roll, pitch, yaw

    @property
    def sigma_deg(self) -> Triple:
        """Standard deviations of roll, pitch, yaw in degrees."""
        roll, pitch, yaw = np.degrees(self.result.sigma[:3]).tolist()
        return roll, pitch, yaw
