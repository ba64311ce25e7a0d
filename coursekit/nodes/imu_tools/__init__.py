"""imu_tools: orientations from what inertial units measure."""
