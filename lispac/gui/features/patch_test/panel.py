"""The LiDAR patch test: objects, pairs of lines, angles and results."""

from collections.abc import Collection, Mapping, Sequence

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QHideEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QListWidget,
    QListWidgetItem,
    QScrollArea,
    QSizePolicy,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.app.unavailable import Reason, Unavailable, first_reason, reason_text
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.patch_test.angles import PatchAngles
from lispac.gui.features.patch_test.pictures import CurvePicture, LinesPicture
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.patchtest.line_pairs import Kind, LinePair

EMPTY_TEXT = N_(
    "The patch test compares the lines at objects visible in several lines: edges, pillars, "
    "poles. Find objects, or click one in the view. Then change roll, pitch and yaw until the "
    "colours coincide: the correct boresight has the smallest mismatch. Distant objects high "
    "above the vessel are best; positions under bridges may be wrong."
)
NO_DATA_TEXT = N_("Open a project with at least two lines to compare them.")
VIEW_TITLES = (N_("From above"), N_("From the front of the box"), N_("From the left of the box"))
"""Directions in which an object is shown."""
CURVE_TITLES = (N_("Displayed object"), N_("All ticked objects"))
PAIR_SYMBOLS: dict[Kind, str] = {
    "reciprocal": "⇄", "crossing": "✕", "oblique": "∠", "same direction": "⇉",
}  # fmt: skip
PAIR_KIND_NAMES: dict[Kind, str] = {
    "reciprocal": N_("reciprocal lines"),
    "crossing": N_("crossing lines"),
    "oblique": N_("oblique lines"),
    "same direction": N_("lines in the same direction"),
}
"""Names of the kinds of pairs; `PAIR_SYMBOLS` are their symbols."""
SIDE_WIDTH_PX, LIST_WIDTH_PX, PICTURE_SPACING_PX = 316, 100, 6
"""Width of both lists, width of the list of objects, and space between the pictures, pixels."""
MIN_WIDE_PX, MAX_ANGLES_WIDTH_PX = 1180, 440
"""Width from which the pictures are between lists and angles, and that of the angles then."""
MIN_TWO_COLUMNS_PX, MIN_STACKED_HEIGHT_PX = 770, 760
"""Width from which lists and angles are side by side, and height from which both pictures are one
below the other in a narrower panel."""
QWIDGETSIZE_MAX = 16777215
"""Largest size of a widget in Qt, which PySide6 does not export."""


class PatchTestPanel(QWidget):
    """Options and results of the patch test."""

    propose_requested = Signal()
    point_requested = Signal()
    target_requested = Signal()
    box_requested = Signal()
    remove_requested = Signal(str)
    zoom_requested = Signal(str)
    shown_changed = Signal()
    """The user has chosen another object, viewing direction or curve."""
    ticked_changed = Signal()
    """The user has changed which objects or pairs are compared."""
    find_all_requested = Signal()
    save_requested = Signal()
    prior_requested = Signal()
    visibility_changed = Signal(bool)
    """The panel was opened or closed; a minimised window is still open."""

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumHeight(250)
        self.objects = _create_list(
            "patch_objects", gettext("Objects; only ticked ones are compared")
        )
        self.pairs = _create_list(
            "patch_pairs", gettext("Pairs of lines; only ticked ones are compared")
        )
        self.picture, self.curve, self.angles = LinesPicture(), CurvePicture(), PatchAngles()
        self.view = widgets.ChoiceBox(
            "patch_view", [gettext(each) for each in VIEW_TITLES],
            gettext("Direction from which the object is viewed"),
        )  # fmt: skip
        self.of = widgets.ChoiceBox(
            "patch_curve_of", [gettext(each) for each in CURVE_TITLES],
            gettext("Plot the mismatch of the displayed object or of all ticked objects"),
        )  # fmt: skip
        self.text_label = widgets.label(gettext(EMPTY_TEXT), "muted", wrap=True, name="patch_text")
        self.text_label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.text_label.setContentsMargins(24, 0, 24, 0)
        self.message_label = widgets.label("", wrap=True, name="patch_message")
        self.message_label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._buttons()
        self._inside = inside = QWidget()
        self._columns = QGridLayout(inside)
        self._columns.setContentsMargins(8, 4, 8, 4)
        left = QWidget()
        left.setLayout(self._create_left_column())
        middle = QWidget()
        self._middle = QStackedLayout(middle)
        self._middle.addWidget(self.text_label)
        self._middle.addWidget(self._create_pictures())
        self._pictures = middle
        self._left, self._right = left, QWidget()
        self._right.setLayout(self._create_right_column())
        self._form: tuple[bool, bool, bool] | None = None
        self._arrange(is_wide=False, is_narrow=False, is_high=False)
        # In a small window, the panel scrolls and does not widen the window.
        self._area = area = QScrollArea()
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidgetResizable(True)
        area.setWidget(inside)
        around = QVBoxLayout(self)
        around.setContentsMargins(0, 0, 0, 0)
        around.addWidget(area)
        self.objects.itemChanged.connect(lambda _item: self.ticked_changed.emit())
        self.pairs.itemChanged.connect(lambda _item: self.ticked_changed.emit())
        self.objects.currentItemChanged.connect(lambda _now, _before: self._emit_shown_changed())
        self.objects.itemDoubleClicked.connect(
            lambda item: self.zoom_requested.emit(_item_name(item))
        )
        self.view.currentIndexChanged.connect(lambda _index: self.shown_changed.emit())
        self.of.currentIndexChanged.connect(lambda _index: self.shown_changed.emit())
        self.update_enabled(Unavailable.NO_PROJECT, busy=False, has_result=False)

    def showEvent(self, event: QShowEvent) -> None:
        """Emit `visibility_changed` with True."""
        super().showEvent(event)
        if not event.spontaneous():
            self.visibility_changed.emit(True)

    def hideEvent(self, event: QHideEvent) -> None:
        """Emit `visibility_changed` with False."""
        super().hideEvent(event)
        if not event.spontaneous():
            self.visibility_changed.emit(False)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Arrange lists, angles and pictures for the size of the panel."""
        super().resizeEvent(event)
        size = event.size()
        self._arrange(
            is_wide=size.width() >= MIN_WIDE_PX, is_narrow=size.width() < MIN_TWO_COLUMNS_PX,
            is_high=size.height() >= MIN_STACKED_HEIGHT_PX,
        )  # fmt: skip

    def _arrange(self, *, is_wide: bool, is_narrow: bool, is_high: bool) -> None:
        """Place the pictures between lists and angles, or below them; all parts in one column.

        Parameters
        ----------
        is_wide, is_narrow : whether there is space for three columns, and only for one
        is_high : whether the pictures are one below the other in one column
        """
        if (is_wide, is_narrow, is_high) == self._form:
            return
        self._form = is_wide, is_narrow, is_high
        columns = self._columns
        for part in (self._left, self._right, self._pictures):
            columns.removeWidget(part)
        self._left.setMinimumWidth(SIDE_WIDTH_PX)
        self._left.setMaximumWidth(QWIDGETSIZE_MAX if is_narrow else SIDE_WIDTH_PX)
        columns.addWidget(self._left, 0, 0)
        if is_narrow:
            columns.addWidget(self._right, 1, 0)
            columns.addWidget(self._pictures, 2, 0)
        else:
            columns.addWidget(self._right, 0, 2)
            columns.addWidget(self._pictures, *((0, 1) if is_wide else (1, 0, 1, 3)))
        for column, stretch in enumerate((is_narrow, is_wide, not is_wide and not is_narrow)):
            columns.setColumnStretch(column, int(stretch))
        for row, stretch in enumerate((2, 0, 3) if is_narrow else (3, 0 if is_wide else 2, 0)):
            columns.setRowStretch(row, stretch)
        self.angles.setMaximumWidth(MAX_ANGLES_WIDTH_PX if is_wide else QWIDGETSIZE_MAX)
        # The tips of the pairs explain the symbols too
        self.pair_kinds.setVisible(is_high or not is_narrow)
        self._stack_pictures(stacked=is_narrow and is_high)

    def _stack_pictures(self, *, stacked: bool) -> None:
        """Place the curve with its choice below the picture of the lines, or beside it."""
        grid = self._picture_grid
        row, column = (2, 0) if stacked else (0, 1)
        for number, part in enumerate((self.of, self.curve)):
            grid.removeWidget(part)
            grid.addWidget(part, row + number, column)
        grid.setRowStretch(3, int(stacked))

    def _buttons(self) -> None:
        add_button = widgets.button
        self.propose = add_button(
            gettext("Find objects"), "patch_propose", primary=True,
            tip=gettext("Find objects that are visible in several lines, and put boxes around "
                        "them"),
        )  # fmt: skip
        self.point = add_button(
            gettext("Click object"), "patch_point",
            tip=gettext("Put a box around the next point that you click in the view"),
        )  # fmt: skip
        self.target = add_button(
            gettext("Target"), "patch_target", tip=gettext("Put a box around the selected target")
        )
        self.box = add_button(
            gettext("Clip box"),
            "patch_box",
            tip=gettext("Use the clip box of the view as the box of an object"),
        )
        self.remove = add_button(
            gettext("Remove"), "patch_remove", tip=gettext("Remove the object from the list")
        )
        self.go = add_button(
            gettext("Go to object"), "patch_go", tip=gettext("Zoom the view to the object")
        )
        self.all = add_button(
            gettext("Find all angles"), "patch_find_all", primary=True,
            tip=gettext(
                "Find the three angles at which the mismatch of the ticked objects is smallest, "
                "with their standard deviations"
            ),
        )  # fmt: skip
        self.save_button = add_button(
            gettext("Keep result"), "patch_keep",
            tip=gettext("Keep the result in the project as an alternative method"),
        )  # fmt: skip
        self.prior = add_button(
            gettext("Reset angles"), "patch_prior",
            tip=gettext("Reset all angles to the prior boresight"),
        )  # fmt: skip
        for button, signal in (
            (self.propose, self.propose_requested), (self.point, self.point_requested),
            (self.target, self.target_requested), (self.box, self.box_requested),
            (self.all, self.find_all_requested), (self.save_button, self.save_requested),
            (self.prior, self.prior_requested),
        ):  # fmt: skip
            button.clicked.connect(lambda _on, signal=signal: signal.emit())
        self.remove.clicked.connect(lambda _on: self.remove_requested.emit(self.shown))
        self.go.clicked.connect(lambda _on: self.zoom_requested.emit(self.shown))

    def _create_left_column(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.addWidget(self.propose, 0, 0, 1, 3)
        by_hand = QHBoxLayout()
        for button in (self.point, self.target, self.box):
            by_hand.addWidget(button)
        grid.addLayout(by_hand, 1, 0, 1, 3)
        lists = QHBoxLayout()
        self.objects.setFixedWidth(LIST_WIDTH_PX)
        lists.addWidget(self.objects)
        lists.addWidget(self.pairs, 1)
        grid.addLayout(lists, 2, 0, 1, 3)
        self.pair_kinds = widgets.label("", "muted", wrap=True, name="patch_pair_kinds")
        grid.addWidget(self.pair_kinds, 3, 0, 1, 3)
        grid.addWidget(self.go, 4, 0)
        grid.addWidget(self.remove, 4, 1)
        grid.setRowStretch(2, 1)
        grid.setVerticalSpacing(4)
        return grid

    def _create_pictures(self) -> QWidget:
        container = QWidget()
        grid = QGridLayout(container)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(PICTURE_SPACING_PX)
        grid.addWidget(self.view, 0, 0)
        grid.addWidget(self.picture, 1, 0)
        grid.setRowStretch(1, 1)
        self._picture_grid = grid
        return container

    def _create_right_column(self) -> QVBoxLayout:
        column = QVBoxLayout()
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addWidget(self.angles)
        column.addWidget(self.all)
        row = QHBoxLayout()
        for button in (self.save_button, self.prior):
            row.addWidget(button)
        column.addLayout(row)
        area = widgets.VerticalScrollArea(self.message_label, 200)
        area.setMinimumHeight(34)
        area.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Ignored)
        self.message_label.setAlignment(Qt.AlignmentFlag.AlignTop)
        column.addWidget(area, 1)
        return column

    # -- selection ---------------------------------------------------------------------------

    @property
    def shown(self) -> str:
        """Name of the displayed object; empty for none."""
        item = self.objects.currentItem()
        return "" if item is None else _item_name(item)

    @property
    def ticked_entries(self) -> tuple[str, ...]:
        """Names of the ticked objects."""
        return tuple(_ticked_names(self.objects))

    @property
    def ticked_pairs(self) -> frozenset[str]:
        """Names of the ticked pairs."""
        return frozenset(_ticked_names(self.pairs))

    # -- display -----------------------------------------------------------------------------

    def show_objects(self, names: Sequence[str], unticked: Collection[str], shown: str) -> None:
        """Show the list of objects."""
        with QSignalBlocker(self.objects):
            _fill_list(self.objects, [(name, name) for name in names], unticked)
            if names:
                row = names.index(shown) if shown in names else 0
                self.objects.setCurrentRow(row)
        self._middle.setCurrentIndex(1 if names else 0)

    def show_pairs(self, pairs: Sequence[LinePair]) -> None:
        """Show the list of pairs with all pairs ticked, and the meaning of their symbols."""
        shown = {pair.kind for pair in pairs}
        self.pair_kinds.setText(
            "\n".join(
                f"{PAIR_SYMBOLS[kind]}  {gettext(name)}"
                for kind, name in PAIR_KIND_NAMES.items()
                if kind in shown
            )
        )
        with QSignalBlocker(self.pairs):
            _fill_list(
                self.pairs, [(p.name, f"{PAIR_SYMBOLS[p.kind]} {p.name}") for p in pairs], ()
            )
            for row, pair in enumerate(pairs):
                kind = gettext(PAIR_KIND_NAMES[pair.kind])
                self.pairs.item(row).setToolTip(kind)
                self.pairs.item(row).setData(
                    Qt.ItemDataRole.AccessibleTextRole, f"{pair.name}, {kind}"
                )

    def copy_choices_from(self, former: "PatchTestPanel") -> None:
        """Copy objects, ticks and choices of the panel of a former window, without a signal."""
        items = [former.objects.item(row) for row in range(former.objects.count())]
        names = [_item_name(item) for item in items]
        self.show_objects(names, set(names) - set(former.ticked_entries), former.shown)
        with QSignalBlocker(self.pairs):
            for row in range(self.pairs.count()):
                self.pairs.item(row).setCheckState(former.pairs.item(row).checkState())
        for choice, chosen in ((self.view, former.view), (self.of, former.of)):
            with QSignalBlocker(choice):
                choice.setCurrentIndex(chosen.currentIndex())

    def mark_objects(self, messages: Mapping[str, Message]) -> None:
        """Mark objects by name with messages, which their tooltips show."""
        with QSignalBlocker(self.objects):
            for row in range(self.objects.count()):
                item = self.objects.item(row)
                found = messages.get(_item_name(item))
                item.setText(f"{_item_name(item)} ⚠" if found else _item_name(item))
                tip = "" if found is None else message_text(found)
                item.setToolTip(widgets.plain_tip(tip))

    def show_empty(self, reason: str) -> None:
        """Show the reason why there are no objects: `EMPTY_TEXT` or `NO_DATA_TEXT`."""
        self.text_label.setText(gettext(reason))
        self.show_objects((), (), "")

    def update_enabled(self, no_data: Reason, *, busy: bool, has_result: bool) -> None:
        """Enable the buttons that can be used now, and give the reason for the others.

        Parameters
        ----------
        no_data : Reason
            Why there are no lines to compare; None if there are.
        """
        no_object = no_data or first_reason((not self.objects.count(), Unavailable.NO_OBJECT))
        no_result = no_object or first_reason((not has_result, Unavailable.NO_ANGLES))
        is_busy = first_reason((busy, Unavailable.BUSY))
        for button in (self.propose, self.point, self.target, self.box):
            button.set_reason(reason_text(no_data or is_busy))
        for button in (self.remove, self.go, self.prior):
            button.set_reason(reason_text(no_object))
        self.all.set_reason(reason_text(no_object or is_busy))
        self.save_button.set_reason(reason_text(no_result or is_busy))
        self.angles.setEnabled(no_object is None)
        self.angles.set_reason(reason_text(no_object or is_busy))

    def _emit_shown_changed(self) -> None:
        self.shown_changed.emit()


def _create_list(name: str, title: str) -> QListWidget:
    made = QListWidget()
    made.setObjectName(name)
    made.setAccessibleName(title)
    made.setToolTip(title)
    made.setMinimumSize(90, 76)
    # Its preferred height would scroll the panel in a low window
    made.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Ignored)
    return made


def _fill_list(
    made: QListWidget, rows: Sequence[tuple[str, str]], unticked: Collection[str]
) -> None:
    made.clear()
    for name, text in rows:
        item = QListWidgetItem(text, made)
        item.setData(Qt.ItemDataRole.UserRole, name)
        on = name not in unticked
        item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)


def _item_name(item: QListWidgetItem) -> str:
    return str(item.data(Qt.ItemDataRole.UserRole))


def _ticked_names(made: QListWidget) -> list[str]:
    items = [made.item(row) for row in range(made.count())]
    return [_item_name(item) for item in items if item.checkState() == Qt.CheckState.Checked]
