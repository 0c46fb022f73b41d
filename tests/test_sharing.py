"""What is made once for all processes of a run."""

import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from tests.sharing import make_once


class Factory:
    """Stands for the factory of folders, with one of its own."""

    def __init__(self, base: Path) -> None:
        self.base = base

    def getbasetemp(self) -> Path:
        return self.base


def test_one_makes_and_the_others_wait_for_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PYTEST_XDIST_WORKER", "gw0")
    asked = []

    def make(folder: Path) -> list[int]:
        asked.append(folder)
        time.sleep(0.1)
        return [1, 2]

    def ask(worker: int) -> list[int]:
        return make_once(Factory(tmp_path / f"gw{worker}"), "thing", make, pause=0.01)

    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(ask, range(4))) == [[1, 2]] * 4
    assert asked == [tmp_path / "thing"]


def test_what_failed_is_tried_by_the_next(tmp_path: Path) -> None:
    def fails(_folder: Path) -> int:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        make_once(Factory(tmp_path), "thing", fails)
    assert make_once(Factory(tmp_path), "thing", lambda _folder: 3) == 3
    assert make_once(Factory(tmp_path), "thing", fails) == 3
