"""``python -m lispac``: the command line."""

import sys
from multiprocessing import freeze_support

from lispac.cli.main import main

# In a bundled executable, worker processes also start here
freeze_support()
sys.exit(main())
