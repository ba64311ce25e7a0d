"""What a verdict says of an exception of a student's function."""

import pytest
from std_msgs.msg import UInt8
from std_srvs.srv import SetBool

from coursekit.grade.plain import called
from coursekit.grade.verdict import Wrong

state = {"holding": False}


def own_name(request, response):
    if state["holding"]:  # noqa: F823  the mistake
        state = {"holding": request.data}  # noqa: F841


def swapped(response, request):
    return request.data


def swapped_and_filled_in(response, request):
    response.success = True


def misspelt_field(request, response):
    response.sucess = request.data


def other_type(request, response):
    response.message = 1


def out_of_range(request, response):
    UInt8(data=-1)


def misspelt(request, response):
    return stat  # noqa: F821


@pytest.mark.parametrize(
    ("function", "cause"),
    [
        (own_name, "To change one outside, change what is in it, or say `global`."),
        (swapped, "The request comes first, then the response"),
        (swapped_and_filled_in, "The request comes first, then the response"),
        (misspelt_field, "no field of this name"),
        (other_type, "`message` is a field of type str, and takes exactly this type"),
        (out_of_range, "The field `data` does not take this value"),
        (misspelt, "Is it spelled so?"),
        (lambda request, response: request.nothing, "Your function stopped there."),
    ],
)
def test_the_likely_cause_is_that_of_the_exception(function, cause):
    with pytest.raises(Wrong) as wrong:
        called(function, SetBool.Request(), SetBool.Response(), told="lift")
    assert cause in wrong.value.cause
