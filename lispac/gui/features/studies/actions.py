"""Actions that show studies."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("methods", N_("Compare with other &methods…"),
        N_("Estimate the boresight from the validation planes and from the scene without "
           "targets, and compare the results"), ("Calibrate", 2, 3), keys="Ctrl+F9",
        uses_values=True),
    ActionRecord("correspondences", N_("Poi&nt correspondences…"),
        N_("Estimate the boresight from a file of pairs of points of the same place, and compare "
           "the result with the others"), ("Calibrate", 2, 5), uses_values=True),
    ActionRecord("subsampling", N_("Point &spacing study…"),
        N_("Repeat the adjustment with smaller and larger point spacings, and compare the results"),
        ("Calibrate", 3, 1), keys="Shift+F9", uses_values=True),
    ActionRecord("visibility", N_("V&isibility of errors…"),
        N_("Show for each systematic error the boards and lines that make it visible"),
        ("Calibrate", 3, 2), uses_values=True),
    ActionRecord("check", N_("Check against a &reference…"),
        N_("Compare the lines with a static scan or surveyed points"), ("Calibrate", 2, 1),
        keys="Shift+F10", uses_values=True),
    ActionRecord("line_quality", N_("Differences between &lines…"),
        N_("Compute the distances between each two lines on flat areas of the scene, with the "
           "boresight used in the view"), ("Calibrate", 2, 2), keys="Ctrl+F10", uses_values=True),
    ActionRecord("budget", N_("Error &budget…"),
        N_("Compute the effect of each error source on a point at a given range"),
        ("Calibrate", 3, 3), uses_values=True),
    ActionRecord("history", N_("Calibrations over the &years…"),
        N_("Compare all calibrations of a vessel’s system to detect a change of its mounting"),
        ("Calibrate", 4, 2), keys="Ctrl+F11"),
)  # fmt: skip
