"""Tests of the warnings about duplicate targets, for a candidate and with the result."""

from lispac.gui.viewport.base import PickedPoint
from lispac.workflow.planning.demo import demo_seeds
from tests.gui.support import Driver, click, open_step, wait_until_idle
from tests.support.message_codes import is_shown


def click_on(driver: Driver, name: str, offset_m: float = 0.0) -> None:
    """Seed a target of the demo, ``offset_m`` metres from its middle, as a Ctrl+click does."""
    x, y, z = demo_seeds()[name][1]
    first = driver.window.document.survey.lines[0]
    driver.viewport.signals.seed_clicked.emit(PickedPoint(first, (x + offset_m, y, z)))
    driver.rest()


def test_a_surface_clicked_twice_is_reported(opened: Driver) -> None:
    window = opened.window
    box = window.targets.candidate
    for name in ("T1", "T2"):
        click_on(opened, name)
        assert box.isVisible()
        assert not box.duplicate_warning.isVisible()
        click(opened, box.accept)
    click_on(opened, "T2", offset_m=0.2)
    assert window.controller.candidate.name == "T3"
    assert box.duplicate_warning.isVisible()
    assert is_shown("overlap.same_surface_twice", box.duplicate_warning.text())
    assert {"T2", "T3"} <= set(box.duplicate_warning.text().split())
    click(opened, box.accept)
    assert [target.name for target in opened.project.targets] == ["T1", "T2", "T3"]
    open_step(opened, 2)
    click(opened, window.adjust.estimate)
    wait_until_idle(opened)
    assert is_shown("targets.counted_twice", window.results.warnings.text())
    assert "T2 with T3 (" in window.results.warnings.text()
    assert "with warnings" in window.workflow.headers[2].sentence.text()
    window.controller.use_target("T3", False)
    wait_until_idle(opened)
    assert "points in common" not in window.results.warnings.text()
