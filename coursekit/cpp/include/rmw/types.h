// rmw's policies and profiles.
#pragma once
#include <stddef.h>
#include <stdint.h>
typedef struct {uint64_t sec; uint64_t nsec;} rmw_time_t;
#define RMW_DURATION_INFINITE {9223372036LL, 854775807LL}
#define RMW_DURATION_UNSPECIFIED {0LL, 0LL}
#define RMW_QOS_DEADLINE_DEFAULT RMW_DURATION_UNSPECIFIED
#define RMW_QOS_LIFESPAN_DEFAULT RMW_DURATION_UNSPECIFIED
#define RMW_QOS_LIVELINESS_LEASE_DURATION_DEFAULT RMW_DURATION_UNSPECIFIED
#define RMW_QOS_POLICY_DEPTH_SYSTEM_DEFAULT 0
typedef enum {RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, RMW_QOS_POLICY_HISTORY_KEEP_LAST, RMW_QOS_POLICY_HISTORY_KEEP_ALL,
  RMW_QOS_POLICY_HISTORY_UNKNOWN} rmw_qos_history_policy_t;
typedef enum {RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT, RMW_QOS_POLICY_RELIABILITY_RELIABLE,
  RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT, RMW_QOS_POLICY_RELIABILITY_UNKNOWN} rmw_qos_reliability_policy_t;
typedef enum {RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
  RMW_QOS_POLICY_DURABILITY_VOLATILE, RMW_QOS_POLICY_DURABILITY_UNKNOWN} rmw_qos_durability_policy_t;
typedef enum {RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT = 0, RMW_QOS_POLICY_LIVELINESS_AUTOMATIC = 1,
  RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_NODE = 2, RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC = 3,
  RMW_QOS_POLICY_LIVELINESS_UNKNOWN = 4} rmw_qos_liveliness_policy_t;
typedef enum {
  RMW_QOS_POLICY_INVALID = 1 << 0, RMW_QOS_POLICY_DURABILITY = 1 << 1, RMW_QOS_POLICY_DEADLINE = 1 << 2,
  RMW_QOS_POLICY_LIVELINESS = 1 << 3, RMW_QOS_POLICY_RELIABILITY = 1 << 4, RMW_QOS_POLICY_HISTORY = 1 << 5,
  RMW_QOS_POLICY_LIFESPAN = 1 << 6, RMW_QOS_POLICY_DEPTH = 1 << 7, RMW_QOS_POLICY_LIVELINESS_LEASE_DURATION = 1 << 8,
  RMW_QOS_POLICY_AVOID_ROS_NAMESPACE_CONVENTIONS = 1 << 9} rmw_qos_policy_kind_t;
typedef enum {RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_NOT_REQUIRED, RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED,
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_OPTIONALLY_REQUIRED} rmw_unique_network_flow_endpoints_requirement_t;
typedef struct {
  rmw_qos_history_policy_t history; size_t depth; rmw_qos_reliability_policy_t reliability;
  rmw_qos_durability_policy_t durability; rmw_time_t deadline; rmw_time_t lifespan;
  rmw_qos_liveliness_policy_t liveliness; rmw_time_t liveliness_lease_duration; bool avoid_ros_namespace_conventions;
} rmw_qos_profile_t;


#define COURSEKIT_PROFILE(depth, reliability, durability) \
  {RMW_QOS_POLICY_HISTORY_KEEP_LAST, depth, RMW_QOS_POLICY_RELIABILITY_ ## reliability, \
    RMW_QOS_POLICY_DURABILITY_ ## durability, {0, 0}, {0, 0}, RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT, {0, 0}, false}
static const rmw_qos_profile_t rmw_qos_profile_default = COURSEKIT_PROFILE(10, RELIABLE, VOLATILE);
static const rmw_qos_profile_t rmw_qos_profile_sensor_data = COURSEKIT_PROFILE(5, BEST_EFFORT, VOLATILE);
static const rmw_qos_profile_t rmw_qos_profile_parameters = COURSEKIT_PROFILE(1000, RELIABLE, VOLATILE);
static const rmw_qos_profile_t rmw_qos_profile_services_default = COURSEKIT_PROFILE(10, RELIABLE, VOLATILE);
static const rmw_qos_profile_t rmw_qos_profile_parameter_events = COURSEKIT_PROFILE(1000, RELIABLE, VOLATILE);
static const rmw_qos_profile_t rmw_qos_profile_system_default = {RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, 0,
  RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT, RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT, {0, 0}, {0, 0},
  RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT, {0, 0}, false};
typedef int64_t rmw_time_point_value_t;
typedef struct {int8_t writer_guid[16]; int64_t sequence_number;} rmw_request_id_t;
typedef struct {
  rmw_time_point_value_t source_timestamp; rmw_time_point_value_t received_timestamp; rmw_request_id_t request_id;
} rmw_service_info_t;
typedef struct {uint8_t data[24]; const char * implementation_identifier;} rmw_gid_t;
typedef struct {
  rmw_time_point_value_t source_timestamp; rmw_time_point_value_t received_timestamp; uint64_t publication_sequence_number;
  uint64_t reception_sequence_number; rmw_gid_t publisher_gid; bool from_intra_process;
} rmw_message_info_t;
