"""An answer that stands although another one was asked for since."""

from lispac.adjustment.doubt import Doubt


def refused_since(reason: str) -> Doubt:
    """What to know of an answer after which another was asked for and refused, and why it was."""
    words = f"An estimate asked for after this one was refused: {reason}"
    return Doubt("refused_since", True, f"{words} The angles are those of the estimate before.")
