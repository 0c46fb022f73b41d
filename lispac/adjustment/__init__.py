"""Least-squares adjustment: observations, stochastic model, solution, diagnostics."""
