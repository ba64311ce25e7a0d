"""imu_tools: estimate orientations from IMU measurements."""
