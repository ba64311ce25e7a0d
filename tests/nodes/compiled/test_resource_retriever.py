"""Files by their addresses, in C++: the same as in Python."""

import resource_retriever

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

MANIFEST = "package://turtlesim/package.xml"
PROGRAM = """
#include <iostream>
#include <resource_retriever/retriever.hpp>
int main(int, char ** argv)
{
  resource_retriever::Retriever retriever;
  for (char ** url = argv + 1; *url; ++url) {
    try {
      resource_retriever::MemoryResource resource = retriever.get(*url);
      std::cout << resource.size << " " << (resource.data ? static_cast<char>(*resource.data) : '-') << std::endl;
    } catch (const resource_retriever::Exception & error) {
      std::cout << error.what() << std::endl;
    }
  }
}
"""


def test_the_content_or_why_there_is_none(build, tmp_path):
    part, empty = tmp_path / "my part.stl", tmp_path / "empty"
    part.write_bytes(b"solid")
    empty.write_bytes(b"")
    urls = [part.as_uri(), empty.as_uri(), MANIFEST]
    urls += ["package://turtlesim", "package:///x", "package://moon/x", "http://x/y", "file:///x"]
    with (session := Session(virtual=True)).use():
        process = session.launch(make_process(session, build("resources", PROGRAM), urls, name="resources"))
        assert process.wait(20.0) == 0
    size = len(resource_retriever.get(MANIFEST))
    assert process.output.splitlines() == [
        "5 s", "0 -", f"{size} <",
        "Error retrieving file [package://turtlesim]: Could not parse package:// format into file:// format",
        "Error retrieving file [package:///x]: Package name must not be empty",
        "Error retrieving file [package://moon/x]: Package [moon] does not exist",
        "Error retrieving file [http://x/y]: Only package://NAME/PATH and file:///PATH are read here: "
        "download it to a file first",
        "Error retrieving file [file:///x]: Couldn't open file /x",
    ]  # fmt: skip
