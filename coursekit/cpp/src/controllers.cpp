// Controllers: the controller manager asks, their classes do.
#include <memory>
#include <stdexcept>
#include <thread>

#include "class_loader/class_loader.hpp"
#include "controller_interface/chainable_controller_interface.hpp"
#include "controller_interface/controller_interface.hpp"
#include "coursekit/plugins.hpp"

namespace controller_interface
{
using coursekit::Packer;
using coursekit::Unpacker;
using hardware_interface::CommandInterface;
using hardware_interface::LoanedCommandInterface;
using hardware_interface::LoanedStateInterface;
using hardware_interface::StateInterface;
using rclcpp_lifecycle::State;

// -- what the classes have

return_type ControllerInterfaceBase::init(
  const std::string & controller_name, const std::string & namespace_, const rclcpp::NodeOptions & node_options)
{
  node_ = std::make_shared<rclcpp_lifecycle::LifecycleNode>(controller_name, namespace_, node_options, false);
  if (on_init() != CallbackReturn::SUCCESS) {
    return return_type::ERROR;
  }
  node_->register_on_configure([this](const State & before) {return on_configure(before);});
  node_->register_on_cleanup([this](const State & before) {return on_cleanup(before);});
  node_->register_on_activate([this](const State & before) {return on_activate(before);});
  node_->register_on_deactivate([this](const State & before) {return on_deactivate(before);});
  node_->register_on_shutdown([this](const State & before) {return on_shutdown(before);});
  node_->register_on_error([this](const State & before) {return on_error(before);});
  return return_type::OK;
}
const State & ControllerInterfaceBase::configure()
{
  if (get_state().id() == lifecycle_msgs::msg::State::PRIMARY_STATE_UNCONFIGURED) {
    update_rate_ = static_cast<unsigned int>(auto_declare<int64_t>("update_rate", 0));
  }
  return node_->configure();
}
void ControllerInterfaceBase::assign_interfaces(
  std::vector<LoanedCommandInterface> && command_interfaces, std::vector<LoanedStateInterface> && state_interfaces)
{
  // Loans are not assigned: each refers to its interface.
  for (auto & one : command_interfaces) {
    command_interfaces_.push_back(std::move(one));
  }
  for (auto & one : state_interfaces) {
    state_interfaces_.push_back(std::move(one));
  }
}
void ControllerInterfaceBase::release_interfaces()
{
  command_interfaces_.clear();
  state_interfaces_.clear();
}
std::shared_ptr<rclcpp_lifecycle::LifecycleNode> ControllerInterfaceBase::get_node() const
{
  if (!node_) {
    throw std::runtime_error("Lifecycle node hasn't been initialized yet!");
  }
  return node_;
}
const State & ControllerInterfaceBase::get_state() const {return node_->get_current_state();}

return_type ChainableControllerInterface::update(const rclcpp::Time & time, const rclcpp::Duration & period)
{
  const return_type done = is_in_chained_mode() ? return_type::OK : update_reference_from_subscribers();
  return done == return_type::OK ? update_and_write_commands(time, period) : done;
}
std::vector<CommandInterface> ChainableControllerInterface::export_reference_interfaces()
{
  auto all = on_export_reference_interfaces();
  const std::string name = get_node()->get_name();
  if (reference_interfaces_.size() != all.size()) {
    RCLCPP_FATAL(
      get_node()->get_logger(), "The internal storage for reference values 'reference_interfaces_' variable has size '%zu', "
      "but it is expected to have the size '%zu' equal to the number of exported reference interfaces. No reference interface "
      "will be exported. Please correct and recompile the controller with name '%s' and try again.",
      reference_interfaces_.size(), all.size(), name.c_str());
    return {};
  }
  for (auto & one : all) {
    if (one.get_prefix_name() != name) {
      RCLCPP_FATAL(
        get_node()->get_logger(), "The name of the interface '%s' does not begin with the controller's name. This is mandatory "
        " for reference interfaces. No reference interface will be exported. Please correct and recompile the controller with "
        "name '%s' and try again.", one.get_name().c_str(), name.c_str());
      return {};
    }
  }
  return all;
}
bool ChainableControllerInterface::set_chained_mode(bool chained_mode)
{
  if (get_state().id() == lifecycle_msgs::msg::State::PRIMARY_STATE_ACTIVE) {
    RCLCPP_ERROR(
      get_node()->get_logger(), "Can not change controller's chained mode because it is no in '%s' state. "
      "Current state is '%s'.", "inactive", get_state().label().c_str());
    return false;
  }
  if (!on_set_chained_mode(chained_mode)) {
    return false;
  }
  in_chained_mode_ = chained_mode;
  return true;
}

namespace
{
/// Copies of the numbers that a controller claims: the controller manager has the originals.
template<class Handle, class Loan>
class Claims
{
public:
  void claim(const std::vector<std::string> & names)
  {
    values_.assign(names.size(), 0.0);
    handles_.clear();
    handles_.reserve(names.size());  // loans refer to them
    for (size_t i = 0; i < names.size(); ++i) {
      const size_t slash = names[i].rfind('/');
      handles_.emplace_back(names[i].substr(0, slash), names[i].substr(slash + 1), &values_[i]);
    }
  }
  std::vector<Loan> loans()
  {
    std::vector<Loan> all;
    for (auto & one : handles_) {
      all.emplace_back(one);
    }
    return all;
  }
  void take(Unpacker & from)
  {
    for (double & value : values_) {
      value = from.d();
    }
  }
  void tell(Packer & to) const
  {
    for (double value : values_) {
      to.d(value);
    }
  }

private:
  std::vector<double> values_;
  std::vector<Handle> handles_;
};

/// A controller with its node, which a thread spins.
class ControllerHost
{
public:
  ~ControllerHost()
  {
    executor_.cancel();
    if (spinner_.joinable()) {
      spinner_.join();
    }
  }
  return_type make(const std::string & type, Unpacker & from)
  {
    class_loader::ClassLoader own("");
    if (own.isClassAvailable<ControllerInterface>(type)) {
      controller_.reset(own.createUnmanagedInstance<ControllerInterface>(type));
    } else {
      controller_.reset(own.createUnmanagedInstance<ChainableControllerInterface>(type));
    }
    const std::string name = from.s(), space = from.s();
    auto options = rclcpp::NodeOptions().allow_undeclared_parameters(true).automatically_declare_parameters_from_overrides(true);
    options.use_global_arguments(false).arguments(from.texts());
    const return_type done = controller_->init(name, space, options);
    if (done == return_type::OK) {
      executor_.add_node(controller_->get_node()->get_node_base_interface());
      spinner_ = std::thread([this] {executor_.spin();});
    }
    return done;
  }
  uint8_t transition(const std::string & what, Unpacker & from)
  {
    auto node = controller_->get_node();
    if (what == "configure") {
      const uint8_t state = controller_->configure().id();
      if (state == lifecycle_msgs::msg::State::PRIMARY_STATE_INACTIVE) {
        references_ = controller_->export_reference_interfaces();
      }
      return state;
    }
    if (what == "activate") {
      claim(from);
      return node->activate().id();
    }
    if (what == "deactivate") {
      const uint8_t state = node->deactivate().id();
      controller_->release_interfaces();
      return state;
    }
    return what == "cleanup" ? node->cleanup().id() : node->shutdown().id();
  }
  void configuration(Packer & to) const
  {
    tell(controller_->command_interface_configuration(), to);
    tell(controller_->state_interface_configuration(), to);
    to.i(controller_->get_update_rate()).i(static_cast<int64_t>(references_.size()));
    for (auto & one : references_) {
      to.s(one.get_name());
    }
  }
  bool set_chained_mode(bool chained_mode) {return controller_->set_chained_mode(chained_mode);}
  return_type update(Unpacker & from)
  {
    const rclcpp::Time time(from.i(), RCL_ROS_TIME);
    const rclcpp::Duration period(std::chrono::nanoseconds(from.i()));
    states_.take(from);
    commands_.take(from);
    if (controller_->is_in_chained_mode()) {
      for (auto & one : references_) {
        one.set_value(from.d());
      }
    }
    return controller_->update(time, period);
  }
  /// The commands, and the references, which a controller may use up.
  void tell(Packer & to) const
  {
    commands_.tell(to);
    for (auto & one : references_) {
      to.d(one.get_value());
    }
  }

private:
  void claim(Unpacker & from)
  {
    states_.claim(from.texts());
    commands_.claim(from.texts());
    states_.take(from);
    commands_.take(from);
    controller_->release_interfaces();
    controller_->assign_interfaces(commands_.loans(), states_.loans());
  }
  static void tell(const InterfaceConfiguration & configuration, Packer & to)
  {
    to.i(static_cast<int64_t>(configuration.type)).i(static_cast<int64_t>(configuration.names.size()));
    for (auto & name : configuration.names) {
      to.s(name);
    }
  }

  Claims<StateInterface, LoanedStateInterface> states_;
  Claims<CommandInterface, LoanedCommandInterface> commands_;
  std::unique_ptr<ControllerInterfaceBase> controller_;
  std::vector<CommandInterface> references_;
  rclcpp::executors::SingleThreadedExecutor executor_;
  std::thread spinner_;
};

void serve(ControllerHost & host, const std::string & type, Unpacker & from, Packer & to)
{
  const std::string what = from.s();
  if (what == "make") {
    coursekit::careful(to, [&](Packer & done) {done.i(static_cast<int64_t>(host.make(type, from)));});
  } else if (what == "update") {
    to.i(static_cast<int64_t>(host.update(from)));
    host.tell(to);
  } else if (what == "configuration") {
    host.configuration(to);
  } else if (what == "chained") {
    coursekit::careful(to, [&](Packer & done) {done.i(host.set_chained_mode(from.i() != 0));});
  } else {
    coursekit::careful(to, [&](Packer & done) {done.i(host.transition(what, from)); host.tell(done);});
  }
}
}  // namespace
}  // namespace controller_interface

coursekit::Handler coursekit::controller_of(const std::string & type)
{
  auto host = std::make_shared<controller_interface::ControllerHost>();
  return [host, type](Unpacker & from, Packer & to) {serve(*host, type, from, to);};
}
