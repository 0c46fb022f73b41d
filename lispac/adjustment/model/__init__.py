"""What is adjusted: observations, stochastic model, parameters, target shapes, conditions."""
