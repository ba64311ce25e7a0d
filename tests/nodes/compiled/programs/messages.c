/* What C does with messages: they are made, filled, compared, copied and given back. */
#include <stdio.h>

#include "rosidl_runtime_c/primitives_sequence_functions.h"
#include "rosidl_runtime_c/string_functions.h"
#include "rosidl_runtime_c/u16string_functions.h"
#include "std_msgs/msg/detail/string__functions.h"
#include "std_srvs/srv/set_bool.h"
#include "test_msgs/action/fibonacci.h"
#include "test_msgs/msg/arrays.h"
#include "test_msgs/msg/constants.h"
#include "test_msgs/msg/defaults.h"
#include "test_msgs/msg/empty.h"
#include "test_msgs/msg/strings.h"
#include "test_msgs/msg/unbounded_sequences.h"
#include "test_msgs/msg/w_strings.h"

static void say(const char * what, bool holds) {printf("%s %s\n", holds ? "ok" : "not ok", what);}

static void texts(void)
{
  rosidl_runtime_c__String a, b;
  say("a text begins empty", rosidl_runtime_c__String__init(&a) && !a.size && a.capacity == 1 && !a.data[0]);
  rosidl_runtime_c__String__init(&b);
  say("texts are assigned", rosidl_runtime_c__String__assign(&a, "hello") && a.size == 5 && a.capacity == 6);
  say("and their beginnings", rosidl_runtime_c__String__assignn(&b, "hello you", 5) && rosidl_runtime_c__String__are_equal(&a, &b));
  say("not from nothing", !rosidl_runtime_c__String__assign(&a, NULL) && !rosidl_runtime_c__String__init(NULL));
  rosidl_runtime_c__String__fini(&a);
  say("nothing is left", !a.data && !a.size && !a.capacity);
  rosidl_runtime_c__String__fini(&b);
  rosidl_runtime_c__String__Sequence * all = rosidl_runtime_c__String__Sequence__create(2);
  say("sequences of texts", all && all->size == 2 && all->data[1].capacity == 1);
  rosidl_runtime_c__String__Sequence__destroy(all);
}

static void defaults(void)
{
  test_msgs__msg__Defaults one;
  say("defaults", test_msgs__msg__Defaults__init(&one) && one.bool_value && one.uint8_value == 200 && one.float64_value == 1.125);
  test_msgs__msg__Defaults__fini(&one);
  test_msgs__msg__Strings text;
  test_msgs__msg__Strings__init(&text);
  say("defaults of texts", !strcmp(text.string_value_default1.data, "Hello world!"));
  say("bounds", test_msgs__msg__Strings__bounded_string_value__MAX_STRING_SIZE == 22);
  test_msgs__msg__Strings__fini(&text);
  test_msgs__msg__WStrings wide;
  test_msgs__msg__WStrings__init(&wide);
  say("defaults of wide texts", wide.wstring_value_default1.size == 12 && wide.wstring_value_default1.data[0] == 'H');
  test_msgs__msg__WStrings__fini(&wide);
  say("constants", test_msgs__msg__Constants__UINT8_CONST == 200 && test_msgs__msg__Constants__BOOL_CONST);
  say("an empty message has a byte", sizeof(test_msgs__msg__Empty) == 1);
}

static void copies(void)
{
  test_msgs__msg__UnboundedSequences * one = test_msgs__msg__UnboundedSequences__create();
  test_msgs__msg__UnboundedSequences * other = test_msgs__msg__UnboundedSequences__create();
  say("defaults of sequences", one->int32_values_default.size == 3 && one->string_values_default.size == 3);
  rosidl_runtime_c__double__Sequence__fini(&one->float64_values);
  rosidl_runtime_c__double__Sequence__init(&one->float64_values, 3);
  one->float64_values.data[2] = 0.5;
  test_msgs__msg__BasicTypes__Sequence__init(&one->basic_types_values, 2);
  one->basic_types_values.data[1].int16_value = 7;
  say("different", !test_msgs__msg__UnboundedSequences__are_equal(one, other));
  say("copied", test_msgs__msg__UnboundedSequences__copy(one, other) && test_msgs__msg__UnboundedSequences__are_equal(one, other));
  one->basic_types_values.data[1].int16_value = 8;
  say("a copy is its own", other->basic_types_values.data[1].int16_value == 7);
  test_msgs__msg__UnboundedSequences__destroy(one);
  test_msgs__msg__UnboundedSequences__destroy(other);
  test_msgs__msg__Arrays__Sequence * all = test_msgs__msg__Arrays__Sequence__create(2);
  say("arrays", rosidl_runtime_c__String__assign(&all->data[1].string_values[2], "last"));
  say("and their copies", test_msgs__msg__Arrays__copy(&all->data[1], &all->data[0]) && !strcmp(all->data[0].string_values[2].data, "last"));
  test_msgs__msg__Arrays__Sequence__destroy(all);
}

static void earlier_names(void)
{
  rosidl_runtime_c__float32__Sequence numbers;
  rosidl_runtime_c__float__Sequence same;
  rosidl_runtime_c__bool__Sequence truths;
  rosidl_runtime_c__byte__Sequence bytes;
  rosidl_runtime_c__float64__Sequence wide;
  bool made = rosidl_runtime_c__float32__Sequence__init(&numbers, 2) && rosidl_runtime_c__float__Sequence__init(&same, 0);
  made = rosidl_runtime_c__bool__Sequence__init(&truths, 1) && rosidl_runtime_c__byte__Sequence__init(&bytes, 1) && made;
  made = rosidl_runtime_c__float64__Sequence__init(&wide, 1) && made;
  say("sequences have their earlier names", made && rosidl_runtime_c__float32__Sequence__copy(&numbers, &same));
  say("which are the same types", rosidl_runtime_c__float__Sequence__are_equal(&numbers, &same) && same.size == 2);
  rosidl_runtime_c__float32__Sequence__fini(&numbers);
  rosidl_runtime_c__float__Sequence__fini(&same);
  rosidl_runtime_c__bool__Sequence__fini(&truths);
  rosidl_runtime_c__byte__Sequence__fini(&bytes);
  rosidl_runtime_c__float64__Sequence__fini(&wide);
}

int main(void)
{
  earlier_names();
  texts();
  defaults();
  copies();
  std_srvs__srv__SetBool_Response * said = std_srvs__srv__SetBool_Response__create();
  test_msgs__action__Fibonacci_Feedback * feedback = test_msgs__action__Fibonacci_Feedback__create();
  say("parts of services and actions", said && !said->message.size && feedback && !feedback->sequence.size);
  std_srvs__srv__SetBool_Response__destroy(said);
  test_msgs__action__Fibonacci_Feedback__destroy(feedback);
  return 0;
}
