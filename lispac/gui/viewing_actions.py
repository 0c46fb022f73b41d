"""Actions that change how the lines are looked at, and what is measured in the view."""

from lispac.gui.colouring import COLOURINGS
from lispac.gui.settings import THEMES
from lispac.gui.status import STEPS

Described = tuple[str, str, str, object, str]
"""Text, short text for the toolbar, icon, keys, tip."""

VIEWS = ("isometric", "top", "front", "back", "left", "right")
"""Names of the standard views; their actions are called the same."""
COLOURED = {name: f"colour_{name}" for name in COLOURINGS}
"""Action of each colouring."""

THEMED = {choice: f"theme_{choice}" for choice in THEMES}
"""Action of each theme."""

STEP_ACTIONS: dict[str, Described] = {
    f"step_{k}": (f"&{k}  {title}", title, "", f"Ctrl+{k}", f"Go to step {k} of the workflow")
    for k, title in enumerate(STEPS, 1)
}
"""Each opens a step, in the order of the steps."""

VIEW_ACTIONS: dict[str, Described] = {
    "fit": ("&Fit all", "Fit all", "fit-to-page-outline", "F", "Bring everything into view"),
    "fit_selection": ("Fit s&election", "Selection", "target", "Shift+F",
                      "Bring the selected target or sighting into view"),
    "isometric": ("&Isometric", "3D", "cube-outline", "1", "Look from above at an angle"),
    "top": ("&Top", "Top", "arrow-down-bold-box-outline", "2", "Look straight down, north up"),
    "front": ("F&ront", "Front", "eye-outline", "3", "Look from the vessel"),
    "left": ("From the &left", "Left", "axis-arrow", "4", "Look from the left, as the vessel sees"),
    "back": ("&Back", "Back", "", "5", "Look towards the vessel"),
    "right": ("From the ri&ght", "Right", "", "6", "Look from the right, as the vessel sees"),
    "normal": ("Along the target's &normal", "Normal", "", "7",
               "Look squarely at the selected target"),
    "orthographic": ("&Orthographic", "Ortho", "", "O",
                     "Draw without perspective: equal lengths look equal at every distance"),
    "larger": ("La&rger points", "Larger", "magnify-plus-outline", "+", "Draw larger points"),
    "smaller": ("S&maller points", "Smaller", "magnify-minus-outline", "-",
                "Draw smaller points"),
    "colour_next": ("&Next colouring", "Colours", "palette-outline", "C",
                    "Colour the points by line, height, intensity, range, time, residual, in turn"),
    "colour_line": ("Colour by &line", "Line", "", "", "Each line in its own colour"),
    "colour_height": ("Colour by &height", "Height", "", "", "Colour the points by height"),
    "colour_intensity": ("Colour by &intensity", "Intensity", "", "",
                         "Colour the points by the intensity in their file"),
    "colour_range": ("Colour by &range", "Range", "", "",
                     "Colour the points by their distance from the scanner"),
    "colour_time": ("Colour by ti&me", "Time", "", "",
                    "Colour the points by the time they were measured"),
    "picture": ("Sa&ve the picture…", "Picture", "camera-outline", "P",
                "Write what the view shows as PNG"),
    "copy_picture": ("Cop&y the picture", "Copy", "", "Shift+P",
                     "Copy what the view shows, to be pasted elsewhere"),
    "colour_residual": ("Colour by r&esidual", "Residual", "", "",
                        "Colour targets by the distance from the adjusted surface, and validation "
                        "planes by that from the plane of all lines as they are shown"),
    "arrange": ("&Arrange as at first", "Arrange", "", "",
                "Put every panel back in its place, also those that float or were closed"),
    "theme_system": ("&System default", "System", "", "",
                     "Light or dark as the system is, also when that changes"),
    "theme_light": ("&Light", "Light", "", "", "Dark text on a light ground"),
    "theme_dark": ("&Dark", "Dark", "", "", "Light text on a dark ground"),
}  # fmt: skip

INSPECT_ACTIONS: dict[str, Described] = {
    "section": ("&Section across the target", "Section", "", "S",
                "Lay a strip across the selected target: all lines side by side at true scale"),
    "section_points": ("Section &between two points", "Section", "", "Shift+S",
                       "Cut through the lines from one clicked point to another"),
    "section_picture": ("Save the section's &picture…", "Picture", "", "Ctrl+P",
                        "Write the section as it is shown, as PNG, SVG or PDF"),
    "copy_section": ("Cop&y the section's picture", "Copy", "", "Ctrl+Shift+P",
                     "Copy the section as it is shown, to be pasted elsewhere"),
    "measure_distance": ("Measure a &distance", "Distance", "ruler", "M",
                         "Click two points: slope, horizontal and vertical distance"),
    "measure_angle": ("Measure an &angle", "Angle", "", "Shift+M",
                      "Click a point, the corner and another point"),
    "clip": ("&Clip box", "Clip", "crop", "X",
             "Draw only what lies in a box about the selected target"),
    "wipe": ("Before and after in o&ne picture", "Wipe", "", "W",
             "Before on the left, after on the right of a line that the mouse moves"),
    "hover": ("S&how what a click would take", "Hover", "", "H",
              "Outline the plane under the resting mouse"),
    "lasso_add": ("A&dd points with a lasso", "Add", "lasso", "L",
                  "Draw around points near the selected target to add them to it"),
    "lasso_remove": ("Re&move points with a lasso", "Remove", "", "Shift+L",
                     "Draw around points of the selected target to take them from it"),
    "change_role": ("Change the &role", "Role", "", "F8",
                    "Make a validation plane of the selected target, or a target of it"),
    "patch_point": ("Object &for the patch test", "Object", "", "Ctrl+Shift+T",
                    "Lay a box of the patch test about the next point that is clicked"),
    "end_tool": ("&End the tool", "End", "", "Esc", "Give the mouse back to the view"),
}  # fmt: skip
"""What is measured and looked into with the mouse."""

Menu = tuple["str | tuple[str, Menu]", ...]
"""Names of actions, "" for a line between them, and menus in the menu with their titles."""

VIEW_MENU: Menu = (
    "before",
    "after",
    "toggle",
    "wipe",
    "",
    "fit",
    "fit_selection",
    ("&Look from", (*VIEWS, "normal")),
    "orthographic",
    "",
    "larger",
    "smaller",
    ("&Colour by", (*COLOURED.values(), "", "colour_next")),
    "",
    "picture",
    "copy_picture",
    "",
    "warnings",
    ("S&teps", tuple(STEP_ACTIONS)),
    ("&Panels", ("DOCKS", "", "arrange")),
    ("T&heme", tuple(THEMED.values())),
    ("Lan&guage · Langue", ("english", "french")),
)
INSPECT_MENU: Menu = (
    "section",
    "section_points",
    "section_picture",
    "copy_section",
    "",
    "measure_distance",
    "measure_angle",
    "",
    "clip",
    "patch_point",
    "",
    "end_tool",
)
SWITCHES = ("orthographic", "section_points", "measure_distance", "measure_angle", "clip",
            "wipe", "lasso_add", "lasso_remove", "hover", "patch_point")  # fmt: skip
"""Actions that are on or off, each by itself."""

KEYS = (
    ("The view", (
        ("Drag, arrows", "rotate about what is under the mouse, about the middle"),
        ("Shift + drag, Shift + arrows", "move; so does a drag with the right or middle button"),
        ("Wheel, Page up and down", "closer and farther"),
        ("Double click", "look at the point there"),
        ("F, Shift + F", "fit everything, fit the selected target"),
        ("1, 2, 3, 4, 5, 6", "look isometric, from the top, front, left, back, right"),
        ("7", "look along the normal of the selected target"),
        ("O", "orthographic or perspective"),
        ("+, −", "larger, smaller points"),
        ("C", "colour by line, height, intensity, range, time, residual"),
        ("B", "switch between before and after"),
        ("W", "before and after in one picture: drag the line, or Ctrl + arrows"),
        ("P, Shift + P", "save the picture of the view, copy it"),
    )),
    ("Designing a site (Ctrl + Shift + D)", (
        ("Drag a line, its arrow", "nearer or farther, turn it; Shift: not in steps"),
        ("Drag a target", "along the wall and up; in 3D its dots, off the wall too"),
        ("Page up and down", "choose a line or target"),
        ("Arrows, Shift + arrows", "move or turn it, in fine steps"),
        ("Insert, Delete", "add one, remove it"),
        ("Ctrl + D, Alt + Up, Down", "line again, a turn earlier, later"),
        ("Ctrl + L, Ctrl + B", "add a line, a board"),
        ("Ctrl + Shift + B", "add a ball"),
        ("F9", "scenarios"),
        ("F10", "simulate surveys: do the sigmas hold?"),
        ("F11", "compare the plan with the open project"),
    )),
    ("Looking into it", (
        ("S, Shift + S", "section across the selected target, between two points"),
        ("Ctrl + P, Ctrl + Shift + P", "save the picture of the section, copy it"),
        ("M, Shift + M", "measure a distance, an angle"),
        ("X", "clip box about the selected target, or none"),
        ("H", "show what a click would take under the resting mouse"),
        ("Ctrl + T, Ctrl + Shift + T", "patch test, box about an object for it"),
        ("Esc", "end measuring or the lasso"),
    )),
    ("Targets", (
        ("Ctrl + click", "set a seed on a target"),
        ("F3, Shift + F3", "type the coordinates of a seed, read a list of them"),
        ("Enter, Esc", "accept or reject the plane just found"),
        ("F5, Shift + F5", "propose targets, find the selected one again"),
        ("F6, F7", "next seed is an adjustment target, a validation plane"),
        ("F8", "target to validation plane, or the other way round"),
        ("L, Shift + L", "lasso: add points to the selected target, remove points"),
    )),
    ("The project", (
        ("Ctrl + 1, 2, 3, 4, 5", "go to a step of the workflow"),
        ("F9, F10", "estimate, validate"),
        ("Shift + F9", "study the distance between points"),
        ("Shift + F10, F11", "check against a reference, calibrations over the years"),
        ("F12", "the warnings, all in one list"),
        ("Ctrl + .", "cancel the running task"),
        ("Ctrl + E, Ctrl + Shift + E", "export the report, the georeferenced lines"),
        ("Ctrl + Z, Ctrl + Y", "undo, redo"),
        ("Ctrl + N, Ctrl + O, Ctrl + S", "new project, open, save"),
    )),
)  # fmt: skip
"""Headings of the list of keys, and the rows below each."""
