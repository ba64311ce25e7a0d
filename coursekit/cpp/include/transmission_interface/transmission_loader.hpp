// Transmissions as a robot's description has them.
#pragma once
#include <memory>

#include "hardware_interface/hardware_info.hpp"
#include "rclcpp/logging.hpp"
#include "transmission_interface/differential_transmission.hpp"
#include "transmission_interface/four_bar_linkage_transmission.hpp"
#include "transmission_interface/simple_transmission.hpp"

namespace transmission_interface
{
class TransmissionLoader
{
public:
  virtual ~TransmissionLoader() = default;
  /// The transmission; nothing where its numbers are wrong.
  virtual std::shared_ptr<Transmission> load(const hardware_interface::TransmissionInfo & transmission_info) = 0;

protected:
  template<class F>
  std::shared_ptr<Transmission> made(const char * name, F make)
  {
    try {
      return make();
    } catch (const std::exception & error) {
      RCLCPP_ERROR(rclcpp::get_logger(name), "Failed to construct transmission '%s'", error.what());
      return nullptr;
    }
  }
};
using TransmissionLoaderSharedPtr = std::shared_ptr<TransmissionLoader>;

class SimpleTransmissionLoader : public TransmissionLoader
{
public:
  std::shared_ptr<Transmission> load(const hardware_interface::TransmissionInfo & info) override
  {
    return made("simple_transmission_loader", [&] {
               return std::make_shared<SimpleTransmission>(info.joints.at(0).mechanical_reduction, info.joints.at(0).offset);
             });
  }
};

template<class T>
class CoursekitPairLoader : public TransmissionLoader
{
public:
  std::shared_ptr<Transmission> load(const hardware_interface::TransmissionInfo & info) override
  {
    // Humble's loader of differentials logs under this name, too.
    return made("four_bar_linkage_transmission_loader", [&] {
               const auto & a = info.actuators.at(0), & b = info.actuators.at(1);
               const auto & j = info.joints.at(0), & k = info.joints.at(1);
               return std::make_shared<T>(
                 std::vector<double>{a.mechanical_reduction, b.mechanical_reduction},
                 std::vector<double>{j.mechanical_reduction, k.mechanical_reduction}, std::vector<double>{j.offset, k.offset});
             });
  }
};
class DifferentialTransmissionLoader : public CoursekitPairLoader<DifferentialTransmission> {};
class FourBarLinkageTransmissionLoader : public CoursekitPairLoader<FourBarLinkageTransmission> {};
}  // namespace transmission_interface
