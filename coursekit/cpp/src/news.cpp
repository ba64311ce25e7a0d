// Callbacks that are called as soon as something new has come: the session tells the program.
#include <cxxabi.h>
#include <stdlib.h>

#include <algorithm>
#include <mutex>

#include "rclcpp/logging.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/subscription.hpp"

namespace coursekit
{
namespace
{
std::mutex g_lock;

/// The class of an exception, in the words of C++.
std::string class_of(const std::exception & error)
{
  int status = 0;
  char * name = abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &status);
  std::string text = name ? name : typeid(error).name();
  free(name);
  return text;
}
/// Call it; what it throws is logged, as nobody is there who could catch it.
void call(const News::Callback & callback, size_t count, const NewsWords & words, const void * owner, const std::string & logger)
{
  const auto where = std::string(" in user-provided callback for the '") + words.callback + "' callback";
  try {
    callback(count);
  } catch (const std::exception & error) {
    RCLCPP_ERROR_STREAM(
      rclcpp::get_logger(logger), words.owner << "@" << owner << " caught " << class_of(error) << " exception" << where <<
        ": " << error.what());
  } catch (...) {
    RCLCPP_ERROR_STREAM(rclcpp::get_logger(logger), words.owner << "@" << owner << " caught unhandled exception" << where);
  }
}
/// Refuse a callback that is empty.
template<class F>
void need(const F & callback, const NewsWords & words)
{
  if (!callback) {
    throw std::invalid_argument(std::string("The callback passed to ") + words.setter + " is not callable.");
  }
}
}  // namespace

void News::tell(Entity & owner, int64_t kind, const NewsWords & words, Callback callback)
{
  need(callback, words);
  tell_no_more(owner, kind);
  int64_t handler = add_handler(
    [=, whose = static_cast<const void *>(&owner)](Unpacker & from, Packer &) {
      auto count = static_cast<size_t>(from.i());
      call(callback, count, words, whose, from.s());
    });
  {
    std::lock_guard<std::mutex> hold(g_lock);
    handlers_.emplace_back(kind, handler);
    owner.handlers.push_back(handler);
  }
  rclcpp::ask("on_new", Packer{}.i(owner.id).i(kind).i(handler));
}
void News::tell_no_more(Entity & owner, int64_t kind)
{
  int64_t handler;
  {
    std::lock_guard<std::mutex> hold(g_lock);
    auto is_it = [&](auto & entry) {return entry.first == kind;};
    auto found = std::find_if(handlers_.begin(), handlers_.end(), is_it);
    if (found == handlers_.end()) {
      return;
    }
    handler = found->second;
    handlers_.erase(found);
    owner.handlers.erase(std::find(owner.handlers.begin(), owner.handlers.end(), handler));
  }
  rclcpp::ask("on_new", Packer{}.i(owner.id).i(kind).i(0));
  remove_handler(handler);
}
void News::tell_each(Entity & owner, int kinds, const NewsWords & words, std::function<void (size_t, int)> callback)
{
  need(callback, words);
  for (int kind = 0; kind < kinds; ++kind) {
    tell(owner, kind, words, [callback, kind](size_t count) {callback(count, kind);});
  }
}
void News::tell_of_none(Entity & owner, int kinds)
{
  for (int kind = 0; kind < kinds; ++kind) {
    tell_no_more(owner, kind);
  }
}
}  // namespace coursekit

namespace rclcpp
{
namespace
{
constexpr char NOT_REGISTERED[] = "Calling set_on_new_qos_event_callback for non registered ";
constexpr char WITHOUT_IPC[] = "_on_new_intra_process_message_callback for subscription with IPC disabled";

template<class Owner, class Type>
void listen(Owner & owner, Type event, std::function<void (size_t)> callback, const char * what)
{
  if (!owner.events.count(event)) {
    RCLCPP_WARN(get_logger("rclcpp"), "%s%s", NOT_REGISTERED, what);
    return;
  }
  if (!callback) {
    throw std::invalid_argument("The callback passed to set_on_new_qos_event_callback is not callable.");
  }
  owner.events.at(event)->set_on_ready_callback([callback](size_t count, int) {callback(count);});
}
template<class Owner, class Type>
void listen_no_more(Owner & owner, Type event)
{
  if (!owner.events.count(event)) {
    RCLCPP_WARN(get_logger("rclcpp"), "Calling clear_on_new_qos_event_callback for non registered event_type");
    return;
  }
  owner.events.at(event)->clear_on_ready_callback();
}
}  // namespace

void PublisherBase::set_on_new_qos_event_callback(std::function<void (size_t)> callback, rcl_publisher_event_type_t event)
{
  listen(*this, event, std::move(callback), "publisher event_type");
}
void PublisherBase::clear_on_new_qos_event_callback(rcl_publisher_event_type_t event) {listen_no_more(*this, event);}
void SubscriptionBase::set_on_new_qos_event_callback(std::function<void (size_t)> callback, rcl_subscription_event_type_t event)
{
  listen(*this, event, std::move(callback), "subscription event_type");
}
void SubscriptionBase::clear_on_new_qos_event_callback(rcl_subscription_event_type_t event) {listen_no_more(*this, event);}
void SubscriptionBase::set_on_new_intra_process_message_callback(std::function<void (size_t)> callback)
{
  if (!inbox) {
    RCLCPP_WARN(get_logger("rclcpp"), "Calling set%s", WITHOUT_IPC);
    return;
  }
  news.tell(
    *this, coursekit::IN_PROGRAM,
    {"set_on_new_intra_process_message_callback", "rclcpp::SubscriptionIntraProcessBase", "on ready"}, std::move(callback));
}
void SubscriptionBase::clear_on_new_intra_process_message_callback()
{
  if (!inbox) {
    RCLCPP_WARN(get_logger("rclcpp"), "Calling clear%s", WITHOUT_IPC);
    return;
  }
  news.tell_no_more(*this, coursekit::IN_PROGRAM);
}
}  // namespace rclcpp
