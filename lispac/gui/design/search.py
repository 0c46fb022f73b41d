"""Find the best plan: within which limits, what is to be small, and what was found."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QScrollArea, QVBoxLayout, QWidget

from lispac.design.objective import CRITERIA, Objective
from lispac.gui import theme, units
from lispac.gui.carrying import fill_in
from lispac.gui.design.limits import LimitsForm
from lispac.gui.design.told import sigma_words
from lispac.gui.design.workspace import Workspace
from lispac.gui.language import say
from lispac.gui.panels import widgets

FACTORS = {
    "POS as good as stated": (1.0,),
    "POS half to twice as poor": (0.5, 1.0, 2.0),
}


class SearchPanel(QScrollArea):
    """Asks for a search; the result is taken over by who runs it."""

    asked = Signal()
    cancel_asked = Signal()
    file_asked = Signal()

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self.setObjectName("design_search")
        self.setWidgetResizable(True)
        self._work, self._busy, self._found = workspace, False, ""
        self.limits = LimitsForm()
        self.criterion = widgets.Choice(
            "search_criterion", list(CRITERIA.values()), "What the best plan has smallest"
        )
        self.factors = widgets.Choice(
            "search_factors", list(FACTORS), "How good the POS will be on the day: the mean counts"
        )
        for choice in (self.criterion, self.factors):
            choice.setAccessibleName(choice.toolTip())
        self.plans = widgets.number(
            "search_plans", suffix="", decimals=0, low=100, high=1_000_000, step=1000,
            tip="About how many plans to look at where there are too many to look at all, "
            "100 to 1,000,000",
        )  # fmt: skip
        self.plans.setValue(5000)
        self.plans.setGroupSeparatorShown(True)
        self.read = widgets.button(
            "Site file…", "search_file", icon="folder-open-outline",
            tip="Read wall, system and limits of a site, and what stands there anyway",
        )  # fmt: skip
        self.forget = widgets.button(
            "Without file", "search_no_file", tip="Take wall and system of the plan again"
        )
        self.find = widgets.button(
            "Find the best plan", "search_find", primary=True,
            tip="Search in the background; the best plan becomes this plan, and one undo goes back",
        )  # fmt: skip
        self.cancel = widgets.button("Cancel", "search_cancel", tip="Stop; nothing is changed")
        self.about_file = widgets.label("", "muted", wrap=True, name="search_about_file")
        self.said = widgets.label("", "hint", wrap=True, name="search_said")
        self.said.hide()
        self.mistake = widgets.label("", "error", wrap=True, name="search_mistake")
        body = QWidget()
        left, right = QVBoxLayout(), QVBoxLayout()
        left.addWidget(self.limits)
        left.addStretch(1)
        form = QFormLayout()
        form.addRow(say("Smallest"), self.criterion)
        form.addRow(say("Expect"), self.factors)
        form.addRow(say("Plans"), self.plans)
        files = QHBoxLayout()
        files.addWidget(self.read)
        files.addWidget(self.forget)
        files.addStretch(1)
        buttons = QHBoxLayout()
        buttons.addWidget(self.find)
        buttons.addWidget(self.cancel)
        buttons.addStretch(1)
        right.addLayout(buttons)
        right.addWidget(self.mistake)
        right.addWidget(self.said)
        right.addLayout(form)
        right.addLayout(files)
        right.addWidget(self.about_file)
        right.addStretch(1)
        both = QHBoxLayout(body)
        both.setSpacing(20)
        for each in (left, right, form, files, buttons):  # else they take that of the whole
            each.setSpacing(theme.SPACE)
        both.addLayout(left, 1)
        both.addLayout(right, 1)
        self.setWidget(body)
        self.read.clicked.connect(lambda: self.file_asked.emit())
        self.forget.clicked.connect(self.limits.use_form)
        self.find.clicked.connect(lambda: self.asked.emit())
        self.cancel.clicked.connect(lambda: self.cancel_asked.emit())
        self.limits.changed.connect(self._judge)
        workspace.changed.connect(self._judge)
        self._judge()

    @property
    def objective(self) -> Objective:
        """What is to be small."""
        factors = list(FACTORS.values())[self.factors.currentIndex()]
        return Objective(list(CRITERIA)[self.criterion.currentIndex()], factors)

    def say(self, words: str) -> None:
        """Say what was found; empty before anything is."""
        self._found = words
        self.said.setText(units.signs(say(words), "°"))
        self.said.setVisible(bool(words))

    def take_over(self, former: "SearchPanel") -> None:
        """Take the choices of another one, and what it says was found."""
        fill_in(former, self)
        self.limits.take_over(former.limits)
        self.say(former._found)

    def show_busy(self, busy: bool) -> None:
        """Whether work runs."""
        self._busy = busy
        self.cancel.setEnabled(busy)
        self._judge()

    def _judge(self) -> None:
        mistake = self.limits.mistake(self._work.titled)
        self.mistake.setText(say(mistake))
        self.mistake.setVisible(bool(mistake))
        self.about_file.setText(say(self.limits.file))
        self.forget.setEnabled(not self.limits.file.endswith("plan's."))
        self.find.allow(not mistake and not self._busy)


def found_in_words(value_deg: float, objective: Objective, looked_at: int, exact: bool) -> str:
    """What a search found, in a sentence."""
    looked = f"{looked_at:,} plans looked at"
    looked += ", which is all there are" if exact else ", of many more"
    return (
        f"{CRITERIA[objective.criterion].capitalize()} is {sigma_words(value_deg)} deg; {looked}. "
        "The best plan is shown; undo goes back to the one before."
    )
