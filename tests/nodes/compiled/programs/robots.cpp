// urdf: reads a robot and prints what its structures hold.
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>

#include "urdf/model.h"

static bool read(urdf::Model & model, const std::string & how, const std::string & path)
{
  if (how != "string") {
    return model.initFile(how == "file" ? path : how);
  }
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return model.initString(text.str());
}

static void print_joints(const urdf::Model & model)
{
  urdf::JointConstSharedPtr shoulder = model.getJoint("shoulder");
  double roll, pitch, yaw;
  shoulder->parent_to_joint_origin_transform.rotation.getRPY(roll, pitch, yaw);
  std::cout << "shoulder " << (shoulder->type == urdf::Joint::REVOLUTE ? "revolute" : "other") << " "
            << shoulder->parent_to_joint_origin_transform.position.z << " rpy " << std::abs(std::round(roll)) << " "
            << std::abs(std::round(pitch)) << " " << std::round(yaw * 100) / 100 << ", axis " << shoulder->axis.x << " "
            << shoulder->axis.y << " " << shoulder->axis.z << std::endl;
  std::cout << "limits " << shoulder->limits->lower << " " << shoulder->limits->upper << " " << shoulder->limits->effort
            << " " << shoulder->limits->velocity << ", damping " << shoulder->dynamics->damping << ", safety "
            << shoulder->safety->soft_lower_limit << " " << shoulder->safety->soft_upper_limit << " "
            << shoulder->safety->k_position << " " << shoulder->safety->k_velocity << std::endl;
  auto fixed = model.joints_.at("fixed");
  std::cout << "fixed " << (fixed->type == urdf::Joint::FIXED ? "fixed" : "other") << ", axis " << fixed->axis.x
            << (fixed->limits ? "" : ", no limits") << (fixed->dynamics ? "" : ", no dynamics") << std::endl;
  auto copy = model.getJoint("copy");
  std::cout << "copy mimics " << copy->mimic->joint_name << " " << copy->mimic->multiplier << " " << copy->mimic->offset
            << std::endl;
}

int main(int, char ** argv)
{
  urdf::Model model;
  if (!read(model, argv[1], argv[2])) {
    std::cout << "no robot" << std::endl;
    return 0;
  }
  std::cout << model.getName() << " " << model.links_.size() << " links " << model.joints_.size() << " joints "
            << model.materials_.size() << " materials, root " << model.getRoot()->name << std::endl;
  auto base = model.getRoot();
  std::cout << "base: child joints";
  for (auto & joint : base->child_joints) {
    std::cout << " " << joint->name;
  }
  std::cout << ", child links";
  for (auto & link : base->child_links) {
    std::cout << " " << link->name;
  }
  std::cout << (base->getParent() ? "" : ", no parent") << std::endl;
  auto & inertial = *base->inertial;
  std::cout << "inertial " << inertial.mass << " " << inertial.origin.position.z << " " << inertial.ixx << " "
            << inertial.iyy << " " << inertial.izz << std::endl;
  auto box = std::dynamic_pointer_cast<urdf::Box>(base->visual->geometry);
  auto upper = model.getLink("upper");
  bool same = base->visual->material == upper->visual_array[1]->material && model.getMaterial("blue") == base->visual->material;
  std::cout << "box " << box->dim.x << " " << box->dim.y << " " << box->dim.z << ", " << base->visual->material_name << " "
            << base->visual->material->color.b << (same ? ", one object" : ", copies") << std::endl;
  auto cylinder = urdf::dynamic_pointer_cast<urdf::Cylinder>(base->collision->geometry);
  std::cout << "cylinder " << cylinder->radius << " " << cylinder->length << " at " << base->collision->origin.position.x
            << std::endl;
  auto sphere = std::static_pointer_cast<urdf::Sphere>(upper->visual->geometry);
  auto skin = upper->visual_array[1];
  auto mesh = std::dynamic_pointer_cast<urdf::Mesh>(skin->geometry);
  std::cout << "upper: " << upper->visual_array.size() << " visuals, "
            << (sphere->type == urdf::Geometry::SPHERE ? "sphere " : "other ") << sphere->radius << ", " << skin->name << " "
            << mesh->filename << " " << mesh->scale.z << ", parent " << upper->getParent()->name << " by "
            << upper->parent_joint->name << std::endl;
  print_joints(model);
  std::cout << (model.getLink("nothing") ? "" : "no such link") << (model.getJoint("nothing") ? "" : ", no such joint")
            << std::endl;
  urdf::Rotation turn;
  turn.setFromRPY(0, 0, std::acos(-1.0) / 2);
  urdf::Vector3 turned = turn * urdf::Vector3(2, -1, 0);
  std::cout << std::round(turned.x) << " " << std::round(turned.y) << " " << std::round(turned.z) << std::endl;
}
