// The loaders of transports: of those that packages of the workspace describe. "raw" needs none.
#pragma once
#include "image_transport/simple_publisher_plugin.hpp"
#include "image_transport/simple_subscriber_plugin.hpp"
#include "pluginlib/class_loader.hpp"

namespace image_transport
{
using PubLoader = pluginlib::ClassLoader<PublisherPlugin>;
using SubLoader = pluginlib::ClassLoader<SubscriberPlugin>;
using PubLoaderPtr = std::shared_ptr<PubLoader>;
using SubLoaderPtr = std::shared_ptr<SubLoader>;

namespace detail
{
/// One for the program, kept to its end: objects of a library's classes must not outlive its loader.
inline PubLoader & pub_loader()
{
  static auto * loader = new PubLoader("image_transport", "image_transport::PublisherPlugin");
  return *loader;
}
inline SubLoader & sub_loader()
{
  static auto * loader = new SubLoader("image_transport", "image_transport::SubscriberPlugin");
  return *loader;
}
/// Names of transports: without the end that tells a publisher's class from a subscriber's.
inline std::string transport_named(const std::string & lookup_name) {return lookup_name.substr(0, lookup_name.rfind('_'));}
}  // namespace detail
}  // namespace image_transport
