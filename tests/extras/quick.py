"""A plugin of pytest for changes of the code: leaves out the tests that take too long for each.

Each change has a process of its own, in which a fixture of the session is made anew. How long the
other tests take is known after mutmut's first run of them; `SLOW` beside them names those.

These processes are copies of one that has run the tests before, without its threads: what waits for
those of the LAZ library would wait until the change is counted as one that hangs.
"""

import json
from pathlib import Path

import pytest

SURVEYS = {
    "calibrated", "copy", "demo_project", "port", "shared_data", "sparse_project", "printed_demo",
    "whole_demo",
}  # fmt: skip
SLOW = Path("slow-tests.json")
"""Names of tests, in the folder that mutmut makes."""


def pytest_configure() -> None:
    """Read and write LAZ in the thread that asks for it."""
    from laspy._compression import backend

    single = backend.LazrsBackend(parallel=False)
    backend._DEFAULT_BACKENDS = (single, single, backend.LaszipBackend())


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Keep the tests that make what they need in moments."""
    slow = set(json.loads(SLOW.read_text(encoding="utf-8"))) if SLOW.is_file() else set()
    left_out = {
        each for each in items
        if each.nodeid in slow or SURVEYS & set(getattr(each, "fixturenames", ()))
    }  # fmt: skip
    config.hook.pytest_deselected(items=list(left_out))
    items[:] = [each for each in items if each not in left_out]
