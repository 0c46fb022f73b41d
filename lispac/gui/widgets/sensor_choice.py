"""Widget for the choice of scanner and INS/GNSS from the sensor library."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from lispac.gui import widgets
from lispac.io.config.sensor_file import PosAccuracy, PosSpecification, ScannerSpecification
from lispac.language import N_, gettext
from lispac.workflow.planning.sensors import SensorLibrary, source_text

OTHER_SENSOR_TEXT = N_("Other (enter specifications)")
SOLUTION_NAMES = {"rtk": "RTK", "ppk": "PPK", "degraded": N_("degraded GNSS")}
"""Displayed names of the GNSS solutions."""


class SensorChoice(QWidget):
    """Lists of scanners and of INS/GNSS with each solution, and the sources of their values.

    `scanner_chosen` and `pos_chosen` emit the specifications of the chosen sensor.
    """

    scanner_chosen = Signal(object)
    pos_chosen = Signal(object)

    def __init__(self, library: SensorLibrary, prefix: str) -> None:
        super().__init__()
        self._scanners = [("", None), *((s.name, s.figures) for s in library.scanners)]
        self._pos: list[tuple[str, tuple[PosSpecification, PosAccuracy] | None]] = [
            ("", None),
            *(
                (f"{each.name}:{state.name}", (each.figures, state))
                for each in library.pos
                for state in each.figures.states
            ),
        ]
        self.scanner = widgets.ChoiceBox(
            f"{prefix}_scanner", [gettext(OTHER_SENSOR_TEXT)],
            gettext("The LiDAR noise of the chosen scanner is filled in. Check it against your "
                    "instrument."),
        )  # fmt: skip
        self.pos = widgets.ChoiceBox(
            f"{prefix}_pos", [gettext(OTHER_SENSOR_TEXT)],
            gettext(
                "The position and attitude standard deviations of the chosen INS/GNSS are filled "
                "in. They apply if there is no accuracy file."
            ),
        )  # fmt: skip
        # Titles are names and are not translated.
        self.scanner.addItems([sensor.figures.title for sensor in library.scanners])
        self.pos.addItems([_pos_title(entry) for entry in self._pos[1:]])
        self.scanner.setAccessibleName(gettext("Scanner"))
        self.pos.setAccessibleName(gettext("INS/GNSS"))
        self.scanner_origin = widgets.label("", "muted", wrap=True, name=f"{prefix}_scanner_origin")
        self.pos_origin = widgets.label("", "muted", wrap=True, name=f"{prefix}_pos_origin")
        self.scanner.currentIndexChanged.connect(lambda _index: self._emit_scanner())
        self.pos.currentIndexChanged.connect(lambda _index: self._emit_pos())
        self._emit_scanner()
        self._emit_pos()

    def choose(self, scanner: str, pos: str) -> None:
        """Choose sensors by name; unknown names choose nothing."""
        for box, known, name in (
            (self.scanner, [n for n, _ in self._scanners], scanner),
            (self.pos, [n for n, _ in self._pos], pos),
        ):
            box.setCurrentIndex(known.index(name) if name in known else 0)

    @property
    def names(self) -> tuple[str, str]:
        """Names of the chosen sensors, as on the command line; empty if none is chosen."""
        return (
            self._scanners[self.scanner.currentIndex()][0], self._pos[self.pos.currentIndex()][0]
        )  # fmt: skip

    @property
    def identity_fields(self) -> dict[str, str]:
        """Maker and model of the chosen sensors, by field of `lispac.identity.Identity`."""
        scanner, pos = self._chosen_scanner(), self._pos[self.pos.currentIndex()][1]
        found = {} if scanner is None else {"scanner": scanner.title}
        return found if pos is None else found | {"pos": pos[0].title}

    def _chosen_scanner(self) -> ScannerSpecification | None:
        return self._scanners[self.scanner.currentIndex()][1]

    def _emit_scanner(self) -> None:
        figures = self._chosen_scanner()
        _show_origin(self.scanner_origin, figures)
        if figures is not None:
            self.scanner_chosen.emit(figures)

    def _emit_pos(self) -> None:
        found = self._pos[self.pos.currentIndex()][1]
        state = None if found is None else found[1]
        _show_origin(self.pos_origin, state)
        if state is not None:
            self.pos_chosen.emit(state)


def _pos_title(entry: tuple[str, tuple[PosSpecification, PosAccuracy] | None]) -> str:
    assert entry[1] is not None
    figures, state = entry[1]
    return f"{figures.title}, {gettext(SOLUTION_NAMES[state.name])}"


def _show_origin(label: QWidget, figures: ScannerSpecification | PosAccuracy | None) -> None:
    label.setText("" if figures is None else source_text(figures))
    label.setVisible(figures is not None)
    label.setProperty("role", "hint" if figures is not None and figures.unverified else "muted")
    label.style().polish(label)
