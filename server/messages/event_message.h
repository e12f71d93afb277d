// SPDX-License-Identifier: MIT
//
// What happened in a tick, as the Events message of play.proto: a piece that all who asked share,
// and before it one of the client's own. The two, one after the other, are a field of a Snapshot.
// Pure functions; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "server/world/tick_events.h"

namespace jostle::server {

std::string encode_shared_events(const TickEvents& events);
// `missed`: ticks with events that this client was not sent since the last ones.
std::string encode_events_header(std::uint32_t missed, std::size_t shared_bytes);

}  // namespace jostle::server
