// The inboxes of this program's subscriptions for messages that stay in it.
#include "rclcpp/intra_process.hpp"

#include <algorithm>

namespace rclcpp::intra_process
{
namespace
{
struct Known
{
  std::mutex lock;
  std::vector<std::weak_ptr<Inbox>> all;
};
Known & known()
{
  static Known * inboxes = new Known;  // never destroyed: global nodes may still publish
  return *inboxes;
}
size_t hash_of(const std::string & bytes) {return std::hash<std::string_view>()(bytes);}
}  // namespace

void Inbox::keep(const std::string & bytes, std::shared_ptr<void> box)
{
  std::lock_guard<std::mutex> hold(lock_);
  kept_.push_back({hash_of(bytes), std::move(box)});
  if (kept_.size() > depth_) {
    kept_.pop_front();  // as the oldest message leaves a queue that is full
  }
}
std::shared_ptr<void> Inbox::take(const std::string & bytes)
{
  size_t hash = hash_of(bytes);
  std::lock_guard<std::mutex> hold(lock_);
  auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept & one) {return one.hash == hash;});
  if (found == kept_.end()) {
    return nullptr;
  }
  std::shared_ptr<void> box = std::move(found->box);
  kept_.erase(kept_.begin(), found + 1);
  return box;
}
void enter(const std::shared_ptr<Inbox> & inbox)
{
  std::lock_guard<std::mutex> hold(known().lock);
  auto & all = known().all;
  all.erase(std::remove_if(all.begin(), all.end(), [](auto & one) {return one.expired();}), all.end());
  all.push_back(inbox);
}
std::vector<std::shared_ptr<Inbox>> inboxes(const std::string & topic, const std::type_info & type)
{
  std::lock_guard<std::mutex> hold(known().lock);
  std::vector<std::shared_ptr<Inbox>> found;
  for (auto & one : known().all) {
    auto inbox = one.lock();
    if (inbox && inbox->topic == topic && inbox->type == type) {
      found.push_back(inbox);
    }
  }
  return found;
}
}  // namespace rclcpp::intra_process
