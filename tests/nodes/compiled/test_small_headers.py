"""What C++ programs find beside rclcpp: the package index, options, clouds and encodings."""

from __future__ import annotations

import os
import subprocess

from coursekit.interfaces.find import UNDERLAY

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
