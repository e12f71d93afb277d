// SPDX-License-Identifier: MIT
//
// Decodes and validates client messages (play.proto). They are untrusted: parsing is strict, and
// each error names the invalid field. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "jostle/base/result.h"
#include "server/replication/interest_view.h"
#include "server/replication/pose_cache.h"
#include "server/world/command.h"

namespace jostle::v1 {
class Input;
}

namespace jostle::server {

inline constexpr std::uint32_t protocol_version = 1;
inline constexpr std::size_t client_name_bytes_max = 32;
inline constexpr int hello_channels_max = 64, hello_topics_max = 64;
inline constexpr std::size_t join_code_bytes_max = RoomProperties::join_code_bytes_max;
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
    std::vector<std::string> channels;  // names of channel kinds; "*": all
    std::uint32_t codec = 0;            // highest codec the client supports; 0: codec 1
    std::uint32_t max_kbps = 0;         // 0: unlimited
    std::optional<Interest> interest;
    std::optional<StreamPrecision> precision = {};  // nothing: the world's
    bool packed_entities = false;
    bool datagrams = false;
    bool resumable = false;
    struct Resume {
        std::string token;
        std::uint32_t frame = 0;    // 0: none
        std::uint32_t message = 0;  // number of the last user message; 0: none
    };
    std::optional<Resume> resume = {};
    bool joints = false;
    bool room = false;
    bool players = false, attributes = false;
    std::vector<std::string> topics = {};  // of user messages; "*": all
    std::optional<std::uint32_t> color = {};
    std::string join_code = {};  // of a private room
};
struct Ack {
    std::uint32_t frame = 0;
    bool need_keyframe = false;
    std::uint32_t ack_delay_ms = 0;
    std::uint32_t ack_bits = 0;  // bit k: frame - 1 - k was decoded as well
};
struct InputBatch {
    std::uint32_t first_sequence = 0;
    std::vector<Result<Action>> inputs;  // an error rejects that input only
    std::vector<std::uint32_t> ticks;    // one per input: its scheduled tick; 0: the next one
    std::optional<Ack> ack;
    std::uint32_t client_time_us = 0;
};
struct Ping {
    std::uint64_t client_time_us = 0;
};
struct Leave {};

using ClientMessage = std::variant<Hello, InputBatch, Ack, Ping, Leave, Interest>;

// Decodes the bytes of one ClientMessage. An error rejects the entire message.
Result<ClientMessage> decode_client_message(std::string_view bytes);
// Decodes one input. An error names the field.
Result<Action> decode_input(const v1::Input& input);
// Whether the bytes look like an InputBatch, which should be processed at once. Accepts arbitrary
// bytes.
bool looks_like_inputs(std::string_view bytes);

}  // namespace jostle::server
