// Messages that stay in the program: a subscription gets the very object that was published, where nodes ask for that.
//
// The bytes travel through the session all the same, and with them the order and the queues. When they arrive the object
// that was kept for them takes the place of a copy that would be made of them.
#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

namespace rclcpp::intra_process
{
/// What a subscription has been given and has not heard yet.
class Inbox
{
public:
  /// `owns` tells that it takes messages as its own: boxes then hold a unique_ptr<M>, else a shared_ptr<const M>.
  Inbox(std::string topic_, const std::type_info & type_, bool owns_, size_t depth)
  : topic(std::move(topic_)), type(type_), owns(owns_), depth_(depth) {}
  void keep(const std::string & bytes, std::shared_ptr<void> box);
  /// The object of these bytes; null where it was not kept. What was kept before it will not come any more.
  std::shared_ptr<void> take(const std::string & bytes);
  const std::string topic;
  const std::type_info & type;
  const bool owns;

private:
  struct Kept
  {
    size_t hash;
    std::shared_ptr<void> box;
  };
  size_t depth_;
  std::mutex lock_;
  std::deque<Kept> kept_;
};

/// Enter an inbox for as long as somebody holds it.
void enter(const std::shared_ptr<Inbox> & inbox);
/// The inboxes of a topic for objects of a type.
std::vector<std::shared_ptr<Inbox>> inboxes(const std::string & topic, const std::type_info & type);

/// Give an object to all inboxes of its topic: the last that wants it as its own gets it, the others get copies.
template<class M>
void give(const std::string & topic, std::unique_ptr<M> message, const std::string & bytes)
{
  std::vector<std::shared_ptr<Inbox>> owners, sharers;
  for (auto & inbox : inboxes(topic, typeid(M))) {
    (inbox->owns ? owners : sharers).push_back(inbox);
  }
  if (owners.empty()) {
    std::shared_ptr<const M> shared(std::move(message));
    for (auto & inbox : sharers) {
      inbox->keep(bytes, std::make_shared<std::shared_ptr<const M>>(shared));
    }
    return;
  }
  if constexpr (std::is_copy_constructible_v<M>) {
    if (!sharers.empty()) {
      auto shared = std::make_shared<const M>(*message);
      for (auto & inbox : sharers) {
        inbox->keep(bytes, std::make_shared<std::shared_ptr<const M>>(shared));
      }
    }
    for (size_t i = 0; i + 1 < owners.size(); ++i) {
      owners[i]->keep(bytes, std::make_shared<std::unique_ptr<M>>(std::make_unique<M>(*message)));
    }
  }
  owners.back()->keep(bytes, std::make_shared<std::unique_ptr<M>>(std::move(message)));
}
}  // namespace rclcpp::intra_process
