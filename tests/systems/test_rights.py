"""What a session leaves for its user's terminals can be read by nobody else, from its first moment on."""

import os
import stat

import pytest

from coursekit.cli import endpoint
from coursekit.systems import operating_system, rights, user_socket
from tests.needs import posix, real_windows

USER = "S-1-5-21-1111-2222-3333-1001"


@pytest.mark.parametrize(
    ("access", "others"),
    [
        (f"D:P(A;OICI;FA;;;SY)(A;OICI;FA;;;BA)(A;OICI;FA;;;{USER})", []),
        (f"D:AI(A;OICIID;FA;;;SY)(A;OICIID;FA;;;BA)(A;OICIID;FA;;;{USER})", []),
        (f"O:{USER}G:BUD:(A;;FA;;;{USER})(A;;FR;;;BU)", ["BU"]),
        ("D:(A;;FA;;;S-1-5-21-1111-2222-3333-1002)(A;;FR;;;WD)", ["S-1-5-21-1111-2222-3333-1002", "WD"]),
        (f"D:(D;;FA;;;WD)(A;;FA;;;{USER})", []),
        (f"D:(XA;;FR;;;AU;(@User.clearance>1))(A;;FA;;;{USER})", ["AU"]),
        ("D:NO_ACCESS_CONTROL", ["everybody"]),
        (f"O:{USER}", ["everybody"]),
        ("D:P", []),
    ],
)
def test_a_list_of_windows_tells_who_else_may_open_a_folder(access, others):
    assert rights.readers(access, USER) == others


@pytest.mark.skipif(not operating_system.WINDOWS, reason="the lists are Windows'")
def test_on_windows_a_folder_is_made_for_this_user_only_and_an_open_one_is_told(tmp_path):
    from coursekit.systems import access_lists

    folder = tmp_path / "José Luis" / "run"
    rights.make_folder(folder)
    assert rights.fault(folder) == "" and access_lists.user() in access_lists.read(folder)
    access_lists.write(folder, "D:P(A;;FA;;;WD)")
    assert rights.fault(folder).endswith("can be opened by others: WD")


@pytest.mark.skipif(not operating_system.WINDOWS, reason="the lists are Windows'")
@real_windows("a file does not take over its folder's list")
def test_on_windows_a_file_in_such_a_folder_is_for_this_user_only(tmp_path):
    rights.make_folder(tmp_path / "run")
    rights.write_text(tmp_path / "run" / "inside", "x")
    assert rights.fault(tmp_path / "run" / "inside") == ""


@posix("modes are its way")
def test_a_file_is_for_this_user_only_before_anything_is_in_it(tmp_path, monkeypatch):
    descriptors = []
    monkeypatch.setattr(
        os, "open", lambda path, *words, real=os.open: descriptors.append(real(path, *words)) or descriptors[-1]
    )
    real_fdopen = os.fdopen
    monkeypatch.setattr(os, "fdopen", lambda number, *words, **named: look(number) and real_fdopen(number, *words, **named))

    def look(number):
        status = os.fstat(number)
        assert (stat.S_IMODE(status.st_mode), status.st_size) == (0o600, 0)
        return True

    before = os.umask(0)
    try:
        rights.write_text(tmp_path / "token", "secret")
        rights.write_text(tmp_path / "token", "another")
    finally:
        os.umask(before)
    assert len(descriptors) == 2 and (tmp_path / "token").read_text(encoding="utf-8") == "another"


@posix("links that somebody else can make are its own")
def test_a_file_is_not_written_through_a_link(tmp_path):
    (tmp_path / "victim").write_text("mine", encoding="utf-8")
    (tmp_path / "token").symlink_to(tmp_path / "victim")
    rights.write_text(tmp_path / "token", "secret")
    assert (tmp_path / "victim").read_text(encoding="utf-8") == "mine"


@posix("modes are its way")
@pytest.mark.parametrize("unix", [True, False])
def test_where_a_session_listens_is_for_this_user_only(tmp_path, monkeypatch, unix):
    monkeypatch.setattr(user_socket, "HAS_UNIX", unix)
    monkeypatch.setattr(endpoint, "folder", lambda: tmp_path)
    monkeypatch.setattr(type(tmp_path), "chmod", lambda *_: None)  # what it is before anybody changes it
    before = os.umask(0)
    try:
        server = endpoint.listen(7)
    finally:
        os.umask(before)
    try:
        for file in tmp_path.iterdir():
            assert file.is_symlink() or stat.S_IMODE(file.stat().st_mode) == 0o600, file
        assert unix or (endpoint.token(7) and endpoint.has_terminals(7))
    finally:
        endpoint.close(server, 7)
    assert list(tmp_path.iterdir()) == []
