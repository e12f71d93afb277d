// SPDX-License-Identifier: MIT
//
// The beginning of a ServerMessage whose end is shared by many clients (out_message.h).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace jostle::server {

// A field of a message whose content is `own` and, after these bytes, `shared_bytes` more: its
// tag, its length, then `own`.
std::string encode_header(int field_number, std::string_view own, std::size_t shared_bytes);

}  // namespace jostle::server
