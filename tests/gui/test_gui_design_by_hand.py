"""The design window of the program itself, with the views that it draws."""

from tests.gui.by_hand import Hands
from tests.gui.design_support import opened_by_keys
from tests.gui.support import WAIT_MS, Left


def test_the_site_is_seen_in_3d(hands: Hands) -> None:
    design = opened_by_keys(hands)
    bar = design.views.tabBar()
    hands.bot.mouseClick(bar, Left, pos=bar.tabRect(1).center())
    hands.bot.waitUntil(
        lambda: (
            design.view3d is not None
            and design.view3d.viewport.drawn_near("wall", (0, 0, 0), 1e6).size > 0
        ),
        timeout=WAIT_MS,
    )
    assert design.isVisible()
