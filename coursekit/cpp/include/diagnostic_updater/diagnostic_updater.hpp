// Tasks that tell how something is, and the updater that asks them once in a while.
#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "diagnostic_msgs/msg/diagnostic_array.hpp"
#include "diagnostic_updater/diagnostic_status_wrapper.hpp"
#include "rclcpp/rclcpp.hpp"

namespace diagnostic_updater
{
using TaskFunction = std::function<void (DiagnosticStatusWrapper &)>;

class DiagnosticTask
{
public:
  explicit DiagnosticTask(const std::string & name)
  : name_(name) {}
  virtual ~DiagnosticTask() = default;
  const std::string & getName() const {return name_;}
  virtual void run(DiagnosticStatusWrapper & status) = 0;

private:
  std::string name_;
};

template<class T>
class GenericFunctionDiagnosticTask : public DiagnosticTask
{
public:
  GenericFunctionDiagnosticTask(const std::string & name, std::function<void (T &)> function)
  : DiagnosticTask(name), function_(std::move(function)) {}
  void run(DiagnosticStatusWrapper & status) override {function_(status);}

private:
  std::function<void (T &)> function_;
};
using FunctionDiagnosticTask = GenericFunctionDiagnosticTask<DiagnosticStatusWrapper>;

/// Several tasks with one status: all their values, the worst of their levels.
class CompositeDiagnosticTask : public DiagnosticTask
{
public:
  using DiagnosticTask::DiagnosticTask;
  void run(DiagnosticStatusWrapper & status) override
  {
    DiagnosticStatusWrapper before, together;
    before.summary(status);
    for (auto task : tasks_) {
      status.summary(before);
      task->run(status);
      together.mergeSummary(status);
    }
    status.summary(together);
  }
  void addTask(DiagnosticTask * task) {tasks_.push_back(task);}

private:
  std::vector<DiagnosticTask *> tasks_;
};

/// Tasks with a status each.
class DiagnosticTaskVector
{
public:
  virtual ~DiagnosticTaskVector() = default;
  void add(const std::string & name, TaskFunction task)
  {
    std::lock_guard<std::mutex> turn(lock_);
    tasks_.emplace_back(name, std::move(task));
    addedTaskCallback(tasks_.back());
  }
  void add(DiagnosticTask & task)
  {
    add(task.getName(), [&task](DiagnosticStatusWrapper & status) {task.run(status);});
  }
  template<class T>
  void add(const std::string & name, T * object, void (T::* method)(DiagnosticStatusWrapper &))
  {
    add(name, [object, method](DiagnosticStatusWrapper & status) {(object->*method)(status);});
  }
  /// Take the task of that name away; whether there was one.
  bool removeByName(const std::string & name)
  {
    std::lock_guard<std::mutex> turn(lock_);
    for (auto it = tasks_.begin(); it != tasks_.end(); ++it) {
      if (it->getName() == name) {
        tasks_.erase(it);
        return true;
      }
    }
    return false;
  }

protected:
  class DiagnosticTaskInternal
  {
public:
    DiagnosticTaskInternal(const std::string & name, TaskFunction function)
    : name_(name), function_(std::move(function)) {}
    const std::string & getName() const {return name_;}
    void run(DiagnosticStatusWrapper & status) const
    {
      status.name = name_;
      function_(status);
    }

private:
    std::string name_;
    TaskFunction function_;
  };
  virtual void addedTaskCallback(DiagnosticTaskInternal &) {}
  std::vector<DiagnosticTaskInternal> getTasks()
  {
    std::lock_guard<std::mutex> turn(lock_);
    return tasks_;
  }

private:
  std::mutex lock_;
  std::vector<DiagnosticTaskInternal> tasks_;
};

/// Asks its tasks each period and publishes what they tell on /diagnostics.
class Updater : public DiagnosticTaskVector
{
  using Interface = rclcpp::node_interfaces::NodeBaseInterface::SharedPtr;

public:
  bool verbose_ = false;

  template<class N>
  explicit Updater(N node, double period = 1.0)
  : Updater(rclcpp::base_of(node), period) {}
  /// Of a node's base, clock, logging, parameters, timers and topics.
  Updater(Interface base, Interface, Interface, Interface, Interface, Interface, double period = 1.0)
  : Updater(base, period) {}
  explicit Updater(Interface base, double period = 1.0)
  : base_(base), period_(rclcpp::Duration::from_seconds(period))
  {
    const char * name = "diagnostic_updater.period";
    if (!base_->has_parameter(name)) {
      base_->declare_parameter(name, rclcpp::ParameterValue(period));
    }
    period_ = rclcpp::Duration::from_seconds(base_->get_parameter(name).as_double());
    publisher_ = rclcpp::create_publisher<diagnostic_msgs::msg::DiagnosticArray>(base_, "/diagnostics", 1);
    reset_timer();
  }

  rclcpp::Duration getPeriod() const {return period_;}
  void setPeriod(rclcpp::Duration period)
  {
    period_ = period;
    reset_timer();
  }
  void setPeriod(double period) {setPeriod(rclcpp::Duration::from_seconds(period));}
  void force_update() {update();}
  /// Report the same of all tasks.
  void broadcast(unsigned char level, const std::string & text)
  {
    std::vector<diagnostic_msgs::msg::DiagnosticStatus> told;
    for (auto & task : getTasks()) {
      DiagnosticStatusWrapper status;
      status.name = task.getName();
      status.summary(level, text);
      told.push_back(status);
    }
    publish(told);
  }
  void setHardwareID(const std::string & id) {hardware_id_ = id;}
  void setHardwareIDf(const char * format, ...)
  {
    char text[1000];
    std::va_list words;
    va_start(words, format);
    std::vsnprintf(text, sizeof text, format, words);
    va_end(words);
    hardware_id_ = text;
  }

private:
  void reset_timer()
  {
    timer_ = rclcpp::create_timer(base_, base_->get_clock(), period_, [this] {update();});
  }
  void update()
  {
    warn_of_no_id();
    std::vector<diagnostic_msgs::msg::DiagnosticStatus> told;
    for (auto & task : getTasks()) {
      DiagnosticStatusWrapper status;
      status.summary(DiagnosticStatusWrapper::ERROR, "No message was set");
      status.hardware_id = hardware_id_;
      task.run(status);
      if (verbose_ && status.level) {
        RCLCPP_WARN(
          base_->get_logger(), "Non-zero diagnostic status. Name: '%s', status %i: '%s'", status.name.c_str(), status.level,
          status.message.c_str());
      }
      told.push_back(status);
    }
    publish(told);
  }
  void warn_of_no_id()
  {
    if (hardware_id_.empty() && !warned_) {
      RCLCPP_WARN(
        base_->get_logger(),
        "diagnostic_updater: No HW_ID was set. This is probably a bug. Please report it. For devices that do not have a HW_ID, "
        "set this value to 'none'. This warning only occurs once all diagnostics are OK. It is okay to wait until the device "
        "is open before calling setHardwareID.");
      warned_ = true;
    }
  }
  /// Their names begin with the node's.
  void publish(std::vector<diagnostic_msgs::msg::DiagnosticStatus> told)
  {
    diagnostic_msgs::msg::DiagnosticArray message;
    message.header.stamp = base_->get_clock()->now();
    for (auto & status : told) {
      status.name = std::string(base_->get_name()) + ": " + status.name;
    }
    message.status = std::move(told);
    publisher_->publish(message);
  }
  void addedTaskCallback(DiagnosticTaskInternal & task) override
  {
    DiagnosticStatusWrapper status;
    status.name = task.getName();
    status.summary(DiagnosticStatusWrapper::OK, "Node starting up");
    publish(std::vector<diagnostic_msgs::msg::DiagnosticStatus>{status});
  }

  Interface base_;
  rclcpp::Duration period_;
  rclcpp::Publisher<diagnostic_msgs::msg::DiagnosticArray>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
  std::string hardware_id_;
  bool warned_ = false;
};
}  // namespace diagnostic_updater
