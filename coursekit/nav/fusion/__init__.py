"""What several sensors say about a motion, together: Kalman filters of 15 numbers in three dimensions."""
