"""Tests of the quality lights of sightings in the table and of a candidate."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel

from lispac.gui.appearance.message_texts import message_text
from lispac.messages import note
from lispac.project import Project
from lispac.targets.sighting_quality import SightingQuality
from tests.gui.support import (
    Demo,
    Driver,
    Key,
    Left,
    click,
    open_step,
    press,
    seed,
    wait_until_idle,
)
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import is_shown

Role = Qt.ItemDataRole


RATED = SightingQuality(
    points=500, rms=0.004, range=20.0, density=80.0, incidence=0.2, extent=np.array([2.0, 2.0]),
    coverage=1.0, curvature=None, curved=False, roughness=None, rating="good", reasons=(),
)  # fmt: skip


def shown_value(driver: Driver, name: str, line: str, role: Role = Role.DisplayRole):
    model = driver.window.table.sightings
    lines = [each.name for each in driver.project.lines]
    return model.data(model.index(model.row_of(name), 1 + lines.index(line)), role)


def with_few_points(project: Project) -> Project:
    target = project.target("T1")
    first = target.sightings[0]
    few = replace(first, indices=first.indices[:40])
    return project.with_target(replace(target, sightings=(few, *target.sightings[1:])))


def test_every_sighting_has_a_quality_light_with_its_reason(
    driver: Driver, denser_demo: Demo
) -> None:
    picked = driver
    picked.window.document.open(denser_demo.picked, denser_demo.survey)
    line = picked.project.target("T1").sightings[0].line
    picked.bot.waitUntil(lambda: shown_value(picked, "T1", line, Role.DecorationRole) is not None)
    assert "Quality: good" in shown_value(picked, "T1", line, Role.ToolTipRole)
    assert "m²" in shown_value(picked, "T1", line, Role.ToolTipRole)
    assert " % of the extent in the other lines" in shown_value(
        picked, "T1", line, Role.ToolTipRole
    )
    assert shown_value(picked, "T1", line).endswith("mm")
    steep = picked.project.target("T2").sightings[-1].line
    assert "Quality: doubtful" in shown_value(picked, "T2", steep, Role.ToolTipRole)
    assert "°" in shown_value(picked, "T2", steep, Role.ToolTipRole)
    model = picked.window.table.sightings
    heads = {name: model.data(model.index(model.row_of(name), 0)) for name in ("T1", "T2")}
    assert heads["T1"] == "T1"
    assert heads["T2"].removeprefix("T2").strip() in {"oblique", "few points"}, "named"


def test_the_status_bar_gives_the_reasons_of_the_selected_sighting(picked: Driver) -> None:
    good = picked.project.target("T1").sightings[0].line
    steep = picked.project.target("T2").sightings[-1].line
    table, bar = picked.window.table, picked.window.task_bar
    picked.bot.waitUntil(lambda: shown_value(picked, "T2", steep, Role.DecorationRole) is not None)
    for name, line, is_named in (("T2", steep, True), ("T1", good, False)):
        model = table.sightings
        cell = table.visualRect(model.index(model.row_of(name), model.column_of(line)))
        picked.bot.mouseClick(table.viewport(), Left, pos=cell.center())
        assert is_shown("quality.oblique", bar.currentMessage()) == is_named


def test_an_effect_of_the_prior_boresight_below_a_tenth_of_a_millimetre_is_not_shown(
    picked: Driver,
) -> None:
    line = picked.project.target("T1").sightings[0].line
    picked.bot.waitUntil(lambda: shown_value(picked, "T1", line, Role.DecorationRole) is not None)
    for smear, is_named in ((4e-5, False), (6e-5, True)):
        picked.window.table.sightings.show_qualities({("T1", line): replace(RATED, smear=smear)})
        tip = shown_value(picked, "T1", line, Role.ToolTipRole)
        assert ("0.1\u00a0mm" in tip) == is_named
        assert "0.0\u00a0mm" not in tip


@LONG
def test_a_poor_sighting_is_reported_and_can_be_excluded_and_restored(picked: Driver) -> None:
    line = picked.project.target("T1").sightings[0].line
    picked.window.document.edit("less", with_few_points(picked.project))
    picked.rest()
    assert shown_value(picked, "T1", line).endswith("poor")
    tip = shown_value(picked, "T1", line, Role.ToolTipRole)
    assert message_text(note("quality.few_points", count=40)) in tip
    assert is_shown("quality.shows_less", tip)
    step = picked.window.workflow.headers[1]
    assert f"T1 on {line}" in step.toolTip()
    picked.window.controller.use_sighting("T1", line, False)
    picked.rest()
    assert shown_value(picked, "T1", line).endswith("poor")
    assert f"T1 on {line}" not in step.toolTip()
    picked.window.document.undo_stack.undo()
    picked.window.document.undo_stack.undo()
    picked.rest()
    assert "Quality: good" in shown_value(picked, "T1", line, Role.ToolTipRole)


@LONG
def test_quality_is_computed_with_the_estimated_boresight(
    picked: Driver, demo: Demo, estimated: Project
) -> None:
    line = picked.project.target("T1").sightings[0].line
    picked.window.document.edit("estimate", estimated)
    picked.rest()
    tip = shown_value(picked, "T1", line, Role.ToolTipRole)
    assert "Quality: good" in tip
    assert "prior boresight" not in tip
    assert " found again with the estimated boresight, RMS " in tip
    # Excluding one sighting keeps the lights of the others until the new result is there.
    picked.window.controller.use_sighting("T1", line, False)
    assert "Quality: good" in shown_value(picked, "T1", line, Role.ToolTipRole)
    wait_until_idle(picked)
    assert "Quality: good" in shown_value(picked, "T1", line, Role.ToolTipRole)


def test_other_tasks_take_precedence_over_quality(picked: Driver) -> None:
    """The computation of the quality is interrupted, and resumes afterwards."""
    line = picked.project.target("T1").sightings[0].line
    picked.window.document.edit("less", with_few_points(picked.project))
    assert picked.window.runner.current is not None
    assert not picked.window.runner.busy
    done = []
    picked.window.runner.run("Something else", lambda progress: 1, done.append)
    picked.rest()
    assert done == [1]
    assert shown_value(picked, "T1", line).endswith("poor")


def lights(driver: Driver) -> dict[str, str]:
    """Tooltips of the candidate's lights, by line."""
    box = driver.window.targets.candidate.lights
    return {
        light.objectName().removeprefix("light_"): light.toolTip()
        for light in box.findChildren(QLabel)
        if light.objectName() and light.isVisible()
    }


def test_a_candidate_has_quality_lights_before_it_is_accepted(
    driver: Driver, denser_demo: Demo
) -> None:
    opened = driver
    opened.window.document.open(denser_demo.project, denser_demo.survey)
    open_step(opened, 1)
    seed(opened, "T2")
    opened.bot.waitUntil(
        lambda: not any("The quality is being computed" in tip for tip in lights(opened).values())
    )
    opened.rest()
    tips = lights(opened)
    assert list(tips) == [line.name for line in opened.project.lines]
    assert "Quality: good" in tips["L1_000"]
    assert " points, " in tips["L1_000"]
    assert "Quality: doubtful\n" in tips["L3_045"]
    assert "(73°)" in tips["L3_045"]
    box = opened.window.targets.candidate
    assert box.lights.height() < 60, "six lines are two or three rows"
    assert box.reasons.isVisible()
    assert "L3_045: " in box.reasons.text()
    assert "L1_000" not in box.reasons.text(), "its quality is good"
    assert box.accept.visibleRegion().boundingRect().size() == box.accept.size()
    press(opened, Key.Key_Return)
    opened.rest()
    assert tips["L3_045"].split("\n")[2] in shown_value(opened, "T1", "L3_045", Role.ToolTipRole)
    seed(opened, "V1")
    opened.rest()
    assert set(lights(opened)) == {s.line for s in opened.window.controller.candidate.sightings}
    assert all("Quality: " in tip for tip in lights(opened).values())
    assert "L3_045: " in box.detail.toolTip(), "why it was not found there"


def test_quality_lights_belong_to_the_current_candidate(opened: Driver) -> None:
    open_step(opened, 1)
    seed(opened, "T1")
    press(opened, Key.Key_Escape)
    seed(opened, "T2")
    opened.rest()
    points = [len(s.indices) for s in opened.window.controller.candidate.sightings]
    tips = lights(opened)
    for tip, count in zip(tips.values(), points, strict=True):
        assert f": {count:,} points, " in tip
    assert all("Quality: " in tip for tip in tips.values())


@pytest.mark.parametrize(
    ("count", "last"),
    others_long(
        [
            (2, ""),
            (3, "and 1 more line of doubtful or poor quality"),
            (4, "and 2 more lines of doubtful or poor quality"),
        ]
    ),
)
def test_further_lines_of_doubtful_quality_are_counted(
    opened: Driver, count: int, last: str
) -> None:
    open_step(opened, 1)
    seed(opened, "T2")
    opened.rest()
    box = opened.window.targets.candidate
    lines = [sighting.line for sighting in opened.window.controller.candidate.sightings]
    box.show_qualities({line: replace(RATED, rating="doubtful") for line in lines[:count]})
    shown = box.reasons.text().split("\n")
    assert [text.partition(":")[0] for text in shown[:2]] == lines[:2]
    assert shown[2:] == ([last] if last else [])
    listed = [line for line in box.reasons.toolTip().split("\n") if line]
    assert [text.partition(":")[0] for text in listed] == lines[2:count]


def test_enter_does_not_accept_a_candidate_whose_lines_are_all_poor(opened: Driver) -> None:
    open_step(opened, 1)
    seed(opened, "T2")
    opened.rest()
    window, box = opened.window, opened.window.targets.candidate
    lines = [sighting.line for sighting in window.controller.candidate.sightings]
    poor = dict.fromkeys(lines, replace(RATED, rating="poor"))
    box.show_qualities(poor | {lines[0]: RATED})
    assert (box.accept.text(), box.accept.property("primary")) == ("Accept  ⏎", True)
    assert window.actions_["accept"].isEnabled()
    box.accept.setFocus()
    box.show_qualities(poor)
    assert (box.accept.text(), box.accept.property("primary")) == ("Accept", False)
    assert "Every line of the target is rated poor" in window.actions_["accept"].toolTip()
    press(opened, Key.Key_Return)
    opened.rest()
    assert window.controller.candidate is not None
    assert opened.project.targets == ()
    click(opened, box.accept)
    assert [target.name for target in opened.project.targets] == ["T1"]
    seed(opened, "T1")
    opened.rest()
    assert (box.accept.text(), box.accept.property("primary")) == ("Accept  ⏎", True)
    assert window.actions_["accept"].isEnabled()
