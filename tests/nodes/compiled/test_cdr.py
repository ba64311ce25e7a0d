"""Every structure of every interface, filled at random, goes from Python to C++ and back without a change of a byte."""

from __future__ import annotations

import random
import struct
import subprocess

from coursekit.interfaces.cdr import serialize
from coursekit.interfaces.cpp_source import header_name, messages_of
from coursekit.interfaces.find import known_interfaces
from coursekit.interfaces.registry import interface_of, load
from tests.interfaces.filling import fill

MAIN = """
#include <cstdio>
{includes}
template<class M>
std::string again(const std::string & bytes)
{{
  M message;
  coursekit::from_cdr(bytes, message);
  return coursekit::to_cdr(message);
}}
using Again = std::string (*)(const std::string &);
static const Again all[] = {{{entries}}};
int main()
{{
  uint32_t head[2];
  while (fread(head, 4, 2, stdin) == 2) {{
    std::string bytes(head[1], 0);
    if (fread(&bytes[0], 1, head[1], stdin) != head[1]) {{return 1;}}
    std::string result = all[head[0]](bytes);
    uint32_t size = static_cast<uint32_t>(result.size());
    fwrite(&size, 4, 1, stdout);
    fwrite(result.data(), 1, size, stdout);
  }}
}}
"""


def test_cdr_is_the_same_on_both_sides(build):
    interfaces = [interface_of(name) for name in known_interfaces()]
    names = [message.full_name for interface in interfaces for message in messages_of(interface)]
    parts = [interface.full_name.split("/") for interface in interfaces]
    includes = "\n".join(f'#include "{package}/{kind}/{header_name(name)}.hpp"' for package, kind, name in parts)
    entries = ", ".join(f"again<{'::'.join(name.split('/'))}>" for name in names)
    program = build("all_types", MAIN.format(includes=includes, entries=entries))
    dice = random.Random(1)
    sent = [(number, serialize(fill(load(name)(), dice))) for number, name in enumerate(names) for _ in range(3)]
    data = b"".join(struct.pack("<II", number, len(cdr)) + cdr for number, cdr in sent)
    came = subprocess.run([program], input=data, capture_output=True, check=True).stdout
    at, differ = 0, []
    for number, cdr in sent:
        (size,) = struct.unpack_from("<I", came, at)
        differ += [names[number]] * (came[at + 4 : at + 4 + size] != cdr)
        at += 4 + size
    assert len(names) > 700 and differ == []
