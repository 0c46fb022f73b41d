"""Tests of objects that are made once for all processes of a test run."""

import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from tests.support.sharing import make_once


class Factory:
    """Stand-in for `TempPathFactory` with a base folder of its own."""

    def __init__(self, base: Path) -> None:
        self.base = base

    def getbasetemp(self) -> Path:
        return self.base


def test_one_process_makes_the_object_and_others_wait(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PYTEST_XDIST_WORKER", "gw0")
    made_in = []

    def make(folder: Path) -> list[int]:
        made_in.append(folder)
        time.sleep(0.1)
        return [1, 2]

    def request_object(worker: int) -> list[int]:
        return make_once(Factory(tmp_path / f"gw{worker}"), "thing", make, pause=0.01)

    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(request_object, range(4))) == [[1, 2]] * 4
    assert made_in == [tmp_path / "thing"]


def test_a_failed_attempt_is_repeated_by_the_next_process(tmp_path: Path) -> None:
    def fails(_folder: Path) -> int:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        make_once(Factory(tmp_path), "thing", fails)
    assert make_once(Factory(tmp_path), "thing", lambda _folder: 3) == 3
    assert make_once(Factory(tmp_path), "thing", fails) == 3
