// Action clients: the session's; answers come back to this program's callbacks and futures.
#pragma once
#include "rclcpp_action/client_goal_handle.hpp"

namespace rclcpp_action
{
class ClientBase : public coursekit::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ClientBase)
  enum class EntityType : size_t {GoalClient, ResultClient, CancelClient, FeedbackSubscription, StatusSubscription};

  /// Have a function called with how many have come of what, a number of EntityType, as soon as they have.
  void set_on_ready_callback(std::function<void (size_t, int)> callback)
  {
    news.tell_each(*this, 5, {"set_on_ready_callback", "rclcpp_action::ClientBase", "on ready"}, std::move(callback));
  }
  void clear_on_ready_callback() {news.tell_of_none(*this, 5);}
  bool action_server_is_ready() const {return rclcpp::ask("action_ready", rclcpp::Packer{}.i(id)).i();}
  template<class Rep = int64_t, class Period = std::milli>
  bool wait_for_action_server(std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(timeout);
    return rclcpp::ask("wait_for_action", rclcpp::Packer{}.i(id).i(nanoseconds.count())).i();
  }
};

template<class A>
class Client : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client)
  using Goal = typename A::Goal;
  using Feedback = typename A::Feedback;
  using GoalHandle = ClientGoalHandle<A>;
  using WrappedResult = typename GoalHandle::WrappedResult;
  using GoalResponseCallback = std::function<void (typename GoalHandle::SharedPtr)>;
  using FeedbackCallback = typename GoalHandle::FeedbackCallback;
  using ResultCallback = typename GoalHandle::ResultCallback;
  using CancelRequest = action_msgs::srv::CancelGoal::Request;
  using CancelResponse = action_msgs::srv::CancelGoal::Response;
  using CancelCallback = std::function<void (typename CancelResponse::SharedPtr)>;
  struct SendGoalOptions
  {
    GoalResponseCallback goal_response_callback;
    FeedbackCallback feedback_callback;
    ResultCallback result_callback;
  };
  ~Client()
  {
    for (auto & [key, handle] : handles_) {
      handle->invalidate();
    }
  }
  using GoalFuture = std::shared_future<typename GoalHandle::SharedPtr>;
  using CancelFuture = std::shared_future<typename CancelResponse::SharedPtr>;

  GoalFuture async_send_goal(const Goal & goal, const SendGoalOptions & options = SendGoalOptions())
  {
    auto promise = std::make_shared<std::promise<typename GoalHandle::SharedPtr>>();
    GoalFuture future = promise->get_future().share();
    int64_t number = remember(sent_, {promise, options});
    std::string cdr = coursekit::to_cdr(goal);
    rclcpp::ask("send_goal", rclcpp::Packer{}.i(id).i(number).raw(cdr.data(), cdr.size()));
    return future;
  }
  std::shared_future<WrappedResult> async_get_result(typename GoalHandle::SharedPtr handle, ResultCallback callback = nullptr)
  {
    if (!known(handle)) {
      throw exceptions::UnknownGoalHandleError();
    }
    if (callback) {
      handle->done_ = callback;
    }
    ask_for_result(handle);
    return handle->future_;
  }
  CancelFuture async_cancel_goal(typename GoalHandle::SharedPtr handle, CancelCallback callback = nullptr)
  {
    if (!known(handle)) {
      throw exceptions::UnknownGoalHandleError();
    }
    return cancel(bytes_of(handle->goal_id_), 0, callback);
  }
  CancelFuture async_cancel_all_goals(CancelCallback callback = nullptr) {return cancel(std::string(16, '\0'), 0, callback);}
  CancelFuture async_cancel_goals_before(const rclcpp::Time & stamp, CancelCallback callback = nullptr)
  {
    return cancel(std::string(16, '\0'), stamp.nanoseconds(), callback);
  }
  void stop_callbacks(typename GoalHandle::SharedPtr handle)
  {
    handle->heard_ = nullptr;
    handle->done_ = nullptr;
  }

  // -- what the session tells

  void goal_answered(rclcpp::Unpacker & from)
  {
    Sent sent = recall(sent_, from.i());
    if (!sent.promise) {
      return;
    }
    bool accepted = from.i();
    std::string key = from.s();
    typename GoalHandle::SharedPtr handle;
    if (accepted) {
      auto & options = sent.options;
      handle = std::make_shared<GoalHandle>(
        id, goal_id_of(key), rclcpp::Time(from.i(), RCL_ROS_TIME), options.feedback_callback, options.result_callback);
      std::lock_guard<std::mutex> hold(lock_);
      handles_[key] = handle;
    }
    sent.promise->set_value(handle);
    if (sent.options.goal_response_callback) {
      sent.options.goal_response_callback(handle);
    }
    if (handle && handle->done_) {
      ask_for_result(handle);
    }
  }
  void feedback_heard(rclcpp::Unpacker & from)
  {
    auto handle = handle_of(from.s());
    if (!handle || !handle->heard_) {
      return;
    }
    auto feedback = std::make_shared<Feedback>();
    coursekit::from_cdr(from.rest(), *feedback);
    handle->heard_(handle, feedback);
  }
  void result_came(rclcpp::Unpacker & from)
  {
    std::string key = from.s();
    auto handle = handle_of(key);
    if (!handle) {
      return;
    }
    WrappedResult wrapped;
    wrapped.goal_id = handle->goal_id_;
    wrapped.code = static_cast<ResultCode>(from.i());
    wrapped.result = std::make_shared<typename A::Result>();
    coursekit::from_cdr(from.rest(), *wrapped.result);
    {
      std::lock_guard<std::mutex> hold(lock_);
      handles_.erase(key);
    }
    handle->ended_ = static_cast<int8_t>(wrapped.code);
    handle->promise_.set_value(wrapped);
    if (handle->done_) {
      handle->done_(wrapped);
    }
  }
  void cancel_answered(rclcpp::Unpacker & from)
  {
    Cancelled asked = recall(cancelled_, from.i());
    if (!asked.promise) {
      return;
    }
    auto response = std::make_shared<CancelResponse>();
    coursekit::from_cdr(from.rest(), *response);
    asked.promise->set_value(response);
    if (asked.callback) {
      asked.callback(response);
    }
  }

private:
  struct Sent
  {
    std::shared_ptr<std::promise<typename GoalHandle::SharedPtr>> promise;
    SendGoalOptions options;
  };
  struct Cancelled
  {
    std::shared_ptr<std::promise<typename CancelResponse::SharedPtr>> promise;
    CancelCallback callback;
  };
  template<class T>
  int64_t remember(std::map<int64_t, T> & where, T what)
  {
    std::lock_guard<std::mutex> hold(lock_);
    where.emplace(++next_, std::move(what));
    return next_;
  }
  template<class T>
  T recall(std::map<int64_t, T> & where, int64_t number)
  {
    std::lock_guard<std::mutex> hold(lock_);
    auto found = where.find(number);
    T what = found == where.end() ? T() : std::move(found->second);
    where.erase(number);
    return what;
  }
  typename GoalHandle::SharedPtr handle_of(const std::string & key)
  {
    std::lock_guard<std::mutex> hold(lock_);
    auto found = handles_.find(key);
    return found == handles_.end() ? nullptr : found->second;
  }
  bool known(const typename GoalHandle::SharedPtr & handle) {return handle && handle_of(bytes_of(handle->goal_id_)) == handle;}
  void ask_for_result(const typename GoalHandle::SharedPtr & handle)
  {
    if (!handle->aware_) {
      handle->aware_ = true;
      rclcpp::ask("get_result", handle->with());
    }
  }
  CancelFuture cancel(const std::string & key, int64_t stamp, CancelCallback callback)
  {
    auto promise = std::make_shared<std::promise<typename CancelResponse::SharedPtr>>();
    CancelFuture future = promise->get_future().share();
    int64_t number = remember(cancelled_, {promise, callback});
    rclcpp::ask("cancel_goals", rclcpp::Packer{}.i(id).i(number).s(key).i(stamp));
    return future;
  }

  std::mutex lock_;
  int64_t next_ = 0;
  std::map<int64_t, Sent> sent_;
  std::map<int64_t, Cancelled> cancelled_;
  std::map<std::string, typename GoalHandle::SharedPtr> handles_;
};

template<class A, class N>
typename Client<A>::SharedPtr create_client(
  N && node, const std::string & name, rclcpp::CallbackGroup::SharedPtr group = nullptr, const rcl_action_client_options_t & = {})
{
  auto made = std::make_shared<Client<A>>();
  std::weak_ptr<Client<A>> weak = made;
  auto told = [&](void (Client<A>::* what)(rclcpp::Unpacker &)) {
      return made->handle(
        [weak, what](rclcpp::Unpacker & from, rclcpp::Packer &) {
          if (auto me = weak.lock()) {
            ((*me).*what)(from);
          }
        });
    };
  rclcpp::Packer with = rclcpp::Packer{}.i(rclcpp::base_of(node)->id).s(A::coursekit_type).s(name);
  with.i(told(&Client<A>::goal_answered)).i(told(&Client<A>::feedback_heard));
  with.i(told(&Client<A>::result_came)).i(told(&Client<A>::cancel_answered));
  rclcpp::detail::enter("action_client", with.i(rclcpp::detail::number_of(group)), *made);
  return made;
}
/// The same, with the interfaces of a node one by one.
template<class A, class B, class G, class L, class W>
typename Client<A>::SharedPtr create_client(
  B node, G, L, W, const std::string & name, rclcpp::CallbackGroup::SharedPtr group = nullptr,
  const rcl_action_client_options_t & options = {})
{
  return rclcpp_action::create_client<A>(node, name, group, options);
}
}  // namespace rclcpp_action
