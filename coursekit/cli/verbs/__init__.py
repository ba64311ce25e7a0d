"""The commands of `ros2`, one module each: `register(subparsers)` adds a command, `main(args)` runs it."""
