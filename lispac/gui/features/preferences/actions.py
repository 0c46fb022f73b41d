"""Actions of the preferences."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.gui.app.settings import THEMES
from lispac.language import N_

THEME_ACTIONS = {choice: f"theme_{choice}" for choice in THEMES}
"""Action of each theme."""

ACTIONS = by_name(
    ActionRecord("settings", N_("Sett&ings…"),
        N_("Set the language, the view, the report and the sensor library"), ("File", 5, 1),
        icon="cog-outline", keys="Ctrl+,"),
    ActionRecord("theme_system", N_("&System default"),
        N_("Use the light or dark theme of the system"), ("Theme", 1, 1), choice="theme"),
    ActionRecord("theme_light", N_("&Light"), N_("Use dark text on a light background"),
        ("Theme", 1, 2), choice="theme"),
    ActionRecord("theme_dark", N_("&Dark"), N_("Use light text on a dark background"),
        ("Theme", 1, 3), choice="theme"),
    ActionRecord("english", "&English", N_("Switch the window to English"), ("Language", 1, 1),
        choice="language"),
    ActionRecord("french", "&Français", "Fenêtre en français", ("Language", 1, 2),
        choice="language"),
)  # fmt: skip
