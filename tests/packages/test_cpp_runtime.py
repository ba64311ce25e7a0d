"""The runtime of C++ programs is built once, whoever asks for it meanwhile; what CMake learned of the compiler is kept."""

from __future__ import annotations

import threading

import pytest

from coursekit.cpp import runtime
from tests.needs import compiler_or_skip
from tests.packages.test_cpp_libraries import lay_out
from tests.packages.test_cpp_workspace import colcon

HELLO = """
add_executable(hello src/hello.cpp)
install(TARGETS hello DESTINATION lib/${PROJECT_NAME})
ament_package()
"""


def test_who_asks_while_it_is_built_waits_for_it(tmp_path, monkeypatch):
    built, second_asks = [], threading.Event()

    def build(folder, *_):
        assert second_asks.wait(10.0)
        built.append(folder)

    for name in ("write_headers", "_write_configs", "write_forwarded"):
        monkeypatch.setattr(runtime, name, lambda folder, *_: folder.mkdir(parents=True, exist_ok=True))
    monkeypatch.setattr(runtime, "_build_library", build)
    folder = tmp_path / "cpp" / "key"
    first = threading.Thread(target=runtime.make_runtime, args=(folder, None))
    first.start()
    second_asks.set()
    runtime.make_runtime(folder, None)
    first.join()
    assert folder.is_dir() and len(built) == 1
    assert [path.name for path in folder.parent.iterdir() if path.name.startswith(".making")] == []


@pytest.fixture
def configured(tmp_path):
    """configured("-DX=y") builds a package and returns what CMake said."""
    compiler_or_skip()
    lay_out(tmp_path, "k_hello", HELLO, {"src/hello.cpp": "int main() {}\n"}, ())

    def build(*words):
        done = colcon(tmp_path, "build", "--cmake-clean-cache", "--cmake-args", "-DCMAKE_BUILD_TYPE=", *words)
        assert done.returncode == 0, done.stdout + done.stderr
        return (tmp_path / "log" / "latest_build" / "k_hello" / "stdout_stderr.log").read_text()

    return build


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_the_compiler_is_examined_with_the_runtime_and_not_again_by_each_package(configured):
    assert "-- Configuring done" in configured() and "Detecting CXX compiler ABI info" not in configured()


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_a_compiler_of_the_user_s_choice_is_examined(configured, tmp_path):
    other = tmp_path / "my_g++"
    other.symlink_to(compiler_or_skip().cxx[0])
    said = configured(f"-DCMAKE_CXX_COMPILER={other}")
    assert f"Check for working CXX compiler: {other}" in said
