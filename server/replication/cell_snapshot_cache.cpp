// SPDX-License-Identifier: MIT
#include "server/replication/cell_snapshot_cache.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/snapshot/frame_codec.h"

namespace jostle::server {

CellSnapshotCache::CellSnapshotCache(double interest_cell_m, const snapshot::QuantSpec& spec,
                                     Serialize serialize)
    : spec_(spec), serialize_(std::move(serialize)), grid_(interest_cell_m, spec) {}

CellSnapshotCache::Cells CellSnapshotCache::cells(
    const FramePtr& frame, const std::function<snapshot::QuantizedFrame()>& quantized) {
    const std::lock_guard lock(mutex_);
    if (frame->tick <= tick_) return cells_;
    CellGrid::Cells now = grid_.split(quantized(), *frame->entity_list);
    for (auto& [id, history] : histories_)
        if (!now.contains(id)) now[id].frame = frame->tick;
    for (auto& [id, content] : now) add(id, std::move(content), frame->tick);
    std::erase_if(histories_, [&](const auto& entry) {
        ASSERT(!entry.second.states.empty());
        const CellState& newest = entry.second.states.back();
        return newest.content->entities.empty() && frame->tick - newest.number > empty_ticks;
    });
    auto cells = std::make_shared<std::vector<CellState>>();
    cells->reserve(histories_.size());
    for (const auto& [id, history] : histories_) cells->push_back(history.states.back());
    tick_ = frame->tick;
    cells_ = std::move(cells);
    ASSERT(cells_->size() == histories_.size());
    return cells_;
}

// A state equal to the previous one is not stored again.
void CellSnapshotCache::add(CellId cell, snapshot::QuantizedFrame content, std::uint32_t tick) {
    History& history = histories_[cell];
    if (!history.states.empty() && history.states.back().content->entities == content.entities)
        return;
    const std::uint32_t crc = snapshot::frame_crc(content);
    const bool same_members =
        !history.states.empty() &&
        std::ranges::equal(history.states.back().content->entities, content.entities, {},
                           &snapshot::EntityState::id, &snapshot::EntityState::id);
    ASSERT(history.states.empty() || history.states.back().number < tick);
    const std::uint32_t members = same_members ? history.states.back().members : tick;
    history.states.push_back({cell, tick, members,
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

SharedBytes CellSnapshotCache::encoding(const CellState& state, snapshot::BaselineFrames baselines,
                                        snapshot::Codec codec) {
    const std::lock_guard lock(mutex_);
    // Another thread may have added a newer state or dropped the cell; the encoding is then made
    // for this client only.
    const auto known = histories_.find(state.id);
    if (known == histories_.end()) return encode({}, state, baselines, codec);
    History& history = known->second;
    if (history.states.back().number != state.number)
        return encode(history, state, baselines, codec);
    SharedBytes& bytes = history.encodings[{baselines, codec}];
    if (!bytes) bytes = encode(history, state, baselines, codec);
    return bytes;
}

SharedBytes CellSnapshotCache::encode(const History& history, const CellState& state,
                                      snapshot::BaselineFrames baselines,
                                      snapshot::Codec codec) const {
    const snapshot::QuantizedFrame* baseline =
        baselines.baseline != 0 ? find(history, baselines.baseline) : nullptr;
    const snapshot::QuantizedFrame* baseline2 =
        baseline && baselines.baseline2 != 0 ? find(history, baselines.baseline2) : nullptr;
    const snapshot::QuantizedFrame* baseline3 =
        baseline2 && baselines.baseline3 != 0 ? find(history, baselines.baseline3) : nullptr;
    const snapshot::BaselineFrames used{baseline ? baselines.baseline : 0,
                                        baseline2 ? baselines.baseline2 : 0,
                                        baseline3 ? baselines.baseline3 : 0};
    return std::make_shared<const std::string>(
        serialize_({.id = state.id,
                    .number = state.number,
                    .baselines = used,
                    .packed = snapshot::encode_frame(
                        *state.content, {baseline, baseline2, baseline3}, spec_, codec),
                    .crc = state.crc}));
}

}  // namespace jostle::server
