// What the programs of nav2's plugins share: the server's node, buffer and costmap, and the class with its life.
#pragma once
#include <memory>
#include <string>

#include "class_loader/class_loader.hpp"
#include "coursekit/link.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"

namespace coursekit
{
/// What a server lends to its plugin.
struct Nav2Server
{
  std::shared_ptr<nav2_util::LifecycleNode> node;
  std::shared_ptr<tf2_ros::Buffer> buffer;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap;
  std::string name;

  /// Take its numbers, the name of the plugin, and the costs.
  void meet(Unpacker & from)
  {
    node = std::make_shared<nav2_util::LifecycleNode>(rclcpp::SharedNode{from.i()});
    buffer = std::make_shared<tf2_ros::Buffer>(tf2::BufferCore::Shared{from.i()}, node->get_clock());
    costmap = std::make_shared<nav2_costmap_2d::Costmap2DROS>(rclcpp::SharedNode{from.i()}, buffer);
    name = from.s();
    costmap->renew(from);
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
  /// A step of its life, for classes with all of them.
  void change(const std::string & what, Unpacker & from)
  {
    if (what == "make") {
      make();
    } else if (what == "configure") {
      meet(from);
      plugin->configure(node, name, buffer, costmap);
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
