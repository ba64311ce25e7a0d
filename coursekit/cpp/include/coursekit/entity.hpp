// What has a number at the session and, mostly, a handler here: a publisher, a timer, an executor, ...
#pragma once
#include "coursekit/link.hpp"
#include "coursekit/news.hpp"

namespace coursekit
{
class Entity
{
public:
  Entity() = default;
  Entity(const Entity &) = delete;
  Entity & operator=(const Entity &) = delete;
  virtual ~Entity()
  {
    if (id) {
      note("drop", Packer{}.i(id));
    }
    for (int64_t handler : handlers) {
      remove_handler(handler);
    }
  }
  /// Make a handler that goes with this entity; its number.
  int64_t handle(Handler handler)
  {
    handlers.push_back(add_handler(std::move(handler)));
    return handlers.back();
  }

  int64_t id = 0;
  std::string name;
  std::vector<int64_t> handlers;
  News news;
};
}  // namespace coursekit
