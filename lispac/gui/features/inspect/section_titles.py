"""Titles of the axes of sections, without the libraries that draw them."""

from lispac.language import N_

AHEAD_LABEL = N_("From the middle, away from the vessel (m)")
RIGHT_LABEL = N_("From the middle to the right (m)")
HEIGHT_LABEL = N_("Height above the middle (m)")
ALONG_LABEL = N_("Distance from the first point (m)")
ACROSS_TITLE = N_("Across the surface, + towards the vessel (m)")
"""Title of the axis across a plane in an exaggerated picture; signs as in the tables."""
ALONG_TITLES = {
    AHEAD_LABEL: N_("Along the surface, away from the vessel (m)"),
    RIGHT_LABEL: N_("Along the surface, to the right (m)"),
    HEIGHT_LABEL: N_("Along the surface, upwards (m)"),
}
"""Title of the axis along a plane in an exaggerated picture, by that of the nearest axis at true
scale."""
LOW_TITLES = {
    HEIGHT_LABEL: N_("Height (m)"),
    AHEAD_LABEL: N_("Away (m)"),
    ACROSS_TITLE: N_("+ to the vessel (m)"),
    ALONG_TITLES[AHEAD_LABEL]: N_("Away (m)"),
    ALONG_TITLES[RIGHT_LABEL]: N_("To the right (m)"),
    ALONG_TITLES[HEIGHT_LABEL]: N_("Upwards (m)"),
}
"""Titles of the axes in a low picture, which have one line; the title of the cut contains the
factor."""
