// Hardware: the controller manager asks, its classes do.
#include <cmath>
#include <memory>
#include <stdexcept>

#include "class_loader/class_loader.hpp"
#include "coursekit/plugins.hpp"
#include "hardware_interface/actuator_interface.hpp"
#include "hardware_interface/component_parser.hpp"
#include "hardware_interface/sensor_interface.hpp"
#include "hardware_interface/system_interface.hpp"
#include "rclcpp/rclcpp.hpp"

namespace hardware_interface
{
namespace
{
using coursekit::Packer;
using coursekit::Unpacker;
using lifecycle_msgs::msg::State;
using Parameters = std::unordered_map<std::string, std::string>;

// -- descriptions

template<class T, class F>
std::vector<T> several(Unpacker & from, F one)
{
  std::vector<T> all;
  for (int64_t count = from.i(); count > 0; --count) {
    all.push_back(one(from));
  }
  return all;
}
Parameters parameters(Unpacker & from)
{
  Parameters all;
  for (int64_t count = from.i(); count > 0; --count) {
    std::string name = from.s();
    all[name] = from.s();
  }
  return all;
}
InterfaceInfo interface(Unpacker & from)
{
  InterfaceInfo read;
  for (auto field : {&read.name, &read.min, &read.max, &read.initial_value, &read.data_type}) {
    *field = from.s();
  }
  read.size = static_cast<int>(from.i());
  return read;
}
ComponentInfo component(Unpacker & from)
{
  ComponentInfo read;
  read.name = from.s();
  read.type = from.s();
  read.command_interfaces = several<InterfaceInfo>(from, interface);
  read.state_interfaces = several<InterfaceInfo>(from, interface);
  read.parameters = parameters(from);
  return read;
}
template<class T>
T geared(Unpacker & from)
{
  T read;
  read.name = from.s();
  read.role = from.s();
  read.mechanical_reduction = from.d();
  read.offset = from.d();
  read.state_interfaces = from.texts();
  read.command_interfaces = from.texts();
  return read;
}
TransmissionInfo transmission(Unpacker & from)
{
  TransmissionInfo read;
  read.name = from.s();
  read.type = from.s();
  read.joints = several<JointInfo>(from, geared<JointInfo>);
  read.actuators = several<ActuatorInfo>(from, geared<ActuatorInfo>);
  read.parameters = parameters(from);
  return read;
}
HardwareInfo info(Unpacker & from)
{
  HardwareInfo read;
  read.name = from.s();
  read.type = from.s();
  read.hardware_class_type = from.s();
  read.hardware_parameters = parameters(from);
  read.joints = several<ComponentInfo>(from, component);
  read.sensors = several<ComponentInfo>(from, component);
  read.gpios = several<ComponentInfo>(from, component);
  read.transmissions = several<TransmissionInfo>(from, transmission);
  return read;
}

// -- the states of hardware

constexpr const char * LABELS[] = {
  lifecycle_state_names::UNKNOWN, lifecycle_state_names::UNCONFIGURED, lifecycle_state_names::INACTIVE,
  lifecycle_state_names::ACTIVE, lifecycle_state_names::FINALIZED};

/// A class's object with its lifecycle and the interfaces that it exported.
class HardwareHost
{
public:
  explicit HardwareHost(std::unique_ptr<HardwareComponent> hardware)
  : hardware_(std::move(hardware)) {}

  void initialize(Unpacker & from)
  {
    const std::string name = from.s();
    for (auto & one : parse_control_resources_from_urdf(from.s())) {
      if (one.name == name) {
        const bool done = hardware_->on_init(one) == CallbackReturn::SUCCESS;
        put(done ? State::PRIMARY_STATE_UNCONFIGURED : State::PRIMARY_STATE_FINALIZED);
      }
    }
  }
  void export_interfaces(Packer & to)
  {
    states_ = hardware_->export_state_interfaces();
    commands_ = hardware_->export_command_interfaces();
    names(states_, to);
    names(commands_, to);
  }
  /// One of the lifecycle's transitions: where it leads if all goes well, and where after a failure.
  template<class F>
  void go(F callback, uint8_t goal, uint8_t after_failure)
  {
    const CallbackReturn done = (hardware_.get()->*callback)(hardware_->get_state());
    if (done == CallbackReturn::SUCCESS) {
      put(goal);
    } else if (done == CallbackReturn::FAILURE && after_failure != State::PRIMARY_STATE_UNKNOWN) {
      put(after_failure);
    } else {
      fail();
    }
  }
  void transition(const std::string & name)
  {
    using H = HardwareComponent;
    if (name == "configure") {
      go(&H::on_configure, State::PRIMARY_STATE_INACTIVE, State::PRIMARY_STATE_UNCONFIGURED);
    } else if (name == "activate") {
      go(&H::on_activate, State::PRIMARY_STATE_ACTIVE, State::PRIMARY_STATE_INACTIVE);
    } else if (name == "deactivate") {
      go(&H::on_deactivate, State::PRIMARY_STATE_INACTIVE, State::PRIMARY_STATE_ACTIVE);
    } else if (name == "cleanup") {
      go(&H::on_cleanup, State::PRIMARY_STATE_UNCONFIGURED, State::PRIMARY_STATE_UNKNOWN);
    } else {
      go(&H::on_shutdown, State::PRIMARY_STATE_FINALIZED, State::PRIMARY_STATE_UNKNOWN);
    }
  }
  /// read() or write(), unless the hardware is not configured; after an error its on_error decides.
  return_type cycle(Unpacker & from, bool writes)
  {
    const rclcpp::Time time(from.i(), RCL_ROS_TIME);
    const rclcpp::Duration period(std::chrono::nanoseconds(from.i()));
    for (auto & command : commands_) {
      const double value = from.d();
      if (writes && command) {
        command.set_value(value);
      }
    }
    const uint8_t state = hardware_->get_state().id();
    if (state != State::PRIMARY_STATE_INACTIVE && state != State::PRIMARY_STATE_ACTIVE) {
      return return_type::OK;
    }
    const return_type done = writes ? hardware_->write(time, period) : hardware_->read(time, period);
    if (done != return_type::OK) {
      fail();
    }
    return done;
  }
  return_type switch_mode(Unpacker & from, bool performs)
  {
    const std::vector<std::string> start = from.texts(), stop = from.texts();
    return performs ? hardware_->perform_command_mode_switch(start, stop) : hardware_->prepare_command_mode_switch(start, stop);
  }
  /// The state, and the numbers of all interfaces.
  void tell(Packer & to) const
  {
    to.i(hardware_->get_state().id());
    values(states_, to);
    values(commands_, to);
  }

private:
  void put(uint8_t state) {hardware_->set_state(rclcpp_lifecycle::State(state, LABELS[state]));}
  void fail()
  {
    const bool done = hardware_->on_error(hardware_->get_state()) == CallbackReturn::SUCCESS;
    put(done ? State::PRIMARY_STATE_UNCONFIGURED : State::PRIMARY_STATE_FINALIZED);
  }
  template<class T>
  static void names(const std::vector<T> & handles, Packer & to)
  {
    to.i(static_cast<int64_t>(handles.size()));
    for (auto & one : handles) {
      to.s(one.get_name());
    }
  }
  template<class T>
  static void values(const std::vector<T> & handles, Packer & to)
  {
    for (auto & one : handles) {
      to.d(one ? one.get_value() : std::nan(""));
    }
  }
  std::unique_ptr<HardwareComponent> hardware_;
  std::vector<StateInterface> states_;
  std::vector<CommandInterface> commands_;
};

// -- the requests

template<class Base>
bool make(class_loader::ClassLoader & own, const std::string & type, std::unique_ptr<HardwareComponent> & made)
{
  if (own.isClassAvailable<Base>(type)) {
    made.reset(own.createUnmanagedInstance<Base>(type));
  }
  return made != nullptr;
}
/// The class that the program is linked with; throws class_loader::CreateClassException where it has none of that name.
std::unique_ptr<HardwareComponent> make(const std::string & type)
{
  class_loader::ClassLoader own("");
  std::unique_ptr<HardwareComponent> made;
  if (make<SystemInterface>(own, type, made) || make<ActuatorInterface>(own, type, made) || make<SensorInterface>(own, type, made)) {
    return made;
  }
  throw class_loader::CreateClassException("Could not create instance of type " + type);
}
void serve(std::unique_ptr<HardwareHost> & host, const std::string & type, Unpacker & from, Packer & to)
{
  const std::string what = from.s();
  if (what == "make") {
    coursekit::careful(to, [&](Packer &) {host = std::make_unique<HardwareHost>(make(type));});
  } else if (what == "read" || what == "write") {
    to.i(static_cast<int64_t>(host->cycle(from, what == "write")));
    host->tell(to);
  } else if (what == "prepare" || what == "perform") {
    to.i(static_cast<int64_t>(host->switch_mode(from, what == "perform")));
  } else if (what == "export") {
    host->export_interfaces(to);
    host->tell(to);
  } else {
    coursekit::careful(to, [&](Packer &) {what == "initialize" ? host->initialize(from) : host->transition(what);});
    host->tell(to);
  }
}
}  // namespace

std::vector<HardwareInfo> parse_control_resources_from_urdf(const std::string & urdf)
{
  try {
    Unpacker answer = coursekit::request("hardware_infos", Packer{}.s(urdf));
    auto all = several<HardwareInfo>(answer, info);
    for (auto & one : all) {
      one.original_xml = urdf;
    }
    return all;
  } catch (const coursekit::Refused & refusal) {
    throw std::runtime_error(refusal.what());
  }
}
}  // namespace hardware_interface

coursekit::Handler coursekit::hardware_of(const std::string & type)
{
  auto host = std::make_shared<std::unique_ptr<hardware_interface::HardwareHost>>();
  return [host, type](Unpacker & from, Packer & to) {serve(*host, type, from, to);};
}
