"""joy: a gamepad's axes and buttons."""
