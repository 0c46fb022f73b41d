"""Where both programs of the bundle begin; which one it is, its own name says.

One script for both makes their files the same on Linux: Numba keeps compiled code for
the program file it was compiled by, and so each finds what the other has compiled.
"""

import os
import sys
from importlib import import_module
from multiprocessing import freeze_support
from pathlib import Path

MAIN = {"lispac": "lispac.cli.main", "lispac-gui": "lispac.gui.window.program"}

# A worker process starts here as well, and does not come back from this
freeze_support()

from lispac import caches  # noqa: E402

caches.set_cache_variables(os.environ)
program = Path(sys.executable).stem
if sys.platform in ("win32", "darwin"):
    # There they differ (a console, files that the Finder hands over), so each keeps its own
    os.environ["NUMBA_CACHE_DIR"] = str(Path(os.environ["NUMBA_CACHE_DIR"]) / program)
sys.exit(import_module(MAIN[program]).main())
