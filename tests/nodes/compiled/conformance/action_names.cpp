// What rcl_action and rcl_lifecycle have for programs in C: names of services, kinds of states, and errors for what is none.
#include "check.hpp"
#include "rcl_action/default_qos.h"
#include "rcl_action/names.h"
#include "rcl_action/types.h"
#include "rcl_lifecycle/rcl_lifecycle.h"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

using Get = rcl_ret_t (*)(const char *, rcl_allocator_t, char **);

static std::string name_of(Get get, const char * action)
{
  rcl_allocator_t allocator = rcl_get_default_allocator();
  char * name = nullptr;
  rcl_ret_t code = get(action, allocator, &name);
  std::string text = code == RCL_RET_OK ? name : std::to_string(code);
  allocator.deallocate(name, allocator.state);
  rcl_reset_error();
  return text;
}
static rcl_ret_t code_of(const char * action, rcl_allocator_t allocator, char ** name)
{
  rcl_ret_t code = rcl_action_get_goal_service_name(action, allocator, name);
  rcl_reset_error();
  return code;
}
static bool refused(std::function<void()> make)
{
  try {
    make();
  } catch (const std::runtime_error &) {
    return true;
  }
  return false;
}

static void names()
{
  check("the service of goals", name_of(rcl_action_get_goal_service_name, "go") == "go/_action/send_goal");
  check("the service of cancels", name_of(rcl_action_get_cancel_service_name, "/a/go") == "/a/go/_action/cancel_goal");
  check("the service of results", name_of(rcl_action_get_result_service_name, "go") == "go/_action/get_result");
  check("the topic of feedback", name_of(rcl_action_get_feedback_topic_name, "go") == "go/_action/feedback");
  check("the topic of states", name_of(rcl_action_get_status_topic_name, "go") == "go/_action/status");
  char * name = nullptr;
  char taken_text[] = "taken", * taken = taken_text;
  rcl_allocator_t allocator = rcl_get_default_allocator(), none = rcutils_get_zero_initialized_allocator();
  check("an empty action has none", code_of("", allocator, &name) == RCL_RET_ACTION_NAME_INVALID);
  check("no action has none", code_of(nullptr, allocator, &name) == RCL_RET_INVALID_ARGUMENT);
  check("it has to go somewhere", code_of("go", allocator, nullptr) == RCL_RET_INVALID_ARGUMENT);
  check("nothing is overwritten", code_of("go", allocator, &taken) == RCL_RET_INVALID_ARGUMENT);
  check("memory is needed", code_of("go", none, &name) == RCL_RET_INVALID_ARGUMENT && name == nullptr);
}

static void goals()
{
  const rmw_qos_profile_t & qos = rcl_action_qos_profile_status_default;
  check("late ones get the states of goals", qos.durability == RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL && qos.depth == 1);
  check("all of them", qos.reliability == RMW_QOS_POLICY_RELIABILITY_RELIABLE);
  rclcpp_action::GoalUUID number{1, 2, 3}, back{};
  rcl_action_goal_info_t info = rcl_action_get_zero_initialized_goal_info();
  check("a number has sixteen bytes", UUID_SIZE == number.size() && info.goal_id.uuid[UUID_SIZE - 1] == 0);
  rclcpp_action::convert(number, &info);
  rclcpp_action::convert(info, &back);
  check("a goal's number goes there and back", back == number && info.goal_id.uuid[2] == 3);
}

static void states()
{
  std::string label = "far";
  rcl_lifecycle_state_t place = {label.c_str(), 7, nullptr, 0}, home = {"near", 8, nullptr, 0};
  rclcpp_lifecycle::State state(&place);
  label = "none";
  check("a state of C is copied", state.id() == 7 && state.label() == "far");
  place.label = "far";
  rcl_lifecycle_transition_t way = {"go", 9, &place, &home};
  rclcpp_lifecycle::Transition transition(&way);
  check("a transition, too", transition.id() == 9 && transition.label() == "go");
  check("its ends, too", transition.start_state().label() == "far" && transition.goal_state().id() == 8);
  const rcl_lifecycle_state_t * no_state = nullptr;
  const rcl_lifecycle_transition_t * no_way = nullptr;
  check("no state is none", refused([&] {rclcpp_lifecycle::State made(no_state);}));
  check("no transition is none", refused([&] {rclcpp_lifecycle::Transition made(no_way);}));
  rclcpp_lifecycle::State own(1, "own", rcutils_get_default_allocator());
  rclcpp_lifecycle::Transition step(2, "step", rcutils_get_default_allocator());
  check("their memory may be chosen", own.label() == "own" && step.label() == "step");
}

int main()
{
  names();
  goals();
  states();
}
