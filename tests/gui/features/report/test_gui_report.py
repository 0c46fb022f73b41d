"""Tests of the report in the window: details, options, preview and pictures."""

import base64
import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import (
    QLabel,
    QLineEdit,
    QMessageBox,
    QPlainTextEdit,
    QPushButton,
    QScrollArea,
    QToolBar,
    QWidget,
)

from lispac.adjustment.result import VarianceComponent
from lispac.gui.app.settings import ReportChoice
from lispac.gui.features.report import report_export
from lispac.gui.features.report.identity_dialog import SURVEY_FIELDS, missing_details_text
from lispac.gui.features.report.report_export import report_file_name
from lispac.gui.features.report.report_panel import ReportPanel
from lispac.gui.features.report.report_pictures import LABEL_SCALE, PICTURE_SIZE_PX
from lispac.gui.project.status import VALIDATE
from lispac.gui.viewport.frame_times import FrameTimes
from lispac.gui.viewport.overlay import AXES_PX
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.gui.widgets import ChoiceBox
from lispac.identity import COMPANY_FIELDS, FIELD_NAMES, REQUIRED_FIELDS, Identity
from lispac.language import LANGUAGES, current_language, in_language
from lispac.present.calibration.sigmas import SIGMA_TITLES
from lispac.project import Project
from lispac.report.options import EXTENTS, ReportOptions
from lispac.targets.cross_section import common_normal
from lispac.workflow.calibration import sighting_assessment
from lispac.workflow.planning.sensors import read_library
from tests.gui.features.estimate.test_gui_diagnostics import turn_to
from tests.gui.support import (
    WAIT_MS,
    Demo,
    Driver,
    Key,
    Left,
    click,
    finish_layouts,
    in_front,
    open_step,
    show_panel,
    type_into,
    use_next_dialog,
)
from tests.report.test_report import _page, _pdf_text
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import is_shown

REPORT_STEP = 4
"""Index of the step of the workflow."""


def field(dialog: QWidget, name: str) -> QLineEdit | QPlainTextEdit:
    return dialog.findChild(QLineEdit, f"identity_{name}") or dialog.findChild(
        QPlainTextEdit, f"identity_{name}"
    )


def discard_details(driver: Driver, dialog: QWidget) -> None:
    """Press Escape in the details, and agree that what was typed is not kept."""

    def agree(box: QMessageBox) -> None:
        leave = next(b for b in box.buttons() if "without keeping" in b.text())
        driver.bot.mouseClick(leave, Left)

    use_next_dialog(agree)
    driver.bot.keyClick(dialog, Key.Key_Escape)


@LONG
def test_an_export_asks_once_for_the_details_that_a_signed_report_needs(
    adjusted: Driver, tmp_path: Path
) -> None:
    open_step(adjusted, REPORT_STEP)
    panel, dialogs = adjusted.window.report, adjusted.dialogs
    panel.opens.setChecked(False)
    dialogs.path, dialogs.fills_in_details = tmp_path / "report.html", True
    texts = {name: f"the {name}" for name in REQUIRED_FIELDS}
    edited = adjusted.project.identity.changed(**texts | {"vessel": "", "scanner": ""})
    measured = replace(adjusted.project.with_identity(edited), truth_deg=None)
    adjusted.window.document.edit("details", measured)
    assert panel.missing.isVisible()

    def cancel(dialog: QWidget) -> None:
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "identity_cancel"), Left)

    proposed = dialogs.proposed
    use_next_dialog(cancel)
    click(adjusted, panel.report)
    adjusted.rest()
    assert dialogs.proposed is proposed, "the file is asked for after the details"
    assert not dialogs.path.exists()

    def fill_in(dialog: QWidget) -> None:
        assert dialog.focusWidget() is field(dialog, "vessel")
        type_into(adjusted, field(dialog, "vessel"), "Nordlys")
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "identity_keep"), Left)

    use_next_dialog(fill_in)
    click(adjusted, panel.report)
    adjusted.rest()
    assert "Nordlys" in dialogs.path.read_text(encoding="utf-8")
    assert adjusted.project.identity.missing == ("scanner",)
    assert panel.missing.isVisible()
    dialogs.path = tmp_path / "second.html"
    click(adjusted, panel.report)  # no second dialogue
    adjusted.rest()
    assert dialogs.path.exists()
    # The set is that of the session: a rebuilt window, or the project opened again, does not ask
    renewed = adjusted.window.document.copy_for_new_window()
    assert renewed.folders_asked_for_details == {adjusted.project.folder}

    def fill_in_last(dialog: QWidget) -> None:
        assert dialog.focusWidget() is field(dialog, "scanner")
        assert dialog.findChild(QPushButton, "identity_keep").text() == "OK"
        type_into(adjusted, field(dialog, "scanner"), "Profiler 32")
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "identity_keep"), Left)

    use_next_dialog(fill_in_last)
    click(adjusted, panel.details)
    assert adjusted.project.identity.missing == ()
    assert not panel.missing.isVisible()


def test_the_exported_report_and_its_folder_are_opened_from_the_panel(
    adjusted: Driver, tmp_path: Path
) -> None:
    """The details are not asked for: the report on a simulated survey is not signed."""
    open_step(adjusted, REPORT_STEP)
    panel, dialogs = adjusted.window.report, adjusted.dialogs
    panel.opens.setChecked(False)
    dialogs.path, dialogs.fills_in_details = tmp_path / "report.html", True
    assert adjusted.project.identity.missing
    assert not panel.open_report.isEnabled()
    click(adjusted, panel.report)
    adjusted.rest()
    click(adjusted, panel.open_report)
    click(adjusted, panel.open_folder)
    assert dialogs.opened == [dialogs.path, tmp_path]
    dialogs.path.unlink()
    click(adjusted, panel.open_report)
    assert [each.code for each in dialogs.errors] == ["report.file_moved"]
    assert dialogs.opened == [dialogs.path, tmp_path]


def test_only_the_form_of_the_details_refers_to_its_asterisks(adjusted: Driver) -> None:
    open_step(adjusted, REPORT_STEP)
    document = adjusted.window.document
    document.edit("details", adjusted.project.with_identity(Identity()))
    assert str(len(REQUIRED_FIELDS)) in adjusted.window.report.missing.text()
    assert "*" not in adjusted.window.report.missing.text()

    def look(dialog: QWidget) -> None:
        assert "*" in dialog.findChild(QLabel, "identity_missing").text()
        labels = [each.text() for each in dialog.findChildren(QLabel)]
        assert len([each for each in labels if each.endswith(" *")]) == len(REQUIRED_FIELDS)
        adjusted.bot.keyClick(dialog, Key.Key_Escape)

    use_next_dialog(look)
    click(adjusted, adjusted.window.report.details)


def test_the_missing_details_are_counted_while_they_are_typed(adjusted: Driver) -> None:
    open_step(adjusted, REPORT_STEP)
    document = adjusted.window.document
    document.edit("details", adjusted.project.with_identity(Identity()))

    def fill_in(dialog: QWidget) -> None:
        banner, height = dialog.findChild(QLabel, "identity_missing"), 0
        for number, name in enumerate(REQUIRED_FIELDS):
            missing = REQUIRED_FIELDS[number:]
            assert banner.text() == missing_details_text(missing, in_form=True)
            height = height or banner.height()
            assert banner.height() == height
            assert banner.heightForWidth(banner.width()) <= height
            type_into(adjusted, field(dialog, name), "2026-03-04" if name == "dates" else "x")
        assert banner.text() == missing_details_text((), in_form=True)
        assert banner.property("role") == "success"
        first = field(dialog, REQUIRED_FIELDS[0])
        type_into(adjusted, first, " ")
        assert banner.text() == missing_details_text(REQUIRED_FIELDS[:1], in_form=True)
        assert banner.property("role") == "warning"
        discard_details(adjusted, dialog)

    use_next_dialog(fill_in)
    click(adjusted, adjusted.window.report.details)


def test_details_are_one_undo_step(adjusted: Driver) -> None:
    before = adjusted.project
    open_step(adjusted, REPORT_STEP)

    def use_dialog(dialog: QWidget) -> None:
        for name in FIELD_NAMES:
            type_into(adjusted, field(dialog, name), f"the {name}")
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "identity_keep"), Left)

    use_next_dialog(use_dialog)
    click(adjusted, adjusted.window.report.details)
    assert [getattr(adjusted.project.identity, name) for name in FIELD_NAMES] == [
        f"the {name}" for name in FIELD_NAMES
    ]
    assert adjusted.project.result is before.result
    assert adjusted.window.document.undo_stack.undoText() == "change of report details"
    assert adjusted.window.document.is_modified
    adjusted.window.document.undo_stack.undo()
    assert adjusted.project is before


def test_invalid_details_are_reported_and_cancel_changes_nothing(opened: Driver) -> None:
    open_step(opened, 0)
    before = opened.project

    def use_dialog(dialog: QWidget) -> None:
        label, keep = (
            dialog.findChild(QLabel, "identity_message"),
            dialog.findChild(QPushButton, "identity_keep"),
        )
        places = {field(dialog, name).mapTo(dialog, QPoint()).x() for name in FIELD_NAMES[:-1]}
        assert len(places) == 2  # two columns of aligned fields; the remarks are below
        dates = field(dialog, "dates")
        range_width = dates.fontMetrics().horizontalAdvance("2026-03-04 to 2026-03-06")
        assert dates.width() > range_width + 12
        type_into(opened, field(dialog, "vessel"), "V" * 201)
        assert label.text().startswith("Vessel: the text has 201 characters")
        assert not keep.isEnabled()
        type_into(opened, field(dialog, "vessel"), "V")
        assert label.text() == ""
        assert keep.isEnabled()
        buttons_at = keep.mapToGlobal(QPoint())
        type_into(opened, field(dialog, "vessel"), "V" * 201)
        finish_layouts()
        assert keep.mapToGlobal(QPoint()) == buttons_at
        assert label.height() >= label.heightForWidth(label.width())
        discard_details(opened, dialog)

    use_next_dialog(use_dialog)
    click(opened, opened.window.data.details)
    assert opened.project is before
    assert opened.window.document.undo_stack.count() == 0


@pytest.mark.parametrize("days", ["", "2026-03-04"])
def test_the_dates_of_the_lines_are_offered_if_the_lines_have_dates(
    opened: Driver, monkeypatch: pytest.MonkeyPatch, days: str
) -> None:
    if days:  # the lines of the demo have only the time of the week
        monkeypatch.setattr(report_export, "survey_dates", lambda *_: days)
    seen: list[tuple[bool, str, str]] = []

    def use_dialog(dialog: QWidget) -> None:
        take = dialog.findChild(QPushButton, "identity_dates_of_lines")
        opened.bot.mouseClick(take, Left)
        seen.append((take.isEnabled(), take.toolTip(), field(dialog, "dates").text()))
        if days:
            discard_details(opened, dialog)
        else:
            opened.bot.keyClick(dialog, Key.Key_Escape)

    open_step(opened, 0)
    use_next_dialog(use_dialog)
    click(opened, opened.window.data.details)
    ((is_enabled, tip, text),) = seen
    assert is_enabled == bool(days)
    assert text == days
    assert ("no date" in tip) != bool(days)


def choose(driver: Driver, box: ChoiceBox, index: int) -> None:
    """Choose an entry of a list with the keys."""
    box.setFocus()
    driver.bot.keyClick(box, Key.Key_Home)
    for _ in range(index):
        driver.bot.keyClick(box, Key.Key_Down)
    assert box.currentIndex() == index


def reopen(driver: Driver) -> None:
    driver.window.open_project(driver.project.folder)
    driver.rest()


@LONG
def test_an_exported_report_is_known_after_the_project_is_opened_again(
    adjusted: Driver, tmp_path: Path
) -> None:
    window = adjusted.window
    adjusted.dialogs.path = tmp_path / "copy"
    window.actions_["save_as"].trigger()
    adjusted.rest()
    open_step(adjusted, REPORT_STEP)
    adjusted.dialogs.path = tmp_path / "r.html"
    click(adjusted, window.report.report)
    adjusted.rest()
    header, advice = window.workflow.headers[REPORT_STEP].sentence, window.report.advice
    reopen(adjusted)
    assert header.text() == "exported: r.html"
    identity = adjusted.project.identity.changed(vessel="Adele")
    window.document.edit("vessel", adjusted.project.with_identity(identity))
    window.actions_["save"].trigger()
    reopen(adjusted)
    assert header.text() != "exported: r.html"
    assert "r.html" in advice.text()  # the project has changed since that report
    adjusted.dialogs.path = tmp_path / "r.html"
    window.actions_["report"].trigger()
    adjusted.rest()
    assert header.text() == "exported: r.html"
    (tmp_path / "r.html").unlink()
    reopen(adjusted)
    assert "r.html" not in advice.text()


def test_page_convention_and_template_are_used_and_stored(adjusted: Driver, tmp_path: Path) -> None:
    open_step(adjusted, REPORT_STEP)
    panel = adjusted.window.report
    template = tmp_path / "own.toml"
    template.write_text('heading = "Order 4711"\npage = "letter"\nconvention = "qinsy"\n')
    adjusted.dialogs.path = template
    click(adjusted, panel.findChild(QPushButton, "report_template_choose"))
    assert panel.options() == ReportOptions("letter", "qinsy", heading="Order 4711")
    names = [panel.convention.itemText(k) for k in range(panel.convention.count())]
    choose(adjusted, panel.convention, names.index("Applanix POS MV, LVX, POSPac (verified)"))
    choose(adjusted, panel.language, 2)
    adjusted.dialogs.path = tmp_path / "r.html"
    click(adjusted, panel.report)
    adjusted.rest()
    assert adjusted.dialogs.errors == []
    header = adjusted.window.workflow.headers[REPORT_STEP].sentence
    assert header.text() == "exported: r.html"
    adjusted.window.controller.rename("T1", "North wall")
    assert header.text() != "exported: r.html"  # the report belongs to another state of the project
    adjusted.window.document.undo_stack.undo()
    assert header.text() == "exported: r.html"
    text = (tmp_path / "r.html").read_text(encoding="utf-8")
    assert "Order 4711" in text
    assert "size: letter;" in text
    assert "Convention\u00a0: Applanix" in text
    assert 'lang="fr"' in text
    assert adjusted.window.settings.report_choice() == ReportChoice(
        str(template), "letter", "applanix", "fr", "short"
    )
    fresh = ReportPanel()
    fresh.show_choice(adjusted.window.settings.report_choice())
    assert fresh.options() == panel.options()
    click(adjusted, panel.no_template)
    assert panel.options() == ReportOptions("letter", "applanix", language="fr")


@LONG
def test_the_toolbar_uses_the_options_of_step_5(adjusted: Driver, tmp_path: Path) -> None:
    window, sizes = adjusted.window, []
    panel, toolbar = window.report, window.findChild(QToolBar, "toolbar")
    button = toolbar.widgetForAction(window.actions_["report"])
    for extent in range(len(EXTENTS)):
        open_step(adjusted, REPORT_STEP)
        choose(adjusted, panel.extent, extent)
        choose(adjusted, panel.language, 2)
        written = [tmp_path / f"{extent}{name}.html" for name in ("toolbar", "panel")]
        for path, press_button in zip(written, (button, panel.report), strict=True):
            adjusted.dialogs.path = path
            click(adjusted, press_button)
            adjusted.rest()
        texts = [re.sub(r"[0-9]+:[0-9]+|toolbar|panel", "", each.read_text()) for each in written]
        assert len(texts[0]) == len(texts[1])
        assert 'lang="fr"' in texts[0]
        sizes.append(len(texts[0]))
    assert len(set(sizes)) == len(EXTENTS)


def test_a_bad_template_is_reported_at_once_and_refused(adjusted: Driver, tmp_path: Path) -> None:
    open_step(adjusted, REPORT_STEP)
    panel = adjusted.window.report
    adjusted.dialogs.path = tmp_path / "own.toml"
    adjusted.dialogs.path.write_text("colour = 'red'")
    click(adjusted, panel.findChild(QPushButton, "report_template_choose"))
    assert is_shown("report_template.unknown_key", panel.template_error.text())
    assert panel.template_error.isVisible()
    click(adjusted, panel.report)
    (error,) = adjusted.dialogs.errors
    assert (error.code, error.message.params["key"]) == ("report_template.unknown_key", "colour")
    assert not adjusted.window.runner.active


def test_the_preview_shows_and_saves_every_page(adjusted: Driver, tmp_path: Path) -> None:
    open_step(adjusted, REPORT_STEP)
    panel = adjusted.window.report
    choose(adjusted, panel.page, 1)
    pictures: list[QPixmap] = []

    def use_dialog(dialog: QWidget) -> None:
        pages = [
            label for label in dialog.findChildren(QLabel)
            if label.objectName().startswith("preview_page_")
        ]  # fmt: skip
        assert pages[-1].pixmap().isNull()  # a page is decoded when it becomes visible
        for label in pages:
            label.grab()
        pictures.extend(label.pixmap() for label in pages)
        place = dialog.findChild(QLabel, "preview_place")
        adjusted.bot.waitUntil(lambda: place.text() == f"Page 1 of {len(pages)}")
        area = dialog.findChild(QScrollArea, "preview_pages")
        adjusted.bot.keyClick(area, Key.Key_End)
        assert place.text() == f"Page {len(pages)} of {len(pages)}"
        adjusted.bot.keyClick(area, Key.Key_Home)
        assert place.text().startswith("Page 1 ")
        adjusted.dialogs.path = tmp_path / "seen.pdf"
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "preview_save"), Left)
        assert "seen.pdf" in dialog.findChild(QLabel, "preview_message").text()
        adjusted.dialogs.path = None  # asked again, and cancelled
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "preview_save"), Left)
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "preview_close"), Left)

    use_next_dialog(use_dialog)
    click(adjusted, panel.preview)
    adjusted.rest()
    pdf = (tmp_path / "seen.pdf").read_bytes()
    assert pdf.startswith(b"%PDF")
    assert len(re.findall(rb"/Type ?/Page[^s]", pdf)) == len(pictures) > 1
    # Letter at 96 pixels an inch
    assert {(page.width(), page.height()) for page in pictures} == {(816, 1056)}
    assert b"[0 0 612 792]" in pdf
    assert adjusted.dialogs.errors == []
    assert adjusted.dialogs.requests == [f"{adjusted.project.name} boresight report.pdf"] * 2


def test_a_preview_that_cannot_be_saved_is_reported(adjusted: Driver, tmp_path: Path) -> None:
    open_step(adjusted, REPORT_STEP)
    (tmp_path / "file").write_text("")

    def use_dialog(dialog: QWidget) -> None:
        adjusted.dialogs.path = tmp_path / "file" / "r.pdf"
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "preview_save"), Left)
        assert dialog.findChild(QLabel, "preview_message").text() == ""
        adjusted.bot.keyClick(dialog, Key.Key_Escape)

    use_next_dialog(use_dialog)
    click(adjusted, adjusted.window.report.preview)
    adjusted.rest()
    (error,) = adjusted.dialogs.errors
    assert error.code == "file.not_writable"


@pytest.fixture
def picture_viewports(monkeypatch: pytest.MonkeyPatch) -> list[RecordingViewport]:
    """Return the viewports made for pictures."""
    made: list[RecordingViewport] = []

    def create(_self: RecordingViewport) -> RecordingViewport:
        made.append(RecordingViewport())
        return made[-1]

    monkeypatch.setattr(RecordingViewport, "create_empty_viewport", create)
    return made


def test_pictures_have_the_language_of_the_report(
    driver: Driver, demo: Demo, validated: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    languages: list[str] = []
    take = RecordingViewport.picture

    def picture(viewport: RecordingViewport, label_scale: float = 1.0) -> QImage:
        languages.append(current_language())
        return take(viewport, label_scale)

    monkeypatch.setattr(RecordingViewport, "picture", picture)
    driver.window.document.open(validated, demo.survey)
    driver.rest()
    open_step(driver, REPORT_STEP)
    panel = driver.window.report
    choose(driver, panel.language, 1 + list(LANGUAGES).index("fr"))
    driver.dialogs.path = tmp_path / "r.html"
    click(driver, panel.report)
    driver.rest()
    assert driver.dialogs.errors == []
    assert current_language() == "en"
    assert set(languages) == {"fr"}


@LONG
@pytest.mark.parametrize("extent", others_long(["short", "full"], lambda extent: extent == "full"))
def test_pictures_are_taken_from_defined_views_before_and_after(
    driver: Driver,
    demo: Demo,
    validated: Project,
    picture_viewports: list[RecordingViewport],
    tmp_path: Path,
    extent: str,
) -> None:
    driver.window.document.open(validated, demo.survey)
    driver.rest()
    open_step(driver, REPORT_STEP)
    panel, project = driver.window.report, driver.project
    choose(driver, panel.extent, list(EXTENTS).index(extent))
    scene = driver.window.scene
    driver.window.computations.show("prior")
    driver.rest()
    prior = dict(driver.viewport.clouds)
    seen = len(driver.viewport.calls)
    driver.dialogs.path = tmp_path / "r.html"
    click(driver, panel.report)
    driver.rest()
    assert driver.dialogs.errors == []
    # The view of the window is unchanged.
    names = {name for name, _ in driver.viewport.calls[seen:]}
    assert not {"fit", "view", "view_along", "set_parallel", "clip", "show_clouds"} & names
    assert scene.which == "prior"
    (viewport,) = picture_viewports
    assert viewport.closed
    compared = {plane.name for plane in project.validation}
    targets = [
        each.name
        for each in project.targets
        if each.name in compared or (extent == "full" and each.role == "target")
    ]
    assert compared & set(targets)
    views = ["Overview", *(f"{name} seen at 60° to its normal" for name in targets)]
    text = (tmp_path / "r.html").read_text(encoding="utf-8")
    captions = re.findall(r"<figcaption>([^<]*) the calibration<", text)
    assert captions == [f"{view}, {when}" for view in views for when in ("before", "after")]
    # Each label is at a point of its own target in that picture; a view of a surface has only one.
    labels: list[dict[str, tuple[float, float, float]]] = []
    for name, arguments in viewport.calls:
        if name == "show_markers":
            labels.append({each.label: each.position for each in arguments[0]})
    every = [each.name for each in project.targets]
    assert [list(each) for each in labels] == 2 * [every, *([name] for name in targets)]
    for k, shown_labels in enumerate(labels):
        clouds = scene.clouds_of("prior" if k < len(views) else "estimated")
        for target in project.targets:
            if target.name in shown_labels:
                points = np.concatenate(
                    [clouds[each.line][each.indices] for each in target.sightings]
                )
                position = np.array(shown_labels[target.name])
                nearest = np.linalg.norm(points - position, axis=1).min()
                assert nearest < 1e-6
                middle = points.mean(axis=0)
                least = np.linalg.norm(points - middle, axis=1).min()
                assert np.linalg.norm(position - middle) <= least + 1e-6
    shown: list[dict[str, np.ndarray]] = []
    cameras: list[list[tuple[str, tuple[object, ...]]]] = [[]]
    for name, arguments in viewport.calls:
        if name == "show_clouds":
            clouds = arguments[0]
        elif name in ("view", "view_along", "fit", "clip"):
            cameras[-1].append((name, arguments))
        elif name == "picture":
            shown.append(clouds)
            cameras.append([])
    assert len(shown) == 2 * len(views)
    # Axes and scale bar, which have the size of the labels, are below the points.
    strips = [given[0] for name, given in viewport.calls if name == "set_fit_margins"]
    assert len(strips) == len(shown)
    assert min(strips) >= LABEL_SCALE * AXES_PX
    first = next(iter(prior))
    np.testing.assert_array_equal(shown[0][first], prior[first])
    moved = np.linalg.norm(shown[-1][first] - prior[first], axis=1)
    # The prior boresight is some tenths of a degree off, at distances of some tens of metres
    assert 0.01 < np.median(moved) < 2.0
    # Before and after are seen with the same camera, and targets in a box.
    for k in range(len(views)):
        before, after = cameras[k], cameras[k + len(views)]
        assert [name for name, _ in before] == [name for name, _ in after]
        box = before[0][1][0]
        assert (box is None) == (k == 0)
        if box is not None:
            np.testing.assert_array_equal(box.corners, after[0][1][0].corners)
            direction, fitted = next(given for name, given in before if name == "view_along")
            np.testing.assert_array_equal(fitted, box.corners)  # all visible points
            normal = common_normal([np.asarray(before[1][1][1])])
            assert np.linalg.norm(direction) == pytest.approx(1.0)
            assert abs(direction @ normal) == pytest.approx(0.5, abs=0.05)


def test_real_pictures_show_the_calibration_of_a_validation_plane(
    real: Driver, demo: Demo, validated: Project, tmp_path: Path
) -> None:
    real.window.document.open(validated, demo.survey)
    real.rest()
    open_step(real, REPORT_STEP)
    real.dialogs.path = tmp_path / "r.html"
    click(real, real.window.report.report)
    real.rest()
    assert real.dialogs.errors == []
    text = (tmp_path / "r.html").read_text(encoding="utf-8")
    pictures = {}
    for data, caption in re.findall(
        r'data:image/png;base64,([^"]*)"[^>]*><figcaption>([^<]*)<', text
    ):
        image = QImage.fromData(base64.b64decode(data))
        assert (image.width(), image.height()) == PICTURE_SIZE_PX
        grey = image.convertToFormat(QImage.Format.Format_Grayscale8)
        pictures[caption] = np.frombuffer(grey.constBits(), np.uint8).astype(int)
    (name,) = (plane.name for plane in validated.validation)
    for view in ("Overview", f"{name} seen at 60° to its normal"):
        before, after = (
            pictures[f"{view}, {when} the calibration"] for when in ("before", "after")
        )
        assert before.std() > 5
        assert np.abs(after - before).mean() > 0.2


def test_an_edit_while_pictures_are_taken_cancels_the_report(
    adjusted: Driver, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    open_step(adjusted, REPORT_STEP)
    adjusted.dialogs.path = tmp_path / "r.html"
    taken: list[QImage] = []

    def edited_meanwhile(_self: RecordingViewport, _label_scale: float) -> QImage:
        edited = adjusted.project.with_identity(Identity(vessel="Nordlys"))
        adjusted.window.document.edit("change of report details", edited)
        taken.append(QImage(8, 8, QImage.Format.Format_RGB32))
        return taken[-1]

    monkeypatch.setattr(RecordingViewport, "picture", edited_meanwhile)
    click(adjusted, adjusted.window.report.report)
    adjusted.rest()
    assert adjusted.dialogs.errors == []
    assert len(taken) == 1
    assert not (tmp_path / "r.html").exists()


def test_cancelling_the_pictures_closes_their_viewport(
    adjusted: Driver,
    picture_viewports: list[RecordingViewport],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    open_step(adjusted, REPORT_STEP)
    adjusted.dialogs.path = tmp_path / "r.html"
    taken: list[QImage] = []

    def cancelled_meanwhile(_self: RecordingViewport, _label_scale: float) -> QImage:
        QTimer.singleShot(0, adjusted.window.runner.cancel)
        taken.append(QImage(8, 8, QImage.Format.Format_RGB32))
        return taken[-1]

    monkeypatch.setattr(RecordingViewport, "picture", cancelled_meanwhile)
    click(adjusted, adjusted.window.report.report)
    adjusted.rest()
    assert adjusted.dialogs.errors == []
    assert not (tmp_path / "r.html").exists()
    assert len(taken) == 1
    assert [viewport.closed for viewport in picture_viewports] == [True]


def test_hints_and_help_are_on_the_screen_but_not_in_pictures(
    real: Driver, demo: Demo, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The number of points in a picture depends on measured frame times, so it is fixed here
    monkeypatch.setattr(FrameTimes, "picture_points", property(lambda _: 20_000))
    real.window.document.open(demo.project, demo.survey)
    real.rest()
    overlay = real.viewport.widget.overlay

    def picture_bytes() -> bytes:
        image = real.viewport.picture()
        return bytes(image.constBits())

    def on_screen() -> bytes:
        image = overlay.grab().toImage()
        return bytes(image.constBits())

    plain, screen = picture_bytes(), on_screen()
    overlay.hint = "Click the first point"
    assert picture_bytes() == plain
    assert on_screen() != screen
    overlay.hint = ""
    assert on_screen() == screen
    shape = np.frombuffer(screen, np.uint8).reshape(overlay.height(), -1, 4)
    with_help = shape[-30:-20, 200:-300].astype(int)
    overlay.pictures = ()
    without = np.frombuffer(on_screen(), np.uint8).reshape(shape.shape)[-30:-20, 200:-300]
    assert (with_help != without).any()


def test_there_is_no_preview_without_a_result(opened: Driver) -> None:
    open_step(opened, REPORT_STEP)
    assert not opened.window.report.preview.isEnabled()


def test_each_extent_is_proposed_as_a_file_of_its_own_in_the_last_folder(
    adjusted: Driver, tmp_path: Path
) -> None:
    open_step(adjusted, REPORT_STEP)
    panel, dialogs, project = adjusted.window.report, adjusted.dialogs, adjusted.project
    panel.opens.setChecked(False)

    def proposed(extent: str) -> Path:
        choose(adjusted, panel.extent, list(EXTENTS).index(extent))
        adjusted.window.actions_["report"].trigger()
        adjusted.rest()
        return dialogs.proposed

    short, full = proposed("short"), proposed("full")
    assert short.parent == full.parent == project.folder
    assert short.suffix == full.suffix == ".pdf"
    assert short.name != full.name
    assert project.name in short.name
    assert project.name in full.name
    other = tmp_path / "deliverables"
    other.mkdir()
    dialogs.path = other / "report.json"
    assert proposed("short") == short  # exports to the other folder
    dialogs.path = None
    assert proposed("short") == other / short.name
    assert proposed("full") == other / full.name
    (other / "report.json").unlink()
    other.rmdir()
    assert proposed("short") == short


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_proposed_names_are_in_the_language_in_use(language: str) -> None:
    with in_language(language):
        names = {extent: report_file_name("Port 2", extent) for extent in EXTENTS}
    assert len(set(names.values())) == len(EXTENTS)
    for name in names.values():
        assert name.startswith("Port 2 ")
        assert name.endswith(".pdf")
        assert not set(name) & set('<>:"/\\|?*')
    assert ("boresight report" in names["short"]) == (language == "en")


@LONG
def test_the_report_is_opened_after_the_export(adjusted: Driver, tmp_path: Path) -> None:
    open_step(adjusted, REPORT_STEP)
    panel, dialogs = adjusted.window.report, adjusted.dialogs
    choose(adjusted, panel.extent, 1)
    assert panel.options().extent == "full"
    dialogs.path = tmp_path / "r.json"
    click(adjusted, panel.report)
    adjusted.rest()
    assert dialogs.opened == [tmp_path / "r.json"]
    dialogs.can_open = False
    click(adjusted, panel.report)
    adjusted.rest()
    assert "r.json" in adjusted.window.log.toPlainText().splitlines()[-1]
    assert dialogs.errors == []
    click(adjusted, panel.opens)
    click(adjusted, panel.report)
    adjusted.rest()
    assert len(dialogs.opened) == 2
    settings = adjusted.window.settings
    assert not settings.opens_report
    assert settings.report_choice().extent == "full"
    fresh = ReportPanel()
    fresh.show_choice(settings.report_choice())
    assert fresh.options() == panel.options()


def test_details_of_a_company_are_proposed_and_typed_texts_are_kept(adjusted: Driver) -> None:
    open_step(adjusted, REPORT_STEP)
    company = "Fleuve Surveys"  # keys of a test are ASCII
    last = {"surveyor": "Ève Tremblay", "checked_by": "Ana Ruiz", "scanner": "Profiler 16"}
    last |= {"client": "Harbour authority", "gnss_base": "NTRIP QUBC"}
    adjusted.window.settings.save_company(company, last)

    def use_dialog(dialog: QWidget) -> None:
        type_into(adjusted, field(dialog, "checked_by"), "Luc Roy")
        type_into(adjusted, field(dialog, "company"), company)
        assert field(dialog, "surveyor").text() == "Ève Tremblay"
        assert field(dialog, "gnss_base").text() == "NTRIP QUBC"
        assert field(dialog, "checked_by").text() == "Luc Roy"
        assert field(dialog, "vessel").text() == field(dialog, "client").text() == ""
        completer = field(dialog, "client").completer()
        completer.setCompletionPrefix("har")
        assert completer.currentCompletion() == "Harbour authority"
        type_into(adjusted, field(dialog, "company"), "Another company")
        assert field(dialog, "surveyor").text() == field(dialog, "scanner").text() == ""
        assert field(dialog, "checked_by").text() == "Luc Roy"
        type_into(adjusted, field(dialog, "company"), company)
        type_into(adjusted, field(dialog, "scanner"), "Profiler 32")
        type_into(adjusted, field(dialog, "contract"), "C-17")
        type_into(adjusted, field(dialog, "datum"), "NAD83")
        type_into(adjusted, field(dialog, "epoch"), "2010.0")
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "identity_keep"), Left)

    use_next_dialog(use_dialog)
    click(adjusted, adjusted.window.report.details)
    identity = adjusted.project.identity
    assert (identity.surveyor, identity.scanner) == ("Ève Tremblay", "Profiler 32")
    stored = adjusted.window.settings.companies()[company]
    assert (stored["scanner"], stored["checked_by"]) == ("Profiler 32", "Luc Roy")
    assert stored["contract"] == "C-17"
    frame = ("datum", "epoch", "gnss_base")
    assert [stored[name] for name in frame] == ["NAD83", "2010.0", "NTRIP QUBC"]
    assert set(stored) <= {*COMPANY_FIELDS, *SURVEY_FIELDS}
    limits = adjusted.window.validate.acceptance
    for value in ("5", "6"):
        type_into(adjusted, limits.fields["rms"], value)
        adjusted.bot.keyClick(limits.fields["rms"], Key.Key_Return)
        assert adjusted.project.acceptance.source == ("C-17" if value == "5" else "")
        adjusted.window.controller.change_acceptance({"source": ""})


def test_needed_details_are_marked_and_sensors_are_offered(adjusted: Driver) -> None:
    open_step(adjusted, REPORT_STEP)
    titles = [
        each.figures.title for each in read_library(adjusted.window.settings.sensors).scanners
    ]

    def use_dialog(dialog: QWidget) -> None:
        marked = {
            name
            for name in FIELD_NAMES
            if any(
                label.buddy() is field(dialog, name) and label.text().endswith("*")
                for label in dialog.findChildren(QLabel)
            )
        }
        assert marked == set(REQUIRED_FIELDS)
        scanner = field(dialog, "scanner")
        adjusted.bot.waitUntil(lambda: in_front(dialog), timeout=WAIT_MS)
        scanner.setFocus()
        adjusted.bot.keyClick(scanner, Key.Key_Down, Qt.KeyboardModifier.AltModifier)
        popup = scanner.completer().popup()
        adjusted.bot.waitUntil(popup.isVisible)
        model = popup.model()
        assert [model.index(k, 0).data() for k in range(model.rowCount())] == titles
        adjusted.bot.keyClick(popup, Key.Key_Down)
        adjusted.bot.keyClick(popup, Key.Key_Return)
        assert scanner.text() == titles[0]
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "identity_keep"), Left)

    use_next_dialog(use_dialog)
    click(adjusted, adjusted.window.report.details)
    assert adjusted.project.identity.scanner == titles[0]


def test_a_report_uses_the_qualities_that_the_window_knows(
    adjusted: Driver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_args: object, **_params: object) -> None:
        raise AssertionError("a sighting is assessed again")

    open_step(adjusted, REPORT_STEP)
    window = adjusted.window
    sightings = sum(len(target.sightings) for target in adjusted.project.targets)
    adjusted.bot.waitUntil(lambda: len(window.document.qualities) == sightings, timeout=WAIT_MS)
    monkeypatch.setattr(sighting_assessment, "_target_qualities", refuse)
    adjusted.dialogs.path = tmp_path / "report.html"
    window.report.opens.setChecked(False)
    click(adjusted, window.report.report)
    adjusted.rest()
    assert not adjusted.dialogs.errors
    assert adjusted.dialogs.path.exists()


def test_the_written_reports_agree_with_the_window(
    driver: Driver, demo: Demo, validated: Project, tmp_path: Path
) -> None:
    assert validated.result is not None
    settings = replace(
        validated.settings, position_sigma=(0.02, 0.02, 0.03), attitude_sigma_deg=(0.01, 0.01, 0.02)
    )
    component = VarianceComponent("POS position", 1.5, 1.2, 1.9, applied=True, used=1.5)
    result = replace(validated.result, components=(component,))
    given = replace(validated, accuracy=None, settings=settings, result=result)
    driver.window.document.open(given, demo.survey)
    driver.rest()
    open_step(driver, VALIDATE)
    limit = driver.window.validate.acceptance.fields["rms"]
    type_into(driver, limit, "0.1 mm")
    driver.bot.keyClick(limit, Key.Key_Return)
    driver.rest()
    open_step(driver, REPORT_STEP)
    panel = driver.window.report
    texts = {name: f"Zq{k:02}" for k, name in enumerate(FIELD_NAMES)}

    def use_dialog(dialog: QWidget) -> None:
        for name, text in texts.items():
            type_into(driver, field(dialog, name), text)
        driver.bot.mouseClick(dialog.findChild(QPushButton, "identity_keep"), Left)

    use_next_dialog(use_dialog)
    click(driver, panel.details)
    paths = {kind: tmp_path / f"report.{kind}" for kind in ("pdf", "html", "json")}
    for kind, path in paths.items():
        choose(driver, panel.extent, list(EXTENTS).index("short" if kind == "pdf" else "full"))
        driver.dialogs.path = path
        click(driver, panel.report)
        driver.rest()
    assert driver.dialogs.errors == []

    numbers = json.loads(paths["json"].read_text(encoding="utf-8"))
    assert numbers["acceptance"]["verdict"] == "fail"
    assert {name: numbers["identity"][name] for name in texts} == texts
    sigmas = numbers["settings"]["standard_deviations"]
    assert [each["source"] for each in sigmas] == ["given", "estimated", "given"]
    pages = _pdf_text(paths["pdf"]).rstrip("\f").split("\f")
    assert len(pages) <= 4
    for page in pages[1:]:
        assert texts["vessel"] in page
        assert texts["company"] in page
    bodies = "\n".join([pages[0], *(page.split("\n", 1)[1] for page in pages[1:])])
    body = paths["html"].read_text(encoding="utf-8").partition("<body")[2]
    html = " ".join(_page(body).words).replace("\u2212", "-")
    for name, text in texts.items():
        assert bodies.count(text) == 1, name
        assert html.count(text) == 1, name
    for text in (bodies, html):
        assert "NOT ACCEPTED" in text
        others = [re.escape(title) for title in SIGMA_TITLES.values()]
        for each, title in zip(sigmas, SIGMA_TITLES.values(), strict=True):
            row = re.split("|".join(others), text.partition(title)[2], maxsplit=1)[0][:160]
            is_estimated = "estimated from the data; given:" in row
            assert is_estimated == (each["source"] == "estimated"), row
            assert is_estimated or "(given)" in row, row
    (half,) = (
        each["difference_deg"]
        for each in numbers["cross_checks"]["parts"]
        if (each["kind"], each["part"]) == ("half", "second")
    )
    show_panel(driver.window, "Diagnostics")
    table = turn_to(driver, "Cross-checks").table
    row = next(k for k in range(table.rowCount()) if "half" in table.item(k, 0).text())
    in_html = html[html.index(table.item(row, 0).text()) :].split()
    for axis, column in (("roll", 1), ("pitch", 3), ("yaw", 5)):
        shown = table.item(row, column).text().replace("\u2212", "-")
        assert shown == f"{half[axis]:+.4f}"
        assert shown in in_html[:12]
