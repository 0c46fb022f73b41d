"""``python -m lispac``: the command line."""

import sys
from multiprocessing import freeze_support

from lispac.cli.main import main

# In a program that is one file, a worker process starts here as well
freeze_support()
sys.exit(main())
