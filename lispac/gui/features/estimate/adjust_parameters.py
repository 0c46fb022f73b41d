"""Parameters estimated besides the boresight, with their priors."""

from dataclasses import dataclass, replace

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QDoubleSpinBox, QGridLayout, QLabel, QWidget

from lispac.adjustment.model.parameters import PARAMETER_DISPLAYS, Parameter
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.widgets.number_field import EQUAL_TOLERANCE
from lispac.gui.widgets.optional_number import OptionalNumber
from lispac.gui.widgets.result_tables import local_amount
from lispac.language import N_, Plural, gettext
from lispac.present.calibration.parameters import parameter_format
from lispac.project import Settings


@dataclass(frozen=True)
class MountingParameter:
    """Mounting parameter as shown in the window; texts are English.

    Attributes
    ----------
    title : name at the beginning of a sentence
    short_title : name for a switch
    summary : name within a list
    sigma_title : title of the field with the standard deviation of the prior
    scale : number of displayed units in one metre, radian or second
    decimals : decimals of the value in its unit
    limit : largest value that can be entered, in its unit
    """

    name: str
    title: str
    unit: str
    scale: float
    decimals: int
    limit: float
    short_title: str
    summary: str
    sigma_title: str
    tip: str

    def amount(self, value: float, *, signed: bool = True) -> str:
        """Text of a value with the unit shown, in the user's language."""
        form = parameter_format(self.name)
        return local_amount(value, form.signed if signed else form)


_LIMITS_AND_TEXTS = {
    "lever_x": (
        100.0, N_("Lever arm X"), N_("lever arm X"), N_("Prior σ of the lever arm X"),
        N_("Estimate the lever arm along X, positive forward"),
    ),
    "lever_y": (
        100.0, N_("Lever arm Y"), N_("lever arm Y"), N_("Prior σ of the lever arm Y"),
        N_("Estimate the lever arm along Y, positive left"),
    ),
    "lever_z": (
        100.0, N_("Lever arm Z"), N_("lever arm Z"), N_("Prior σ of the lever arm Z"),
        N_("Estimate the lever arm along Z, positive up"),
    ),
    "range_offset": (
        10.0, N_("Range offset"), N_("range offset"), N_("Prior σ of the range offset"),
        N_("Estimate a constant that is added to each range"),
    ),
    "scan_angle_offset": (
        360.0, N_("Scan-angle offset"), N_("scan-angle offset"),
        N_("Prior σ of the scan-angle offset"),
        N_("Estimate a rotation of all beams about the X axis of the scanner"),
    ),
    "latency": (
        1e4, N_("Latency"), N_("latency"), N_("Prior σ of the latency"),
        N_("Estimate a time offset that is added to the time of each point"),
    ),
}  # fmt: skip
"""Largest value that can be entered, short title, summary, title of the prior sigma, tooltip."""
PRIOR_TIPS = {
    "range_offset": N_("Prior range offset. It is also applied if it is not estimated."),
    "scan_angle_offset": N_("Prior scan-angle offset. It is also applied if it is not estimated."),
    "latency": N_("Prior latency. It is also applied if it is not estimated."),
}
PARAMETER_TITLES = {
    "lever_x": N_("Lever arm X"),
    "lever_y": N_("Lever arm Y"),
    "lever_z": N_("Lever arm Z"),
    "range_offset": N_("Range offset"),
    "scan_angle_offset": N_("Scan-angle offset"),
    "latency": N_("Latency"),
}
MOUNTING_PARAMETERS: dict[str, MountingParameter] = {
    name: MountingParameter(
        name, PARAMETER_TITLES[name], each.unit.replace("deg", "°"), each.factor, each.decimals,
        *_LIMITS_AND_TEXTS[name],
    )
    for name, each in PARAMETER_DISPLAYS.items()
}  # fmt: skip
SWITCH_TEXT_WIDTH_PX = 112
"""Width beyond which the text of a switch is wrapped, so that the panel keeps its width, pixels."""
LEVER_ARM_NAMES = ("lever_x", "lever_y", "lever_z")
SCANNER_PARAMETER_NAMES = ("range_offset", "scan_angle_offset", "latency")


class ParameterSwitches(QWidget):
    """Rows of parameters, each with a switch, the prior and its standard deviation."""

    changed = Signal()
    """A value is being changed."""
    committed = Signal()
    """A value was changed."""

    def __init__(self) -> None:
        super().__init__()
        self.switches: dict[str, QCheckBox] = {}
        self.sigmas: dict[str, OptionalNumber] = {}
        self.priors: dict[str, QDoubleSpinBox] = {}
        self._lever: dict[str, QLabel] = {}
        self._shown: dict[str, float] = {}
        grid = QGridLayout(self)
        grid.setContentsMargins(4, 0, 0, 4)
        grid.setHorizontalSpacing(4)
        grid.setVerticalSpacing(3)
        for column, (title, tip) in enumerate(
            (
                (gettext("Prior"), gettext("Value before the adjustment")),
                (gettext("± 1 σ"), gettext("Standard deviation of the prior")),
            )
        ):
            head = widgets.label(title, "muted")
            head.setToolTip(tip)
            head.setAlignment(Qt.AlignmentFlag.AlignRight)
            grid.addWidget(head, 0, 1 + column)
        for row, kind in enumerate(MOUNTING_PARAMETERS.values(), start=1):
            title = gettext(kind.short_title)
            switch = QCheckBox()
            switch.setText(widgets.in_lines(title, switch.fontMetrics(), SWITCH_TEXT_WIDTH_PX))
            switch.setAccessibleName(title)
            switch.setObjectName(f"estimate_{kind.name}")
            switch.setToolTip(gettext(kind.tip))
            switch.toggled.connect(self._on_switched)
            self.switches[kind.name] = switch
            grid.addWidget(switch, row, 0)
            grid.addWidget(self._prior_field(kind), row, 1)
            sigma = OptionalNumber(
                f"sigma_{kind.name}", gettext(kind.sigma_title), kind.unit, kind.scale,
                gettext("unknown"), gettext("Standard deviation of the prior"),
            )  # fmt: skip
            sigma.textChanged.connect(self.changed)
            sigma.committed.connect(self.committed)
            sigma.setFixedWidth(78)
            self.sigmas[kind.name] = sigma
            grid.addWidget(sigma, row, 2)
        grid.setColumnStretch(0, 1)
        self._on_switched()

    def with_chosen_values(self, settings: Settings) -> Settings:
        """Settings with the values of these rows.

        Raises
        ------
        InputError
            If a field contains an invalid value.
        """
        chosen = tuple(
            Parameter(name, self.sigmas[name].value())
            for name, switch in self.switches.items()
            if switch.isChecked()
        )
        value = {name: self._value(name) for name in SCANNER_PARAMETER_NAMES}
        return replace(
            settings,
            parameters=chosen,
            range_offset=value["range_offset"],
            scan_angle_offset_deg=value["scan_angle_offset"],
            latency=value["latency"],
        )

    def show_settings(self, settings: Settings) -> None:
        """Fill in the settings without emitting `changed`."""
        sigma = {parameter.name: parameter.sigma for parameter in settings.parameters}
        self.blockSignals(True)
        for name, switch in self.switches.items():
            switch.blockSignals(True)
            switch.setChecked(name in sigma)
            switch.blockSignals(False)
            self.sigmas[name].show_value(sigma.get(name))
        for name, metres in zip(LEVER_ARM_NAMES, settings.lever_arm, strict=True):
            self._lever[name].setText(MOUNTING_PARAMETERS[name].amount(metres))
        self._shown = dict(
            zip(
                SCANNER_PARAMETER_NAMES,
                (settings.range_offset, settings.scan_angle_offset_deg, settings.latency),
                strict=True,
            )
        )
        for name in SCANNER_PARAMETER_NAMES:
            field = self.priors[name]
            field.blockSignals(True)
            field.setValue(self._shown[name] * _unit_scale(name))
            field.blockSignals(False)
        self.blockSignals(False)
        self._enable_controls()

    @property
    def summary(self) -> str:
        """Text with the chosen parameters, or with their number."""
        chosen = [
            MOUNTING_PARAMETERS[name]
            for name, switch in self.switches.items()
            if switch.isChecked()
        ]
        if len(chosen) > 2:
            return gettext(Plural("{count:n} parameter", "{count:n} parameters"), count=len(chosen))
        return ", ".join(gettext(kind.summary) for kind in chosen) if chosen else gettext("none")

    def _prior_field(self, kind: MountingParameter) -> QWidget:
        if kind.name in LEVER_ARM_NAMES:
            shown = widgets.label("")
            shown.setFont(theme.tabular_font(shown.font()))
            shown.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            shown.setToolTip(gettext("Lever arm given in step 1"))
            self._lever[kind.name] = shown
            return shown
        field = widgets.number(
            f"prior_{kind.name}", suffix=f" {kind.unit}", decimals=kind.decimals,
            low=-kind.limit, high=kind.limit, step=10 ** (1 - kind.decimals),
            tip=gettext(PRIOR_TIPS[kind.name]), title=gettext(kind.title),
        )  # fmt: skip
        field.setFixedWidth(92)
        field.lineEdit().textChanged.connect(self.changed)
        field.committed.connect(self.committed)
        self.priors[kind.name] = field
        return field

    def _value(self, name: str) -> float:
        """Value in metres, degrees or seconds, with all digits if it was not changed."""
        typed, shown = self.priors[name].value(), self._shown.get(name, 0.0)
        if abs(typed - shown * _unit_scale(name)) < EQUAL_TOLERANCE:
            return shown
        return typed / _unit_scale(name)

    def _on_switched(self) -> None:
        self._enable_controls()
        self.committed.emit()

    def _enable_controls(self) -> None:
        for name, switch in self.switches.items():
            self.sigmas[name].setEnabled(switch.isChecked())


def _unit_scale(name: str) -> float:
    """Factor from the unit of `Settings` to the unit shown."""
    return 1.0 if name == "scan_angle_offset" else MOUNTING_PARAMETERS[name].scale
