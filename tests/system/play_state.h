// SPDX-License-Identifier: MIT
//
// The knowledge of one client about its world, built from ServerMessages according to
// proto/WIRE.md: entities, the last 32 decoded frames and the result of each input. Each message is
// checked against the guarantees of the protocol; violations are counted and the first one is
// recorded. The players of both transports use it.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/snapshot/frame_codec.h"
#include "jostle/v1/play.pb.h"

namespace jostle::test {

class PlayState {
public:
    void take(const v1::ServerMessage& message);

    std::uint32_t client_id = 0;
    v1::Welcome welcome;
    int welcomes = 0, entity_updates = 0, snapshots = 0, keyframes = 0, stats = 0, pongs = 0;
    std::size_t snapshot_bytes = 0;
    std::uint32_t newest_frame = 0;
    std::uint32_t skipped = 0;                         // as reported by the server
    std::int32_t input_margin_us = 0;                  // likewise
    std::vector<double> ages_ms;                       // of each snapshot when it was decoded
    std::map<std::uint32_t, std::uint32_t> crc_of;     // by frame
    std::set<std::uint64_t> geometry;                  // received
    std::map<std::uint32_t, v1::Entity> entities;      // from the EntityUpdates
    std::set<std::uint32_t> removed;                   // likewise
    std::map<std::uint32_t, v1::InputResult> results;  // by sequence
    std::vector<v1::Notice> notices;
    // States of the cells in the area of interest, by number; for clients with an area of interest.
    std::map<std::uint32_t, std::map<std::uint32_t, snapshot::QuantizedFrame>> cells;
    bool wants_events = false;                    // from its Hello
    std::string newest_message;                   // data of the newest user message
    std::vector<std::uint32_t> restorable_ticks;  // of the newest WorldStats
    std::vector<v1::Events> events;               // in order of arrival

    int violations = 0;
    std::string first_violation;

    std::size_t count(v1::InputCode code) const;
    const snapshot::QuantizedFrame* newest() const {
        return ring_.empty() ? nullptr : &ring_.back();
    }

private:
    void take(const v1::EntityUpdate& entity_update);
    void take(const v1::Snapshot& snapshot);
    void take_results(const v1::ClientUpdate& own);
    std::uint64_t due_us(const v1::Snapshot& snapshot) const;
    std::optional<snapshot::QuantizedFrame> decoded(const std::string& name, std::uint32_t number,
                                                    const std::string& packed,
                                                    const snapshot::Baselines& baselines,
                                                    std::uint32_t crc);
    std::optional<snapshot::QuantizedFrame> assemble_cells(const v1::Snapshot& snapshot,
                                                           const std::string& name);
    void take(const v1::Events& happened);
    const snapshot::QuantizedFrame* find(std::uint32_t frame) const;
    void expect(bool holds, const std::string& what);

    std::deque<snapshot::QuantizedFrame> ring_;
    std::uint32_t newest_message_ = 0;  // number
    bool has_players_ = false;
};

// Time since `server_time_us` on the server's clock, ms. Server and client run on the same machine.
double age_ms(std::uint64_t server_time_us);

}  // namespace jostle::test
