#include <fstream>

#include "check.hpp"

using rcl_interfaces::msg::ParameterDescriptor;
using rcl_interfaces::msg::SetParametersResult;
namespace errors = rclcpp::exceptions;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("parameters");
  equal("declared int", node->declare_parameter("count", 3), 3);
  equal("declared double", node->declare_parameter("speed", 1.5), 1.5);
  equal("declared text", node->declare_parameter("name", "x"), "x");
  equal("declared bool", node->declare_parameter<bool>("on", true), true);
  equal("declared list", node->declare_parameter("list", std::vector<double>{1, 2}).size(), 2u);
  equal("declared texts", node->declare_parameter("texts", std::vector<std::string>{"a", "b", "c"}).at(2), "c");
  check("an empty list", node->declare_parameter<std::vector<std::string>>("none", std::vector<std::string>{}).empty());
  check("is of its type", node->get_parameter("none").get_type() == rclcpp::PARAMETER_STRING_ARRAY);
  ParameterDescriptor kept;
  kept.read_only = true;
  check("also where it is read only", node->declare_parameter("no_numbers", std::vector<int64_t>{}, kept).empty());
  check("and takes no other", !node->set_parameter(rclcpp::Parameter("none", std::vector<double>{1})).successful);
  equal("as_int", node->get_parameter("count").as_int(), 3);
  equal("as_double", node->get_parameter("speed").as_double(), 1.5);
  equal("as_string", node->get_parameter("name").as_string(), "x");
  equal("as_bool", node->get_parameter("on").as_bool(), true);
  equal("as_double_array", node->get_parameter("list").as_double_array().at(1), 2.0);
  equal("type's name", node->get_parameter("speed").get_type_name(), "double");
  equal("value as text", node->get_parameter("texts").value_to_string(), "[a, b, c]");
  int count = 0;
  check("get into a variable", node->get_parameter("count", count) && count == 3);
  check("get what is not there", !node->get_parameter("nothing", count));
  check("get_parameter_or", !node->get_parameter_or("nothing", count, 8) && count == 8);
  check("has", node->has_parameter("count") && !node->has_parameter("nothing"));
  throws<errors::ParameterNotDeclaredException>("get throws", [&] {node->get_parameter("nothing");});
  throws<errors::ParameterAlreadyDeclaredException>("declared twice", [&] {node->declare_parameter("count", 1);});
  auto said = [](auto what) {
      try {
        what();
      } catch (const std::exception & error) {
        return std::string(error.what());
      }
      return std::string();
    };
  equal("words of what is declared twice", said([&] {node->declare_parameter("count", 1);}), "parameter 'count' has already been declared");
  equal("words of what is not declared", said([&] {node->get_parameter("nothing");}), "nothing");
  node->declare_parameter("later", rclcpp::PARAMETER_DOUBLE);
  rclcpp::Parameter later("as it was", 7);
  double number = 2.5;
  check("what has no value is not found", !node->get_parameter("later", later) && later.as_int() == 7);
  check("nor as a number", !node->get_parameter("later", number) && node->get_parameter_or("later", number, 4.5) == false);
  equal("the alternative", number, 4.5);
  std::map<std::string, rclcpp::Parameter> below;
  node->declare_parameter("box.width", rclcpp::PARAMETER_DOUBLE);
  check("what has no value is below its prefix", node->get_node_parameters_interface()->get_parameters_by_prefix("box", below));
  equal("without a type", static_cast<int>(below.at("width").get_type()), static_cast<int>(rclcpp::PARAMETER_NOT_SET));
  equal("words of what has no value", said([&] {node->get_parameter("later");}), "parameter 'later' is not initialized");
  throws<errors::InvalidParametersException>("no name", [&] {node->declare_parameter("", 1);});
  throws<errors::InvalidParameterTypeException>("another type", [&] {node->get_parameter("count").get_value<std::string>();});
  throws<rclcpp::ParameterTypeException>("another type by its name", [&] {node->get_parameter("count").as_string();});
  throws<rclcpp::ParameterTypeException>(
    "another type by its number", [&] {node->get_parameter("count").get_value<rclcpp::PARAMETER_STRING>();});
  rclcpp::ParameterValue whole;
  check("the value itself", node->get_parameter("count", whole) && whole == node->get_parameter("count").get_parameter_value());
  equal("a parameter as itself", node->get_parameter("count").get_value<rclcpp::Parameter>().get_name(), "count");
  std::map<std::string, rclcpp::Parameter> named;
  check("parameters by the rest of their names", node->get_parameters("", named) && named.at("count").get_name() == "count");
  enum Level {LOW, HIGH};
  equal("an enumerator is a number", rclcpp::Parameter("level", HIGH).as_int(), 1);
  throws<errors::ParameterNotDeclaredException>("set what is not declared", [&] {node->set_parameter({"nothing", 1});});
  equal("words for it", said([&] {node->set_parameter({"nothing", 1});}),
    "parameter 'nothing' cannot be set because it was not declared");
  throws<errors::UninitializedStaticallyTypedParameterException>("declared by type alone", [&] {
      node->declare_parameter<int>("typed");
    });
  check("set", node->set_parameter(rclcpp::Parameter("count", 5)).successful && node->get_parameter("count").as_int() == 5);
  auto wrong = node->set_parameter(rclcpp::Parameter("count", "five"));
  check("a wrong type is refused", !wrong.successful);
  equal("in these words", wrong.reason, "Wrong parameter type, parameter {count} is of type {integer}, setting it to {string} is not allowed.");
  ParameterDescriptor fixed;
  fixed.read_only = true;
  node->declare_parameter("fixed", 1, fixed);
  equal("read-only", node->set_parameter({"fixed", 2}).reason, "parameter 'fixed' cannot be set because it is read-only");
  ParameterDescriptor ranged;
  ranged.integer_range.resize(1);
  ranged.integer_range[0].from_value = 0;
  ranged.integer_range[0].to_value = 10;
  ranged.integer_range[0].step = 2;
  node->declare_parameter("ranged", 4, ranged);
  check("within the range", node->set_parameter({"ranged", 6}).successful);
  equal("off the step", node->set_parameter({"ranged", 5}).reason, "Parameter {ranged} doesn't comply with integer range.");
  throws<errors::InvalidParameterValueException>("a default out of range", [&] {node->declare_parameter("r2", 11, ranged);});
  ranged.read_only = true;
  equal("out of range and read only", said([&] {node->declare_parameter("r3", 11, ranged);}),
    "parameter 'r3' could not be set: Parameter {r3} doesn't comply with integer range.");
  auto typed = rclcpp::Node::make_shared("typed", rclcpp::NodeOptions().append_parameter_override("width", "it's wide"));
  equal("an override of another type", said([&] {typed->declare_parameter("width", 320);}),
    "parameter 'width' has invalid type: Wrong parameter type, parameter {width} is of type {integer}, "
    "setting it to {string} is not allowed.");
  ParameterDescriptor dynamic;
  dynamic.dynamic_typing = true;
  node->declare_parameter("dynamic", rclcpp::ParameterValue(1), dynamic);
  check("dynamic typing", node->set_parameter({"dynamic", "text"}).successful);
  equal("described", node->describe_parameter("ranged").integer_range.at(0).to_value, 10);
  throws<errors::InvalidParameterTypeException>("one of a fixed type stays", [&] {node->undeclare_parameter("count");});
  throws<errors::InvalidParameterTypeException>(
    "neither type nor value", [&] {node->declare_parameter("none", rclcpp::ParameterValue());});
  throws<std::invalid_argument>("no type", [&] {node->declare_parameter("none", rclcpp::PARAMETER_NOT_SET);});
  ParameterDescriptor any_type;
  any_type.dynamic_typing = true;
  throws<std::invalid_argument>("one type and any", [&] {node->declare_parameter("none", rclcpp::PARAMETER_BOOL, any_type);});
  node->declare_parameter("unset", rclcpp::ParameterValue(), any_type);
  check("unset stays declared", node->set_parameter(rclcpp::Parameter("unset")).successful && node->has_parameter("unset"));
  throws<errors::ParameterNotDeclaredException>(
    "the type of what is not declared", [&] {node->get_parameter_types({"count", "nowhere"});});
  auto tolerant = rclcpp::Node::make_shared("tolerant", rclcpp::NodeOptions().allow_undeclared_parameters(true));
  equal("it has none where that is allowed", tolerant->get_parameter_types({"none"}).at(0), rclcpp::PARAMETER_NOT_SET);
  equal("and a name", tolerant->describe_parameter("none").name, "none");
  throws<errors::ParameterImmutableException>("a read-only one stays", [&] {node->undeclare_parameter("fixed");});
  node->undeclare_parameter("dynamic");
  check("undeclared", !node->has_parameter("dynamic"));

  auto judge = node->add_on_set_parameters_callback(
    [](const std::vector<rclcpp::Parameter> & wanted) {
      SetParametersResult result;
      result.successful = wanted[0].get_name() != "count" || wanted[0].as_int() < 100;
      result.reason = result.successful ? "" : "too many";
      return result;
    });
  equal("a callback judges", node->set_parameter({"count", 100}).reason, "too many");
  check("and lets pass", node->set_parameter({"count", 99}).successful);
  auto both = node->set_parameters_atomically({{"speed", 9.0}, {"fixed", 3}});
  check("all or nothing", !both.successful && node->get_parameter("speed").as_double() == 1.5);
  auto each = node->set_parameters({{"speed", 9.0}, {"fixed", 3}});
  check("one by one", each[0].successful && !each[1].successful);
  judge.reset();
  check("the callback is gone with its handle", node->set_parameter({"count", 100}).successful);
  node->declare_parameters<int>("wheel", {{"left", 1}, {"right", 2}});
  std::map<std::string, int> wheels;
  check("by prefix", node->get_parameters("wheel", wheels) && wheels["right"] == 2);
  equal("listed below a prefix", node->list_parameters({"wheel"}, 10).names.size(), 2u);
  node->declare_parameter("wheel.aft", 3);
  equal("listed by their names", node->list_parameters({"wheel"}, 10).names.front(), "wheel.aft");
  equal("prefixes", node->list_parameters({"wheel"}, 10).prefixes.at(0), "wheel");
  equal("types", static_cast<int>(node->get_parameter_types({"name"}).at(0)), static_cast<int>(rclcpp::PARAMETER_STRING));

  // of other nodes, by their services
  auto asker = rclcpp::Node::make_shared("asker");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  std::thread serving([&] {executor.spin();});
  auto client = std::make_shared<rclcpp::SyncParametersClient>(asker, "parameters");
  check("services are there", client->wait_for_service(2s));
  equal("remote get", client->get_parameter<int>("count"), 100);
  equal("remote alternative", client->get_parameter<int>("nothing", 6), 6);
  check("remote has", client->has_parameter("wheel.left"));
  check("remote set", client->set_parameters({rclcpp::Parameter("count", 1)})[0].successful);
  equal("remote types", static_cast<int>(client->get_parameter_types({"speed"})[0]), static_cast<int>(rclcpp::PARAMETER_DOUBLE));
  equal("remote list", client->list_parameters({"wheel"}, 10).names.front(), "wheel.aft");
  check("remote atomically", client->set_parameters_atomically({{"count", 2}, {"speed", 2.0}}).successful);
  check("remote calls take a time", client->set_parameters({rclcpp::Parameter("count", 2)}, 2s)[0].successful);
  equal("also in brackets", client->set_parameters<>({rclcpp::Parameter("count", 2)}).size(), 1u);
  equal("a list within a time", client->list_parameters({"wheel"}, 10, 2s).names.size(), client->list_parameters({"wheel"}, 10).names.size());
  auto nobody = std::make_shared<rclcpp::SyncParametersClient>(asker, "nobody");
  check("in vain", nobody->describe_parameters({"count"}, 20ms).empty() && nobody->get_parameter_types({"count"}, 20ms).empty());
  std::ofstream("given.yaml") << "/**:\n  ros__parameters:\n    count: 44\nparameters:\n  ros__parameters:\n    wheel: {left: 7}\n";
  equal("a map is loaded", client->load_parameters(rclcpp::ParameterMap{{"/any", {rclcpp::Parameter("given", 1)}}}).size(), 1u);
  equal("a file is loaded", client->load_parameters("given.yaml").size(), 2u);
  equal("for all nodes", node->get_parameter("count").as_int(), 44);
  equal("and for this one", node->get_parameter("wheel.left").as_int(), 7);
  equal("a file as a map", rclcpp::parameter_map_from_yaml_file("given.yaml").size(), 2u);
  throws<std::runtime_error>("no file", [&] {client->load_parameters("nothing.yaml");});
  int changed = 0;
  auto handler = std::make_shared<rclcpp::ParameterEventHandler>(asker);
  auto handle = handler->add_parameter_callback(
    "count", [&](const rclcpp::Parameter & p) {changed = static_cast<int>(p.as_int());}, "/parameters");
  client->set_parameters({rclcpp::Parameter("count", 12)});
  spin_until(asker, [&] {return changed != 0;});
  equal("a handler hears of a change", changed, 12);
  equal("a parameter as JSON", std::to_string(rclcpp::Parameter("a", 1)), "{\"name\": \"a\", \"type\": \"integer\", \"value\": \"1\"}");
  auto news = std::make_shared<rcl_interfaces::msg::ParameterEvent>();
  news->node = "/told";
  news->new_parameters = {rclcpp::Parameter("a", 1).to_parameter_msg(), rclcpp::Parameter("b", 2).to_parameter_msg()};
  news->deleted_parameters = {rclcpp::Parameter("a", 3).to_parameter_msg()};
  using Handler = rclcpp::ParameterEventHandler;
  equal("a parameter of an event", Handler::get_parameter_from_event(*news, "b", "/told").as_int(), 2);
  equal("one that it does not have", Handler::get_parameter_from_event(*news, "c", "/told").get_name(), "c");
  throws<std::runtime_error>("an event of another node", [&] {Handler::get_parameter_from_event(*news, "b", "/other");});
  rclcpp::Parameter taken;
  check("a node must be named", !Handler::get_parameter_from_event(*news, taken, "b"));
  struct Inside : Handler
  {
    using Handler::Handler;
    using Handler::event_callback;
    size_t all() const {return parameter_callbacks_.size() + event_callbacks_.size();}
  } inside(asker);
  {
    auto one = inside.add_parameter_callback("b", [&](const rclcpp::Parameter & p) {taken = p;}, "/told");
    auto any = inside.add_parameter_event_callback([](const rcl_interfaces::msg::ParameterEvent &) {});
    inside.event_callback(*news);
    check("a class of its own sees a handler's inside", taken.as_int() == 2 && inside.all() == 2);
    inside.remove_parameter_callback(one);
    inside.remove_parameter_event_callback(any);
    equal("nothing is left in it", inside.all(), 0u);
  }
  using Filter = rclcpp::ParameterEventsFilter;
  Filter about_a(news, {"a"}, {Filter::EventType::NEW, Filter::EventType::CHANGED});
  equal("events about a name", about_a.get_events().size(), 1u);
  equal("the event", about_a.get_events().at(0).second->value.integer_value, 1);
  equal("events of a kind", Filter(news, {"a", "b"}, {Filter::EventType::DELETED}).get_events().size(), 1u);
  executor.cancel();
  serving.join();
  rclcpp::shutdown();
}
