"""What C++ programs find beside rclcpp: the package index, options, clouds and encodings."""

from __future__ import annotations

import os
import subprocess

from coursekit.interfaces.find import UNDERLAY
from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

PROGRAM = """
#include <iostream>
#include "ament_index_cpp/get_package_share_directory.hpp"
#include "ament_index_cpp/has_resource.hpp"
#include "rcutils/cmdline_parser.h"
#include "rcutils/env.h"
#include "rcutils/strdup.h"
#include "rmw/error_handling.h"
#include "sensor_msgs/distortion_models.hpp"
#include "sensor_msgs/fill_image.hpp"
#include "sensor_msgs/image_encodings.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2/LinearMath/Quaternion.h"
int main(int argc, char ** argv)
{
  std::cout << ament_index_cpp::get_package_share_directory("std_msgs") << std::endl;
  try {
    ament_index_cpp::get_package_prefix("nowhere");
  } catch (const ament_index_cpp::PackageNotFoundError & error) {
    std::cout << error.package_name << " " << ament_index_cpp::has_resource("packages", "nowhere") << std::endl;
  }
  std::cout << rcutils_cli_option_exist(argv, argv + argc, "-h") << rcutils_cli_get_option(argv, argv + argc, "-n")
            << (rcutils_cli_get_option(argv, argv + argc, "-z") == nullptr) << std::endl;

  sensor_msgs::msg::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(2, "xyz", "rgb");
  modifier.resize(3);
  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x"), z(cloud, "z");
  sensor_msgs::PointCloud2Iterator<uint8_t> red(cloud, "r");
  for (int i = 0; i < 3; ++i, ++x, ++z, ++red) {
    *x = i;
    *z = 0.5f * i;
    *red = 10 * i;
  }
  float sum = 0;
  for (sensor_msgs::PointCloud2ConstIterator<float> it(cloud, "x"); it != it.end(); ++it) {sum += it[0] + it[2];}
  std::cout << cloud.point_step << " " << cloud.width << " " << sum << " " << int(cloud.data[2 * 32 + 16 + 2]) << std::endl;

  namespace enc = sensor_msgs::image_encodings;
  std::cout << enc::numChannels(enc::BGR8) << enc::bitDepth(enc::MONO16) << enc::numChannels("32FC2");
  std::cout << enc::isBayer("mono8") << std::endl;

  tf2::Quaternion q(1, 2, 3, 4);
  q[3] = -q[3];  // the way to invert it on the page about quaternions
  const tf2::Quaternion & same = q;
  sensor_msgs::msg::Image image;
  sensor_msgs::fillImage(image, enc::MONO8, 2, 3, 4, "abcdefgh");
  char * copy = rcutils_strdup("text", rcutils_get_default_allocator());
  const char * found = nullptr;
  rcutils_set_env("PROBE", "set");
  std::cout << image.data.size() << image.step << image.data[7] << copy << (rcutils_get_env("PROBE", &found) == nullptr)
            << found << sensor_msgs::distortion_models::PLUMB_BOB << rmw_error_is_set() << std::endl;
  free(copy);
  std::cout << same[0] << same[1] << same[2] << same[3] << q.w() << std::endl;
}
"""


def test_they_do_as_humbles(build):
    env = {**os.environ, "AMENT_PREFIX_PATH": str(UNDERLAY)}
    command = [build("small", PROGRAM), "-n", "five", "-z"]
    done = subprocess.run(command, env=env, capture_output=True, encoding="utf-8", check=True)
    assert done.stdout.splitlines() == [
        f"{UNDERLAY}/share/std_msgs",
        "nowhere 0",
        "0five1",
        "32 3 4.5 20",
        "31620",
        "84htext1setplumb_bob0",
        "123-4-4",
    ]


FILES = """
#include <iostream>
#include "rcpputils/env.hpp"
#include "rcpputils/filesystem_helper.hpp"
#include "rcpputils/thread_safety_annotations.hpp"
#include "rcpputils/time.hpp"
namespace fs = rcpputils::fs;
#include <mutex>
std::mutex lock;
int guarded RCPPUTILS_TSA_GUARDED_BY(lock) = 7;
int main()
{
  fs::path folder = fs::create_temp_directory("probe");
  fs::path deep = folder / "a" / "b.tar.gz";
  std::cout << fs::create_directories(deep) << deep.exists() << deep.is_directory() << deep.is_regular_file();
  std::cout << " " << deep.filename().string() << " " << deep.extension().string() << " ";
  std::cout << fs::remove_extension(deep.filename(), 2).string() << " " << (deep.parent_path() == folder / "a") << std::endl;
  std::cout << fs::remove_all(folder) << folder.exists() << " ";
  rcpputils::set_env_var("PROBE", "x");
  std::cout << rcpputils::get_env_var("PROBE");
  rcpputils::set_env_var("PROBE", nullptr);
  std::cout << "[" << rcpputils::get_env_var("PROBE") << "] ";
  std::cout << rcpputils::convert_to_nanoseconds(std::chrono::milliseconds(3)).count() << " ";
  try {
    rcpputils::convert_to_nanoseconds(std::chrono::hours::max());
  } catch (const std::invalid_argument &) {
    std::cout << "too long" << std::endl;
  }
}
"""


def test_rcpputils_helps_with_files_variables_and_times(build):
    done = subprocess.run([build("files", FILES)], capture_output=True, encoding="utf-8", check=True)
    assert done.stdout == "1110 b.tar.gz .gz b 1\n10 x[] 3000000 too long\n"


NATIVE = """
#include "rclcpp/rclcpp.hpp"
#include "rmw_fastrtps_cpp/get_participant.hpp"
#include "rmw_fastrtps_cpp/get_publisher.hpp"
#include "std_msgs/msg/string.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::Node one("one"), two("two");
  auto participant_of = [](rclcpp::Node & node) {
      rcl_node_t * handle = node.get_node_base_interface()->get_rcl_node_handle();
      eprosima::fastdds::dds::DomainParticipant * found =
        rmw_fastrtps_cpp::get_domain_participant(rcl_node_get_rmw_handle(handle));
      return found;
    };
  auto publisher = one.create_publisher<std_msgs::msg::String>("words", 10);
  rcl_publisher_t * handle = publisher->get_publisher_handle().get();
  eprosima::fastdds::dds::DataWriter * writer = rmw_fastrtps_cpp::get_datawriter(rcl_publisher_get_rmw_handle(handle));
  std::cout << (participant_of(one) == participant_of(one)) << (participant_of(one) == participant_of(two))
            << (reinterpret_cast<size_t>(writer) != 0) << rcl_publisher_is_valid(handle) << std::endl;
}
"""


def test_the_middleware_s_own_objects_have_places(build):
    with (session := Session(virtual=True)).use():
        native = session.launch(make_process(session, build("native", NATIVE), name="native"))
        assert native.wait(10.0) == 0
    assert native.output == "1011\n"


HEADERS = """
#include "rclcpp/rclcpp.hpp"
int main()
{
  std::variant<int, double> either = 0.5;
  std::unordered_set<int> some = {1, 1};
  std::shared_mutex lock;
  std::type_index type = typeid(int);
  std::optional<int> perhaps;
  std::vector<int> numbers = {1, 2};
  std::cout << either.index() << some.size() << (type == typeid(int)) << perhaps.has_value()
            << std::accumulate(numbers.begin(), numbers.end(), 0) << lock.try_lock() << std::endl;
}
"""


def test_rclcpp_brings_the_standard_headers_that_programs_leave_to_it(build):
    assert (
        subprocess.run([build("headers", HEADERS)], capture_output=True, encoding="utf-8", check=True).stdout == "111031\n"
    )
