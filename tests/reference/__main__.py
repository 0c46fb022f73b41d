"""``python -m tests.reference FOLDER`` builds the API reference, in some minutes."""

import sys
from pathlib import Path

from tests.reference.pages import build

said = build(Path(sys.argv[1]))
sys.exit(said or None)
