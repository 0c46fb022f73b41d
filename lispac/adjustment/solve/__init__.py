"""Solution of the adjustment: normal equations, iteration, rejection of blunders."""
