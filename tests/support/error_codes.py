"""Checks of errors by the code and the parameters of their message."""

from collections.abc import Callable
from typing import Any

from lispac.errors import LispacError


def has_code(code: str, **params: Any) -> Callable[[BaseException], bool]:
    """Check for `pytest.raises` that an error has this code and these parameters."""

    def check(error: BaseException) -> bool:
        assert isinstance(error, LispacError)
        parameters = error.message.params if error.message is not None else {}
        assert (error.code, {name: parameters.get(name) for name in params}) == (code, params), (
            error
        )
        return True

    return check
