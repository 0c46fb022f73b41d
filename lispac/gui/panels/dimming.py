"""A picture drawn on white paper, as it is shown in a dark window: light is dark, hues stay.

Figures that the report has too are drawn for paper. With x a colour's red, green and blue, 0 to 1,
and L its luma, x + 1 - 2 L turns the lightness over (white is black then), and leaves the
differences between the three as they are, which is hue. Black and white become the theme's.
"""

import numpy as np
from numpy.typing import NDArray

from lispac.gui import theme

LUMA = (77, 150, 29)
"""Shares of red, green and blue in 256, after ITU-R BT.601."""


def dimmed(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The picture in the colours of the scheme in use.

    Parameters
    ----------
    pixels : ndarray, shape (height, width, 4), 0 to 255
        Red, green, blue, alpha.
    """
    colours = pixels[..., :3].astype(np.int16)
    luma = sum(colours[..., k].astype(np.int32) * share for k, share in enumerate(LUMA)) >> 8
    colours += (255 - 2 * luma).astype(np.int16)[..., None]
    np.clip(colours, 0, 255, out=colours)
    made = pixels.copy()
    for k, (dark, light) in enumerate(zip(theme.rgb("paper"), theme.rgb("text"), strict=True)):
        made[..., k] = np.linspace(dark, light, 256).round().astype(np.uint8)[colours[..., k]]
    return made
