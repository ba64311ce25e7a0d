"""Robots on topics: robot_state_publisher, joint_state_publisher with its sliders, check_urdf, xacro."""
