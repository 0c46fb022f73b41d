"""Build the API reference with ``python -m tests.reference FOLDER`` (takes some minutes)."""

import sys
from pathlib import Path

from tests.reference.pages import build

said = build(Path(sys.argv[1]))
sys.exit(said or None)
