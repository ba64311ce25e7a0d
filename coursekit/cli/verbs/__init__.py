"""The commands of `ros2`, one module each: `register(subparsers)` adds it, its `main(args)` carries it out."""
