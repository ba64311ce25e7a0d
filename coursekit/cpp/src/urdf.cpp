// Robots' descriptions: the session reads them, `nodes/compiled/robot_descriptions.py` tells what is in them.
#include <cstdio>
#include <fstream>
#include <iterator>

#include "coursekit/link.hpp"
#include "urdf_parser/urdf_parser.h"

namespace urdf
{
namespace
{
using coursekit::Unpacker;

Vector3 vector(Unpacker & from)
{
  Vector3 read;
  for (double * number : {&read.x, &read.y, &read.z}) {
    *number = from.d();
  }
  return read;
}
Pose pose(Unpacker & from)
{
  Pose read;
  read.position = vector(from);
  Vector3 rpy = vector(from);
  read.rotation.setFromRPY(rpy.x, rpy.y, rpy.z);
  return read;
}
MaterialSharedPtr material(Unpacker & from)
{
  auto read = std::make_shared<Material>();
  read->name = from.s();
  read->texture_filename = from.s();
  for (float * part : {&read->color.r, &read->color.g, &read->color.b, &read->color.a}) {
    *part = static_cast<float>(from.d());
  }
  return read;
}
GeometrySharedPtr geometry(Unpacker & from)
{
  switch (from.i()) {
    case Geometry::SPHERE: {
        auto read = std::make_shared<Sphere>();
        read->radius = from.d();
        return read;
      }
    case Geometry::BOX: {
        auto read = std::make_shared<Box>();
        read->dim = vector(from);
        return read;
      }
    case Geometry::CYLINDER: {
        auto read = std::make_shared<Cylinder>();
        read->length = from.d();
        read->radius = from.d();
        return read;
      }
    default: {
        auto read = std::make_shared<Mesh>();
        read->filename = from.s();
        read->scale = vector(from);
        return read;
      }
  }
}
template<class T>
std::shared_ptr<T> placed_shape(Unpacker & from)
{
  auto read = std::make_shared<T>();
  read->name = from.s();
  read->origin = pose(from);
  read->geometry = geometry(from);
  return read;
}
VisualSharedPtr visual(Unpacker & from)
{
  auto read = placed_shape<Visual>(from);
  if (from.i()) {
    read->material = material(from);
    read->material_name = read->material->name;
  }
  return read;
}
InertialSharedPtr inertial(Unpacker & from)
{
  auto read = std::make_shared<Inertial>();
  read->origin = pose(from);
  for (double * number : {&read->mass, &read->ixx, &read->ixy, &read->ixz, &read->iyy, &read->iyz, &read->izz}) {
    *number = from.d();
  }
  return read;
}
LinkSharedPtr link(Unpacker & from)
{
  auto read = std::make_shared<Link>();
  read->name = from.s();
  read->inertial = from.i() ? inertial(from) : nullptr;
  for (int64_t count = from.i(); count > 0; --count) {
    read->visual_array.push_back(visual(from));
  }
  for (int64_t count = from.i(); count > 0; --count) {
    read->collision_array.push_back(placed_shape<Collision>(from));
  }
  read->visual = read->visual_array.empty() ? nullptr : read->visual_array.front();
  read->collision = read->collision_array.empty() ? nullptr : read->collision_array.front();
  return read;
}
void limits(Unpacker & from, Joint & joint)
{
  if (from.i()) {
    joint.limits = std::make_shared<JointLimits>();
    for (double * n : {&joint.limits->lower, &joint.limits->upper, &joint.limits->effort, &joint.limits->velocity}) {
      *n = from.d();
    }
  }
  if (from.i()) {
    joint.safety = std::make_shared<JointSafety>();
    auto & safety = *joint.safety;
    for (double * n : {&safety.soft_lower_limit, &safety.soft_upper_limit, &safety.k_position, &safety.k_velocity}) {
      *n = from.d();
    }
  }
  if (from.i()) {
    joint.mimic = std::make_shared<JointMimic>();
    joint.mimic->joint_name = from.s();
    joint.mimic->multiplier = from.d();
    joint.mimic->offset = from.d();
  }
}
JointSharedPtr joint(Unpacker & from)
{
  auto read = std::make_shared<Joint>();
  read->name = from.s();
  read->type = static_cast<decltype(read->type)>(from.i());
  read->parent_link_name = from.s();
  read->child_link_name = from.s();
  read->parent_to_joint_origin_transform = pose(from);
  read->axis = vector(from);
  double damping = from.d(), friction = from.d();
  if (damping != 0 || friction != 0) {
    read->dynamics = std::make_shared<JointDynamics>();
    read->dynamics->damping = damping;
    read->dynamics->friction = friction;
  }
  limits(from, *read);
  return read;
}
template<class T, class F>
void fill(Unpacker & from, std::map<std::string, std::shared_ptr<T>> & parts, F read)
{
  for (int64_t count = from.i(); count > 0; --count) {
    std::shared_ptr<T> part = read(from);
    parts[part->name] = part;
  }
}
/// A material is one object, whoever wears it.
void share_materials(ModelInterface & model)
{
  for (auto & entry : model.links_) {
    for (auto & one : entry.second->visual_array) {
      MaterialSharedPtr known = one->material ? model.getMaterial(one->material_name) : nullptr;
      one->material = known ? known : one->material;
    }
  }
}
}  // namespace

ModelInterfaceSharedPtr parseURDF(const std::string & text)
{
  Unpacker answer = coursekit::request("urdf", coursekit::Packer{}.s(text));
  bool good = answer.i();
  std::fputs(answer.s().c_str(), stderr);
  if (!good) {
    return nullptr;
  }
  auto model = std::make_shared<ModelInterface>();
  model->name_ = answer.s();
  fill(answer, model->materials_, material);
  fill(answer, model->links_, link);
  fill(answer, model->joints_, joint);
  share_materials(*model);
  std::map<std::string, std::string> parents;
  model->initTree(parents);
  model->initRoot(parents);
  return model;
}

ModelInterfaceSharedPtr parseURDFFile(const std::string & path)
{
  std::ifstream file(path);
  if (!file) {
    std::fprintf(stderr, "File %s does not exist\n", path.c_str());
    return nullptr;
  }
  return parseURDF({std::istreambuf_iterator<char>(file), {}});
}
}  // namespace urdf
