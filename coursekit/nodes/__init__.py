"""The underlay's nodes, written against rclpy like any student's."""
