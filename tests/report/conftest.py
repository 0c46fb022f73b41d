"""Fixtures of the tests of the report."""

from functools import lru_cache

import pytest

from lispac.report import figures


@pytest.fixture(scope="session", autouse=True)
def _keep_figures() -> None:
    """Keep all figures that were drawn: most reports of the tests contain the same ones."""
    drawing = figures.render_pictures.__wrapped__
    figures.render_pictures = lru_cache(maxsize=None)(drawing)
