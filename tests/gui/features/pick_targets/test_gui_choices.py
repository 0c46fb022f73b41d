"""Tests of the minimum number of points and maximum tilt, in step 2 and in "Find again"."""

from dataclasses import replace
from math import radians

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QDoubleSpinBox, QPushButton, QToolButton, QWidget

from lispac.gui.window.main_window import MAX_TITLE_BAR_HEIGHT_PX
from lispac.targets.finder_settings import DEFAULT_CHOICES, FinderChoices
from tests.gui.features.pick_targets.test_gui_seed_coordinates import use_next_dialog
from tests.gui.support import WAIT_MS, Demo, Driver, Left, click, open_step, seed, type_into


def unfold(driver: Driver, parent: QWidget, name: str) -> None:
    head = parent.findChild(QToolButton, name)
    driver.bot.mouseClick(head, Left, pos=QPoint(8, head.height() // 2))


def field(parent: QWidget, name: str) -> QDoubleSpinBox:
    return parent.findChild(QDoubleSpinBox, name)


def test_choices_apply_to_the_next_seeds_and_are_shown_when_folded(opened: Driver) -> None:
    open_step(opened, 1)
    panel = opened.window.targets
    assert not field(panel, "seed_min_points").isVisible()
    assert panel.search_fields.fold.head.text() == "More settings"
    assert panel.seed_options.choices == DEFAULT_CHOICES
    unfold(opened, panel, "seed_more")
    type_into(opened, field(panel, "seed_min_points"), "50")
    type_into(opened, field(panel, "seed_max_tilt"), "8")
    unfold(opened, panel, "seed_more")
    assert not field(panel, "seed_min_points").isVisible()
    assert (
        panel.search_fields.fold.head.text()
        == "More settings: at least 50 points, angle between normals at most 8.0°"
    )
    seed(opened, "T1")
    click(opened, panel.candidate.accept)
    chosen = FinderChoices(min_points=50, max_tilt=radians(8.0))
    assert opened.project.target("T1").choices == chosen


def test_a_target_is_found_again_with_other_choices(picked: Driver) -> None:
    open_step(picked, 1)
    before = FinderChoices(max_tilt=radians(12.34), seed=5)
    project = picked.project
    picked.window.document.edit(
        "test", project.with_target(replace(project.target("T1"), choices=before))
    )
    picked.rest()
    picked.window.targets.select("T1")
    picked.bot.waitUntil(picked.window.actions_["find_again"].isEnabled)

    def use_dialog(dialog) -> None:
        points = field(dialog, "again_min_points")
        assert points.isVisible()  # unfolded, because the choices are not the defaults
        assert field(dialog, "again_max_tilt").value() == 12.3
        type_into(picked, points, "40")
        picked.bot.mouseClick(dialog.findChild(QPushButton, "again_find"), Left)

    dialogs = use_next_dialog(picked, use_dialog)
    picked.window.actions_["find_again"].trigger()
    picked.rest()
    assert dialogs
    candidate = picked.window.controller.candidate
    assert candidate.choices == replace(before, min_points=40)
    click(picked, picked.window.targets.candidate.accept)
    assert picked.project.target("T1").choices == replace(before, min_points=40)


def test_the_candidate_buttons_are_visible_on_a_low_screen(opened: Driver, demo: Demo) -> None:
    window = opened.window
    window.resize(1366, 768 - MAX_TITLE_BAR_HEIGHT_PX)
    opened.rest()
    window.controller.set_candidate(demo.picked.target("T1"))
    for button in (window.targets.candidate.accept, window.targets.candidate.reject):
        opened.bot.waitUntil(
            lambda button=button: button.visibleRegion().boundingRect() == button.rect(),
            timeout=WAIT_MS,
        )
    click(opened, window.targets.candidate.reject)
