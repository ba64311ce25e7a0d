"""image_view: windows and files for image topics."""
