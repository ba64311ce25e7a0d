"""Files by their addresses."""

import pytest
import resource_retriever
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

MANIFEST = "package://turtlesim/package.xml"


def test_a_file_of_a_package():
    path = f"{get_package_share_directory('turtlesim')}/package.xml"
    assert resource_retriever.get_filename(MANIFEST, use_protocol=False) == path
    with open(path, "rb") as file:
        assert resource_retriever.get(MANIFEST) == file.read()


def test_a_path_with_a_space(tmp_path):
    file = tmp_path / "my part.stl"
    file.write_bytes(b"solid")
    assert resource_retriever.get(file.as_uri()) == b"solid"


@pytest.mark.parametrize("url", ["file://fail", "file:///no/such/file", "package://turtlesim"])
def test_nothing_can_be_read_there(url):
    with pytest.raises(ValueError, match=url.rpartition("/")[2]):
        resource_retriever.get(url)


def test_an_unknown_package():
    with pytest.raises(PackageNotFoundError):
        resource_retriever.get("package://invalid_package_blah/test.xml")
