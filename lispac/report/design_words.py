"""Words of a plan's figures that a window needs before it draws one."""

from lispac.adjustment.stochastic import PosErrors

NAMES: dict[PosErrors, str] = {
    "correlated": "POS errors that drift",
    "independent": "every point its own POS error (thesis)",
}
