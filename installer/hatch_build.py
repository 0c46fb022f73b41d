"""Build hook of the wheel: takes resources/ along as lispac/resources.

A plain force-include would copy the folder into the environment for an editable install too, beside
the checkout's own, and fails where the folder is empty and therefore not checked out.
"""

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class ResourcesHook(BuildHookInterface[Any]):
    """Adds the resources folder to a standard wheel."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Called by hatchling before each build; `version` is "standard" or "editable"."""
        resources = Path(self.root) / "resources"
        if version == "standard" and resources.is_dir():
            build_data["force_include"][str(resources)] = "lispac/resources"
