"""The LiDAR patch test: objects and pairs to choose, angles to turn, and what comes of it."""

from collections.abc import Collection, Sequence

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QListWidget,
    QListWidgetItem,
    QScrollArea,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.patch_angles import PatchAngles
from lispac.gui.panels.patch_pictures import CurvePicture, LinesPicture
from lispac.patchtest.pairs import Kind, LinePair

TITLE = "Patch test"
EMPTY = (
    "The patch test lays lines onto each other about objects that they share: an edge, a pillar, a "
    "pole. Turn roll, pitch and yaw until the colours fall together; where the mismatch is "
    "smallest, the boresight is right. Let objects be found, or click one in the view. Objects far "
    "and high above the vessel tell most; under bridges the position may be off."
)
NO_DATA = "Open a project with two lines or more to lay them onto each other."
VIEWS = ("From above", "Ahead of the box", "From its left")
"""How an object is looked at."""
CURVES = ("Object shown", "All ticked")
SIGNS: dict[Kind, str] = {
    "reciprocal": "⇄", "crossing": "✕", "oblique": "∠", "same direction": "⇉",
}  # fmt: skip
"""Of the kinds of pairs; the tip says them in words."""
SIDE, LISTED, SPACE = 316, 100, 6
"""Pixels of the lists together, of that of the objects, and between the pictures."""


class PatchTestPanel(QWidget):
    """Asks by signals; shows what it is given."""

    propose_asked = Signal()
    point_asked = Signal()
    target_asked = Signal()
    box_asked = Signal()
    remove_asked = Signal(str)
    go_asked = Signal(str)
    shown_changed = Signal()
    """Another object, another side of it, or another curve is to be seen."""
    ticked_changed = Signal()
    """Other objects or pairs are to be compared."""
    all_asked = Signal()
    keep_asked = Signal()
    prior_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumHeight(250)
        self.objects = _list("patch_objects", "Objects: tick those that count")
        self.pairs = _list("patch_pairs", "Pairs of lines: tick those that count")
        self.picture, self.curve, self.angles = LinesPicture(), CurvePicture(), PatchAngles()
        self.view = widgets.Choice("patch_view", VIEWS, "From where the object is looked at")
        self.of = widgets.Choice(
            "patch_curve_of", CURVES, "Whose mismatch is drawn: of one object, or of all ticked"
        )
        self.words = widgets.label(EMPTY, "muted", wrap=True, name="patch_words")
        self.words.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.words.setContentsMargins(24, 0, 24, 0)
        self.said = widgets.label("", wrap=True, name="patch_said")
        self.said.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._buttons()
        self._inside = inside = QWidget()
        row = QHBoxLayout(inside)
        row.setContentsMargins(8, 4, 8, 4)
        left = QWidget()
        left.setLayout(self._left())
        left.setFixedWidth(SIDE)
        row.addWidget(left)
        self._middle = QStackedLayout()
        self._middle.addWidget(self.words)
        self._middle.addWidget(self._pictures())
        row.addLayout(self._middle, 1)
        row.addLayout(self._right())
        # In a small window it is moved to and fro rather than makes the window wider.
        self._area = area = QScrollArea()
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidgetResizable(True)
        area.setWidget(inside)
        around = QVBoxLayout(self)
        around.setContentsMargins(0, 0, 0, 0)
        around.addWidget(area)
        self.objects.itemChanged.connect(lambda _item: self.ticked_changed.emit())
        self.pairs.itemChanged.connect(lambda _item: self.ticked_changed.emit())
        self.objects.currentItemChanged.connect(lambda _now, _before: self._another())
        self.objects.itemDoubleClicked.connect(lambda item: self.go_asked.emit(_name(item)))
        self.view.currentIndexChanged.connect(lambda _index: self.shown_changed.emit())
        self.of.currentIndexChanged.connect(lambda _index: self.shown_changed.emit())
        self.allow(ready=False, busy=False, answer=False)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Have all of it within the width: where that is small, one picture is below the other."""
        super().resizeEvent(event)
        more = max(self.of.minimumSizeHint().width(), self.curve.minimumWidth()) + SPACE
        wide = self._inside.minimumSizeHint().width() + (0 if self._beside else more)
        # What is in it is as wide as before just now
        room = event.size().width() - self._area.verticalScrollBar().sizeHint().width()
        self._place_curve(beside=wide <= room)

    def _buttons(self) -> None:
        make = widgets.button
        self.propose = make(
            "Find objects", "patch_propose", primary=True,
            tip="Find objects that lines share, and lay boxes about them",
        )  # fmt: skip
        self.point = make(
            "Click one", "patch_point",
            tip="Lay a box about the next point that is clicked in the view",
        )  # fmt: skip
        self.target = make("Target", "patch_target", tip="Lay a box about the selected target")
        self.box = make("Clip box", "patch_box", tip="Take the clip box as it lies in the view")
        self.remove = make("Remove", "patch_remove", tip="Take the object off the list")
        self.go = make("Go to", "patch_go", tip="Bring the object into view")
        self.all = make("Find all three", "patch_find_all", primary=True,
                        tip="Turn all angles to where the mismatch of all ticked objects is "
                        "smallest, and say how well they are known")  # fmt: skip
        self.keep = make(
            "Keep this answer", "patch_keep",
            tip="Keep the result in the project as an alternative method",
        )  # fmt: skip
        self.prior = make("Start again from the prior", "patch_prior",
                          tip="Turn all angles back to the prior boresight")  # fmt: skip
        for button, asked in (
            (self.propose, self.propose_asked), (self.point, self.point_asked),
            (self.target, self.target_asked), (self.box, self.box_asked),
            (self.all, self.all_asked), (self.keep, self.keep_asked),
            (self.prior, self.prior_asked),
        ):  # fmt: skip
            button.clicked.connect(lambda _on, asked=asked: asked.emit())
        self.remove.clicked.connect(lambda _on: self.remove_asked.emit(self.shown))
        self.go.clicked.connect(lambda _on: self.go_asked.emit(self.shown))

    def _left(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.addWidget(self.propose, 0, 0, 1, 3)
        by_hand = QHBoxLayout()
        for button in (self.point, self.target, self.box):
            by_hand.addWidget(button)
        grid.addLayout(by_hand, 1, 0, 1, 3)
        lists = QHBoxLayout()
        self.objects.setFixedWidth(LISTED)
        lists.addWidget(self.objects)
        lists.addWidget(self.pairs, 1)
        grid.addLayout(lists, 2, 0, 1, 3)
        grid.addWidget(self.go, 3, 0)
        grid.addWidget(self.remove, 3, 1)
        grid.setRowStretch(2, 1)
        grid.setVerticalSpacing(4)
        return grid

    def _pictures(self) -> QWidget:
        held = QWidget()
        self._grid = grid = QGridLayout(held)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(SPACE)
        grid.addWidget(self.view, 0, 0)
        grid.addWidget(self.picture, 1, 0)
        grid.setRowStretch(1, 1)
        self._place_curve(beside=True)
        return held

    def _place_curve(self, *, beside: bool) -> None:
        self._beside = beside
        row, column = (0, 1) if beside else (2, 0)
        self._grid.addWidget(self.of, row, column)
        self._grid.addWidget(self.curve, row + 1, column)
        self._grid.setRowStretch(3, 0 if beside else 1)

    def _right(self) -> QVBoxLayout:
        column = QVBoxLayout()
        column.setSpacing(4)
        self.angles.setMaximumWidth(420)
        column.addWidget(self.angles)
        column.addWidget(self.all)
        row = QHBoxLayout()
        for button in (self.keep, self.prior):
            row.addWidget(button)
        column.addLayout(row)
        area = widgets.TallArea(self.said, 200)
        area.setMinimumHeight(34)
        self.said.setAlignment(Qt.AlignmentFlag.AlignTop)
        column.addWidget(area, 1)
        return column

    # -- what is chosen ----------------------------------------------------------------------

    @property
    def shown(self) -> str:
        """Name of the object that is looked at; "" for none."""
        item = self.objects.currentItem()
        return "" if item is None else _name(item)

    @property
    def ticked(self) -> tuple[str, ...]:
        """Names of the objects that count."""
        return tuple(_ticked(self.objects))

    @property
    def ticked_pairs(self) -> frozenset[str]:
        """Names of the pairs that count."""
        return frozenset(_ticked(self.pairs))

    # -- what is shown -----------------------------------------------------------------------

    def show_objects(self, names: Sequence[str], unticked: Collection[str], shown: str) -> None:
        """Fill the list of objects."""
        with QSignalBlocker(self.objects):
            _fill(self.objects, [(name, name) for name in names], unticked)
            if names:
                row = names.index(shown) if shown in names else 0
                self.objects.setCurrentRow(row)
        self._middle.setCurrentIndex(1 if names else 0)

    def show_pairs(self, pairs: Sequence[LinePair]) -> None:
        """Fill the list of pairs; all are ticked."""
        with QSignalBlocker(self.pairs):
            _fill(self.pairs, [(p.name, f"{SIGNS[p.kind]} {p.name}") for p in pairs], ())
            for row, pair in enumerate(pairs):
                self.pairs.item(row).setToolTip(say(pair.kind))
                spoken = f"{pair.name}, {say(pair.kind)}"
                self.pairs.item(row).setData(Qt.ItemDataRole.AccessibleTextRole, spoken)

    def mark_objects(self, words: dict[str, str]) -> None:
        """Mark the objects of which there is something to say, and say it as their tips."""
        with QSignalBlocker(self.objects):
            for row in range(self.objects.count()):
                item = self.objects.item(row)
                said = words.get(_name(item), "")
                item.setText(f"{_name(item)} ⚠" if said else _name(item))
                item.setToolTip(widgets.plain_tip(say(said)))

    def say_empty(self, words: str) -> None:
        """Say why there is nothing."""
        self.words.setText(say(words))
        self.show_objects((), (), "")

    def allow(self, *, ready: bool, busy: bool, answer: bool) -> None:
        """Let be pressed what can be done now."""
        some, free = bool(self.objects.count()), ready and not busy
        for button in (self.propose, self.point, self.target, self.box):
            button.allow(free)
        for button in (self.remove, self.go):
            button.allow(some and ready)
        self.all.allow(some and free)
        self.keep.allow(answer and free)
        self.prior.allow(some and ready)
        self.angles.setEnabled(some and ready)
        self.angles.allow(some and free)

    def _another(self) -> None:
        self.shown_changed.emit()


def _list(name: str, words: str) -> QListWidget:
    made = QListWidget()
    made.setObjectName(name)
    made.setAccessibleName(say(words))
    made.setToolTip(say(words))
    made.setMinimumSize(90, 60)
    return made


def _fill(made: QListWidget, rows: Sequence[tuple[str, str]], unticked: Collection[str]) -> None:
    made.clear()
    for name, text in rows:
        item = QListWidgetItem(text, made)
        item.setData(Qt.ItemDataRole.UserRole, name)
        on = name not in unticked
        item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)


def _name(item: QListWidgetItem) -> str:
    return str(item.data(Qt.ItemDataRole.UserRole))


def _ticked(made: QListWidget) -> list[str]:
    items = [made.item(row) for row in range(made.count())]
    return [_name(item) for item in items if item.checkState() == Qt.CheckState.Checked]
