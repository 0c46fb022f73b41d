"""Tests of the expected values of a target, typed in step 2."""

from PySide6.QtWidgets import QDoubleSpinBox

from tests.gui.support import Driver, click, open_step, seed, type_into


def type_expected(driver: Driver, name: str, text: str) -> None:
    type_into(driver, driver.window.targets.findChild(QDoubleSpinBox, name), text)


def test_the_candidate_is_compared_with_the_expected_values(opened: Driver) -> None:
    open_step(opened, 1)
    assert opened.window.targets.expected is None
    type_expected(opened, "expected_width", "1.23")
    type_expected(opened, "expected_height", "1.22")
    seed(opened, "T1")
    detail = opened.window.targets.candidate.detail
    agreeing = detail.text()
    click(opened, opened.window.targets.candidate.reject)
    type_expected(opened, "expected_tilt", "45")
    seed(opened, "T1")
    assert "more than the expected 45.0°" in detail.text()
    assert "more than the expected" not in agreeing
    click(opened, opened.window.targets.candidate.accept)
    assert opened.project.target("T1").expected.width == 1.23
    opened.window.targets.shape_choice.setCurrentIndex(1)
    assert opened.window.targets.expected is None
