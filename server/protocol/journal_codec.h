// SPDX-License-Identifier: MIT
//
// What was done to a world, tick by tick, as bytes.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/journaled_command.h"
#include "jostle/base/result.h"

namespace jostle::server {

// Ticks in rising order; one in which nothing was done may be left out.
std::string encode_journal(std::span<const JournaledTick> ticks);
// corrupt_data: the bytes are no such journal.
Result<std::vector<JournaledTick>> decode_journal(std::string_view bytes);

}  // namespace jostle::server
