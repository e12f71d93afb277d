// SPDX-License-Identifier: MIT
//
// JSON validation of scene files: checks a text against the fields of a message before protobuf
// parses it, because errors of protobuf contain neither line nor path.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace google::protobuf {
class Descriptor;
}

namespace jostle::scenes {

// Returns the unknown fields and the values of a wrong type in the text, one a line, such as "line
// 7, column 20: bodies[2].shapes[0].radius: unknown field; did you mean ..."; nullopt if the text
// is valid. A scene may name its "$schema".
std::optional<std::string> find_json_errors(std::string_view text,
                                            const google::protobuf::Descriptor& message);

}  // namespace jostle::scenes
