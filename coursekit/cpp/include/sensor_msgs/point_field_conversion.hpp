// Numbers of a cloud's fields, as their datatype has them.
#pragma once
#include <cstring>

#include "sensor_msgs/msg/point_field.hpp"

namespace sensor_msgs
{
/// The C++ type of a datatype, and the datatype of a C++ type.
template<int Datatype>
struct pointFieldTypeAsType {};
template<class T>
struct typeAsPointFieldType {};
#define COURSEKIT_POINT_FIELD(NAME, T) \
  template<> \
  struct pointFieldTypeAsType<msg::PointField::NAME> {using type = T;}; \
  template<> \
  struct typeAsPointFieldType<T> {static const uint8_t value = msg::PointField::NAME;};
COURSEKIT_POINT_FIELD(INT8, int8_t)
COURSEKIT_POINT_FIELD(UINT8, uint8_t)
COURSEKIT_POINT_FIELD(INT16, int16_t)
COURSEKIT_POINT_FIELD(UINT16, uint16_t)
COURSEKIT_POINT_FIELD(INT32, int32_t)
COURSEKIT_POINT_FIELD(UINT32, uint32_t)
COURSEKIT_POINT_FIELD(FLOAT32, float)
COURSEKIT_POINT_FIELD(FLOAT64, double)
#undef COURSEKIT_POINT_FIELD

/// The number that stands there, as another type.
template<int Datatype, class T>
T readPointCloud2BufferValue(const unsigned char * data)
{
  typename pointFieldTypeAsType<Datatype>::type value;
  std::memcpy(&value, data, sizeof(value));
  return static_cast<T>(value);
}
template<int Datatype, class T>
void writePointCloud2BufferValue(unsigned char * data, T value)
{
  auto written = static_cast<typename pointFieldTypeAsType<Datatype>::type>(value);
  std::memcpy(data, &written, sizeof(written));
}
template<class T>
T readPointCloud2BufferValue(const unsigned char * data, const unsigned char datatype)
{
  switch (datatype) {
    case msg::PointField::INT8: return readPointCloud2BufferValue<msg::PointField::INT8, T>(data);
    case msg::PointField::UINT8: return readPointCloud2BufferValue<msg::PointField::UINT8, T>(data);
    case msg::PointField::INT16: return readPointCloud2BufferValue<msg::PointField::INT16, T>(data);
    case msg::PointField::UINT16: return readPointCloud2BufferValue<msg::PointField::UINT16, T>(data);
    case msg::PointField::INT32: return readPointCloud2BufferValue<msg::PointField::INT32, T>(data);
    case msg::PointField::UINT32: return readPointCloud2BufferValue<msg::PointField::UINT32, T>(data);
    case msg::PointField::FLOAT32: return readPointCloud2BufferValue<msg::PointField::FLOAT32, T>(data);
    case msg::PointField::FLOAT64: return readPointCloud2BufferValue<msg::PointField::FLOAT64, T>(data);
  }
  return T(0);
}
template<class T>
void writePointCloud2BufferValue(unsigned char * data, const unsigned char datatype, T value)
{
  switch (datatype) {
    case msg::PointField::INT8: return writePointCloud2BufferValue<msg::PointField::INT8, T>(data, value);
    case msg::PointField::UINT8: return writePointCloud2BufferValue<msg::PointField::UINT8, T>(data, value);
    case msg::PointField::INT16: return writePointCloud2BufferValue<msg::PointField::INT16, T>(data, value);
    case msg::PointField::UINT16: return writePointCloud2BufferValue<msg::PointField::UINT16, T>(data, value);
    case msg::PointField::INT32: return writePointCloud2BufferValue<msg::PointField::INT32, T>(data, value);
    case msg::PointField::UINT32: return writePointCloud2BufferValue<msg::PointField::UINT32, T>(data, value);
    case msg::PointField::FLOAT32: return writePointCloud2BufferValue<msg::PointField::FLOAT32, T>(data, value);
    case msg::PointField::FLOAT64: return writePointCloud2BufferValue<msg::PointField::FLOAT64, T>(data, value);
  }
}
}  // namespace sensor_msgs
