// SPDX-License-Identifier: MIT
#include "jostle/client/world_view.h"

#include <algorithm>

namespace jostle::client {

void WorldView::begin(const v1::Welcome& welcome) {
    spec_ = {static_cast<std::int32_t>(welcome.quant().units_per_meter()),
             static_cast<std::int32_t>(welcome.quant().rotation_component())};
    frames_.clear();
    entities_.clear();
}

void WorldView::apply(const v1::Roster& roster) {
    for (const std::uint32_t id : roster.removed()) entities_.erase(id);
    for (const v1::Entity& entity : roster.added()) entities_[entity.id()] = entity;
}

const wire::QuantizedFrame* WorldView::find(std::uint32_t frame) const {
    const auto at = std::lower_bound(
        frames_.begin(), frames_.end(), frame,
        [](const wire::QuantizedFrame& f, std::uint32_t number) { return f.frame < number; });
    return at != frames_.end() && at->frame == frame ? &*at : nullptr;
}

Status WorldView::apply(const v1::Snapshot& snapshot) {
    const std::uint32_t numbers[] = {snapshot.base_frame(), snapshot.base2_frame(),
                                     snapshot.base3_frame()};
    wire::Bases bases;
    const wire::QuantizedFrame** slots[] = {&bases.base, &bases.base2, &bases.base3};
    for (int k = 0; k < 3; k++) {
        if (numbers[k] == 0) break;
        *slots[k] = find(numbers[k]);
        if (!*slots[k])
            return Error{ErrorCode::failed_precondition,
                         "base frame " + std::to_string(numbers[k]) + " is not known"};
    }
    const std::string name = "frame " + std::to_string(snapshot.frame());
    if (snapshot.frame() <= frame().frame)
        return Error{ErrorCode::failed_precondition, name + " is not newer than the last one"};
    const auto* bytes = reinterpret_cast<const std::byte*>(snapshot.packed().data());
    auto decoded =
        wire::decode_frame(snapshot.frame(), {bytes, snapshot.packed().size()}, bases, spec_);
    if (!decoded.ok()) return Error{decoded.error().code, name + ": " + decoded.error().message};
    if (wire::frame_crc(*decoded) != snapshot.crc())
        return Error{ErrorCode::corrupt_data, name + ": the CRC does not match"};
    frames_.push_back(std::move(*decoded));
    if (frames_.size() > ring) frames_.pop_front();
    return {};
}

std::optional<wire::Pose> WorldView::pose_of(std::uint32_t entity) const {
    const auto& entities = frame().entities;
    const auto at =
        std::lower_bound(entities.begin(), entities.end(), entity,
                         [](const wire::EntityState& e, std::uint32_t id) { return e.id < id; });
    if (at == entities.end() || at->id != entity) return std::nullopt;
    return wire::dequantize(*at, spec_);
}

}  // namespace jostle::client
