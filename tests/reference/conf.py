"""Configuration of Sphinx for the API reference, whose pages `tests.reference.pages` writes."""

import re
from pathlib import Path
from types import GenericAlias
from typing import Any

import numpy.typing
from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.ext.napoleon import Config, NumpyDocstring
from sphinx.roles import XRefRole

from tests.reference import resolving

HERE = Path(__file__).resolve().parent

# Types in docstrings are texts ("ndarray of shape (n, 3), metres, local frame"), not names.
SECTIONS = Config(
    napoleon_use_param=False,
    napoleon_use_rtype=False,
    napoleon_custom_sections=[("Attributes", "params_style")],
)
project = "LISPAC"
html_title = "LISPAC API reference"
language = "en"
extensions = ["sphinx.ext.autodoc", "myst_parser"]
myst_heading_anchors = 3
nitpicky = True
nitpick_ignore_regex = [("py:.*", rf"({'|'.join(resolving.FOREIGN)})(\..*)?")]
default_role = "named"
smartquotes_action = "D"  # convert dashes only
add_module_names = False
toc_object_entries_show_parents = "hide"
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 88
autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
autodoc_typehints_format = "short"
html_theme = "furo"
html_static_path = [str(HERE.parents[1] / "resources/manual/_static"), str(HERE / "static")]
html_css_files = ["manual.css", "reference.css"]
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_show_sourcelink = False
pygments_style = "friendly"


class Named(XRefRole):
    """Role for a name in single backticks: of this module, or unique in another one."""

    def process_link(
        self, env: BuildEnvironment, refnode: Any, has_explicit_title: bool, title: str, target: str
    ) -> tuple[str, str]:
        """Resolve the name like the types of signatures."""
        refnode["refdomain"] = "py"
        refnode["reftype"] = "obj"
        refnode["refspecific"] = True
        refnode["py:module"] = env.ref_context.get("py:module")
        refnode["py:class"] = env.ref_context.get("py:class")
        return title, target.strip()


def _resolve(
    app: Sphinx, env: BuildEnvironment, node: pending_xref, content: nodes.TextElement
) -> nodes.Node | None:
    """Resolve a name that Sphinx does not find as written."""
    target = resolving.documented_as(node["reftarget"])
    domain = env.domains["py"]
    if target in domain.objects and target != node["reftarget"]:
        return domain.resolve_xref(env, node["refdoc"], app.builder, "obj", target, node, content)
    return content if resolving.is_there(node["reftarget"]) else None


def _in_sections(
    app: Sphinx, _what: str, name: str, obj: object, _options: object, lines: list[str]
) -> None:
    """Format sections like napoleon, which would read "Metres: of what" of a value as a type."""
    lines[:] = str(NumpyDocstring(list(lines), SECTIONS, app, "function", name, obj)).splitlines()


def _skip(
    _app: Sphinx, _what: str, _name: str, obj: object, _skipped: bool, _options: object
) -> bool | None:
    """Skip fields of named tuples, which are documented by their number only."""
    return True if str(obj.__doc__).startswith("Alias for field number") else None


def _without_objects(
    _app: Sphinx,
    _what: str,
    _name: str,
    _obj: object,
    _options: object,
    signature: str | None,
    returns: str | None,
) -> tuple[str | None, str | None]:
    """Remove default values that are not valid Python (``<factory>``) from a signature."""
    return signature and re.sub(r"<[^<>]+>", "...", signature), returns


def _without_dashes(_app: Sphinx, doctree: nodes.document) -> None:
    """Remove the dash after an error that has no description."""
    for paragraph in doctree.findall(nodes.paragraph):
        last = paragraph.children[-1] if paragraph.children else None
        if isinstance(last, nodes.Text) and last.strip() in ("--", "\N{EN DASH}"):
            paragraph.remove(last)


class NDArray:
    """Stand-in that keeps its name; NumPy's shows ``ndarray[tuple[Any, ...], dtype[...]]``."""

    __class_getitem__ = classmethod(GenericAlias)
    __module__ = "numpy.typing"


numpy.typing.NDArray = NDArray


def _fold_list(
    _app: Sphinx, _page: str, _template: str, context: dict[str, Any], _tree: object
) -> None:
    """Restrict the navigation to modules of the page's package; full ones take minutes."""
    whole = context["toctree"]
    context["toctree"] = lambda **options: whole(**{**options, "collapse": True})


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the handlers (called by Sphinx)."""
    app.add_role("named", Named())
    app.connect("autodoc-process-docstring", _in_sections)
    app.connect("missing-reference", _resolve)
    app.connect("autodoc-process-signature", _without_objects)
    app.connect("autodoc-skip-member", _skip)
    app.connect("doctree-read", _without_dashes)
    app.connect("html-page-context", _fold_list, priority=100)  # before that of the theme
    return {"parallel_read_safe": True, "parallel_write_safe": True}
