// Services: a server's side.
#pragma once
#include <functional>

#include "coursekit/entity.hpp"
#include "coursekit/wait_set_part.hpp"
#include "rclcpp/any_service_callback.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/qos.hpp"
#include "rmw/types.h"

namespace rclcpp
{
class ServiceBase
  : public coursekit::Entity, public coursekit::WaitSetPart, public std::enable_shared_from_this<ServiceBase>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServiceBase)
  const char * get_service_name() const {return name.c_str();}
  QoS get_request_subscription_actual_qos() const {return qos;}
  QoS get_response_publisher_actual_qos() const {return qos;}
  std::shared_ptr<coursekit::Entity> get_service_handle() {return shared_from_this();}
  std::shared_ptr<const coursekit::Entity> get_service_handle() const {return shared_from_this();}
  /// Have a function called with how many requests have come, as soon as they have.
  void set_on_new_request_callback(std::function<void (size_t)> callback)
  {
    news.tell(
      *this, coursekit::ITSELF, {"set_on_new_request_callback", "rclcpp::ServiceBase", "on new request"}, std::move(callback));
  }
  void clear_on_new_request_callback() {news.tell_no_more(*this, coursekit::ITSELF);}
  std::shared_ptr<rmw_request_id_t> create_request_header() {return std::make_shared<rmw_request_id_t>();}
  virtual std::shared_ptr<void> create_request() = 0;
  virtual bool take_type_erased_request(void * request, rmw_request_id_t & header) = 0;
  /// Run the callback with a request that was taken, and answer it.
  virtual void handle_request(std::shared_ptr<rmw_request_id_t> header, std::shared_ptr<void> request) = 0;
  QoS qos{10};
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

  /// Take the next request without waiting and without the callback; false where there is none.
  bool take_request(Request & request, rmw_request_id_t & header)
  {
    Unpacker answer = ask("take_request", Packer{}.i(id));
    if (!answer.i()) {
      return false;
    }
    header.sequence_number = answer.i();
    coursekit::from_cdr(answer.rest(), request);
    return true;
  }
  std::shared_ptr<void> create_request() override {return std::make_shared<Request>();}
  bool take_type_erased_request(void * request, rmw_request_id_t & header) override
  {
    return take_request(*static_cast<Request *>(request), header);
  }
  void handle_request(Header header, std::shared_ptr<void> request) override
  {
    if (auto response = answer(header, std::static_pointer_cast<Request>(request))) {
      send_response(*header, *response);
    }
  }
  /// Call the program's callback; its answer, nullptr where it puts that off.
  SharedResponse answer(const Header & header, SharedRequest request)
  {
    return callback.dispatch(std::static_pointer_cast<Service<S>>(this->shared_from_this()), header, std::move(request));
  }
  AnyServiceCallback<S> callback;
};
}  // namespace rclcpp
