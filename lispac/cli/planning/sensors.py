"""``lispac sensors``: list of the scanners and INS/GNSS in the library, with sources."""

from argparse import ArgumentParser, Namespace

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import print_json, print_table
from lispac.cli.messages import print_messages


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print all sensors of the library."""
    from lispac.present.survey.sensors import POS_TABLE, SCANNERS_TABLE, PosRow, ScannerRow
    from lispac.workflow.planning.sensors import read_library, source_text, user_sensors_folder

    folder = user_sensors_folder()
    found = read_library(folder)
    print_messages(found.messages)
    if arguments.json:
        from lispac.cli.json_outputs import PosOutput, ScannerOutput, SensorsOutput, extended

        known_scanners = {
            each.name: extended(ScannerOutput, each.figures, user_defined=each.is_user_defined)
            for each in found.scanners
        }
        known_pos = {
            each.name: extended(PosOutput, each.figures, user_defined=each.is_user_defined)
            for each in found.pos
        }
        print_json(SensorsOutput(folder, known_scanners, known_pos))
        return
    scanners = [
        ScannerRow(
            each.name, each.figures.range_sigma, each.figures.angle_sigma_deg,
            each.figures.divergence_mrad, each.figures.title, source_text(each.figures),
            each.is_user_defined,
        )
        for each in found.scanners
    ]  # fmt: skip
    pos = [
        PosRow(
            f"{each.name}:{state.name}", state.position_sigma, state.attitude_sigma_deg,
            each.figures.title, source_text(state), each.is_user_defined,
        )
        for each in found.pos
        for state in each.figures.states
    ]  # fmt: skip
    print_table(SCANNERS_TABLE, scanners)
    print_table(POS_TABLE, pos)
    print(f"User-defined sensors are stored in {folder}")
