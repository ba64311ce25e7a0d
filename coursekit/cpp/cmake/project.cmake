# Read by CMake right after the first project() of every package that `colcon build` builds here.
#   COURSEKIT_CPP      the folder with the runtime's library, the interfaces' headers and the configs of packages
#   COURSEKIT_CMAKE    this folder
#   COURSEKIT_ROOT     the folder above it, with include/
#   COURSEKIT_PYTHON   a Python that has coursekit

include_guard(GLOBAL)

# What a package depends on may stand in its package.xml alone.
if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/package.xml")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/package.xml")
endif()

if(NOT CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD 17)
endif()

# The runtime in a program is C++, whatever the program is.
get_property(_coursekit_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if("C" IN_LIST _coursekit_languages AND NOT "CXX" IN_LIST _coursekit_languages)
  enable_language(CXX)
endif()

# What packages of the underlay give to those that find them: headers. The runtime is linked into programs, once.
add_library(coursekit_headers INTERFACE IMPORTED GLOBAL)
target_include_directories(coursekit_headers SYSTEM INTERFACE "${COURSEKIT_ROOT}/include" "${COURSEKIT_CPP}/include")
target_compile_features(coursekit_headers INTERFACE cxx_std_17)

# Targets whose sources need what is not here, as a build has found out: they are there, and neither built nor installed.
function(_coursekit_leave_out target of)
  if("${of}" IN_LIST COURSEKIT_LEFT_OUT)
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  endif()
endfunction()

# A program's clocks, threads and locks are the runtime's, whether or not it includes rclcpp.
macro(add_executable _coursekit_target)
  _add_executable(${_coursekit_target} ${ARGN})
  _coursekit_leave_out(${_coursekit_target} ${_coursekit_target})
  coursekit_link_runtime(${_coursekit_target} ${ARGN})
endmacro()

function(coursekit_link_runtime target)
  if("${ARGN}" MATCHES "^(IMPORTED|ALIAS)(;|$)")
    return()
  endif()
  if(NOT TARGET Threads::Threads)  # not before: a package of files has no language to look for it in
    find_package(Threads QUIET)
  endif()
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
  set(library "${COURSEKIT_CPP}/lib/libcoursekit.a")
  _coursekit_replaced(replaced)
  if(APPLE)
    target_link_options(${target} PRIVATE "-Wl,-force_load,${library}")
  elseif(replaced)
    cmake_language(DEFER CALL _coursekit_link_runtime_last)
  else()
    target_link_options(${target} PRIVATE "SHELL:-Wl,--whole-archive \"${library}\" -Wl,--no-whole-archive")
  endif()
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${library}")
  if(WIN32)
    set_property(TARGET ${target} APPEND PROPERTY LINK_LIBRARIES ws2_32)
  else()
    set_property(TARGET ${target} APPEND PROPERTY LINK_LIBRARIES Threads::Threads ${CMAKE_DL_LIBS})
  endif()
endfunction()

# Whether the workspace has a package whose functions the runtime has as well, such as a clone of tf2: built here, or found.
function(_coursekit_replaced variable)
  set(${variable} FALSE PARENT_SCOPE)
  file(GLOB names RELATIVE "${COURSEKIT_ROOT}/include" "${COURSEKIT_ROOT}/include/*")
  foreach(name ${names})
    if(name STREQUAL PROJECT_NAME OR (${name}_DIR AND NOT ${name}_DIR MATCHES "^${COURSEKIT_CPP}"))
      set(${variable} TRUE PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# Behind all that the folder's programs are linked with: the functions of the workspace's package are taken, not the runtime's.
macro(_coursekit_link_runtime_last)
  if(NOT CMAKE_CXX_LINK_EXECUTABLE MATCHES "libcoursekit")
    string(APPEND CMAKE_CXX_LINK_EXECUTABLE " -Wl,--allow-multiple-definition -Wl,--whole-archive \"${COURSEKIT_CPP}/lib/libcoursekit.a\""
      " -Wl,--no-whole-archive -lpthread -ldl")
  endif()
endmacro()

# zig links a C++ library of its own into everything. Where the runtime has it with visible names, programs lend theirs to what
# they load, and that is linked as C is: without one. Elsewhere zig's programs load nothing.
set(_coursekit_lent "")
set(COURSEKIT_LOADS TRUE)
if(CMAKE_CXX_COMPILER MATCHES "zig")
  file(GLOB _coursekit_lent "${COURSEKIT_CPP}/lib/libc++*.a")
  if(_coursekit_lent)
    set(CMAKE_CXX_IMPLICIT_LINK_LIBRARIES "")
    enable_language(C)  # a project may have C++ alone
  else()
    set(COURSEKIT_LOADS FALSE)
  endif()
endif()

# Libraries are static: a program then has one copy of the runtime, and exceptions and types cross them safely. A shared one
# is made as well, without the runtime, for programs that load it while they run: it takes theirs.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
macro(add_library _coursekit_target)
  set(_coursekit_words ${ARGN})
  set(_coursekit_shared FALSE)
  if(";${_coursekit_words};" MATCHES ";(SHARED|MODULE);")
    set(_coursekit_shared TRUE)
  endif()
  list(TRANSFORM _coursekit_words REPLACE "^(SHARED|MODULE)$" "STATIC")
  if(NOT ";${_coursekit_words};" MATCHES ";(IMPORTED|INTERFACE|ALIAS|OBJECT|STATIC);")
    list(PREPEND _coursekit_words STATIC)
    set(_coursekit_shared ${BUILD_SHARED_LIBS})
  endif()
  _add_library(${_coursekit_target} ${_coursekit_words})
  _coursekit_leave_out(${_coursekit_target} ${_coursekit_target})
  if(_coursekit_shared AND NOT ";${_coursekit_words};" MATCHES ";IMPORTED;" AND COURSEKIT_LOADS)
    _coursekit_add_loadable(${_coursekit_target})
  endif()
endmacro()

# The source of a program that has C++ classes for a process of Python.
function(_coursekit_plugins_source program variable)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/plugins/${program}.cpp")
  file(GENERATE OUTPUT "${source}" CONTENT "#include \"coursekit/plugins.hpp\"
int main(int argc, char ** argv) {return coursekit::run_plugins(argc, argv);}
")
  set(${variable} "${source}" PARENT_SCOPE)
endfunction()

function(_coursekit_add_loadable target)
  set(loadable ${target}__loadable)
  _add_library(${loadable} MODULE $<TARGET_OBJECTS:${target}> "${COURSEKIT_CPP}/age.cpp")
  _coursekit_leave_out(${loadable} ${target})
  set(name "$<TARGET_PROPERTY:${target},OUTPUT_NAME>")  # as it is when all has been read
  set_target_properties(${loadable} PROPERTIES OUTPUT_NAME "$<IF:$<BOOL:${name}>,${name},${target}>" LINKER_LANGUAGE CXX)
  if(_coursekit_lent)
    set_target_properties(${loadable} PROPERTIES LINKER_LANGUAGE C)
    target_link_options(${loadable} PRIVATE -lunwind)
  endif()
  set_property(TARGET ${loadable} APPEND PROPERTY LINK_LIBRARIES $<TARGET_PROPERTY:${target},LINK_LIBRARIES>)
  if(APPLE)
    target_link_options(${loadable} PRIVATE -undefined dynamic_lookup)
    set_target_properties(${loadable} PROPERTIES SUFFIX .so)
  elseif(NOT WIN32)
    target_link_options(${loadable} PRIVATE -Wl,-z,undefs)  # the package may ask for the contrary of all its libraries
  endif()
endfunction()

# Programs that load libraries let them have the runtime that they are linked with.
foreach(_coursekit_name class_loader pluginlib)
  if(NOT TARGET ${_coursekit_name}::${_coursekit_name})
    _add_library(${_coursekit_name}::${_coursekit_name} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(${_coursekit_name}::${_coursekit_name} INTERFACE coursekit_headers)
    if(COURSEKIT_LOADS)
      target_link_options(${_coursekit_name}::${_coursekit_name} INTERFACE -rdynamic)
    endif()
    if(_coursekit_lent)
      list(JOIN _coursekit_lent "\" \"" _coursekit_files)
      target_link_options(${_coursekit_name}::${_coursekit_name} INTERFACE "SHELL:$<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,\
EXECUTABLE>:-Wl,--whole-archive \"${_coursekit_files}\" -Wl,--no-whole-archive>")
    endif()
  endif()
endforeach()

if(AMENT_CMAKE_SYMLINK_INSTALL)
  include("${COURSEKIT_CMAKE}/symlink_install.cmake")
endif()

# The name that the file of a library has, without lib.
function(_coursekit_file_name target variable)
  get_target_property(name ${target} OUTPUT_NAME)
  if(NOT name)
    set(name ${target})
  endif()
  set(${variable} "${name}" PARENT_SCOPE)
endfunction()

macro(install)
  if(AMENT_CMAKE_SYMLINK_INSTALL AND "${ARGV0}" MATCHES "^(FILES|PROGRAMS|DIRECTORY)$")
    _coursekit_link_install(${ARGV})
  elseif("${ARGV0}" STREQUAL "TARGETS")
    _coursekit_install_targets(${ARGN})
  else()
    _install(${ARGV})
  endif()
endmacro()

function(_coursekit_install_targets kind)
  set(words ${ARGN})
  if(COURSEKIT_LEFT_OUT)
    list(REMOVE_ITEM words ${COURSEKIT_LEFT_OUT})
    list(GET words 0 first)
    if(NOT "${words}" STREQUAL "${ARGN}" AND NOT TARGET ${first})
      return()  # nothing is left to install
    endif()
  endif()
  _install(${kind} ${words})
  _coursekit_install_loadable(${words})
endfunction()

function(_coursekit_install_loadable)
  set(folder lib)
  if("${ARGN}" MATCHES "LIBRARY;DESTINATION;([^;]+)")
    set(folder "${CMAKE_MATCH_1}")
  elseif("${ARGN}" MATCHES "DESTINATION;([^;]+)$")
    set(folder "${CMAKE_MATCH_1}")
  endif()
  foreach(word ${ARGN})
    if(TARGET ${word}__loadable)
      _install(TARGETS ${word}__loadable LIBRARY DESTINATION ${folder})
    endif()
  endforeach()
endfunction()
