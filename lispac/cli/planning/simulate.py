"""``lispac simulate``: simulated survey of a scene, with known true values."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lispac.cli.argument_types import (
    add_json_option,
    add_triple_option,
    positive_number,
    whole_number_from,
)
from lispac.cli.console import ConsoleProgress, UsageError, print_json
from lispac.cli.noise_options import add_offset_options

if TYPE_CHECKING:
    from lispac.workflow.planning.simulated_setup import SimulatedSetup


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "scene",
        nargs="?",
        metavar="SCENE",
        help="name of a scene (see --list), or TOML file with a scene or a survey plan",
    )
    parser.add_argument("--output", type=Path, metavar="DIR", help="project folder to create")
    parser.add_argument(
        "--list", action="store_true", help="list scenes, vessels and scanners and exit"
    )
    parser.add_argument(
        "--seed", type=whole_number_from(0), default=2019, metavar="N",
        help="seed of the random numbers: the same seed gives the same survey (default 2019)",
    )  # fmt: skip
    for kind in ("vessel", "scanner"):
        parser.add_argument(
            f"--{kind}",
            metavar="NAME",
            help=f"{kind} to use instead of that of the scene: name or TOML file",
        )
    parser.add_argument(
        "--trajectory",
        type=Path,
        metavar="SBET",
        help="SBET file to use as the true motion (default: simulated)",
    )
    parser.add_argument(
        "--points-per-second", type=positive_number, metavar="N",
        help="pulses per second over the full rotation of the scanner (default: from the scene or "
             "scanner)",
    )  # fmt: skip
    add_triple_option(
        parser, "--boresight", ("ROLL", "PITCH", "YAW"),
        "true boresight (deg; default: that of the vessel)",
    )  # fmt: skip
    add_triple_option(
        parser,
        "--lever-arm-error",
        ("X", "Y", "Z"),
        "true lever arm minus the lever arm written to the project (m)",
    )
    add_offset_options(parser, "true", "that of the vessel")
    parser.add_argument(
        "--no-noise",
        action="store_true",
        help="simulate the scanner without noise and without mixed echoes",
    )
    parser.add_argument(
        "--no-pos-errors", action="store_true", help="simulate the POS without errors"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Simulate a survey and write it, or list the supplied scenes, vessels and scanners.

    Raises
    ------
    UsageError
        If options cannot be combined.
    """
    from lispac.workflow.planning import simulate as simulated
    from lispac.workflow.planning.plan_simulation import is_plan
    from lispac.workflow.planning.simulated_setup import PART_KINDS, read_simulation

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
    truth = project.folder / simulated.TRUTH_FOLDER / "truth.json"
    targets, balls = (
        project.folder / name for name in (simulated.TARGET_LIST_FILE, simulated.SPHERE_LIST_FILE)
    )
    if arguments.json:
        from lispac.cli.json_outputs import SimulateOutput

        seeds, ball_seeds = (path if path.is_file() else None for path in (targets, balls))
        titles = (chosen.titles[kind] for kind in PART_KINDS)
        print_json(SimulateOutput(project.folder, points, truth, seeds, ball_seeds, *titles))
        return
    from lispac.present.tables import COUNT, DEGREES

    for kind in PART_KINDS:
        print(f"{kind:10s} {chosen.titles[kind]}")
    for name, count in points.items():
        print(f"{name:20s} {COUNT.text(count):>12s} points")
    angles = map(DEGREES.signed.plain_text, project.truth_deg or ())
    print("truth      " + "".join(f"{angle:>12s}" for angle in angles))
    print(f"project    {project.folder}")
    if targets.is_file():
        print(f"seeds      {targets} (for lispac pick --seeds)")
    if balls.is_file():
        print(f"spheres    {balls} (for lispac pick --shape sphere --seeds)")


def _read_plan_simulation(arguments: Namespace, errors: dict[str, Any]) -> SimulatedSetup:
    from lispac.workflow.planning.plan_simulation import simulation_of_plan

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
    from lispac.workflow.planning.simulated_setup import PART_KINDS, supplied_titles

    known = {f"{kind}s": supplied_titles(kind) for kind in PART_KINDS}
    if arguments.json:
        from lispac.cli.json_outputs import SuppliedPartsOutput

        print_json(SuppliedPartsOutput(**known))
        return
    for kind, titles in known.items():
        print(kind)
        for name, title in titles.items():
            print(f"  {name:20s} {title}")
