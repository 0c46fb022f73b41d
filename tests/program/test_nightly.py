"""Tests of the nightly checks and of the evaluation of mutants."""

import re
import subprocess
import sys
import tomllib

import pytest

from tests.extras import nightly
from tests.extras.nightly import (
    CHECKOUT,
    COMPILED,
    PACKAGES,
    Justifications,
    drawn,
    function_of,
    functions_of_packages,
    kind_of,
    noticed_afresh,
)
from tests.extras.quick import SLOW


def test_named_packages_modules_and_tests_exist() -> None:
    assert all((CHECKOUT / "lispac" / package).is_dir() for package in PACKAGES)
    assert all((CHECKOUT / module).is_file() for module in COMPILED)
    for tests in PACKAGES.values():
        assert [each for each in tests if not [*CHECKOUT.glob(f"tests/**/test_{each}.py")]] == []


def test_an_unknown_step_is_refused(
    tmp_path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["nightly", str(tmp_path), "everything"])
    with pytest.raises(SystemExit):
        nightly.main()
    assert "there is no step everything" in capsys.readouterr().err


def test_a_failed_step_is_reported_and_the_next_one_runs(
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


def test_the_sample_of_mutants_is_reproducible() -> None:
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
def test_survivors_are_justified_by_kind_family_or_text(ours, theirs, expected) -> None:
    reasons = Justifications.of(
        {"functions": {"frames.f": {"20 -> 21": "enough"}}, "families": {"strict=False": "guard"}}
    )
    assert (reasons.missing_for(changed("f", 1, ours, theirs)) == []) is expected
    assert (reasons.missing_for(changed("g", 1, ours, theirs)) == []) is (
        expected and "range" not in ours
    )


def changed(function: str, number: int, ours: str, theirs: str) -> dict[str, str]:
    """Return one mutant with its difference in the format of mutmut."""
    name = f"lispac.geometry.frames.x_{function}__mutmut_{number}"
    return {
        name: f"# {name}: survived\n--- a/b.py\n+++ a/b.py\n@@ -1,2 +1,2 @@\n"
        f"     same\n-    {ours}\n+    {theirs}\n"
    }


@pytest.mark.parametrize(
    ("ours", "theirs", "kind"),
    [
        ("a < b", "a <= b", "< -> <="),
        ("a and b", "a or b", "and -> or"),
        ("range(20)", "range(21)", "20 -> 21"),
        ("f(len(a) - 1)", "f(None)", "expression -> None"),
        ("f(b, a.size)", "f(b, )", "argument -> nothing"),
        ("if a.size:", "if (a.size) or True:", "expression -> True"),
        ('f("sum")', 'f("SUM")', "text -> other text"),
    ],
)
def test_the_kind_of_a_mutation_does_not_contain_names(ours: str, theirs: str, kind: str) -> None:
    assert kind_of(ours, theirs) == kind


def test_each_survivor_of_a_kind_needs_its_own_reason() -> None:
    less, more = changed("f", 1, "a < b", "a <= b"), changed("f", 2, "c = d < e", "c = d <= e")
    one = Justifications({"frames.f": {"< -> <=": ["the very number"]}}, {})
    assert one.missing_for(less) == one.missing_for(more) == []
    assert one.missing_for(less | more) == [*less, *more]
    two = Justifications({"frames.f": {"< -> <=": ["the very number", "never equal"]}}, {})
    assert two.missing_for(less | more) == []


def test_unmatched_entries_are_named() -> None:
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
def test_the_function_of_a_mutant_is_named_without_its_package(name: str, function: str) -> None:
    assert function_of(name) == function


def test_mutants_with_effects_at_import_are_tested_in_a_new_process(
    tmp_path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    (tmp_path / "pytest.ini").write_text("[pytest]\n")  # tmp_path may lie in the checkout
    tests = tmp_path / "test_table.py"
    tests.write_text(
        "import os\n"
        "TABLE = os.environ.get('MUTANT_UNDER_TEST') != 'a.x_f__mutmut_1'\n"
        "def test_table():\n    assert TABLE\n"
    )
    (tmp_path / SLOW).write_text('["test_table.py::test_table"]')
    found = noticed_afresh(["a.x_f__mutmut_1", "a.x_f__mutmut_2"], tmp_path, [])
    assert not (tmp_path / SLOW).exists()
    assert found == {"a.x_f__mutmut_1"}
    tests.write_text("def test_never():\n    assert False\n")
    with pytest.raises(nightly.Failed, match="fail without a change too"):
        noticed_afresh(["a.x_f__mutmut_2"], tmp_path, [])
    assert noticed_afresh([], tmp_path, []) == set()


def test_justifications_are_valid() -> None:
    content = tomllib.loads(nightly.JUSTIFICATIONS.read_text(encoding="utf-8"))
    assert set(content) == {"functions", "families"}
    reasons = Justifications.of(content)
    assert all(all(each) for kinds in reasons.functions.values() for each in kinds.values())
    for each in reasons.families:
        re.compile(each)


LAZ_AFTER_FORK_SCRIPT = """
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


def test_laz_is_read_after_a_fork(tmp_path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", LAZ_AFTER_FORK_SCRIPT, str(tmp_path / "cloud.laz")],
        cwd=CHECKOUT, check=False,
    )  # fmt: skip
    assert done.returncode == 0
