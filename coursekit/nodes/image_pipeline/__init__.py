"""image_proc and depth_image_proc: rectified images, and clouds of points from depth images."""
