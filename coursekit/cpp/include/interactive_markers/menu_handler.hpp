// Menus of interactive markers: entries, and what is called when one is chosen.
#pragma once
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "interactive_markers/interactive_marker_server.hpp"
#include "visualization_msgs/msg/menu_entry.hpp"

namespace interactive_markers
{
class MenuHandler
{
public:
  using EntryHandle = uint32_t;
  using FeedbackConstPtr = visualization_msgs::msg::InteractiveMarkerFeedback::ConstSharedPtr;
  using FeedbackCallback = std::function<void (const FeedbackConstPtr &)>;
  using Message = visualization_msgs::msg::MenuEntry;
  enum CheckState {NO_CHECKBOX, CHECKED, UNCHECKED};

  /// Add an entry to the menu, or below another entry: with a callback, or with a command for who shows the menu.
  EntryHandle insert(const std::string & title, const FeedbackCallback & callback)
  {
    return add(0, {title, "", Message::FEEDBACK, callback});
  }
  EntryHandle insert(
    const std::string & title, const uint8_t command_type = Message::FEEDBACK, const std::string & command = "")
  {
    return add(0, {title, command, command_type, nullptr});
  }
  EntryHandle insert(EntryHandle parent, const std::string & title, const FeedbackCallback & callback)
  {
    return add(known(parent), {title, "", Message::FEEDBACK, callback});
  }
  EntryHandle insert(
    EntryHandle parent, const std::string & title, const uint8_t command_type = Message::FEEDBACK,
    const std::string & command = "")
  {
    return add(known(parent), {title, command, command_type, nullptr});
  }
  /// Each says whether there is such an entry.
  bool setVisible(EntryHandle handle, bool visible)
  {
    return with(handle, [&](Entry & entry) {entry.visible = visible;});
  }
  bool setCheckState(EntryHandle handle, CheckState state)
  {
    return with(handle, [&](Entry & entry) {entry.state = state;});
  }
  bool getCheckState(EntryHandle handle, CheckState & state) const
  {
    auto found = entries_.find(handle);
    state = found == entries_.end() ? NO_CHECKBOX : found->second.state;
    return found != entries_.end();
  }
  bool getTitle(EntryHandle handle, std::string & title) const
  {
    auto found = entries_.find(handle);
    title = found == entries_.end() ? title : found->second.title;
    return found != entries_.end();
  }
  /// Give a marker this menu as it is now; it is sent by the server's applyChanges(). False where there is no such marker.
  bool apply(InteractiveMarkerServer & server, const std::string & marker_name)
  {
    visualization_msgs::msg::InteractiveMarker marker;
    if (!server.get(marker_name, marker)) {
      markers_.erase(marker_name);
      return false;
    }
    marker.menu_entries.clear();
    write(0, marker.menu_entries);
    server.insert(marker);
    server.setCallback(
      marker_name, [this](const FeedbackConstPtr & feedback) {choose(feedback);},
      visualization_msgs::msg::InteractiveMarkerFeedback::MENU_SELECT);
    markers_.insert(marker_name);
    return true;
  }
  /// Again for all markers that have it.
  bool reApply(InteractiveMarkerServer & server)
  {
    bool all = true;
    for (auto & name : std::set<std::string>(markers_)) {
      all = apply(server, name) && all;
    }
    return all;
  }

private:
  struct Entry
  {
    std::string title, command;
    uint8_t command_type;
    FeedbackCallback callback;
    bool visible = true;
    CheckState state = NO_CHECKBOX;
  };

  EntryHandle known(EntryHandle handle) const
  {
    if (!entries_.count(handle)) {
      throw std::invalid_argument("Parent menu entry " + std::to_string(handle) + " not found.");
    }
    return handle;
  }
  EntryHandle add(EntryHandle parent, Entry entry)
  {
    EntryHandle handle = next_++;
    entries_.emplace(handle, std::move(entry));
    below_[parent].push_back(handle);
    return handle;
  }
  template<class F>
  bool with(EntryHandle handle, F change)
  {
    auto found = entries_.find(handle);
    if (found == entries_.end()) {
      return false;
    }
    change(found->second);
    return true;
  }
  void write(EntryHandle parent, std::vector<Message> & messages)
  {
    for (EntryHandle handle : below_[parent]) {
      const Entry & entry = entries_.at(handle);
      if (entry.visible) {
        const char * box = entry.state == CHECKED ? "[x] " : entry.state == UNCHECKED ? "[ ] " : "";
        messages.emplace_back();
        messages.back().set__id(handle).set__parent_id(parent).set__title(box + entry.title);
        messages.back().set__command(entry.command).set__command_type(entry.command_type);
        write(handle, messages);
      }
    }
  }
  void choose(const FeedbackConstPtr & feedback)
  {
    auto found = entries_.find(feedback->menu_entry_id);
    if (found != entries_.end() && found->second.callback) {
      found->second.callback(feedback);
    }
  }

  std::map<EntryHandle, Entry> entries_;
  std::map<EntryHandle, std::vector<EntryHandle>> below_;
  std::set<std::string> markers_;
  EntryHandle next_ = 1;
};
}  // namespace interactive_markers
