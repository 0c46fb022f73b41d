"""Tests that cached machine code is compiled again after a change of its source files."""

import ast
import os
import re
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from lispac.compiled_code import (
    COMPILED_PACKAGES,
    IMPORT_TEXT,
    MAX_UNUSED_TIME_S,
    cache_folder,
    current_cache_folder,
    njit,
    portable_processor,
    source_state,
)
from lispac.computing_time import computing_time

CHECKOUT = Path(__file__).resolve().parents[2]
COPIED_FILES = (
    "__init__.py", "compiled_code.py", "compiled_code_locator.py", "computing_time.py",
    "geometry/__init__.py", "version.py",
)  # fmt: skip


def compiled_files() -> dict[Path, ast.Module]:
    found = {}
    for path in sorted((CHECKOUT / "lispac").rglob("*.py")):
        text = path.read_bytes()
        if IMPORT_TEXT in text and path.name != "compiled_code.py":
            found[path] = ast.parse(text)
    return found


def test_all_compiled_functions_are_in_watched_files() -> None:
    files = compiled_files()
    assert {path.relative_to(CHECKOUT / "lispac").parts[0] for path in files} <= set(
        COMPILED_PACKAGES
    )
    others = [
        path for path in (CHECKOUT / "lispac").rglob("*.py")
        if re.search(r"^\s*(from|import) numba\b", path.read_text(encoding="utf-8"), re.MULTILINE)
    ]  # fmt: skip
    assert {path.stem for path in others} == {"compiled_code", "compiled_code_locator"}


def test_compiled_functions_use_only_names_of_watched_files() -> None:
    """Constants become part of the machine code too."""
    files = compiled_files()
    modules = {".".join(path.relative_to(CHECKOUT).with_suffix("").parts) for path in files}
    for path, tree in files.items():
        imported = {
            alias.asname or alias.name: node.module
            for node in tree.body if isinstance(node, ast.ImportFrom)
            for alias in node.names if (node.module or "").startswith("lispac")
        }  # fmt: skip
        for node in tree.body:
            if isinstance(node, ast.FunctionDef) and any(
                isinstance(call, ast.Call) and getattr(call.func, "id", "") in {"njit", "kernel"}
                for call in node.decorator_list
            ):
                used = {name.id for part in node.body for name in ast.walk(part)
                        if isinstance(name, ast.Name)}  # fmt: skip
                unwatched = {imported[name] for name in used & set(imported)} - modules
                assert not unwatched, (path.name, node.name)


@pytest.mark.parametrize("what", ["function", pytest.param("constant", marks=pytest.mark.long)])
def test_code_is_compiled_again_after_a_change_in_another_file(tmp_path: Path, what: str) -> None:
    """Numba checks only the file of the caller, which does not change."""
    copy = tmp_path / "lispac"
    for name in COPIED_FILES:
        (copy / name).parent.mkdir(exist_ok=True)
        (copy / name).write_bytes((CHECKOUT / "lispac" / name).read_bytes())
    called = copy / "geometry" / "called.py"
    (copy / "geometry" / "caller.py").write_text(
        "from lispac.compiled_code import njit\n"
        "from lispac.geometry.called import SUMMAND, used\n"
        "@njit(cache=True)\ndef call(x):\n    return used(x) + SUMMAND\n"
    )

    def run(factor: int, summand: int) -> float:
        called.write_text(
            "from lispac.compiled_code import njit\n"
            f"SUMMAND = {summand}.0\n"
            f"@njit(cache=True)\ndef used(x):\n    return {factor}.0 * x\n"
        )
        os.utime(called, (1e9, 1e9))  # only the content changes
        done = subprocess.run(
            [sys.executable, "-c", "from lispac.geometry.caller import call; print(call(1.0))"],
            cwd=tmp_path, capture_output=True, text=True, check=True,
            env=os.environ | {
                "PYTHONPATH": str(tmp_path), "NUMBA_CACHE_DIR": str(tmp_path / "c"),
                # Byte code of a file of equal size and time (in seconds) would be used unchecked.
                "PYTHONDONTWRITEBYTECODE": "1",
            },
        )  # fmt: skip
        return float(done.stdout)

    assert run(2, 0) == 2.0
    assert run(2, 0) == 2.0
    assert (run(3, 0) if what == "function" else run(2, 1)) == 3.0


def test_only_folders_unused_for_a_month_are_removed(tmp_path: Path) -> None:
    old, recent = (cache_folder(tmp_path, state) for state in ("old", "recent"))
    other = tmp_path / "geometry_0123"
    other.mkdir()
    for folder in (old, other):
        os.utime(folder, (time.time() - 2 * MAX_UNUSED_TIME_S,) * 2)
    cache_folder(tmp_path, "new")
    assert not old.exists()
    assert recent.is_dir()
    assert other.is_dir()


def test_the_source_state_depends_on_compiled_files_only(tmp_path: Path) -> None:
    kernels, others = tmp_path / "survey" / "kernels.py", tmp_path / "survey" / "others.py"
    kernels.parent.mkdir()
    kernels.write_text("from lispac.compiled_code import njit")
    first = source_state(tmp_path)
    others.write_text("1")
    assert source_state(tmp_path) == first
    kernels.write_text("from lispac.compiled_code import njit as compiled")
    assert source_state(tmp_path) != first


def test_numba_uses_the_cache_folder_of_the_source_state() -> None:
    """Numba reads its variables again after a change, and child processes inherit them."""
    program = (
        "import os; from lispac.compiled_code import current_cache_folder; "
        "current_cache_folder(); from numba import config; "
        "os.environ['NUMBA_NUM_THREADS'] = '1'; config.reload_config(); print(config.CACHE_DIR)"
    )
    expected = str(current_cache_folder())
    assert Path(expected).name == f"sources-{source_state(CHECKOUT / 'lispac')}"
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=CHECKOUT, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == expected


@pytest.mark.long
def test_a_program_in_another_folder_uses_code_that_was_compiled_before(tmp_path: Path) -> None:
    """The bundle contains code that was compiled in the checkout."""
    program = (
        "from lispac.geometry.called import used; used(1.0); "
        "print(sum(used.stats.cache_hits.values()), sum(used.stats.cache_misses.values()))"
    )

    def run(folder: Path, cache: Path) -> list[int]:
        copy = folder / "lispac"
        for name in COPIED_FILES:
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            (copy / name).write_bytes((CHECKOUT / "lispac" / name).read_bytes())
        (copy / "geometry" / "called.py").write_text(
            "from lispac.compiled_code import njit\n"
            "@njit(cache=True)\ndef used(x):\n    return 2.0 * x\n"
        )
        variables = os.environ | {"PYTHONPATH": str(folder), "NUMBA_CACHE_DIR": str(cache)}
        done = subprocess.run(
            [sys.executable, "-c", program],
            cwd=folder, capture_output=True, text=True, check=True, env=variables,
        )  # fmt: skip
        return [int(word) for word in done.stdout.split()]

    first, second = tmp_path / "first", tmp_path / "second"
    packaged = second / "resources" / "compiled"
    assert run(first, tmp_path / "cache") == [0, 1]
    assert run(second, tmp_path / "cache") == [1, 0]
    (tmp_path / "cache").rename(packaged.parent.mkdir() or packaged)
    assert run(second, tmp_path / "new") == [1, 0]
    assert run(second, tmp_path / "new") == [1, 0]
    assert [path.name for path in (tmp_path / "new").iterdir()] == [
        path.name for path in packaged.iterdir()
    ]


@pytest.mark.parametrize(
    ("machine", "system", "features", "expected"),
    [
        ("x86_64", "linux", {"avx2": True, "fma": True, "avx512f": True}, "x86-64-v3"),
        ("AMD64", "win32", {"avx2": True, "fma": True}, "x86-64-v3"),
        ("x86_64", "linux", {"avx2": False, "fma": False}, None),
        ("x86_64", "darwin", {}, None),
        ("arm64", "darwin", {"neon": True}, "apple-m1"),
        ("aarch64", "linux", {"neon": True}, None),
    ],
)
def test_functions_are_compiled_for_a_group_of_processors(
    machine: str, system: str, features: dict[str, bool], expected: str | None
) -> None:
    assert portable_processor(machine, system, features) == expected


def test_numba_is_imported_at_the_first_call() -> None:
    program = (
        "import sys; from lispac.geometry.radius_search import finite_bounds; import numpy as np; "
        "print('numba' in sys.modules); finite_bounds(np.ones((2, 3))); "
        "print('numba' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=CHECKOUT, capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["False", "True"]


def test_the_clock_of_computations_stops_while_a_function_is_compiled() -> None:
    @njit
    def summed(values: np.ndarray) -> float:
        total = 0.0
        for k in range(len(values)):
            total += np.sqrt(values[k]) * np.sin(values[k])
        return total

    started, computing = time.perf_counter(), computing_time()
    first = summed(np.arange(10.0))
    whole, without = time.perf_counter() - started, computing_time() - computing
    assert first == pytest.approx(np.sum(np.sqrt(np.arange(10.0)) * np.sin(np.arange(10.0))))
    assert 0 <= without < 0.5 * whole  # nearly all of the time is that of the compilation
    started, computing = time.perf_counter(), computing_time()
    summed(np.arange(1e6))
    whole, without = time.perf_counter() - started, computing_time() - computing
    assert without == pytest.approx(whole, rel=0.05)
