"""The package image_tools: publishes images from a camera, or of a flying burger, and shows them."""
