"""Actions on targets."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("seed_target", N_("Pick an adjustment &target"),
        N_("The next Ctrl+click in the view picks an adjustment target"), ("Targets", 1, 1),
        toolbar=(3, 1), short=N_("Target"), icon="target", keys="F6", choice="seed"),
    ActionRecord("seed_validation", N_("Pick a &validation plane"),
        N_("The next Ctrl+click in the view picks a validation plane"), ("Targets", 1, 2),
        toolbar=(3, 2), short=N_("Plane"), icon="shield-check-outline", keys="F7",
        choice="seed"),
    ActionRecord("seed_coordinates", N_("Enter seed &coordinates…"),
        N_("Enter the coordinates of a seed point in the local frame or in map projection, and "
           "detect its target"), ("Targets", 1, 3), icon="crosshairs-gps", keys="F3",
        uses_values=True),
    ActionRecord("seed_list", N_("Read seeds &from a file…"),
        N_("Read seed coordinates from a file, for example from a total station, and detect "
           "their targets"), ("Targets", 1, 4), icon="format-list-bulleted", keys="Shift+F3",
        uses_values=True),
    ActionRecord("propose", N_("&Propose targets"),
        N_("Find flat surfaces in all lines and propose targets and validation planes"),
        ("Targets", 2, 1), icon="auto-fix", keys="F5", uses_values=True),
    ActionRecord("accept", N_("&Accept detected target"),
        N_("Add the detected target or validation plane to the project"), ("Targets", 3, 1),
        icon="check-bold", keys=("Return", "Enter")),
    ActionRecord("reject", N_("Re&ject detected target"),
        N_("Discard the detected target or validation plane"), ("Targets", 3, 2), icon="close",
        keys="Esc"),
    ActionRecord("find_again", N_("Search aga&in with other settings…"),
        N_("Search for the selected target with another threshold or search radius"),
        ("Targets", 4, 1), icon="refresh", keys="Shift+F5", uses_values=True),
    ActionRecord("hover", N_("S&how plane under the mouse"),
        N_("Outline the plane that a Ctrl+click at the mouse position would pick"),
        ("Targets", 4, 2), keys="H", toggles=True),
    ActionRecord("change_role", N_("Change &role of target"),
        N_("Turn the selected target into a validation plane, or the reverse"), ("Targets", 5, 1),
        keys="F8"),
    ActionRecord("lasso_add", N_("A&dd points with a lasso"),
        N_("Draw around points near the selected target to add them to it"), ("Targets", 5, 2),
        icon="lasso", keys="L", toggles=True),
    ActionRecord("lasso_remove", N_("Re&move points with a lasso"),
        N_("Draw around points of the selected target to remove them from it"), ("Targets", 5, 3),
        keys="Shift+L", toggles=True),
)  # fmt: skip
