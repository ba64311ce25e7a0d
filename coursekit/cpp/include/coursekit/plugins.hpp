// The program that has the classes of a package's library, for a process of Python that would load the library on a robot.
#pragma once
#include <exception>
#include <string>
#include <typeinfo>

#include "coursekit/link.hpp"

namespace coursekit
{
/// Make the object that the arguments name (its kind, such as "hardware", and its class), and serve it until the process ends.
int run_plugins(int argc, char ** argv);
/// A handler of the process's requests to an object of that class.
Handler hardware_of(const std::string & type);
Handler controller_of(const std::string & type);
Handler planner_of(const std::string & type);
Handler smoother_of(const std::string & type);
Handler path_controller_of(const std::string & type);
Handler goal_checker_of(const std::string & type);
Handler progress_checker_of(const std::string & type);
Handler layer_of(const std::string & type);
Handler behavior_of(const std::string & type);
Handler waypoint_task_of(const std::string & type);
/// Here the libraries of a tree's nodes, one a line.
Handler tree_nodes_of(const std::string & paths);

inline const char * type_name(const std::exception & error) {return typeid(error).name();}

/// Do what may fail without an end of the program. Packs what was thrown, type and text, or two empty texts and the result.
template<class F>
void careful(Packer & to, F act, const char * (*name)(const std::exception &) = type_name)
{
  try {
    Packer result;
    act(result);
    to.s("").s("").raw(result.bytes.data(), result.bytes.size());
  } catch (const std::exception & error) {
    to.s(name(error)).s(error.what());
  } catch (...) {
    to.s("...").s("");
  }
}
}  // namespace coursekit
