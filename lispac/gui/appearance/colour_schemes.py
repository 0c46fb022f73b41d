"""Colour schemes of the window, light and dark, by purpose."""

from dataclasses import dataclass

from lispac.present.line_colours import LINE_COLOURS, NEGATIVE_COLOUR, POSITIVE_COLOUR

Colour = tuple[int, int, int]
Lines = tuple[Colour, ...]


@dataclass(frozen=True)
class ColourScheme:
    """Colours of a scheme as ``#rrggbb``.

    The name of a colour states its purpose. Messages with a background have three colours: text,
    background and border.

    Attributes
    ----------
    window, paper, bar, alternate : backgrounds
        Of the window, of fields and drawings, of toolbars and step headers, of every other row.
    text, muted, placeholder : text on each of these backgrounds
    disabled, disabled_ground, disabled_fill, disabled_icon
        Disabled widgets, with less contrast.
    accent, on_accent : selected, active or focused items, as lines or text
    fill, fill_hover, on_fill : main button and selected text
    done, warning, error, doubtful : ratings, always shown with a symbol or a word as well
    before, after : before and after the calibration
    frame : frames of check boxes and input fields
    border, edge, edge_strong, grid : separating lines
    hover, pressed, chosen, chosen_edge, on_chosen, current : buttons, tabs and rows
    series, on_series : data series of a figure, and text on them
    lines : RGB of the survey lines, in their order
    """

    name: str
    window: str
    paper: str
    bar: str
    alternate: str
    header: str
    title: str
    text: str
    muted: str
    placeholder: str
    disabled: str
    disabled_ground: str
    disabled_fill: str
    disabled_icon: str
    accent: str
    on_accent: str
    fill: str
    fill_hover: str
    fill_edge: str
    on_fill: str
    done: str
    warning: str
    error: str
    doubtful: str
    waiting: str
    before: str
    after: str
    border: str
    frame: str
    edge: str
    edge_strong: str
    grid: str
    hover: str
    pressed: str
    chosen: str
    chosen_edge: str
    on_chosen: str
    current: str
    warning_text: str
    warning_ground: str
    warning_edge: str
    hint_text: str
    hint_ground: str
    hint_edge: str
    wrong_ground: str
    progress: str
    positive: str
    negative: str
    level: str
    wall: str
    moved: str
    hull: str
    body_axis: str
    axis_x: str
    axis_y: str
    axis_z: str
    hatch: str
    desk: str
    note: str
    sky: str
    ground: str
    series: tuple[str, str, str]
    on_series: str
    lines: Lines

    @property
    def is_dark(self) -> bool:
        """Whether the text is lighter than the background."""
        return luminance(self.text) > luminance(self.window)


def luminance(colour: str) -> float:
    """Relative luminance of ``#rrggbb``, 0 to 1 (WCAG 2.2)."""
    shares = (int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5))
    red, green, blue = (
        share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4 for share in shares
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


LIGHT_SCHEME = ColourScheme(
    name="light",
    window="#f3f5f8",
    paper="#ffffff",
    bar="#fbfcfd",
    alternate="#f7f9fb",
    header="#eef1f5",
    title="#e7ebf0",
    text="#1c2733",
    muted="#586573",
    placeholder="#626e7a",
    disabled="#93a0ac",
    disabled_ground="#f1f3f5",
    disabled_fill="#c3d0de",
    disabled_icon="#a9b3bd",
    accent="#1f5fa8",
    on_accent="#ffffff",
    fill="#1f5fa8",
    fill_hover="#2a6fbd",
    fill_edge="#0b325f",
    on_fill="#ffffff",
    done="#1b774a",
    warning="#a85508",
    error="#b3261e",
    doubtful="#c96f00",
    waiting="#7d8a97",
    before="#0072b2",
    after="#8c510a",
    border="#d3dae1",
    frame="#7f8c9a",
    edge="#c3ccd5",
    edge_strong="#9fb4ca",
    grid="#e4e9ed",
    hover="#e8eef5",
    pressed="#dfe9f4",
    chosen="#d6e4f4",
    chosen_edge="#a9c4e2",
    on_chosen="#0b325f",
    current="#e3edf8",
    warning_text="#6d3703",
    warning_ground="#fdf1e3",
    warning_edge="#eccfa6",
    hint_text="#123f72",
    hint_ground="#e9f1fa",
    hint_edge="#cfe0f2",
    wrong_ground="#fdeceb",
    progress="#7fb0e2",
    positive=POSITIVE_COLOUR,
    negative=NEGATIVE_COLOUR,
    level="#7fb0e2",
    wall="#8a8f98",
    moved="#c24d00",
    hull="#eef2f6",
    body_axis="#7b8794",
    axis_x="#c62828",
    axis_y="#1b774a",
    axis_z="#1f5fa8",
    hatch="#e4a7a2",
    desk="#8d96a0",
    note="#ffecaa",
    sky="#fcfeff",
    ground="#dbe2e7",
    # Blue, vermilion and green of Okabe and Ito.
    series=("#0072b2", "#d55e00", "#009e73"),
    on_series="#ffffff",
    lines=LINE_COLOURS,
)

DARK_SCHEME = ColourScheme(
    name="dark",
    window="#1f252c",
    paper="#171c22",
    bar="#242b33",
    alternate="#1c222a",
    header="#2a323b",
    title="#2b343e",
    text="#e4e9ee",
    muted="#a3b0bd",
    placeholder="#93a0ad",
    disabled="#6f7c89",
    disabled_ground="#22282f",
    disabled_fill="#37424e",
    disabled_icon="#5c6874",
    accent="#6cb0f5",
    on_accent="#0e1317",
    fill="#2a71c0",
    fill_hover="#2f74c1",
    fill_edge="#cfe4fb",
    on_fill="#ffffff",
    done="#55c08a",
    warning="#f0a04b",
    error="#ff8a80",
    doubtful="#f5a742",
    waiting="#7d8a97",
    before="#56b4e9",
    after="#e0a458",
    border="#3b4651",
    frame="#75869a",
    edge="#56636f",
    edge_strong="#75869a",
    grid="#2c353e",
    hover="#313c48",
    pressed="#3a4756",
    chosen="#2c4868",
    chosen_edge="#4674a3",
    on_chosen="#dcebfb",
    current="#263a50",
    warning_text="#f8cf9b",
    warning_ground="#3d2c18",
    warning_edge="#6d4f2a",
    hint_text="#bcdcfb",
    hint_ground="#1d3148",
    hint_edge="#33557a",
    wrong_ground="#4a2324",
    progress="#235f9f",
    positive="#2a649e",
    negative="#8a5418",
    level="#4f86bd",
    wall="#8a929c",
    moved="#ff9248",
    hull="#2a333d",
    body_axis="#8d9aa7",
    axis_x="#ff7a70",
    axis_y="#55c08a",
    axis_z="#6cb0f5",
    hatch="#8c4a46",
    desk="#11151a",
    note="#55481a",
    sky="#2b343d",
    ground="#12161b",
    series=("#56a8e0", "#f08a45", "#35c096"),
    on_series="#0e1317",
    # The same order of hues; dark colours are lighter, for contrast with the dark background.
    lines=(
        (51, 148, 214),
        (240, 175, 30),
        (0, 178, 130),
        (214, 136, 180),
        (120, 200, 245),
        (232, 110, 30),
        (140, 125, 240),
        (176, 176, 66),
        (205, 80, 140),
        (70, 165, 90),
    ),
)
SCHEMES = {scheme.name: scheme for scheme in (LIGHT_SCHEME, DARK_SCHEME)}
"""Colour schemes by name."""
