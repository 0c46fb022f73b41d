"""All dialogues of the window in one class, which tests replace."""

from lispac.gui.features.design.dialogs import DesignDialogs
from lispac.gui.features.export.dialogs import ExportDialogs
from lispac.gui.features.help.dialogs import HelpDialogs
from lispac.gui.features.inspect.dialogs import PictureDialogs
from lispac.gui.features.open_project.dialogs import ProjectDialogs
from lispac.gui.features.pick_targets.dialogs import TargetDialogs
from lispac.gui.features.preferences.dialogs import PreferenceDialogs
from lispac.gui.features.report.dialogs import ReportDialogs
from lispac.gui.features.studies.dialogs import StudyDialogs


class Dialogs(
    ProjectDialogs,
    TargetDialogs,
    StudyDialogs,
    DesignDialogs,
    ReportDialogs,
    ExportDialogs,
    PictureDialogs,
    PreferenceDialogs,
    HelpDialogs,
):
    """Shows the dialogues and returns the answers of the user."""
