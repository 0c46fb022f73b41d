"""Solution: normal equations, elimination of the POS error, iteration, rejection of blunders."""
