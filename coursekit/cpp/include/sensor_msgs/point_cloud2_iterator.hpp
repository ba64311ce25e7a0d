// Fields of clouds, one point after the other.
#pragma once
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include "sensor_msgs/msg/point_cloud2.hpp"

namespace sensor_msgs
{
/// Changes the fields and the size of a cloud.
class PointCloud2Modifier
{
public:
  explicit PointCloud2Modifier(msg::PointCloud2 & cloud)
  : cloud_(cloud) {}
  size_t size() const {return static_cast<size_t>(cloud_.width) * cloud_.height;}
  void reserve(size_t size) {cloud_.data.reserve(size * cloud_.point_step);}
  void resize(size_t size)
  {
    cloud_.data.resize(size * cloud_.point_step);
    cloud_.height = 1;
    cloud_.width = static_cast<uint32_t>(size);
    cloud_.row_step = cloud_.width * cloud_.point_step;
  }
  void clear() {resize(0);}
  /// Fields as (name, count, datatype), three words for each.
  template<class ... Words>
  void setPointCloud2Fields(int count, Words ... words)
  {
    static_assert(sizeof...(words) % 3 == 0, "each field has a name, a count and a datatype");
    begin();
    add(words ...);
    finish(count);
  }
  /// Fields by what they are called: "xyz", "rgb", "rgba".
  template<class ... Names>
  void setPointCloud2FieldsByString(int count, Names ... names)
  {
    begin();
    (add_by_name(names), ...);
    finish(count);
  }

private:
  void begin()
  {
    cloud_.fields.clear();
    step_ = 0;
  }
  void add() {}
  template<class ... Words>
  void add(const char * name, int count, int datatype, Words ... words)
  {
    msg::PointField field;
    field.name = name;
    field.offset = step_;
    field.datatype = static_cast<uint8_t>(datatype);
    field.count = static_cast<uint32_t>(count);
    step_ += field.count * size_of(field.datatype);
    cloud_.fields.push_back(field);
    add(words ...);
  }
  void add_by_name(const std::string & name)
  {
    if (name == "xyz") {
      add("x", 1, msg::PointField::FLOAT32, "y", 1, msg::PointField::FLOAT32, "z", 1, msg::PointField::FLOAT32);
      step_ += 4;  // the four floats of a point that is moved as one
    } else if (name == "rgb" || name == "rgba") {
      add(name.c_str(), 1, msg::PointField::FLOAT32);
      step_ += 12;
    } else {
      throw std::runtime_error("Field " + name + " does not exist");
    }
  }
  void finish(int)
  {
    cloud_.point_step = step_;
    cloud_.row_step = cloud_.width * step_;
    cloud_.data.resize(static_cast<size_t>(cloud_.height) * cloud_.row_step);
  }
  static uint32_t size_of(uint8_t datatype)
  {
    static const uint32_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return datatype < 9 ? sizes[datatype] : 0;
  }
  msg::PointCloud2 & cloud_;
  uint32_t step_ = 0;
};

namespace impl
{
/// What the iterator V over one field is made of; C is the cloud, T what the field's bytes are.
template<class V, class T, class C, class Byte>
class FieldIterator
{
public:
  FieldIterator(C & cloud, const std::string & name)
  : step_(cloud.point_step)
  {
    at_ = cloud.data.data() + offset_of(cloud, name);
    end_ = at_ + static_cast<size_t>(cloud.width) * cloud.height * step_;
  }
  T & operator*() const {return *reinterpret_cast<T *>(at_);}
  T & operator[](size_t i) const {return reinterpret_cast<T *>(at_)[i];}
  V & operator++() {return *this += 1;}
  V & operator+=(int count)
  {
    at_ += static_cast<ptrdiff_t>(count) * step_;
    return static_cast<V &>(*this);
  }
  V operator+(int count) const
  {
    V moved = static_cast<const V &>(*this);
    return moved += count;
  }
  bool operator!=(const FieldIterator & other) const {return at_ != other.at_;}
  V end() const
  {
    V last = static_cast<const V &>(*this);
    last.at_ = end_;
    return last;
  }

private:
  static size_t offset_of(C & cloud, const std::string & name)
  {
    for (auto & field : cloud.fields) {
      if (field.name == name) {
        return field.offset;
      }
    }
    for (auto & field : cloud.fields) {  // a colour's parts lie in one field
      if ((field.name == "rgb" || field.name == "rgba") && name.size() == 1) {
        size_t at = std::string("bgra").find(name);
        if (at != std::string::npos) {
          return field.offset + (cloud.is_bigendian ? 3 - at : at);
        }
      }
    }
    throw std::runtime_error("Field " + name + " does not exist");
  }
  Byte * at_;
  Byte * end_;
  uint32_t step_;
};
}  // namespace impl

template<class T>
class PointCloud2Iterator : public impl::FieldIterator<PointCloud2Iterator<T>, T, msg::PointCloud2, unsigned char>
{
public:
  using impl::FieldIterator<PointCloud2Iterator<T>, T, msg::PointCloud2, unsigned char>::FieldIterator;
};
template<class T>
class PointCloud2ConstIterator
  : public impl::FieldIterator<PointCloud2ConstIterator<T>, const T, const msg::PointCloud2, const unsigned char>
{
public:
  using impl::FieldIterator<PointCloud2ConstIterator<T>, const T, const msg::PointCloud2, const unsigned char>::FieldIterator;
};
}  // namespace sensor_msgs
