"""Form for the limits of the search for a survey plan."""

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtCore import QLocale, Signal
from PySide6.QtWidgets import QFormLayout, QLineEdit, QWidget

from lispac.design.site import Site
from lispac.errors import InputError, LispacError
from lispac.gui import widgets
from lispac.gui.appearance import units
from lispac.gui.appearance.units import Base
from lispac.gui.widgets.number_field import BASES
from lispac.io.config.plan_file import TitledPlan
from lispac.language import N_, gettext
from lispac.messages import error

# name of the site's field: (label, unit, low, high, tip)
LIST_FIELDS = {
    "along": (N_("Board positions"), "m", -500.0, 500.0,
              N_("Board positions along the wall to be tried in the search, positive to the "
                 "right")),
    "heights": (N_("Board heights"), "m", -50.0, 200.0,
                N_("Board heights above the POS to be tried in the search")),
    "inclinations_deg": (N_("Board inclinations"), "deg", 0.0, 180.0,
                         N_("Board inclinations to be tried in the search: 90° is vertical, "
                            "smaller values lean back, larger values lean forward")),
    "headings_deg": (N_("Line headings"), "deg", -360.0, 360.0,
                     N_("Line headings to be tried in the search")),
    "distances": (N_("Line distances"), "m", 1.0, 200.0,
                  N_("Distances between line and site to be tried in the search")),
}  # fmt: skip
INCLINATIONS_DEG = (90.0, 60.0, 45.0, 120.0, 135.0)
"""Degrees from level, as in the site files that come with the program."""


def parse_numbers(
    text: str, what: str, unit: str, low: float, high: float, decimal: str = "."
) -> tuple[float, ...]:
    """Parse a typed list of numbers, separated by semicolons, blanks or commas.

    A comma is a decimal sign where it is one in the user's language.

    Raises
    ------
    InputError
        Where something is not a number, or out of range.
    """
    text = text.replace(";", " ").replace("−", "-")
    base = BASES.get(f" {unit}")
    shown, factor = unit, 1.0
    if base is not None:
        shown, factor = units.shown_unit(base).sign, units.shown_unit(base).factor
    parts = text.replace(",", " " if decimal == "." else ".").split()
    if not parts:
        raise InputError(error("window.no_numbers", field=what, unit=shown))
    found = []
    for part in parts:
        try:
            typed = float(part)
        except ValueError:
            raise InputError(
                error("window.not_a_number_in", field=what, text=part, unit=shown)
            ) from None
        value = units.snap_to_limits(typed / factor, base, low, high)
        if not low <= value <= high:
            raise InputError(
                error(
                    "window.out_of_range",
                    field=what,
                    text=units.localised(f"{typed:g}"),
                    low=units.localised(_limit_text(low, base)),
                    high=units.localised(_limit_text(high, base)),
                    unit=shown,
                )
            )
        found.append(value)
    return tuple(dict.fromkeys(found))


class LimitsForm(QWidget):
    """Form with the limits of a site; other values of a site file are kept."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._file: tuple[str, Site] | None = None
        self.lists: dict[str, QLineEdit] = {}
        self._values: dict[str, tuple[float, ...] | None] = {}
        """Values of each list; None where the text is not a list of numbers."""
        self._filled = {name: ("", ()) for name in LIST_FIELDS}
        """Text that was filled in and its values with all digits, until something is typed."""
        self.boards = _integer_field(
            "limit_boards", 0, 6, 2, gettext("Number of boards in the survey plan")
        )
        self.lines = _integer_field(
            "limit_lines", 2, 12, 6, gettext("Number of lines in the survey plan")
        )
        self.closest = widgets.number(
            "limit_closest", suffix=" m", decimals=1, low=0.0, high=100.0, step=0.5,
            tip=gettext("Minimum distance between a line and the wall"), ranged=True,
        )  # fmt: skip
        self.minutes = widgets.number(
            "limit_minutes", suffix=" min", decimals=0, low=1.0, high=1440.0, step=5.0,
            tip=gettext("Maximum time on site for all lines, turns included"), ranged=True,
        )  # fmt: skip
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        for label, field in (
            (gettext("Number of boards"), self.boards),
            (gettext("Number of lines"), self.lines),
            (gettext("Minimum distance to wall"), self.closest),
            (gettext("Maximum time on site"), self.minutes),
        ):  # fmt: skip
            form.addRow(label, field)
            field.valueChanged.connect(lambda _value: self.changed.emit())
        for name, (label, unit, low, high, tip) in LIST_FIELDS.items():
            field = QLineEdit()
            field.setObjectName(f"limit_{name}")
            base = BASES.get(f" {unit}")
            shown = unit if base is None else units.shown_unit(base).sign
            field.setAccessibleName(f"{gettext(label)}, {shown}")
            field.setToolTip(
                gettext(
                    "{tip}. Enter one or more numbers from {low} to {high} {unit}.",
                    tip=gettext(tip), low=units.localised(_limit_text(low, base)),
                    high=units.localised(_limit_text(high, base)), unit=shown,
                )
            )  # fmt: skip
            field.textChanged.connect(self._check_lists)
            self.lists[name] = field
            form.addRow(f"{gettext(label)} ({shown})", field)
        self._fill_fields(Site((0.0, 0.0, 0.0), 270.0, inclinations_deg=INCLINATIONS_DEG))

    def use_file(self, title: str, site: Site) -> None:
        """Use the limits of a site file."""
        self._file = (title, site)
        self._fill_fields(site)

    def use_form(self) -> None:
        """Use the wall and the system of the plan instead of a site file."""
        self._file = None
        self.changed.emit()

    @property
    def has_file(self) -> bool:
        """Whether the limits come from a site file."""
        return self._file is not None

    @property
    def file_text(self) -> str:
        """Text that says where the wall and the system come from."""
        if self._file is None:
            return gettext("The wall and the survey system are taken from the survey plan.")
        title, site = self._file
        text = gettext(
            "The wall and the survey system are taken from the site file “{title}”.", title=title
        )
        if not site.natural:
            return text
        names = [each.name for each in site.natural]
        existing = gettext("Existing targets on the site: {names:names}.", names=names)
        return f"{text} {existing}"

    def site(self, titled: TitledPlan) -> tuple[str, Site]:
        """Title and site of the search.

        Raises
        ------
        LispacError
            Where the values do not form a site.
        """
        if self._file is None:
            plan = titled.plan
            title = titled.title
            base = Site(titled.wall.middle, titled.wall.facing_deg, system=plan.system,
                        flatness=plan.flatness)  # fmt: skip
            base = replace(base, minutes_per_line=plan.interval / 60, time_on_site=float("inf"))
        else:
            title, base = self._file
        lists = {name: self._read_list(name) for name in LIST_FIELDS}
        return title, replace(
            base, boards=round(self.boards.value()), lines=round(self.lines.value()),
            closest=self.closest.value(), time_on_site=self.minutes.value(), **lists,
        )  # fmt: skip

    def input_error(self, titled: TitledPlan) -> str:
        """Text of the error in the form; empty if there is none."""
        try:
            self.site(titled)
        except LispacError as error:
            return str(error)
        return ""

    def _read_list(self, name: str) -> tuple[float, ...]:
        label, unit, low, high, _ = LIST_FIELDS[name]
        text, (filled, values) = self.lists[name].text(), self._filled[name]
        if text == filled:
            return values
        decimal = QLocale().decimalPoint()
        return parse_numbers(text, label, unit, low, high, decimal)

    def _fill_fields(self, site: Site) -> None:
        for field, value in (
            (self.boards, site.boards), (self.lines, site.lines), (self.closest, site.closest),
            (self.minutes, site.time_on_site),
        ):  # fmt: skip
            field.setValue(value)
        for name, field in self.lists.items():
            self._fill_list(name, field, tuple(getattr(site, name)))
        self.changed.emit()

    def _fill_list(self, name: str, field: QLineEdit, values: tuple[float, ...]) -> None:
        self._filled[name] = _list_text(values, LIST_FIELDS[name][1]), values
        field.setText(self._filled[name][0])

    def copy_state_from(self, former: "LimitsForm") -> None:
        """Copy the site file and the lists of another form, in the language in use."""
        self._file = former._file
        for name, field in self.lists.items():
            values = former._values[name]
            if values is None:
                field.setText(former.lists[name].text())
            else:
                self._fill_list(name, field, values)
        self.changed.emit()

    def _check_lists(self, _text: str) -> None:
        for name, field in self.lists.items():
            try:
                self._values[name] = self._read_list(name)
            except InputError:
                self._values[name] = None
            wrong = self._values[name] is None
            if field.property("wrong") != wrong:
                field.setProperty("wrong", wrong)
                field.style().unpolish(field)
                field.style().polish(field)
        self.changed.emit()


def _list_text(values: Sequence[float], unit: str) -> str:
    """Text of a list of numbers, in the user's language and unit."""
    decimal, base = QLocale().decimalPoint(), BASES.get(f" {unit}")
    between = ", " if decimal == "." else "; "
    shown = (f"{v:g}" if base is None else units.figure(v, base, "g") for v in values)
    return between.join(each.replace(".", decimal) for each in shown)


def _limit_text(value: float, base: Base | None) -> str:
    return f"{value:g}" if base is None else units.limit_text(value, base)


def _integer_field(name: str, low: int, high: int, value: int, tip: str):
    made = widgets.number(
        name, suffix="", decimals=0, low=low, high=high, step=1, tip=tip, ranged=True
    )
    made.setValue(value)
    return made
