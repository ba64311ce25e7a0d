// KDL's tree of segments from urdf's model of a robot. KDL itself is the system's.
#pragma once
#include <cstdio>
#include <kdl/tree.hpp>
#include <string>

#include "rcutils/logging_macros.h"
#include "urdf/model.h"

namespace kdl_parser
{
namespace detail
{
inline KDL::Vector vector_of(const urdf::Vector3 & v) {return KDL::Vector(v.x, v.y, v.z);}
inline KDL::Frame frame_of(const urdf::Pose & p)
{
  return KDL::Frame(KDL::Rotation::Quaternion(p.rotation.x, p.rotation.y, p.rotation.z, p.rotation.w), vector_of(p.position));
}
inline KDL::Joint joint_of(const urdf::Joint & joint)
{
  const KDL::Frame frame = frame_of(joint.parent_to_joint_origin_transform);
  const KDL::Vector axis = frame.M * vector_of(joint.axis);
  switch (joint.type) {
    case urdf::Joint::FIXED:
      return KDL::Joint(joint.name, KDL::Joint::Fixed);
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
      return KDL::Joint(joint.name, frame.p, axis, KDL::Joint::RotAxis);
    case urdf::Joint::PRISMATIC:
      return KDL::Joint(joint.name, frame.p, axis, KDL::Joint::TransAxis);
    default:
      RCUTILS_LOG_WARN_NAMED(
        "kdl_parser", "Converting unknown joint type of joint '%s' into a fixed joint", joint.name.c_str());
      return KDL::Joint(joint.name, KDL::Joint::Fixed);
  }
}
/// KDL wants the moments about the link's own axes; urdf gives them about those of the centre of mass.
inline KDL::RigidBodyInertia inertia_of(const urdf::Link & link)
{
  if (!link.inertial) {
    return KDL::RigidBodyInertia(0);
  }
  const urdf::Inertial & given = *link.inertial;
  const KDL::Frame centre = frame_of(given.origin);
  const KDL::RotationalInertia moments(given.ixx, given.iyy, given.izz, given.ixy, given.ixz, given.iyz);
  const KDL::RigidBodyInertia turned = centre.M * KDL::RigidBodyInertia(0, KDL::Vector::Zero(), moments);
  return KDL::RigidBodyInertia(given.mass, centre.p, turned.getRotationalInertia());
}
inline bool add_below(const urdf::Link & parent, KDL::Tree & tree)
{
  for (auto & link : parent.child_links) {
    const urdf::Joint & joint = *link->parent_joint;
    const KDL::Frame tip = frame_of(joint.parent_to_joint_origin_transform);
    const KDL::Segment segment(link->name, joint_of(joint), tip, inertia_of(*link));
    if (!tree.addSegment(segment, joint.parent_link_name) || !add_below(*link, tree)) {
      return false;
    }
  }
  return true;
}
}  // namespace detail

/// Each says whether there is a tree.
inline bool treeFromUrdfModel(const urdf::ModelInterface & robot_model, KDL::Tree & tree)
{
  auto root = robot_model.getRoot();
  if (!root) {
    return false;
  }
  tree = KDL::Tree(root->name);
  if (root->inertial) {
    RCUTILS_LOG_WARN_NAMED(
      "kdl_parser",
      "The root link %s has an inertia specified in the URDF, but KDL does not support a root link with an inertia.  "
      "As a workaround, you can add an extra dummy link to your URDF.", root->name.c_str());
  }
  return detail::add_below(*root, tree);
}
inline bool treeFromString(const std::string & xml, KDL::Tree & tree)
{
  urdf::Model model;
  if (!model.initString(xml)) {
    RCUTILS_LOG_ERROR_NAMED("kdl_parser", "Could not generate robot model");
    return false;
  }
  return treeFromUrdfModel(model, tree);
}
inline bool treeFromFile(const std::string & file, KDL::Tree & tree)
{
  urdf::Model model;
  if (!model.initFile(file)) {
    RCUTILS_LOG_ERROR_NAMED("kdl_parser", "Could not generate robot model");
    return false;
  }
  return treeFromUrdfModel(model, tree);
}
}  // namespace kdl_parser
