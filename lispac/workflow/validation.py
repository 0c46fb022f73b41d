"""How far apart the lines are on planes that took no part, before and after."""

from lispac.errors import NotComparable, ProjectError
from lispac.progress import Progress, no_progress, part
from lispac.project import Project
from lispac.validation.comparison import PlaneComparison, compare_plane
from lispac.workflow.survey import Survey


def validate(project: Project, survey: Survey, *, progress: Progress = no_progress) -> Project:
    """Compare the lines on every validation plane with the prior and the estimated boresight.

    Raises
    ------
    ProjectError
        Where nothing was estimated, or there is no validation plane.
    NotComparable
        Where no plane is seen in common by two lines; one of several such planes is named in
        ``not_compared`` instead.
    """
    placed = survey.placed(project, "estimated")
    planes = [plane for plane in project.of_role("validation") if plane.used]
    if not planes:
        raise ProjectError(
            f"{project.name}: there is no validation plane; pick planes that took no part in the "
            "adjustment."
        )
    comparisons: list[PlaneComparison] = []
    not_compared: dict[str, str] = {}
    for k, plane in enumerate(planes):
        step = part(progress, k / len(planes), (k + 1) / len(planes))
        step(0.0, f"Comparing the lines on {plane.name}")
        before, after = {}, {}
        for sighting in plane.used_sightings:
            before[sighting.line] = survey.clouds[sighting.line][sighting.indices]
            after[sighting.line] = placed[sighting.line][sighting.indices]
        try:
            comparisons.append(
                compare_plane(plane.name, before, after, survey.heading, progress=step)
            )
        except NotComparable as error:
            not_compared[plane.name] = str(error)
    if not comparisons:
        raise NotComparable(" ".join(not_compared.values()))
    return project.with_validation(tuple(comparisons), not_compared)
