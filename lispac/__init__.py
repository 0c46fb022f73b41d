"""LISPAC: boresight calibration of mobile LiDAR systems.

A script performs the same steps as the user in the window: create or open a project, pick targets
from seeds, estimate and validate the boresight, and write a report::

    import lispac

    harbour = lispac.open("harbour")
    harbour.seed("T1", (12.4, -3.1, 2.0))
    harbour.estimate()
    harbour.report("boresight.pdf")
    harbour.save()

``resources/manual/en/scripts.md`` describes all steps. The names in ``__all__`` are the public
interface for scripts and stay the same in later versions; all others are internal.
"""

import os
from importlib import import_module
from typing import TYPE_CHECKING, Any

from lispac.version import __version__ as __version__

# Products of matrices with a few columns take several times longer if BLAS divides them among the
# cores. The variable has no effect if NumPy was imported before.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

if TYPE_CHECKING:
    from lispac.acceptance import AcceptanceCriteria as AcceptanceCriteria
    from lispac.adjustment.model.parameters import Parameter as Parameter
    from lispac.control_points import ControlFile as ControlFile
    from lispac.control_points import ControlPoint as ControlPoint
    from lispac.errors import LispacError as LispacError
    from lispac.identity import Identity as Identity
    from lispac.messages import Message as Message
    from lispac.picked_targets import PickedSighting as PickedSighting
    from lispac.picked_targets import Target as Target
    from lispac.project import Settings as Settings
    from lispac.scripting.open_project import OpenProject as OpenProject
    from lispac.scripting.projects import demo as demo
    from lispac.scripting.projects import new as new
    from lispac.scripting.projects import open as open
    from lispac.survey.line_source import LineSource as LineSource
    from lispac.survey.line_source import Reading as Reading
    from lispac.targets.expected_target import ExpectedTarget as ExpectedTarget
    from lispac.targets.finder_settings import FinderChoices as FinderChoices
    from lispac.workflow.calibration.point_index_text import point_numbers as point_numbers
    from lispac.workflow.output.batch import batch as batch

# Modules are imported on first use, since the command line often needs only the version.
_MODULE_OF_NAME = {
    "AcceptanceCriteria": "lispac.acceptance",
    "ControlFile": "lispac.control_points",
    "ControlPoint": "lispac.control_points",
    "ExpectedTarget": "lispac.targets.expected_target",
    "FinderChoices": "lispac.targets.finder_settings",
    "Identity": "lispac.identity",
    "LineSource": "lispac.survey.line_source",
    "LispacError": "lispac.errors",
    "Message": "lispac.messages",
    "OpenProject": "lispac.scripting.open_project",
    "Parameter": "lispac.adjustment.model.parameters",
    "PickedSighting": "lispac.picked_targets",
    "Reading": "lispac.survey.line_source",
    "Settings": "lispac.project",
    "Target": "lispac.picked_targets",
    "batch": "lispac.workflow.output.batch",
    "demo": "lispac.scripting.projects",
    "new": "lispac.scripting.projects",
    "open": "lispac.scripting.projects",
    "point_numbers": "lispac.workflow.calibration.point_index_text",
}

__all__ = ["__version__", *sorted(_MODULE_OF_NAME)]


def __getattr__(name: str) -> Any:
    if name not in _MODULE_OF_NAME:
        raise AttributeError(f"module 'lispac' has no attribute {name!r}")
    _use_cache()
    found = getattr(import_module(_MODULE_OF_NAME[name]), name)
    globals()[name] = found
    return found


def _use_cache() -> None:
    """Set the folder of Numba's compiled code before the import; warn if it is temporary."""
    import os
    import warnings

    from lispac import caches

    if (message := caches.set_cache_variables(os.environ)) is not None:
        from lispac.message_texts import message_text

        warnings.warn(message_text(message), stacklevel=3)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
