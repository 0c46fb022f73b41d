"""Fields for the coordinate system and the vertical system of coordinates."""

from collections.abc import Collection
from typing import cast

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QComboBox, QFormLayout, QLineEdit

from lispac.errors import InputError, LispacError
from lispac.language import N_, gettext
from lispac.messages import error
from lispac.project import Project
from lispac.survey.crs import CoordinateSystem
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.project.coordinates import LocalAxes, axis_names
from lispac.workflow.project.output_crs import (
    LOCAL_FRAME,
    common_system,
    output_system_of,
    utm_zone,
)

CHECK_DELAY_MS = 300
"""Delay after the last typed character until the text is checked."""
LOCAL_FRAME_TEXTS: dict[LocalAxes, str] = {
    "north, west, up": N_("Local frame – North, West, Up"),
    "east, north, up": N_("Local frame – East, North, Up"),
}
"""Item for the local frame, by the order of its coordinates."""
HEIGHT_PLACEHOLDER = N_("From the coordinate system, otherwise ellipsoidal heights")
HEIGHT_TIP = N_("EPSG code of a vertical system, path of a geoid grid (.gtx, .tif) or “ellipsoid”")


def system_box(
    name: str, project: Project, trajectory: LocalTrajectory, *, local_first: bool = False,
    local_axes: LocalAxes = "north, west, up",
) -> QComboBox:  # fmt: skip
    """Create an editable list of likely coordinate systems, with their codes as item data."""
    found = QComboBox()
    found.setObjectName(name)
    found.setEditable(True)
    found.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
    found.setToolTip(gettext("Choose or type an EPSG code, such as EPSG:2959 or EPSG:6347+5703"))
    zone, local_text = utm_zone(trajectory), gettext(LOCAL_FRAME_TEXTS[local_axes])
    try:
        line_system = common_system(project)
    except LispacError:
        line_system = None  # the lines are in different systems
    items = [(gettext("{zone} – UTM zone of the trajectory (WGS 84)", zone=zone), zone)]
    if line_system is not None:
        system = line_system.name if line_system.frame is None else local_text
        items.insert(0, (gettext("System of the line files – {system}", system=system), ""))
    items.insert(0 if local_first else len(items), (local_text, LOCAL_FRAME))
    for text, code in items:
        found.addItem(text, code)
    return found


def system_text(box: QComboBox) -> str:
    """Code of the chosen item, or the typed text."""
    text = box.currentText().strip()
    index = box.findText(text)
    return cast(str, box.itemData(index)) if index >= 0 else text


class CoordinateSystemFields(QObject):
    """Two fields of a form, coordinate system and vertical system, with a check of the input.

    Attributes
    ----------
    system : CoordinateSystem or None
        None for the local frame.
    problem : LispacError or None
        Reason why there is no system; None if there is one.
    waiting : bool
        Whether the typed text has not yet been checked.
    """

    changed = Signal()

    def __init__(
        self, project: Project, trajectory: LocalTrajectory, prefix: str, parent: QObject,
        local_axes: LocalAxes = "north, west, up",
    ) -> None:  # fmt: skip
        super().__init__(parent)
        self._project, self._trajectory = project, trajectory
        self._local_axes = local_axes
        self.box = system_box(
            f"{prefix}_system", project, trajectory, local_first=True, local_axes=local_axes
        )
        self.height = QLineEdit()
        self.height.setObjectName(f"{prefix}_height")
        self.height.setPlaceholderText(gettext(HEIGHT_PLACEHOLDER))
        self.height.setToolTip(gettext(HEIGHT_TIP))
        self.system: CoordinateSystem | None = None
        self.problem: LispacError | None = None
        self.waiting = False
        self._form: QFormLayout | None = None
        self._debounce = QTimer(self)
        self._debounce.setSingleShot(True)
        self._debounce.setInterval(CHECK_DELAY_MS)
        self._debounce.timeout.connect(self._resolve_system)
        self.box.editTextChanged.connect(self._on_typed)
        self.height.textChanged.connect(self._on_typed)

    def add_to(self, form: QFormLayout) -> None:
        """Add the two fields to a form."""
        form.addRow(gettext("Coordinate system"), self.box)
        form.addRow(gettext("Vertical system"), self.height)
        self._form = form
        self._resolve_system()

    def choose(self, axes: Collection[str]) -> None:
        """Choose the local frame or the system of the line files, by the names of the axes."""
        is_local_frame = set(axes) == set(axis_names(None, self._local_axes))
        index = self.box.findData(LOCAL_FRAME if is_local_frame else "")
        if index >= 0:
            self.height.clear()
            self.box.setCurrentIndex(index)

    def _on_typed(self) -> None:
        if self.box.findText(self.box.currentText()) >= 0 and not self.height.text():
            self._resolve_system()  # chosen, not typed
            return
        self.waiting = True
        self._debounce.start()
        self.changed.emit()

    def _resolve_system(self) -> None:
        self._debounce.stop()
        self.waiting, self.problem, self.system = False, None, None
        text, chosen = system_text(self.box), self.box.findText(self.box.currentText().strip()) >= 0
        self._show_heights(text != LOCAL_FRAME)
        if not text and not chosen:
            self.problem = InputError(error("window.no_coordinate_system"))
        elif text != LOCAL_FRAME:
            height = self.height.text().strip()
            try:
                self.system = output_system_of(self._project, self._trajectory, text, height)
            except LispacError as failure:
                self.problem = failure
        self.changed.emit()

    def _show_heights(self, shown: bool) -> None:
        if self._form is not None:
            self._form.setRowVisible(self.height, shown)
