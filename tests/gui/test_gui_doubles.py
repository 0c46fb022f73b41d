"""A surface clicked twice is told of before it is accepted, and with the answer."""

import numpy as np
from PySide6.QtCore import QPoint

from lispac.project import Project
from lispac.workflow.demo import demo_seeds
from lispac.workflow.survey import load_survey
from tests.gui.support import Control, Driver, Key, Left, click, open_step, press, settle


def ctrl_click(driver: Driver, name: str, aside: float = 0.0) -> None:
    """Look at a target of the demo from the front, and click it."""
    window, viewport = driver.window, driver.viewport
    x, y, z = demo_seeds()[name][1]
    place = np.array([x + aside, y, z])
    press(driver, Key.Key_3)
    clouds = np.concatenate([cloud.sample for cloud in window.scene.clouds.values()])
    viewport.fit(clouds[np.linalg.norm(clouds - place, axis=1) < 3])
    driver.bot.wait(300)
    left, top = (int(v) for v in viewport.to_pixels(place[None])[0][:2])
    driver.bot.mouseClick(viewport.canvas, Left, Control, QPoint(left, top))
    driver.rest()


def test_a_surface_clicked_twice_is_told_of(real: Driver, whole_demo: Project) -> None:
    """With all points of the boards: between fewer of them a click meets the wall behind."""
    window = real.window
    window.document.open(whole_demo, load_survey(whole_demo))
    real.rest()
    box = window.targets.candidate
    for name in ("T1", "T2"):
        ctrl_click(real, name)
        assert box.isVisible()
        assert not box.double.isVisible()
        click(real, box.accept)
    ctrl_click(real, "T2", aside=0.2)
    assert window.controller.candidate.name == "T3"
    assert box.double.isVisible()
    assert box.double.text().startswith("T3 is the surface of T2 already: ")
    click(real, box.accept)
    assert [target.name for target in real.project.targets] == ["T1", "T2", "T3"]
    open_step(real, 2)
    click(real, window.adjust.estimate)
    settle(real)
    assert "Targets have points in common: T2 with T3 (" in window.results.warnings.text()
    assert "in doubt" in window.workflow.headers[2].sentence.text()
    window.controller.use_target("T3", False)
    settle(real)
    assert "points in common" not in window.results.warnings.text()
