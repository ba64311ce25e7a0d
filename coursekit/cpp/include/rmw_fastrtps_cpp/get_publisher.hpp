// What stands for a publisher in DDS. There is no DDS here: the pointer tells them apart, and nothing can be asked of it.
#pragma once
#include "rcl/publisher.h"

namespace eprosima::fastdds::dds
{
class DataWriter;
}
namespace rmw_fastrtps_cpp
{
inline eprosima::fastdds::dds::DataWriter * get_datawriter(rmw_publisher_t * publisher)
{
  return reinterpret_cast<eprosima::fastdds::dds::DataWriter *>(publisher);
}
}  // namespace rmw_fastrtps_cpp
