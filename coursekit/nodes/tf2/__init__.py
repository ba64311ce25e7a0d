"""tf2's programs: a static publisher, echo, monitor, buffer server, view_frames."""
