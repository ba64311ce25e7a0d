// Action servers: the session's, whose decisions and work are this program's callbacks.
#pragma once
#include "rclcpp_action/server_goal_handle.hpp"

namespace rclcpp_action
{
enum class GoalResponse : int8_t {REJECT = 1, ACCEPT_AND_EXECUTE = 2, ACCEPT_AND_DEFER = 3};
enum class CancelResponse : int8_t {REJECT = 1, ACCEPT = 2};

class ServerBase : public coursekit::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServerBase)
  enum class EntityType : size_t {GoalService, ResultService, CancelService};

  /// Have a function called with how many have come of what, a number of EntityType, as soon as they have.
  void set_on_ready_callback(std::function<void (size_t, int)> callback)
  {
    news.tell_each(*this, 3, {"set_on_ready_callback", "rclcpp_action::ServerBase", "on ready"}, std::move(callback));
  }
  void clear_on_ready_callback() {news.tell_of_none(*this, 3);}
};

template<class A>
class Server : public ServerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Server)
  using Goal = typename A::Goal;
  using Handle = ServerGoalHandle<A>;
  using GoalCallback = std::function<GoalResponse (const GoalUUID &, std::shared_ptr<const Goal>)>;
  using CancelCallback = std::function<CancelResponse (const std::shared_ptr<Handle>)>;
  using AcceptedCallback = std::function<void (const std::shared_ptr<Handle>)>;

  /// Whether to take a goal; a goal that is taken waits here until it is made a handle.
  void goal_asked(const GoalCallback & callback, rclcpp::Unpacker & from, rclcpp::Packer & to)
  {
    std::string key = from.s();
    auto goal = std::make_shared<Goal>();
    coursekit::from_cdr(from.rest(), *goal);
    auto answer = callback(goal_id_of(key), goal);
    if (answer != GoalResponse::REJECT) {
      std::lock_guard<std::mutex> hold(lock_);
      taken_[key] = goal;
    }
    to.i(static_cast<int64_t>(answer));
  }
  void accepted(const AcceptedCallback & callback, rclcpp::Unpacker & from)
  {
    std::string key = from.s();
    std::shared_ptr<Handle> handle;
    {
      std::lock_guard<std::mutex> hold(lock_);
      handle = std::make_shared<Handle>(id, goal_id_of(key), taken_[key]);
      taken_.erase(key);
      handles_[key] = handle;
    }
    callback(handle);
  }
  void cancel_asked(const CancelCallback & callback, rclcpp::Unpacker & from, rclcpp::Packer & to)
  {
    std::shared_ptr<Handle> handle;
    {
      std::lock_guard<std::mutex> hold(lock_);
      handle = handles_[from.s()].lock();
    }
    to.i(static_cast<int64_t>(handle ? callback(handle) : CancelResponse::REJECT));
  }

private:
  std::mutex lock_;
  std::map<std::string, std::shared_ptr<Goal>> taken_;
  std::map<std::string, std::weak_ptr<Handle>> handles_;
};

template<class A, class N>
typename Server<A>::SharedPtr create_server(
  N && node, const std::string & name, typename Server<A>::GoalCallback handle_goal,
  typename Server<A>::CancelCallback handle_cancel, typename Server<A>::AcceptedCallback handle_accepted,
  const rcl_action_server_options_t & options = rcl_action_server_get_default_options(),
  rclcpp::CallbackGroup::SharedPtr group = nullptr)
{
  auto made = std::make_shared<Server<A>>();
  std::weak_ptr<Server<A>> weak = made;
  auto goal = made->handle(
    [weak, handle_goal](rclcpp::Unpacker & from, rclcpp::Packer & to) {
      if (auto me = weak.lock()) {
        me->goal_asked(handle_goal, from, to);
      } else {
        to.i(static_cast<int64_t>(GoalResponse::REJECT));
      }
    });
  auto accepted = made->handle(
    [weak, handle_accepted](rclcpp::Unpacker & from, rclcpp::Packer &) {
      if (auto me = weak.lock()) {
        me->accepted(handle_accepted, from);
      }
    });
  auto cancel = made->handle(
    [weak, handle_cancel](rclcpp::Unpacker & from, rclcpp::Packer & to) {
      if (auto me = weak.lock()) {
        me->cancel_asked(handle_cancel, from, to);
      } else {
        to.i(static_cast<int64_t>(CancelResponse::REJECT));
      }
    });
  auto base = rclcpp::base_of(node);
  rclcpp::Packer with = rclcpp::Packer{}.i(base->id).s(A::coursekit_type).s(name).i(goal).i(accepted).i(cancel);
  rclcpp::detail::enter(
    "action_server", with.i(rclcpp::detail::number_of(group)).i(options.result_timeout.nanoseconds), *made);
  return made;
}
/// The same, with the interfaces of a node one by one.
template<class A, class B, class C, class L, class W>
typename Server<A>::SharedPtr create_server(
  B node, C, L, W, const std::string & name, typename Server<A>::GoalCallback handle_goal,
  typename Server<A>::CancelCallback handle_cancel, typename Server<A>::AcceptedCallback handle_accepted,
  const rcl_action_server_options_t & options = rcl_action_server_get_default_options(),
  rclcpp::CallbackGroup::SharedPtr group = nullptr)
{
  return rclcpp_action::create_server<A>(node, name, handle_goal, handle_cancel, handle_accepted, options, group);
}
}  // namespace rclcpp_action
