"""Tests of the minimum number of points and maximum tilt, in step 2 and in "Find again"."""

from dataclasses import replace
from math import radians

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QDoubleSpinBox, QPushButton, QToolButton, QWidget

from lispac.gui.appearance.message_texts import message_text
from lispac.gui.window.main_window import MAX_TITLE_BAR_HEIGHT_PX
from lispac.messages import error, note
from lispac.targets.finder_settings import DEFAULT_CHOICES, FinderChoices
from tests.gui.support import (
    WAIT_MS,
    Demo,
    Driver,
    Left,
    click,
    open_step,
    seed,
    type_into,
    use_next_dialog,
)


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

    dialogs = use_next_dialog(use_dialog)
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


def test_the_lines_without_the_target_are_listed_with_their_reasons(
    opened: Driver, demo: Demo
) -> None:
    """Lines with the same reason are together; the tooltip has the reasons of all lines."""
    target = demo.picked.target("T2")
    names = [line.name for line in opened.project.lines]
    reasons = {
        names[2]: error("finder.crossing"),
        names[3]: error("finder.not_alike"),
        names[4]: error("finder.not_alike"),
        names[5]: error("finder.too_large", ratio=3.0),
    }
    found = tuple(each for each in target.sightings if each.line not in reasons)
    opened.window.controller.set_candidate(
        replace(target, name="T1", sightings=found, missing=reasons)
    )
    box = opened.window.targets.candidate
    text = box.detail.text()
    assert text.startswith("Found in 2 of 6 lines")
    together = f"Not found in {names[3]} and {names[4]}. {message_text(reasons[names[3]])}"
    assert together in text
    assert f"Not found in {names[2]}. {message_text(reasons[names[2]])}" in text
    assert f"Not found in {names[5]}. {message_text(reasons[names[5]])}" in text
    assert text.count("Not found") == 3
    place = note("finder.seed_position", east=-7.43, north=-4.0, up=44.16)
    renamed = {"L -1": error("finder.no_plane", place=place, threshold=0.015)}
    opened.window.controller.set_candidate(
        replace(target, name="T1", sightings=found, missing=renamed)
    )
    assert "east \N{MINUS SIGN}7.43 m; north \N{MINUS SIGN}4.00 m; up 44.16 m" in box.detail.text()
    assert "Not found in L -1." in box.detail.text(), "a name has no minus sign"
    reasons = renamed
    assert all(f"{line}: " in box.detail.toolTip() for line in reasons)
