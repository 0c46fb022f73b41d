"""The nightly set names tests and modules that are there."""

import pytest

from tests.extras import nightly
from tests.extras.nightly import CHECKOUT, COMPILED, ROOMS


def test_what_it_names_is_there() -> None:
    assert all((CHECKOUT / "lispac" / room).is_dir() for room in ROOMS)
    assert all((CHECKOUT / module).is_file() for module in COMPILED)
    for tests in ROOMS.values():
        assert [each for each in tests if not (CHECKOUT / f"tests/test_{each}.py").is_file()] == []


def test_a_step_that_is_not_there_is_refused(
    tmp_path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["nightly", str(tmp_path), "everything"])
    with pytest.raises(SystemExit):
        nightly.main()
    assert "there is no step everything" in capsys.readouterr().err


def test_a_step_that_fails_is_told_and_the_next_is_taken(
    tmp_path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fails(_folder, log) -> str:
        nightly.run(["false"], log)
        return ""

    monkeypatch.setattr(nightly, "STEPS", {"first": fails, "second": lambda *_: "all is well"})
    monkeypatch.setattr("sys.argv", ["nightly", str(tmp_path / "out")])
    assert nightly.main() == 1
    first, second = capsys.readouterr().out.splitlines()
    assert first.startswith("first     FAILED")
    assert "exit 1; see" in first
    assert second.endswith("all is well")
