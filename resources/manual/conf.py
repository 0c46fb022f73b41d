"""Sphinx configuration of the manual.

`lispac/workflow/output/manual.py` runs Sphinx with this folder as the configuration folder and
``en`` or ``fr`` as the folder of the sources. Pages of one name in both languages are the same
page.
"""

import html
import re
from pathlib import Path
from typing import Any

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx
from sphinx.locale import get_translation
from sphinx.util.docutils import SphinxRole

HERE = Path(__file__).resolve().parent
LANGUAGES = {"en": "English", "fr": "Français"}
FRAME = {
    "Next": "Suivant",
    "Previous": "Précédent",
    "Home": "Accueil",
    "On this page": "Sur cette page",
    "Back to top": "Haut de la page",
    "Made with ": "Fait avec ",
}
"""Words of the theme, which knows no French."""
TITLES = {"en": "LISPAC manual", "fr": "Manuel de LISPAC"}

project = "LISPAC"
extensions = ["myst_parser"]
myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 3
# [text](en:mathematics#anchor) in a French page leads to the English one.
myst_url_schemes = {
    "http": None,
    "https": None,
    "en": {"url": "../en/{{path}}.html#{{fragment}}", "classes": ["in-english"]},
}
nitpicky = True
smartquotes_action = "q"  # dashes and dots stay as the program says them
exclude_patterns = ["tables/*"]  # included in pages; tests/documents/manual_tables.py writes them
highlight_language = "none"
html_theme = "furo"
html_static_path = ["_static"]
html_css_files = ["manual.css"]
templates_path = ["_templates"]
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_show_sourcelink = False
html_math_renderer = "mathml"
html_sidebars = {
    "**": [
        "sidebar/brand.html",
        "languages.html",
        "sidebar/search.html",
        "sidebar/scroll-start.html",
        "sidebar/navigation.html",
        "sidebar/scroll-end.html",
    ]
}


def _inline(translator: Any, node: nodes.math) -> None:
    translator.body.append(tex2mathml(node.astext(), as_block=False))
    raise nodes.SkipNode


def _display(translator: Any, node: nodes.math_block) -> None:
    formula = tex2mathml(node.astext(), as_block=True)
    translator.body.append(f'<div class="formula">{formula}</div>\n')
    raise nodes.SkipNode


class Typed(SphinxRole):
    """What is to be typed as it stands; `tests/support/tutorial_steps.py` types it."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        """Shown as letters of a typewriter."""
        return [nodes.literal(self.rawtext, self.text, classes=["typed"])], []


def _settle(app: Sphinx, config: Any) -> None:
    config.html_title = TITLES[config.language]


def _name_languages(
    app: Sphinx, page: str, _template: str, context: dict[str, Any], _tree: object
) -> None:
    """Leads to the same page in each language, and to the first where it has none."""
    if app.config.language == "fr":
        context["_"] = context["gettext"] = lambda text: (
            FRAME.get(text) or get_translation("sphinx")(text)
        )
    context["languages"] = [
        (
            html.escape(name),
            f"{'../' * (page.count('/') + 1)}{key}/"
            f"{page if (HERE / key / f'{page}.md').is_file() else 'index'}.html",
            key == app.config.language,
        )
        for key, name in LANGUAGES.items()
    ]


def _finish(app: Sphinx, doctree: nodes.document) -> None:
    """Pictures open in full by a click; French signs are not parted from their words."""
    for image in doctree.findall(nodes.image):
        image["width"] = "100%"
    if app.config.language != "fr":
        return
    for text in list(doctree.findall(nodes.Text)):
        if not isinstance(text.parent, (nodes.literal, nodes.literal_block, nodes.math)):
            bound = re.sub(r" (?=[:;?!»%])|(?<=«) ", "\N{NO-BREAK SPACE}", str(text))
            text.parent.replace(text, nodes.Text(bound))


def setup(app: Sphinx) -> dict[str, Any]:
    """Called by Sphinx: formulas become MathML, which browsers draw without a script."""
    app.add_html_math_renderer("mathml", (_inline, None), (_display, None))
    app.add_role("typed", Typed())
    app.connect("config-inited", _settle)
    app.connect("doctree-read", _finish)
    app.connect("html-page-context", _name_languages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
