"""Test the complete workflow with the real viewport, by mouse and keys, with a picture per step."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QImage

from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.projects import open_project
from tests.gui.support import WAIT_MS, Driver

Key, Left = Qt.Key, Qt.MouseButton.LeftButton
Control = Qt.KeyboardModifier.ControlModifier


def colours_of(path: Path) -> int:
    """How many different colours a picture has."""
    image = QImage(str(path)).convertToFormat(QImage.Format.Format_RGB32)
    pixels = np.frombuffer(image.constBits(), np.uint32)
    return len(np.unique(pixels))


@pytest.mark.long  # `test_gui_tutorial` covers the same workflow
def test_from_opening_to_the_report(real: Driver, demo_copy: Path, tmp_path: Path):
    window, viewport, bot = real.window, real.viewport, real.bot

    def picture(step: str) -> Path:
        path = tmp_path / f"{step}.png"
        bot.wait(400)
        assert window.grab().save(str(path))
        return path

    def ctrl_click(name: str) -> None:
        role, position = demo_seeds()[name]
        bot.keyClick(window, Key.Key_F6 if role == "target" else Key.Key_F7)
        bot.keyClick(window, Key.Key_3)
        clouds = np.concatenate([cloud.sample for cloud in window.scene.clouds.values()])
        away = np.linalg.norm(clouds - position, axis=1)
        viewport.fit(clouds[away < 3])
        bot.wait(300)
        aim = clouds[np.argmin(away)]  # a drawn point of the plane, not a gap between two
        x, y = (int(v) for v in viewport.to_pixels(aim[None])[0][:2])
        bot.mouseClick(viewport.canvas, Left, Control, QPoint(x, y))
        real.rest()
        assert window.controller.candidate is not None
        assert window.controller.candidate.name == name

    real.dialogs.path = demo_copy
    bot.keyClick(window, Key.Key_O, Control)
    real.rest()
    assert colours_of(picture("1-opened")) > 50

    ctrl_click("T1")
    picture("2-candidate")
    bot.keyClick(window, Key.Key_Escape)
    assert real.project.targets == ()
    for name in ("T1", "T2", "V1"):
        ctrl_click(name)
        bot.keyClick(window, Key.Key_Return)
    assert [(t.name, len(t.sightings)) for t in real.project.targets[:2]] == [("T1", 6), ("T2", 6)]
    picture("3-picked")

    bot.mouseClick(window.workflow.headers[2], Left)
    bot.mouseClick(window.adjust.estimate, Left)
    real.rest()
    result = real.project.result
    assert (np.abs(np.degrees(result.boresight) - real.project.truth_deg) < 0.1).all()
    picture("4-estimated")

    bot.keyClick(window, Key.Key_F10)
    bot.waitUntil(lambda: bool(real.project.validation), timeout=WAIT_MS)
    real.rest()
    picture("5-validated")

    real.dialogs.path = tmp_path / "calibration.pdf"
    bot.keyClick(window, Key.Key_E, Control)
    real.rest()
    assert real.dialogs.errors == []
    assert (tmp_path / "calibration.pdf").read_bytes().startswith(b"%PDF")

    bot.keyClick(window, Key.Key_S, Control)
    saved = open_project(demo_copy)
    assert saved.result.boresight == pytest.approx(result.boresight)
    assert not window.isWindowModified()
