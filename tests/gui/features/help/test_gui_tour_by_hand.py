"""Test the complete tour from the start page to its end, by mouse and keyboard alone."""

import shutil
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint

from lispac.gui.features.help.tour import TOUR_STEPS, VERDICT_TEXTS
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.projects import open_project
from tests.gui.by_hand import Hands, ctrl_click, shows_something
from tests.gui.support import Control, Demo, Key, click, press

TOUR_TARGETS = ("T1", "T2", "V1")
"""Names of the demo's targets in the order of the tour."""


def middle(hands: Hands) -> QPoint:
    """Middle of the view, to which the tour moves its current target."""
    hands.bot.wait(300)
    return hands.viewport.canvas.rect().center()


@pytest.mark.long  # `test_gui_start` follows the tour in every run
def test_the_tour_from_the_start_page_to_its_end(
    hands: Hands, denser_demo: Demo, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # In the thinner demo, no point is within a few pixels of the middle of the view
    demo_copy = Path(shutil.copytree(denser_demo.project.folder, tmp_path / "harbour"))
    monkeypatch.setattr("lispac.gui.project.controller.demo_folder", lambda: demo_copy)
    start, card = hands.window.central_widget.start, hands.window.central_widget.card

    def at(step: int) -> None:
        hands.until(lambda: card.head.text() == f"Tour, step {step} of {len(TOUR_STEPS)}")
        hands.rest()
        assert card.isVisible()

    assert start.isVisible()
    click(hands, start.links["tour"])
    at(1)
    ctrl_click(hands, middle(hands))
    at(2)
    press(hands, Key.Key_Return)
    at(3)
    ctrl_click(hands, middle(hands))
    press(hands, Key.Key_Return)
    at(4)
    press(hands, Key.Key_F9)
    at(5)
    press(hands, Key.Key_F7)
    ctrl_click(hands, middle(hands))
    press(hands, Key.Key_Return)
    at(6)
    press(hands, Key.Key_F10)
    at(7)
    assert card.text.text() == VERDICT_TEXTS["not judged"]
    assert hands.window.scene.which == "estimated"
    press(hands, Key.Key_B)
    hands.rest()
    assert hands.window.scene.which == "prior"
    shows_something(hands, tmp_path / "last-step.png")
    assert card.end.text() == "Close"
    click(hands, card.end)
    assert not card.isVisible()
    assert not hands.window.tour.is_running

    press(hands, Key.Key_S, Control)
    kept = open_project(demo_copy)
    assert len(kept.targets) == 3
    for target, (role, position) in zip(
        kept.targets, map(demo_seeds().get, TOUR_TARGETS), strict=True
    ):
        assert target.role == role
        assert np.linalg.norm(np.subtract(target.seed, position)) < 0.5, "another plane"
    off = np.degrees(kept.result.boresight) - kept.truth_deg
    assert (np.abs(off) < 3 * np.degrees(kept.result.sigma[:3])).all()
    assert (np.abs(off) < 0.1).all()
    assert kept.validation
    assert not hands.window.isWindowModified()
    shows_something(hands, tmp_path / "ended.png")
