// A PID controller. Times are nanoseconds.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "realtime_tools/realtime_buffer.h"

namespace control_toolbox
{
class Pid
{
public:
  struct Gains
  {
    Gains() = default;
    Gains(double p, double i, double d, double i_max, double i_min, bool antiwindup = false)
    : p_gain_(p), i_gain_(i), d_gain_(d), i_max_(i_max), i_min_(i_min), antiwindup_(antiwindup) {}
    double p_gain_ = 0, i_gain_ = 0, d_gain_ = 0, i_max_ = 0, i_min_ = 0;
    /// Whether the integrated error stays within the limits too, beside what it adds to the command.
    bool antiwindup_ = false;
  };

  explicit Pid(
    double p = 0.0, double i = 0.0, double d = 0.0, double i_max = 0.0, double i_min = -0.0, bool antiwindup = false)
  {
    initPid(p, i, d, i_max, i_min, antiwindup);
  }
  Pid(const Pid & source)
  {
    gains_ = source.gains_;
    reset();
  }
  Pid & operator=(const Pid & source)
  {
    if (this != &source) {
      gains_ = source.gains_;
      reset();
    }
    return *this;
  }
  void initPid(double p, double i, double d, double i_max, double i_min, bool antiwindup = false)
  {
    gains_.initRT(checked(Gains(p, i, d, i_max, i_min, antiwindup)));
    reset();
  }
  void reset() {p_error_last_ = p_error_ = i_error_ = d_error_ = cmd_ = 0;}
  Gains getGains() {return *gains_.readFromRT();}
  void getGains(double & p, double & i, double & d, double & i_max, double & i_min)
  {
    bool antiwindup;
    getGains(p, i, d, i_max, i_min, antiwindup);
  }
  void getGains(double & p, double & i, double & d, double & i_max, double & i_min, bool & antiwindup)
  {
    const Gains gains = getGains();
    p = gains.p_gain_;
    i = gains.i_gain_;
    d = gains.d_gain_;
    i_max = gains.i_max_;
    i_min = gains.i_min_;
    antiwindup = gains.antiwindup_;
  }
  void setGains(double p, double i, double d, double i_max, double i_min, bool antiwindup = false)
  {
    setGains(Gains(p, i, d, i_max, i_min, antiwindup));
  }
  void setGains(const Gains & gains) {gains_.writeFromNonRT(checked(gains));}

  /// The command for an error that lasted so long; its rate is that since the last call.
  double computeCommand(double error, uint64_t dt)
  {
    if (dt == 0 || !std::isfinite(error)) {
      return 0.0;
    }
    const double rate = (error - p_error_last_) / (static_cast<double>(dt) / 1e9);
    p_error_last_ = error;
    return computeCommand(error, rate, dt);
  }
  double computeCommand(double error, double error_dot, uint64_t dt)
  {
    p_error_ = error;
    d_error_ = error_dot;
    if (dt == 0 || !std::isfinite(error) || !std::isfinite(error_dot)) {
      return 0.0;
    }
    const Gains gains = getGains();
    i_error_ += static_cast<double>(dt) / 1e9 * error;
    if (gains.antiwindup_ && gains.i_gain_ != 0) {
      const auto bounds = std::minmax(gains.i_min_ / gains.i_gain_, gains.i_max_ / gains.i_gain_);
      i_error_ = std::min(std::max(i_error_, bounds.first), bounds.second);
    }
    double integral = gains.i_gain_ * i_error_;
    if (!gains.antiwindup_) {
      integral = std::min(std::max(integral, gains.i_min_), gains.i_max_);
    }
    return cmd_ = gains.p_gain_ * error + integral + gains.d_gain_ * error_dot;
  }
  void setCurrentCmd(double cmd) {cmd_ = cmd;}
  double getCurrentCmd() {return cmd_;}
  double getDerivativeError() {return d_error_;}
  void getCurrentPIDErrors(double & pe, double & ie, double & de)
  {
    pe = p_error_;
    ie = i_error_;
    de = d_error_;
  }

private:
  static const Gains & checked(const Gains & gains)
  {
    if (gains.i_min_ > gains.i_max_) {
      throw std::invalid_argument("received i_min > i_max");
    }
    return gains;
  }
  realtime_tools::RealtimeBuffer<Gains> gains_;
  double p_error_last_ = 0, p_error_ = 0, i_error_ = 0, d_error_ = 0, cmd_ = 0;
};
}  // namespace control_toolbox
