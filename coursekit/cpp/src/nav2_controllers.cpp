// Controllers and their checkers: controller_server asks, their classes do.
#include "coursekit/nav2.hpp"
#include "coursekit/plugins.hpp"
#include "nav2_core/controller.hpp"
#include "nav2_core/exceptions.hpp"
#include "nav2_core/progress_checker.hpp"

namespace nav2_core
{
using coursekit::Nav2Plugin;
using coursekit::Packer;
using coursekit::Unpacker;
using geometry_msgs::msg::Pose;
using geometry_msgs::msg::PoseStamped;
using geometry_msgs::msg::Twist;

namespace
{
/// The server's goal checker, which has its class elsewhere: a function of the server's answers for it.
class LentGoalChecker : public GoalChecker
{
public:
  explicit LentGoalChecker(int64_t function)
  : function_(function) {}
  void initialize(
    const rclcpp_lifecycle::LifecycleNode::WeakPtr &, const std::string &,
    const std::shared_ptr<nav2_costmap_2d::Costmap2DROS>) override {}
  void reset() override {ask(Packer{}.s("reset"));}
  bool isGoalReached(const Pose & query_pose, const Pose & goal_pose, const Twist & velocity) override
  {
    return ask(Packer{}.s("reached").m(query_pose).m(goal_pose).m(velocity)).i();
  }
  bool getTolerances(Pose & pose_tolerance, Twist & vel_tolerance) override
  {
    Unpacker answer = ask(Packer{}.s("tolerances"));
    const bool known = answer.i();
    pose_tolerance = answer.m<Pose>();
    vel_tolerance = answer.m<Twist>();
    return known;
  }

private:
  Unpacker ask(const Packer & what) const
  {
    return coursekit::request("shared_call", Packer{}.i(function_).raw(what.bytes.data(), what.bytes.size()));
  }
  int64_t function_;
};

/// A PlannerException, also one derived from it, has its own name: the server may try again after it.
const char * fault_name(const std::exception & error)
{
  return dynamic_cast<const PlannerException *>(&error) ? "nav2_core::PlannerException" : coursekit::type_name(error);
}

void serve(Nav2Plugin<Controller> & host, Unpacker & from, Packer & done)
{
  const std::string what = from.s();
  if (what == "follow") {
    host.plugin->setPlan(from.m<nav_msgs::msg::Path>());
  } else if (what == "limit") {
    const double limit = from.d();
    host.plugin->setSpeedLimit(limit, from.i());
  } else if (what == "velocity") {
    host.costmap->renew(from);
    const auto pose = from.m<PoseStamped>();
    const auto velocity = from.m<Twist>();
    LentGoalChecker checker(from.i());
    done.m(host.plugin->computeVelocityCommands(pose, velocity, &checker));
  } else if (what == "configure") {
    host.configure(from);
  } else {
    host.change(what);
  }
}
void serve(Nav2Plugin<GoalChecker> & host, Unpacker & from, Packer & done)
{
  const std::string what = from.s();
  if (what == "make") {
    host.make();
  } else if (what == "configure") {
    host.meet(from);
    host.plugin->initialize(host.node, host.name, host.costmap);
  } else if (what == "reset") {
    host.plugin->reset();
  } else if (what == "reached") {
    const auto here = from.m<Pose>(), goal = from.m<Pose>();
    done.i(host.plugin->isGoalReached(here, goal, from.m<Twist>()));
  } else if (what == "tolerances") {
    Pose pose;
    Twist velocity;
    done.i(host.plugin->getTolerances(pose, velocity)).m(pose).m(velocity);
  }
}
void serve(Nav2Plugin<ProgressChecker> & host, Unpacker & from, Packer & done)
{
  const std::string what = from.s();
  if (what == "make") {
    host.make();
  } else if (what == "configure") {
    host.meet(from);
    host.plugin->initialize(host.node, host.name);
  } else if (what == "reset") {
    host.plugin->reset();
  } else if (what == "check") {
    auto pose = from.m<PoseStamped>();
    done.i(host.plugin->check(pose));
  }
}
template<class Base>
coursekit::Handler handler_of(const std::string & type)
{
  auto host = std::make_shared<Nav2Plugin<Base>>(type);
  return [host](Unpacker & from, Packer & to) {coursekit::careful(to, [&](Packer & done) {serve(*host, from, done);}, fault_name);};
}
}  // namespace
}  // namespace nav2_core

coursekit::Handler coursekit::path_controller_of(const std::string & type)
{
  return nav2_core::handler_of<nav2_core::Controller>(type);
}
coursekit::Handler coursekit::goal_checker_of(const std::string & type)
{
  return nav2_core::handler_of<nav2_core::GoalChecker>(type);
}
coursekit::Handler coursekit::progress_checker_of(const std::string & type)
{
  return nav2_core::handler_of<nav2_core::ProgressChecker>(type);
}
