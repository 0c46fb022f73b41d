"""Plugin of pytest for mutation tests that skips slow tests.

Each mutation runs in a separate process, where session fixtures are created again. The times of the
other tests are known after mutmut's first run; `SLOW_TESTS_FILE` names the slow ones.

These processes are forks of one that has run the tests, without its threads. Code that waits for
threads of the LAZ library would block until the mutation is counted as a timeout.
"""

import json
from pathlib import Path

import pytest

SURVEY_FIXTURES = {
    "calibrated", "copy", "demo_project", "port", "shared_data", "sparse_project", "printed_demo",
    "whole_demo",
}  # fmt: skip
SLOW_TESTS_FILE = Path("slow-tests.json")
"""File with names of slow tests, in the folder created by mutmut."""


def pytest_configure() -> None:
    """Read and write LAZ in the calling thread."""
    from laspy._compression import backend

    single = backend.LazrsBackend(parallel=False)
    backend._DEFAULT_BACKENDS = (single, single, backend.LaszipBackend())


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Keep tests without slow fixtures."""
    slow = (
        set(json.loads(SLOW_TESTS_FILE.read_text(encoding="utf-8")))
        if SLOW_TESTS_FILE.is_file()
        else set()
    )
    left_out = {
        each for each in items
        if each.nodeid in slow or SURVEY_FIXTURES & set(getattr(each, "fixturenames", ()))
    }  # fmt: skip
    config.hook.pytest_deselected(items=list(left_out))
    items[:] = [each for each in items if each not in left_out]
