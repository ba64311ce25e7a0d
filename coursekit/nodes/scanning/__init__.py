"""What nodes share that take scans and work in the plane: messages as poses, the sensor, scans with their transforms."""
