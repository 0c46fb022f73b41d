"""Names of the models of the POS errors in figures and forms of the survey design."""

from lispac.adjustment.model.stochastic_model import PosErrors
from lispac.language import N_

POS_ERROR_MODEL_NAMES: dict[PosErrors, str] = {
    "correlated": N_("correlated POS errors"),
    "independent": N_("uncorrelated POS errors (classical)"),
}
