"""Replacement for Open3D's plotly module, which Open3D imports at start but LISPAC does not use.

Without plotly, the bundle is 40 MB smaller.
"""

import sys
from types import ModuleType
from typing import Any


def _absent(*_arguments: Any, **_options: Any) -> None:
    raise ImportError("Open3D's plotly figures are not part of this program.")


module = ModuleType("open3d.visualization.draw_plotly")
for name in ("get_plotly_fig", "draw_plotly", "draw_plotly_server"):
    setattr(module, name, _absent)
sys.modules[module.__name__] = module
