// A service's callback of any form: with or without the request's header, answering at once or later.
#pragma once
#include <functional>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rmw/types.h"

namespace rclcpp
{
template<class S>
class Service;

template<class S>
class AnyServiceCallback
{
public:
  using Request = std::shared_ptr<typename S::Request>;
  using Response = std::shared_ptr<typename S::Response>;
  using Header = std::shared_ptr<rmw_request_id_t>;
  using Server = std::shared_ptr<Service<S>>;

  template<class F>
  void set(F && given)
  {
    using Callback = std::decay_t<F>;
    if constexpr (std::is_constructible_v<bool, Callback &> && std::is_assignable_v<Callback &, std::nullptr_t>) {
      if (!given) {
        throw std::invalid_argument("AnyServiceCallback::set(): callback cannot be nullptr");
      }
    }
    call_ = [callback = Callback(std::forward<F>(given))](auto && ... all) mutable {return call(callback, all ...);};
  }
  /// Call it; its answer, nullptr where it puts that off.
  Response dispatch(const Server & server, const Header & header, Request request)
  {
    if (!call_) {
      throw std::runtime_error("unexpected request without any callback set");
    }
    return call_(server, header, request);
  }
  void register_callback_for_tracing() {}

private:
  template<class F>
  static Response call(F & callback, const Server & server, const Header & header, const Request & request)
  {
    if constexpr (std::is_invocable_v<F &, Header, Request> && !std::is_invocable_v<F &, Request, Response>) {
      callback(header, request);
      return nullptr;
    } else if constexpr (std::is_invocable_v<F &, Server, Header, Request>) {
      callback(server, header, request);
      return nullptr;
    } else {
      auto response = std::make_shared<typename S::Response>();
      if constexpr (std::is_invocable_v<F &, Request, Response>) {
        callback(request, response);
      } else {
        static_assert(
          std::is_invocable_v<F &, Header, Request, Response>,
          "a service's callback takes (std::shared_ptr<Request>, std::shared_ptr<Response>)");
        callback(header, request, response);
      }
      return response;
    }
  }
  std::function<Response (const Server &, const Header &, const Request &)> call_;
};
}  // namespace rclcpp
