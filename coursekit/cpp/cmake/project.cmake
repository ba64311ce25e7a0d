# Read by CMake right after the first project() of every package that `colcon build` builds here.
#   COURSEKIT_CPP      the folder with the runtime's library, the interfaces' headers and the configs of packages
#   COURSEKIT_CMAKE    this folder
#   COURSEKIT_ROOT     the folder above it, with include/
#   COURSEKIT_PYTHON   a Python that has coursekit

include_guard(GLOBAL)

if(NOT CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD 17)
endif()

# What packages of the underlay give to those that find them: headers. The runtime is linked into programs, once.
add_library(coursekit_headers INTERFACE IMPORTED GLOBAL)
target_include_directories(coursekit_headers SYSTEM INTERFACE "${COURSEKIT_ROOT}/include" "${COURSEKIT_CPP}/include")
target_compile_features(coursekit_headers INTERFACE cxx_std_17)
find_package(Threads QUIET)

# A program's clocks, threads and locks are the runtime's, whether or not it includes rclcpp.
macro(add_executable _coursekit_target)
  _add_executable(${_coursekit_target} ${ARGN})
  coursekit_link_runtime(${_coursekit_target} ${ARGN})
endmacro()

function(coursekit_link_runtime target)
  if("${ARGN}" MATCHES "^(IMPORTED|ALIAS)(;|$)")
    return()
  endif()
  set(library "${COURSEKIT_CPP}/lib/libcoursekit.a")
  if(APPLE)
    target_link_options(${target} PRIVATE "SHELL:-Wl,-force_load \"${library}\"")
  else()
    target_link_options(${target} PRIVATE "SHELL:-Wl,--whole-archive \"${library}\" -Wl,--no-whole-archive")
  endif()
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${library}")
  set_property(TARGET ${target} APPEND PROPERTY LINK_LIBRARIES Threads::Threads ${CMAKE_DL_LIBS})
endfunction()

# Libraries are static: a program then has one copy of the runtime, and exceptions and types cross them safely.
macro(add_library _coursekit_target)
  set(_coursekit_words ${ARGN})
  list(TRANSFORM _coursekit_words REPLACE "^(SHARED|MODULE)$" "STATIC")
  if(NOT ";${_coursekit_words};" MATCHES ";(IMPORTED|INTERFACE|ALIAS|OBJECT|STATIC);")
    list(PREPEND _coursekit_words STATIC)
  endif()
  _add_library(${_coursekit_target} ${_coursekit_words})
endmacro()

if(AMENT_CMAKE_SYMLINK_INSTALL)
  include("${COURSEKIT_CMAKE}/symlink_install.cmake")
endif()
