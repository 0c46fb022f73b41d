"""Compilation of all compiled functions before their first use, ``python -m`` this module.

Numba compiles a function for each combination of argument types with which it is called. All
methods are therefore run once, on the demo with few points; a list of the types would have to be
kept up to date by hand.
"""

import os
import shutil
import sys
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path

from lispac import caches
from lispac.errors import LispacError
from lispac.locks import AlreadyLocked, file_lock

POINTS_PER_SECOND = 12_500.0
"""Pulse rate of the simulated scanner: few points, but enough for all methods."""
FINISHED_FILE, LOCK_FILE = "precompiled", "precompile.lock"
"""Names of the file in the cache folder that says that all functions have been compiled, and of the
one that is locked while a process compiles them."""
SURVEY_FOLDER = "precompile"
"""Name of the folder of the simulated survey in the cache folder."""


def start_precompilation() -> None:
    """Compile all functions in a separate process with low priority, unless they are compiled.

    The process ends with this one at the latest; another one then starts from the beginning.
    """
    if not _finished_file().is_file():
        process = get_context("spawn").Process(
            target=_precompile_with_low_priority, name="lispac-precompile", daemon=True
        )
        process.start()


def precompile() -> None:
    """Compile all functions, unless they are compiled or another process is compiling them."""
    finished = _finished_file()
    folder = finished.with_name(SURVEY_FOLDER)
    with suppress(AlreadyLocked), file_lock(finished.with_name(LOCK_FILE)):
        if not finished.is_file():
            shutil.rmtree(folder, ignore_errors=True)  # of a process that has been ended
            try:
                run_all_methods(folder)
                finished.touch()
            finally:
                shutil.rmtree(folder, ignore_errors=True)


def _finished_file() -> Path:
    from lispac import compiled_code

    return compiled_code.current_cache_folder() / FINISHED_FILE


def _precompile_with_low_priority() -> None:
    if sys.platform == "win32":
        import ctypes

        kernel = ctypes.windll.kernel32
        kernel.SetPriorityClass(kernel.GetCurrentProcess(), 0x40)  # IDLE_PRIORITY_CLASS
    else:
        os.nice(19)
    precompile()


def run_all_methods(folder: Path) -> None:
    """Run all methods on a small simulated survey, which is written to a folder."""
    from lispac.alternative_methods import COMPUTED_METHODS
    from lispac.validation.local_models import LocalModel
    from lispac.workflow.calibration.estimation import estimate
    from lispac.workflow.calibration.method_runs import run_method
    from lispac.workflow.calibration.picking import pick_target
    from lispac.workflow.calibration.proposals import propose_targets
    from lispac.workflow.checking.line_quality import line_quality
    from lispac.workflow.checking.subsampling import subsampling_study
    from lispac.workflow.checking.survey_sections import section_at_target
    from lispac.workflow.checking.validation import validate
    from lispac.workflow.output.export import write_report
    from lispac.workflow.output.georeferencing import georeference_project
    from lispac.workflow.planning.demo import calibrate_demo, demo_seeds, make_demo

    project, survey = calibrate_demo(
        make_demo(folder / "demo", points_per_second=POINTS_PER_SECOND)
    )
    settings = project.settings
    name, (_role, seed) = next(iter(demo_seeds().items()))
    further: list[Callable[[], object]] = [
        lambda: write_report(project, survey, folder / "report.pdf"),
        lambda: pick_target(project, survey, seed, name="sphere", shape="sphere"),
        lambda: propose_targets(project, survey),
        lambda: section_at_target(project, survey, name),
        lambda: line_quality(project, survey),
        lambda: subsampling_study(project, survey),
        lambda: georeference_project(project, folder / "georeferenced", system="local"),
    ]
    for model in (LocalModel("quadric", 12), LocalModel("plane", radius=0.2)):
        further.append(lambda model=model: validate(project, survey, model=model))  # type: ignore[misc]
    for method in COMPUTED_METHODS:
        further.append(lambda method=method: run_method(project, survey, method))  # type: ignore[misc]
    for other in (
        replace(settings, pos_errors="independent"),
        replace(settings, loss="huber"),
        replace(settings, lidar_beam_sigma=(0.0025, 0.005)),
        replace(settings, variance_components=True),
    ):
        further.append(lambda other=other: estimate(project, survey, settings=other))  # type: ignore[misc]
    for run in further:
        # The functions are compiled even if a method finds no result with so few points
        with suppress(LispacError):
            run()


if __name__ == "__main__":
    caches.set_cache_variables(os.environ)
    precompile()
