"""Start script of both programs of the bundle; the file name selects the program to run."""

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
sys.exit(import_module(MAIN_MODULES[Path(sys.executable).stem]).main())
