"""Which boards and lines to choose: prediction, search, Monte Carlo."""
