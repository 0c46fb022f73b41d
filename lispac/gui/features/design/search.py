"""Panel of the search for the best plan: limits, criterion and result."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from PySide6.QtCore import QLocale, Signal
from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QLineEdit, QScrollArea, QVBoxLayout, QWidget

from lispac.design.objective import CRITERION_TEXTS, PlanObjective
from lispac.design.site import Site
from lispac.errors import InputError, LispacError
from lispac.gui import widgets
from lispac.gui.app.unavailable import Unavailable, first_reason, reason_text
from lispac.gui.appearance import theme, units
from lispac.gui.features.design.workspace import Workspace
from lispac.gui.widgets.error_box import exception_text
from lispac.gui.widgets.field_transfer import copy_fields
from lispac.gui.widgets.number_field import BASE_OF_SUFFIX
from lispac.gui.widgets.number_input import parse_number
from lispac.gui.widgets.result_tables import local_number
from lispac.io.config.plan_file import TitledPlan
from lispac.language import N_, LazyText, gettext
from lispac.messages import error
from lispac.present.tables import DEGREES
from lispac.simulation.closed_form_survey import Board

# name of the attribute of `Site`: (label, unit, smallest value, largest value, tip)
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
    "distances": (N_("Distances of lines from site"), "m", 1.0, 200.0,
                  N_("Distances of the lines from the centre of the site to be tried in the "
                     "search")),
}  # fmt: skip
UNIT_SIGNS = {"deg": "°"}
"""Sign of a unit that is shown as a word."""
_BEFORE_UNIT = re.compile(r"(?<=\d)[^\S\n]+(?=[^\W\d_]|[°′″'\"])")
"""Blanks between a number and its unit."""
_SEPARATORS = re.compile(r"[;\s]+")
_DECIMAL_COMMA = re.compile(r"[+\-−]?\d+,\d+(?:[eE][+\-]?\d+)?\D*")
"""Number with a comma, and perhaps a unit."""
DEFAULT_INCLINATIONS_DEG = (90.0, 60.0, 45.0, 120.0, 135.0)
"""Default inclinations from the horizontal, degrees, as in the supplied site files."""


def parse_numbers(
    text: str, what: str, unit: str, low: float, high: float, decimal: str = "."
) -> tuple[float, ...]:
    """Parse a typed list of numbers, separated by semicolons, blanks or commas.

    A number may have a unit. See `split_numbers` on commas.

    Raises
    ------
    InputError
        If a part of the text is not a number, is out of range, or may be one number or two.
    """
    base = BASE_OF_SUFFIX.get(f" {unit}")
    shown, factor = unit, 1.0
    if base is not None:
        shown, factor = units.shown_unit(base).sign, units.shown_unit(base).factor
    parts = split_numbers(text, what, decimal)
    if not parts:
        raise InputError(error("window.no_numbers", field=what, unit=shown))
    found = []
    for part in parts:
        typed = parse_number(part, UNIT_SIGNS.get(shown, shown))
        if typed is None:
            raise InputError(error("window.not_a_number_in", field=what, text=part, unit=shown))
        value = units.snap_to_limits(typed / factor, base, low, high)
        if not low <= value <= high:
            raise InputError(
                error(
                    "window.out_of_range",
                    field=what,
                    text=units.localised(units.plain_figure(typed, 10)),
                    low=units.localised(units.limit_text(low, base)),
                    high=units.localised(units.limit_text(high, base)),
                    unit=shown,
                )
            )
        found.append(value)
    return tuple(dict.fromkeys(found))


def split_numbers(text: str, what: str, decimal: str) -> list[str]:
    """Split a list into the texts of its numbers.

    A comma between two digits is the decimal sign if the numbers are separated by semicolons or
    blanks, or if ``decimal`` is a comma. Several commas without blanks, or a comma beside a decimal
    point, separate numbers.

    Raises
    ------
    InputError
        If a comma may be either.
    """
    spaced = _BEFORE_UNIT.sub("", text)
    words = [word for word in _SEPARATORS.split(spaced) if word]
    plain = [word.strip(",") for word in words]
    is_separated = len(words) > 1 or ";" in text
    is_separator = any(len(word) < len(each) for word, each in zip(plain, words, strict=True))
    parts = []
    for word in filter(None, plain):
        is_number = _DECIMAL_COMMA.fullmatch(word) is not None
        if is_number and (is_separator or (decimal == "." and not is_separated)):
            raise InputError(error("window.ambiguous_comma", field=what, text=word))
        is_one = is_number or (decimal == "," and "." not in word)
        parts += [word] if is_one else filter(None, word.split(","))
    return parts


class LimitsForm(QWidget):
    """Form with the limits of a site; other values of a site file are kept."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._file: tuple[str, Site] | None = None
        self.lists: dict[str, QLineEdit] = {}
        self._values: dict[str, tuple[float, ...] | None] = {}
        """Values of each list; None if the text is not a list of numbers."""
        self._filled = {name: ("", ()) for name in LIST_FIELDS}
        """Text that was filled in and its values with all digits, until the user edits it."""
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
            base = BASE_OF_SUFFIX.get(f" {unit}")
            shown = unit if base is None else units.shown_unit(base).sign
            field.setAccessibleName(f"{gettext(label)}, {shown}")
            field.setToolTip(
                gettext(
                    "{tip}. Enter one or more numbers from {low} to {high} {unit}.",
                    tip=gettext(tip), low=units.localised(units.limit_text(low, base)),
                    high=units.localised(units.limit_text(high, base)), unit=shown,
                )
            )  # fmt: skip
            field.textChanged.connect(self._check_lists)
            self.lists[name] = field
            form.addRow(f"{gettext(label)} ({shown})", field)
        self._fill_fields(Site((0.0, 0.0, 0.0), 270.0, inclinations_deg=DEFAULT_INCLINATIONS_DEG))

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
            If the values do not form a site.
        """
        if self._file is None:
            plan = titled.plan
            title = titled.title
            sigmas = [each.control_sigma for each in plan.targets if isinstance(each, Board)]
            known = [sigma for sigma in sigmas if sigma is not None]
            # Boards of a search are all alike: surveyed if all boards of the plan are
            control = max(known) if known and len(known) == len(sigmas) else None
            base = Site(titled.wall.middle, titled.wall.facing_deg, system=plan.system,
                        flatness=plan.flatness, control_sigma=control)  # fmt: skip
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
            return exception_text(error)
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
    decimal, base = QLocale().decimalPoint(), BASE_OF_SUFFIX.get(f" {unit}")
    between = ", " if decimal == "." else "; "
    shown = (f"{v:g}" if base is None else units.figure(v, base, "g") for v in values)
    return between.join(each.replace(".", decimal) for each in shown)


def _integer_field(name: str, low: int, high: int, value: int, tip: str):
    made = widgets.number(
        name, suffix="", decimals=0, low=low, high=high, step=1, tip=tip, ranged=True
    )
    made.setValue(value)
    return made


POS_ERROR_FACTORS = {
    N_("POS errors as specified"): (1.0,),
    N_("0.5, 1 and 2 times the specified POS errors"): (0.5, 1.0, 2.0),
}
"""Factors of the POS errors in a search, by the title of the choice."""


class SearchPanel(QScrollArea):
    """Form of the search, which emits the request of the user."""

    requested = Signal()
    cancel_requested = Signal()
    file_requested = Signal()

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self.setObjectName("design_search")
        self.setWidgetResizable(True)
        self._work, self._busy = workspace, False
        self._found: LazyText | None = None
        self.limits = LimitsForm()
        self.criterion = widgets.ChoiceBox(
            "search_criterion",
            list(map(gettext, CRITERION_TEXTS.values())),
            gettext("Quantity that the search minimises"),
        )
        self.factors = widgets.ChoiceBox(
            "search_factors",
            list(map(gettext, POS_ERROR_FACTORS)),
            gettext(
                "POS errors assumed in the search. If there are several levels, the mean "
                "result is minimised."
            ),
        )
        for choice in (self.criterion, self.factors):
            choice.setAccessibleName(choice.toolTip())
        self.plans = widgets.number(
            "search_plans", suffix="", decimals=0, low=100, high=1_000_000, step=1000,
            tip=gettext(
                "Approximate number of survey plans to evaluate, {low:n} to {high:n}. If fewer "
                "plans are possible, all are evaluated.", low=100, high=1_000_000,
            ),
        )  # fmt: skip
        self.plans.setValue(5000)
        self.plans.setGroupSeparatorShown(True)
        self.read = widgets.button(
            gettext("Open site file…"), "search_file", icon="folder-open-outline",
            tip=gettext("Read the wall, the survey system, the limits and the existing targets "
                        "from a site file"),
        )  # fmt: skip
        self.clear_file = widgets.button(
            gettext("Close site file"),
            "search_no_file",
            tip=gettext(
                "Use the wall and the survey system of the survey plan instead of those "
                "of the site file"
            ),
        )
        self.find = widgets.button(
            gettext("Find the best plan"), "search_find", primary=True,
            tip=gettext("Search in the background and replace this plan with the best one. Undo "
                        "restores this plan."),
        )  # fmt: skip
        self.cancel = widgets.button(
            gettext("Cancel"),
            "search_cancel",
            tip=gettext("Stop the search without changing the survey plan"),
        )
        self.about_file = widgets.label("", "muted", wrap=True, name="search_about_file")
        self.message_label = widgets.label("", "hint", wrap=True, name="search_message")
        self.message_label.hide()
        self.error_label = widgets.label("", "error", wrap=True, name="search_mistake")
        self._arrange()
        self.read.clicked.connect(lambda: self.file_requested.emit())
        self.clear_file.clicked.connect(self.limits.use_form)
        self.find.clicked.connect(lambda: self.requested.emit())
        self.cancel.clicked.connect(lambda: self.cancel_requested.emit())
        self.limits.changed.connect(self._check_limits)
        workspace.changed.connect(self._check_limits)
        self._check_limits()

    def _arrange(self) -> None:
        """Place the limits on the left, and all other fields and buttons on the right."""
        body = QWidget()
        left, right = QVBoxLayout(), QVBoxLayout()
        left.addWidget(self.limits)
        left.addStretch(1)
        form = QFormLayout()
        form.addRow(gettext("Quantity to minimise"), self.criterion)
        form.addRow(gettext("POS errors"), self.factors)
        form.addRow(gettext("Plans to evaluate"), self.plans)
        files = QHBoxLayout()
        files.addWidget(self.read)
        files.addWidget(self.clear_file)
        files.addStretch(1)
        buttons = QHBoxLayout()
        buttons.addWidget(self.find)
        buttons.addWidget(self.cancel)
        buttons.addStretch(1)
        right.addLayout(buttons)
        right.addWidget(self.error_label)
        right.addWidget(self.message_label)
        right.addLayout(form)
        right.addLayout(files)
        right.addWidget(self.about_file)
        right.addStretch(1)
        both = QHBoxLayout(body)
        both.setSpacing(20)
        for each in (left, right, form, files, buttons):  # else the outer spacing applies
            each.setSpacing(theme.SPACING)
        both.addLayout(left, 1)
        both.addLayout(right, 1)
        self.setWidget(body)

    @property
    def objective(self) -> PlanObjective:
        """Objective of the search."""
        factors = list(POS_ERROR_FACTORS.values())[self.factors.currentIndex()]
        return PlanObjective(list(CRITERION_TEXTS)[self.criterion.currentIndex()], factors)

    def show_found(self, result_text: LazyText | None) -> None:
        """Show the result of a search; None if there is no result."""
        self._found = result_text
        self.message_label.setText("" if result_text is None else str(result_text))
        self.message_label.setVisible(result_text is not None)

    def copy_state_from(self, former: "SearchPanel") -> None:
        """Copy the choices and the result of another panel."""
        copy_fields(former, self)
        self.limits.copy_state_from(former.limits)
        self.show_found(former._found)

    def show_busy(self, busy: bool) -> None:
        """Enable or disable the controls while a task runs."""
        self._busy = busy
        self.cancel.setEnabled(busy)
        self._check_limits()

    def _check_limits(self) -> None:
        mistake = self.limits.input_error(self._work.titled)
        self.error_label.setText(mistake)
        self.error_label.setVisible(bool(mistake))
        self.about_file.setText(self.limits.file_text)
        self.clear_file.setEnabled(self.limits.has_file)
        reason = first_reason(
            (bool(mistake), Unavailable.WRONG_VALUE), (self._busy, Unavailable.BUSY)
        )
        self.find.set_reason(reason_text(reason))


@dataclass(frozen=True)
class SearchResult:
    """Result of a search, converted to text in the language in use.

    Attributes
    ----------
    value : float, degrees
        Value of the objective.
    evaluated : int
        Number of plans that were evaluated.
    all_evaluated : bool
        Whether all possible plans were evaluated.
    """

    value: float
    objective: PlanObjective
    evaluated: int
    all_evaluated: bool

    def __str__(self) -> str:
        """The text in the language and the unit in use."""
        criterion = gettext(CRITERION_TEXTS[self.objective.criterion])
        unit = units.shown_unit("°").sign
        value = local_number(self.value, DEGREES) + (unit if unit in "°′″" else f" {unit}")
        if self.all_evaluated:
            return gettext(
                "The best of all {count:n} possible plans replaces the former plan ({criterion}: "
                "{value}). Undo restores the former plan.",
                criterion=criterion, value=value, count=self.evaluated,
            )  # fmt: skip
        return gettext(
            "The best of {count:n} evaluated plans replaces the former plan ({criterion}: "
            "{value}). Not all possible plans were evaluated. Undo restores the former plan.",
            criterion=criterion, value=value, count=self.evaluated,
        )  # fmt: skip
