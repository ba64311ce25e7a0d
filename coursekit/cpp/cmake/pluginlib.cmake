# pluginlib: packages say which file describes the plugins in their libraries.

include_guard(GLOBAL)

function(pluginlib_export_plugin_description_file category file)
  if(IS_ABSOLUTE "${file}")
    message(FATAL_ERROR "pluginlib_export_plugin_description_file() was called with an absolute path, it must be a relative path")
  endif()
  if(NOT EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${file}")
    message(FATAL_ERROR "Given plugin description file '${CMAKE_CURRENT_SOURCE_DIR}/${file}' does not exist")
  endif()
  get_filename_component(folder "${file}" DIRECTORY)
  install(FILES "${file}" DESTINATION share/${PROJECT_NAME}/${folder})
  set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND_STRING PROPERTY COURSEKIT_PLUGINS_${category}
    "share/${PROJECT_NAME}/${file}\n")
  get_property(content DIRECTORY "${PROJECT_SOURCE_DIR}" PROPERTY COURSEKIT_PLUGINS_${category})
  ament_index_register_resource(${category}__pluginlib__plugin CONTENT "${content}")
  if(category MATCHES "^((hardware|controller)_interface|nav2_(core|costmap_2d))$")
    set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY COURSEKIT_SERVED "${PROJECT_SOURCE_DIR}/${file}")
    cmake_language(DEFER DIRECTORY "${PROJECT_SOURCE_DIR}" CALL _coursekit_add_plugin_programs)  # when all libraries are known
  endif()
endfunction()

# Each library of plugins for ros2_control or nav2 also becomes a program, which their servers start where a robot would load
# the library.
function(_coursekit_add_plugin_programs)
  get_property(files DIRECTORY "${PROJECT_SOURCE_DIR}" PROPERTY COURSEKIT_SERVED)
  set(libraries "")
  foreach(file ${files})
    file(READ "${file}" text)
    string(REGEX MATCHALL "<library[^>]*path=[\"'][^\"']+" found "${text}")
    list(APPEND libraries ${found})
  endforeach()
  foreach(library ${libraries})
    string(REGEX REPLACE ".*[\"'/]" "" library "${library}")
    string(REGEX REPLACE "^lib" "" name "${library}")
    foreach(target ${library} ${name})
      _coursekit_library_of(${target} target)
      if(TARGET ${target} AND NOT TARGET __plugins_${name})
        _coursekit_add_plugin_program(${target} ${name})
      endif()
    endforeach()
  endforeach()
endfunction()

# The target whose file has a name: that of the name, or another that was given it.
function(_coursekit_library_of name variable)
  set(${variable} ${name} PARENT_SCOPE)
  get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    _coursekit_file_name(${target} file)
    if(file STREQUAL name AND TARGET ${target}__loadable)
      set(${variable} ${target} PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

function(_coursekit_add_plugin_program target name)
  if("${target}" IN_LIST COURSEKIT_LEFT_OUT)
    return()
  endif()
  set(program __plugins_${name})
  set(source "${CMAKE_CURRENT_BINARY_DIR}/plugins/${program}.cpp")
  file(GENERATE OUTPUT "${source}" CONTENT "#include \"coursekit/plugins.hpp\"
int main(int argc, char ** argv) {return coursekit::run_plugins(argc, argv);}
")
  add_executable(${program} "${source}" $<TARGET_OBJECTS:${target}>)  # the objects, so that the classes are entered
  set_property(TARGET ${program} APPEND PROPERTY LINK_LIBRARIES $<TARGET_PROPERTY:${target},LINK_LIBRARIES> coursekit_headers)
  install(TARGETS ${program} DESTINATION lib/${PROJECT_NAME})
endfunction()
