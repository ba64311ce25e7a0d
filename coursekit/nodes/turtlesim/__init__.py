"""turtlesim: the window with turtles, and the programs that drive them."""
