"""Scripts that made the meshes."""
