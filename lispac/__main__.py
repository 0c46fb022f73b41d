"""``python -m lispac``: the command line."""

import sys

from lispac.cli.main import main

sys.exit(main())
