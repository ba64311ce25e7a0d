// What rcutils does in C: with allocators of a program's own, with arrays that grow, and where something fails.
#include <cerrno>

#include "check.hpp"
#include "rcutils/error_handling.h"
#include "rcutils/filesystem.h"
#include "rcutils/format_string.h"
#include "rcutils/logging_macros.h"
#include "rcutils/macros.h"
#include "rcutils/repl_str.h"
#include "rcutils/split.h"
#include "rcutils/strcasecmp.h"
#include "rcutils/strerror.h"
#include "rcutils/time.h"
#include "rcutils/types/char_array.h"
#include "rcutils/types/string_array.h"
#include "rcutils/types/uint8_array.h"

/// Counts what it gives, and gives nothing more once it is empty.
struct Store
{
  int given = 0;
  int left = 1000;
  bool take() {return left > 0 && (--left, ++given, true);}
};
static rcutils_allocator_t allocator_of(Store & store)
{
  return {
    [](size_t size, void * state) {return static_cast<Store *>(state)->take() ? malloc(size) : nullptr;},
    [](void * pointer, void * state) {
      static_cast<Store *>(state)->given -= pointer != nullptr;
      free(pointer);
    },
    [](void * pointer, size_t size, void * state) {
      auto store = static_cast<Store *>(state);
      if (!store->take()) {
        return static_cast<void *>(nullptr);
      }
      store->given -= pointer != nullptr;
      return realloc(pointer, size);
    },
    [](size_t number, size_t size, void * state) {return static_cast<Store *>(state)->take() ? calloc(number, size) : nullptr;},
    &store};
}

static void allocators()
{
  Store store;
  rcutils_allocator_t own = allocator_of(store);
  char * text = rcutils_strdup("text", own);
  char * made = rcutils_format_string(own, "%d", 7);
  char * other = rcutils_repl_str("a-b", "-", "+", &own);
  char * path = rcutils_join_path("a", "b", own);
  equal("texts are of the memory that is given", store.given, 4);
  for (char * one : {text, made, other, path}) {
    own.deallocate(one, own.state);
  }
  auto nothing = rcutils_get_zero_initialized_uint8_array();
  equal("what was never begun is not ended", rcutils_uint8_array_fini(&nothing), RCUTILS_RET_INVALID_ARGUMENT);
  auto parts = rcutils_get_zero_initialized_string_array();
  (void)rcutils_split("a/b/c", '/', own, &parts);
  auto bytes = rcutils_get_zero_initialized_uint8_array();
  (void)rcutils_uint8_array_init(&bytes, 8, &own);
  equal("lists are, too", store.given, 5);
  check("and give it back", !rcutils_string_array_fini(&parts) && !rcutils_uint8_array_fini(&bytes) && store.given == 0);
  store.left = 2;
  equal("a list whose last text finds no memory is none", rcutils_split("a/b/c", '/', own, &parts), RCUTILS_RET_BAD_ALLOC);
  equal("and keeps none", store.given, 0);
  store.left = 0;
  check("no memory, no text", !rcutils_strdup("text", own) && !rcutils_format_string(own, "%d", 7));
  void * kept = malloc(4);
  check("what cannot grow is given back", !rcutils_reallocf(kept, 8, &own));
  equal(
    "no list without a place for it", rcutils_split("a", '/', rcutils_get_default_allocator(), nullptr),
    RCUTILS_RET_INVALID_ARGUMENT);
}

static std::string joined(const rcutils_string_array_t & array)
{
  std::string all;
  for (size_t i = 0; i < array.size; ++i) {
    all += array.data[i] ? array.data[i] : "-";
  }
  return all;
}
static void lists()
{
  auto allocator = rcutils_get_default_allocator();
  auto list = rcutils_get_zero_initialized_string_array();
  (void)rcutils_split("c/a/b", '/', allocator, &list);
  (void)rcutils_string_array_resize(&list, 4);
  equal("a list grows by empty places", joined(list), "cab-");
  equal("a list is put in order", rcutils_string_array_sort(&list), RCUTILS_RET_OK);
  equal("empty places are its last", joined(list), "abc-");
  int order;
  equal("lists with empty places have no order", rcutils_string_array_cmp(&list, &list, &order), RCUTILS_RET_ERROR);
  (void)rcutils_string_array_resize(&list, 2);
  equal("a list becomes shorter", joined(list), "ab");
  (void)rcutils_string_array_fini(&list);
}

static rcutils_ret_t printed(rcutils_char_array_t * array, const char * format, ...)
{
  va_list args;
  va_start(args, format);
  rcutils_ret_t done = rcutils_char_array_vsprintf(array, format, args);
  va_end(args);
  return done;
}
static void texts()
{
  auto allocator = rcutils_get_default_allocator();
  auto text = rcutils_get_zero_initialized_char_array();
  (void)rcutils_char_array_init(&text, 2, &allocator);
  (void)rcutils_char_array_strcpy(&text, "one");
  (void)rcutils_char_array_strncat(&text, " two", 2);
  equal("a text with a part of another", std::string(text.buffer), "one t");
  equal("its end counts", text.buffer_length, 6u);
  (void)printed(&text, "%s %d", "number", 12);
  equal("a text is printed over what was there", std::string(text.buffer), "number 12");
  (void)rcutils_char_array_memcpy(&text, "xyz", 2);
  equal("only so many letters are copied", std::string(text.buffer, text.buffer_length), "xy");
  size_t before = text.buffer_capacity;
  (void)rcutils_char_array_expand_as_needed(&text, 1);
  equal("a text that has enough is not made smaller", text.buffer_capacity, before);
  equal("no text of no length", rcutils_char_array_resize(&text, 0), RCUTILS_RET_INVALID_ARGUMENT);
  (void)rcutils_char_array_fini(&text);
  char own[] = "mine";
  rcutils_char_array_t lent{own, false, sizeof own, sizeof own, allocator};
  (void)rcutils_char_array_strcat(&lent, " too");
  check("a text of somebody else's memory is copied as it grows", lent.owns_buffer && own == std::string("mine"));
  (void)rcutils_char_array_fini(&lent);

  char shown[64];
  check("what has no place is measured", rcutils_snprintf(nullptr, 0, "%d", 123) == 3);
  check("no place, or no room, is no print", rcutils_snprintf(nullptr, 9, "1") == -1 && rcutils_snprintf(shown, 0, "1") == -1);
  int order = 0;
  check("cases are alike", rcutils_strcasecmp("ROS 2", "ros 2", &order) == 0 && order == 0);
  check("the shorter comes first", rcutils_strcasecmp("ab", "ABC", &order) == 0 && order < 0);
  check("only so many letters are compared", rcutils_strncasecmp("abx", "ABC", 2, &order) == 0 && order == 0);
  equal("nothing is not compared", rcutils_strcasecmp(nullptr, "a", &order), -1);
  equal("names are put together", std::string(RCUTILS_STRINGIFY(RCUTILS_JOIN(left, right))), "leftright");
  errno = ENOENT;
  rcutils_strerror(shown, sizeof shown);
  equal("an error of the system", std::string(shown), "No such file or directory");
  equal("the system's time needs a place", rcutils_system_time_now(nullptr), RCUTILS_RET_INVALID_ARGUMENT);
  equal("so does the steady time", rcutils_steady_time_now(nullptr), RCUTILS_RET_INVALID_ARGUMENT);
  int64_t time = -1500000002;
  (void)rcutils_time_point_value_as_nanoseconds_string(&time, shown, sizeof shown);
  equal("nanoseconds in nineteen digits", std::string(shown), "-0000000001500000002");
  (void)rcutils_time_point_value_as_seconds_string(&time, shown, sizeof shown);
  equal("seconds in ten, and a fraction", std::string(shown), "-0000000001.500000002");
}

static int first_of(const int * numbers)
{
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(numbers, -1);
  return numbers[0];
}
static void errors()
{
  int level = 0;
  rcutils_reset_error();
  check("an argument that is missing", first_of(nullptr) == -1 && rcutils_error_is_set());
  equal("is named", std::string(rcutils_get_error_state()->message), "numbers argument is null");
  rcutils_reset_error();
  RCUTILS_SET_ERROR_MSG_WITH_FORMAT_STRING("%d of %s", 3, "four");
  equal("an error with numbers", std::string(rcutils_get_error_state()->message), "3 of four");
  rcutils_reset_error();
  equal("a level without a name", rcutils_logging_severity_level_from_string("LOUD", rcutils_get_default_allocator(), &level), 41);
  auto none = rcutils_get_zero_initialized_allocator();
  auto bytes = rcutils_get_zero_initialized_uint8_array();
  equal("no allocator, no bytes", rcutils_uint8_array_init(&bytes, 4, &none), RCUTILS_RET_INVALID_ARGUMENT);
  check("what fails says why", rcutils_error_is_set());
  rcutils_reset_error();
}

static std::string said;
static const rcutils_log_location_t * place = nullptr;
static void hear(const rcutils_log_location_t * where, int severity, const char * name, int64_t, const char * format, va_list * args)
{
  char line[64];
  vsnprintf(line, sizeof line, format, *args);
  said += std::to_string(severity) + name + line;
  place = where;
}
static void lines()
{
  check("logging begins by itself or is begun", rcutils_logging_initialize() == RCUTILS_RET_OK && g_rcutils_logging_initialized);
  auto before = rcutils_logging_get_output_handler();
  rcutils_logging_set_output_handler(hear);
  rcutils_log(nullptr, RCUTILS_LOG_SEVERITY_WARN, "ears", " %d walls;", 3);
  rcutils_log(nullptr, RCUTILS_LOG_SEVERITY_DEBUG, "ears", "not heard");
  equal("a line without a macro", said, "30ears 3 walls;");
  said.clear();
  const int first = 1, next = 2, at = 3;
  RCUTILS_LOG_WARN_THROTTLE_NAMED(RCUTILS_STEADY_TIME, 1000, "ears", " %d%d%d", first, next, at);
  rcutils_logging_set_output_handler(before);
  equal("a throttled line of the program's own variables", said, "30ears 123");
  equal("where it was said stays known", std::string(place->function_name), "lines");
  rcutils_logging_set_default_logger_level(RCUTILS_LOG_SEVERITY_FATAL);
  rcutils_logging_set_default_logger_level(RCUTILS_LOG_SEVERITY_UNSET);
  equal("without a level loggers have that of the beginning", rcutils_logging_get_default_logger_level(), 20);
  equal("no name, no level", rcutils_logging_get_logger_effective_level(nullptr), -1);
  equal("the level of a part of a name", rcutils_logging_get_logger_leveln("ears.left", 4), 0);
  (void)rcutils_logging_set_logger_level("ears", RCUTILS_LOG_SEVERITY_ERROR);
  equal("that was set", rcutils_logging_get_logger_leveln("ears.left", 4), 40);
}

int main()
{
  allocators();
  lists();
  texts();
  errors();
  lines();
}
