"""One thread for the small matrices of an adjustment.

BLAS starts all cores for a product of a few hundred numbers; where another program uses them, it
waits for them a hundred times longer than the product takes. One thread also makes the answer the
same, bit by bit, on any number of cores.
"""

from contextlib import AbstractContextManager
from functools import cache
from typing import Any


@cache
def _controller() -> Any:
    from threadpoolctl import ThreadpoolController  # type: ignore[import-untyped]

    return ThreadpoolController()


def one_thread() -> AbstractContextManager[Any]:
    """Keep BLAS to the calling thread while the context is open."""
    return _controller().limit(limits=1, user_api="blas")
