"""Write all generated files: the catalogues, the tables of the manual, the JSON schemas.

``python -m tests.documents [FILE.po ...]`` takes new translations from FILE.po.
"""

import os
import subprocess
import sys
from pathlib import Path

CATALOGUES = Path(__file__).parents[2] / "installer" / "catalogues.py"


def main() -> int:
    """Write the files; returns the exit code, 1 if a text has no translation."""
    take = ["--take", *sys.argv[1:]] if sys.argv[1:] else []
    update = subprocess.run([sys.executable, str(CATALOGUES), "update", *take], check=False)
    if sys.platform == "linux" and not os.environ.get("DISPLAY"):
        os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

    from tests.documents import manual_tables, schemas

    schemas.main()
    manual_tables.main()
    return update.returncode


if __name__ == "__main__":
    sys.exit(main())
