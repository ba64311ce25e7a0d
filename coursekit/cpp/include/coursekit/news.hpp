// Callbacks that are called as soon as something new has come to an entity, before anybody takes it.
#pragma once
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace coursekit
{
class Entity;

/// What is listened to of an entity: what comes, and of that what stays in the program. Other numbers are its events.
enum NewsKind : int64_t {ITSELF = -1, IN_PROGRAM = -2};

/// The words in which rclcpp speaks of such a callback.
struct NewsWords
{
  const char * setter;
  const char * owner;
  const char * callback;
};

class News
{
public:
  using Callback = std::function<void (size_t)>;
  /// Have `callback` called with how many have come; throws std::invalid_argument for an empty one.
  void tell(Entity & owner, int64_t kind, const NewsWords & words, Callback callback);
  void tell_no_more(Entity & owner, int64_t kind);
  /// The same for the kinds from 0 on, so many, by one callback that is told the kind as well.
  void tell_each(Entity & owner, int kinds, const NewsWords & words, std::function<void (size_t, int)> callback);
  void tell_of_none(Entity & owner, int kinds);

private:
  std::vector<std::pair<int64_t, int64_t>> handlers_;  // by kind
};
}  // namespace coursekit
