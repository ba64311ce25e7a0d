# ament_cmake_python: Python packages beside C++.

include_guard(GLOBAL)

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

