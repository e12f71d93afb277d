// SPDX-License-Identifier: MIT
//
// State of the entity that a client controls, several times per second, for a client that predicts
// it. Used on the session's thread.
#pragma once

#include <cstdint>
#include <vector>

#include "server/session/snapshot_section.h"

namespace jostle::server {

class ControlledEntitySection final : public SnapshotSection {
public:
    // `hz`: ticks per second of the world.
    ControlledEntitySection(ClientId client, double hz);

    void on_enter(FrameListeners& listeners) override { listeners.controlled_entities++; }
    void on_leave(FrameListeners& listeners) override;
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;

private:
    const ClientId client_;
    const std::uint32_t period_;  // ticks between two updates
    // The update that was sent last; the next one is encoded as a difference from it.
    EntityId sent_entity_ = 0;  // 0: none
    std::uint32_t sent_tick_ = 0;
    std::vector<std::uint32_t> sent_words_;
};

}  // namespace jostle::server
