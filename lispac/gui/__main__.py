"""``python -m lispac.gui [PROJECT]``."""

import sys

from lispac.gui.app import main

sys.exit(main())
