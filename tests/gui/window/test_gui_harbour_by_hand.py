"""Test of the harbour survey, calibrated by mouse and keyboard from its files to a report."""

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QFileDialog, QLineEdit, QPushButton, QWidget

from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.features.report.identity_dialog import IdentityDialog
from lispac.gui.project.status import DATA, REPORT, VALIDATE
from lispac.identity import REQUIRED_FIELDS
from lispac.workflow.project.projects import open_project
from tests.gui.by_hand import Hands
from tests.gui.import_support import drop
from tests.gui.support import WAIT_MS, Control, Key, Left, click, open_step, press, type_into

FILES = ("trajectory.sbet", "smrmsg.out", *(f"pass{k}.laz" for k in range(1, 7)))

LONG_WAIT_MS = 5 * WAIT_MS


def import_files(hands: Hands, source: Path, folder: Path) -> None:
    """Drop the files on the start page, and type the folder of the project."""

    def act(dialog: ImportDialog) -> bool:
        if dialog.work.busy or not dialog.table.rowCount():
            return False
        if dialog.folder.text() != str(folder):
            dialog.folder.selectAll()
            hands.bot.keyClicks(dialog.folder, str(folder))
            return False
        hands.bot.mouseClick(dialog.ok, Left)
        return True

    hands.answers.expect(ImportDialog, act)
    drop(hands.window, [source / name for name in FILES])
    hands.until(lambda: hands.window.document.project is not None)
    hands.until_dialogs_used()
    hands.rest()


def patiently(hands: Hands, done: Callable[[], bool]) -> None:
    """Wait for a result of all points, which takes minutes on a busy computer."""
    hands.bot.waitUntil(
        lambda: bool(hands.answers.trouble) or (done() and not hands.window.runner.active),
        timeout=LONG_WAIT_MS,
    )
    hands.rest()


def type_value(hands: Hands, field: QWidget, text: str) -> None:
    type_into(hands, field, text)
    hands.bot.keyClick(field, Key.Key_Tab)


def propose_and_accept(hands: Hands) -> None:
    """Propose targets with F5, and accept all of them."""
    press(hands, Key.Key_F5)
    panel = hands.window.targets.proposal
    patiently(hands, panel.accept_button.isVisible)
    click(hands, panel.accept_button)
    hands.rest()


def export_report(hands: Hands, path: Path) -> None:
    """Press the button of step 5, type the file and the missing details."""

    def fill_in(dialog: IdentityDialog) -> bool:
        for name in REQUIRED_FIELDS:
            type_into(hands, dialog.findChild(QLineEdit, f"identity_{name}"), f"the {name}")
        hands.bot.mouseClick(dialog.findChild(QPushButton, "identity_keep"), Left)
        return True

    def name_file(dialog: QFileDialog) -> bool:
        name = dialog.findChild(QLineEdit, "fileNameEdit")
        if name.text() != str(path):
            name.selectAll()
            hands.bot.keyClicks(name, str(path))
            return False
        hands.bot.keyClick(name, Key.Key_Return)
        return True

    hands.answers.expect(IdentityDialog, fill_in)
    hands.answers.expect(QFileDialog, name_file)
    open_step(hands, REPORT)
    click(hands, hands.window.report.report)
    hands.until_dialogs_used()
    hands.until(path.exists)
    hands.rest()


@pytest.mark.long
def test_the_harbour_survey_is_calibrated_by_mouse_and_keyboard(
    hands: Hands, shared_data: Path, tmp_path: Path
) -> None:
    source, folder = shared_data / "harbour", tmp_path / "harbour"
    truth = json.loads((source / "truth.json").read_text(encoding="utf-8"))
    import_files(hands, source, folder)
    window = hands.window
    open_step(hands, DATA)
    for field, value in zip(window.data.lever_arm.fields, truth["lever"], strict=True):
        type_value(hands, field, str(value))
    hands.rest()
    assert hands.project.settings.lever_arm == pytest.approx(truth["lever"])
    propose_and_accept(hands)
    assert len(hands.project.targets_of_role("target")) >= 2
    assert hands.project.targets_of_role("validation")

    press(hands, Key.Key_F9)
    patiently(hands, lambda: hands.project.result is not None or bool(window.document.refusal))
    patiently(hands, lambda: not window.document.awaits_checks)
    result = hands.project.result
    assert result is not None
    error = np.degrees(result.boresight) - truth["boresight_deg"]
    sigma = np.degrees(result.sigma)
    assert (np.abs(error) < 3 * sigma).all(), (error, sigma)
    assert sigma.max() < 0.05

    press(hands, Key.Key_F10)
    patiently(hands, lambda: bool(hands.project.validation))
    hands.rest()
    assert all(plane.after.rms < plane.before.rms for plane in hands.project.validation)
    open_step(hands, VALIDATE)
    fields = window.validate.acceptance.fields
    for name, text in (("rms", "1 m"), ("roll_sigma_deg", "0,05"), ("yaw_sigma_deg", "0.05")):
        type_value(hands, fields[name], text)
    assert hands.project.judgement.verdict == "pass"
    export_report(hands, tmp_path / "report.json")
    report = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert report["acceptance"]["verdict"] == "pass"
    shown = report["adjustment"]["boresight_deg"]
    assert [shown[axis] for axis in ("roll", "pitch", "yaw")] == pytest.approx(
        np.degrees(result.boresight)
    )
    press(hands, Key.Key_S, Control)
    assert open_project(folder).identity.vessel == "the vessel"
    assert not window.isWindowModified()
