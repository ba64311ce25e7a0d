"""pointcloud_to_laserscan and depthimage_to_laserscan: planar scans from other sensors, and clouds from scans."""
