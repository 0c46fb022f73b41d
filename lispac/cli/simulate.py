"""``lispac simulate``: a survey of a scene with known truth."""

from argparse import Namespace
from typing import Any

from lispac.cli.console import ConsoleProgress, UsageError, print_json
from lispac.workflow.planning import simulate as simulated
from lispac.workflow.planning.plan_simulation import is_plan, simulation_of_plan
from lispac.workflow.planning.simulated_setup import (
    KINDS,
    SimulatedSetup,
    read_simulation,
    supplied_titles,
)


def simulate(arguments: Namespace) -> None:
    """Simulate a survey and write it, or list the supplied scenes.

    Raises
    ------
    UsageError
        Where options do not go together.
    """
    if arguments.list:
        _print_supplied(arguments)
        return
    if arguments.scene is None or arguments.output is None:
        raise UsageError("simulate: give SCENE and --output DIR, or --list.")
    errors: dict[str, Any] = {
        "boresight_deg": arguments.boresight,
        "lever_arm": arguments.lever_arm_error,
        "range_offset": arguments.range_offset,
        "scan_angle_offset_deg": arguments.scan_angle_offset,
        "latency": arguments.latency,
    }
    known = {name: value for name, value in errors.items() if value is not None}
    if is_plan(arguments.scene):
        chosen = _read_plan_simulation(arguments, known)
    else:
        chosen = read_simulation(
            arguments.scene,
            vessel=arguments.vessel,
            scanner=arguments.scanner,
            trajectory=arguments.trajectory,
            points_per_second=arguments.points_per_second,
            errors=known,
        )
    with ConsoleProgress() as progress:
        project, points = simulated.simulate(
            arguments.output,
            chosen,
            seed=arguments.seed,
            noise=not arguments.no_noise,
            pos_errors=not arguments.no_pos_errors,
            progress=progress,
        )
    truth = project.folder / simulated.TRUTH / "truth.json"
    targets, balls = (project.folder / name for name in (simulated.TARGETS, simulated.BALLS))
    if arguments.json:
        print_json(
            {
                "project": str(project.folder),
                "points": points,
                "truth": str(truth),
                "seeds": str(targets) if targets.is_file() else None,
                "ball_seeds": str(balls) if balls.is_file() else None,
                **{kind: chosen.titles[kind] for kind in KINDS},
            }
        )
        return
    for kind in KINDS:
        print(f"{kind:10s} {chosen.titles[kind]}")
    for name, count in points.items():
        print(f"{name:20s} {count:12,} points")
    print("truth      " + "".join(f"{angle:+12.4f}" for angle in project.truth_deg or ()))
    print(f"project    {project.folder}")
    if targets.is_file():
        print(f"seeds      {targets} (for lispac pick --seeds)")
    if balls.is_file():
        print(f"spheres    {balls} (for lispac pick --shape sphere --seeds)")


def _read_plan_simulation(arguments: Namespace, errors: dict[str, Any]) -> SimulatedSetup:
    if arguments.scanner or arguments.trajectory:
        raise UsageError(
            "simulate: a survey plan contains its scanner and lines; omit --scanner and "
            "--trajectory."
        )
    return simulation_of_plan(
        arguments.scene,
        vessel=arguments.vessel,
        points_per_second=arguments.points_per_second,
        errors=errors,
    )


def _print_supplied(arguments: Namespace) -> None:
    known = {f"{kind}s": supplied_titles(kind) for kind in KINDS}
    if arguments.json:
        print_json(known)
        return
    for kind, titles in known.items():
        print(kind)
        for name, title in titles.items():
            print(f"  {name:20s} {title}")
