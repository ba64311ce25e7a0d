// Services: a server's side.
#pragma once
#include <functional>

#include "coursekit/entity.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/macros.hpp"
#include "rmw/types.h"

namespace rclcpp
{
class ServiceBase : public coursekit::Entity, public std::enable_shared_from_this<ServiceBase>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServiceBase)
  const char * get_service_name() const {return name.c_str();}
};

template<class S>
class Service : public ServiceBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Service)
  using Request = typename S::Request;
  using Response = typename S::Response;
  using SharedRequest = std::shared_ptr<Request>;
  using SharedResponse = std::shared_ptr<Response>;
  using Header = std::shared_ptr<rmw_request_id_t>;

  /// Answer a request that was put off: a callback that takes (service, header, request) may answer later.
  void send_response(rmw_request_id_t & header, Response & response)
  {
    ask("send_response", Packer{}.i(id).i(header.sequence_number).m(response));
  }

  /// Call the program's callback in the form that it takes; whether it has answered.
  template<class F>
  bool answer(F & callback, int64_t number, SharedRequest request, SharedResponse response)
  {
    auto header = std::make_shared<rmw_request_id_t>();
    header->sequence_number = number;
    auto me = std::static_pointer_cast<Service<S>>(this->shared_from_this());
    if constexpr (std::is_invocable_v<F &, SharedRequest, SharedResponse>) {
      callback(request, response);
    } else if constexpr (std::is_invocable_v<F &, Header, SharedRequest, SharedResponse>) {
      callback(header, request, response);
    } else if constexpr (std::is_invocable_v<F &, Header, SharedRequest>) {
      callback(header, request);
      return false;
    } else {
      static_assert(
        std::is_invocable_v<F &, std::shared_ptr<Service<S>>, Header, SharedRequest>,
        "a service's callback takes (std::shared_ptr<Request>, std::shared_ptr<Response>)");
      callback(me, header, request);
      return false;
    }
    return true;
  }
};
}  // namespace rclcpp
