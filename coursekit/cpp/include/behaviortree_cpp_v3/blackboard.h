// What the nodes of a tree tell each other.
#pragma once
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "behaviortree_cpp_v3/basic_types.h"

namespace BT
{
class Blackboard
{
public:
  using Ptr = std::shared_ptr<Blackboard>;

  /// That of a subtree has its tree's as its parent.
  static Ptr create(Ptr parent = {}) {return Ptr(new Blackboard(parent));}
  virtual ~Blackboard() = default;

  /// nullptr where nothing was declared or set.
  const Any * getAny(const std::string & key) const;
  Any * getAny(const std::string & key);

  /// Throws std::runtime_error where it is of another type.
  template<class T>
  bool get(const std::string & key, T & value) const
  {
    const Any * found = getAny(key);
    if (found) {
      value = found->cast<T>();
    }
    return found;
  }
  template<class T>
  T get(const std::string & key) const
  {
    const Any * found = getAny(key);
    return found ? found->cast<T>() : throw RuntimeError("Blackboard::get() error. Missing key [", key, "]");
  }
  /// Throws LogicError where a port declared another type.
  template<class T>
  void set(const std::string & key, const T & value)
  {
    put(key, Any(value), typeid(T), [&value](const PortInfo & port) {return port.parseString(value);});
  }

  void setPortInfo(const std::string & key, const PortInfo & info);
  const PortInfo * portInfo(const std::string & key);
  /// A key here is another one of the parent.
  void addSubtreeRemapping(StringView internal, StringView external);
  void debugMessage() const;
  std::vector<StringView> getKeys() const;
  void clear();
  /// The keys that were set since the last call, for who keeps a copy.
  std::set<std::string> take_changed();
  /// Whoever uses what getAny() returned holds it meanwhile.
  std::mutex & entryMutex() {return entry_mutex_;}

protected:
  explicit Blackboard(Ptr parent)
  : parent_(parent) {}

private:
  struct Entry
  {
    Any value;
    PortInfo port;
  };
  using Parse = std::function<Any (const PortInfo &)>;

  void put(const std::string & key, Any value, const std::type_info & type, const Parse & parse);
  /// The parent if it has the key, which is then that of the parent.
  Ptr owner(std::string & key) const;

  mutable std::mutex mutex_;
  std::mutex entry_mutex_;
  std::unordered_map<std::string, Entry> entries_;
  std::set<std::string> changed_;
  std::weak_ptr<Blackboard> parent_;
  std::unordered_map<std::string, std::string> remapped_;
};
}  // namespace BT
