"""Tests of the structure of the code: locked dependencies, one version, light imports."""

import os
import re
import subprocess
import sys
import tomllib
from itertools import chain
from pathlib import Path

import pytest

import lispac

CHECKOUT = Path(__file__).resolve().parents[2]
LOCKS = ["installer/lock-run.txt", "installer/lock-test.txt", "installer/lock-bundle.txt"]
HEAVY_MODULES = {
    "PySide6",
    "laspy",
    "matplotlib",
    "numba",
    "numpy",
    "open3d",
    "pyproj",
    "pyvista",
    "scipy",
    "vtk",
    "vtkmodules",
}
LATE_MODULES = {
    "dask",
    "distributed",
    "dpkt",
    "fontTools",
    "laspy",
    "matplotlib",
    "numba",
    "open3d",
    "pyvista",
    "pyvistaqt",
    "scipy.linalg",
    "scipy.ndimage",
    "scipy.optimize",
    "scipy.signal",
    "scipy.spatial",
    "scipy.special",
    "scipy.stats",
    "velodyne_decoder",
    "vtkmodules",
}
"""Modules that the window imports when it needs them or after it has been drawn."""


def requirements(lock: str) -> dict[str, list[str]]:
    """Hashes of the requirements of a lock file, by name, version and marker."""
    text = (CHECKOUT / lock).read_text(encoding="utf-8").replace("\\\n", " ")
    found: dict[str, list[str]] = {}
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            requirement, *hashes = re.split(r"\s+--hash=", line.strip())
            found[requirement] = hashes
    return found


def pyproject() -> dict:
    """Content of ``pyproject.toml``."""
    return tomllib.loads((CHECKOUT / "pyproject.toml").read_text(encoding="utf-8"))


def normalised(requirement: str) -> str:
    """Name of a requirement as written in lock files."""
    return re.sub(r"[-_.]+", "-", re.match(r"[\w.-]+", requirement).group()).lower()


@pytest.mark.parametrize("lock", LOCKS)
def test_every_locked_package_has_a_version_and_hashes(lock: str) -> None:
    locked = requirements(lock)
    assert len(locked) > 50
    for requirement, hashes in locked.items():
        assert re.match(r"[a-z0-9-]+==\d", requirement), requirement
        assert hashes, requirement
        assert all(re.fullmatch(r"sha256:[0-9a-f]{64}", value) for value in hashes), requirement


@pytest.mark.parametrize("lock", LOCKS)
def test_lock_files_contain_no_address(lock: str) -> None:
    text = (CHECKOUT / lock).read_text(encoding="utf-8")
    assert not re.search(r"://|--index|--extra-index|--find-links|file:", text)


@pytest.mark.parametrize("lock", LOCKS[1:])
def test_other_lock_files_contain_the_run_dependencies(lock: str) -> None:
    """The marker may be missing in the other lock: the package is then installed on all systems."""
    run, test = (requirements(name) for name in (LOCKS[0], lock))
    anywhere = {name: name if name in test else name.partition(" ")[0] for name in run}
    assert {test_name: run[name] for name, test_name in anywhere.items()}.items() <= test.items()


def test_every_dependency_is_locked() -> None:
    project = pyproject()["project"]
    extras = project["optional-dependencies"]
    run, test, bundle = ({normalised(name) for name in requirements(lock)} for lock in LOCKS)
    assert {normalised(name) for name in project["dependencies"] + extras["build"]} <= run
    assert {normalised(name) for name in extras["cluster"] + extras["tests"]} <= test
    assert {normalised(name) for name in extras["bundle"]} <= bundle


def test_every_dependency_has_a_documented_reason() -> None:
    table = "resources/developers/dependencies.md"
    reasons = (CHECKOUT / table).read_text(encoding="utf-8").lower()
    project = pyproject()["project"]
    extras = project["optional-dependencies"].values()
    for requirement in chain(project["dependencies"], *extras):
        name = normalised(requirement)
        assert f"`{name}`" in reasons, f"{table} gives no reason for {name}"


def test_the_version_is_defined_in_one_place() -> None:
    settings = pyproject()
    assert "version" not in settings["project"]
    assert settings["tool"]["hatch"]["version"]["path"] == "lispac/version.py"
    assert re.fullmatch(r"\d+\.\d+\.\d+", lispac.__version__)


def test_changelog_and_citation_name_the_current_version() -> None:
    assert f"## {lispac.__version__}" in (CHECKOUT / "CHANGELOG.md").read_text(encoding="utf-8")
    cited = (CHECKOUT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"\nversion: {lispac.__version__}\n" in cited


def run_python(code: str) -> subprocess.CompletedProcess[str]:
    """Run code in a new interpreter in the checkout."""
    variables = {**os.environ, "PYTHONPATH": str(CHECKOUT)}
    command = [sys.executable, "-c", code]
    return subprocess.run(
        command, capture_output=True, text=True, check=False, env=variables, timeout=60
    )


@pytest.mark.parametrize("argument", ["--version", "--help"])
def test_command_line_starts_without_heavy_modules(argument: str) -> None:
    code = f"""
import sys
from lispac.cli.main import main
try:
    code = main(["{argument}"])
except SystemExit as stop:
    code = stop.code
print(*sorted(name for name in sys.modules if "." not in name), file=sys.stderr)
sys.exit(code)
"""
    done = run_python(code)
    assert done.returncode == 0, done.stderr
    if argument == "--version":
        assert lispac.__version__ in done.stdout
    assert not HEAVY_MODULES & set(done.stderr.split())


def test_no_command_imports_heavy_modules_before_it_runs() -> None:
    done = run_python(
        "import sys; from lispac.cli.parser import build_parser; build_parser();print(*sys.modules)"
    )
    assert done.returncode == 0, done.stderr
    assert not HEAVY_MODULES & set(done.stdout.split())


def test_importing_the_package_imports_no_heavy_module() -> None:
    done = run_python("import lispac, sys; print(*sys.modules)")
    assert done.returncode == 0, done.stderr
    loaded = set(done.stdout.split())
    assert not HEAVY_MODULES & loaded
    own = {name for name in loaded if name.startswith("lispac")}
    assert own == {"lispac", "lispac.version"}


def test_the_window_starts_without_modules_that_it_needs_later() -> None:
    done = run_python(
        "import lispac.gui.window.program, lispac.gui.window.session, sys;"
        "import lispac.gui.viewport.lazy_viewport;"
        "print(*sys.modules)"
    )
    assert done.returncode == 0, done.stderr
    assert not LATE_MODULES & set(done.stdout.split())


def test_the_core_does_not_import_qt() -> None:
    code = """
import sys
import lispac.workflow, lispac.io, lispac.report, lispac.design, lispac.simulation
import lispac.validation, lispac.adjustment, lispac.targets, lispac.survey, lispac.geometry
print(*sorted({name.partition(".")[0] for name in sys.modules}))
"""
    done = run_python(code)
    assert done.returncode == 0, done.stderr
    assert not {"PySide6", "qtpy", "pyvistaqt", "vtkmodules"} & set(done.stdout.split())


def test_continuous_integration_runs_the_command_of_the_readme() -> None:
    command = "python3 installer/bootstrap.py test"
    assert command in (CHECKOUT / "README.md").read_text(encoding="utf-8")
    assert command in (CHECKOUT / ".ci" / "run").read_text(encoding="utf-8")


def test_the_command_line_formats_no_results_itself() -> None:
    own = {"argument_types.py", "console.py", "messages.py"}  # limits, progress, options
    pattern = re.compile(r"\{[^{}]*:[^{}]*(?:\.\d+[efg%]|,)\}")
    for file in sorted((CHECKOUT / "lispac" / "cli").rglob("*.py")):
        if file.name not in own:
            assert not pattern.findall(file.read_text(encoding="utf-8")), file.name
