"""``python -m lispac.gui [PROJECT]``."""

import sys
from multiprocessing import freeze_support

from lispac.gui.window.program import main

# In the bundled program, worker processes start here as well
freeze_support()
sys.exit(main())
