"""Pages of the API reference: scripting API, developer documents, and a page for each module."""

import ast
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from tests.reference.resolving import script_names
from tests.support.public_names import trees

HERE = Path(__file__).resolve().parent
CHECKOUT = HERE.parents[1]
MANUAL = CHECKOUT / "resources" / "manual" / "en"
DEVELOPERS = CHECKOUT / "resources" / "developers"
PACKAGES = {
    "workflow": "Use cases",
    "io": "Files",
    "report": "Report",
    "present": "Results as values and tables",
    "design": "Design",
    "simulation": "Simulation",
    "validation": "Validation",
    "adjustment": "Adjustment",
    "natural": "Natural surfaces",
    "patchtest": "LiDAR patch test",
    "correspondences": "Point correspondences",
    "targets": "Targets",
    "survey": "Survey",
    "geometry": "Geometry",
    "message_texts": "Texts of messages",
    "scripting": "Scripting",
    "cli": "Command line",
    "others": "Used by all packages",
}
"""Titles of the packages of the core; ``others`` are single modules. The GUI is not included."""


def build(folder: Path, *, whole: bool = True) -> str:
    """Build the reference into a folder; return the output of Sphinx, empty without warnings.

    Parameters
    ----------
    whole : whether to include the packages, or only the scripting API
    """
    with tempfile.TemporaryDirectory(prefix="lispac-") as scratch:
        write(Path(scratch, "sources"), whole=whole)
        return run(Path(scratch, "sources"), folder)


def run(sources: Path, folder: Path) -> str:
    """Run Sphinx on sources; return its output, empty without warnings."""
    with tempfile.TemporaryDirectory(prefix="lispac-") as scratch:
        command = [sys.executable, "-m", "sphinx", "-q", "-b", "html", "-W", "--keep-going"]
        command += ["-c", str(HERE), "-d", scratch, str(sources), str(folder.resolve())]
        # Without compilation, the compiled functions have their Python signatures and docstrings.
        variables = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
        if sys.pycache_prefix is None:  # no bytecode beside the sources
            variables["PYTHONDONTWRITEBYTECODE"] = "1"
        done = subprocess.run(
            command, capture_output=True, text=True, check=False, env=variables, cwd=CHECKOUT
        )
    return f"{done.stderr}\nSphinx refuses." if done.returncode else done.stderr


def write(sources: Path, *, whole: bool = True) -> None:
    """Write the sources of the pages into a new folder."""
    shutil.copytree(HERE / "texts", sources)
    shutil.copy(MANUAL / "scripts.md", sources / "scripts.txt")
    _copy_developer_pages(sources / "developers")
    listed = _list_of("", ["scripts_api", "developers/index"])
    if whole:
        modules = [name.removesuffix(".py").replace("/", ".") for name in trees()]
        modules = [name for name in modules if name not in ("lispac.__init__", "lispac.__main__")]
        for package in PACKAGES:
            _write_package(
                sources, package, [name for name in modules if package_of(name) == package]
            )
        listed += _list_of("Packages", list(PACKAGES))
    with (sources / "index.rst").open("a", encoding="utf-8") as index:
        index.write("\n".join(listed))


def _copy_developer_pages(folder: Path) -> None:
    """Copy the documents for developers and add the lists of pages that Sphinx needs."""
    shutil.copytree(DEVELOPERS, folder)
    for index, pages in {
        "index.md": (
            "architecture",
            "language",
            "testing",
            "dependencies",
            "recipes/*",
            "decisions/index",
        ),
        "decisions/index.md": ("[0-9]*",),
    }.items():
        with (folder / index).open("a", encoding="utf-8") as file:
            file.write("\n".join(["", "```{toctree}", ":hidden:", ":glob:", *pages, "```", ""]))


def package_of(module: str) -> str:
    parts = module.split(".")
    return parts[1] if len(parts) > 2 else "others"


def _write_package(sources: Path, package: str, modules: list[str]) -> None:
    """Write the page of a package and those of its modules."""
    dotted = f"lispac.{package}"
    pages = {name.removesuffix(".__init__"): name for name in modules}
    lines = _titled(PACKAGES[package])
    if pages.pop(dotted, ""):
        lines += [f".. automodule:: {dotted}", "   :members:", ""]
    lines += [f"- :doc:`{_short(name)} <{name}>`: {_summary(pages[name])}" for name in pages]
    lines += _list_of("", list(pages), hidden=True)
    (sources / f"{package}.rst").write_text("\n".join(lines), encoding="utf-8")
    for name in pages:
        at_scripts = [full for full in script_names() if full.rpartition(".")[0] == name]
        hidden = ", ".join(full.rpartition(".")[2] for full in at_scripts)
        lines = _titled(_short(name))
        lines += [f".. automodule:: {name}", "   :members:", "   :ignore-module-all:"]
        lines += [f"   :exclude-members: {hidden}"] if hidden else []
        lines += ["   :show-inheritance:"] if name == "lispac.errors" else []
        if hidden:
            names = ", ".join(f":py:obj:`{script_names()[full]}`" for full in at_scripts)
            lines += ["", f"For scripts: {names}."]
        (sources / f"{name}.rst").write_text("\n".join([*lines, ""]), encoding="utf-8")


def _short(module: str) -> str:
    parts = module.split(".")
    return ".".join(parts[2:] or parts[1:])


def _summary(module: str) -> str:
    """First paragraph of a module's docstring."""
    words = ast.get_docstring(trees()[f"{module.replace('.', '/')}.py"]) or ""
    return words.partition("\n\n")[0].replace("\n", " ")


def _titled(title: str) -> list[str]:
    return [title, "=" * len(title), ""]


def _list_of(caption: str, pages: list[str], *, hidden: bool = False) -> list[str]:
    options = ["   :maxdepth: 1", *([f"   :caption: {caption}"] if caption else [])]
    options += ["   :hidden:"] if hidden else []
    return ["", ".. toctree::", *options, "", *(f"   {page}" for page in pages), ""]
