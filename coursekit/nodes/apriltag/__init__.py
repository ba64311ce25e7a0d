"""apriltag_ros: the places of AprilTags in a camera's images."""
