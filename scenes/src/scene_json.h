// SPDX-License-Identifier: MIT
//
// The JSON side of scene files: checks a text against a message's fields before protobuf reads it,
// because protobuf's own messages name neither line nor path.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace google::protobuf {
class Descriptor;
}

namespace jostle::scenes {

// The first thing in the text that is no field of the message or has the wrong kind of value:
// "line 7: bodies[2].shapes[0].radius: there is no such field; did you mean ...". Nothing when all
// is well.
std::optional<std::string> find_json_error(std::string_view text,
                                           const google::protobuf::Descriptor& message);

}  // namespace jostle::scenes
