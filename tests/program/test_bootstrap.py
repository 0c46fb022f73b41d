"""Tests of the decisions of the setup script, without installing anything."""

import ast
import json
import runpy
import subprocess
import sys
from pathlib import Path

import bootstrap
import environment
import pytest
import system_packages
from system_packages import MissingComponent, PackagesMissingError

REQUIRED = {
    "checkout": "/checkout",
    "python": "3.12",
    "locks": {"run": "a", "test": "b"},
    "project": "p",
}
ALL_STEPS = ["environment", "dependencies", "project"]


@pytest.mark.parametrize("version", [(3, 11), (3, 14)])
def test_supported_python_is_accepted(version: tuple[int, int]) -> None:
    assert bootstrap.unsupported_python_text(version) is None


@pytest.mark.parametrize("version", [(3, 10), (3, 15)])
def test_other_python_is_refused_in_one_line(version: tuple[int, int]) -> None:
    refusal = bootstrap.unsupported_python_text(version)
    assert refusal is not None
    assert f"3.{version[1]}" in refusal
    assert "\n" not in refusal


@pytest.mark.parametrize("module", [bootstrap, environment, system_packages])
def test_an_old_python_can_read_the_script_that_refuses_it(module: object) -> None:
    source = Path(module.__file__).read_text(encoding="utf-8")
    ast.parse(source, feature_version=(3, 7))


def test_tests_that_import_the_script_keep_their_bytecode(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    runpy.run_path(bootstrap.__file__)
    assert not sys.dont_write_bytecode


# Installed state and required state


def test_a_complete_installation_needs_no_step() -> None:
    assert environment.steps_needed(REQUIRED, REQUIRED, "run") == []
    assert environment.steps_needed(REQUIRED, REQUIRED, "test") == []


def test_the_first_start_runs_every_step() -> None:
    assert environment.steps_needed(None, REQUIRED, "run") == ALL_STEPS


@pytest.mark.parametrize("key", ["checkout", "python"])
def test_moved_checkout_or_other_python_needs_a_new_environment(key: str) -> None:
    assert environment.steps_needed({**REQUIRED, key: "other"}, REQUIRED, "run") == ALL_STEPS


def test_an_environment_for_running_lacks_the_test_dependencies() -> None:
    installed = {**REQUIRED, "locks": {"run": "a"}}
    assert environment.steps_needed(installed, REQUIRED, "run") == []
    assert environment.steps_needed(installed, REQUIRED, "test") == ["dependencies"]


def test_changed_lock_and_changed_project_are_distinguished() -> None:
    changed_lock = {**REQUIRED, "locks": {"run": "old", "test": "old"}}
    assert environment.steps_needed(changed_lock, REQUIRED, "run") == ["dependencies"]
    assert environment.steps_needed({**REQUIRED, "project": "old"}, REQUIRED, "run") == ["project"]


def test_stamp_survives_a_round_trip(tmp_path: Path) -> None:
    stamp = tmp_path / "stamp.json"
    environment.write_stamp(REQUIRED, stamp)
    assert environment.read_stamp(stamp) == REQUIRED
    assert [path.name for path in tmp_path.iterdir()] == ["stamp.json"]


@pytest.mark.parametrize("text", [None, "", "{", "[]", '{"state": "unfinished"}'])
def test_an_interrupted_installation_is_repeated(tmp_path: Path, text: str | None) -> None:
    stamp = tmp_path / "stamp.json"
    if text is not None:
        stamp.write_text(text)
    assert environment.read_stamp(stamp) is None


def test_the_required_state_follows_the_lock_files_and_the_version(tmp_path: Path) -> None:
    locks = [f"installer/{name}" for name in environment.LOCK_FILES.values()]
    for name in (*environment.PROJECT_FILES, *locks):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("first")
    before = environment.wanted_state(tmp_path)
    (tmp_path / "installer" / "lock-test.txt").write_text("second")
    after_lock = environment.wanted_state(tmp_path)
    assert after_lock["locks"]["run"] == before["locks"]["run"]
    assert after_lock["locks"]["test"] != before["locks"]["test"]
    (tmp_path / "lispac" / "version.py").write_text("second")
    assert environment.wanted_state(tmp_path)["project"] != before["project"]


@pytest.fixture
def scratch_environment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder in place of .venv."""
    folder = tmp_path / ".venv"
    monkeypatch.setattr(environment, "ENVIRONMENT", folder)
    monkeypatch.setattr(environment, "STAMP", folder / "stamp.json")
    monkeypatch.setattr(environment, "INSTALL_LOG", folder / "install.log")
    return folder


def test_foreign_environment_is_left_alone(scratch_environment: Path) -> None:
    scratch_environment.mkdir()
    (scratch_environment / "pyvenv.cfg").write_text("mine")
    with pytest.raises(environment.SetupError, match="was not created"):
        environment.make_environment()
    assert (scratch_environment / "pyvenv.cfg").read_text() == "mine"


def test_failing_pip_leaves_the_install_unfinished_and_says_why(
    scratch_environment: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def make() -> None:
        scratch_environment.mkdir()

    failing = "import sys; print('ERROR: no such package'); sys.exit(1)"
    monkeypatch.setattr(environment, "make_environment", make)
    monkeypatch.setattr(environment, "pip_command", lambda: [sys.executable, "-c", failing])
    with pytest.raises(environment.SetupError, match="no such package"):
        environment.ensure_installed("run", scratch_environment / "cache")
    assert environment.read_stamp(scratch_environment / "stamp.json") is None
    assert "no such package" in (scratch_environment / "install.log").read_text()
    assert "locked packages" in capsys.readouterr().out


def test_finished_install_is_not_repeated(
    scratch_environment: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(environment, "make_environment", scratch_environment.mkdir)
    monkeypatch.setattr(environment, "pip_command", lambda: [sys.executable, "-c", "pass"])
    assert environment.ensure_installed("test", scratch_environment / "cache")
    monkeypatch.setattr(environment, "run_pip", lambda *_: pytest.fail("installed again"))
    assert not environment.ensure_installed("test", scratch_environment / "cache")
    assert not environment.ensure_installed("run", scratch_environment / "cache")


def test_pip_output_becomes_a_few_lines() -> None:
    lines = [f"Collecting package-{i}==1.0" for i in range(30)]
    lines.append("  Downloading small-1.0-py3-none-any.whl (9.9 MB)")
    lines.append("  Downloading vtk-9.7.2-cp311-cp311-manylinux_2_28_x86_64.whl (139.4 MB)")
    lines.append("Installing collected packages: a, b")
    printed: list[str] = []
    environment.pip_progress(lines, 40, printed.append)
    assert printed == ["  25 of 40 packages", "  downloading vtk-9.7.2 (139 MB)", "  unpacking"]


# Folders


def test_the_user_cache_follows_the_platform() -> None:
    home = Path("/home/me")
    assert environment.user_cache("linux", {}, home) == home / ".cache" / "lispac"
    assert environment.user_cache("linux", {"XDG_CACHE_HOME": "/c"}, home) == Path("/c/lispac")
    assert environment.user_cache("darwin", {}, home) == home / "Library" / "Caches" / "lispac"
    local = {"LOCALAPPDATA": "/local"}
    assert environment.user_cache("win32", local, home) == Path("/local/lispac/Cache")


def test_child_processes_write_caches_in_allowed_folders_only(scratch_environment: Path) -> None:
    cache = Path("/cache/lispac")
    theirs = {"PYTHONPATH": "/other", "PYTHONDONTWRITEBYTECODE": "1", "PATH": "/bin"}
    variables = environment.child_variables(theirs, cache)
    assert variables.keys().isdisjoint(theirs.keys() - {"PATH"})
    assert variables["PATH"] == "/bin"
    places = [path for name, path in variables.items() if name != "PATH"]
    allowed = (str(scratch_environment), str(cache))
    assert all(path.startswith(allowed) for path in places)
    assert {"PYTHONPYCACHEPREFIX", "NUMBA_CACHE_DIR", "MPLCONFIGDIR"} <= variables.keys()


def test_tests_render_in_software(scratch_environment: Path) -> None:
    variables = environment.child_variables({}, Path("/cache"), testing=True)
    assert variables["LIBGL_ALWAYS_SOFTWARE"] == "1"
    assert variables["XDG_CONFIG_HOME"].startswith(str(scratch_environment))
    assert "LIBGL_ALWAYS_SOFTWARE" not in environment.child_variables({}, Path("/cache"))


def test_programs_are_found_on_each_platform() -> None:
    assert environment.script("lispac", "linux").endswith("/bin/lispac")
    assert environment.script("lispac", "win32").endswith("lispac.exe")


def test_no_display_is_recognised() -> None:
    assert not bootstrap.has_display("linux", {})
    assert bootstrap.has_display("linux", {"WAYLAND_DISPLAY": "wayland-0"})
    assert bootstrap.has_display("win32", {})


@pytest.mark.skipif(sys.platform != "linux", reason="X11 is asked on Linux only")
def test_a_display_that_does_not_answer_does_not_count(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISPLAY", ":987")
    assert not bootstrap.has_display("linux", {"DISPLAY": ":987"})


# System packages


def missing_components(**overrides: object) -> list[MissingComponent]:
    """`missing_packages` of a complete system, except for the functions given by name."""
    system = {
        "loads": lambda _soname: True,
        "has_fonts": lambda: True,
        "which": lambda _name: "/usr/bin/Xvfb",
        "has_venv": lambda: True,
    }
    return system_packages.missing_packages(for_tests=True, **{**system, **overrides})


def test_complete_system_lacks_nothing() -> None:
    assert missing_components() == []


def test_missing_library_names_its_package() -> None:
    found = missing_components(loads=lambda soname: soname != "libxcb-cursor.so.0")
    assert found == [MissingComponent("libxcb-cursor.so.0", ("libxcb-cursor0",))]


def test_missing_fonts_screen_and_venv_are_noticed() -> None:
    found = missing_components(
        has_fonts=lambda: False, which=lambda _name: None, has_venv=lambda: False
    )
    packages = [need.package_names[-1] for need in found]
    assert packages == ["fonts-dejavu-core", "xvfb", "poppler-utils", "python3-venv"]


def test_the_virtual_screen_is_required_for_tests_only() -> None:
    found = system_packages.missing_packages(
        for_tests=False,
        loads=lambda _soname: True,
        has_fonts=lambda: True,
        which=lambda _name: None,
        has_venv=lambda: True,
    )
    assert found == []


def test_a_renamed_package_has_the_name_of_this_system() -> None:
    needs = [
        MissingComponent("glib", ("libglib2.0-0t64", "libglib2.0-0")),
        MissingComponent("GL", ("libgl1",)),
    ]
    new = system_packages.choose_names(needs, knows=lambda name: name.endswith("t64"))
    old = system_packages.choose_names(needs, knows=lambda name: not name.endswith("t64"))
    assert new == ["libglib2.0-0t64", "libgl1"]
    assert old == ["libglib2.0-0", "libgl1"]
    assert system_packages.choose_names(needs * 2, knows=lambda _name: False) == old


def test_without_root_the_exact_command_is_printed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(system_packages, "run_apt", lambda _command: pytest.fail("not root"))
    needs = [
        MissingComponent("libGL.so.1", ("libgl1",)),
        MissingComponent("the virtual screen Xvfb", ("xvfb",)),
    ]
    with pytest.raises(PackagesMissingError) as refused:
        system_packages.ensure_packages(needs, root=False, apt_get="/usr/bin/apt-get", say=print)
    command = "sudo apt-get install -y --no-install-recommends libgl1 xvfb"
    assert f"sudo apt-get update && {command}" in str(refused.value)


def test_without_apt_the_packages_are_named() -> None:
    needs = [MissingComponent("libGL.so.1", ("libgl1",))]
    with pytest.raises(PackagesMissingError, match="libgl1"):
        system_packages.ensure_packages(needs, root=True, apt_get=None, say=print)


def test_root_installs_only_what_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    ran: list[list[str]] = []
    monkeypatch.setattr(system_packages, "run_apt", lambda command: ran.append(list(command)))
    printed: list[str] = []
    needs = [MissingComponent("libGL.so.1", ("libgl1",))]
    system_packages.ensure_packages(needs, root=True, apt_get="apt-get", say=printed.append)
    assert ran == [
        ["apt-get", "update"],
        ["apt-get", "install", "-y", "--no-install-recommends", "libgl1"],
    ]
    assert len(printed) == 1
    ran.clear()
    system_packages.ensure_packages([], root=True, apt_get="apt-get", say=printed.append)
    assert ran == []


def test_failing_apt_shows_its_output() -> None:
    failing = "import sys; print('E: no space'); sys.exit(100)"
    with pytest.raises(PackagesMissingError, match="E: no space"):
        system_packages.run_apt([sys.executable, "-c", failing])


# Commands


def test_test_command_runs_every_check_before_the_tests() -> None:
    names = [name for name, _ in bootstrap.check_commands("test", [])]
    checks = ["ruff check", "ruff format", "mypy", "translations", "import rules"]
    assert names == [*checks, "pytest"]
    assert [name for name, _ in bootstrap.check_commands("lint", [])] == names[:-1]


@pytest.mark.parametrize("command", ["test", "benchmark"])
def test_further_arguments_reach_pytest_in_order(command: str) -> None:
    arguments = ["tests/test_a.py", "-k", "one and two", "-x"]
    _, rest = bootstrap.parser().parse_known_args([command, *arguments])
    _, line = bootstrap.check_commands(command, rest)[-1]
    assert line[-4:] == arguments


def test_first_failing_check_ends_the_run(capsys: pytest.CaptureFixture[str]) -> None:
    fails = [sys.executable, "-c", "import sys; sys.exit(3)"]
    never = [sys.executable, "-c", "print('went on')"]
    assert bootstrap.run_checks([("first", fails), ("second", never)], {}) == 3
    assert "second" not in capsys.readouterr().out


def test_demo_opens_no_window_without_a_display() -> None:
    assert bootstrap.demo_command(Path("out"), display=True)[1:] == ["demo", "--output", "out"]
    assert bootstrap.demo_command(Path("out"), display=False)[-1] == "--no-window"


def test_wrong_usage_ends_with_two() -> None:
    command = [sys.executable, bootstrap.__file__, "demo", "--nonsense"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "--nonsense" in done.stderr


def test_stamp_is_plain_json(tmp_path: Path) -> None:
    environment.write_stamp({"state": "unfinished"}, tmp_path / "stamp.json")
    assert json.loads((tmp_path / "stamp.json").read_text()) == {"state": "unfinished"}


def test_the_bundle_has_an_environment_of_its_own(
    scratch_environment: Path, tmp_path: Path
) -> None:
    environment.use_folder(tmp_path / "build" / "bundle-env")
    assert environment.STAMP.parent == environment.INSTALL_LOG.parent == environment.ENVIRONMENT
    assert scratch_environment != environment.ENVIRONMENT
    assert environment.script("python", "linux").startswith(str(tmp_path / "build"))
