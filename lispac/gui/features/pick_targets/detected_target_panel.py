"""The detected target, to be accepted or rejected."""

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QFrame, QHBoxLayout

from lispac.duplicate_targets import overlap_warning
from lispac.gui import widgets
from lispac.gui.appearance import units
from lispac.gui.features.pick_targets.line_lights import LineQualityIndicators
from lispac.gui.widgets.tab_order import ENTER_KEYS
from lispac.language import N_, Plural, gettext
from lispac.message_texts import message_text
from lispac.project import Project, Role, Shape, Target
from lispac.workflow.project.survey import Survey

TITLES: dict[Role, tuple[str, str]] = {
    "target": (N_("Target {name}"), N_("Target {name} (replaces the existing target)")),
    "validation": (
        N_("Validation plane {name}"),
        N_("Validation plane {name} (replaces the existing plane)"),
    ),
}
"""Titles of a new target and of one with a known name."""
FOUND_TEXTS: dict[Shape, str] = {
    "plane": N_(
        "Found in {found:n} of {lines:n} lines: {points:n} points, RMS distance to the plane "
        "at most {rms}."
    ),
    "sphere": N_(
        "Found in {found:n} of {lines:n} lines: {points:n} points, RMS distance to the sphere "
        "at most {rms}."
    ),
}


class DetectedTargetPanel(QFrame):
    """The detected target, to be accepted or rejected."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("candidate_box")
        self.setProperty("role", "candidate")
        layout = widgets.vertical_layout(self, 10)
        self.title = widgets.label("", "heading", name="candidate_title")
        self.detail = widgets.label("", wrap=True, name="candidate_detail")
        layout.addWidget(self.title)
        layout.addWidget(self.detail)
        self.lights = LineQualityIndicators("candidate_lights")
        layout.addWidget(self.lights)
        self.double = widgets.label("", "warning", wrap=True, name="candidate_double")
        layout.addWidget(self.double)
        self.accept = widgets.button(
            gettext("Accept  ⏎"), "accept_candidate", icon="check-bold", primary=True,
            tip=gettext("Enter"),
        )  # fmt: skip
        self.reject = widgets.button(
            gettext("Reject  Esc"), "reject_candidate", icon="close", tip=gettext("Esc")
        )
        self.reject.installEventFilter(self)
        row = QHBoxLayout()
        row.addWidget(self.accept, 1)
        row.addWidget(self.reject, 1)
        layout.addLayout(row)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Leave Enter to "Reject" where that has the focus; elsewhere it accepts."""
        if event.type() == QEvent.Type.ShortcutOverride and event.key() in ENTER_KEYS:
            event.accept()
            return True
        return super().eventFilter(watched, event)

    def fill(self, candidate: Target, project: Project, survey: Survey | None) -> None:
        """Show the lines with and without the target, and a target that shares its points."""
        known = any(target.name == candidate.name for target in project.targets)
        self.title.setText(gettext(TITLES[candidate.role][known], name=candidate.name))
        found = candidate.sightings
        worst = max((sighting.rms for sighting in found), default=0.0)
        sentences = [
            gettext(
                FOUND_TEXTS[candidate.shape],
                found=len(found), lines=len(project.lines),
                points=sum(len(sighting.indices) for sighting in found),
                rms=units.local_amount(1000 * worst, "mm", ".1f"),
            )
        ]  # fmt: skip
        if candidate.shape == "sphere" and survey is not None:
            sentences.append(_spheres_text(candidate, survey))
        if candidate.expected is not None and survey is not None:
            sentences.append(_comparison_text(candidate, survey))
        if candidate.missing:
            sentences.append(gettext("Not found in {lines:names}.", lines=list(candidate.missing)))
        self.detail.setText(" ".join(sentences))
        self.detail.setToolTip(
            widgets.plain_tip(
                "\n".join(
                    gettext("{line}: {reason}", line=line, reason=message_text(reason))
                    for line, reason in candidate.missing.items()
                )
            )
        )
        self.lights.show_target(candidate)
        overlap = overlap_warning(candidate, project.targets)
        self.double.setText("" if overlap is None else message_text(overlap))
        self.double.setVisible(overlap is not None)


def _comparison_text(target: Target, survey: Survey) -> str:
    """How the target differs from the expected one, on the first line with a difference."""
    from lispac.workflow.calibration.sighting_assessment import unexpected_deviations

    differences = unexpected_deviations(target, survey)
    if not differences:
        return gettext("Size and inclination agree with the expected values.")
    line, reasons = next(iter(differences.items()))
    text = gettext(
        "Differs from the expected size or inclination in {line}: {reasons}",
        line=line,
        reasons=" ".join(map(message_text, reasons)),
    )
    if len(differences) == 1:
        return text
    others = Plural(
        "It also differs in {count:n} other line.", "It also differs in {count:n} other lines."
    )
    return f"{text} {gettext(others, count=len(differences) - 1)}"


def _spheres_text(target: Target, survey: Survey) -> str:
    """Radius and visible part of the spheres over the lines."""
    from lispac.workflow.calibration.picking import spheres_of

    patches = spheres_of(target, survey).values()
    radii = [patch.sphere.radius for patch in patches]
    shares = [patch.share for patch in patches]
    if target.sphere_radius is not None:
        return gettext(
            "Known radius: {radius}. {lowest:percent.0} to {highest:percent.0} % of the "
            "surface is observed.",
            radius=units.local_amount(target.sphere_radius, "m", "g"),
            lowest=min(shares), highest=max(shares),
        )  # fmt: skip
    return gettext(
        "Radius: {smallest} to {largest}. {lowest:percent.0} to {highest:percent.0} % of the "
        "surface is observed.",
        smallest=units.local_amount(min(radii), "m", ".3f"),
        largest=units.local_amount(max(radii), "m", ".3f"),
        lowest=min(shares), highest=max(shares),
    )  # fmt: skip
