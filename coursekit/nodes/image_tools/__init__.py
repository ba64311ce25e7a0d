"""The package image_tools: a camera, or a flying burger, as a topic; and who looks at it."""
