"""What a sandboxed program may do: next to nothing, and less than it tries."""

import json
import os
import sys

import pytest

from coursekit.grade import folders, sandbox
from coursekit.grade.cgroup_limits import confined
from coursekit.grade.unsandboxed import cure
from coursekit.systems import operating_system
from tests.needs import posix

walls = pytest.mark.skipif(sandbox.tier() != "bubblewrap", reason="NOT TESTED: no bubblewrap: apt-get install bubblewrap")


def told(work, code, limits=None, **options):
    """What a program in a sandbox prints, and why it was ended."""
    command, limits = [sys.executable, "-I", "-c", code], limits or sandbox.Limits(seconds=60)
    running = sandbox.start(command, work, os.environ, limits, **options)
    out = running.answer(b"", 1 << 20)
    running.end()
    return out.decode(), running.stopped


@walls
def test_an_installation_below_tmp_is_seen(tmp_path_factory, monkeypatch):
    """A checkout, with its interpreter, may lie in the system's folder for temporary files."""
    installed, work = tmp_path_factory.mktemp("installed"), tmp_path_factory.mktemp("work")
    (installed / "here.txt").write_text("seen")
    own = sandbox._python_folders()
    monkeypatch.setattr(sandbox, "_python_folders", lambda: [*own, str(installed)])
    assert told(work, f"print(open({str(installed / 'here.txt')!r}).read())") == ("seen\n", "")


STATUS = """
import json, os
kept = {}
for line in open("/proc/self/status"):
    name, _, value = line.partition(":")
    kept[name] = value.strip()
print(json.dumps({"uid": os.getuid(), "gid": os.getgid(), "groups": os.getgroups(), **kept}))
"""


@walls
def test_it_has_no_capability_no_name_and_no_way_to_more_rights(tmp_path):
    status = json.loads(told(tmp_path, STATUS)[0])
    assert (status["uid"], status["gid"]) == (65534, 65534)
    assert {status[name] for name in ("CapInh", "CapPrm", "CapEff", "CapBnd", "CapAmb")} == {"0" * 16}
    assert status["NoNewPrivs"] == "1"


REFUSED = """
import ctypes, errno, os
libc = ctypes.CDLL(None, use_errno=True)
def tried(name, *args):
    ctypes.set_errno(0)
    code = getattr(libc, name)(*args)
    print(name, "done" if code == 0 else errno.errorcode[ctypes.get_errno()])
CLONE_NEWUSER, MS_REMOUNT, MS_BIND, MNT_DETACH = 0x10000000, 32, 4096, 2
tried("unshare", CLONE_NEWUSER)
for place in (b"/", CHAPTERS, b"/usr"):
    tried("mount", None, place, None, MS_REMOUNT | MS_BIND, None)
    tried("umount2", place, MNT_DETACH)
tried("mount", b"/tmp", CHAPTERS, None, MS_BIND, None)
tried("chroot", b"/tmp")
tried("setuid", 0)
for place in ("/x", "/usr/x", "/dev/x", os.path.join(os.fsdecode(CHAPTERS), "x"), "/proc/sys/kernel/core_pattern"):
    try:
        os.close(os.open(place, os.O_WRONLY | os.O_CREAT))
        print(place, "done")
    except OSError as error:
        print(place, errno.errorcode[error.errno])
print(os.listdir(CHAPTERS))
"""


@walls
def test_what_would_open_a_way_out_is_refused(tmp_path):
    chapters = os.fsencode(sandbox.PACKAGE / "grade" / "chapters")
    out, _ = told(tmp_path, REFUSED.replace("CHAPTERS", repr(chapters)))
    lines = out.splitlines()
    assert len(lines) == 16 and not [line for line in lines if line.endswith("done")], out
    assert lines[-1] == "[]"


ROOM = """
import os
print(sorted(os.listdir("/")), os.path.exists("/etc/passwd"), os.path.exists(HOME), os.path.exists(NOTEBOOKS))
"""


@walls
def test_it_sees_the_system_and_its_own_folder_only(tmp_path):
    home, notebooks = os.path.expanduser("~/.ssh"), str(sandbox.PACKAGE.parent / "notebooks")
    out, _ = told(tmp_path, ROOM.replace("HOME", repr(home)).replace("NOTEBOOKS", repr(notebooks)))
    assert out.endswith("False False False\n"), out


FILL = """
import os
for folder in ("/tmp", "/dev/shm"):
    total = 0
    try:
        for number in range(64):
            total += open(f"{folder}/{number}", "wb").write(bytes(4 << 20))
    except OSError as error:
        print(folder, total >> 20, error.strerror)
"""


@walls
def test_memory_does_not_hide_in_temporary_files(tmp_path):
    out, _ = told(tmp_path, FILL, sandbox.Limits(seconds=60, scratch=32 << 20))
    lines = [line.split(" ", 2) for line in out.splitlines()]
    assert [(folder, why) for folder, _, why in lines] == [(f, "No space left on device") for f in ("/tmp", "/dev/shm")]
    assert all(int(megabytes) <= 32 for _, megabytes, _ in lines)


@walls
def test_a_folder_that_is_only_read_cannot_be_written(tmp_path):
    (tmp_path / "mine").write_text("mine")
    code = "print(open('mine').read())\nopen('mine', 'w')"
    assert told(tmp_path, code, writable=False)[0] == "mine\n"
    assert (tmp_path / "mine").read_text() == "mine"


DEEP = "import os\nfor _ in range(1500):\n    os.mkdir('d')\n    os.chdir('d')\nimport time\ntime.sleep(60)"
SPARSE = "import os, time\nfor n in range(9):\n    os.truncate(os.open(str(n), 577), 60 << 20)\ntime.sleep(60)"
MANY = "import time\nfor n in range(60_000):\n    open(str(n), 'w').close()\ntime.sleep(60)"


@posix("nothing of a student's runs there outside of a container")
@pytest.mark.parametrize(
    ("code", "why"),
    [(DEEP, "folders in folders"), (SPARSE, "MB of files"), (MANY, "more than 50000 files")],
    ids=["deep", "sparse", "many"],
)
def test_folders_that_cannot_be_measured_by_paths_are_measured(tmp_path, code, why):
    assert why in told(tmp_path, code)[1]
    folders.remove(tmp_path)
    assert not tmp_path.exists()


def test_what_cannot_be_watched_is_ended(tmp_path, monkeypatch):
    def broken(_pid):
        raise OSError("no /proc")

    monkeypatch.setattr(sandbox, "_family", broken)
    assert told(tmp_path, "import time\ntime.sleep(60)")[1] == "it could not be watched: OSError"


def test_bubblewrap_is_never_what_lies_on_the_path(tmp_path, monkeypatch):
    (tmp_path / "bwrap").write_text("#!/bin/sh\ntouch taken\n")
    (tmp_path / "bwrap").chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.environ['PATH']}")
    assert sandbox._bwrap() in (None, *sandbox._BWRAP)


@pytest.mark.parametrize("system", ["WINDOWS", "MAC"])
def test_bubblewrap_is_not_looked_for_where_there_is_none(monkeypatch, system):
    monkeypatch.setattr(sandbox, "_BWRAP", (sys.executable,))
    assert sandbox._bwrap() == (None if operating_system.WINDOWS or operating_system.MAC else sys.executable)
    monkeypatch.setattr(operating_system, system, True)
    assert sandbox._bwrap() is None


@pytest.mark.parametrize(
    ("tier", "uid", "options", "why"),
    [
        ("bubblewrap", 1000, {}, ""),
        ("bubblewrap", 0, {}, "--allow-root"),
        ("bubblewrap", 0, {"allow_root": True}, ""),
        ("limits", 1000, {}, "--unsafe"),
        ("limits", 1000, {"unsafe": True}, ""),
        ("limits", 0, {"unsafe": True}, "--allow-root"),
    ],
)
def test_other_people_s_work_runs_only_behind_walls(monkeypatch, tier, uid, options, why):
    monkeypatch.setattr(sandbox, "tier", lambda: tier)
    monkeypatch.setattr(os, "geteuid", lambda: uid, raising=False)
    refusal = sandbox.refusal(**options)
    assert (why in refusal) if why else not refusal


@posix("bubblewrap is Linux'")
def test_a_bubblewrap_that_fails_is_not_to_be_installed_once_more(monkeypatch, tmp_path):
    """Ubuntu has it, and lets it do nothing: the words are about that."""
    broken, setting = tmp_path / "bwrap", tmp_path / "restricted"
    broken.write_text("#!/bin/sh\necho 'bwrap: setting up uid map: Permission denied' >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setattr(sandbox, "_bwrap", lambda: str(broken))
    sandbox.complaint.cache_clear()
    try:
        assert sandbox.tier() == "limits"
        assert "'bwrap: setting up uid map: Permission denied'" in cure(sandbox.complaint(), setting)
        setting.write_text("1\n")
        assert "sudo apparmor_parser -r" in cure(sandbox.complaint(), setting)
        assert "apt install bubblewrap" not in sandbox.refusal()
    finally:
        sandbox.complaint.cache_clear()


def test_control_groups_are_used_where_the_system_lends_them(monkeypatch):
    monkeypatch.setattr("coursekit.grade.cgroup_limits._works", lambda: True)
    words = confined(1 << 30, 100)
    assert words[0] == "/usr/bin/systemd-run" and words[-1] == "--"
    assert {"MemoryMax=1073741824", "MemorySwapMax=0", "TasksMax=100"} <= set(words)
    monkeypatch.setattr("coursekit.grade.cgroup_limits._works", lambda: False)
    assert confined(1 << 30, 100) == []


@posix("nothing of a student's runs there outside of a container")
def test_without_walls_its_temporary_files_are_its_own(tmp_path):
    """numba unpickles what it has compiled: never from a folder in which others may write."""
    code = "import os; e = os.environ; print(e['TMPDIR'], e['NUMBA_CACHE_DIR'], os.stat(e['TMPDIR']).st_mode & 0o77)"
    running = sandbox.start([sys.executable, "-c", code], tmp_path, {}, sandbox.Limits(tier="limits"), writable=False)
    scratch, numba, rights = running.answer(b"", 1000).decode().split()
    running.end()
    assert scratch != "/tmp" and numba == f"{scratch}/.numba" and rights == "0" and not os.path.exists(scratch)
