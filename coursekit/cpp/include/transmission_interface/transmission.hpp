// What gears and linkages between actuators and joints have in common.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "transmission_interface/accessor.hpp"
#include "transmission_interface/handle.hpp"

namespace transmission_interface
{
class Transmission
{
public:
  virtual ~Transmission() = default;
  virtual void configure(const std::vector<JointHandle> & joint_handles, const std::vector<ActuatorHandle> & actuator_handles) = 0;
  virtual void actuator_to_joint() = 0;
  virtual void joint_to_actuator() = 0;
  virtual std::size_t num_actuators() const = 0;
  virtual std::size_t num_joints() const = 0;
};
using TransmissionSharedPtr = std::shared_ptr<Transmission>;

/// One of as many actuators as joints, for those of the positions, velocities and efforts that both sides have.
template<std::size_t N>
class CoursekitTransmission : public Transmission
{
public:
  using Numbers = std::array<double, N>;
  void configure(const std::vector<JointHandle> & joint_handles, const std::vector<ActuatorHandle> & actuator_handles) override
  {
    auto joints = names_of(joint_handles, "joint"), actuators = names_of(actuator_handles, "actuator");
    bool any = false;
    for (auto & kind : kinds_) {
      kind.joints = get_ordered_handles(joint_handles, joints, kind.name);
      kind.actuators = get_ordered_handles(actuator_handles, actuators, kind.name);
      check(kind.joints.size(), "joint", kind.name);
      check(kind.actuators.size(), "actuator", kind.name);
      any = any || kind.is_there();
    }
    if (!any) {
      throw Exception("None of the provided handles are valid or from the required interfaces.");
    }
  }
  void actuator_to_joint() override
  {
    for (auto & kind : kinds_) {
      if (kind.is_there()) {
        write(kind.joints, to_joints(kind.name, read(kind.actuators)));
      }
    }
  }
  void joint_to_actuator() override
  {
    for (auto & kind : kinds_) {
      if (kind.is_there()) {
        write(kind.actuators, to_actuators(kind.name, read(kind.joints)));
      }
    }
  }
  std::size_t num_actuators() const override {return N;}
  std::size_t num_joints() const override {return N;}

protected:
  virtual Numbers to_joints(const std::string & kind, const Numbers & actuators) const = 0;
  virtual Numbers to_actuators(const std::string & kind, const Numbers & joints) const = 0;
  static bool is_effort(const std::string & kind) {return kind == hardware_interface::HW_IF_EFFORT;}
  static bool is_position(const std::string & kind) {return kind == hardware_interface::HW_IF_POSITION;}

private:
  struct Kind
  {
    std::string name;
    std::vector<JointHandle> joints;
    std::vector<ActuatorHandle> actuators;
    bool is_there() const {return !joints.empty() && !actuators.empty();}
  };
  template<class T>
  static std::vector<std::string> names_of(const std::vector<T> & handles, const std::string & what)
  {
    if (handles.empty()) {
      throw Exception("No " + what + " handles were passed in");
    }
    auto names = get_names(handles);
    if (names.size() != N) {
      std::string number = N == 1 ? "one unique " + what + " name" : "two unique " + what + " names";
      throw Exception("There should be exactly " + number + " but was given '" + to_string(names) + "'.");
    }
    return names;
  }
  static void check(std::size_t size, const std::string & what, const std::string & kind)
  {
    if (size && size != N) {
      throw Exception("Not enough valid or required " + what + " " + kind + " handles were presented.");
    }
  }
  template<class T>
  static Numbers read(const std::vector<T> & handles)
  {
    Numbers numbers;
    std::transform(handles.begin(), handles.end(), numbers.begin(), [](const T & handle) {return handle.get_value();});
    return numbers;
  }
  template<class T>
  static void write(std::vector<T> & handles, const Numbers & numbers)
  {
    for (std::size_t i = 0; i < N; ++i) {
      handles[i].set_value(numbers[i]);
    }
  }

  std::array<Kind, 3> kinds_{{{hardware_interface::HW_IF_POSITION, {}, {}}, {hardware_interface::HW_IF_VELOCITY, {}, {}},
    {hardware_interface::HW_IF_EFFORT, {}, {}}}};
};

/// Two actuators with reductions, and two joints with reductions and offsets.
class CoursekitPair : public CoursekitTransmission<2>
{
public:
  CoursekitPair(
    const std::vector<double> & actuator_reduction, const std::vector<double> & joint_reduction,
    const std::vector<double> & joint_offset = {0.0, 0.0})
  : actuator_reduction_(actuator_reduction), joint_reduction_(joint_reduction), joint_offset_(joint_offset)
  {
    if (actuator_reduction_.size() != 2 || joint_reduction_.size() != 2 || joint_offset_.size() != 2) {
      throw Exception("Reduction and offset vectors must have size 2.");
    }
    if (!(actuator_reduction_[0] && actuator_reduction_[1] && joint_reduction_[0] && joint_reduction_[1])) {
      throw Exception("Transmission reduction ratios cannot be zero.");
    }
  }
  const std::vector<double> & get_actuator_reduction() const {return actuator_reduction_;}
  const std::vector<double> & get_joint_reduction() const {return joint_reduction_;}
  const std::vector<double> & get_joint_offset() const {return joint_offset_;}

protected:
  /// Joints' positions without, or (`sign` 1) with, their offsets; other numbers as they are.
  Numbers offset(const std::string & kind, Numbers joints, int sign) const
  {
    for (std::size_t i = 0; i < 2 && is_position(kind); ++i) {
      joints[i] += sign * joint_offset_[i];
    }
    return joints;
  }
  std::vector<double> actuator_reduction_, joint_reduction_, joint_offset_;
};
}  // namespace transmission_interface
