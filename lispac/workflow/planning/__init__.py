"""Survey planning: simulation, plans, sensors, and simulation studies on a cluster."""
