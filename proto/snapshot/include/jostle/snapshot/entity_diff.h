// SPDX-License-Identifier: MIT
//
// Common start of both frame codecs: the surviving entities of the baseline, their states in older
// baselines, and the spacing of the frames. Any thread.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/snapshot/baselines.h"
#include "jostle/snapshot/predict.h"

namespace jostle::snapshot {

inline Error corrupt(std::string message) {
    return {ErrorCode::corrupt_data, std::move(message)};
}

/// An entity of the baseline that is still present. For an entity at rest the older baselines are
/// not set, because no codec uses them.
struct Survivor {
    const EntityState* baseline = nullptr;
    const EntityState* baseline2 = nullptr;
    const EntityState* baseline3 = nullptr;
    /// For an encoder: the number of skipped entities directly before this one. They are at rest in
    /// the baseline and unchanged.
    std::size_t unchanged_before = 0;
};

/// Finds entities of a frame by id. The ids of successive calls must be ascending.
class EntityFinder {
public:
    explicit EntityFinder(const QuantizedFrame* frame) : frame_(frame) {}

    const EntityState* find(std::uint32_t id) {
        if (!frame_) return nullptr;
        const std::vector<EntityState>& all = frame_->entities;
        // Ids are mostly consecutive, so the position usually advances as far as the id.
        if (at_ < all.size() && id > all[at_].id) {
            const std::size_t guess = at_ + (id - all[at_].id);
            if (guess < all.size() && all[guess].id == id) at_ = guess;
        }
        while (at_ < all.size() && all[at_].id < id) at_++;
        return at_ < all.size() && all[at_].id == id ? &all[at_] : nullptr;
    }

private:
    const QuantizedFrame* frame_;
    std::size_t at_ = 0;
};

/// Returns the survivors. `removed` contains ascending positions in the baseline.
std::vector<Survivor> find_survivors(const Baselines& baselines,
                                     const std::vector<std::size_t>& removed);

/// The difference between a frame and its baseline.
struct EntityDiff {
    std::vector<std::size_t> removed;                    ///< positions in the baseline
    std::vector<const EntityState*> spawned, surviving;  ///< surviving: parallel to survivors
    std::vector<Survivor> survivors;
    std::size_t unchanged_after = 0;  ///< number of skipped entities after the last survivor
};
EntityDiff entity_diff(const QuantizedFrame& frame, const Baselines& baselines);
/// For a frame and a baseline with the same entities. Entities in `unchanged` are skipped.
EntityDiff entity_diff(const QuantizedFrame& frame, const Baselines& baselines,
                       std::span<const UnchangedRun> unchanged);

/// Merges survivors and spawned entities. Both lists are sorted by id.
std::vector<EntityState> merge_entities(std::vector<EntityState> surviving,
                                        const std::vector<EntityState>& spawned);

/// Returns the spacing of a frame and its baselines; 1 where a frame is missing.
Spacing spacing_of(std::uint32_t frame, const Baselines& baselines);

/// Number of bits of a rotation component in two's complement.
unsigned component_bits(const QuantSpec& spec);
/// Returns whether decoded components form a valid rotation; a decoder must check this.
bool is_rotation(const std::array<std::int64_t, 3>& components, const QuantSpec& spec);
inline bool is_position(std::int64_t v) {
    return v >= -2147483648ll && v <= 2147483647ll;
}

}  // namespace jostle::snapshot
