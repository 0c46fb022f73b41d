"""Model of the adjustment: observations, stochastic model, parameters, shapes, conditions."""
