"""Plugin of pytest for mutation tests: deselect the tests that take too long.

Each mutation is tested in its own process, which creates the session fixtures again. The times of
the other tests are known after mutmut's first run; the file `SLOW` names the slow ones.

These processes are forks of one that has run the tests before, without its threads. Calls that wait
for threads of the LAZ library would block until the mutation counts as timed out.
"""

import json
from pathlib import Path

import pytest

SURVEY_FIXTURES = {
    "calibrated", "copy", "demo_project", "port", "shared_data", "denser_project", "printed_demo",
    "denser_calibrated", "denser_copy", "whole_demo",
}  # fmt: skip
SLOW = Path("slow-tests.json")
"""File with the names of the slow tests, in the folder that mutmut makes."""


def pytest_configure() -> None:
    """Read and write LAZ in the calling thread."""
    from laspy._compression import backend

    single = backend.LazrsBackend(parallel=False)
    backend._DEFAULT_BACKENDS = (single, single, backend.LaszipBackend())


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Deselect slow tests and tests that need a whole survey."""
    slow = set(json.loads(SLOW.read_text(encoding="utf-8"))) if SLOW.is_file() else set()
    excluded = {
        each for each in items
        if each.nodeid in slow or SURVEY_FIXTURES & set(getattr(each, "fixturenames", ()))
    }  # fmt: skip
    config.hook.pytest_deselected(items=list(excluded))
    items[:] = [each for each in items if each not in excluded]
