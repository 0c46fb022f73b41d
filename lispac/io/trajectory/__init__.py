"""Trajectories and their accuracies."""
