// SPDX-License-Identifier: MIT
//
// The play stream's messages to our types and back. Nothing else on the way of a play message knows
// protobuf. What is read came from strangers: it is parsed strictly and each refusal says which
// field is wrong. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/command.h"
#include "host/frame.h"
#include "replication/snapshot_cache.h"

namespace jostle::server {

inline constexpr std::uint32_t protocol_version = 1;
inline constexpr std::size_t client_name_bytes_max = 32;

// --- what a client sends: the messages of play.proto, checked ---

struct Hello {
    std::uint32_t protocol = 0;
    std::string world, ticket, name;
    std::uint32_t snapshot_hz = 0;  // 0: the world's rate
    bool spectator = false;
    bool events = false;
};
struct Ack {
    std::uint32_t frame = 0;
    bool need_keyframe = false;
};
struct InputBatch {
    std::uint32_t first_sequence = 0;
    std::vector<Result<Action>> inputs;  // an error refuses that input alone
    std::optional<Ack> ack;
    std::uint32_t client_time_us = 0;
};
struct Ping {
    std::uint64_t client_time_us = 0;
};
struct Leave {};

using ClientMessage = std::variant<Hello, InputBatch, Ack, Ping, Leave>;

// The bytes of one ClientMessage. An error refuses the whole message.
Result<ClientMessage> decode_client_message(std::string_view bytes);

// --- what the server sends: each function returns the bytes of one ServerMessage ---

struct Welcome {
    ClientId client = 0;
    std::string world_id, world_name;
    std::uint32_t tick = 0;
    double tick_hz = 0;
    std::uint32_t snapshot_hz = 0;
    std::uint32_t ack_window = 0;
    wire::QuantSpec quant;
    std::uint64_t server_time_us = 0;
    physics::Vec3 gravity;
};
enum class NoticeKind { draining, world_closed, refused, rate_limit };

std::string encode_welcome(const Welcome& welcome);
std::string encode_roster(std::span<const std::shared_ptr<const EntityDescription>> added,
                          std::span<const EntityId> removed);
std::string encode_input_results(std::span<const InputResult> results);
std::string encode_pong(std::uint64_t client_time_us, std::uint64_t server_time_us);
std::string encode_world_stats(const Frame& frame, std::uint32_t clients);
std::string encode_notice(NoticeKind kind, const std::string& message);

// --- snapshots and events: a shared piece and a private one, one after the other, are one
// ServerMessage ---

struct Private {
    std::uint32_t input_sequence = 0;
    std::uint32_t echo_client_time_us = 0;
    std::uint32_t snapshots_skipped = 0;
};

// The fields of jostle.v1.Snapshot that all clients share.
std::string encode_shared_snapshot(const EncodedSnapshot& snapshot);
// What stands before them: the field and length of the snapshot in its ServerMessage, then the
// client's own field.
std::string encode_snapshot_head(const Private& own, std::size_t shared_bytes);

// The same for jostle.v1.Events: what a client missed is its own.
std::string encode_shared_events(const TickEvents& events);
std::string encode_events_head(std::uint32_t missed, std::size_t shared_bytes);

}  // namespace jostle::server
