"""The features of the window."""

from lispac.gui.features.control import feature as control
from lispac.gui.features.conventions import feature as conventions
from lispac.gui.features.design import actions as design
from lispac.gui.features.design.dialogs import DesignDialogs
from lispac.gui.features.estimate import actions as estimate
from lispac.gui.features.export import feature as export
from lispac.gui.features.help import actions as help
from lispac.gui.features.help.dialogs import HelpDialogs
from lispac.gui.features.inspect import actions as inspect
from lispac.gui.features.inspect.dialogs import PictureDialogs
from lispac.gui.features.open_project import actions as open_project
from lispac.gui.features.open_project.dialogs import ProjectDialogs
from lispac.gui.features.patch_test import feature as patch_test
from lispac.gui.features.pick_targets import actions as pick_targets
from lispac.gui.features.pick_targets.dialogs import TargetDialogs
from lispac.gui.features.preferences import actions as preferences
from lispac.gui.features.preferences.dialogs import PreferenceDialogs
from lispac.gui.features.report import actions as report
from lispac.gui.features.report.dialogs import ReportDialogs
from lispac.gui.features.studies import feature as studies
from lispac.gui.features.validate import actions as validate
from lispac.gui.features.warnings import actions as warnings
from lispac.gui.project.features import Feature, PanelRecord

FEATURES = (
    Feature(open_project.ACTIONS, ProjectDialogs),
    Feature(report.ACTIONS, ReportDialogs),
    export.FEATURE,
    Feature(pick_targets.ACTIONS, TargetDialogs),
    Feature(estimate.ACTIONS),
    control.FEATURE,
    conventions.FEATURE,
    patch_test.FEATURE,
    studies.FEATURE,
    Feature(design.ACTIONS, DesignDialogs),
    Feature(validate.ACTIONS),
    Feature(inspect.ACTIONS, PictureDialogs),
    Feature(preferences.ACTIONS, PreferenceDialogs),
    Feature(warnings.ACTIONS),
    Feature(help.ACTIONS, HelpDialogs),
)
"""All features; a feature that is added here is complete.

Those without a record of their own have panels or controllers that `MainWindow` connects with those
of other features.
"""


def panel_records() -> list[PanelRecord]:
    """Panels of all features that are not connected with others."""
    return [panel for feature in FEATURES for panel in feature.panels]
