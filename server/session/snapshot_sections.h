// SPDX-License-Identifier: MIT
//
// The sections that one client requested in its Hello, in the order in which a snapshot contains
// them. Used on the session's thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "server/messages/client_message.h"
#include "server/session/cells_section.h"
#include "server/session/data_sections.h"
#include "server/session/entity_stream.h"
#include "server/session/input_intake.h"
#include "server/session/optional_sections.h"
#include "server/session/play_context.h"
#include "server/session/points_section.h"
#include "server/session/snapshot_schedule.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

class SnapshotSections {
public:
    // The objects that the sections read.
    struct Sources {
        PlayContext& context;
        BroadcastCache& broadcast;
        PoseCache& poses;
        EntityStream& entities;
        InputIntake& inputs;
        const SnapshotSchedule& schedule;
        ClientId client = 0;
        snapshot::Codec codec = snapshot::Codec::bits;
    };
    SnapshotSections(const Sources& sources, const Hello& hello);

    void on_enter(FrameListeners& listeners);
    void on_leave(FrameListeners& listeners);
    bool has_changes(const Frame& frame) const;
    // Appends every section except the client update, which the caller appends last, if it sends
    // the message.
    // Adds the appended bytes to `traffic`.
    void append_optional(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts,
                         TrafficBytes& traffic);
    void on_sent(const OutMessage& snapshot);

    ClientUpdateSection& client_update() { return client_update_; }
    EventsSection* events() { return events_; }              // null: not requested
    CellsSection* cells() { return cells_; }                 // null: not requested
    PointsSection* points() { return points_; }              // null: not requested
    PlayersSection* players() { return players_; }           // null: not requested
    AttributesSection* attributes() { return attributes_; }  // null: not requested
    MessagesSection* messages() { return messages_; }        // null: not requested
    const CellsSection* cells() const { return cells_; }
    std::uint64_t channel_kinds() const { return channels_ ? channels_->kinds() : 0; }

private:
    template <class Section, class... Arguments>
    Section* add(Arguments&&... arguments);
    void add_channels(const Sources& sources, const Hello& hello);

    std::vector<std::unique_ptr<SnapshotSection>> optional_;  // in order, without client_update_
    ClientUpdateSection client_update_;                       // last
    CellsSection* cells_ = nullptr;
    PointsSection* points_ = nullptr;
    ChannelsSection* channels_ = nullptr;
    EventsSection* events_ = nullptr;
    PlayersSection* players_ = nullptr;
    AttributesSection* attributes_ = nullptr;
    MessagesSection* messages_ = nullptr;
};

}  // namespace jostle::server
