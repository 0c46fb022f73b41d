"""Tests of the API reference: no build warnings, no broken references, no missing names."""

import zlib
from pathlib import Path

import pytest

import lispac
from tests.reference import pages, resolving
from tests.support.public_names import public, trees


def inventory(built: Path) -> set[str]:
    """Return the names documented in the built pages, from `objects.inv`."""
    content = (built / "objects.inv").read_bytes().split(b"\n", 4)[4]
    return {line.split(" ")[0] for line in zlib.decompress(content).decode().splitlines()}


def documented_names(dotted: str) -> set[str]:
    """Return the public names of a module under which the reference documents them."""
    path = f"{dotted.replace('.', '/')}"
    module = f"{path}.py" if f"{path}.py" in trees() else f"{path}/__init__.py"
    package = module.split("/")[1]
    found = (name for name in public(package) if name.module == module)
    return {resolving.documented_as(f"{dotted}.{name.name}") for name in found}


@pytest.fixture(scope="module")
def scripts(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the pages for script authors; any warning of Sphinx fails."""
    folder = tmp_path_factory.mktemp("reference")
    assert pages.build(folder, whole=False) == ""
    return folder


def test_scripting_names_are_documented_with_an_example(scripts: Path) -> None:
    there = inventory(scripts)
    assert {f"lispac.{name}" for name in lispac.__all__ if name != "__version__"} <= there
    own = documented_names("lispac.scripting.open_project")
    assert {"lispac.OpenProject.seed", "lispac.OpenProject.boresight_deg"} < own
    assert own <= there
    text = (scripts / "scripts_api.html").read_text("utf-8")
    assert 'class="n">reject</span>' in text


def test_every_developer_document_has_a_page(scripts: Path) -> None:
    for source in pages.DEVELOPERS.rglob("*.md"):
        page = scripts / "developers" / source.relative_to(pages.DEVELOPERS)
        assert page.with_suffix(".html").is_file(), source.name


@pytest.mark.long
def test_a_broken_reference_fails_the_build(tmp_path: Path) -> None:
    sources = tmp_path / "sources"
    sources.mkdir()
    names = "`SEMI_MAJOR_AXIS`, `ValueError`, `no_such_name`"
    (sources / "index.rst").write_text(f"One\n===\n\nSee {names}.\n")
    output = pages.run(sources, tmp_path / "out")
    assert "reference target not found: no_such_name" in output
    assert output.count("WARNING") == 1
    assert output.endswith("Sphinx refuses.")


def test_every_module_of_the_core_has_a_page(tmp_path: Path) -> None:
    pages.write(tmp_path / "sources")
    written = "\n".join(page.read_text("utf-8") for page in (tmp_path / "sources").glob("*.rst"))
    modules = {
        name.removesuffix(".py").removesuffix("/__init__").replace("/", ".") for name in trees()
    }
    assert len(modules) > 300
    for module in modules - {"lispac", "lispac.__main__"}:
        assert f".. automodule:: {module}\n" in written


@pytest.mark.long
@pytest.mark.timeout(900)
def test_every_public_name_of_the_core_is_documented(tmp_path: Path) -> None:
    assert pages.build(tmp_path) == ""
    there = inventory(tmp_path)
    expected: set[str] = set()
    for module in trees():
        dotted = module.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
        expected |= (
            documented_names(dotted) if dotted not in ("lispac", "lispac.__main__") else set()
        )
    assert len(expected) > 1500
    assert expected - there == set()
    # Sphinx leaves the markup of autodoc in signatures that it cannot parse.
    unread = [
        page.name for page in tmp_path.glob("*.html") if "~lispac." in page.read_text("utf-8")
    ]
    assert unread == []


def test_every_section_of_the_reference_has_modules() -> None:
    packages = {pages.package_of(name.removesuffix(".py").replace("/", ".")) for name in trees()}
    assert pages.PACKAGES.keys() <= packages
