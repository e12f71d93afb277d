// SPDX-License-Identifier: MIT
#include "server/session/cells_section.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "server/messages/server_message.h"

namespace jostle::server {

namespace {

constexpr double bytes_per_kbit = 125;
// Entities per entity update of one cell, and the estimated size of one in bytes.
struct UpdateSize {
    std::size_t entities_max, entity_bytes;
};
constexpr UpdateSize complete_entities{64, 48}, packed_entities{1024, 2};

}  // namespace

CellsSection::CellsSection(BroadcastCache& broadcast, PoseCache& poses, EntityStream& entities,
                           snapshot::Codec codec, const Hello& hello)
    : broadcast_(broadcast),
      poses_(poses),
      entities_(entities),
      codec_(codec),
      view_(hello.max_kbps * bytes_per_kbit) {
    if (hello.interest) view_.set_interest(*hello.interest);
}

void CellsSection::append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) {
    if (frame->entity_list != entities_.list()) update_list(frame->entity_list);
    parts.has_poses = false;
    has_pending_ = false;
    const CellSnapshotCache& cache = poses_.cells();
    const CellSnapshotCache::Cells cells = poses_.cells_of(frame);
    std::vector<InterestView::PendingCell> beyond_quota;
    bool budget_left = true;
    for (auto& part : view_.pending_cells(cache, *cells, frame->tick, now)) {
        const Sent sent = send_cell(part, frame->tick, part.fresh, parts);
        if (sent == Sent::all) continue;
        has_pending_ = true;
        if (sent == Sent::members) continue;  // the cell follows in a later snapshot
        if (part.fresh || part.new_members) {
            beyond_quota.push_back(std::move(part));
        } else {
            budget_left = false;  // a cell further down must not overtake it each time
            break;
        }
    }
    // New cells also get what updates leave of the budget.
    for (const auto& part : beyond_quota)
        if (!budget_left || send_cell(part, frame->tick, false, parts) == Sent::nothing) break;
    view_.set_cells_waiting(has_pending_);
    const std::vector<CellId> left = view_.take_left();
    if (!left.empty()) parts.fields += encode_cells_left_field(left);
}

// Sends the cell, or entities of it that the client does not know, which must arrive before it.
// `quota`: within the quota of new cells.
CellsSection::Sent CellsSection::send_cell(const InterestView::PendingCell& part,
                                           std::uint32_t tick, bool quota, SnapshotParts& parts) {
    if (!view_.affords(0, quota)) return Sent::nothing;
    if (part.new_members)
        if (const Sent sent = send_members(*part.state.content, quota); sent != Sent::all)
            return sent;
    CellSnapshotCache::Encoding cell = poses_.cells().encoding(part.state, part.baselines, codec_);
    if (!view_.affords(cell.bytes->size(), quota)) return Sent::nothing;
    view_.spend(cell.bytes->size(), part.fresh);
    view_.on_sent(part, cell.is_keyframe, tick);
    parts.shared_fields.push_back(std::move(cell.bytes));
    return Sent::all;
}

void CellsSection::on_sent(const OutMessage& snapshot) {
    ASSERT(snapshot.shared != nullptr);
    // append() charged the cells.
    view_.spend(snapshot.header.size() + snapshot.shared->size(), false);
}

// Sends the entities of the cell that the client does not know, as far as the budget allows. `all`:
// the client knew all of them.
CellsSection::Sent CellsSection::send_members(const snapshot::QuantizedFrame& cell, bool quota) {
    const UpdateSize& size =
        entities_.form() == EntityForm::packed ? packed_entities : complete_entities;
    EntityList fresh;
    bool knew_all = true;
    for (const snapshot::EntityState& entity : cell.entities) {
        if (is_known(entity.id)) continue;
        knew_all = false;
        if (fresh.size() == size.entities_max ||
            !view_.affords(fresh.size() * size.entity_bytes, quota))
            break;
        const EntityList& list = *entities_.list();
        const auto at = std::ranges::lower_bound(list, entity.id, {},
                                                 [](const auto& known) { return known->id; });
        if (at != list.end() && (*at)->id == entity.id) fresh.push_back(*at);
    }
    if (fresh.empty()) return knew_all ? Sent::all : Sent::nothing;
    const EntityUpdateMessages messages = broadcast_.entity_update_for(fresh, entities_.form());
    std::size_t bytes = 0;
    for (const SharedBytes& update : messages.entity_updates) bytes += update->size();
    if (!view_.affords(bytes, quota)) return Sent::nothing;
    entities_.send(messages);
    view_.spend(bytes, true);
    known_revision_++;
    for (const auto& entity : fresh) {
        if (known_.size() <= entity->id) known_.resize(entity->id + 1, false);
        known_[entity->id] = true;
    }
    return Sent::members;
}

// Sends the removal of entities that the client knows.
void CellsSection::update_list(const std::shared_ptr<const EntityList>& list) {
    ASSERT(list != nullptr);
    if (entities_.list()) {
        std::vector<EntityId> removed;
        for (const EntityId id :
             broadcast_.entity_list_change(entities_.list(), list, entities_.form())->removed)
            if (is_known(id)) removed.push_back(id);
        entities_.send_removed(removed);
        for (const EntityId id : removed) known_[id] = false;
    }
    entities_.set_list(list);
}

}  // namespace jostle::server
