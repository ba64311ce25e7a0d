// What the nodes of a tree tell each other, and how subtrees share it.
#include "behaviortree_cpp_v3/blackboard.h"

#include <utility>

namespace BT
{
Blackboard::Ptr Blackboard::owner(std::string & key) const
{
  auto found = remapped_.find(key);
  Ptr parent = found == remapped_.end() ? nullptr : parent_.lock();
  if (parent) {
    key = found->second;
  }
  return parent;
}
const Any * Blackboard::getAny(const std::string & key) const
{
  std::unique_lock<std::mutex> hold(mutex_);
  std::string theirs = key;
  if (Ptr parent = owner(theirs)) {
    return static_cast<const Blackboard &>(*parent).getAny(theirs);
  }
  auto found = entries_.find(key);
  return found == entries_.end() ? nullptr : &found->second.value;
}
Any * Blackboard::getAny(const std::string & key)
{
  return const_cast<Any *>(static_cast<const Blackboard &>(*this).getAny(key));
}
void Blackboard::put(const std::string & key, Any value, const std::type_info & type, const Parse & parse)
{
  std::unique_lock<std::mutex> hold_entry(entry_mutex_), hold(mutex_);
  std::string theirs = key;
  if (Ptr parent = owner(theirs)) {
    return parent->put(theirs, std::move(value), type, parse);
  }
  auto found = entries_.find(key);
  changed_.insert(key);
  if (found == entries_.end()) {
    entries_.emplace(key, Entry{std::move(value), PortInfo()});
    return;
  }
  const std::type_info * declared = found->second.port.type();
  if (declared && *declared != type && *declared != value.type()) {
    value = parse(found->second.port);
    if (value.empty()) {
      hold.unlock();
      debugMessage();
      throw LogicError(
              "Blackboard::set() failed: once declared, the type of a port shall not change. Declared type [",
              demangle(declared), "] != current type [", demangle(type), "]");
    }
  }
  found->second.value = std::move(value);
}
std::set<std::string> Blackboard::take_changed()
{
  std::unique_lock<std::mutex> hold(mutex_);
  return std::exchange(changed_, {});
}
void Blackboard::setPortInfo(const std::string & key, const PortInfo & info)
{
  std::unique_lock<std::mutex> hold(mutex_);
  std::string theirs = key;
  if (Ptr parent = owner(theirs)) {
    return parent->setPortInfo(theirs, info);
  }
  auto entered = entries_.emplace(key, Entry{{}, info});
  const std::type_info * before = entered.first->second.port.type();
  if (!entered.second && before && info.type() && *before != *info.type()) {
    throw LogicError(
            "Blackboard::set() failed: once declared, the type of a port shall not change. Declared type [",
            demangle(before), "] != current type [", demangle(info.type()), "]");
  }
}
const PortInfo * Blackboard::portInfo(const std::string & key)
{
  std::unique_lock<std::mutex> hold(mutex_);
  std::string theirs = key;
  if (Ptr parent = owner(theirs)) {
    return parent->portInfo(theirs);
  }
  auto found = entries_.find(key);
  return found == entries_.end() ? nullptr : &found->second.port;
}
void Blackboard::addSubtreeRemapping(StringView internal, StringView external) {remapped_.emplace(internal, external);}

void Blackboard::debugMessage() const
{
  for (auto & entry : entries_) {
    const Any & value = entry.second.value;
    const std::type_info * declared = entry.second.port.type();
    std::cout << entry.first << " (" << demangle(declared ? *declared : value.type()) << ") -> " <<
      (value.empty() ? "empty" : "full") << std::endl;
  }
  for (auto & one : remapped_) {
    std::cout << one.first << " -> remapped to parent [" << one.second << "]" << std::endl;
  }
}
std::vector<StringView> Blackboard::getKeys() const
{
  std::vector<StringView> keys;
  for (auto & entry : entries_) {
    keys.push_back(entry.first);
  }
  return keys;
}
void Blackboard::clear()
{
  std::unique_lock<std::mutex> hold(mutex_);
  entries_.clear();
  remapped_.clear();
}
}  // namespace BT
