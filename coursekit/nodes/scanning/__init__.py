"""The common parts of nodes that take scans and work in the plane: poses, the sensor, scans with their transforms."""
