// SPDX-License-Identifier: MIT
#include "server/replication/cell_snapshot_cache.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/snapshot/entity_diff.h"
#include "jostle/snapshot/frame_codec.h"

namespace jostle::server {
namespace {

// The entities of a cell with the poses of `poses`, a frame that contains all of them.
snapshot::QuantizedFrame with_poses_of(const snapshot::QuantizedFrame& poses,
                                       const snapshot::QuantizedFrame& cell) {
    snapshot::QuantizedFrame result{.frame = cell.frame, .entities = {}};
    result.entities.reserve(cell.entities.size());
    snapshot::EntityFinder finder(&poses);
    for (const snapshot::EntityState& entity : cell.entities) {
        const snapshot::EntityState* pose = finder.find(entity.id);
        ASSERT(pose != nullptr);
        result.entities.push_back(*pose);
    }
    return result;
}

}  // namespace

CellSnapshotCache::CellSnapshotCache(double interest_cell_m, const snapshot::QuantSpec& spec,
                                     Serialize serialize)
    : spec_(spec), serialize_(std::move(serialize)), grid_(interest_cell_m, spec) {}

CellSnapshotCache::Cells CellSnapshotCache::cells(const FramePtr& frame, const Quantize& near,
                                                  const Quantize& far) {
    const std::lock_guard lock(mutex_);
    if (frame->tick <= tick_) return cells_;
    CellGrid::Cells now = grid_.split(near(), *frame->entity_list);
    for (auto& [id, history] : histories_)
        if (!now.contains(id)) now[id].frame = frame->tick;
    const snapshot::QuantizedFrame far_poses = far ? far() : snapshot::QuantizedFrame();
    for (auto& [id, content] : now) {
        if (far) add(id, true, with_poses_of(far_poses, content), frame->tick);
        add(id, false, std::move(content), frame->tick);
    }
    std::erase_if(histories_, [&](const auto& entry) {
        ASSERT(!entry.second.states.empty());
        const CellState& newest = entry.second.states.back();
        const bool ends =
            newest.content->entities.empty() && frame->tick - newest.number > empty_ticks;
        if (ends) far_histories_.erase(entry.first);
        return ends;
    });
    ASSERT(far_histories_.size() == (far ? histories_.size() : 0));
    auto cells = std::make_shared<std::vector<CellLevels>>();
    cells->reserve(histories_.size());
    auto of_far = far_histories_.begin();
    for (const auto& [id, history] : histories_) {
        const CellState& state = history.states.back();
        cells->push_back({state, far ? (of_far++)->second.states.back() : state});
        ASSERT(cells->back().far.id == id);
    }
    tick_ = frame->tick;
    cells_ = std::move(cells);
    ASSERT(cells_->size() == histories_.size());
    return cells_;
}

// A state equal to the previous one is not stored again.
void CellSnapshotCache::add(CellId cell, bool far, snapshot::QuantizedFrame content,
                            std::uint32_t tick) {
    History& history = histories(far)[cell];
    if (!history.states.empty() && history.states.back().content->entities == content.entities)
        return;
    const std::uint32_t crc = snapshot::frame_crc(content);
    const bool same_members =
        !history.states.empty() &&
        std::ranges::equal(history.states.back().content->entities, content.entities, {},
                           &snapshot::EntityState::id, &snapshot::EntityState::id);
    ASSERT(history.states.empty() || history.states.back().number < tick);
    const std::uint32_t members = same_members ? history.states.back().members : tick;
    history.states.push_back({cell, far, tick, members,
                              std::make_shared<const snapshot::QuantizedFrame>(std::move(content)),
                              crc});
    if (history.states.size() > states_retained) history.states.pop_front();
    ASSERT(history.states.size() <= states_retained);
    history.encodings.clear();
}

const snapshot::QuantizedFrame* CellSnapshotCache::find(const History& history,
                                                        std::uint32_t number) const {
    const auto at = std::ranges::lower_bound(history.states, number, {}, &CellState::number);
    return at != history.states.end() && at->number == number ? at->content.get() : nullptr;
}

CellSnapshotCache::Encoding CellSnapshotCache::encoding(const CellState& state,
                                                        snapshot::BaselineFrames baselines,
                                                        snapshot::Codec codec) {
    const std::lock_guard lock(mutex_);
    // Another thread may have added a newer state or dropped the cell; the encoding is then made
    // for this client only.
    Histories& all = histories(state.far);
    const auto known = all.find(state.id);
    if (known == all.end()) return encode({}, state, baselines, codec);
    History& history = known->second;
    if (history.states.back().number != state.number)
        return encode(history, state, baselines, codec);
    Encoding& made = history.encodings[{baselines, codec}];
    if (!made.bytes) made = encode(history, state, baselines, codec);
    return made;
}

CellSnapshotCache::Encoding CellSnapshotCache::encode(const History& history,
                                                      const CellState& state,
                                                      snapshot::BaselineFrames baselines,
                                                      snapshot::Codec codec) const {
    baselines = snapshot::predictable(state.number, baselines, spec_);
    const snapshot::QuantizedFrame* baseline =
        baselines.baseline != 0 ? find(history, baselines.baseline) : nullptr;
    const snapshot::QuantizedFrame* baseline2 =
        baseline && baselines.baseline2 != 0 ? find(history, baselines.baseline2) : nullptr;
    const snapshot::QuantizedFrame* baseline3 =
        baseline2 && baselines.baseline3 != 0 ? find(history, baselines.baseline3) : nullptr;
    const snapshot::BaselineFrames used{baseline ? baselines.baseline : 0,
                                        baseline2 ? baselines.baseline2 : 0,
                                        baseline3 ? baselines.baseline3 : 0};
    return {std::make_shared<const std::string>(
                serialize_({.id = state.id,
                            .number = state.number,
                            .baselines = used,
                            .packed = snapshot::encode_frame(
                                *state.content, {baseline, baseline2, baseline3}, spec_, codec),
                            .crc = state.crc})),
            baseline == nullptr};
}

}  // namespace jostle::server
