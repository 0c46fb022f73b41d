"""``python -m lispac.gui [PROJECT]``."""

import sys
from multiprocessing import freeze_support

from lispac.gui.window.program import main

# In a program that is one file, a worker process starts here as well
freeze_support()
sys.exit(main())
