"""The nightly set names tests and modules that are there."""

import re
import subprocess
import sys
import tomllib

import pytest

from tests.extras import nightly
from tests.extras.nightly import (
    CHECKOUT,
    COMPILED_MODULES,
    PACKAGES,
    Justifications,
    drawn,
    function_of,
    functions_of_packages,
    noticed_afresh,
)
from tests.extras.quick import SLOW_TESTS_FILE


def test_what_it_names_is_there() -> None:
    assert all((CHECKOUT / "lispac" / package).is_dir() for package in PACKAGES)
    assert all((CHECKOUT / module).is_file() for module in COMPILED_MODULES)
    for tests in PACKAGES.values():
        assert [each for each in tests if not (CHECKOUT / f"tests/test_{each}.py").is_file()] == []


def test_a_step_that_is_not_there_is_refused(
    tmp_path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["nightly", str(tmp_path), "everything"])
    with pytest.raises(SystemExit):
        nightly.main()
    assert "there is no step everything" in capsys.readouterr().err


def test_a_step_that_fails_is_reported_and_the_next_is_taken(
    tmp_path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fails(_folder, log) -> str:
        nightly.run(["false"], log)
        return ""

    monkeypatch.setattr(nightly, "STEPS", {"first": fails, "second": lambda *_: "all is well"})
    monkeypatch.setattr("sys.argv", ["nightly", str(tmp_path / "out")])
    assert nightly.main() == 1
    first, second = capsys.readouterr().out.splitlines()
    assert first.startswith("first     FAILED")
    assert "exit 1; see" in first
    assert second.endswith("all is well")


def test_of_each_module_the_same_changes_are_drawn() -> None:
    found = {f"a.{m}.x_f__mutmut_{k}": "not checked" for m in ("one", "two") for k in range(30)}
    found["a.few.x_g__mutmut_1"] = "not checked"
    some = drawn(found, 5)
    assert some == drawn(dict(reversed(found.items())), 5)
    assert [name.split(".")[1] for name in some] == ["few"] + 5 * ["one"] + 5 * ["two"]
    assert len(set(some)) == 11
    assert sorted(drawn(found, None)) == sorted(found)


@pytest.mark.parametrize(
    ("ours", "theirs", "expected"),
    [
        ("a = b + c", "a = b - c", False),
        ('say("A plane.", a)', 'say("XXA plane.XX", a)', True),
        ('say("A plane.", a)', 'say("A plane.", None)', False),
        ('if loss != "none":', 'if loss != "NONE":', False),
        ("for _ in range(20):", "for _ in range(21):", True),
        ("for _ in range(20):", "for _ in range(22):", False),
        ("zip(a, b, strict=True)", "zip(a, b, strict=False)", True),
        ("zip(a, b, strict=True)", "zip(a, b, )", True),
        ("zip(a, b, strict=True)", "zip(b, strict=True)", False),
    ],
)
def test_a_survivor_is_justified_by_its_kind_a_family_or_its_texts(ours, theirs, expected) -> None:
    reasons = Justifications.of(
        {"functions": {"frames.f": {"20 -> 21": "enough"}}, "families": {"strict=False": "guard"}}
    )
    assert (reasons.missing_for(changed("f", 1, ours, theirs)) == []) is expected
    assert (reasons.missing_for(changed("g", 1, ours, theirs)) == []) is (
        expected and "range" not in ours
    )


def changed(function: str, number: int, ours: str, theirs: str) -> dict[str, str]:
    """Difference of one change, as mutmut shows it."""
    name = f"lispac.geometry.frames.x_{function}__mutmut_{number}"
    return {
        name: f"# {name}: survived\n--- a/b.py\n+++ a/b.py\n@@ -1,2 +1,2 @@\n"
        f"     same\n-    {ours}\n+    {theirs}\n"
    }


def test_each_survivor_of_a_kind_needs_a_reason_of_its_own() -> None:
    less, more = changed("f", 1, "a < b", "a <= b"), changed("f", 2, "c = d < e", "c = d <= e")
    one = Justifications({"frames.f": {"< -> <=": ["the very number"]}}, {})
    assert one.missing_for(less) == one.missing_for(more) == []
    assert one.missing_for(less | more) == [*less, *more]
    two = Justifications({"frames.f": {"< -> <=": ["the very number", "never equal"]}}, {})
    assert two.missing_for(less | more) == []


def test_entries_that_match_nothing_are_named() -> None:
    (known, *_) = functions_of_packages()
    reasons = Justifications({known: {"1 -> 2": ["why"]}, "frames.gone": {"1 -> 2": ["why"]}}, {})
    assert reasons.unmatched(whole=False) == ["frames.gone: 1 -> 2"]
    assert reasons.unmatched(whole=True) == [f"{known}: 1 -> 2", "frames.gone: 1 -> 2"]


@pytest.mark.parametrize(
    ("name", "function"),
    [
        ("lispac.geometry.frames.x_to_local__mutmut_12", "frames.to_local"),
        ("lispac.geometry.frames.x__helper__mutmut_1", "frames._helper"),
        ("lispac.survey.store.layout.xǁManifestǁread__mutmut_1", "layout.Manifest.read"),
        ("lispac.geometry.planes.xǁPlaneǁ__init____mutmut_2", "planes.Plane.__init__"),
    ],
)
def test_the_function_of_a_change_has_no_package(name: str, function: str) -> None:
    assert function_of(name) == function


def test_a_change_that_shows_only_where_it_is_imported_is_noticed_afresh(
    tmp_path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    (tmp_path / "pytest.ini").write_text("[pytest]\n")  # the folder may lie in the checkout
    tests = tmp_path / "test_table.py"
    tests.write_text(
        "import os\n"
        "TABLE = os.environ.get('MUTANT_UNDER_TEST') != 'a.x_f__mutmut_1'\n"
        "def test_table():\n    assert TABLE\n"
    )
    (tmp_path / SLOW_TESTS_FILE).write_text('["test_table.py::test_table"]')
    found = noticed_afresh(["a.x_f__mutmut_1", "a.x_f__mutmut_2"], tmp_path, [])
    assert not (tmp_path / SLOW_TESTS_FILE).exists()
    assert found == {"a.x_f__mutmut_1"}
    tests.write_text("def test_never():\n    assert False\n")
    with pytest.raises(nightly.Failed, match="fail without a change too"):
        noticed_afresh(["a.x_f__mutmut_2"], tmp_path, [])
    assert noticed_afresh([], tmp_path, []) == set()


def test_every_justification_is_a_text_and_every_family_an_expression() -> None:
    content = tomllib.loads(nightly.JUSTIFICATIONS_FILE.read_text(encoding="utf-8"))
    assert set(content) == {"functions", "families"}
    reasons = Justifications.of(content)
    assert all(all(each) for kinds in reasons.functions.values() for each in kinds.values())
    for each in reasons.families:
        re.compile(each)


LAZ_IN_A_COPY = """
import os, signal, sys
import laspy
from tests.extras.quick import pytest_configure
pytest_configure()
cloud = laspy.create(point_format=6)
cloud.x = range(100)
cloud.write(sys.argv[1])
laspy.read(sys.argv[1])
copy = os.fork()
if not copy:
    signal.alarm(20)
    os._exit(len(laspy.read(sys.argv[1])) != 100)
sys.exit(os.waitstatus_to_exitcode(os.waitpid(copy, 0)[1]))
"""


def test_a_copy_of_a_process_that_has_read_laz_reads_it_too(tmp_path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", LAZ_IN_A_COPY, str(tmp_path / "cloud.laz")],
        cwd=CHECKOUT, check=False,
    )  # fmt: skip
    assert done.returncode == 0
