"""Which values are estimated besides the boresight, and what is known of them."""

from dataclasses import dataclass, replace

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QDoubleSpinBox, QGridLayout, QLabel, QWidget

from lispac.adjustment.parameters import Parameter
from lispac.adjustment.shown import QUANTITIES
from lispac.gui import theme, units
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.fields import OptionalNumber
from lispac.gui.panels.number_field import ALIKE
from lispac.gui.units import Base
from lispac.language import gettext
from lispac.project import Settings


@dataclass(frozen=True)
class Kind:
    """A value of the mounting as the window shows it.

    Attributes
    ----------
    scale : shown units to one metre, radian or second
    decimals : of the value in its unit
    limit : largest value that can be typed, in its unit
    """

    name: str
    title: str
    unit: str
    scale: float
    decimals: int
    limit: float
    tip: str

    def text(self, value: float, *, signed: bool = True) -> str:
        """A figure in the unit shown with the sign of the base; `units.signs` puts the other."""
        form = f"{'+' if signed else ''}.{self.decimals}f"
        if self.unit in BASES:
            return (
                f"{units.figure(value * self.scale, BASES[self.unit], form)} {self.unit}".replace(
                    "-", "−"
                )
            )
        return f"{value * self.scale:{form}} {self.unit}".replace("-", "−")

    @property
    def bases(self) -> tuple[Base, ...]:
        """Its unit, where the user may choose another."""
        return (BASES[self.unit],) if self.unit in BASES else ()


BASES: dict[str, Base] = {"m": "m", "°": "°"}
_MEANING = {
    "lever_x": (100.0, "forward"),
    "lever_y": (100.0, "left"),
    "lever_z": (100.0, "up"),
    "range_offset": (10.0, "added to every range"),
    "scan_angle_offset": (360.0, "turns every beam about the scanner's X axis"),
    "latency": (1e4, "added to the time of every point before the trajectory is asked"),
}
KINDS: dict[str, Kind] = {
    name: Kind(
        name, each.title, each.unit.replace("deg", "°"), each.factor, each.decimals,
        *_MEANING[name],
    )
    for name, each in QUANTITIES.items()
}  # fmt: skip
LEVER = ("lever_x", "lever_y", "lever_z")
SCANNER = ("range_offset", "scan_angle_offset", "latency")


class ParameterSwitches(QWidget):
    """A row for each value: a switch, the value it starts from, and how well that is known."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.switches: dict[str, QCheckBox] = {}
        self.sigmas: dict[str, OptionalNumber] = {}
        self.priors: dict[str, QDoubleSpinBox] = {}
        self._lever: dict[str, QLabel] = {}
        self._shown: dict[str, float] = {}
        grid = QGridLayout(self)
        grid.setContentsMargins(8, 0, 0, 4)
        grid.setHorizontalSpacing(4)
        grid.setVerticalSpacing(3)
        for column, (word, tip) in enumerate(
            (("Prior", "The value it starts from"), ("± 1 σ", "How well that value is known"))
        ):
            head = widgets.label(word, "muted")
            head.setToolTip(say(tip))
            head.setAlignment(Qt.AlignmentFlag.AlignRight)
            grid.addWidget(head, 0, 1 + column)
        for row, kind in enumerate(KINDS.values(), start=1):
            switch = QCheckBox(say(kind.title.replace("Scan-angle offset", "Scan angle")))
            switch.setObjectName(f"estimate_{kind.name}")
            switch.setToolTip(say(f"Estimate the {_small(kind.title)} too ({kind.tip})"))
            switch.toggled.connect(self._switched)
            self.switches[kind.name] = switch
            grid.addWidget(switch, row, 0)
            grid.addWidget(self._prior(kind), row, 1)
            sigma = OptionalNumber(
                f"sigma_{kind.name}", f"Prior sigma of the {_small(kind.title)}", kind.unit,
                kind.scale, "not known",
                f"How well the prior {_small(kind.title)} is known, one standard deviation",
            )  # fmt: skip
            sigma.textChanged.connect(self.changed)
            sigma.setFixedWidth(78)
            self.sigmas[kind.name] = sigma
            grid.addWidget(sigma, row, 2)
        grid.setColumnStretch(0, 1)
        self._switched()

    def settings_of(self, settings: Settings) -> Settings:
        """The settings with what is chosen here.

        Raises
        ------
        InputError
        """
        chosen = tuple(
            Parameter(name, self.sigmas[name].value())
            for name, switch in self.switches.items()
            if switch.isChecked()
        )
        value = {name: self._value(name) for name in SCANNER}
        return replace(
            settings,
            parameters=chosen,
            range_offset=value["range_offset"],
            scan_angle_offset_deg=value["scan_angle_offset"],
            latency=value["latency"],
        )

    def show_settings(self, settings: Settings) -> None:
        """Fill in, without telling anyone."""
        sigma = {parameter.name: parameter.sigma for parameter in settings.parameters}
        for name, switch in self.switches.items():
            switch.blockSignals(True)
            switch.setChecked(name in sigma)
            switch.blockSignals(False)
            self.sigmas[name].show_value(sigma.get(name))
        for name, metres in zip(LEVER, settings.lever_arm, strict=True):
            self._lever[name].setText(units.signs(say(KINDS[name].text(metres)), "m"))
        self._shown = dict(
            zip(
                SCANNER,
                (settings.range_offset, settings.scan_angle_offset_deg, settings.latency),
                strict=True,
            )
        )
        for name in SCANNER:
            field = self.priors[name]
            field.blockSignals(True)
            field.setValue(self._shown[name] * _scale(name))
            field.blockSignals(False)
        self._enable()

    @property
    def summary(self) -> str:
        """The chosen ones in a few words."""
        chosen = [KINDS[name].title for name, switch in self.switches.items() if switch.isChecked()]
        if len(chosen) > 2:
            return say(f"{len(chosen)} values")
        return ", ".join(say(_small(title)) for title in chosen) if chosen else gettext("none")

    def _prior(self, kind: Kind) -> QWidget:
        if kind.name in LEVER:
            shown = widgets.label("")
            shown.setFont(theme.tabular(shown.font()))
            shown.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            shown.setToolTip(say(f"Lever arm {kind.name[-1].upper()} as typed in step 1"))
            self._lever[kind.name] = shown
            return shown
        field = widgets.number(
            f"prior_{kind.name}", suffix=f" {kind.unit}", decimals=kind.decimals,
            low=-kind.limit, high=kind.limit, step=10 ** (1 - kind.decimals),
            tip=f"{kind.title} as it is known: {kind.tip}; used where not estimated too",
        )  # fmt: skip
        field.setFixedWidth(92)
        field.valueChanged.connect(self.changed)
        self.priors[kind.name] = field
        return field

    def _value(self, name: str) -> float:
        """Metres, degrees or seconds; what was not moved keeps all its figures."""
        typed, shown = self.priors[name].value(), self._shown.get(name, 0.0)
        if abs(typed - shown * _scale(name)) < ALIKE:
            return shown
        return typed / _scale(name)

    def _switched(self) -> None:
        self._enable()
        self.changed.emit()

    def _enable(self) -> None:
        for name, switch in self.switches.items():
            self.sigmas[name].setEnabled(switch.isChecked())


def _scale(name: str) -> float:
    """Shown units to one of `Settings`, which holds the scan-angle offset in degrees."""
    return 1.0 if name == "scan_angle_offset" else KINDS[name].scale


def _small(title: str) -> str:
    return title[0].lower() + title[1:]
