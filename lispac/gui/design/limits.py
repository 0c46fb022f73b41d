"""What a search may choose from, in a form: a list of numbers in each field."""

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtCore import QLocale, Signal
from PySide6.QtWidgets import QFormLayout, QLineEdit, QWidget

from lispac.design.site import Site
from lispac.errors import InputError, LispacError
from lispac.gui import units
from lispac.gui.language import local_number, say
from lispac.gui.panels import widgets
from lispac.gui.panels.number_field import BASES
from lispac.gui.units import Base
from lispac.io.plan_file import TitledPlan
from lispac.messages import error

# name of the site's field: (label, unit, low, high, tip)
LISTS = {
    "along": ("Boards along", "m", -500.0, 500.0, "Where boards may hang, to the right"),
    "heights": ("Boards up", "m", -50.0, 200.0, "Heights of boards above the POS"),
    "inclinations_deg": ("From level", "deg", 0.0, 180.0,
                         "Inclinations: 90 upright, less leans back, more forward"),
    "headings_deg": ("Headings", "deg", -360.0, 360.0, "That may be sailed"),
    "distances": ("Distances", "m", 1.0, 200.0, "At which a line may pass the site"),
}  # fmt: skip
LEANS = (90.0, 60.0, 45.0, 120.0, 135.0)
"""Degrees from level, as in the site files that come with the program."""


def numbers_of(
    text: str, what: str, unit: str, low: float, high: float, decimal: str = "."
) -> tuple[float, ...]:
    """A list of numbers as it is typed in the unit shown: apart by semicolons, blanks, or commas.

    A comma between digits is a decimal sign where the user's language has it as such.

    Raises
    ------
    InputError
        Something else stands there, or it is out of range.
    """
    text = text.replace(";", " ").replace("−", "-")
    base = BASES.get(f" {unit}")
    shown, factor = unit, 1.0
    if base is not None:
        shown, factor = units.unit(base).sign, units.unit(base).factor
    parts = text.replace(",", " " if decimal == "." else ".").split()
    if not parts:
        raise InputError(error("window.no_numbers", field=say(what), unit=shown))
    found = []
    for part in parts:
        try:
            typed = float(part)
        except ValueError:
            raise InputError(
                error("window.not_a_number_in", field=say(what), text=part, unit=shown)
            ) from None
        value = units.ended(typed / factor, base, low, high)
        if not low <= value <= high:
            raise InputError(
                error(
                    "window.out_of_range", field=say(what), text=local_number(f"{typed:g}"),
                    low=local_number(_end(low, base)), high=local_number(_end(high, base)),
                    unit=shown,
                )
            )  # fmt: skip
        found.append(value)
    return tuple(dict.fromkeys(found))


class LimitsForm(QWidget):
    """The limits of a site; what a site file says besides stays as it is there."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._file: tuple[str, Site] | None = None
        self.lists: dict[str, QLineEdit] = {}
        self._values: dict[str, tuple[float, ...] | None] = {}
        """What is typed; none where that is no list of numbers."""
        self._filled = {name: ("", ()) for name in LISTS}
        """What was filled in, with all its digits, which stands as long as nothing is typed."""
        self.boards = _whole("limit_boards", 0, 6, 2, "Boards that are hung")
        self.lines = _whole("limit_lines", 2, 12, 6, "Lines that are sailed")
        self.closest = widgets.number(
            "limit_closest", suffix=" m", decimals=1, low=0.0, high=100.0, step=0.5,
            tip="No line comes nearer to the wall than this", ranged=True,
        )  # fmt: skip
        self.minutes = widgets.number(
            "limit_minutes", suffix=" min", decimals=0, low=1.0, high=1440.0, step=5.0,
            tip="Time on site for lines", ranged=True,
        )  # fmt: skip
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        for label, field in (
            ("Boards", self.boards), ("Lines", self.lines), ("Off the wall", self.closest),
            ("Time on site", self.minutes),
        ):  # fmt: skip
            form.addRow(say(label), field)
            field.valueChanged.connect(lambda _value: self.changed.emit())
        for name, (label, unit, low, high, tip) in LISTS.items():
            field = QLineEdit()
            field.setObjectName(f"limit_{name}")
            base = BASES.get(f" {unit}")
            told = say(f"{tip}; a list of numbers, {_ends(low, high, base)} {unit}")
            field.setAccessibleName(_in_units(say(f"{label}, {unit}"), base))
            field.setToolTip(told if base is None else units.signs(told, base))
            field.textChanged.connect(self._judge)
            self.lists[name] = field
            form.addRow(_in_units(say(f"{label} ({unit})"), base), field)
        self._fill(Site((0.0, 0.0, 0.0), 270.0, inclinations_deg=LEANS))

    def use_file(self, title: str, site: Site) -> None:
        """Limits from a site file."""
        self._file = (title, site)
        self._fill(site)

    def use_form(self) -> None:
        """Forget the site file; wall and system are the plan's again."""
        self._file = None
        self.changed.emit()

    @property
    def file(self) -> str:
        """What the limits rest on, in words."""
        if self._file is None:
            return "Wall and system: the plan's."
        title, site = self._file
        there = ", ".join(each.name for each in site.natural)
        there = f" There anyway: {there}." if there else ""
        return f"Wall and system: the site file's, “{title}”.{there}"

    def site(self, titled: TitledPlan) -> tuple[str, Site]:
        """Title and site to search on.

        Raises
        ------
        LispacError
            What is typed makes no site.
        """
        if self._file is None:
            plan = titled.plan
            title = titled.title
            base = Site(titled.wall.middle, titled.wall.facing_deg, system=plan.system,
                        flatness=plan.flatness)  # fmt: skip
            base = replace(base, minutes_per_line=plan.interval / 60, time_on_site=float("inf"))
        else:
            title, base = self._file
        lists = {name: self._numbers(name) for name in LISTS}
        return title, replace(
            base, boards=round(self.boards.value()), lines=round(self.lines.value()),
            closest=self.closest.value(), time_on_site=self.minutes.value(), **lists,
        )  # fmt: skip

    def mistake(self, titled: TitledPlan) -> str:
        """What is wrong with what is typed; empty where nothing is."""
        try:
            self.site(titled)
        except LispacError as error:
            return str(error)
        return ""

    def _numbers(self, name: str) -> tuple[float, ...]:
        label, unit, low, high, _ = LISTS[name]
        text, (filled, values) = self.lists[name].text(), self._filled[name]
        if text == filled:
            return values
        decimal = QLocale().decimalPoint()
        return numbers_of(text, label, unit, low, high, decimal)

    def _fill(self, site: Site) -> None:
        for field, value in (
            (self.boards, site.boards), (self.lines, site.lines), (self.closest, site.closest),
            (self.minutes, site.time_on_site),
        ):  # fmt: skip
            field.setValue(value)
        for name, field in self.lists.items():
            self._fill_list(name, field, tuple(getattr(site, name)))
        self.changed.emit()

    def _fill_list(self, name: str, field: QLineEdit, values: tuple[float, ...]) -> None:
        self._filled[name] = _apart(values, LISTS[name][1]), values
        field.setText(self._filled[name][0])

    def take_over(self, former: "LimitsForm") -> None:
        """Take the site file and the lists of another one, written as numbers are written now."""
        self._file = former._file
        for name, field in self.lists.items():
            values = former._values[name]
            if values is None:
                field.setText(former.lists[name].text())
            else:
                self._fill_list(name, field, values)
        self.changed.emit()

    def _judge(self, _text: str) -> None:
        for name, field in self.lists.items():
            try:
                self._values[name] = self._numbers(name)
            except InputError:
                self._values[name] = None
            wrong = self._values[name] is None
            if field.property("wrong") != wrong:
                field.setProperty("wrong", wrong)
                field.style().unpolish(field)
                field.style().polish(field)
        self.changed.emit()


def _apart(values: Sequence[float], unit: str) -> str:
    """Numbers as they are typed, in the user's language and unit."""
    decimal, base = QLocale().decimalPoint(), BASES.get(f" {unit}")
    between = ", " if decimal == "." else "; "
    shown = (f"{v:g}" if base is None else units.figure(v, base, "g") for v in values)
    return between.join(each.replace(".", decimal) for each in shown)


def _ends(low: float, high: float, base: Base | None) -> str:
    return f"{_end(low, base)} to {_end(high, base)}"


def _end(value: float, base: Base | None) -> str:
    return f"{value:g}" if base is None else units.limit(value, base)


def _in_units(said: str, base: Base | None) -> str:
    return said if base is None else units.signs(said, base, figures=False)


def _whole(name: str, low: int, high: int, value: int, tip: str):
    made = widgets.number(
        name, suffix="", decimals=0, low=low, high=high, step=1, tip=f"{tip}, {low} to {high}"
    )
    made.setValue(value)
    return made
