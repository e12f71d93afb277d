// SPDX-License-Identifier: MIT
//
// The events of a tick as the Events message of play.proto: a shared piece for all subscribers,
// preceded by a piece for one client. Both pieces together are one field of a Snapshot. Pure
// functions; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "server/world/tick_events.h"

namespace jostle::server {

std::string encode_shared_events(const TickEvents& events);
// `missed`: ticks with events since the last Events that this client was not sent.
std::string encode_events_header(std::uint32_t missed, std::size_t shared_bytes);

}  // namespace jostle::server
