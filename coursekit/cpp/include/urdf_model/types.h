// Names of pointers to a robot's parts.
#pragma once
#include <memory>

#define URDF_TYPEDEF_CLASS_POINTER(Class) \
  class Class; \
  using Class ## SharedPtr = std::shared_ptr<Class>; \
  using Class ## ConstSharedPtr = std::shared_ptr<const Class>; \
  using Class ## WeakPtr = std::weak_ptr<Class>

namespace urdf
{
URDF_TYPEDEF_CLASS_POINTER(Box);
URDF_TYPEDEF_CLASS_POINTER(Collision);
URDF_TYPEDEF_CLASS_POINTER(Cylinder);
URDF_TYPEDEF_CLASS_POINTER(Geometry);
URDF_TYPEDEF_CLASS_POINTER(Inertial);
URDF_TYPEDEF_CLASS_POINTER(Joint);
URDF_TYPEDEF_CLASS_POINTER(JointCalibration);
URDF_TYPEDEF_CLASS_POINTER(JointDynamics);
URDF_TYPEDEF_CLASS_POINTER(JointLimits);
URDF_TYPEDEF_CLASS_POINTER(JointMimic);
URDF_TYPEDEF_CLASS_POINTER(JointSafety);
URDF_TYPEDEF_CLASS_POINTER(Link);
URDF_TYPEDEF_CLASS_POINTER(Material);
URDF_TYPEDEF_CLASS_POINTER(Mesh);
URDF_TYPEDEF_CLASS_POINTER(ModelInterface);
URDF_TYPEDEF_CLASS_POINTER(Sphere);
URDF_TYPEDEF_CLASS_POINTER(Visual);
using DoubleSharedPtr = std::shared_ptr<double>;

template<class T, class U>
std::shared_ptr<T> const_pointer_cast(const std::shared_ptr<U> & pointer) {return std::const_pointer_cast<T>(pointer);}
template<class T, class U>
std::shared_ptr<T> dynamic_pointer_cast(const std::shared_ptr<U> & pointer) {return std::dynamic_pointer_cast<T>(pointer);}
template<class T, class U>
std::shared_ptr<T> static_pointer_cast(const std::shared_ptr<U> & pointer) {return std::static_pointer_cast<T>(pointer);}
}  // namespace urdf
