// SPDX-License-Identifier: MIT
//
// Encodes the start of a ServerMessage whose end is shared by many clients (out_message.h).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace jostle::server {

// The header of a field whose content is `own` followed by `shared_bytes` more bytes: tag, length,
// then `own`.
std::string encode_header(int field_number, std::string_view own, std::size_t shared_bytes);

}  // namespace jostle::server
