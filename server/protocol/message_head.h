// SPDX-License-Identifier: MIT
//
// The beginning of a ServerMessage whose end is shared by many clients (out_message.h).
#pragma once

#include <google/protobuf/message_lite.h>

#include <cstddef>
#include <string>

namespace jostle::server {

// A field of ServerMessage whose content is `own` and, after these bytes, `shared_bytes` more: its
// tag, its length, then the fields of `own`.
std::string encode_head(int field_number, const google::protobuf::MessageLite& own,
                        std::size_t shared_bytes);

}  // namespace jostle::server
