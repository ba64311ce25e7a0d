"""Why this computer cannot confine other people's programs, and the commands that change this."""

from __future__ import annotations

from pathlib import Path

from coursekit.files import read_text

RESTRICTED = Path("/proc/sys/kernel/apparmor_restrict_unprivileged_userns")
"""Contains 1 if AppArmor lets only listed programs create namespaces, as on Ubuntu from 23.10 on."""
_PROFILE = "bwrap-userns-restrict"


def cure(complaint: str | None, restricted: Path = RESTRICTED) -> str:
    """Return the fault and the remedy for a result of `sandbox.complaint`; empty if there is no fault.

    >>> cure(None)
    'no bubblewrap. On Debian or Ubuntu: sudo apt install bubblewrap.'
    >>> cure("bwrap: No space left on device", Path("/no/such/file"))
    "no working bubblewrap. It says: 'bwrap: No space left on device'."
    """
    if complaint == "":
        return ""
    if complaint is None:
        return "no bubblewrap. On Debian or Ubuntu: sudo apt install bubblewrap."
    if _is_on(restricted):
        return (
            "no working bubblewrap, because AppArmor keeps it from making namespaces, as on Ubuntu from 23.10 on. Allow it: "
            f"sudo apt install apparmor-profiles; sudo cp /usr/share/apparmor/extra-profiles/{_PROFILE} /etc/apparmor.d/; "
            f"sudo apparmor_parser -r /etc/apparmor.d/{_PROFILE}."
        )
    return f"no working bubblewrap. It says: {complaint!r}."


def _is_on(setting: Path) -> bool:
    try:
        return read_text(setting).strip() == "1"
    except OSError:
        return False


__all__ = ["RESTRICTED", "cure"]
