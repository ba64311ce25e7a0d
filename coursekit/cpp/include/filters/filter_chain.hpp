// Filters one after the other, as parameters name them: `filter1.name`, `filter1.type`, `filter1.params`, `filter2.name` ...
#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "filters/filter_base.hpp"
#include "pluginlib/class_loader.hpp"

namespace filters
{
namespace impl
{
using Logging = rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr;
using Parameters = rclcpp::node_interfaces::NodeParametersInterface::SharedPtr;
struct FoundFilter
{
  std::string name, type, param_prefix;
};
/// Whether a filter's entry is one that a chain can have; else its logger says why not.
inline bool check(
  const rclcpp::Parameter & name, const rclcpp::Parameter & type, const std::vector<FoundFilter> & before,
  const Logging & log)
{
  for (const rclcpp::Parameter * one : {&name, &type}) {
    if (one->get_type() != rclcpp::PARAMETER_STRING) {
      RCLCPP_FATAL(log->get_logger(), "%s must be a string", one->get_name().c_str());
      return false;
    }
  }
  for (const FoundFilter & other : before) {
    if (other.name == name.as_string()) {
      RCLCPP_FATAL(log->get_logger(), "A filter with the name %s already exists", other.name.c_str());
      return false;
    }
  }
  const std::string words = type.as_string();
  if (std::count(words.begin(), words.end(), '/') != 1) {
    RCLCPP_FATAL(log->get_logger(), "%s must be of form <package_name>/<filter_name>", words.c_str());
    return false;
  }
  return true;
}
/// Find a chain's filters by the parameters of a node; false where one is described wrongly.
inline bool load_chain_config(
  const std::string & param_prefix, const Logging & log, const Parameters & parameters, std::vector<FoundFilter> & found)
{
  for (;;) {
    const std::string own = normalize_param_prefix(param_prefix) + "filter" + std::to_string(found.size() + 1);
    const rclcpp::Parameter name = declared(*parameters, own + ".name"), type = declared(*parameters, own + ".type");
    const bool has_name = name.get_type() != rclcpp::PARAMETER_NOT_SET;
    const bool has_type = type.get_type() != rclcpp::PARAMETER_NOT_SET;
    if (!has_name && !has_type) {
      return true;
    }
    if (has_name != has_type) {
      RCLCPP_FATAL(log->get_logger(), "%s.name and %s.type are required", own.c_str(), own.c_str());
      return false;
    }
    if (!check(name, type, found, log)) {
      return false;
    }
    found.push_back({name.as_string(), type.as_string(), own + ".params"});
  }
}

/// A chain of filters of one base class, of what they take and give.
template<class Filter, class Data>
class Chain
{
public:
  explicit Chain(const std::string & base_class)
  : loader_("filters", base_class) {}
  /// Pass data through all; false as soon as one fails.
  bool update(const Data & data_in, Data & data_out)
  {
    data_out = data_in;
    for (auto & filter : filters_) {
      const Data before = data_out;
      if (!filter->update(before, data_out)) {
        return false;
      }
    }
    return true;
  }
  bool clear()
  {
    configured_ = false;
    filters_.clear();
    return true;
  }

protected:
  template<class Configure>
  bool load(const std::string & param_prefix, const Logging & log, const Parameters & parameters, Configure configure)
  {
    if (configured_) {
      RCLCPP_ERROR(log->get_logger(), "Filter chain is already configured");
      return false;
    }
    std::vector<FoundFilter> found;
    if (!load_chain_config(param_prefix, log, parameters, found)) {
      return false;
    }
    std::vector<pluginlib::UniquePtr<Filter>> loaded;
    for (const FoundFilter & one : found) {
      pluginlib::UniquePtr<Filter> filter = make(one, log);
      if (!filter) {
        return false;
      }
      if (!configure(*filter, one)) {
        RCLCPP_FATAL(log->get_logger(), "Could not configure %s of type %s", one.name.c_str(), one.type.c_str());
        return false;
      }
      loaded.push_back(std::move(filter));
    }
    filters_ = std::move(loaded);
    return configured_ = true;
  }

private:
  pluginlib::UniquePtr<Filter> make(const FoundFilter & one, const Logging & log)
  {
    try {
      return loader_.createUniqueInstance(one.type);
    } catch (const pluginlib::LibraryLoadException & error) {
      RCLCPP_FATAL(log->get_logger(), "Could not load library for %s: %s", one.type.c_str(), error.what());
    } catch (const pluginlib::CreateClassException & error) {
      RCLCPP_FATAL(log->get_logger(), "Could not construct class %s: %s", one.type.c_str(), error.what());
    }
    return pluginlib::UniquePtr<Filter>();
  }
  pluginlib::ClassLoader<Filter> loader_;
  std::vector<pluginlib::UniquePtr<Filter>> filters_;  // after their loader, which they must not outlive
  bool configured_ = false;
};
}  // namespace impl

template<typename T>
class FilterChain : public impl::Chain<FilterBase<T>, T>
{
public:
  explicit FilterChain(std::string data_type)
  : impl::Chain<FilterBase<T>, T>("filters::FilterBase<" + data_type + ">") {}
  bool configure(const std::string & param_prefix, const impl::Logging & node_logger, const impl::Parameters & node_params)
  {
    return this->load(
      param_prefix, node_logger, node_params, [&](FilterBase<T> & filter, const impl::FoundFilter & one) {
        return filter.configure(one.param_prefix, one.name, node_logger, node_params);
      });
  }
};

template<typename T>
class MultiChannelFilterChain : public impl::Chain<MultiChannelFilterBase<T>, std::vector<T>>
{
public:
  explicit MultiChannelFilterChain(std::string data_type)
  : impl::Chain<MultiChannelFilterBase<T>, std::vector<T>>("filters::MultiChannelFilterBase<" + data_type + ">") {}
  bool configure(
    size_t number_of_channels, const std::string & param_prefix, const impl::Logging & node_logger,
    const impl::Parameters & node_params)
  {
    return this->load(
      param_prefix, node_logger, node_params, [&](MultiChannelFilterBase<T> & filter, const impl::FoundFilter & one) {
        return filter.configure(number_of_channels, one.param_prefix, one.name, node_logger, node_params);
      });
  }
};
}  // namespace filters
