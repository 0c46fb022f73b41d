"""The detected target with the quality on each line, to be accepted or rejected."""

from collections.abc import Iterator, Mapping

from PySide6.QtCore import QEvent, QObject, QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QLabel, QSizePolicy, QWidget

from lispac.duplicate_targets import overlap_warning
from lispac.gui import widgets
from lispac.gui.app.unavailable import Unavailable
from lispac.gui.appearance import theme, units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.pick_targets.sightings_table import RATING_TEXTS, quality_text
from lispac.gui.widgets.result_tables import local_amount
from lispac.gui.widgets.tab_order import ENTER_KEYS
from lispac.language import N_, Plural, gettext
from lispac.messages import Message
from lispac.present.tables import MILLIMETRES
from lispac.project import PickedSighting, Project, Role, Shape, Target
from lispac.targets.sighting_quality import SightingQuality
from lispac.workflow.project.survey import Survey

ICON_SIZE_PX, ICON_GAP_PX = 16, 14
"""Size of a quality icon, and gap between two columns of lines, pixels."""
PENDING_ICON = "circle-outline"
LINE_POINTS_TEXT = Plural(
    "{line}: {count:n} point, {rms} RMS", "{line}: {count:n} points, {rms} RMS"
)


class LineQualityIndicators(QWidget):
    """Quality icons and names of the lines, in as many columns as fit."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(4)
        self._grid.setVerticalSpacing(3)
        self._cells: dict[str, tuple[PickedSighting, QLabel, QLabel]] = {}
        self._columns = 0

    def show_target(self, target: Target) -> None:
        """List the lines on which the target was found, with unknown quality."""
        for _, light, name in self._cells.values():
            for each in (light, name):
                each.hide()
                each.deleteLater()
        self._cells = {}
        for sighting in target.sightings:
            light, name = QLabel(self), QLabel(sighting.line, self)
            name.setTextFormat(Qt.TextFormat.PlainText)
            light.setObjectName(f"light_{sighting.line}")
            light.setFixedSize(ICON_SIZE_PX, ICON_SIZE_PX)
            name.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
            self._cells[sighting.line] = sighting, light, name
        self.show_qualities({})
        self._columns = 0
        self._arrange()

    def show_qualities(self, qualities: Mapping[str, SightingQuality]) -> None:
        """Show the quality of the lines for which it is known."""
        for line, (sighting, light, name) in self._cells.items():
            quality = qualities.get(line)
            icon = (
                theme.icon(PENDING_ICON, theme.MUTED)
                if quality is None
                else theme.quality_icon(quality.rating)
            )
            light.setPixmap(icon.pixmap(ICON_SIZE_PX, ICON_SIZE_PX))
            if quality is None:
                judgement = gettext("The quality is being computed")
            else:
                judgement = quality_text(quality)
            rms = local_amount(sighting.rms, MILLIMETRES)
            points = gettext(LINE_POINTS_TEXT, line=line, count=len(sighting.indices), rms=rms)
            for each in (light, name):
                each.setToolTip(widgets.plain_tip(f"{points}\n{judgement}"))
                each.setAccessibleName(f"{line}. {judgement}")

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Arrange the names for the new width."""
        super().resizeEvent(event)
        self._arrange()

    def _arrange(self) -> None:
        """Arrange the lines in rows, each column as wide as the longest name."""
        if not self._cells:
            return
        widest = max(name.sizeHint().width() for _, _, name in self._cells.values())
        columns = max(1, (self.width() + ICON_GAP_PX) // (ICON_SIZE_PX + 4 + widest + ICON_GAP_PX))
        columns = min(columns, len(self._cells))
        if columns == self._columns:
            return
        for k in range(2 * self._columns + 1):
            self._grid.setColumnStretch(k, 0)
            self._grid.setColumnMinimumWidth(k, 0)
        self._columns = columns
        left = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        for k, (_, light, name) in enumerate(self._cells.values()):
            row, column = divmod(k, columns)
            self._grid.addWidget(light, row, 2 * column, left)
            self._grid.addWidget(name, row, 2 * column + 1, left)
            self._grid.setColumnMinimumWidth(2 * column + 1, widest + ICON_GAP_PX - 8)
        self._grid.setColumnStretch(2 * columns, 1)


MAX_REASONS = 2
"""Largest number of lines of doubtful or poor quality that are shown with their reason; the others
are counted, and their reasons are in the tooltip."""
MORE_LINES_TEXT = Plural(
    "and {count:n} more line of doubtful or poor quality",
    "and {count:n} more lines of doubtful or poor quality",
)
TARGET_TITLES: dict[Role, tuple[str, str]] = {
    "target": (N_("Target {name}"), N_("Target {name} (replaces the existing target)")),
    "validation": (
        N_("Validation plane {name}"),
        N_("Validation plane {name} (replaces the existing plane)"),
    ),
}
"""Titles for a new target and for a target that exists already, by role."""
FOUND_TEXTS: dict[Shape, str] = {
    "plane": N_(
        "Found in {found:n} of {lines:n} lines: {points:n} points, RMS distance to the plane "
        "of each line at most {rms}."
    ),
    "sphere": N_(
        "Found in {found:n} of {lines:n} lines: {points:n} points, RMS distance to the sphere "
        "of each line at most {rms}."
    ),
}


class DetectedTargetPanel(QFrame):
    """Panel with the detected target, to be accepted or rejected."""

    grown = Signal()
    """Text was added, which may move the buttons out of view."""
    rated = Signal()
    """`is_poor` may have changed."""

    def __init__(self) -> None:
        super().__init__()
        self.is_poor = False
        """Whether every line of the detected target is rated poor."""
        self.setObjectName("candidate_box")
        self.setProperty("role", "candidate")
        layout = widgets.vertical_layout(self, 10)
        self.title = widgets.label("", "heading", name="candidate_title")
        self.detail = widgets.label("", wrap=True, name="candidate_detail")
        layout.addWidget(self.title)
        layout.addWidget(self.detail)
        self.lights = LineQualityIndicators("candidate_lights")
        layout.addWidget(self.lights)
        self.reasons = widgets.label("", "warning", wrap=True, name="candidate_reasons")
        layout.addWidget(self.reasons)
        self.duplicate_warning = widgets.label("", "warning", wrap=True, name="candidate_double")
        layout.addWidget(self.duplicate_warning)
        self.accept = widgets.button(gettext("Accept  ⏎"), "accept_candidate", primary=True)
        self._show_default_button()
        self.reject = widgets.button(
            gettext("Reject  Esc"), "reject_candidate", icon="close", tip=gettext("Esc")
        )
        self.reject.installEventFilter(self)
        row = QHBoxLayout()
        row.addWidget(self.accept, 1)
        row.addWidget(self.reject, 1)
        layout.addLayout(row)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Let Enter press "Reject" if that has the focus; otherwise Enter accepts."""
        if event.type() == QEvent.Type.ShortcutOverride and event.key() in ENTER_KEYS:
            event.accept()
            return True
        return super().eventFilter(watched, event)

    def fill(self, candidate: Target, project: Project, survey: Survey | None) -> None:
        """Show the lines with and without the target, and a warning if it overlaps another one."""
        known = any(target.name == candidate.name for target in project.targets)
        self.title.setText(gettext(TARGET_TITLES[candidate.role][known], name=candidate.name))
        found = candidate.sightings
        worst = max((sighting.rms for sighting in found), default=0.0)
        sentences = [
            gettext(
                FOUND_TEXTS[candidate.shape],
                found=len(found), lines=len(project.lines),
                points=sum(len(sighting.indices) for sighting in found),
                rms=local_amount(worst, MILLIMETRES),
            )
        ]  # fmt: skip
        if candidate.shape == "sphere" and survey is not None:
            sentences.append(_spheres_text(candidate, survey))
        if candidate.expected is not None and survey is not None:
            sentences.append(_comparison_text(candidate, survey))
        sentences += _missing_sentences(candidate.missing)
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
        self.reasons.hide()
        self.is_poor = False
        self._show_default_button()
        overlap = overlap_warning(candidate, project.targets)
        self.duplicate_warning.setText("" if overlap is None else message_text(overlap))
        self.duplicate_warning.setVisible(overlap is not None)

    def show_qualities(self, qualities: Mapping[str, SightingQuality]) -> None:
        """Show the quality of the lines, and why some are not good."""
        self.lights.show_qualities(qualities)
        order = {"poor": 0, "doubtful": 1}
        rated = [(line, each) for line, each in qualities.items() if each.rating in order]
        rated.sort(key=lambda pair: order[pair[1].rating])
        every = [
            gettext(
                "{line}: {reason}", line=line,
                reason=message_text(each.reasons[0]) if each.reasons
                else gettext(RATING_TEXTS[each.rating]),
            )
            for line, each in rated
        ]  # fmt: skip
        texts, others = every[:MAX_REASONS], every[MAX_REASONS:]
        if others:
            texts.append(gettext(MORE_LINES_TEXT, count=len(others)))
        self.reasons.setText("\n".join(texts))
        self.reasons.setToolTip(widgets.plain_tip("\n".join(others)))
        is_new = bool(texts) and self.reasons.isHidden()
        self.reasons.setVisible(bool(texts))
        self.is_poor = bool(qualities) and all(q.rating == "poor" for q in qualities.values())
        self._show_default_button()
        self.rated.emit()
        if is_new:
            self.grown.emit()

    def _show_default_button(self) -> None:
        """Show whether Enter accepts the target: not if every line is rated poor."""
        accept = self.accept
        accept.setText(gettext("Accept") if self.is_poor else gettext("Accept  ⏎"))
        accept.setToolTip(Unavailable.POOR_CANDIDATE.text if self.is_poor else gettext("Enter"))
        accept.setIcon(theme.icon("check-bold", "" if self.is_poor else theme.ON_FILL))
        accept.setIconSize(QSize(ICON_SIZE_PX, ICON_SIZE_PX))
        if accept.property("primary") == self.is_poor:
            accept.setProperty("primary", not self.is_poor)
            accept.style().unpolish(accept)
            accept.style().polish(accept)
        if self.is_poor:
            accept.clearFocus()  # Enter would press the focused button


def _missing_sentences(missing: Mapping[str, Message]) -> Iterator[str]:
    """Lines without the target and the reasons, the most frequent first; equal ones together."""
    lines: dict[Message, list[str]] = {}
    for line, reason in missing.items():
        lines.setdefault(reason, []).append(line)
    for reason, names in sorted(lines.items(), key=lambda each: -len(each[1])):
        yield gettext("Not found in {lines:names}.", lines=names)
        yield message_text(reason)


def _comparison_text(target: Target, survey: Survey) -> str:
    """Text on differences from the expected size and inclination, in full for the first line."""
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
    """Text on the radii and visible parts of the spheres in all lines."""
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
