// rcutils, rcpputils, rcppmath, function traits, parameters copied, where log lines go.
#include <cstdarg>
#include <fstream>

#include "check.hpp"
#include "console_bridge/console.h"
#include "libstatistics_collector/moving_average_statistics/moving_average.hpp"
#include "libstatistics_collector/moving_average_statistics/types.hpp"
#include "rclcpp/copy_all_parameter_values.hpp"
#include "rclcpp/function_traits.hpp"
#include "rclcpp/node_interfaces/node_topics.hpp"
#include "rclcpp_action/visibility_control.hpp"
#include "rcppmath/clamp.hpp"
#include "rcppmath/rolling_mean_accumulator.hpp"
#include "rcpputils/endian.hpp"
#include "rcpputils/filesystem_helper.hpp"
#include "rcpputils/find_and_replace.hpp"
#include "rcpputils/find_library.hpp"
#include "rcpputils/pointer_traits.hpp"
#include "rcpputils/process.hpp"
#include "rcpputils/shared_library.hpp"
#include "rcutils/filesystem.h"
#include "rcutils/find.h"
#include "rcutils/format_string.h"
#include "rcutils/isalnum_no_locale.h"
#include "rcutils/process.h"
#include "rcutils/repl_str.h"
#include "rcutils/split.h"
#include "rcutils/types.h"
#include "rcutils/types/string_array.h"
#include "tracetools/tracetools.h"

using rcpputils::fs::path;

static void paths()
{
  equal("joined", (path("foo") / "bar").string(), "foo/bar");
  equal("an absolute path wins", (path("foo") / path("/bar")).string(), "/bar");
  equal("parent", path("/foo/bar").parent_path().string(), "/foo");
  equal("parent of a name", path("foo").parent_path().string(), ".");
  equal("parent of the root", path("/").parent_path().string(), "/");
  equal("parent of nothing", path("").parent_path().string(), "");
  equal("backslashes", path("\\foo\\bar").string(), "/foo/bar");
  equal("extension", path("/foo/baz.bar.yml").extension().string(), ".yml");
  equal("two extensions gone", rcpputils::fs::remove_extension("foo.txt.zip", 2).string(), "foo");
  path three("a/b/c");
  equal("parts", std::distance(three.cbegin(), three.cend()), 3);
  check("nothing is not there", !path("").exists() && path("").empty());
  check("no folder without a name", !rcpputils::fs::create_directories(path("")));

  path folder = rcpputils::fs::create_temp_directory("probe");
  check("a new folder", folder.is_directory() && !folder.is_regular_file());
  path file = folder / "test.txt";
  std::ofstream(file.string()) << "test";
  equal("size", file.file_size(), 4u);
  throws<std::system_error>("a folder has no size", [&] {folder.file_size();});
  check("a file is no folder", !rcpputils::fs::create_directories(file));
  check("what is full stays", !rcpputils::fs::remove(folder));
  check("all goes", rcpputils::fs::remove_all(folder) && !folder.exists());
  check("nothing to remove", !rcpputils::fs::remove_all(folder));
  throws<std::system_error>("no folder below a name", [] {rcpputils::fs::create_temp_directory("no/name");});
  std::ostringstream text;
  text << path("foo");
  equal("printed", text.str(), "foo");
  setenv("ROS_LOG_DIR", "/tmp/logs", 1);
  equal("log folder", rclcpp::get_logging_directory().string(), "/tmp/logs");
  unsetenv("ROS_LOG_DIR");
  setenv("ROS_HOME", "/tmp/home", 1);
  equal("log folder in ROS_HOME", rclcpp::get_logging_directory().string(), "/tmp/home/log");
}

static void texts()
{
  equal("replaced", rcpputils::find_and_replace("foo\rbar\rbaz", "\r", "NEW"), "fooNEWbarNEWbaz");
  auto allocator = rcutils_get_default_allocator();
  rcutils_string_array_t parts = rcutils_get_zero_initialized_string_array();
  rcutils_split("/hello//world/", '/', allocator, &parts);
  check("split", parts.size == 2 && std::string(parts.data[0]) + "," + parts.data[1] == "hello,world");
  equal("freed", rcutils_string_array_fini(&parts), RCUTILS_RET_OK);
  rcutils_split_last("hello/w/orld", '/', allocator, &parts);
  check("split at the last", parts.size == 2 && std::string(parts.data[0]) + "," + parts.data[1] == "hello/w,orld");
  (void)rcutils_string_array_fini(&parts);
  equal("found", rcutils_find("a.b.c", '.') * 10 + rcutils_find_last("a.b.c", '.'), 13u);
  equal("not found", rcutils_find("abc", '.'), SIZE_MAX);
  char * made = rcutils_format_string(allocator, "%d %s", 42, "answers");
  equal("formatted", std::string(made), "42 answers");
  free(made);
  made = rcutils_repl_str("a-b-c", "-", "+", &allocator);
  equal("replaced in C", std::string(made), "a+b+c");
  free(made);
  char buffer[8];
  equal("length of what would be printed", rcutils_snprintf(buffer, sizeof(buffer), "%s", "much too long"), 13);
  check("letters and digits", rcutils_isalnum_no_locale('7') && rcutils_isalnum_no_locale('z') && !rcutils_isalnum_no_locale('_'));
  rcutils_char_array_t grown = rcutils_get_zero_initialized_char_array();
  (void)rcutils_char_array_init(&grown, 4, &allocator);
  (void)rcutils_char_array_strcat(&grown, "one ");
  (void)rcutils_char_array_strcat(&grown, "more");
  equal("text that grows", std::string(grown.buffer), "one more");
  (void)rcutils_char_array_fini(&grown);
  made = rcutils_join_path("foo", "bar", allocator);
  equal("path in C", std::string(made), "foo/bar");
  free(made);
  check("folder in C", rcutils_is_directory("/") && !rcutils_is_file("/") && !rcutils_exists("/nowhere"));
}

static void program()
{
  equal("the program's name", rcpputils::get_executable_name(), "utilities");
  check("its number", rcutils_get_pid() > 0);
  equal("a library's name", rcpputils::get_platform_library_name("foo"), "libfoo.so");
  throws<std::runtime_error>("no such library", [] {rcpputils::SharedLibrary("libnowhere.so");});
  rcpputils::SharedLibrary maths("libm.so.6");
  check("a symbol", maths.has_symbol("cos") && !maths.has_symbol("no_such_symbol"));
  auto cosine = reinterpret_cast<double (*)(double)>(maths.get_symbol("cos"));
  equal("called", cosine(0.0), 1.0);
  throws<std::runtime_error>("no such symbol", [&] {maths.get_symbol("no_such_symbol");});
  equal("not on the way", rcpputils::find_library_path("nowhere"), "");
  check("order of bytes", rcpputils::endian::native == rcpputils::endian::little);
  TRACEPOINT(anything, 1);
}

static int function(double) {return 0;}
struct Thing
{
  void method(int, std::string) {}
};

static void traits()
{
  using namespace rclcpp::function_traits;
  auto lambda = [](int, const std::string &) {return 1.5;};
  equal("arity", function_traits<decltype(lambda)>::arity, 2u);
  check("argument", std::is_same_v<function_traits<decltype(lambda)>::argument_type<1>, const std::string &>);
  check("returned", std::is_same_v<function_traits<decltype(lambda)>::return_type, double>);
  equal("of a function", function_traits<decltype(&function)>::arity, 1u);
  equal("of std::function", function_traits<std::function<void (int, int, int)>>::arity, 3u);
  auto bound = std::bind(&Thing::method, Thing(), std::placeholders::_1, std::placeholders::_2);
  check("of std::bind", std::is_same_v<function_traits<decltype(bound)>::argument_type<0>, int>);
  check("the same", same_arguments<decltype(&function), void (*)(double)>::value);
  check("checked", check_arguments<decltype(lambda), int, const std::string &>::value);
  check("pointers", rcpputils::is_pointer<std::shared_ptr<int>>::value && rcpputils::is_pointer<int *>::value &&
    !rcpputils::is_pointer<int>::value && std::is_same_v<rcpputils::remove_pointer<std::unique_ptr<int>>::type, int>);
}

static void numbers()
{
  rcppmath::RollingMeanAccumulator<double> mean(3);
  for (double value : {100.0, 1.0, 2.0, 3.0}) {
    mean.accumulate(value);
  }
  equal("mean of the last three", mean.getRollingMean(), 2.0);
  equal("clamped", rcppmath::clamp(7, 0, 5), 5);
  libstatistics_collector::moving_average_statistics::MovingAverageStatistics all;
  check("nothing measured", std::isnan(all.Average()) && all.GetCount() == 0);
  for (double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0, std::nan("")}) {
    all.AddMeasurement(value);
  }
  equal("average", all.Average(), 5.0);
  equal("deviation", all.StandardDeviation(), 2.0);
  equal("extremes", all.Max() - all.Min(), 7.0);
  equal("what is no number does not count", all.GetCount(), 8u);
  all.Reset();
  equal("from the beginning", all.GetCount(), 0u);
}

static void copies()
{
  auto from = std::make_shared<rclcpp::Node>("from"), to = std::make_shared<rclcpp::Node>("to");
  from->declare_parameter("speed", 1.5);
  from->declare_parameter("name", "walker");
  to->declare_parameter("name", "own");
  rclcpp::copy_all_parameter_values(from, to);
  equal("declared and set", to->get_parameter("speed").as_double(), 1.5);
  equal("its own is kept", to->get_parameter("name").as_string(), "own");
  rclcpp::copy_all_parameter_values(from, to, true);
  equal("or replaced", to->get_parameter("name").as_string(), "walker");
}

static std::string heard;
static void hear(const rcutils_log_location_t * where, int severity, const char * name, int64_t, const char * format, va_list * args)
{
  char line[100];
  vsnprintf(line, sizeof(line), format, *args);
  heard += std::to_string(severity) + " " + name + " " + line + (where->line_number > 0 ? ";" : "?");
}
static void show_and_hear(
  const rcutils_log_location_t * where, int severity, const char * name, int64_t time, const char * format, va_list * args)
{
  rcutils_logging_console_output_handler(where, severity, name, time, format, args);
  hear(where, severity, name, time, format, args);
}

static void log_lines()
{
  auto before = rcutils_logging_get_output_handler();
  check("a handler from the beginning", before == &rcutils_logging_console_output_handler);
  rcutils_logging_set_output_handler(hear);
  RCLCPP_WARN(rclcpp::get_logger("ears"), "%d walls", 3);
  CONSOLE_BRIDGE_logInform("said %s", "elsewhere");
  rcutils_logging_set_output_handler(before);
  RCLCPP_INFO(rclcpp::get_logger("ears"), "not heard");
  equal("lines for a handler of its own", heard, "30 ears 3 walls;20 console_bridge said elsewhere;");
  heard.clear();
  rcutils_logging_set_output_handler(show_and_hear);
  RCLCPP_WARN(rclcpp::get_logger("ears"), "%d of %s", 5, "seven");
  rcutils_logging_set_output_handler(before);
  equal("the terminal's handler leaves the arguments to others", heard, "30 ears 5 of seven;");
}

static void errors_of_c()
{
  namespace errors = rclcpp::exceptions;
  throws<std::invalid_argument>("what succeeded is no error", [] {errors::throw_from_rcl_error(RCL_RET_OK);});
  throws<std::runtime_error>("an error has a reason", [] {errors::throw_from_rcl_error(RCL_RET_ERROR);});
  RCL_SET_ERROR_MSG("too far");
  try {
    errors::throw_from_rcl_error(RCL_RET_INVALID_ARGUMENT, "the arm");
  } catch (const errors::RCLErrorBase & error) {
    equal("what it is about, and the reason", std::string(error.formatted_message), "the arm: too far");
    equal("what was returned", error.ret, RCL_RET_INVALID_ARGUMENT);
  }
  check("the error was taken", !rcl_error_is_set());
  equal(
    "a parameter of a wrong type", std::string(errors::InvalidParameterTypeException("x", "none").what()),
    "parameter 'x' has invalid type: none");
}
static void too_early()
{
  try {
    rclcpp::Node node("early");
    check("no node before init", false);
  } catch (const rclcpp::exceptions::RCLError & error) {
    equal(
      "no node before init", std::string(error.what()),
      "failed to create guard condition: the given context is not valid, either rcl_init() was not called or rcl_shutdown() "
      "was called., at ./src/rcl/guard_condition.c:67");
  }
}

int main(int argc, char ** argv)
{
  errors_of_c();
  too_early();
  rclcpp::init(argc, argv);
  paths();
  texts();
  program();
  traits();
  numbers();
  copies();
  log_lines();
  auto node = std::make_shared<rclcpp::Node>("late");
  rclcpp::shutdown();
  throws<rclcpp::exceptions::RCLError>("nothing spins after shutdown", [&] {rclcpp::spin(node);});
  throws<rclcpp::exceptions::RCLError>(
    "no client after shutdown", [&] {rclcpp::AsyncParametersClient client(node, "other");});
}
