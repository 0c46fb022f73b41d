"""Tests of the sizes of dialogues on a small screen, in each language."""

from collections.abc import Iterator
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QRect
from PySide6.QtWidgets import QApplication, QDialog, QLabel
from pytestqt.qtbot import QtBot

from lispac.gui.app.language import set_language
from lispac.gui.appearance import theme
from lispac.gui.features.design.number_table import NumberTable
from lispac.gui.features.design.plan_tables import TARGET_FIELDS
from lispac.gui.features.help.dialogs import shortcuts_box
from lispac.gui.features.report.identity_dialog import IdentityDialog
from lispac.gui.features.studies.check_dialog import CheckDialog
from lispac.gui.features.studies.study_dialog import StudyDialog
from lispac.gui.features.studies.visibility_dialog import VisibilityDialog
from lispac.identity import EMPTY_IDENTITY, REQUIRED_FIELDS
from lispac.language import LANGUAGES
from lispac.project import Project
from lispac.simulation.visibility_study import VisibilityStudy
from tests.gui.support import Demo

SCREEN = QRect(0, 0, 1366, 768)
TITLE_BAR_PX = 40


@pytest.fixture(params=LANGUAGES)
def _language(request: pytest.FixtureRequest, qapp: QApplication) -> Iterator[None]:
    """Language of the dialogues that are created during the test."""
    theme.apply_theme(qapp)
    set_language(request.param)
    yield
    set_language("en")


@pytest.fixture(autouse=True)
def _small_screen(monkeypatch: pytest.MonkeyPatch, _language: None) -> None:
    screen = SimpleNamespace(availableGeometry=lambda: QRect(SCREEN))
    monkeypatch.setattr(QDialog, "screen", lambda _self: screen)


def shown(qtbot: QtBot, dialog: QDialog) -> QRect:
    """Geometry of a dialogue after it was shown."""
    qtbot.addWidget(dialog)
    dialog.show()
    qtbot.waitExposed(dialog)
    return dialog.geometry()


@pytest.mark.parametrize("missing", [(), REQUIRED_FIELDS])
def test_the_details_of_the_report_fit_on_the_screen(
    qtbot: QtBot, missing: tuple[str, ...]
) -> None:
    dialog = IdentityDialog(EMPTY_IDENTITY, lambda: "", {}, {}, missing=missing)
    place = shown(qtbot, dialog)
    assert place.height() <= 700
    assert dialog.minimumSizeHint().height() <= 700
    fields = list(dialog.fields.values())
    assert dialog.rect().contains(dialog.keep.geometry())
    assert all(field.height() >= field.minimumSizeHint().height() for field in fields)


def test_the_list_of_keys_fits_on_the_screen(qtbot: QtBot) -> None:
    dialog = shortcuts_box(None)
    place = shown(qtbot, dialog)
    assert place.width() <= SCREEN.width()
    assert place.height() <= SCREEN.height() - TITLE_BAR_PX
    for column in dialog.findChildren(QLabel):
        assert column.height() >= column.sizeHint().height()
        assert column.height() >= column.heightForWidth(column.width())


@pytest.mark.parametrize("corner", [(0, 0), (600, 400), (1200, 700)])
def test_the_study_of_visibility_stays_on_the_screen(
    qtbot: QtBot, visibility_studies: list[VisibilityStudy], corner: tuple[int, int]
) -> None:
    dialog: StudyDialog = VisibilityDialog(visibility_studies)
    dialog.move(*corner)
    assert SCREEN.contains(shown(qtbot, dialog))
    buttons = dialog.copy_numbers, dialog.copy_picture
    assert all(dialog.rect().contains(each.geometry()) for each in buttons)


def test_the_columns_of_a_survey_plan_show_their_texts(qtbot: QtBot) -> None:
    table = NumberTable("targets", "Targets", TARGET_FIELDS)
    qtbot.addWidget(table)
    table.show_rows([["T1", -0.8, 0.0, 5.0, 90.0, 270.0, 1.23, 1.22, None, None]], 0)
    table.resize(985, 170)
    table.show()
    header = table.horizontalHeader()
    for k in range(table.columnCount()):
        assert header.sectionSize(k) >= header.sectionSizeHint(k)
        assert header.sectionSize(k) > table.sizeHintForColumn(k)
    assert header.length() == table.viewport().width()


def test_a_wrapped_text_leaves_no_gap_in_a_dialogue(qtbot: QtBot) -> None:
    dialog = IdentityDialog(EMPTY_IDENTITY, lambda: "", {}, {}, missing=REQUIRED_FIELDS)
    shown(qtbot, dialog)
    text = next(each for each in dialog.findChildren(QLabel) if each.wordWrap())
    assert text.height() <= text.heightForWidth(text.width()) + 2
    # Between the last field and the buttons there are only spacings
    last = dialog.fields["processing_software"]
    gap = dialog.keep.y() - last.mapTo(dialog, last.rect().bottomLeft()).y()
    assert 0 < gap <= 40


def test_the_check_against_a_reference_has_no_gaps(
    qtbot: QtBot, estimated: Project, demo: Demo
) -> None:
    dialog = CheckDialog(estimated, demo.survey.trajectory)
    shown(qtbot, dialog)
    text = next(each for each in dialog.findChildren(QLabel) if each.wordWrap())
    assert text.height() <= text.heightForWidth(text.width()) + 2
