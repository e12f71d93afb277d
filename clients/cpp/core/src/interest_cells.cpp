// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/interest_cells.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "clients/cpp/core/src/pose_blend.h"
#include "jostle/snapshot/baseline_frames.h"
#include "jostle/snapshot/entity_diff.h"

namespace jostle::client {

Result<snapshot::QuantizedFrame> InterestCells::decode(const v1::CellUpdate& part,
                                                       const snapshot::QuantSpec& spec,
                                                       snapshot::Codec codec) const {
    const std::string name =
        "cell " + std::to_string(part.cell()) + " of tick " + std::to_string(part.number());
    const Result<snapshot::BaselineFrames> baseline_frames =
        snapshot::decode_baseline_frames(part.number(), part.baselines());
    if (!baseline_frames.ok())
        return Error{baseline_frames.error().code, name + ": " + baseline_frames.error().message};
    const auto known = cells_.find(part.cell());
    if (known != cells_.end() && part.baselines() != 0 &&
        part.number() <= known->second.back().frame)
        return Error{ErrorCode::failed_precondition, name + " is not newer than the last one"};
    snapshot::Baselines baselines;
    const snapshot::QuantizedFrame** slots[] = {&baselines.baseline, &baselines.baseline2,
                                                &baselines.baseline3};
    const std::uint32_t numbers[] = {baseline_frames->baseline, baseline_frames->baseline2,
                                     baseline_frames->baseline3};
    for (int k = 0; k < 3 && numbers[k] != 0; k++) {
        if (known != cells_.end())
            for (const snapshot::QuantizedFrame& state : known->second)
                if (state.frame == numbers[k]) *slots[k] = &state;
        if (*slots[k] == nullptr)
            return Error{ErrorCode::failed_precondition,
                         name + ": unknown baseline " + std::to_string(numbers[k])};
    }
    const auto* bytes = reinterpret_cast<const std::byte*>(part.packed().data());
    auto state = snapshot::decode_frame(part.number(), {bytes, part.packed().size()}, baselines,
                                        spec, snapshot::default_entities_max, codec);
    if (!state.ok()) return Error{state.error().code, name + ": " + state.error().message};
    if (snapshot::frame_crc(*state) != part.crc())
        return Error{ErrorCode::corrupt_data, name + ": CRC mismatch"};
    return state;
}

Status InterestCells::apply(const v1::Snapshot& snapshot, const snapshot::QuantSpec& spec,
                            snapshot::Codec codec) {
    std::vector<std::pair<std::uint32_t, snapshot::QuantizedFrame>> fresh;
    for (const v1::CellUpdate& part : snapshot.cells()) {
        auto state = decode(part, spec, codec);
        if (!state.ok()) return state.error();
        fresh.emplace_back(part.cell(), *std::move(state));
    }
    if (newest_ != 0 && snapshot.frame() > newest_) step_ = snapshot.frame() - newest_;
    newest_ = snapshot.frame();
    for (const std::uint32_t cell : snapshot.cells_left()) cells_.erase(cell);
    for (auto& [cell, state] : fresh) {
        States& states = cells_[cell];
        // Only a cell without baselines may have an older number; it replaces the stored states.
        if (!states.empty() && state.frame <= states.back().frame) states.clear();
        states.push_back(std::move(state));
        if (states.size() > history_max) states.pop_front();
    }
    return {};
}

namespace {

struct CellEntity {
    const snapshot::EntityState* entity;
    std::uint32_t number;
};

snapshot::QuantizedFrame merge_cells(std::vector<CellEntity> all, std::uint32_t number) {
    std::ranges::sort(all, [](const CellEntity& a, const CellEntity& b) {
        return a.entity->id != b.entity->id ? a.entity->id < b.entity->id : a.number > b.number;
    });
    snapshot::QuantizedFrame frame{.frame = number, .entities = {}};
    frame.entities.reserve(all.size());
    for (const CellEntity& candidate : all)
        if (frame.entities.empty() || frame.entities.back().id != candidate.entity->id)
            frame.entities.push_back(*candidate.entity);
    return frame;
}

snapshot::EntityState interpolate_entity(const snapshot::EntityState& a,
                                         const snapshot::EntityState& b, double t,
                                         const snapshot::QuantSpec& spec, double width_us) {
    if (snapshot::same_pose(a, b)) return b;
    const snapshot::Pose from = snapshot::dequantize(a, spec), to = snapshot::dequantize(b, spec);
    if (is_teleport(from, to, width_us)) return a;
    return snapshot::quantize(b.id, blend(from, to, t), b.at_rest, spec);
}

}  // namespace

snapshot::QuantizedFrame InterestCells::frame(std::uint32_t number) const {
    std::vector<CellEntity> all;
    for (const auto& [cell, states] : cells_)
        for (const snapshot::EntityState& entity : states.back().entities)
            all.push_back({&entity, states.back().frame});
    return merge_cells(std::move(all), number);
}

// A cell in which nothing moves is sent rarely, so its update interval is the shortest of its
// recent intervals.
double InterestCells::progress(const States& states, std::uint32_t number) const {
    constexpr std::size_t intervals = 3;
    constexpr std::uint32_t longest = 12;  // ticks: upper bound of the added delay
    if (states.size() < 2) return 1;
    std::uint32_t shortest = longest;
    for (std::size_t k = states.size() - 1; k > 0 && k + intervals >= states.size(); k--)
        shortest = std::min(shortest, states[k].frame - states[k - 1].frame);
    const std::uint32_t since = number - std::min(number, states.back().frame);
    return shortest <= step_ ? 1 : std::min(1.0, double(since + step_) / shortest);
}

snapshot::QuantizedFrame InterestCells::rendered_frame(std::uint32_t number,
                                                       const snapshot::QuantSpec& spec,
                                                       double tick_us) const {
    std::vector<CellEntity> all;
    std::deque<snapshot::EntityState> interpolated;
    for (const auto& [cell, states] : cells_) {
        const snapshot::QuantizedFrame& now = states.back();
        const double t = progress(states, number);
        const snapshot::QuantizedFrame* const previous =
            t < 1 ? &states[states.size() - 2] : nullptr;
        const double width_us = previous ? (now.frame - previous->frame) * tick_us : 0;
        snapshot::EntityFinder in_previous(previous);
        for (const snapshot::EntityState& entity : now.entities) {
            const snapshot::EntityState* const was = in_previous.find(entity.id);
            if (was) interpolated.push_back(interpolate_entity(*was, entity, t, spec, width_us));
            all.push_back({was ? &interpolated.back() : &entity, now.frame});
        }
    }
    return merge_cells(std::move(all), number);
}

}  // namespace jostle::client
