"""Build hook of the wheel: includes resources/ as lispac/resources.

The setting force-include is not used: it would also copy the folder into the environment of an
editable install, and it fails if the folder is empty and therefore not checked out.
"""

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class ResourcesHook(BuildHookInterface[Any]):
    """Adds the resources folder to a standard wheel, but not to an editable install."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Called by hatchling before each build; `version` is "standard" or "editable"."""
        resources = Path(self.root) / "resources"
        if version == "standard" and resources.is_dir():
            build_data["force_include"][str(resources)] = "lispac/resources"
