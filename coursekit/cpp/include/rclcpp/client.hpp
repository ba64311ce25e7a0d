// Services: a client's side.
#pragma once
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <mutex>

#include "coursekit/entity.hpp"
#include "coursekit/wait_set_part.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/future_return_code.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/qos.hpp"
#include "rmw/types.h"

namespace rclcpp
{
namespace detail
{
/// A future with the number of the request that it belongs to.
template<class F>
struct FutureAndRequestId
{
  F future;
  int64_t request_id = 0;
  operator F &() {return future;}
  auto get() {return future.get();}
  bool valid() const noexcept {return future.valid();}
  void wait() const {future.wait();}
  template<class Rep, class Period>
  std::future_status wait_for(const std::chrono::duration<Rep, Period> & timeout) const {return future.wait_for(timeout);}
  template<class Clock, class Duration>
  std::future_status wait_until(const std::chrono::time_point<Clock, Duration> & until) const
  {
    return future.wait_until(until);
  }
};
}  // namespace detail

class ClientBase
  : public coursekit::Entity, public coursekit::WaitSetPart, public std::enable_shared_from_this<ClientBase>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ClientBase)
  const char * get_service_name() const {return name.c_str();}
  QoS get_request_publisher_actual_qos() const {return qos;}
  QoS get_response_subscription_actual_qos() const {return qos;}
  std::shared_ptr<coursekit::Entity> get_client_handle() {return shared_from_this();}
  std::shared_ptr<const coursekit::Entity> get_client_handle() const {return shared_from_this();}
  /// Have a function called with how many responses have come, as soon as they have.
  void set_on_new_response_callback(std::function<void (size_t)> callback)
  {
    news.tell(
      *this, coursekit::ITSELF, {"set_on_new_response_callback", "rclcpp::ClientBase", "on new response"}, std::move(callback));
  }
  void clear_on_new_response_callback() {news.tell_no_more(*this, coursekit::ITSELF);}
  std::shared_ptr<rmw_request_id_t> create_request_header() {return std::make_shared<rmw_request_id_t>();}
  virtual std::shared_ptr<void> create_response() = 0;
  virtual bool take_type_erased_response(void * response, rmw_request_id_t & header) = 0;
  /// Fulfil the request that a response which was taken belongs to.
  virtual void handle_response(std::shared_ptr<rmw_request_id_t> header, std::shared_ptr<void> response) = 0;
  bool service_is_ready() const {return ask("service_ready", Packer{}.i(id)).i();}
  template<class Rep = int64_t, class Period = std::milli>
  bool wait_for_service(std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(timeout);
    return ask("wait_for_service", Packer{}.i(id).i(nanoseconds.count())).i();
  }
  QoS qos{10};
};

template<class S>
class Client : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client)
  using Request = typename S::Request;
  using Response = typename S::Response;
  using SharedRequest = std::shared_ptr<Request>;
  using SharedResponse = std::shared_ptr<Response>;
  using Promise = std::promise<SharedResponse>;
  using SharedPromise = std::shared_ptr<Promise>;
  using PromiseWithRequest = std::promise<std::pair<SharedRequest, SharedResponse>>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using SharedFutureWithRequest = std::shared_future<std::pair<SharedRequest, SharedResponse>>;
  using CallbackType = std::function<void (SharedFuture)>;
  using CallbackWithRequestType = std::function<void (SharedFutureWithRequest)>;

  struct FutureAndRequestId : detail::FutureAndRequestId<Future>
  {
    SharedFuture share() noexcept {return this->future.share();}
    operator SharedFuture() {return this->future.share();}
  };
  struct SharedFutureAndRequestId : detail::FutureAndRequestId<SharedFuture> {};
  struct SharedFutureWithRequestAndRequestId : detail::FutureAndRequestId<SharedFutureWithRequest> {};

  FutureAndRequestId async_send_request(SharedRequest request)
  {
    auto promise = std::make_shared<Promise>();
    FutureAndRequestId sent;
    sent.future = promise->get_future();
    sent.request_id = send(request, [promise](SharedResponse response) {promise->set_value(response);});
    return sent;
  }
  template<class F, std::enable_if_t<std::is_invocable_v<F, SharedFuture>> * = nullptr>
  SharedFutureAndRequestId async_send_request(SharedRequest request, F && callback)
  {
    auto promise = std::make_shared<Promise>();
    SharedFutureAndRequestId sent;
    sent.future = promise->get_future().share();
    CallbackType then = std::forward<F>(callback);
    sent.request_id = send(
      request, [promise, future = sent.future, then](SharedResponse response) {
        promise->set_value(response);
        then(future);
      });
    return sent;
  }
  template<class F, std::enable_if_t<
      std::is_invocable_v<F, SharedFutureWithRequest> && !std::is_invocable_v<F, SharedFuture>> * = nullptr>
  SharedFutureWithRequestAndRequestId async_send_request(SharedRequest request, F && callback)
  {
    auto promise = std::make_shared<PromiseWithRequest>();
    SharedFutureWithRequestAndRequestId sent;
    sent.future = promise->get_future().share();
    CallbackWithRequestType then = std::forward<F>(callback);
    sent.request_id = send(
      request, [promise, future = sent.future, then, request](SharedResponse response) {
        promise->set_value({request, response});
        then(future);
      });
    return sent;
  }

  bool remove_pending_request(int64_t number)
  {
    std::lock_guard<std::mutex> hold(lock_);
    return pending_.erase(number) != 0;
  }
  template<class F>
  bool remove_pending_request(const detail::FutureAndRequestId<F> & sent) {return remove_pending_request(sent.request_id);}
  size_t prune_pending_requests()
  {
    std::lock_guard<std::mutex> hold(lock_);
    size_t count = pending_.size();
    pending_.clear();
    return count;
  }
  template<class Duration, class Allocator = std::allocator<int64_t>>
  size_t prune_requests_older_than(
    std::chrono::time_point<std::chrono::system_clock, Duration> time, std::vector<int64_t, Allocator> * pruned = nullptr)
  {
    std::lock_guard<std::mutex> hold(lock_);
    size_t before = pending_.size();
    for (auto at = pending_.begin(); at != pending_.end(); ) {
      if (at->second.sent < time) {
        if (pruned) {
          pruned->push_back(at->first);
        }
        at = pending_.erase(at);
      } else {
        ++at;
      }
    }
    return before - pending_.size();
  }
  /// Take the next response without waiting and without its callback; false where there is none.
  bool take_response(Response & response, rmw_request_id_t & header)
  {
    Unpacker answer = ask("take_response", Packer{}.i(id));
    if (!answer.i()) {
      return false;
    }
    header.sequence_number = answer.i();
    coursekit::from_cdr(answer.rest(), response);
    return true;
  }
  std::shared_ptr<void> create_response() override {return std::make_shared<Response>();}
  bool take_type_erased_response(void * response, rmw_request_id_t & header) override
  {
    return take_response(*static_cast<Response *>(response), header);
  }
  void handle_response(std::shared_ptr<rmw_request_id_t> header, std::shared_ptr<void> response) override
  {
    fulfil(header->sequence_number, std::static_pointer_cast<Response>(response));
  }
  /// The session has the response to a request.
  void receive(int64_t number, const std::string & cdr)
  {
    auto response = std::make_shared<Response>();
    coursekit::from_cdr(cdr, *response);
    fulfil(number, response);
  }

private:
  using Then = std::function<void (SharedResponse)>;
  struct Pending
  {
    std::chrono::system_clock::time_point sent;
    Then then;
  };
  /// A response to a request that was given up is dropped.
  void fulfil(int64_t number, SharedResponse response)
  {
    Then then;
    {
      std::lock_guard<std::mutex> hold(lock_);
      auto found = pending_.find(number);
      if (found == pending_.end()) {
        return;
      }
      then = std::move(found->second.then);
      pending_.erase(found);
    }
    then(response);
  }
  int64_t send(const SharedRequest & request, Then then)
  {
    int64_t number = next_++;
    {
      std::lock_guard<std::mutex> hold(lock_);
      pending_.emplace(number, Pending{std::chrono::system_clock::now(), std::move(then)});
    }
    std::string cdr = coursekit::to_cdr(*request);
    coursekit::note("send_request", Packer{}.i(id).i(number).raw(cdr.data(), cdr.size()));
    return number;
  }
  std::mutex lock_;
  std::atomic<int64_t> next_{1};
  std::map<int64_t, Pending> pending_;
};
}  // namespace rclcpp
