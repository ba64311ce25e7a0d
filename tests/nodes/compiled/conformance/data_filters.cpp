// The package filters: filters that parameters configure, alone and in chains.
#include <numeric>

#include "check.hpp"
#include "filters/filter_chain.hpp"

/// Multiplies by a factor, which must be set.
class Gain : public filters::FilterBase<double>
{
public:
  bool update(const double & data_in, double & data_out) override
  {
    data_out = data_in * factor;
    return times > 0;
  }
  bool configure() override
  {
    getParam("times", times);
    return getParam("factor", factor);
  }
  using FilterBase::configure;
  double factor = 0;
  unsigned int times = 3;
};
/// Gives each channel the sum of all.
class Sum : public filters::MultiChannelFilterBase<double>
{
public:
  bool update(const std::vector<double> & data_in, std::vector<double> & data_out) override
  {
    data_out.assign(number_of_channels_, std::accumulate(data_in.begin(), data_in.end(), 0.0));
    return true;
  }
  bool configure() override {return true;}
  using MultiChannelFilterBase::configure;
  using MultiChannelFilterBase::update;
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto options = rclcpp::NodeOptions().parameter_overrides(
    {{"gain.factor", 2.5}, {"gain.times", -1}, {"odd.filter1.name", "first"}, {"one.filter1.name", "a"},
      {"one.filter1.type", "no_slash"}});
  auto node = rclcpp::Node::make_shared("filtering", options);
  auto log = node->get_node_logging_interface();
  auto parameters = node->get_node_parameters_interface();

  Gain gain;
  check("configured by parameters", gain.configure("gain", "louder", log, parameters));
  double out = 0;
  check("it filters", gain.update(4.0, out) && out == 10.0);
  equal("its name", gain.getName(), "louder");
  equal("no negative count", gain.times, 3u);
  check("what is not set leaves it unconfigured", !gain.configure("other.", "quiet", log, parameters));
  equal("and its value as it was", gain.factor, 2.5);
  throws<std::runtime_error>("it needs parameters", [&] {gain.configure("gain", "louder", log, nullptr);});

  Sum sum;
  std::vector<double> outs;
  check("several channels", sum.configure(2, "sum", "sum", log, parameters) && sum.update({1.0, 2.0}, outs) && outs[1] == 3.0);
  check("not one at a time", !sum.update(1.0, out));

  filters::FilterChain<double> chain("double");
  check("a chain of none", chain.configure("empty", log, parameters) && chain.update(7.0, out) && out == 7.0);
  check("only once", !chain.configure("empty", log, parameters));
  check("until it is cleared", chain.clear() && chain.configure("empty", log, parameters));
  chain.clear();
  check("a name needs a type", !chain.configure("odd", log, parameters));
  check("a type needs a package", !chain.configure("one", log, parameters));
  filters::MultiChannelFilterChain<double> several("double");
  check("a chain of channels", several.configure(2, "", log, parameters) && several.update({1.0, 2.0}, outs) && outs[0] == 1.0);
  rclcpp::shutdown();
}
