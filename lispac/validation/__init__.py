"""How far apart the lines were on what was not used in the adjustment, and how close they are."""
