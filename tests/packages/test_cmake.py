"""CMakeLists.txt is read as far as files go."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.packages.cmake_beyond import NeedsCMake
from coursekit.packages.cmake_condition import holds
from coursekit.packages.cmake_run import read_project
from coursekit.packages.cmake_text import CMakeError, parse_commands
from coursekit.packages.install_rules import copies


@pytest.fixture
def project(tmp_path):
    """Write files; return what the package installs as {target: source relative to the package}."""

    def read(cmake, *files):
        (tmp_path / "CMakeLists.txt").write_text("project(pkg)\n" + cmake)
        for name in files:
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text("")
        reading = read_project(tmp_path)
        return {c.target: c.source.relative_to(tmp_path).as_posix() for c in copies(reading, "pkg", "site")}

    return read


def test_commands_comments_quotes_and_brackets():
    commands = parse_commands('A(b "c d;e" # x\n  [[f)]]) #[[ g( ]]\nh()')
    assert [(c.name, [a.text for a in c.arguments], c.line) for c in commands] == [
        ("a", ["b", "c d;e", "f)"], 1),
        ("h", [], 3),
    ]


@pytest.mark.parametrize(("text", "line"), [("a(\nb", 1), ("\n)", 2), ("a b", 1), ('a("b)', 1)])
def test_bad_text_names_its_line(text, line):
    with pytest.raises(CMakeError) as caught:
        parse_commands(text)
    assert caught.value.line == line


@given(st.text(alphabet='ab()"#[]=${};\\\n ', max_size=60))
def test_any_text_is_read_or_refused(text):
    try:
        assert isinstance(parse_commands(text), list)
    except CMakeError as error:
        assert error.line >= 1


@pytest.mark.parametrize(
    ("words", "result"),
    [
        ("X", True), ("NOT X", False), ("UNSET", False), ("OFF OR ON", True), ("X AND NOT OFF", True),
        ("X STREQUAL yes", True), ("ANY MATCHES A.Y", True), ("DEFINED X", True), ("DEFINED Y", False),
        ("( X OR OFF ) AND OFF", False), ("3.10 VERSION_LESS 3.9", False), ("TARGET foo", False),
    ],
)  # fmt: skip
def test_conditions(words, result):
    assert holds(words.split(), {"X": "yes"}) is result


def test_variables_lists_loops_and_conditions(project):
    cmake = """
    set(base share/${PROJECT_NAME})
    set(files a.txt)
    list(APPEND files b.txt "c d.txt")
    foreach(file IN LISTS files)
      install(FILES ${file} DESTINATION ${base})
    endforeach()
    if(BUILD_TESTING)
      install(FILES no.txt DESTINATION x)
    elseif(NOT CMAKE_CXX_STANDARD)
      install(FILES e.txt DESTINATION ${base} RENAME f.txt)
    else()
      install(FILES no.txt DESTINATION x)
    endif()
    """
    files = project(cmake, "a.txt", "b.txt", "c d.txt", "e.txt")
    assert list(files) == ["share/pkg/a.txt", "share/pkg/b.txt", "share/pkg/c d.txt", "share/pkg/f.txt"]


def test_directories_with_and_without_a_slash(project):
    cmake = "install(DIRECTORY launch config/ DESTINATION share/pkg)"
    assert project(cmake, "launch/a.py", "config/sub/b.yaml") == {
        "share/pkg/launch/a.py": "launch/a.py",
        "share/pkg/sub/b.yaml": "config/sub/b.yaml",
    }


def test_patterns(project):
    cmake = """
    install(DIRECTORY d DESTINATION x PATTERN "*.bak" EXCLUDE)
    install(DIRECTORY d DESTINATION y FILES_MATCHING PATTERN "*.bak")
    """
    assert sorted(project(cmake, "d/a.txt", "d/a.bak")) == ["x/d/a.txt", "y/d/a.bak"]


def test_globs_subdirectories_and_functions(project, tmp_path):
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "CMakeLists.txt").write_text("install(PROGRAMS run.py DESTINATION lib/${PROJECT_NAME})")
    cmake = """
    function(unused)
      install(FILES nothing DESTINATION x)
    endfunction()
    file(GLOB launches "launch/*.py")
    install(FILES ${launches} DESTINATION share/pkg/launch)
    add_subdirectory(sub)
    """
    assert project(cmake, "launch/a.py", "sub/run.py") == {
        "share/pkg/launch/a.py": "launch/a.py",
        "lib/pkg/run.py": "sub/run.py",
    }


def test_python_packages_go_to_site_packages(project):
    assert project("ament_python_install_package(${PROJECT_NAME})", "pkg/__init__.py", "pkg/a/b.py") == {
        "site/pkg/__init__.py": "pkg/__init__.py",
        "site/pkg/a/b.py": "pkg/a/b.py",
    }


def test_targets_are_remembered_not_built(tmp_path):
    (tmp_path / "CMakeLists.txt").write_text("project(p)\nadd_executable(a a.cpp)\nadd_library(h INTERFACE)\n")
    assert read_project(tmp_path).targets == ["a"]


@pytest.mark.parametrize(
    "cmake",
    [
        "install(FILES nope.txt DESTINATION x)",
        "install(DIRECTORY nope DESTINATION x)",
        "install(FILES CMakeLists.txt)",
        "ament_python_install_package(nope)",
        "add_subdirectory(nope)",
        "if(X)",
        'message(FATAL_ERROR "stop")',
    ],
)
def test_what_cmake_would_refuse_is_refused_with_its_line(project, cmake):
    with pytest.raises(CMakeError) as caught:
        project(cmake)
    assert caught.value.line == 2


def test_what_a_macro_sets_stays_set_and_a_function_has_parent_scope(project):
    cmake = """
        macro(remember name)
          set(kept ${name} ${ARGN})
        endmacro()
        function(choose name)
          set(inside x)
          set(chosen ${name} PARENT_SCOPE)
        endfunction()
        remember(a.txt b.txt)
        choose(c.txt)
        install(FILES ${kept} ${chosen} ${inside} DESTINATION share/pkg)
    """
    assert project(cmake, "a.txt", "b.txt", "c.txt").keys() == {"share/pkg/a.txt", "share/pkg/b.txt", "share/pkg/c.txt"}


def test_return_ends_the_file_or_the_function_from_within_a_block(project):
    cmake = """
        function(leave)
          if(TRUE)
            return()
          endif()
          install(FILES never.txt DESTINATION share/pkg)
        endfunction()
        leave()
        install(FILES a.txt DESTINATION share/pkg)
        foreach(one x y)
          if(one STREQUAL one)
            return()
          endif()
        endforeach()
        install(FILES never.txt DESTINATION share/pkg)
    """
    assert project(cmake, "a.txt", "never.txt").keys() == {"share/pkg/a.txt"}


def test_items_are_removed_from_lists_and_variables_unset(project):
    cmake = """
        set(files a.txt b.txt a.txt)
        list(REMOVE_DUPLICATES files)
        list(REMOVE_ITEM files b.txt)
        set(more b.txt)
        unset(more)
        install(FILES ${files} ${more} DESTINATION share/pkg)
    """
    assert project(cmake, "a.txt", "b.txt").keys() == {"share/pkg/a.txt"}


@pytest.mark.parametrize(
    "command",
    [
        *("string(TOUPPER a b)", "get_filename_component(n a.txt NAME)", "list(SORT files)", "file(READ a.txt text)"),
        *("foreach(i RANGE 3)\nendforeach()", "while(FALSE)\nendwhile()", "configure_file(a.in a)", "include(extra.cmake)"),
    ],
)
def test_what_cannot_be_carried_out_wants_cmake_itself(tmp_path, command):
    (tmp_path / "CMakeLists.txt").write_text(f"project(pkg)\n{command}\n")
    with pytest.raises(NeedsCMake, match=r'CMakeLists.txt:2: .* needs CMake itself, .* pip install "coursekit\[cpp\]"'):
        read_project(tmp_path, strict=True)
    assert read_project(tmp_path).project == "pkg"
