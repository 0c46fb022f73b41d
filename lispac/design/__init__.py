"""Design of calibration surveys: predicted precision, search for a plan, Monte Carlo check."""
