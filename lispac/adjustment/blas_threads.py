"""Limit BLAS to one thread for the small matrices of an adjustment.

BLAS starts all cores for a product of a few hundred numbers; where another program uses them, it
waits for them a hundred times longer than the product takes. One thread also makes the result the
same, bit by bit, on any number of cores.
"""

from contextlib import AbstractContextManager
from functools import cache
from typing import Any


@cache
def _thread_pool_controller() -> Any:
    from threadpoolctl import ThreadpoolController  # type: ignore[import-untyped]

    return ThreadpoolController()


def single_blas_thread() -> AbstractContextManager[Any]:
    """Context manager that limits BLAS to the calling thread."""
    return _thread_pool_controller().limit(limits=1, user_api="blas")
