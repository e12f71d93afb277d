// SPDX-License-Identifier: MIT
//
// The part of a ClientSession that tells who sees a part of the world: cells, and who is in them.
#include <algorithm>
#include <memory>
#include <utility>

#include "server/messages/server_message.h"
#include "server/session/client_session.h"

namespace jostle::server {

namespace {

// Entities told at once to who sees a part of a world, and about how many bytes one takes.
constexpr std::size_t entity_updates_per_message_max = 64, entity_bytes = 48;

}  // namespace

// The part of the frame that the client sees and can be told of now. A cell comes after the rosters
// of all that is in it, and so not before the next snapshot.
OutMessage ClientSession::take_cell_snapshot(const FramePtr& frame, Clock::time_point now) {
    if (frame->entity_list != entity_list_) send_removed(frame->entity_list);
    std::vector<SharedBytes> cells;
    const CellSnapshotCache::Cells there = broadcast_->cells_of(frame);
    more_to_send_ = false;
    for (const auto& part :
         interest_->pending_cells(broadcast_->cells(), *there, frame->tick, now)) {
        if (part.new_members && !send_cell_members(*part.state.content)) {
            more_to_send_ = true;
            continue;
        }
        SharedBytes bytes = broadcast_->cells().encoding(part.state, part.baselines, codec_);
        if (!interest_->affords(bytes->size(), part.fresh)) {
            more_to_send_ = true;
            if (part.fresh) continue;
            break;
        }
        interest_->spend(bytes->size(), part.fresh);
        interest_->on_sent(part, frame->tick);
        cells.push_back(std::move(bytes));
    }
    const std::vector<CellId> left = interest_->take_left();
    std::string fields = left.empty() ? std::string() : encode_cells_left_field(left);
    OutMessage message = snapshot_of(frame, now, std::move(fields), std::move(cells));
    interest_->spend(message.header.size() + message.shared->size(), false);
    return message;
}

// Of what is in the cell and not known yet, as much as there is budget for. True: all was known.
bool ClientSession::send_cell_members(const wire::QuantizedFrame& cell) {
    EntityList fresh;
    bool all = true;
    for (const wire::EntityState& entity : cell.entities) {
        if (entity.id < known_entities_.size() && known_entities_[entity.id]) continue;
        all = false;
        if (fresh.size() == entity_updates_per_message_max ||
            !interest_->affords(fresh.size() * entity_bytes, true))
            break;
        const auto at = std::ranges::lower_bound(*entity_list_, entity.id, {},
                                                 [](const auto& known) { return known->id; });
        if (at != entity_list_->end() && (*at)->id == entity.id) fresh.push_back(*at);
    }
    if (fresh.empty()) return all;
    const EntityUpdateMessages messages = broadcast_->entity_update_for(fresh);
    push(messages);
    for (const SharedBytes& roster : messages.entity_updates)
        interest_->spend(roster->size(), true);
    for (const auto& entity : fresh) {
        if (known_entities_.size() <= entity->id) known_entities_.resize(entity->id + 1, false);
        known_entities_[entity->id] = true;
    }
    return all;
}

// Who is removed, of those that this client knows.
void ClientSession::send_removed(const std::shared_ptr<const EntityList>& entities) {
    if (entity_list_) {
        std::vector<EntityId> removed;
        for (const EntityId id : broadcast_->entity_list_change(entity_list_, entities)->removed)
            if (id < known_entities_.size() && known_entities_[id]) removed.push_back(id);
        if (!removed.empty())
            outgoing_.push_back({{}, std::make_shared<const std::string>(encode_removed(removed))});
        for (const EntityId id : removed) known_entities_[id] = false;
    }
    entity_list_ = entities;
}

}  // namespace jostle::server
