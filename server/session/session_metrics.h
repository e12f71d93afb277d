// SPDX-License-Identifier: MIT
//
// Metrics of one session, and its client's entry in ConnectedClients. Without metrics, only the
// entry is updated. Used on the session's thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "server/limits/connected_clients.h"
#include "server/messages/out_message.h"
#include "server/session/play_context.h"
#include "server/session/snapshot_schedule.h"
#include "server/session/snapshot_section.h"
#include "server/world/command.h"
#include "server/world/world_host.h"

namespace jostle::server {

class SessionMetrics {
public:
    explicit SessionMetrics(PlayContext& context) : context_(context) {}

    // The subject of the admitted client; anonymous_subject without a token.
    void set_subject(const std::string& subject) { subject_ = subject; }
    const std::string& subject() const { return subject_; }
    // The client entered a world, which must exist until left().
    void entered(ClientIdentity who, WorldHost& world);
    void left();
    void refused(ErrorCode reason);

    void answered(std::span<const InputResult> results);
    void sent(const OutMessage& message, Clock::time_point now);
    // A message from the outbox.
    void sent_other(const OutMessage& message);
    // `channels`, `traffic`: the parts of the bytes that are no poses.
    void sent_snapshot(std::size_t bytes, std::size_t channels, const TrafficBytes& traffic);
    // A snapshot without poses, which follow as a datagram.
    void sent_update(std::size_t bytes, const TrafficBytes& traffic);
    // The poses of a frame were encoded.
    void encoded_snapshot();
    // After each frame.
    void on_frame(const SnapshotSchedule& schedule);

    // Why an operator removed the client; nothing: it was not removed.
    std::optional<std::string> kicked() const;

private:
    void count_in_class(std::optional<int> number);
    void add_traffic(TrafficKind rest, std::size_t bytes, const TrafficBytes& traffic);
    void flush_traffic();

    struct Skips {
        std::uint32_t window = 0, pending = 0, rate = 0, encodings = 0;
    };

    PlayContext& context_;
    std::shared_ptr<ConnectedClient> connected_client_;
    std::string subject_;
    ClientId client_ = 0;
    WorldMetrics* world_ = nullptr;
    Skips counted_;
    std::optional<int> counted_class_;  // the cadence class that counts this client
    // Not added to the metrics yet: all sessions share the counters.
    TrafficBytes traffic_{};
    Clock::time_point next_flush_{};
};

}  // namespace jostle::server
