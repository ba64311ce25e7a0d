// main() of a program that has a package's hardware.
#pragma once

namespace hardware_interface
{
/// Make the class that argv[1] names, and do with it what the controller manager asks.
int run(int argc, char ** argv);
}  // namespace hardware_interface
