"""Build the API reference with ``python -m tests.reference FOLDER``; takes some minutes."""

import sys
from pathlib import Path

from tests.reference.pages import build

errors = build(Path(sys.argv[1]))
sys.exit(errors or None)
