# rclcpp_components: each component becomes a program, which a container starts where a robot would load a library.

include_guard(GLOBAL)

foreach(_coursekit_suffix component component_manager)
  if(NOT TARGET rclcpp_components::${_coursekit_suffix})
    _add_library(rclcpp_components::${_coursekit_suffix} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(rclcpp_components::${_coursekit_suffix} INTERFACE coursekit_headers)
  endif()
endforeach()

# Its factories are made by class_loader, as in Humble: who links it may load libraries.
foreach(_coursekit_suffix rclcpp_components component component_manager)
  target_link_libraries(rclcpp_components::${_coursekit_suffix} INTERFACE class_loader::class_loader)
endforeach()

macro(rclcpp_components_register_node target)
  cmake_parse_arguments(_coursekit_arg "" "PLUGIN;EXECUTABLE;EXECUTOR;RESOURCE_INDEX" "" ${ARGN})
  if(NOT _coursekit_arg_PLUGIN OR NOT _coursekit_arg_EXECUTABLE)
    message(FATAL_ERROR "rclcpp_components_register_node() needs a PLUGIN and an EXECUTABLE")
  endif()
  if(NOT _coursekit_arg_EXECUTOR)
    set(_coursekit_arg_EXECUTOR SingleThreadedExecutor)
  endif()
  _coursekit_component(${target} ${_coursekit_arg_EXECUTABLE} ${_coursekit_arg_PLUGIN} ${_coursekit_arg_EXECUTOR})
  _coursekit_link_whole(${target})
endmacro()

# Who links a library of components has its classes, though nothing names them: the linker would leave such objects out.
function(_coursekit_link_whole target)
  set_property(TARGET ${target} APPEND PROPERTY INTERFACE_SOURCES $<BUILD_INTERFACE:$<TARGET_OBJECTS:${target}>>)
endfunction()

macro(rclcpp_components_register_nodes target)
  _coursekit_link_whole(${target})
  cmake_parse_arguments(_coursekit_arg "" "RESOURCE_INDEX" "" ${ARGN})
  foreach(_coursekit_plugin ${_coursekit_arg_UNPARSED_ARGUMENTS})
    string(REGEX REPLACE "[^A-Za-z0-9]+" "_" _coursekit_program "${_coursekit_plugin}")
    _coursekit_component(${target} __component_${_coursekit_program} ${_coursekit_plugin} SingleThreadedExecutor)
  endforeach()
endmacro()

function(_coursekit_component target program plugin executor)
  if("${target}" IN_LIST COURSEKIT_LEFT_OUT)
    return()
  endif()
  set(source "${CMAKE_CURRENT_BINARY_DIR}/rclcpp_components/${program}.cpp")
  set(content "#include \"rclcpp_components/coursekit_run.hpp\"
int main(int argc, char ** argv)
{
  return rclcpp_components::run<rclcpp::executors::${executor}>(\"${plugin}\", argc, argv);
}
")
  file(GENERATE OUTPUT "${source}" CONTENT "${content}")
  add_executable(${program} "${source}" $<TARGET_OBJECTS:${target}>)  # the objects, so that the class is entered
  set_property(TARGET ${program} APPEND PROPERTY LINK_LIBRARIES $<TARGET_PROPERTY:${target},LINK_LIBRARIES> coursekit_headers)
  install(TARGETS ${program} DESTINATION lib/${PROJECT_NAME})
  get_property(known DIRECTORY "${PROJECT_SOURCE_DIR}" PROPERTY COURSEKIT_COMPONENTS)
  set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" PROPERTY COURSEKIT_COMPONENTS
    "${known}${plugin}|lib/${PROJECT_NAME}/${program}|lib/lib@${target}@.so\n")
endfunction()
