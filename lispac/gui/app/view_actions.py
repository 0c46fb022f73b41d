"""Actions of the view: standard views, colours and measurements; the list of mouse and keys."""

from lispac.gui.app.point_colours import COLOURINGS
from lispac.gui.app.settings import THEMES
from lispac.gui.project.status import STEP_TITLES
from lispac.language import N_

ActionSpec = tuple[str, str, str, object, str]
"""Text, short text for the toolbar, icon, keys, tip."""

VIEWS = ("isometric", "top", "front", "back", "left", "right")
"""Names of the standard views; their actions are called the same."""
COLOUR_ACTIONS = {name: f"colour_{name}" for name in COLOURINGS}
"""Action of each colouring."""

THEME_ACTIONS = {choice: f"theme_{choice}" for choice in THEMES}
"""Action of each theme."""

STEP_ACTIONS: dict[str, ActionSpec] = {
    f"step_{k}": (title, "", "", f"Ctrl+{k}", N_("Go to step {number:n} of the workflow"))
    for k, title in enumerate(STEP_TITLES, 1)
}
"""Actions that open the steps, in the order of the steps."""

VIEW_ACTIONS: dict[str, ActionSpec] = {
    "fit": (N_("&Zoom to all"), N_("Zoom to all"), "fit-to-page-outline", "F",
            N_("Show all points in the view")),
    "fit_selection": (N_("Zoom to s&election"), "", "target", "Shift+F",
                      N_("Zoom the view to the selected target or sighting")),
    "isometric": (N_("&Isometric"), N_("3D"), "cube-outline", "1",
                  N_("Look obliquely from above")),
    "top": (N_("&Top"), N_("Top"), "arrow-down-bold-box-outline", "2",
            N_("Look straight down, north up")),
    "front": (N_("F&ront"), N_("Front"), "eye-outline", "3", N_("Look from the vessel")),
    "left": (N_("From the &left"), N_("Left"), "axis-arrow", "4",
             N_("Look from the left, as seen from the vessel")),
    "back": (N_("&Back"), "", "", "5", N_("Look towards the vessel")),
    "right": (N_("From the ri&ght"), "", "", "6",
              N_("Look from the right, as seen from the vessel")),
    "normal": (N_("Along the target's &normal"), "", "", "7",
               N_("Look at the selected target along its normal")),
    "orthographic": (N_("&Orthographic"), "", "", "O",
                     N_("Draw without perspective: equal lengths have equal size at every "
                        "distance")),
    "larger": (N_("La&rger points"), "", "magnify-plus-outline", "+", N_("Draw larger points")),
    "smaller": (N_("S&maller points"), "", "magnify-minus-outline", "-", N_("Draw smaller points")),
    "colour_next": (N_("&Next colouring"), "", "palette-outline", "C",
                    N_("Switch to the next colouring: line, height, intensity, range, time, "
                       "residual")),
    "colour_line": (N_("Colour by &line"), "", "", "", N_("Give each line its own colour")),
    "colour_height": (N_("Colour by &height"), "", "", "", N_("Colour the points by height")),
    "colour_intensity": (N_("Colour by &intensity"), "", "", "",
                         N_("Colour the points by the intensity in their file")),
    "colour_range": (N_("Colour by &range"), "", "", "",
                     N_("Colour the points by their distance from the scanner")),
    "colour_time": (N_("Colour by ti&me"), "", "", "",
                    N_("Colour the points by the time of measurement")),
    "picture": (N_("Sa&ve the picture…"), "", "camera-outline", "P",
                N_("Save the view as a PNG file")),
    "copy_picture": (N_("Cop&y the picture"), "", "", "Shift+P",
                     N_("Copy the view to the clipboard")),
    "colour_residual": (N_("Colour by r&esidual"), "", "", "",
                        N_("Colour targets by the distance from the adjusted surface, and "
                           "validation planes by the distance from the plane fitted to all "
                           "displayed lines")),
    "arrange": (N_("&Restore default layout"), "", "", "",
                N_("Restore the default layout of all panels")),
    "theme_system": (N_("&System default"), "", "", "",
                     N_("Use the light or dark theme of the system")),
    "theme_light": (N_("&Light"), "", "", "", N_("Use dark text on a light background")),
    "theme_dark": (N_("&Dark"), "", "", "", N_("Use light text on a dark background")),
}  # fmt: skip

INSPECT_ACTIONS: dict[str, ActionSpec] = {
    "section": (N_("&Section across the target"), "", "", "S",
                N_("Show a section of all lines across the selected target at true scale")),
    "section_points": (N_("Section &between two points"), "", "", "Shift+S",
                       N_("Cut a section between two clicked points")),
    "section_picture": (N_("Save the section's &picture…"), "", "", "Ctrl+P",
                        N_("Save the section as shown, as PNG, SVG or PDF")),
    "copy_section": (N_("Cop&y the section's picture"), "", "", "Ctrl+Shift+P",
                     N_("Copy the section as shown to the clipboard")),
    "measure_distance": (N_("Measure a &distance"), "", "ruler", "M",
                         N_("Click two points to measure their slope, horizontal and vertical "
                            "distance")),
    "measure_angle": (N_("Measure an &angle"), "", "", "Shift+M",
                      N_("Click a point, the vertex and another point to measure the angle")),
    "clip": (N_("&Clip box"), "", "crop", "X",
             N_("Draw only the points in a box around the selected target")),
    "wipe": (N_("Before a&nd after in a split view"), "", "", "W",
             N_("Show the lines before on the left and after on the right of a divider that "
                "follows the mouse")),
    "hover": (N_("S&how plane under the mouse"), "", "", "H",
              N_("Outline the plane that a Ctrl+click at the mouse position would pick")),
    "lasso_add": (N_("A&dd points with a lasso"), "", "lasso", "L",
                  N_("Draw around points near the selected target to add them to it")),
    "lasso_remove": (N_("Re&move points with a lasso"), "", "", "Shift+L",
                     N_("Draw around points of the selected target to remove them from it")),
    "change_role": (N_("Change &role of target"), "", "", "F8",
                    N_("Turn the selected target into a validation plane, or the reverse")),
    "patch_point": (N_("Add object &for the patch test"), "", "", "Ctrl+Shift+T",
                    N_("Put a patch-test box around the next point that you click")),
    "end_tool": (N_("&End the mouse tool"), "", "", "Esc",
                 N_("End the measurement, the section or the lasso")),
}  # fmt: skip
"""Measurements and inspections with the mouse."""

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
    (N_("&Look from"), (*VIEWS, "normal")),
    "orthographic",
    "",
    "larger",
    "smaller",
    (N_("&Colour by"), (*COLOUR_ACTIONS.values(), "", "colour_next")),
    "",
    "picture",
    "copy_picture",
    "",
    "warnings",
    (N_("S&teps"), tuple(STEP_ACTIONS)),
    (N_("&Panels"), ("DOCKS", "", "arrange")),
    (N_("T&heme"), tuple(THEME_ACTIONS.values())),
    (N_("Lan&guage · Langue"), ("english", "french")),
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
TOGGLES = ("orthographic", "section_points", "measure_distance", "measure_angle", "clip",
            "wipe", "lasso_add", "lasso_remove", "hover", "patch_point")  # fmt: skip
"""Actions that are on or off, each by itself."""

KEYS = (
    (N_("View"), (
        (N_("Drag, arrows"), N_("rotate about the point under the mouse or the centre")),
        (N_("Shift + drag, Shift + arrows"),
         N_("pan the view; or drag with the middle or right button")),
        (N_("Wheel, Page up and down"), N_("zoom in and out")),
        (N_("Double click"), N_("centre the view on the point")),
        (N_("F, Shift + F"), N_("zoom to all points, zoom to the selected target")),
        ("1, 2, 3, 4, 5, 6", N_("isometric view, from the top, front, left, back, right")),
        ("7", N_("view along the normal of the selected target")),
        ("O", N_("switch between orthographic and perspective view")),
        ("+, −", N_("larger, smaller points")),
        ("C", N_("colour by line, height, intensity, range, time, residual")),
        ("B", N_("switch between before and after")),
        ("W", N_("split view before and after; Ctrl + arrows move the divider")),
        (N_("P, Shift + P"), N_("save the picture of the view, copy it")),
    )),
    (N_("Designing a survey (Ctrl + Shift + D)"), (
        (N_("Drag a line or its arrow"),
         N_("move or turn the line; with Shift continuously")),
        (N_("Drag a target"),
         N_("move the target along the wall and in height")),
        (N_("Page up and down"), N_("select a line or target")),
        (N_("Arrows, Shift + arrows"), N_("move or turn the selection in small steps")),
        (N_("Insert, Delete"), N_("add or remove a line or target")),
        (N_("Ctrl + D, Alt + Up, Down"), N_("duplicate the line, move it up or down in the "
                                            "order")),
        (N_("Ctrl + L, Ctrl + B"), N_("add a line, a board")),
        (N_("Ctrl + Shift + B"), N_("add a sphere")),
        ("F9", N_("compare scenarios")),
        ("F10", N_("simulate surveys to check the standard deviations")),
        ("F11", N_("compare the survey design with the open project")),
    )),
    (N_("Inspection"), (
        (N_("S, Shift + S"), N_("cut a section across the selected target, between two points")),
        (N_("Ctrl + P, Ctrl + Shift + P"), N_("save the picture of the section, copy it")),
        (N_("M, Shift + M"), N_("measure a distance, an angle")),
        ("X", N_("show or remove the clip box around the selected target")),
        ("H", N_("outline the plane that a Ctrl+click would pick")),
        (N_("Ctrl + T, Ctrl + Shift + T"), N_("show the patch test, add a box around an object")),
        (N_("Esc"), N_("end the measurement, the section or the lasso")),
    )),
    (N_("Targets"), (
        (N_("Ctrl + click"), N_("pick a target")),
        (N_("F3, Shift + F3"), N_("enter the coordinates of a seed, read a list of seeds")),
        (N_("Enter, Esc"), N_("accept or reject the detected target")),
        (N_("F5, Shift + F5"), N_("propose targets, search for the selected target again")),
        ("F6, F7", N_("next Ctrl + click picks a target, a validation plane")),
        ("F8", N_("turn the target into a validation plane, or the reverse")),
        (N_("L, Shift + L"), N_("lasso: add points to the selected target, remove points")),
    )),
    (N_("Project"), (
        (N_("Ctrl + 1, 2, 3, 4, 5"), N_("go to a step of the workflow")),
        ("F9, F10", N_("estimate the boresight, validate")),
        (N_("Shift + F9"), N_("run the point spacing study")),
        (N_("Shift + F10, F11"), N_("check against a reference, compare calibrations")),
        ("F12", N_("list all warnings")),
        (N_("Ctrl + ."), N_("cancel the running task")),
        (N_("Ctrl + E, Ctrl + Shift + E"), N_("export the report, the georeferenced lines")),
        (N_("Ctrl + Z, Ctrl + Y"), N_("undo, redo")),
        (N_("Ctrl + N, Ctrl + O, Ctrl + S"), N_("new project, open, save")),
    )),
)  # fmt: skip
"""Headings of the list of keys, and the rows below each."""
