// SPDX-License-Identifier: MIT
//
// What a client sends: the messages of play.proto, decoded and checked. They came from strangers:
// they are parsed strictly and each refusal says which field is wrong. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "jostle/base/result.h"
#include "server/replication/interest_view.h"
#include "server/world/command.h"

namespace jostle::server {

inline constexpr std::uint32_t protocol_version = 1;
inline constexpr std::size_t client_name_bytes_max = 32;
inline constexpr int hello_channels_max = 64;
inline constexpr std::size_t resume_token_bytes_max = 256;
inline constexpr std::uint32_t hello_kbps_min = 16;
inline constexpr std::uint32_t ack_delay_ms_max = 60'000;

struct Hello {
    std::uint32_t protocol = 0;
    std::string world, ticket, name;
    std::uint32_t snapshot_hz = 0;  // 0: the world's rate
    bool spectator = false;
    bool events = false;
    std::string token;
    std::vector<std::string> channels;  // names of kinds; "*": all
    std::uint32_t codec = 0;            // the highest that it understands; 0: 1
    std::uint32_t max_kbps = 0;         // 0: no bound
    std::optional<Interest> interest;
    bool datagrams = false;
    bool resumable = false;
    struct Resume {
        std::string token;
        std::uint32_t frame = 0;  // 0: none
    };
    std::optional<Resume> resume = {};
};
struct Ack {
    std::uint32_t frame = 0;
    bool need_keyframe = false;
    std::uint32_t ack_delay_ms = 0;
    std::uint32_t ack_bits = 0;  // bit k: frame - 1 - k was decoded, too
};
struct InputBatch {
    std::uint32_t first_sequence = 0;
    std::vector<Result<Action>> inputs;  // an error refuses that input alone
    std::vector<std::uint32_t> ticks;    // one for each: which it is meant for; 0: the next
    std::optional<Ack> ack;
    std::uint32_t client_time_us = 0;
};
struct Ping {
    std::uint64_t client_time_us = 0;
};
struct Leave {};

using ClientMessage = std::variant<Hello, InputBatch, Ack, Ping, Leave, Interest>;

// The bytes of one ClientMessage. An error refuses the whole message.
Result<ClientMessage> decode_client_message(std::string_view bytes);
// Whether the bytes, which may be any, look like an InputBatch: one that should be taken at once.
bool looks_like_inputs(std::string_view bytes);

}  // namespace jostle::server
