"""Before the survey: simulation, plans, sensors, and studies on many machines."""
