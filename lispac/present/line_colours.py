"""Colours of lines and signs, the same in the light window, the views and the report."""

LINE_COLOURS = (
    (0, 114, 178),
    (230, 159, 0),
    (0, 158, 115),
    (204, 121, 167),
    (86, 180, 233),
    (213, 94, 0),
    (51, 34, 136),
    (153, 153, 51),
    (136, 34, 85),
    (17, 119, 51),
)
"""Red, green and blue by the place of a line in the project, from 0 to 255.

Okabe and Ito's colours without black and yellow, then dark ones of Tol's muted set: any two
neighbours in the list can be distinguished with every common kind of colour blindness.
"""
POSITIVE_COLOUR, NEGATIVE_COLOUR = "#7fb0e2", "#f0b26b"
"""Colours of correlations of +1 and -1; those between are paler."""
