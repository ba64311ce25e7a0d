// The message about the statistics of one metric.
#pragma once
#include <utility>

#include "libstatistics_collector/moving_average_statistics/moving_average.hpp"
#include "statistics_msgs/msg/metrics_message.hpp"
#include "statistics_msgs/msg/statistic_data_type.hpp"

namespace libstatistics_collector::collector
{
inline statistics_msgs::msg::MetricsMessage GenerateStatisticMessage(
  const std::string & node_name, const std::string & metric_name, const std::string & unit,
  const builtin_interfaces::msg::Time window_start, const builtin_interfaces::msg::Time window_stop,
  const moving_average_statistics::StatisticData & data)
{
  using Type = statistics_msgs::msg::StatisticDataType;
  statistics_msgs::msg::MetricsMessage message;
  message.measurement_source_name = node_name;
  message.metrics_source = metric_name;
  message.unit = unit;
  message.window_start = window_start;
  message.window_stop = window_stop;
  const std::pair<uint8_t, double> numbers[] = {
    {Type::STATISTICS_DATA_TYPE_AVERAGE, data.average}, {Type::STATISTICS_DATA_TYPE_MAXIMUM, data.max},
    {Type::STATISTICS_DATA_TYPE_MINIMUM, data.min},
    {Type::STATISTICS_DATA_TYPE_SAMPLE_COUNT, static_cast<double>(data.sample_count)},
    {Type::STATISTICS_DATA_TYPE_STDDEV, data.standard_deviation}};
  for (const auto & [type, number] : numbers) {
    message.statistics.emplace_back();
    message.statistics.back().data_type = type;
    message.statistics.back().data = number;
  }
  return message;
}
}  // namespace libstatistics_collector::collector
