"""Common parts of nodes that process scans in the plane: poses, the sensor, scans with their transforms."""
