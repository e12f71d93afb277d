// SPDX-License-Identifier: MIT
//
// The part of a snapshot for one client: results of its inputs and counters, each only if it
// changed since the previous snapshot. Used on the session's thread.
#pragma once

#include <cstdint>

#include "server/session/input_intake.h"
#include "server/session/snapshot_schedule.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

class ClientUpdateSection final : public SnapshotSection {
public:
    ClientUpdateSection(InputIntake& inputs, const SnapshotSchedule& schedule)
        : inputs_(inputs), schedule_(schedule) {}

    bool has_changes(const Frame&) const override { return !inputs_.results().empty(); }
    // The results stay with the InputIntake, valid until on_results_sent().
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;

    // Inputs arrive in datagrams, so that the client must learn which ones were received.
    void report_received_inputs() { reports_received_ = true; }

private:
    InputIntake& inputs_;
    const SnapshotSchedule& schedule_;
    // Values that were sent last.
    std::uint32_t sent_sequence_ = 0, sent_skipped_ = 0, sent_received_ = 0;
    bool reports_received_ = false;
};

}  // namespace jostle::server
