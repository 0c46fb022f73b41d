"""Edits of a project's targets, each of which returns a new project."""

from dataclasses import replace

from lispac.errors import ProjectError
from lispac.messages import error
from lispac.project import Project, Role


def set_target_use(project: Project, name: str, used: bool) -> Project:
    """Include or exclude a target."""
    target = project.target(name)
    return project if target.used == used else project.with_target(replace(target, used=used))


def set_sighting_use(project: Project, name: str, line: str, used: bool) -> Project:
    """Include or exclude one sighting."""
    target = project.target(name)
    sighting = target.sighting(line)
    if sighting is None or sighting.used == used:
        return project
    changed = replace(sighting, used=used)
    sightings = tuple(changed if s.line == line else s for s in target.sightings)
    return project.with_target(replace(target, sightings=sightings))


def set_line_use(project: Project, line: str, used: bool) -> Project:
    """Include or exclude the sightings of all targets on a line, without validation planes."""
    for target in project.targets_of_role("target"):
        project = set_sighting_use(project, target.name, line, used)
    return project


def with_renamed_target(project: Project, old: str, new: str) -> Project:
    """Rename a target without changing the order; results that contain a target are cleared.

    Raises
    ------
    ProjectError
        If the name is empty or taken.
    """
    new = new.strip()
    if not new:
        raise ProjectError(error("edit.no_name", target=old))
    if any(target.name == new for target in project.targets if target.name != old):
        raise ProjectError(error("edit.name_taken", name=new, target=old))
    return project.with_renamed_target(old, new)


def with_switched_role(project: Project, name: str) -> Project:
    """Change a target into a validation plane or back; it keeps its name.

    Raises
    ------
    ProjectError
        For a sphere, on which lines are not compared.
    """
    target = project.target(name)
    role: Role = "validation" if target.role == "target" else "target"
    return project.with_target(replace(target, role=role))
