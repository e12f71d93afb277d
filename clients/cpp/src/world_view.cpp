// SPDX-License-Identifier: MIT
#include "jostle/client/world_view.h"

#include <algorithm>

namespace jostle::client {

void WorldView::begin(const v1::Welcome& welcome) {
    spec_ = {static_cast<std::int32_t>(welcome.quant().units_per_meter()),
             static_cast<std::int32_t>(welcome.quant().rotation_component())};
    frames_.clear();
    entities_.clear();
    geometry_.clear();
    unfinished_ = {};
}

Status WorldView::apply(const v1::GeometryPart& part) {
    const auto failed = [&](const std::string& why) {
        unfinished_ = {};
        return Error{ErrorCode::corrupt_data, "geometry " + std::to_string(part.id()) + ": " + why};
    };
    if (part.part() == 0) unfinished_ = {.id = part.id(), .next = 0, .bytes = {}};
    if (part.id() != unfinished_.id || part.part() != unfinished_.next ||
        part.part() >= part.parts())
        return failed("part " + std::to_string(part.part()) + " of " +
                      std::to_string(part.parts()) + " does not follow the one before");
    if (unfinished_.bytes.size() + part.data().size() > geometry_bytes_max)
        return failed("it has more than " + std::to_string(geometry_bytes_max) + " bytes");
    unfinished_.bytes += part.data();
    if (++unfinished_.next < part.parts()) return {};
    v1::Shape shape;
    if (!shape.ParseFromString(unfinished_.bytes)) return failed("its bytes are no Shape");
    geometry_[part.id()] = std::move(shape);
    unfinished_ = {};
    return {};
}

const v1::Shape* WorldView::outline_of(const v1::Shape& shape) const {
    if (shape.kind_case() != v1::Shape::kGeometry) return &shape;
    const auto known = geometry_.find(shape.geometry());
    return known == geometry_.end() ? nullptr : &known->second;
}

void WorldView::apply(const v1::Roster& roster) {
    for (const std::uint32_t id : roster.removed()) entities_.erase(id);
    for (const v1::Entity& entity : roster.added()) entities_[entity.id()] = entity;
}

const WorldView::KnownFrame* WorldView::find(std::uint32_t frame) const {
    const auto at = std::lower_bound(
        frames_.begin(), frames_.end(), frame,
        [](const KnownFrame& f, std::uint32_t number) { return f.state.frame < number; });
    return at != frames_.end() && at->state.frame == frame ? &*at : nullptr;
}

Status WorldView::apply(const v1::Snapshot& snapshot) {
    const std::uint32_t numbers[] = {snapshot.base_frame(), snapshot.base2_frame(),
                                     snapshot.base3_frame()};
    wire::Bases bases;
    const wire::QuantizedFrame** slots[] = {&bases.base, &bases.base2, &bases.base3};
    Chunks chunks;  // those of the base, until the snapshot says otherwise
    for (int k = 0; k < 3; k++) {
        if (numbers[k] == 0) break;
        const KnownFrame* known = find(numbers[k]);
        if (!known)
            return Error{ErrorCode::failed_precondition,
                         "base frame " + std::to_string(numbers[k]) + " is not known"};
        *slots[k] = &known->state;
        if (k == 0) chunks = known->chunks;
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
    for (const v1::ModuleChunk& chunk : snapshot.modules()) {
        if (chunk.data().empty())
            chunks.erase(chunk.tag());
        else
            chunks[chunk.tag()] = std::make_shared<const std::string>(chunk.data());
    }
    if (chunks.size() > chunks_max)
        return Error{ErrorCode::corrupt_data,
                     name + ": more than " + std::to_string(chunks_max) + " modules"};
    frames_.push_back({std::move(*decoded), std::move(chunks)});
    if (frames_.size() > ring) frames_.pop_front();
    return {};
}

std::span<const std::byte> WorldView::chunk(std::string_view tag) const {
    if (frames_.empty()) return {};
    const auto at = frames_.back().chunks.find(tag);
    if (at == frames_.back().chunks.end()) return {};
    return std::as_bytes(std::span(*at->second));
}

std::vector<std::string> WorldView::chunk_tags() const {
    std::vector<std::string> tags;
    if (!frames_.empty())
        for (const auto& [tag, bytes] : frames_.back().chunks) tags.push_back(tag);
    return tags;
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
