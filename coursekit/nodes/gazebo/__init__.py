"""The simulator under Gazebo's names: its files (SDF, URDF with <gazebo> blocks), its node, its services."""
