"""Menus of interactive markers: entries, boxes to check, and the functions that are called for them."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from visualization_msgs.msg import InteractiveMarkerFeedback, MenuEntry

if TYPE_CHECKING:
    from .interactive_marker_server import InteractiveMarkerServer

Callback = Callable[[InteractiveMarkerFeedback], object]
_NO_CHECKBOX, _CHECKED, _UNCHECKED = range(3)
_BOXES = {_NO_CHECKBOX: "", _CHECKED: "[x] ", _UNCHECKED: "[ ] "}


@dataclass
class EntryContext:
    """An entry of a menu."""

    title: str
    command: str = ""
    command_type: int = MenuEntry.FEEDBACK
    feedback_cb: Callback | None = None
    sub_entries: list[int] = field(default_factory=list)
    visible: bool = True
    check_state: int = _NO_CHECKBOX


class MenuHandler:
    """A menu for one or many markers; entries are known by the numbers that `insert` returns."""

    NO_CHECKBOX = _NO_CHECKBOX
    CHECKED = _CHECKED
    UNCHECKED = _UNCHECKED

    def __init__(self) -> None:
        self.top_level_handles_: list[int] = []
        self.entry_contexts_: dict[int, EntryContext] = {}
        self.current_handle_ = 1
        self.managed_markers_: set[str] = set()

    def insert(
        self,
        title: str,
        parent: int | None = None,
        command_type: int = MenuEntry.FEEDBACK,
        command: str = "",
        callback: Callback | None = None,
    ) -> int | None:
        """Add an entry, below another if `parent` is given; None if there is no such parent."""
        handle = self.doInsert(title, command_type, command, callback)
        if parent is None:
            self.top_level_handles_.append(handle)
        elif parent in self.entry_contexts_:
            self.entry_contexts_[parent].sub_entries.append(handle)
        else:
            print(f"Parent menu entry {parent} not found.", file=sys.stderr)
            return None
        return handle

    def setVisible(self, handle: int, visible: bool) -> bool:
        """Show or hide an entry and those below it; False for an unknown one."""
        if handle not in self.entry_contexts_:
            return False
        self.entry_contexts_[handle].visible = visible
        return True

    def setCheckState(self, handle: int, check_state: int) -> bool:
        """Check or uncheck an entry's box, or take it away; False for an unknown one."""
        if handle not in self.entry_contexts_:
            return False
        self.entry_contexts_[handle].check_state = check_state
        return True

    def getCheckState(self, handle: int) -> int | None:
        """Return the state of an entry's box; None for an unknown one."""
        return self.entry_contexts_[handle].check_state if handle in self.entry_contexts_ else None

    def getTitle(self, handle: int) -> str | None:
        """Return an entry's title; None for an unknown one."""
        return self.entry_contexts_[handle].title if handle in self.entry_contexts_ else None

    def apply(self, server: InteractiveMarkerServer, marker_name: str) -> bool:
        """Give a marker this menu as it is now; False for an unknown marker. `server.applyChanges()` shows it."""
        marker = server.get(marker_name)
        if marker is None:
            self.managed_markers_.discard(marker_name)
            return False
        entries: list[MenuEntry] = []
        self.pushMenuEntries(self.top_level_handles_, entries, 0)
        marker.menu_entries = entries
        server.insert(marker, feedback_callback=self.processFeedback, feedback_type=InteractiveMarkerFeedback.MENU_SELECT)
        self.managed_markers_.add(marker_name)
        return True

    def reApply(self, server: InteractiveMarkerServer) -> bool:
        """Give the changed menu to all markers that have it."""
        done = [self.apply(server, name) for name in list(self.managed_markers_)]
        return all(done)

    def processFeedback(self, feedback: InteractiveMarkerFeedback) -> None:
        """Call the function of the entry that was chosen."""
        context = self.entry_contexts_.get(feedback.menu_entry_id)
        if context is not None and context.feedback_cb is not None:
            context.feedback_cb(feedback)

    def pushMenuEntries(self, handles_in: list[int], entries_out: list[MenuEntry], parent_handle: int) -> bool:
        """Append the visible entries and all that lies below them."""
        for handle in handles_in:
            context = self.entry_contexts_[handle]
            if context.visible:
                entries_out.append(self.makeEntry(context, handle, parent_handle))
                self.pushMenuEntries(context.sub_entries, entries_out, handle)
        return True

    def makeEntry(self, context: EntryContext, handle: int, parent_handle: int) -> MenuEntry:
        """Return an entry as a message."""
        return MenuEntry(
            id=handle,
            parent_id=parent_handle,
            title=_BOXES.get(context.check_state, "") + context.title,
            command=context.command,
            command_type=context.command_type,
        )

    def doInsert(self, title: str, command_type: int, command: str, feedback_cb: Callback | None) -> int:
        """Make an entry that is in no menu yet."""
        handle = self.current_handle_
        self.current_handle_ += 1
        self.entry_contexts_[handle] = EntryContext(title, command, command_type, feedback_cb)
        return handle
