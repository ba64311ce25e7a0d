// What the programs of nav2's plugins share: the server's node, buffer and costmap, and the class with its life.
#pragma once
#include <memory>
#include <string>

#include "class_loader/class_loader.hpp"
#include "coursekit/link.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_costmap_2d/costmap_subscriber.hpp"
#include "nav2_costmap_2d/footprint_subscriber.hpp"

namespace coursekit
{
/// What a server lends to its plugin.
struct Nav2Server
{
  std::shared_ptr<nav2_util::LifecycleNode> node;
  std::shared_ptr<tf2_ros::Buffer> buffer;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap;
  std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> heard_costs;
  std::shared_ptr<nav2_costmap_2d::FootprintSubscriber> heard_outline;
  std::string name;

  /// Take the name of the plugin, and the numbers of the server's node and buffer.
  void meet_node(Unpacker & from)
  {
    name = from.s();
    node = std::make_shared<nav2_util::LifecycleNode>(rclcpp::SharedNode{from.i()});
    buffer = std::make_shared<tf2_ros::Buffer>(tf2::BufferCore::Shared{from.i()}, node->get_clock());
  }
  /// The costmap, too, and its costs.
  void meet_costmap(Unpacker & from)
  {
    meet_node(from);
    costmap = std::make_shared<nav2_costmap_2d::Costmap2DROS>(rclcpp::SharedNode{from.i()}, buffer);
    costmap->renew(from);
  }
  /// And the layers that it is made of.
  void meet(Unpacker & from)
  {
    meet_costmap(from);
    costmap->meet_layers();
  }
  /// Instead of the costmap, hear what another node publishes of it, by the names that the server's parameters give.
  void meet_and_listen(Unpacker & from)
  {
    meet_node(from);
    auto text = [this](const char * parameter) {return node->get_parameter(parameter).as_string();};
    heard_costs = std::make_shared<nav2_costmap_2d::CostmapSubscriber>(node, text("costmap_topic"));
    heard_outline = std::make_shared<nav2_costmap_2d::FootprintSubscriber>(
      node, text("footprint_topic"), *buffer, text("robot_base_frame"),
      node->get_parameter("transform_tolerance").as_double());
  }
};

/// An object of one of the program's own classes.
template<class Base>
struct Nav2Plugin : Nav2Server
{
  explicit Nav2Plugin(std::string type_)
  : type(std::move(type_)) {}

  void make()
  {
    class_loader::ClassLoader own("");
    plugin.reset(own.createUnmanagedInstance<Base>(type));
  }
  void configure(Unpacker & from)
  {
    meet(from);
    plugin->configure(node, name, buffer, costmap);
  }
  /// Another step of its life, for classes with all of them.
  void change(const std::string & what)
  {
    if (what == "make") {
      make();
    } else if (what == "activate") {
      plugin->activate();
    } else if (what == "deactivate") {
      plugin->deactivate();
    } else {
      plugin->cleanup();
    }
  }

  std::string type;
  std::shared_ptr<Base> plugin;
};
}  // namespace coursekit
