"""Tests of the options that the command line prints below a message."""

import io

import pytest

from lispac.cli.messages import print_messages
from lispac.message_texts import ACTIONS
from lispac.messages import Action, note

FILE_OPTIONS = {
    Action("check_sign", {"name": "pitch"}): "--trajectory-option pitch=VALUE",
    Action("choose_frame", {"name": "frame"}): "--line-option frame=VALUE",
    Action("use_feet", {"name": "unit", "value": "foot"}): "--line-option unit=foot",
    Action("shift_times", {"shift": 18.0}): "--time-shift 18",
    Action("split_line", {"line": "L1", "by": "gap"}): "--split-by gap",
}


def printed(action: Action) -> list[str]:
    """Lines below the text of a message with an action."""
    file = io.StringIO()
    print_messages([note("fact.signs_not_checked", actions=(action,))], file)
    return [line.strip() for line in file.getvalue().splitlines()[1:]]


@pytest.mark.parametrize(("action", "option"), list(FILE_OPTIONS.items()))
def test_an_action_is_printed_as_an_option(action: Action, option: str) -> None:
    assert printed(action) == [option]


@pytest.mark.parametrize("code", sorted(ACTIONS))
def test_no_label_of_a_button_is_printed(code: str) -> None:
    params = {"name": "x", "value": "1", "by": "gap", "shift": 1.0, "gap": 2.0, "measured": 0.004}
    assert all(line.startswith("--") for line in printed(Action(code, params)))
