// The filters that come with the package filters, alone and in chains that find them by their names.
#include "check.hpp"
#include "filters/filter_chain.hpp"
#include "filters/increment.hpp"
#include "filters/mean.hpp"
#include "filters/median.hpp"
#include "filters/param_test.hpp"
#include "filters/transfer_function.hpp"

using Numbers = std::vector<double>;

static rclcpp::Node::SharedPtr node;
template<class Filter>
static bool configure(Filter & filter, const std::string & prefix)
{
  return filter.configure(prefix, "mine", node->get_node_logging_interface(), node->get_node_parameters_interface());
}
static double last_of(filters::FilterBase<double> & filter, const Numbers & all)
{
  double out = -1;
  for (double one : all) {
    if (!filter.update(one, out)) {
      return -99;
    }
  }
  return out;
}
static bool near(const Numbers & a, const Numbers & b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {return std::abs(x - y) < 1e-9;});
}

static void alone()
{
  filters::MeanFilter<double> mean;
  filters::FilterBase<double> & any = mean;
  check("a mean needs to know of how many", !configure(any, "nothing"));
  check("what is not configured does nothing", last_of(any, {1}) == -99);
  check("three of them", configure(any, "three"));
  equal("the mean of less than these", last_of(any, {4, 6}), 5.0);
  equal("the mean of the last", last_of(any, {8, 10}), 8.0);
  filters::MedianFilter<double> median;
  configure(static_cast<filters::FilterBase<double> &>(median), "four");
  equal("the smaller of the middle two", last_of(median, {9, 1, 7, 3}), 3.0);
  equal("the first has gone", last_of(median, {2}), 2.0);
  filters::IncrementFilter<int> increment;
  int more = 0;
  check("one more", increment.update(41, more) && more == 42);
  filters::ParamTest<double> told;
  configure(static_cast<filters::FilterBase<double> &>(told), "told");
  equal("a parameter's value", last_of(told, {1, 2}), 6.5);
  filters::SingleChannelTransferFunctionFilter<double> smooth;
  filters::FilterBase<double> & equation = smooth;
  check("numbers of what came out are missing", !configure(equation, "half_told"));
  check("nothing is divided by 0", !configure(equation, "by_zero"));
  check("all numbers", configure(equation, "smooth"));
  // 2 y[n] = 1 x[n] + 3 x[n-1] - 1 y[n-1]: 4 gives 2, then 0 gives 6 - 1
  equal("a step of the equation", last_of(equation, {4}), 2.0);
  equal("with what was before", last_of(equation, {0}), 5.0);
}
static void channels()
{
  filters::MultiChannelMeanFilter<double> mean;
  filters::MultiChannelFilterBase<double> & any = mean;
  any.configure(2, "three", "mine", node->get_node_logging_interface(), node->get_node_parameters_interface());
  Numbers out(2);
  check("channels apart", any.update({1, 10}, out) && any.update({3, 30}, out) && near(out, {2, 20}));
  Numbers few(1);
  check("another number of channels", !any.update({1}, few) && !any.update({1, 2}, few));
  double one = 0;
  check("not one channel", !any.update(1.0, one));
  filters::RealtimeCircularBuffer<int> row(2, 7);
  check("it is full from the beginning, but counts none", row.size() == 0 && !row.empty() && row.front() == 7);
  row.push_back(1);
  row.push_back(2);
  row.push_back(3);
  check("the oldest goes", row.size() == 2 && row.at(0) == 2 && row.back() == 3);
  row.push_front(9);
  check("the last goes", row[0] == 9 && row[1] == 2);
}
static void in_chains()
{
  filters::MultiChannelFilterChain<double> chain("double");
  auto log = node->get_node_logging_interface();
  check("a chain knows them", chain.configure(2, "chain", log, node->get_node_parameters_interface()));
  Numbers out(2);
  chain.update({2, 4}, out);
  check("one behind the other", chain.update({4, 0}, out) && near(out, {3, 2}));
  filters::FilterChain<int> counts("int");
  check("also of whole numbers", counts.configure("count", log, node->get_node_parameters_interface()));
  int more = 0;
  check("two more", counts.update(1, more) && more == 3);
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  node = rclcpp::Node::make_shared(
    "own_filters", rclcpp::NodeOptions().parameter_overrides(
      {{"three.number_of_observations", 3}, {"four.number_of_observations", 4}, {"told.key", 6.5},
        {"half_told.b", Numbers{1}}, {"by_zero.a", Numbers{0, 1}}, {"by_zero.b", Numbers{1}},
        {"smooth.a", Numbers{2, 1}}, {"smooth.b", Numbers{1, 3}},
        {"chain.filter1.name", "middle"}, {"chain.filter1.type", "filters/MultiChannelMedianFilterDouble"},
        {"chain.filter1.params.number_of_observations", 1},
        {"chain.filter2.name", "mean"}, {"chain.filter2.type", "filters/MultiChannelMeanFilterDouble"},
        {"chain.filter2.params.number_of_observations", 2},
        {"count.filter1.name", "once"}, {"count.filter1.type", "filters/IncrementFilterInt"},
        {"count.filter2.name", "again"}, {"count.filter2.type", "filters/IncrementFilterInt"}}));
  alone();
  channels();
  in_chains();
  node.reset();
  rclcpp::shutdown();
}
