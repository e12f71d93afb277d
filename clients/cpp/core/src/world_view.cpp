// SPDX-License-Identifier: MIT
#include "jostle/client/world_view.h"
#include "jostle/client/added_entities.h"

#include <algorithm>
#include <cmath>

#include "clients/cpp/core/src/interest_cells.h"
#include "jostle/client/clock_sync.h"
#include "jostle/snapshot/baseline_frames.h"
#include "jostle/snapshot/word_changes.h"

namespace jostle::client {

void WorldView::begin(const v1::Welcome& welcome) {
    spec_ = {static_cast<std::int32_t>(welcome.quant().units_per_meter()),
             static_cast<std::int32_t>(welcome.quant().rotation_component())};
    // Clamped, because the server's values are untrusted: later times and slower worlds are
    // invalid.
    epoch_us_ = static_cast<std::int64_t>(std::min(welcome.epoch_us(), latest_time_us));
    tick_us_ = 1e6 / std::clamp(welcome.tick_hz(), 1.0, 1e5);
    codec_ = static_cast<snapshot::Codec>(std::max(1u, welcome.codec()));
    cells_ = welcome.cells() ? std::make_shared<InterestCells>() : nullptr;
    datagrams_ = welcome.has_datagrams();
    known_frame_.reset();
    kinds_.assign(welcome.channels().begin(), welcome.channels().end());
    points_.begin(kinds_);
    frames_.clear();
    entities_.clear();
    geometry_.clear();
    partial_geometry_ = {};
    controlled_entity_ = {};
    joints_.clear();
    data_.clear();
}

void WorldView::resume(const v1::Welcome& welcome) {
    codec_ = static_cast<snapshot::Codec>(std::max(1u, welcome.codec()));
    partial_geometry_ = {};
    points_.begin(kinds_);  // the server sends them again
}

Status WorldView::apply(const v1::GeometryChunk& part) {
    const auto failed = [&](const std::string& reason) {
        partial_geometry_ = {};
        return Error{ErrorCode::corrupt_data,
                     "geometry " + std::to_string(part.id()) + ": " + reason};
    };
    if (part.chunk() == 0) partial_geometry_ = {.id = part.id(), .next = 0, .bytes = {}};
    if (part.id() != partial_geometry_.id || part.chunk() != partial_geometry_.next ||
        part.chunk() >= part.chunk_count())
        return failed("chunk " + std::to_string(part.chunk()) + " of " +
                      std::to_string(part.chunk_count()) + " does not follow the previous chunk");
    if (partial_geometry_.bytes.size() + part.data().size() > geometry_bytes_max)
        return failed("more than " + std::to_string(geometry_bytes_max) + " bytes");
    partial_geometry_.bytes += part.data();
    if (++partial_geometry_.next < part.chunk_count()) return {};
    v1::Shape shape;
    if (!shape.ParseFromString(partial_geometry_.bytes)) return failed("not a valid Shape");
    geometry_[part.id()] = std::move(shape);
    partial_geometry_ = {};
    return {};
}

const v1::Shape* WorldView::resolve_shape(const v1::Shape& shape) const {
    if (shape.kind_case() != v1::Shape::kGeometry) return &shape;
    const auto known = geometry_.find(shape.geometry());
    return known == geometry_.end() ? nullptr : &known->second;
}

Status WorldView::apply(const v1::EntityUpdate& entity_update) {
    auto added = added_entities(entity_update);
    if (!added.ok()) return added.error();
    for (const std::uint32_t id : entity_update.removed()) entities_.erase(id);
    for (v1::Entity& entity : *added) {
        const std::uint32_t id = entity.id();
        entities_[id] = std::move(entity);
    }
    remove_unknown_entities();
    return {};
}

Status WorldView::apply(const v1::ControlledEntityState& state) {
    if (!state.keyframe() && state.entity() != controlled_entity_.entity)
        return Error{ErrorCode::failed_precondition, "controlled entity " +
                                                         std::to_string(state.entity()) +
                                                         ": the first state must be a keyframe"};
    if (state.keyframe()) controlled_entity_ = {};
    Result<std::vector<std::uint32_t>> words = snapshot::apply_changes(
        controlled_entity_.words, state.words(), state.changed_mask(), state.values());
    controlled_entity_ = {};
    if (!words.ok())
        return Error{words.error().code,
                     "entity " + std::to_string(state.entity()) + ": " + words.error().message};
    controlled_entity_ = {state.entity(), state.tick(), state.module(), *std::move(words)};
    return {};
}

// Both lists are sorted by id.
void WorldView::remove_unknown_entities() {
    known_frame_.reset();
    if (!datagrams_ || frames_.empty()) return;
    const snapshot::QuantizedFrame& newest = frames_.back().state;
    auto known = entities_.begin();
    const auto is_unknown = [&](const snapshot::EntityState& e) {
        while (known != entities_.end() && known->first < e.id) ++known;
        return known == entities_.end() || known->first != e.id;
    };
    if (std::ranges::none_of(newest.entities, is_unknown)) return;
    known = entities_.begin();
    known_frame_ = newest;
    std::erase_if(known_frame_->entities, is_unknown);
}

std::uint32_t WorldView::ack_bits() const {
    std::uint32_t bits = 0;
    if (frames_.empty()) return bits;
    const std::uint32_t newest = frames_.back().state.frame;
    for (const KnownFrame& known : frames_) {
        const std::uint32_t back = newest - known.state.frame;
        if (back >= 1 && back <= 32) bits |= 1u << (back - 1);
    }
    return bits;
}

const WorldView::KnownFrame* WorldView::find(std::uint32_t frame) const {
    const auto at = std::lower_bound(
        frames_.begin(), frames_.end(), frame,
        [](const KnownFrame& f, std::uint32_t number) { return f.state.frame < number; });
    return at != frames_.end() && at->state.frame == frame ? &*at : nullptr;
}

Status WorldView::apply(const v1::Snapshot& snapshot) {
    const Result<snapshot::BaselineFrames> baseline_frames =
        snapshot::decode_baseline_frames(snapshot.frame(), snapshot.baselines());
    if (!baseline_frames.ok()) return baseline_frames.error();
    const std::uint32_t numbers[] = {baseline_frames->baseline, baseline_frames->baseline2,
                                     baseline_frames->baseline3};
    snapshot::Baselines baselines;
    const snapshot::QuantizedFrame** slots[] = {&baselines.baseline, &baselines.baseline2,
                                                &baselines.baseline3};
    const snapshot::Channels* base_channels = &no_channels_;
    for (int k = 0; k < 3; k++) {
        if (numbers[k] == 0) break;
        const KnownFrame* known = find(numbers[k]);
        if (!known)
            return Error{ErrorCode::failed_precondition,
                         "unknown baseline frame " + std::to_string(numbers[k])};
        *slots[k] = &known->state;
        if (k == 0) base_channels = &known->channels;
    }
    const std::string name = "frame " + std::to_string(snapshot.frame());
    if (snapshot.frame() <= frame().frame)
        return Error{ErrorCode::failed_precondition, name + " is not newer than the last one"};
    auto decoded = decode_poses(snapshot, baselines);
    if (!decoded.ok()) return Error{decoded.error().code, name + ": " + decoded.error().message};
    const auto* channel_bytes = reinterpret_cast<const std::byte*>(snapshot.channels().data());
    Result<snapshot::Channels> channels = snapshot::decode_channels(
        {channel_bytes, snapshot.channels().size()}, snapshot.channels_crc(), *base_channels);
    if (!channels.ok()) return Error{channels.error().code, name + ": " + channels.error().message};
    frames_.push_back({std::move(*decoded), *std::move(channels)});
    if (frames_.size() > frame_history_max) frames_.pop_front();
    remove_unknown_entities();
    return {};
}

// Decodes either a complete frame or the cells of the area of interest.
Result<snapshot::QuantizedFrame> WorldView::decode_poses(const v1::Snapshot& snapshot,
                                                         const snapshot::Baselines& baselines) {
    if (cells_) {
        if (Status s = cells_->apply(snapshot, spec_, codec_); !s.ok()) return s.error();
        snapshot::QuantizedFrame merged = cells_->frame(snapshot.frame());
        // A delayed cell may contain entities that were removed.
        std::erase_if(merged.entities, [&](const auto& e) { return !entities_.contains(e.id); });
        return merged;
    }
    const auto* bytes = reinterpret_cast<const std::byte*>(snapshot.packed().data());
    auto decoded = snapshot::decode_frame(snapshot.frame(), {bytes, snapshot.packed().size()},
                                          baselines, spec_, snapshot::default_entities_max, codec_);
    if (decoded.ok() && snapshot::frame_crc(*decoded) != snapshot.crc())
        return Error{ErrorCode::corrupt_data, "CRC mismatch"};
    return decoded;
}

snapshot::QuantizedFrame WorldView::rendered_frame() const {
    if (!cells_ || frames_.empty()) return frame();
    snapshot::QuantizedFrame rendered = cells_->rendered_frame(frame().frame, spec_, tick_us_);
    std::erase_if(rendered.entities, [&](const auto& e) { return !entities_.contains(e.id); });
    return rendered;
}

WorldView::SnapshotTimes WorldView::times_of(const v1::Snapshot& snapshot) const {
    constexpr auto most = static_cast<std::int64_t>(latest_time_us);
    const std::int64_t start = epoch_us_ + std::clamp(snapshot.late_us(), -most, most);
    const auto due = [&](std::uint32_t frame) {
        // The tick rate may be no number.
        return start + static_cast<std::int64_t>(
                           std::llround(std::min(static_cast<double>(most), frame * tick_us_)));
    };
    SnapshotTimes times{.due_us = due(snapshot.frame())};
    const auto baselines = snapshot::decode_baseline_frames(snapshot.frame(), snapshot.baselines());
    if (!baselines.ok() || baselines->baseline == 0 || snapshot.unchanged_ticks() == 0)
        return times;
    if (snapshot.unchanged_ticks() <= snapshot.frame() - baselines->baseline)
        times.unchanged_until_us = due(baselines->baseline + snapshot.unchanged_ticks());
    return times;
}

const snapshot::Channels& WorldView::channels() const {
    return frames_.empty() ? no_channels_ : frames_.back().channels;
}

std::span<const std::int32_t> WorldView::channel(std::string_view kind,
                                                 std::uint32_t entity) const {
    for (const snapshot::Channel& channel : channels())
        if (channel.entity == entity && channel.kind < kinds_.size() &&
            kinds_[channel.kind].name() == kind)
            return *channel.values;
    return {};
}

std::optional<snapshot::Pose> WorldView::pose_of(std::uint32_t entity) const {
    const auto& entities = frame().entities;
    const auto at = std::lower_bound(
        entities.begin(), entities.end(), entity,
        [](const snapshot::EntityState& e, std::uint32_t id) { return e.id < id; });
    if (at == entities.end() || at->id != entity) return std::nullopt;
    return snapshot::dequantize(*at, spec_);
}

}  // namespace jostle::client
