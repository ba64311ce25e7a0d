"""Files of a new ament_cmake or cmake package."""

from __future__ import annotations

from coursekit.packages.package_settings import PackageSettings

_TESTING = """\
if(BUILD_TESTING)
  find_package(ament_lint_auto REQUIRED)
  # take this line away once every source file starts with a copyright notice
  set(ament_cmake_copyright_FOUND TRUE)
  # take this line away once the package is in a git repository
  set(ament_cmake_cpplint_FOUND TRUE)
  ament_lint_auto_find_test_dependencies()
endif()
"""

_WARNINGS = """\
if(CMAKE_COMPILER_IS_GNUCXX OR CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_compile_options(-Wall -Wextra -Wpedantic)
endif()
"""


def cmake_lists(recipe: PackageSettings) -> str:
    """Return the text of CMakeLists.txt."""
    ament = recipe.build_type == "ament_cmake"
    parts = [f"cmake_minimum_required(VERSION 3.8)\nproject({recipe.name})\n", _WARNINGS, _find(recipe)]
    parts += [_library(recipe)] if recipe.library_name else []
    parts += [_node(recipe)] if recipe.node_name else []
    if ament:
        exports = "ament_export_include_directories(include)\n" if recipe.library_name else ""
        exports += f"ament_export_targets(export_{recipe.name})\n" if recipe.library_name else ""
        parts += [_TESTING, exports + "ament_package()\n"]
    return "\n".join(parts)


def _find(recipe: PackageSettings) -> str:
    ament = ["ament_cmake", *(["ament_cmake_ros"] if recipe.library_name else [])]
    names = [*(ament if recipe.build_type == "ament_cmake" else []), *recipe.dependencies]
    lines = ["# find dependencies", *(f"find_package({name} REQUIRED)" for name in names)]
    if not recipe.dependencies:
        lines += ["# add the packages that this one needs, such as", "# find_package(<dependency> REQUIRED)"]
    return "\n".join([*lines, ""])


def _uses(target: str, recipe: PackageSettings) -> str:
    if not recipe.dependencies:
        return ""
    if recipe.build_type == "cmake":
        return ""
    names = "".join(f'\n  "{name}"' for name in recipe.dependencies)
    return f"ament_target_dependencies(\n  {target}{names}\n)\n"


def _library(recipe: PackageSettings) -> str:
    name, package = recipe.library_name, recipe.name
    return (
        f"add_library({name} src/{name}.cpp)\n"
        f"target_compile_features({name} PUBLIC c_std_99 cxx_std_17)\n"
        f"target_include_directories({name} PUBLIC\n"
        "  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>\n"
        "  $<INSTALL_INTERFACE:include>)\n"
        f"{_uses(str(name), recipe)}"
        "# on Windows the library exports what it defines and imports the rest\n"
        f'target_compile_definitions({name} PRIVATE "{package.upper()}_BUILDING_LIBRARY")\n\n'
        "install(\n  DIRECTORY include/\n  DESTINATION include\n)\n"
        f"install(\n  TARGETS {name}\n  EXPORT export_${{PROJECT_NAME}}\n"
        "  ARCHIVE DESTINATION lib\n  LIBRARY DESTINATION lib\n  RUNTIME DESTINATION bin\n)\n"
    )


def _node(recipe: PackageSettings) -> str:
    name = recipe.node_name
    link = f"target_link_libraries({name} {recipe.library_name})\n" if recipe.library_name else ""
    return (
        f"add_executable({name} src/{name}.cpp)\n"
        f"target_compile_features({name} PUBLIC c_std_99 cxx_std_17)\n"
        f"{_uses(str(name), recipe)}{link}\n"
        f"install(TARGETS {name}\n  DESTINATION lib/${{PROJECT_NAME}})\n"
    )


def node_cpp(recipe: PackageSettings) -> str:
    """Return the text of the executable's source.

    >>> settings = PackageSettings("robot", "", "MIT", "Ada", "ada@example.com", "ament_cmake")
    >>> 'printf("hello world robot package' in node_cpp(settings)
    True
    """
    return (
        "#include <cstdio>\n\nint main(int argc, char ** argv)\n{\n  (void) argc;\n  (void) argv;\n\n"
        f'  printf("hello world {recipe.name} package\\n");\n  return 0;\n}}\n'
    )


def _class_name(recipe: PackageSettings) -> str:
    return "".join(part.capitalize() for part in str(recipe.library_name).split("_"))


def library_hpp(recipe: PackageSettings) -> str:
    """Return the text of the library's header."""
    name, package, cls = recipe.library_name, recipe.name, _class_name(recipe)
    guard = f"{package.upper()}__{str(name).upper()}_HPP_"
    return (
        f'#ifndef {guard}\n#define {guard}\n\n#include "{package}/visibility_control.h"\n\n'
        f"namespace {package}\n{{\n\nclass {cls}\n{{\npublic:\n  {cls}();\n\n  virtual ~{cls}();\n}};\n\n"
        f"}}  // namespace {package}\n\n#endif  // {guard}\n"
    )


def library_cpp(recipe: PackageSettings) -> str:
    """Return the text of the library's source."""
    name, package, cls = recipe.library_name, recipe.name, _class_name(recipe)
    return (
        f'#include "{package}/{name}.hpp"\n\nnamespace {package}\n{{\n\n'
        f"{cls}::{cls}()\n{{\n}}\n\n{cls}::~{cls}()\n{{\n}}\n\n}}  // namespace {package}\n"
    )


def visibility_h(recipe: PackageSettings) -> str:
    """Return the text of the header that defines the exported symbols of the library."""
    upper = recipe.name.upper()
    guard = f"{upper}__VISIBILITY_CONTROL_H_"
    return (
        f"#ifndef {guard}\n#define {guard}\n\n"
        "#if defined _WIN32 || defined __CYGWIN__\n"
        f"  #ifdef {upper}_BUILDING_LIBRARY\n    #define {upper}_PUBLIC __declspec(dllexport)\n"
        f"  #else\n    #define {upper}_PUBLIC __declspec(dllimport)\n  #endif\n  #define {upper}_LOCAL\n"
        f'#else\n  #define {upper}_PUBLIC __attribute__ ((visibility("default")))\n'
        f'  #define {upper}_LOCAL  __attribute__ ((visibility("hidden")))\n#endif\n\n#endif  // {guard}\n'
    )


def config_in(recipe: PackageSettings) -> str:
    """Return the text of <package>Config.cmake.in of a plain CMake package."""
    lines = ["@PACKAGE_INIT@", ""]
    if recipe.library_name:
        lines += [f'set({recipe.name}_LIBRARIES "{recipe.library_name}")']
        lines += [f'set_and_check({recipe.name}_INCLUDE_DIR "@PACKAGE_INCLUDE_INSTALL_DIR@")']
    return "\n".join([*lines, f"check_required_components({recipe.name})", ""])


def version_in(recipe: PackageSettings) -> str:
    """Return the text of <package>ConfigVersion.cmake.in of a plain CMake package."""
    return f'set(PACKAGE_VERSION "@{recipe.name}_VERSION@")\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n'
