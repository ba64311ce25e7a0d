// What stands for a node in DDS. There is no DDS here: the pointer tells nodes apart, and nothing can be asked of it.
#pragma once
#include "rcl/node.h"

namespace eprosima::fastdds::dds
{
class DomainParticipant;
}
namespace rmw_fastrtps_cpp
{
inline eprosima::fastdds::dds::DomainParticipant * get_domain_participant(rmw_node_t * node)
{
  return reinterpret_cast<eprosima::fastdds::dds::DomainParticipant *>(node);
}
}  // namespace rmw_fastrtps_cpp
