// Reads a file of lengths and bytes, each as what the session might send: none may do more than throw.
#include <fstream>
#include <iostream>

#include "coursekit/frame.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"

template<class F>
static int refused(const std::string & bytes, F read)
{
  try {
    coursekit::Unpacker frame{bytes};
    read(frame);
    return 0;
  } catch (const std::runtime_error &) {
    return 1;
  } catch (const std::length_error &) {
    return 1;
  }
}
int main(int, char ** argv)
{
  std::ifstream file(argv[1], std::ios::binary);
  int count = 0, bad = 0;
  for (uint32_t size; file.read(reinterpret_cast<char *>(&size), 4); ++count) {
    std::string bytes(size, '\0');
    file.read(&bytes[0], size);
    bad += refused(bytes, [](auto & frame) {
          for (;;) {
            frame.s();
          }
        });
    bad += refused(bytes, [](auto & frame) {frame.i(), frame.d(), frame.s(), frame.rest();});
    bad += refused(bytes, [&](auto &) {
          sensor_msgs::msg::PointCloud2 cloud;
          coursekit::from_cdr(bytes, cloud);
        });
    bad += refused(bytes, [&](auto &) {
          rcl_interfaces::msg::ParameterEvent event;
          coursekit::from_cdr(bytes, event);
        });
  }
  std::cout << count << " " << (bad > count) << std::endl;
}
