#include <set>

#include "check.hpp"
#include "std_msgs/msg/int32.hpp"

using std_msgs::msg::Int32;

/// An executor of one's own: it counts what it runs.
class Counting : public rclcpp::Executor
{
public:
  void spin() override
  {
    if (spinning.exchange(true)) {
      throw std::runtime_error("spin() called while already spinning");
    }
    while (rclcpp::ok(context_) && spinning) {
      rclcpp::AnyExecutable next;
      if (get_next_executable(next)) {
        execute_any_executable(next);
        ++count;
      }
    }
    spinning = false;
  }
  using rclcpp::Executor::add_node;
  void add_node(std::shared_ptr<rclcpp::Node> node, bool notify = true) override
  {
    ++nodes;
    Executor::add_node(node, notify);
  }
  int nodes = 0;
  bool leave_one()
  {
    rclcpp::AnyExecutable next;
    while (!get_next_executable(next, 1s)) {}  // the cancel ends the first wait
    return true;
  }
  /// What the next callback tells of itself, before it runs.
  void look_at_next(const std::function<void (const rclcpp::AnyExecutable &)> & look)
  {
    rclcpp::AnyExecutable next;
    if (get_next_executable(next, 1s)) {
      look(next);
    }
    execute_any_executable(next);
  }
  int wait_once()
  {
    int before = count;
    spin_once_impl(20ms);
    spin_some_impl(20ms, true);
    return count - before;
  }
  bool run_ready()
  {
    wait_for_work(1s);
    rclcpp::AnyExecutable next;
    bool found = get_next_ready_executable(next);
    execute_any_executable(next);
    return found;
  }
  int count = 0;
};

static void of_ones_own()
{
  Counting counting;
  auto node = rclcpp::Node::make_shared("counted");
  int ticks = 0;
  auto timer = node->create_wall_timer(10ms, [&] {if (++ticks == 3) {counting.cancel();}});
  counting.add_node(node);
  equal("a node comes to the executor's own function", counting.nodes, 1);
  counting.spin();
  check("an executor of one's own runs callbacks", ticks == 3 && counting.count == 3);
  check("what it leaves is not run", counting.leave_one() && ticks == 3);
  check("and keeps nobody from running", counting.run_ready() && ticks == 4);
  check("it is not spinning any more", !counting.is_spinning());
  bool told = false;
  counting.look_at_next([&](const rclcpp::AnyExecutable & next) {
      told = next.timer == timer && !next.subscription && next.node_base == node->get_node_base_interface() &&
      next.callback_group == node->get_node_base_interface()->get_default_callback_group();
    });
  check("a callback tells whose timer it is", told);
  timer->cancel();
  std::string heard;
  auto subscription = node->create_subscription<Int32>("told", 10, [&](const Int32 & message) {heard += std::to_string(message.data);});
  auto publisher = node->create_publisher<Int32>("told", 10);
  publisher->publish(Int32().set__data(4));
  counting.look_at_next([&](const rclcpp::AnyExecutable & next) {heard = next.subscription == subscription ? "its" : "another's";});
  equal("and whose subscription", heard, std::string("its4"));
  check("a wait of one's own ends", counting.wait_once() == 0);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("busy");
  int ticks = 0;
  auto timer = node->create_wall_timer(10ms, [&] {++ticks;});
  rclcpp::executors::SingleThreadedExecutor single;
  single.add_node(node);
  throws<std::runtime_error>("added twice", [&] {single.add_node(node);});
  rclcpp::executors::SingleThreadedExecutor another;
  throws<std::runtime_error>("served by two", [&] {another.add_node(node);});
  throws<std::runtime_error>("removed where it is not", [&] {another.remove_node(node);});
  single.spin_once(1s);
  equal("spin_once runs one callback", ticks, 1);
  single.spin_once(0ns);
  check("spin_once may find nothing", ticks <= 2);
  rclcpp::sleep_for(20ms);
  int before = ticks;
  single.spin_some();
  equal("spin_some runs what is ready", ticks, before + 1);
  std::promise<int> promise;
  auto future = promise.get_future();
  auto fulfil = node->create_wall_timer(30ms, [&, done = false]() mutable {
      if (!done) {
        promise.set_value(4);
        done = true;
      }
    });
  check("until a future is ready", single.spin_until_future_complete(future, 5s) == rclcpp::FutureReturnCode::SUCCESS);
  equal("the future", future.get(), 4);
  std::promise<void> never;
  auto endless = never.get_future();
  check("a timeout", single.spin_until_future_complete(endless, 30ms) == rclcpp::FutureReturnCode::TIMEOUT);
  fulfil->cancel();
  auto watch = rclcpp::Node::make_shared("watch");  // it has nothing to do: only the cancel ends the wait
  rclcpp::executors::SingleThreadedExecutor idle;
  idle.add_node(watch);
  std::promise<void> other;
  auto kept = other.get_future().share();
  std::thread fulfilled([&] {
      rclcpp::sleep_for(30ms);
      other.set_value();
      idle.cancel();
    });
  check("cancel has a future looked at", idle.spin_until_future_complete(kept) == rclcpp::FutureReturnCode::SUCCESS);
  fulfilled.join();
  std::thread cancels([&] {
      rclcpp::sleep_for(30ms);
      idle.cancel();
    });
  check("or ends the wait", idle.spin_until_future_complete(endless) == rclcpp::FutureReturnCode::INTERRUPTED);
  cancels.join();
  check("not spinning", !single.is_spinning());
  auto stop = node->create_wall_timer(40ms, [&] {single.cancel();});
  single.spin();
  check("cancel ends spin", true);
  stop->cancel();
  bool nested = false;
  auto again = node->create_wall_timer(10ms, [&] {
      try {
        single.spin();
      } catch (const std::runtime_error & error) {
        nested = std::string(error.what()) == "spin() called while already spinning";
      }
      single.cancel();
    });
  single.spin();
  check("spin within spin", nested);
  again->cancel();
  single.remove_node(node);
  before = ticks;
  rclcpp::sleep_for(30ms);
  single.spin_some();
  equal("a node that was removed", ticks, before);
  rclcpp::spin_some(node);
  rclcpp::spin_some(std::make_unique<rclcpp::Node>("owned_by_the_spin"));
  check("the free function", ticks > before);
  timer->cancel();

  // several threads
  auto threaded = rclcpp::Node::make_shared("threaded");
  auto group = threaded->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  std::atomic<int> at_once{0}, most{0}, ended{0};
  std::mutex lock;
  std::set<std::thread::id> ids;
  auto work = [&] {
      most = std::max<int>(most, ++at_once);
      {
        std::lock_guard<std::mutex> hold(lock);
        ids.insert(std::this_thread::get_id());
      }
      rclcpp::sleep_for(50ms);
      --at_once;
      ++ended;
    };
  auto first = threaded->create_wall_timer(20ms, work, group);
  auto second = threaded->create_wall_timer(20ms, work, group);
  rclcpp::executors::MultiThreadedExecutor several(rclcpp::ExecutorOptions(), 4);
  equal("number of threads", several.get_number_of_threads(), 4u);
  several.add_node(threaded);
  auto enough = threaded->create_wall_timer(20ms, [&] {if (ended >= 4) {several.cancel();}});
  several.spin();
  check("a reentrant group runs beside itself", most >= 2, std::to_string(most));
  check("in several threads", ids.size() >= 2);
  several.remove_node(threaded);
  first->cancel();
  second->cancel();
  rclcpp::sleep_for(60ms);
  auto exclusive = rclcpp::Node::make_shared("exclusive");
  std::atomic<int> beside{0}, highest{0}, runs{0};  // of its own: the others' last callbacks may still run
  auto careful_work = [&] {
      highest = std::max<int>(highest, ++beside);
      rclcpp::sleep_for(30ms);
      --beside;
      ++runs;
    };
  auto one = exclusive->create_wall_timer(20ms, careful_work), two = exclusive->create_wall_timer(20ms, careful_work);
  rclcpp::executors::MultiThreadedExecutor careful(rclcpp::ExecutorOptions(), 4);
  careful.add_node(exclusive);
  auto done = exclusive->create_wall_timer(20ms, [&] {if (runs >= 4) {careful.cancel();}});
  careful.spin();
  equal("an exclusive group never does", highest.load(), 1);

  // groups of their own executors
  auto apart = rclcpp::Node::make_shared("apart");
  auto own = apart->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  check("a group may stay apart", !own->automatically_add_to_executor_with_node());
  int with_node = 0, with_group = 0;
  auto both = apart->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  rclcpp::executors::SingleThreadedExecutor with_one, with_all;
  with_one.add_callback_group(both, apart->get_node_base_interface());
  with_all.add_node(apart);
  equal("a group that an executor has does not come with its node",
    with_all.get_automatically_added_callback_groups_from_nodes().size(), 1u);
  with_all.remove_node(apart);
  with_one.remove_callback_group(both);
  auto usual = apart->create_wall_timer(10ms, [&] {++with_node;});
  auto special = apart->create_wall_timer(10ms, [&] {++with_group;}, own);
  check("the node's executor leaves it alone", spin_until(apart, [&] {return with_node > 3;}) && with_group == 0);
  rclcpp::executors::SingleThreadedExecutor of_group;
  of_group.add_callback_group(own, apart->get_node_base_interface());
  before = with_node;
  for (int i = 0; i < 3; ++i) {
    of_group.spin_once(1s);
  }
  check("its own serves it", with_group == 3 && with_node == before);

  // a node once
  auto lonely = rclcpp::Node::make_shared("lonely");
  int singles = 0;
  auto often = lonely->create_wall_timer(10ms, [&] {++singles;});
  rclcpp::executors::SingleThreadedExecutor briefly;
  briefly.spin_node_once(lonely);
  equal("a node is spun once", singles, 1);
  often->cancel();
  briefly.spin_node_once(lonely, 20ms);
  equal("or not within the time", singles, 1);

  // what a callback throws leaves through spin
  auto thrower = rclcpp::Node::make_shared("thrower");
  auto bad = thrower->create_wall_timer(10ms, [] {throw std::domain_error("from a callback");});
  throws<std::domain_error>("spin throws what a callback throws", [&] {rclcpp::spin(thrower);});
  bad->cancel();
  rclcpp::executors::StaticSingleThreadedExecutor fixed;
  int fixed_ticks = 0;
  auto node_of_fixed = rclcpp::Node::make_shared("fixed");
  auto tick = node_of_fixed->create_wall_timer(10ms, [&] {if (++fixed_ticks == 3) {fixed.cancel();}});
  fixed.add_node(node_of_fixed);
  fixed.spin();
  equal("the static executor", fixed_ticks, 3);
  throws<std::invalid_argument>("spin_all wants no negative time", [&] {fixed.spin_all(-1s);});

  {
    // groups
    auto grouped = rclcpp::Node::make_shared("grouped");
    auto base = grouped->get_node_base_interface();
    auto automatic = grouped->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    auto by_itself = grouped->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
    check("a group is its node's", base->callback_group_in_node(by_itself) && base->callback_group_in_node(automatic));
    check("and no other's", !node->get_node_base_interface()->callback_group_in_node(by_itself));
    rclcpp::executors::SingleThreadedExecutor holder, rival;
    holder.add_node(grouped);
    equal("groups that came with their node", holder.get_automatically_added_callback_groups_from_nodes().size(), 2u);
    holder.add_callback_group(by_itself, base);
    equal("groups that were added", holder.get_manually_added_callback_groups().size(), 1u);
    equal("all groups", holder.get_all_callback_groups().size(), 3u);
    throws<std::runtime_error>("a group served by two", [&] {rival.add_callback_group(by_itself, base);});
    holder.remove_callback_group(by_itself);
    throws<std::runtime_error>("a group removed twice", [&] {holder.remove_callback_group(by_itself);});
    rival.add_callback_group(by_itself, base);
    equal("a group moves", rival.get_all_callback_groups().size(), 1u);
  }
  of_ones_own();
  rclcpp::executors::SingleThreadedExecutor saving;
  saving.set_memory_strategy(rclcpp::memory_strategies::create_default_strategy());
  throws<std::runtime_error>("no strategy for memory", [&] {saving.set_memory_strategy(nullptr);});
  const std::vector<int> numbers{1, 2};
  equal("sums are at hand", std::accumulate(numbers.begin(), numbers.end(), 0), 3);
  rclcpp::shutdown();
  check("shutdown ends ok", !rclcpp::ok());
}
