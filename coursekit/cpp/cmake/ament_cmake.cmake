# ament_cmake: what packages say of themselves, and what other packages then find of them.

include_guard(GLOBAL)
include(CMakePackageConfigHelpers)
option(BUILD_TESTING "Build the testing tree." OFF)

macro(_coursekit_gather variable)
  set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY ${variable} ${ARGN})
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
  _coursekit_gather(COURSEKIT_DEPENDENCIES ${ARGN})
endmacro()

macro(ament_export_include_directories)
  _coursekit_gather(COURSEKIT_INCLUDES ${ARGN})
endmacro()

macro(ament_export_libraries)
  _coursekit_gather(COURSEKIT_LIBRARIES ${ARGN})
endmacro()

macro(ament_export_interfaces)
  ament_export_targets(${ARGN})
endmacro()

macro(ament_export_targets)
  set(_coursekit_exports ${ARGN})
  list(REMOVE_ITEM _coursekit_exports HAS_LIBRARY_TARGET)
  _coursekit_gather(COURSEKIT_EXPORTS ${_coursekit_exports})
endmacro()

function(ament_get_pkg_config)
endfunction()

function(ament_include_directories_order variable)
  set(${variable} ${ARGN} PARENT_SCOPE)
endfunction()

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

function(ament_environment_hooks)
  install(FILES ${ARGN} DESTINATION share/${PROJECT_NAME}/environment)
endfunction()

# -- Python packages beside C++

function(ament_python_install_package name)
  cmake_parse_arguments(arg "SKIP_COMPILE" "PACKAGE_DIR;VERSION;SETUP_CFG;DESTINATION;SCRIPTS_DESTINATION" "" ${ARGN})
  if(NOT arg_PACKAGE_DIR)
    set(arg_PACKAGE_DIR ${name})
  endif()
  get_filename_component(folder "${arg_PACKAGE_DIR}" ABSOLUTE)
  if(NOT EXISTS "${folder}/__init__.py")
    message(FATAL_ERROR "ament_python_install_package() the Python package folder '${folder}' doesn't contain an '__init__.py' file")
  endif()
  if(NOT arg_DESTINATION)
    set(arg_DESTINATION ${COURSEKIT_SITE_PACKAGES})
  endif()
  install(DIRECTORY "${folder}/" DESTINATION "${arg_DESTINATION}/${name}" PATTERN "__pycache__" EXCLUDE PATTERN "*.pyc" EXCLUDE)
endfunction()

function(ament_python_install_module file)
  install(FILES ${file} DESTINATION ${COURSEKIT_SITE_PACKAGES})
endfunction()

function(ament_get_python_install_dir variable)
  set(${variable} ${COURSEKIT_SITE_PACKAGES} PARENT_SCOPE)
endfunction()
set(PYTHON_INSTALL_DIR ${COURSEKIT_SITE_PACKAGES})
set(PYTHON_EXECUTABLE ${COURSEKIT_PYTHON})
set(Python3_EXECUTABLE ${COURSEKIT_PYTHON})

# -- tests are run by `colcon test`, which reads them from the CMakeLists.txt

foreach(_coursekit_name ament_add_pytest_test ament_add_test ament_add_ros_isolated_pytest_test ament_add_ros_isolated_test
    add_launch_test add_ros_test ament_find_gtest ament_find_gmock
    ament_lint_auto_find_test_dependencies ament_copyright ament_cpplint ament_cppcheck ament_uncrustify ament_lint_cmake
    ament_xmllint ament_flake8 ament_pep257 ament_clang_format ament_clang_tidy)
  cmake_language(EVAL CODE "function(${_coursekit_name})\nendfunction()")
endforeach()

# Tests in C++ are programs, which `colcon test` has built with BUILD_TESTING before it runs them.
function(_coursekit_find_gtest)
  if(NOT CMAKE_CXX_COMPILER MATCHES "zig")
    find_package(GTest CONFIG QUIET GLOBAL)
  endif()
  if(NOT TARGET GTest::gmock AND EXISTS "/usr/src/googletest/CMakeLists.txt" AND NOT TARGET gmock)
    add_subdirectory("/usr/src/googletest" "${CMAKE_BINARY_DIR}/googletest" EXCLUDE_FROM_ALL)
  endif()
  if(NOT TARGET GTest::gmock AND NOT TARGET gmock)
    message(FATAL_ERROR "gtest is not here: sudo apt install libgtest-dev libgmock-dev")
  endif()
endfunction()

macro(_coursekit_add_gtest _coursekit_target _coursekit_kind)
  cmake_parse_arguments(_coursekit_arg "SKIP_LINKING_MAIN_LIBRARIES;SKIP_TEST" "RUNNER;TIMEOUT;WORKING_DIRECTORY"
    "APPEND_ENV;APPEND_LIBRARY_DIRS;ENV" ${ARGN})
  _coursekit_find_gtest()
  add_executable(${_coursekit_target} EXCLUDE_FROM_ALL ${_coursekit_arg_UNPARSED_ARGUMENTS})
  set(_coursekit_space "")
  if(NOT TARGET gmock)
    set(_coursekit_space "GTest::")
  endif()
  set(_coursekit_libraries ${_coursekit_space}${_coursekit_kind})
  if(NOT _coursekit_arg_SKIP_LINKING_MAIN_LIBRARIES)
    list(PREPEND _coursekit_libraries ${_coursekit_space}${_coursekit_kind}_main)
  endif()
  set_property(TARGET ${_coursekit_target} APPEND PROPERTY LINK_LIBRARIES ${_coursekit_libraries})
endmacro()

macro(ament_add_gtest _coursekit_name)
  _coursekit_add_gtest(${_coursekit_name} gtest ${ARGN})
endmacro()

macro(ament_add_gmock _coursekit_name)
  _coursekit_add_gtest(${_coursekit_name} gmock ${ARGN})
endmacro()

macro(ament_add_gtest_executable _coursekit_name)
  _coursekit_add_gtest(${_coursekit_name} gtest ${ARGN})
endmacro()

# Every test here has a graph of its own.
macro(ament_add_ros_isolated_gtest _coursekit_name)
  _coursekit_add_gtest(${_coursekit_name} gtest ${ARGN})
endmacro()

macro(ament_add_ros_isolated_gmock _coursekit_name)
  _coursekit_add_gtest(${_coursekit_name} gmock ${ARGN})
endmacro()

function(ament_add_gtest_test)
endfunction()

# -- the end of every package

macro(ament_package)
  _coursekit_package(${ARGN})
endmacro()

# Files that find_package() of this package reads, too; of those called NAME.in the words between @ are filled in.
function(_coursekit_config_extras variable)
  set(names "")
  foreach(file ${ARGN})
    get_filename_component(name "${file}" NAME)
    if(name MATCHES "\\.in$")
      string(REGEX REPLACE "\\.in$" "" name "${name}")
      configure_file("${file}" "${CMAKE_CURRENT_BINARY_DIR}/${name}" @ONLY)
      set(file "${CMAKE_CURRENT_BINARY_DIR}/${name}")
    endif()
    install(FILES "${file}" DESTINATION share/${PROJECT_NAME}/cmake)
    list(APPEND names "${name}")
  endforeach()
  set(${variable} ${names} PARENT_SCOPE)
endfunction()

function(_coursekit_package)
  cmake_parse_arguments(arg "" "" "CONFIG_EXTRAS;CONFIG_EXTRAS_POST;INSTALL_TO_SHARE" ${ARGN})
  foreach(what DEPENDENCIES INCLUDES LIBRARIES EXPORTS)
    get_property(${what} DIRECTORY "${PROJECT_SOURCE_DIR}" PROPERTY COURSEKIT_${what})
    if(${what})
      list(REMOVE_DUPLICATES ${what})
    endif()
  endforeach()
  foreach(name ${EXPORTS})
    install(EXPORT ${name} DESTINATION share/${PROJECT_NAME}/cmake NAMESPACE ${PROJECT_NAME}:: FILE ${name}Export.cmake)
  endforeach()
  _coursekit_config_extras(EXTRAS ${arg_CONFIG_EXTRAS} ${arg_CONFIG_EXTRAS_POST})
  file(READ "${PROJECT_SOURCE_DIR}/package.xml" version)
  string(REGEX REPLACE ".*<version[^>]*>[ \n\t]*([0-9.]+).*" "\\1" version "${version}")
  set(config "${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}Config")
  configure_file("${COURSEKIT_CMAKE}/package_config.cmake.in" "${config}.cmake" @ONLY)
  write_basic_package_version_file("${config}-version.cmake" VERSION "${version}" COMPATIBILITY AnyNewerVersion ARCH_INDEPENDENT)
  install(FILES "${config}.cmake" "${config}-version.cmake" DESTINATION share/${PROJECT_NAME}/cmake)
  install(FILES package.xml DESTINATION share/${PROJECT_NAME})
  ament_index_register_resource(packages)
  get_property(components DIRECTORY "${PROJECT_SOURCE_DIR}" PROPERTY COURSEKIT_COMPONENTS)
  if(components)
    string(REPLACE "|" ";" components "${components}")
    ament_index_register_resource(rclcpp_components CONTENT "${components}")
  endif()
endfunction()
