# ament_cmake: what packages say of themselves, and what other packages then find of them.

include_guard(GLOBAL)
include("${COURSEKIT_CMAKE}/ament_cmake_core.cmake")
include("${COURSEKIT_CMAKE}/ament_cmake_gen_version_h.cmake")
include("${COURSEKIT_CMAKE}/ament_cmake_python.cmake")
include("${COURSEKIT_CMAKE}/ament_cmake_test.cmake")

macro(_coursekit_gather variable)
  set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY ${variable} ${ARGN})
endmacro()

macro(_coursekit_export function variable)
  if(_${PROJECT_NAME}_AMENT_PACKAGE)
    message(FATAL_ERROR "${function}() must be called before ament_package()")
  endif()
  _coursekit_gather(${variable} ${ARGN})
endmacro()

macro(ament_target_dependencies target)
  set(_coursekit_keyword "")
  set(_coursekit_found "")
  foreach(_coursekit_word ${ARGN})
    if(_coursekit_word MATCHES "^(PUBLIC|PRIVATE|INTERFACE)$")
      set(_coursekit_keyword ${_coursekit_word})
    elseif(NOT _coursekit_word STREQUAL "SYSTEM")
      if(NOT ${_coursekit_word}_FOUND)
        message(FATAL_ERROR "ament_target_dependencies() the passed package name '${_coursekit_word}' was not found before")
      endif()
      if(${_coursekit_word}_TARGETS)
        list(APPEND _coursekit_found ${${_coursekit_word}_TARGETS})
      else()
        list(APPEND _coursekit_found ${${_coursekit_word}_LIBRARIES})
        target_include_directories(${target} PUBLIC ${${_coursekit_word}_INCLUDE_DIRS})
      endif()
    endif()
  endforeach()
  target_link_libraries(${target} ${_coursekit_keyword} ${_coursekit_found})
endmacro()

macro(ament_export_dependencies)
  _coursekit_export(ament_export_dependencies COURSEKIT_DEPENDENCIES ${ARGN})
endmacro()

macro(ament_export_include_directories)
  _coursekit_export(ament_export_include_directories COURSEKIT_INCLUDES ${ARGN})
endmacro()

macro(ament_export_libraries)
  _coursekit_export(ament_export_libraries COURSEKIT_LIBRARIES ${ARGN})
endmacro()

macro(ament_export_library_names)
  _coursekit_export(ament_export_library_names COURSEKIT_LIBRARIES ${ARGN})
endmacro()

macro(ament_export_definitions)
  _coursekit_export(ament_export_definitions COURSEKIT_DEFINITIONS ${ARGN})
endmacro()

macro(ament_export_link_flags)
  _coursekit_export(ament_export_link_flags COURSEKIT_LINK_FLAGS ${ARGN})
endmacro()

macro(ament_export_interfaces)
  _coursekit_export_targets(ament_export_interfaces ${ARGN})
endmacro()

macro(ament_export_targets)
  _coursekit_export_targets(ament_export_targets ${ARGN})
endmacro()

macro(_coursekit_export_targets function)
  set(_coursekit_exports ${ARGN})
  list(REMOVE_ITEM _coursekit_exports HAS_LIBRARY_TARGET)
  _coursekit_export(${function} COURSEKIT_EXPORTS ${_coursekit_exports})
endmacro()

function(ament_get_pkg_config)
endfunction()

macro(ament_libraries_deduplicate variable)
  set(${variable} ${ARGN})
  list(REMOVE_DUPLICATES ${variable})
endmacro()

function(ament_include_directories_order variable)
  set(${variable} ${ARGN} PARENT_SCOPE)
endfunction()
