"""The target just found, waiting for a yes or a no."""

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QFrame, QHBoxLayout

from lispac.doubles import overlap_words
from lispac.gui import units
from lispac.gui.language import say, say_message
from lispac.gui.panels import widgets
from lispac.gui.panels.line_lights import LineLights
from lispac.gui.tabbing import ENTERS
from lispac.project import Project, Target
from lispac.workflow.survey import Survey


class CandidateBox(QFrame):
    """The target just found, waiting for a yes or a no."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("candidate_box")
        self.setProperty("role", "candidate")
        layout = widgets.column(self, 10)
        self.title = widgets.label("", "heading", name="candidate_title")
        self.detail = widgets.label("", wrap=True, name="candidate_detail")
        layout.addWidget(self.title)
        layout.addWidget(self.detail)
        self.lights = LineLights("candidate_lights")
        layout.addWidget(self.lights)
        self.double = widgets.label("", "warning", wrap=True, name="candidate_double")
        layout.addWidget(self.double)
        self.accept = widgets.button(
            "Accept  ⏎", "accept_candidate", icon="check-bold", primary=True, tip="Enter"
        )
        self.reject = widgets.button("Reject  Esc", "reject_candidate", icon="close", tip="Esc")
        self.reject.installEventFilter(self)
        row = QHBoxLayout()
        row.addWidget(self.accept, 1)
        row.addWidget(self.reject, 1)
        layout.addLayout(row)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Leave Enter to "Reject" where that has the focus: it accepts from anywhere else."""
        if event.type() == QEvent.Type.ShortcutOverride and event.key() in ENTERS:
            event.accept()
            return True
        return super().eventFilter(watched, event)

    def fill(self, candidate: Target, project: Project, survey: Survey | None) -> None:
        """Say what was found, where not, and whether another target has the points already."""
        known = any(target.name == candidate.name for target in project.targets)
        lines = len(project.lines)
        what = "Target" if candidate.role == "target" else "Validation plane"
        again = " (in place of the present one)" if known else ""
        self.title.setText(say(f"{what} {candidate.name}{again}"))
        found = candidate.sightings
        points = sum(len(sighting.indices) for sighting in found)
        worst = max((sighting.rms for sighting in found), default=0.0)
        text = (
            f"Found on {len(found)} of {lines} lines: {points:,} points, "
            f"within {units.amount(1000 * worst, 'mm', '.1f')} RMS of their {candidate.shape}s."
        )
        if candidate.shape == "sphere" and survey is not None:
            text += f" {_of_spheres(candidate, survey)}"
        if survey is not None:
            text += _unexpected(candidate, survey)
        if candidate.missing:
            text += f" Not found on {', '.join(candidate.missing)}."
        self.detail.setText(say(text))
        self.detail.setToolTip(
            widgets.plain_tip(
                "\n".join(
                    f"{line}: {say_message(reason)}" for line, reason in candidate.missing.items()
                )
            )
        )
        self.lights.show_target(candidate)
        double = overlap_words(candidate, project.targets)
        self.double.setText(say(double))
        self.double.setVisible(bool(double))


def _unexpected(target: Target, survey: Survey) -> str:
    """What differs from what is expected, on the first line where something does."""
    from lispac.workflow.qualities import unexpected

    if target.expected is None:
        return ""
    said = unexpected(target, survey)
    if not said:
        return " Size and inclination are as expected."
    line, words = next(iter(said.items()))
    others = f" ({len(said) - 1} more lines differ too)" if len(said) > 1 else ""
    return f" Not as expected on {line}: {' '.join(words)}{others}"


def _of_spheres(target: Target, survey: Survey) -> str:
    """Radius and share seen, over the lines."""
    from lispac.workflow.picking import spheres_of

    patches = spheres_of(target, survey).values()
    radii = [patch.sphere.radius for patch in patches]
    shares = [100 * patch.share for patch in patches]
    if target.sphere_radius is not None:
        radius = f"Radius {units.amount(target.sphere_radius, 'm', 'g')} (known)"
    else:
        low, high = (units.amount(end(radii), "m", ".3f") for end in (min, max))
        radius = f"Radius {low} to {high}"
    return f"{radius}; {min(shares):.0f} to {max(shares):.0f} % of the surface seen."
