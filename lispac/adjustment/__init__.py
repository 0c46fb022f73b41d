"""Least squares: observations, stochastic model, normal equations, diagnostics."""
