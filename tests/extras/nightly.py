"""Run the checks that take too long for every test run, with a log for each and a final table.

    python -m tests.extras.nightly FOLDER                     all steps, most of a night
    python -m tests.extras.nightly FOLDER coverage long       these steps
    python -m tests.extras.nightly FOLDER mutation-whole      all mutations instead of a sample

`coverage` and `mutation` need `python -m pip install -e '.[nightly]'` in the environment; `bundle`
and `readme` need root and debootstrap (`tests.extras.clean_root`). Exit code 1 if a step failed.
"""

from __future__ import annotations

import argparse
import ast
import json
import os
import random
import re
import shutil
import subprocess
import sys
import time
import tomllib
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from tests.extras.quick import SLOW

CHECKOUT = Path(__file__).resolve().parents[2]
PYTEST = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"]
MIN_BRANCH_COVERAGE = 95.0
"""Smallest accepted percentage of the core's branches that the tests cover."""
PACKAGES = {
    "geometry": (
        "frames", "planes", "rotations", "spheres", "conventions", "convention_rules",
        "repeatability", "crs", "occlusion", "normal_distance", "cloud_distance", "sections",
        "spheres_adjusted", "sphere_finder", "vessel_adjustment", "georeferencing", "finder",
        "growing", "geodesy_edges", "distance_edges", "reference_places", "target_edges",
    ),
    "adjustment": (
        "adjustment", "averaging", "consistent_warnings", "error_budget", "invariance",
        "observability", "omitted", "parameters", "prediction", "reliability", "robustness",
        "shown", "spheres_adjusted", "standards", "variance_factor", "vessel_adjustment",
        "design_effect", "pos_error_knots", "shape_tangents", "adjustment_edges",
        "duplicate_targets", "line_shifts", "plan_warnings", "warnings", "displaced",
    ),
    "survey": (
        "blocks", "cidco_states", "cloud", "cloud_regions", "clouds", "mounting_replacement",
        "convention_rules", "convention_typed", "convention_texts", "conventions", "crs",
        "crs_operation", "given_frame", "geodesy_edges", "georeferencing", "georeferencing_map",
        "growing", "kept_header", "trajectory_coverage", "lever_arm", "lines_cut",
        "suggested_shifts", "patches_on_disk", "points_clock", "reading", "recovery", "scanners",
        "store", "store_damage", "store_parts", "time_base", "time_rollover", "given_time_base",
        "trajectory_quality", "trajectory_values",
    ),
}  # fmt: skip
"""Packages whose code is mutated, and the test modules that are fast enough for each mutation."""
COMPILED = ("lispac/geometry/point_tree.py", "lispac/survey/kernels.py")
"""Modules of compiled functions, which every mutation would compile again."""
UNMUTATED_LINES = (r"^\s*raise ", r"dtype=")
"""Patterns of lines that are not mutated: error messages and redundant types of arrays."""
MAX_TEST_S = 2.0
"""Longest time of a test that every mutation is tested with, s."""
MUTATION_ARGUMENTS = (
    "-n0", "-p", "tests.extras.quick", "-W", "ignore::pytest.PytestConfigWarning",
    # Each mutation has its own process, which would leave a virtual screen behind
    "-p", "no:xvfb",
)  # fmt: skip
"""Arguments of pytest for the test of a mutation."""
MUTATION_TIMEOUT_S = 1800.0
"""Time after which tests that have not ended count as failed by the mutation."""
MUTATIONS_PER_MODULE = 10
"""Number of mutations of a module that are tested in a night."""
JUSTIFICATIONS = Path(__file__).with_name("survivors.toml")
"""File with the reasons why a mutation need not be detected, by function and kind of change."""
TOKENS = re.compile(r"""(["']).*?\1|\d(?:e[+-]|[\w.])*|\w+|\*\*|//|[<>=!:]=|->|\S""")
"""Pattern of the words, numbers and operators of a line of code."""

Log = Path
Step = Callable[[Path, Log], str]
"""Performs a check in a folder, writes a log and returns a summary; raises `Failed`."""


EXPRESSIONS = (
    (r"^None$", "expression -> None"),
    (r" or True$", "expression -> True"),
    (r"^$", "argument -> nothing"),
    (r"^[\"']", "text -> other text"),
)
"""Form and kind of what replaces an expression; its own text is not part of the kind."""


class Failed(Exception):
    """A step failed; the message says why."""


def run(command: Sequence[str], log: Log, **environment: str) -> None:
    """Run a command in the checkout, and append its output to the log."""
    with log.open("a", encoding="utf-8") as file:
        file.write(f"$ {' '.join(command)}\n")
        file.flush()
        done = subprocess.run(
            command, cwd=CHECKOUT, stdout=file, stderr=subprocess.STDOUT, check=False,
            env=os.environ | environment,
        )  # fmt: skip
    if done.returncode:
        raise Failed(f"exit {done.returncode}; see {log}")


def long(_folder: Path, log: Log) -> str:
    """Run the tests marked long, one after the other, because the monkey test measures pauses."""
    run([*PYTEST, "-m", "long", "-n", "0", "--timeout=0", "--ignore", "tests/extras"], log)
    return re.findall(r"\d+ passed.*", log.read_text(encoding="utf-8"))[-1]


def coverage(folder: Path, log: Log) -> str:
    """Measure the branch coverage of the core by the normal test run."""
    settings = f"--rcfile={Path(__file__).with_name('coverage.ini')}"
    data = {"COVERAGE_FILE": str(folder / "coverage")}
    measure = [sys.executable, "-m", "coverage"]
    # The tests take twice as long while their coverage is measured
    run([*measure, "run", settings, "-m", *PYTEST[2:], "--timeout=1800"], log, **data)
    run([*measure, "combine", settings], log, **data)
    run([*measure, "json", settings, "-o", str(folder / "coverage.json")], log, **data)
    totals = json.loads((folder / "coverage.json").read_text(encoding="utf-8"))["totals"]
    share = 100.0 * totals["covered_branches"] / totals["num_branches"]
    text = f"{share:.1f} % of {totals['num_branches']} branches of the core"
    if share < MIN_BRANCH_COVERAGE:
        raise Failed(
            f"{text}, less than {MIN_BRANCH_COVERAGE:.0f} %; see {folder / 'coverage.json'}"
        )
    return text


def mutation(folder: Path, log: Log) -> str:
    """Find mutations of the core that no test detects and that are not justified.

    The packages are those of `PACKAGES`. Of each module the same random sample of
    `MUTATIONS_PER_MODULE` is tested every night; `mutation-whole` tests all. Tests that need a
    whole survey or more than `MAX_TEST_S` are excluded (`tests.extras.quick`). mutmut mutates no
    functions with a decorator, and so no compiled ones; their Jacobians are compared with
    difference quotients instead. Lines that match `UNMUTATED_LINES` contain no mathematics.
    """
    return _mutation(folder, log, MUTATIONS_PER_MODULE)


def mutation_whole(folder: Path, log: Log) -> str:
    """Test every mutation, which takes days of one processor; runs only on request."""
    return _mutation(folder, log, None)


def _mutation(folder: Path, log: Log, most: int | None) -> str:
    justifications = Justifications.of(tomllib.loads(JUSTIFICATIONS.read_text(encoding="utf-8")))
    texts, open_ = [], []
    for package, tests in PACKAGES.items():
        place = folder / f"mutation-{package}"
        shutil.rmtree(place, ignore_errors=True)
        run(["git", "clone", "-q", str(CHECKOUT), str(place)], log)
        (place / "setup.cfg").write_text(_settings(package, tests), encoding="utf-8")
        mutmut = [sys.executable, "-m", "mutmut"]
        # Creates the mutations and finds the tests that reach them; no mutation has this name
        _run_all([*mutmut, "run", "none"], place, log)
        _leave_out_slow(place / "mutants")
        _run_all([*mutmut, "run", *drawn(_results(mutmut, place), most)], place, log)
        found = _results(mutmut, place)
        counts = Counter(found.values())
        if not counts["killed"]:
            raise Failed(f"{package}: mutmut did not come to an end; see {log}")
        survivors = {
            name: _output([*mutmut, "show", name], place)
            for name, what in found.items()
            if what == "survived"
        }
        unjustified = justifications.missing_for(survivors)
        arguments = [*MUTATION_ARGUMENTS, *_files(tests)]
        noticed = noticed_afresh(unjustified, place / "mutants", arguments)
        survivors = {
            name: difference for name, difference in survivors.items() if name not in noticed
        }
        unjustified = [each for each in unjustified if each not in noticed]
        tried = sum(counts[what] for what in ("killed", "survived", "timeout", "suspicious"))
        texts.append(
            f"{package}: {len(survivors)} of {tried} survived, {len(unjustified)} not justified, "
            f"{counts['no tests']} reached by no quick test"
        )
        open_ += unjustified
    text = "; ".join(texts)
    if unmatched := justifications.unmatched(whole=most is None):
        text += f"; {JUSTIFICATIONS.name} has entries that match nothing: {', '.join(unmatched)}"
    if open_:
        raise Failed(f"{text}; to be justified in {JUSTIFICATIONS.name}: {' '.join(open_)}")
    return text


def noticed_afresh(names: Sequence[str], mutants: Path, tests: Sequence[str]) -> set[str]:
    """Surviving mutations that the tests detect in a new process.

    mutmut tests a mutation in a fork of a process that has imported all modules, so a mutation has
    no effect on values that are computed during the import, such as the table of conventions. Only
    few mutations are tested again, so the slow tests are included.
    """
    (mutants / SLOW).unlink(missing_ok=True)

    def passes(**environment: str) -> bool:
        command = [*PYTEST, "-x", *tests]
        try:
            done = subprocess.run(
                command, cwd=mutants, env=os.environ | environment, capture_output=True,
                timeout=MUTATION_TIMEOUT_S, check=False,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return False
        return done.returncode == 0

    if names and not passes():
        raise Failed(f"{mutants}: its tests fail without a change too")
    return {each for each in names if not passes(MUTANT_UNDER_TEST=each)}


def _run_all(command: Sequence[str], place: Path, log: Log) -> None:
    with log.open("a", encoding="utf-8") as file:
        subprocess.run(command, cwd=place, stdout=file, stderr=file, check=False)


def _leave_out_slow(mutants: Path) -> None:
    known = mutants / "mutmut-stats.json"
    if not known.is_file():
        return
    seconds = json.loads(known.read_text(encoding="utf-8"))["duration_by_test"]
    slow = [name for name, each in seconds.items() if each > MAX_TEST_S]
    (mutants / SLOW).write_text(json.dumps(slow), encoding="utf-8")


def _results(mutmut: Sequence[str], place: Path) -> dict[str, str]:
    """Status of each mutation by its name."""
    return dict(
        re.findall(r"(\S+__mutmut_\d+): (.+)", _output([*mutmut, "results", "--all", "1"], place))
    )


def drawn(found: dict[str, str], most: int | None) -> list[str]:
    """Mutations to test: at most ``most`` of each module, the same ones every time."""
    modules: dict[str, list[str]] = {}
    for name, what in found.items():
        if what != "no tests":
            modules.setdefault(name.rpartition(".")[0], []).append(name)
    return [
        name
        for module, names in sorted(modules.items())
        for name in (
            sorted(names) if most is None or len(names) <= most
            else random.Random(module).sample(sorted(names), most)
        )
    ]  # fmt: skip


class Justifications:
    """Reasons why mutations may survive, with a record of the reasons that matched.

    Attributes
    ----------
    functions : dict of str to dict of str to list of str
        By function (`function_of`) and kind of change (`kind_of`): one reason for each mutation of
        this kind in the function that may survive.
    families : dict of str to str
        Reasons by a regular expression that is searched for in the changed lines.
    """

    def __init__(
        self, functions: Mapping[str, Mapping[str, list[str]]], families: Mapping[str, str]
    ) -> None:
        self.functions = functions
        self.families = families
        self._used: set[str] = set()

    @classmethod
    def of(cls, content: Mapping[str, Mapping[str, object]]) -> Justifications:
        """Justifications from the content of the file, where a single reason may be a string."""
        functions = {
            function: {
                kind: [reasons] if isinstance(reasons, str) else list(reasons)
                for kind, reasons in kinds.items()
            }
            for function, kinds in content["functions"].items()
        }
        return cls(functions, content["families"])

    def missing_for(self, differences: Mapping[str, str]) -> list[str]:
        """Names of the mutations without a reason, from the differences by name.

        If more mutations of a kind survive than there are reasons, all of them are returned.
        """
        missing, by_kind = [], {}
        for name, difference in differences.items():
            ours, theirs = changed_lines(difference)
            families = [each for each in self.families if re.search(each, theirs, re.MULTILINE)]
            self._used.update(families)
            if not families and _bare(ours) != _bare(theirs):
                key = function_of(name), kind_of(ours, theirs)
                by_kind.setdefault(key, []).append(name)
        for (function, kind), names in by_kind.items():
            self._used.add(f"{function}: {kind}")
            if len(names) > len(self.functions.get(function, {}).get(kind, ())):
                missing += names
        return missing

    def unmatched(self, *, whole: bool) -> list[str]:
        """Entries whose function no longer exists; with ``whole``, also entries without a match."""
        functions = set(functions_of_packages())
        entries = [(f, f"{f}: {kind}") for f, kinds in self.functions.items() for kind in kinds]
        unused = [each for each in self.families if whole and each not in self._used]
        return unused + [
            justification
            for function, justification in entries
            if function not in functions or (whole and justification not in self._used)
        ]


def functions_of_packages() -> Iterator[str]:
    """Functions and methods of the mutated packages, named as by `function_of`."""
    for package in PACKAGES:
        for path in (CHECKOUT / "lispac" / package).rglob("*.py"):
            for node in ast.parse(path.read_text(encoding="utf-8")).body:
                if isinstance(node, ast.FunctionDef):
                    yield f"{path.stem}.{node.name}"
                elif isinstance(node, ast.ClassDef):
                    yield from (
                        f"{path.stem}.{node.name}.{each.name}"
                        for each in node.body
                        if isinstance(each, ast.FunctionDef)
                    )


def function_of(name: str) -> str:
    """Function of a mutation without its package, such as ``planes.Plane.facing``."""
    module, _, function = name.partition("__mutmut_")[0].rpartition(".")
    parts = function.removeprefix("x").removeprefix("_") if "ǁ" not in function else function[2:]
    return f"{module.rpartition('.')[2]}.{parts.replace('ǁ', '.')}"


def changed_lines(difference: str) -> tuple[str, str]:
    """Original and mutated lines of a unified difference."""
    lines = re.findall(r"^([-+])(?![-+]{2} )(.*)", difference, re.MULTILINE)
    ours, theirs = (
        "\n".join(text.strip() for sign, text in lines if sign == side) for side in "-+"
    )
    return ours, theirs


def kind_of(ours: str, theirs: str) -> str:
    """Kind of a change: operators or numbers that differ, such as ``< -> <=``, or `EXPRESSIONS`."""
    before, after = ([each[0] for each in TOKENS.finditer(lines)] for lines in (ours, theirs))
    while before and after and before[0] == after[0]:
        del before[0], after[0]
    while before and after and before[-1] == after[-1]:
        del before[-1], after[-1]
    old, new = " ".join(before), " ".join(after)
    if (len(before) == 1 and not re.match(r"[^\W\d]|[\"']", old)) or old in ("and", "or", "not"):
        return f"{old} -> {new}"
    return next((kind for form, kind in EXPRESSIONS if re.search(form, new)), f"{old} -> {new}")


def _bare(code: str) -> str:
    """Code without string literals, ``strict=True``, blanks and trailing commas.

    A literal in a comparison is kept, because it affects the behaviour.
    """
    code = re.sub(r"""([!=]=\s*)?(["']).*?\2""", lambda text: text[0] if text[1] else '""', code)
    code = re.sub(r"\s+", "", code)
    return re.sub(r",(?=[)\]])", "", re.sub(r"\bstrict=True\b", "", code))


def _files(tests: Sequence[str]) -> list[str]:
    found = {path.stem: path for path in CHECKOUT.glob("tests/**/test_*.py")}
    return [str(found[f"test_{each}"].relative_to(CHECKOUT)) for each in tests]


def _settings(package: str, tests: Sequence[str]) -> str:
    lists = {
        "only_mutate": [f"lispac/{package}/*"],
        "do_not_mutate": COMPILED,
        "do_not_mutate_patterns": UNMUTATED_LINES,
        "also_copy": ["tests/", "resources/", "installer/", "pyproject.toml", "README.md"],
        "pytest_add_cli_args_test_selection": _files(tests),
        "pytest_add_cli_args": [*MUTATION_ARGUMENTS, "-p", "no:cacheprovider"],
    }
    rows = [f"{name}=\n" + "".join(f"    {each}\n" for each in each_of)
            for name, each_of in lists.items()]  # fmt: skip
    return "[mutmut]\nsource_paths=lispac/\n" + "".join(rows)


def _output(command: Sequence[str], place: Path) -> str:
    done = subprocess.run(command, cwd=place, capture_output=True, text=True, check=False)
    return done.stdout


def _clean_root(what: str) -> Step:
    def step(_folder: Path, log: Log) -> str:
        run([sys.executable, "-m", "tests.extras.clean_root", what], log)
        return log.read_text(encoding="utf-8").splitlines()[-1]

    return step


STEPS: dict[str, Step] = {
    "long": long,
    "coverage": coverage,
    "mutation": mutation,
    "mutation-whole": mutation_whole,
    "bundle": _clean_root("bundle"),
    "readme": _clean_root("readme"),
}
ON_DEMAND = {"mutation-whole"}
"""Steps that run only if they are named."""


def main() -> int:
    """Run the steps one after the other."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.extras.nightly", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )  # fmt: skip
    parser.add_argument("folder", type=Path, help="for the logs and what they tell of")
    parser.add_argument("steps", nargs="*", metavar="STEP", help=", ".join(STEPS))
    arguments = parser.parse_args()
    unknown = set(arguments.steps) - STEPS.keys()
    if unknown:
        parser.error(f"there is no step {', '.join(sorted(unknown))}; choose of {', '.join(STEPS)}")
    folder = arguments.folder.absolute()
    folder.mkdir(parents=True, exist_ok=True)
    failed = 0
    for name in arguments.steps or [each for each in STEPS if each not in ON_DEMAND]:
        log, start = folder / f"{name}.log", time.monotonic()
        log.write_text("", encoding="utf-8")
        try:
            outcome, word = STEPS[name](folder, log), "done"
        except Failed as error:
            outcome, word, failed = str(error), "FAILED", failed + 1
        print(
            f"{name:10s}{word:8s}{(time.monotonic() - start) / 60:6.1f} min  {outcome}", flush=True
        )
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
