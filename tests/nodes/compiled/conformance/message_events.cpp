// message_filters: what callbacks of any kind get of a message, and what a policy of a program's own is told.
#include "check.hpp"
#include "message_filters/cache.h"
#include "message_filters/chain.h"
#include "message_filters/signal1.h"
#include "message_filters/sync_policies/exact_time.h"
#include "message_filters/sync_policies/latest_time.h"
#include "message_filters/time_sequencer.h"
#include "message_filters/time_synchronizer.h"
#include "rosgraph_msgs/msg/clock.hpp"

using std::placeholders::_1;
using std::placeholders::_2;
using message_filters::MessageEvent;

/// A message that no middleware knows; its time is that of a computer's clock.
struct Reading
{
  rclcpp::Time taken{0, 0, RCL_SYSTEM_TIME};
  int value = 0;
};
using ReadingPtr = std::shared_ptr<Reading>;
using ReadingConstPtr = std::shared_ptr<const Reading>;
namespace message_filters::message_traits
{
template<>
struct TimeStamp<Reading>
{
  static rclcpp::Time value(const Reading & one) {return one.taken;}
};
}  // namespace message_filters::message_traits

static ReadingPtr reading(int value, int64_t nanoseconds = 0)
{
  auto one = std::make_shared<Reading>();
  one->value = value;
  one->taken = rclcpp::Time(nanoseconds, RCL_SYSTEM_TIME);
  return one;
}

class Source : public message_filters::SimpleFilter<Reading>
{
public:
  void give(const EventType & event) {signalMessage(event);}
};
/// Adds up what it is called with, whatever way.
struct Adder
{
  void by_const_pointer(const ReadingConstPtr & one) {sum += one->value;}
  void by_pointer(ReadingPtr one) {sum += one->value++;}
  void by_reference(const Reading & one) {sum += one.value;}
  void by_value(Reading one) {sum += one.value++;}
  void by_event(const MessageEvent<Reading const> & one) {sum += one.getMessage()->value;}
  void by_own_event(const MessageEvent<Reading> & one) {sum += one.getMessage()->value++;}
  int sum = 0;
};

static void events()
{
  const rclcpp::Time then(7, 0, RCL_SYSTEM_TIME);
  auto one = reading(1);
  MessageEvent<Reading const> event(one, then);
  check("an event is of its message", event.getMessage() == one && event.getReceiptTime() == then);
  check("one that only reads does not copy", !event.getMessageWillCopy() && event.nonConstWillCopy());
  MessageEvent<Reading> own(event);
  check("who may change it gets a copy", own.getMessageWillCopy() && own.getMessage() != one && own.getMessage()->value == 1);
  check("always the same copy", own.getMessage() == own.getMessage());
  MessageEvent<Reading> only(event, false);
  check("where nobody else has it, it is the message", only.getMessage() == one);
  check("events are compared", own != only && MessageEvent<Reading const>(one, then) == event && !(event < event));
  auto made = std::make_shared<Reading>();
  MessageEvent<Reading> filled(one, then, true, [&] {return made;});
  check("a copy is made where it is wanted", filled.getMessage() == made && made->value == 1);
}
static void callbacks()
{
  Source source;
  Adder adder;
  source.registerCallback(std::bind(&Adder::by_const_pointer, &adder, _1));
  source.registerCallback<ReadingPtr>(std::bind(&Adder::by_pointer, &adder, _1));
  source.registerCallback<const ReadingPtr &>(std::bind(&Adder::by_pointer, &adder, _1));
  source.registerCallback<const Reading &>(std::bind(&Adder::by_reference, &adder, _1));
  source.registerCallback<Reading>(std::bind(&Adder::by_value, &adder, _1));
  source.registerCallback<const MessageEvent<Reading const> &>(std::bind(&Adder::by_event, &adder, _1));
  source.registerCallback(&Adder::by_own_event, &adder);
  auto connection = source.registerCallback([&](const MessageEvent<Reading const> & one) {adder.sum += 100 * one.getMessage()->value;});
  auto given = reading(2);
  source.give(ReadingConstPtr(given));
  equal("each is called, in its way", adder.sum, 7 * 2 + 200);
  equal("nobody has changed it for others", given->value, 2);
  connection.disconnect();
  source.give(ReadingConstPtr(given));
  equal("one less", adder.sum, 14 * 2 + 200);
  Source alone;
  alone.registerCallback(&Adder::by_pointer, &adder);
  alone.give(MessageEvent<Reading const>(given, rclcpp::Time(), false, message_filters::DefaultMessageCreator<Reading>()));
  equal("the only one may change what nobody else has", given->value, 3);
  message_filters::Signal1<Reading> signal;
  auto helper = signal.addCallback<const Reading &>([&](const Reading & one) {adder.sum = one.value;});
  signal.call(ReadingConstPtr(reading(5)));
  equal("a signal by itself", adder.sum, 5);
  signal.removeCallback(helper);
  signal.call(ReadingConstPtr(reading(6)));
  equal("without its callback", adder.sum, 5);
}
/// A policy that counts what comes, and gives a set with each third message.
template<class M0, class M1, class M2 = message_filters::NullType>
struct EachThird : message_filters::PolicyBase<M0, M1, M2>
{
  using Sync = message_filters::Synchronizer<EachThird>;
  using Super = message_filters::PolicyBase<M0, M1, M2>;
  using typename Super::Events;
  using typename Super::Messages;
  using typename Super::RealTypeCount;
  using typename Super::Signal;
  void initParent(Sync * parent) {parent_ = parent;}
  template<int i>
  void add(const std::tuple_element_t<i, Events> & event)
  {
    std::get<i>(events_) = event;
    if (++count % 3 == 0) {
      std::apply([this](const auto & ... one) {parent_->signal(one ...);}, events_);
    }
  }
  int count = 0;

private:
  Sync * parent_ = nullptr;
  Events events_;
};
static int called = 0;
static void two(const ReadingConstPtr & one, const MessageEvent<Reading const> & other)
{
  called = one->value * 10 + other.getMessage()->value;
}
static void three(ReadingConstPtr one, const ReadingPtr & other, Reading last) {called = one->value * 100 + other->value * 10 + last.value;}
static void policies()
{
  using Third = message_filters::Synchronizer<EachThird<Reading, Reading>>;
  message_filters::NullFilter<Reading> nothing, nowhere;
  Third third(nothing, nowhere);
  equal("two inputs, not nine", int(Third::RealTypeCount::value), 2);
  auto connection = third.registerCallback(two);
  third.add<0>(reading(1));
  third.add<1>(reading(2));
  equal("a policy of one's own waits", called, 0);
  third.add<0>(reading(3));
  equal("and calls", called, 32);
  connection.disconnect();
  third.registerCallback(std::bind(two, _2, _1));
  third.add<1>(reading(4));
  third.add<1>(reading(5));
  third.add<0>(reading(6));
  equal("by a binding that turns them round", called, 56);

  message_filters::Synchronizer<message_filters::sync_policies::ExactTime<Reading, Reading, Reading>> exact(1);
  exact.registerCallback(three);
  int dropped = 0;
  exact.getPolicy()->registerDropCallback(std::bind([&] {++dropped;}));
  exact.add<0>(reading(1, 10));
  exact.add<1>(reading(2, 10));
  exact.add<2>(reading(3, 10));
  equal("three of one time", called, 123);
  exact.add<0>(reading(1, 20));
  exact.add<1>(reading(1, 30));
  equal("what is given up is told", dropped, 1);
  message_filters::TimeSynchronizer<Reading, Reading> both(5);
  int64_t received = 0;
  both.registerCallback(
    std::function<void (const MessageEvent<Reading const> &, const Reading &)>(
      [&](const MessageEvent<Reading const> & one, const Reading &) {received = one.getReceiptTime().nanoseconds();}));
  both.add<0>(MessageEvent<Reading const>(reading(1, 5), rclcpp::Time(int64_t(99), RCL_SYSTEM_TIME)));
  both.add1(reading(2, 5));
  equal("an event goes through with its time", received, 99);
}
static void through_filters()
{
  const MessageEvent<Reading const> event(reading(4, 40), rclcpp::Time(int64_t(123), RCL_SYSTEM_TIME));
  message_filters::Cache<Reading> first(3), second(first, 3);
  int64_t received = 0;
  auto hear = [&](const MessageEvent<Reading const> & one) {received = one.getReceiptTime().nanoseconds();};
  second.registerCallback(hear);
  first.add(event);
  equal("through a cache", received, 123);
  message_filters::Chain<Reading> chain;
  chain.addFilter(std::make_shared<message_filters::PassThrough<Reading>>());
  received = 0;
  chain.registerCallback(hear);
  chain.add(event);
  equal("through a chain", received, 123);
  auto node = rclcpp::Node::make_shared("through");
  message_filters::TimeSequencer<Reading> sequencer(rclcpp::Duration(0, 1000), rclcpp::Duration(0, 1000000), 5, node);
  received = 0;
  sequencer.registerCallback(hear);
  sequencer.add(event);
  check("through a sequencer, stamped by any clock", spin_until(node, [&] {return received == 123;}));
}
static void latest()
{
  auto node = rclcpp::Node::make_shared("latest", rclcpp::NodeOptions().parameter_overrides({{"use_sim_time", true}}));
  auto clock = node->create_publisher<rosgraph_msgs::msg::Clock>("/clock", rclcpp::ClockQoS());
  message_filters::Synchronizer<message_filters::sync_policies::LatestTime<Reading, Reading>> sync;
  sync.setClock(node->get_clock());
  called = 0;
  sync.registerCallback(two);
  auto at = [&](int milliseconds) {
      rosgraph_msgs::msg::Clock time;
      time.clock = rclcpp::Time(RCL_MS_TO_NS(milliseconds));
      clock->publish(time);
      spin_until(node, [&] {return node->now().nanoseconds() == RCL_MS_TO_NS(milliseconds);});
    };
  at(100);
  sync.add<0>(reading(1));
  sync.add<1>(reading(1));
  equal("no rate is known yet", called, 0);
  at(110);
  sync.add<0>(reading(2));
  equal("the fast one is", called, 21);
  at(120);
  sync.add<1>(reading(2));
  equal("the slow one does not lead", called, 21);
  sync.add<0>(reading(3));
  equal("it comes with the fast one", called, 32);
  at(140);
  sync.add<1>(reading(3));
  equal("what leads is late: another leads", called, 33);
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  events();
  callbacks();
  policies();
  through_filters();
  latest();
  rclcpp::shutdown();
}
