// SPDX-License-Identifier: MIT
//
// The interest cells of a client with an area of interest or a byte budget. They replace the poses
// of the shared part. The client receives the entities of a cell first and the cell in a later
// snapshot. Used on the session's thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "server/messages/client_message.h"
#include "server/replication/interest_view.h"
#include "server/session/broadcast_cache.h"
#include "server/session/entity_stream.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

class CellsSection final : public SnapshotSection {
public:
    CellsSection(BroadcastCache& broadcast, PoseCache& poses, EntityStream& entities,
                 snapshot::Codec codec, const Hello& hello);

    // The budget did not suffice for all pending cells and entities.
    bool has_changes(const Frame&) const override { return has_pending_; }
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;
    void on_sent(const OutMessage& snapshot) override;

    void set_interest(const Interest& interest) { view_.set_interest(interest); }
    // Point objects share it.
    InterestView& view() { return view_; }
    // The client lost its state: each of its cells is sent as a keyframe.
    void reset() { view_.reset(); }

    // The client was sent the entity.
    bool is_known(EntityId entity) const { return entity < known_.size() && known_[entity]; }
    // Increases when the client is sent entities.
    std::uint64_t known_revision() const { return known_revision_; }

private:
    void update_list(const std::shared_ptr<const EntityList>& list);
    enum class Sent { nothing, members, all };
    Sent send_cell(const InterestView::PendingCell& part, std::uint32_t tick, bool quota,
                   SnapshotParts& parts);
    Sent send_members(const snapshot::QuantizedFrame& cell, bool quota);

    BroadcastCache& broadcast_;
    PoseCache& poses_;
    EntityStream& entities_;
    const snapshot::Codec codec_;
    InterestView view_;
    std::vector<bool> known_;  // by entity id: the client was sent the entity
    std::uint64_t known_revision_ = 0;
    bool has_pending_ = false;
};

}  // namespace jostle::server
