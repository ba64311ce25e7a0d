// Links: the rigid parts of a robot, what one sees of them, what one bumps into, what they weigh.
#pragma once
#include <string>
#include <vector>

#include "urdf_model/color.h"
#include "urdf_model/joint.h"

namespace urdf
{
class Geometry
{
public:
  enum {SPHERE, BOX, CYLINDER, MESH} type = SPHERE;
  virtual ~Geometry() = default;
};

class Sphere : public Geometry
{
public:
  double radius = 0;
  Sphere() {type = SPHERE;}
  void clear() {radius = 0;}
};

class Box : public Geometry
{
public:
  Vector3 dim;
  Box() {type = BOX;}
  void clear() {dim.clear();}
};

class Cylinder : public Geometry
{
public:
  double length = 0, radius = 0;
  Cylinder() {type = CYLINDER;}
  void clear() {length = radius = 0;}
};

class Mesh : public Geometry
{
public:
  std::string filename;
  Vector3 scale{1, 1, 1};
  Mesh() {type = MESH;}
  void clear()
  {
    filename.clear();
    scale = Vector3(1, 1, 1);
  }
};

class Material
{
public:
  std::string name, texture_filename;
  Color color;
  void clear() {*this = Material();}
};

/// Mass [kg], and the moments of inertia about its centre [kg m^2].
class Inertial
{
public:
  Pose origin;
  double mass = 0, ixx = 0, ixy = 0, ixz = 0, iyy = 0, iyz = 0, izz = 0;
  void clear() {*this = Inertial();}
};

class Visual
{
public:
  Pose origin;
  GeometrySharedPtr geometry;
  std::string material_name;
  MaterialSharedPtr material;
  std::string name;
  void clear() {*this = Visual();}
};

class Collision
{
public:
  Pose origin;
  GeometrySharedPtr geometry;
  std::string name;
  void clear() {*this = Collision();}
};

class Link
{
public:
  std::string name;
  InertialSharedPtr inertial;
  /// The first of the arrays below.
  VisualSharedPtr visual;
  CollisionSharedPtr collision;
  std::vector<CollisionSharedPtr> collision_array;
  std::vector<VisualSharedPtr> visual_array;
  JointSharedPtr parent_joint;
  std::vector<JointSharedPtr> child_joints;
  std::vector<LinkSharedPtr> child_links;
  mutable int link_index = -1;

  LinkSharedPtr getParent() const {return parent_.lock();}
  void setParent(const LinkSharedPtr & parent) {parent_ = parent;}
  void clear() {*this = Link();}

private:
  LinkWeakPtr parent_;
};
}  // namespace urdf
