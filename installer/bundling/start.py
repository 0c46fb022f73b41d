"""Start script of both programs of the bundle; the file name selects the program to run.

With one script, both program files are identical on Linux. Numba caches compiled code for each
program file, so each program can use the code that the other has compiled.
"""

import os
import sys
from importlib import import_module
from multiprocessing import freeze_support
from pathlib import Path

MAIN_MODULES = {"lispac": "lispac.cli.main", "lispac-gui": "lispac.gui.window.program"}
"""Module whose function ``main`` runs a program, by the name of the program."""

# Worker processes also start here, and this call does not return in them
freeze_support()

from lispac import caches  # noqa: E402

caches.set_cache_variables(os.environ)
program = Path(sys.executable).stem
if sys.platform in ("win32", "darwin"):
    # The two program files differ on these systems, so each has a separate cache
    os.environ["NUMBA_CACHE_DIR"] = str(Path(os.environ["NUMBA_CACHE_DIR"]) / program)
sys.exit(import_module(MAIN_MODULES[program]).main())
