# ament_cmake_core: the resource index, what package.xml says, extension points, and helpers for lists, paths and names.

include_guard(GLOBAL)

# -- the resource index

function(ament_index_register_resource type)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SKIP_AMENT_INDEX_TEMPLATE" "CONTENT;CONTENT_FILE;PACKAGE_NAME" "AMENT_INDEX_BINARY_DIR")
  if(NOT arg_PACKAGE_NAME)
    set(arg_PACKAGE_NAME ${PROJECT_NAME})
  endif()
  set(file "${CMAKE_CURRENT_BINARY_DIR}/ament_cmake_index/${type}/${arg_PACKAGE_NAME}")
  if(arg_CONTENT_FILE)
    file(READ "${arg_CONTENT_FILE}" arg_CONTENT)
  endif()
  file(WRITE "${file}" "${arg_CONTENT}")
  install(FILES "${file}" DESTINATION "share/ament_index/resource_index/${type}")
endfunction()

function(ament_index_register_package)
  ament_index_register_resource(packages ${ARGN})
endfunction()

function(ament_index_get_prefix_path variable)
  file(TO_CMAKE_PATH "$ENV{AMENT_PREFIX_PATH}" prefixes)
  set(${variable} ${prefixes} PARENT_SCOPE)
endfunction()

# The prefix of the workspace or package that has the resource, FALSE where none has it.
function(ament_index_has_resource variable type name)
  ament_index_get_prefix_path(prefixes)
  set(${variable} FALSE PARENT_SCOPE)
  foreach(prefix ${prefixes})
    if(EXISTS "${prefix}/share/ament_index/resource_index/${type}/${name}")
      set(${variable} "${prefix}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

function(ament_index_get_resource variable type name)
  ament_index_has_resource(prefix "${type}" "${name}")
  if(NOT prefix)
    message(FATAL_ERROR "ament_index_get_resource() called with not existing resource ('${type}' '${name}')")
  endif()
  file(READ "${prefix}/share/ament_index/resource_index/${type}/${name}" content)
  set(${variable} "${content}" PARENT_SCOPE)
endfunction()

function(ament_index_get_resources variable type)
  ament_index_get_prefix_path(prefixes)
  set(names "")
  foreach(prefix ${prefixes})
    file(GLOB found RELATIVE "${prefix}/share/ament_index/resource_index/${type}" "${prefix}/share/ament_index/resource_index/${type}/*")
    list(APPEND names ${found})
  endforeach()
  list(REMOVE_DUPLICATES names)
  list(SORT names)
  set(${variable} ${names} PARENT_SCOPE)
endfunction()

# -- package.xml

macro(ament_package_xml)
  cmake_parse_arguments(_coursekit_arg "" "DIRECTORY" "" ${ARGN})
  if(NOT _coursekit_arg_DIRECTORY)
    set(_coursekit_arg_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  endif()
  file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/ament_cmake_core")
  execute_process(COMMAND "${COURSEKIT_PYTHON}" -m coursekit.packages.manifest_facts "${_coursekit_arg_DIRECTORY}/package.xml"
    OUTPUT_FILE "${CMAKE_CURRENT_BINARY_DIR}/ament_cmake_core/package.cmake" RESULT_VARIABLE _coursekit_code ERROR_VARIABLE _coursekit_error)
  if(_coursekit_code)
    message(FATAL_ERROR "ament_package_xml() ${_coursekit_error}")
  endif()
  include("${CMAKE_CURRENT_BINARY_DIR}/ament_cmake_core/package.cmake")
endmacro()

function(_coursekit_manifest_version variable)
  file(READ "${PROJECT_SOURCE_DIR}/package.xml" version)
  string(REGEX REPLACE ".*<version[^>]*>[ \n\t]*([0-9.]+).*" "\\1" version "${version}")
  set(${variable} "${version}" PARENT_SCOPE)
endfunction()

# -- extension points: files that are read when somebody says so

macro(ament_register_extension point package file)
  set_property(GLOBAL APPEND PROPERTY COURSEKIT_EXTENSIONS_${point} "${${package}_DIR}/${file}")
endmacro()

macro(ament_execute_extensions point)
  get_property(_coursekit_files GLOBAL PROPERTY COURSEKIT_EXTENSIONS_${point})
  foreach(_coursekit_file ${_coursekit_files})
    include("${_coursekit_file}")
  endforeach()
endmacro()

# -- helpers

macro(list_append_unique list)
  foreach(_coursekit_one ${ARGN})
    if(NOT _coursekit_one IN_LIST ${list})
      list(APPEND ${list} ${_coursekit_one})
    endif()
  endforeach()
endmacro()

function(normalize_path variable path)
  get_filename_component(path "${path}" ABSOLUTE BASE_DIR "/")
  set(${variable} "${path}" PARENT_SCOPE)
endfunction()

function(string_ends_with text end variable)
  string(LENGTH "${text}" length)
  string(LENGTH "${end}" short)
  string(FIND "${text}" "${end}" at REVERSE)
  math(EXPR last "${length} - ${short}")
  set(${variable} FALSE PARENT_SCOPE)
  if(short EQUAL 0 OR (at GREATER_EQUAL 0 AND at EQUAL last))
    set(${variable} TRUE PARENT_SCOPE)
  endif()
endfunction()

function(assert_file_exists file message)
  if(NOT EXISTS "${file}")
    message(FATAL_ERROR "${message}")
  endif()
endfunction()

function(get_executable_path variable target)
  set(${variable} "${target}" PARENT_SCOPE)
  if(TARGET ${target})
    set(${variable} "$<TARGET_FILE:${target}>" PARENT_SCOPE)
  endif()
endfunction()

# Configure again when this file has changed.
function(stamp path)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
endfunction()
