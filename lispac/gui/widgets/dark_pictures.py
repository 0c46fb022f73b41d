"""Pictures on white ground for a dark window: the lightness is inverted, hues stay.

Figures of the report are drawn for paper. With x the red, green and blue of a colour, 0 to 1, and L
its luma, x + 1 - 2 L inverts the lightness (white becomes black) and keeps the differences between
the three, which are the hue. Black and white become the colours of the theme.
"""

import numpy as np
from numpy.typing import NDArray

from lispac.gui.appearance import theme

LUMA = (77, 150, 29)
"""Shares of red, green and blue in 256, after ITU-R BT.601."""


def with_inverted_lightness(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Pixels of a picture with inverted lightness, in the colours of the scheme in use.

    Parameters
    ----------
    pixels : ndarray, shape (height, width, 4), 0 to 255
        Red, green, blue, alpha.
    """
    colours = pixels[..., :3].astype(np.int16)
    luma = sum(colours[..., k].astype(np.int32) * share for k, share in enumerate(LUMA)) >> 8
    colours += (255 - 2 * luma).astype(np.int16)[..., None]
    np.clip(colours, 0, 255, out=colours)
    result = pixels.copy()
    for k, (dark, light) in enumerate(zip(theme.rgb("paper"), theme.rgb("text"), strict=True)):
        result[..., k] = np.linspace(dark, light, 256).round().astype(np.uint8)[colours[..., k]]
    return result
