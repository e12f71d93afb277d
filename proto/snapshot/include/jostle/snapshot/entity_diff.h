// SPDX-License-Identifier: MIT
//
// What both codecs of frames begin with: which entities of the base are still there, what older
// bases say of them, and how far apart the frames are. Any thread.
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

namespace jostle::wire {

inline Error corrupt(std::string message) {
    return {ErrorCode::corrupt_data, std::move(message)};
}

// An entity of the base that is still there. Of one at rest the older bases say nothing that a
// codec asks for: they are left out.
struct Survivor {
    const EntityState* baseline = nullptr;
    const EntityState* baseline2 = nullptr;
    const EntityState* baseline3 = nullptr;
    // So many left out just before it, for an encoder: they rest in the base, and stay as they are.
    std::size_t unchanged_before = 0;
};

// Walks a frame's entities along rising ids.
class EntityFinder {
public:
    explicit EntityFinder(const QuantizedFrame* frame) : frame_(frame) {}

    const EntityState* find(std::uint32_t id) {
        if (!frame_) return nullptr;
        const std::vector<EntityState>& all = frame_->entities;
        // Mostly there are no gaps between ids, and it is as far on as the id is.
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

// `removed`: rising positions in the base.
std::vector<Survivor> find_survivors(const Baselines& baselines,
                                     const std::vector<std::size_t>& removed);

// What becomes of the base's entities in a frame.
struct EntityDiff {
    std::vector<std::size_t> removed;                    // positions in the base
    std::vector<const EntityState*> spawned, surviving;  // kept: as many as survivors
    std::vector<Survivor> survivors;
    std::size_t unchanged_after = 0;  // left out after the last one
};
EntityDiff entity_diff(const QuantizedFrame& frame, const Baselines& baselines);
// Where frame and base are of the same entities, and those in `quiet` need not be looked at.
EntityDiff entity_diff(const QuantizedFrame& frame, const Baselines& baselines,
                       std::span<const UnchangedRun> unchanged);

// Survivors and newcomers as one list. Both rise.
std::vector<EntityState> merge_entities(std::vector<EntityState> surviving,
                                        const std::vector<EntityState>& spawned);

// 1 where a frame is missing.
Spacing spacing_of(std::uint32_t frame, const Baselines& baselines);

// Bits of a component of a rotation in two's complement.
unsigned component_bits(const QuantSpec& spec);
// What a decoder must check of what it read.
bool is_rotation(const std::array<std::int64_t, 3>& components, const QuantSpec& spec);
inline bool is_position(std::int64_t v) {
    return v >= -2147483648ll && v <= 2147483647ll;
}

}  // namespace jostle::wire
