"""The terminal: progress as one line on stderr, rewritten in place, and wrong usage."""

import json
import os
import sys
import time
from types import TracebackType
from typing import Any


class UsageError(Exception):
    """Options that do not go together: exit 2, as argparse does for the others."""


class ConsoleProgress:
    """A progress that draws on stderr where that is a terminal, and is silent elsewhere."""

    def __init__(self) -> None:
        self._shown = 0.0
        self._width = 0
        self._terminal = sys.stderr.isatty()

    def __call__(self, fraction: float, message: str = "") -> None:
        """Redraw at most ten times a second."""
        now = time.monotonic()
        if not self._terminal or now - self._shown < 0.1:
            return
        self._shown = now
        text = f"{fraction:4.0%} {message}"
        print("\r" + text.ljust(self._width), end="", file=sys.stderr, flush=True)
        self._width = len(text)

    def __enter__(self) -> "ConsoleProgress":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if self._width:
            print("\r" + " " * self._width + "\r", end="", file=sys.stderr, flush=True)


def has_display() -> bool:
    """Whether a window can be opened here."""
    if sys.platform.startswith("linux"):
        return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
    return True


def print_json(content: dict[str, Any]) -> None:
    """Print plain values as JSON."""
    print(json.dumps(content, indent=1, allow_nan=False))
