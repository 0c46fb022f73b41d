"""``lispac sensors``: list of the scanners and INS/GNSS in the library, with sources."""

from argparse import ArgumentParser, Namespace
from dataclasses import asdict

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import print_json
from lispac.cli.messages import print_messages


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print all sensors of the library."""
    from lispac.workflow.planning.sensors import read_library, source_text, user_sensors_folder

    folder = user_sensors_folder()
    found = read_library(folder)
    print_messages(found.messages)
    if arguments.json:
        print_json(
            {
                "folder": str(folder),
                "scanners": {
                    s.name: {**asdict(s.figures), "user_defined": s.is_user_defined}
                    for s in found.scanners
                },
                "pos": {
                    s.name: {**asdict(s.figures), "user_defined": s.is_user_defined}
                    for s in found.pos
                },
            }
        )
        return
    print(f"{'scanner, 1 sigma':28s}{'range':>9s}{'direction':>13s}{'divergence':>12s}")
    for sensor in found.scanners:
        figures = sensor.figures
        mark = _own_mark(sensor.is_user_defined)
        print(
            f"{sensor.name:28s}{1000 * figures.range_sigma:6.1f} mm{figures.angle_sigma_deg:9.4f} "
            f"deg{figures.divergence_mrad:7.2f} mrad  {figures.title}{mark}"
        )
        print(f"    {source_text(figures)}")
    print(f"\n{'INS/GNSS, 1 sigma':28s}{'north, east, down':>22s}{'roll, pitch, heading':>26s}")
    for each in found.pos:
        for state in each.figures.states:
            position = " ".join(f"{value:.3f}" for value in state.position_sigma)
            attitude = " ".join(f"{value:.4f}" for value in state.attitude_sigma_deg)
            print(
                f"{f'{each.name}:{state.name}':28s}{position:>20s} m{attitude:>22s} deg  "
                f"{each.figures.title}{_own_mark(each.is_user_defined)}"
            )
            print(f"    {source_text(state)}")
    print(f"\nUser-defined sensors are stored in {folder}")


def _own_mark(user_defined: bool) -> str:
    return " (user-defined)" if user_defined else ""
