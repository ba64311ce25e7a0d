// A PID controller whose gains are parameters of a node, and which publishes what it does.
#pragma once
#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "control_msgs/msg/pid_state.hpp"
#include "control_toolbox/pid.hpp"
#include "rclcpp/rclcpp.hpp"
#include "realtime_tools/realtime_publisher.h"

namespace control_toolbox
{
class PidROS
{
public:
  /// The prefix is that of the parameters and of the topic: "~/arm" gives arm.p and ~/arm/pid_state.
  template<class NodeT>
  explicit PidROS(std::shared_ptr<NodeT> node_ptr, std::string prefix = "", bool prefix_is_for_params = false)
  : PidROS(
      node_ptr->get_node_base_interface(), node_ptr->get_node_logging_interface(), node_ptr->get_node_parameters_interface(),
      node_ptr->get_node_topics_interface(), std::move(prefix), prefix_is_for_params) {}
  PidROS(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr, rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging,
    rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_params,
    rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr topics_interface, std::string prefix = "",
    bool prefix_is_for_params = false)
  : topic_prefix_(prefix), param_prefix_(std::move(prefix)), logging_(std::move(node_logging)), parameters_(std::move(node_params))
  {
    set_prefixes(prefix_is_for_params);
    state_pub_ = rclcpp::create_publisher<control_msgs::msg::PidState>(
      topics_interface, topic_prefix_ + "pid_state", rclcpp::SensorDataQoS());
    rt_state_pub_ = std::make_unique<realtime_tools::RealtimePublisher<control_msgs::msg::PidState>>(state_pub_);
  }
  PidROS(const PidROS &) = delete;

  void initPid(double p, double i, double d, double i_max, double i_min, bool antiwindup)
  {
    if (!in_order(i_max, i_min)) {
      return;
    }
    pid_.initPid(p, i, d, i_max, i_min, antiwindup);
    declare("antiwindup", rclcpp::ParameterValue(antiwindup));
    for (auto & [name, value] : {
        std::pair("p", p), std::pair("i", i), std::pair("d", d), std::pair("i_clamp_max", i_max), std::pair("i_clamp_min", i_min)})
    {
      declare(name, rclcpp::ParameterValue(value));
    }
    listen();
  }
  /// Take the gains from the parameters; false where one is missing.
  bool initPid()
  {
    Pid::Gains gains;
    bool all = true;
    for (auto & [name, value] : fields(gains)) {
      all = read(name, *value) && all;
    }
    declare("antiwindup", rclcpp::ParameterValue(false));
    rclcpp::Parameter antiwindup;
    if (parameters_->get_parameter(param_prefix_ + "antiwindup", antiwindup)) {
      gains.antiwindup_ = antiwindup.as_bool();
    }
    if (all) {
      listen();
    }
    pid_.initPid(gains.p_gain_, gains.i_gain_, gains.d_gain_, gains.i_max_, gains.i_min_, gains.antiwindup_);
    return all;
  }
  void reset() {pid_.reset();}
  double computeCommand(double error, rclcpp::Duration dt)
  {
    const double command = pid_.computeCommand(error, static_cast<uint64_t>(dt.nanoseconds()));
    publish(command, error, dt);
    return command;
  }
  double computeCommand(double error, double error_dot, rclcpp::Duration dt)
  {
    const double command = pid_.computeCommand(error, error_dot, static_cast<uint64_t>(dt.nanoseconds()));
    publish(command, error, dt);
    return command;
  }
  Pid::Gains getGains() {return pid_.getGains();}
  void setGains(double p, double i, double d, double i_max, double i_min, bool antiwindup = false)
  {
    if (!in_order(i_max, i_min)) {
      return;
    }
    parameters_->set_parameters({
        {param_prefix_ + "p", p}, {param_prefix_ + "i", i}, {param_prefix_ + "d", d}, {param_prefix_ + "i_clamp_max", i_max},
        {param_prefix_ + "i_clamp_min", i_min}, {param_prefix_ + "antiwindup", antiwindup}});
    pid_.setGains(p, i, d, i_max, i_min, antiwindup);
  }
  void setGains(const Pid::Gains & gains)
  {
    if (in_order(gains.i_max_, gains.i_min_)) {
      pid_.setGains(gains);
    }
  }
  void setCurrentCmd(double cmd) {pid_.setCurrentCmd(cmd);}
  double getCurrentCmd() {return pid_.getCurrentCmd();}
  std::shared_ptr<rclcpp::Publisher<control_msgs::msg::PidState>> getPidStatePublisher() {return state_pub_;}
  void getCurrentPIDErrors(double & pe, double & ie, double & de) {pid_.getCurrentPIDErrors(pe, ie, de);}
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr getParametersCallbackHandle() {return parameter_callback_;}
  void printValues()
  {
    double p = 0, i = 0, d = 0;
    getCurrentPIDErrors(p, i, d);
    const Pid::Gains gains = getGains();
    RCLCPP_INFO_STREAM(
      logging_->get_logger(), "Current Values of PID template:\n  P Gain:       " << gains.p_gain_ << "\n  I Gain:       " <<
        gains.i_gain_ << "\n  D Gain:       " << gains.d_gain_ << "\n  I_Max:        " << gains.i_max_ << "\n  I_Min:        " <<
        gains.i_min_ << "\n  Antiwindup:   " << gains.antiwindup_ << "\n  P_Error:      " << p << "\n  I_Error:      " << i <<
        "\n  D_Error:      " << d << "\n  Command:      " << getCurrentCmd());
  }

protected:
  std::string topic_prefix_, param_prefix_;

private:
  static std::vector<std::pair<std::string, double *>> fields(Pid::Gains & gains)
  {
    return {{"p", &gains.p_gain_}, {"i", &gains.i_gain_}, {"d", &gains.d_gain_}, {"i_clamp_max", &gains.i_max_},
      {"i_clamp_min", &gains.i_min_}};
  }
  void set_prefixes(bool is_for_params)
  {
    for (const char * lead : {"~", "/"}) {
      param_prefix_.erase(0, param_prefix_.compare(0, 1, lead) == 0 ? 1 : 0);
    }
    if (!is_for_params) {
      std::replace(param_prefix_.begin(), param_prefix_.end(), '/', '.');
    }
    std::replace(topic_prefix_.begin(), topic_prefix_.end(), '.', '/');
    end_with(param_prefix_, '.');
    end_with(topic_prefix_, '/');
    if (is_for_params && topic_prefix_.find_first_of("~/") != 0) {
      topic_prefix_.insert(0, "/");
    }
  }
  static void end_with(std::string & prefix, char sign)
  {
    if (!prefix.empty() && prefix.back() != sign) {
      prefix += sign;
    }
  }
  bool in_order(double i_max, double i_min)
  {
    if (i_min > i_max) {
      RCLCPP_ERROR(logging_->get_logger(), "received i_min > i_max, skip new gains");
    }
    return i_min <= i_max;
  }
  void declare(const std::string & name, const rclcpp::ParameterValue & value)
  {
    if (!parameters_->has_parameter(param_prefix_ + name)) {
      parameters_->declare_parameter(param_prefix_ + name, value);
    }
  }
  /// A gain that nobody has given is declared as not a number.
  bool read(const std::string & name, double & value)
  {
    declare(name, rclcpp::ParameterValue(std::numeric_limits<double>::quiet_NaN()));
    const rclcpp::Parameter parameter = parameters_->get_parameter(param_prefix_ + name);
    if (parameter.get_type() != rclcpp::PARAMETER_DOUBLE) {
      RCLCPP_ERROR(logging_->get_logger(), "Wrong parameter type '%s', not double", (param_prefix_ + name).c_str());
      return false;
    }
    value = parameter.as_double();
    return true;
  }
  void listen()
  {
    parameter_callback_ = parameters_->add_on_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> & changed) {
        Pid::Gains gains = pid_.getGains();
        for (auto & parameter : changed) {
          try {
            take(parameter, gains);
          } catch (const rclcpp::exceptions::InvalidParameterTypeException & error) {
            RCLCPP_INFO_STREAM(logging_->get_logger(), "Please use the right type: " << error.what());
          }
        }
        setGains(gains);
        rcl_interfaces::msg::SetParametersResult result;
        result.successful = true;
        return result;
      });
  }
  void take(const rclcpp::Parameter & parameter, Pid::Gains & gains) const
  {
    for (auto & [name, value] : fields(gains)) {
      if (parameter.get_name() == param_prefix_ + name) {
        *value = parameter.get_value<double>();
      }
    }
    if (parameter.get_name() == param_prefix_ + "antiwindup") {
      gains.antiwindup_ = parameter.get_value<bool>();
    }
  }
  void publish(double command, double error, rclcpp::Duration dt)
  {
    if (!rt_state_pub_->trylock()) {
      return;
    }
    auto & state = rt_state_pub_->msg_;
    const Pid::Gains gains = pid_.getGains();
    state.header.stamp = rclcpp::Clock().now();
    state.timestep = dt;
    state.error = error;
    pid_.getCurrentPIDErrors(state.p_error, state.i_error, state.d_error);
    state.error_dot = state.d_error;
    state.p_term = gains.p_gain_;
    state.i_term = gains.i_gain_;
    state.d_term = gains.d_gain_;
    state.i_max = gains.i_max_;
    state.i_min = gains.i_min_;
    state.output = command;
    rt_state_pub_->unlockAndPublish();
  }

  Pid pid_;
  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logging_;
  rclcpp::node_interfaces::NodeParametersInterface::SharedPtr parameters_;
  rclcpp::Publisher<control_msgs::msg::PidState>::SharedPtr state_pub_;
  std::unique_ptr<realtime_tools::RealtimePublisher<control_msgs::msg::PidState>> rt_state_pub_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr parameter_callback_;
};
}  // namespace control_toolbox
