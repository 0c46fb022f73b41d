"""The folder of files that are not code: schemas, scenes, vessels, scanners."""

from pathlib import Path

import lispac
from lispac.errors import InputError


def resource(name: str) -> Path:
    """A file or folder of the resources.

    Raises
    ------
    InputError
        Where the installation lacks it.
    """
    package = Path(lispac.__file__).parent
    # A wheel has the resources in the package, a checkout beside it.
    for folder in (package, package.parent):
        path = folder / "resources" / name
        if path.exists():
            return path
    raise InputError(f"{name} is missing from this installation; install it again.")
