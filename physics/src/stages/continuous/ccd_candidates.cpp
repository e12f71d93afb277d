// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/ccd_candidates.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {

void CcdCandidates::find(std::uint32_t body, const Aabb& swept_box,
                         std::vector<std::uint32_t>& near) {
    ASSERT(near.empty());
    note_fast();
    swept_.query(swept_box, [&](std::uint32_t other) {
        for (std::uint32_t s = world_.bodies.cold[other].first_shape; s != none;
             s = world_.shapes.shapes[s].next)
            near.push_back(s);
    });
    found_.clear();
    world_.shapes.statics->query(swept_box, 0xffffffff, found_);
    if (some_slow_) world_.shapes.moving->query(swept_box, 0xffffffff, found_);
    // Fast bodies are found by their swept boxes; their boxes in the trees extend over several
    // steps.
    for (const std::uint32_t shape : found_)
        if (!swept_.has(world_.shapes.shapes[shape].body)) near.push_back(shape);
    for (const std::uint32_t plane : world_.shapes.planes)
        if (reaches_plane(world_, world_.shapes.shapes[plane], swept_box)) near.push_back(plane);
    tidy(body, near);
}

void CcdCandidates::set_swept_aabb(std::uint32_t body, const Aabb& swept_box) {
    note_fast();
    swept_.set(body, swept_box);
}

void CcdCandidates::insert(std::uint32_t body, std::vector<std::uint32_t>& near) const {
    for (std::uint32_t s = world_.bodies.cold[body].first_shape; s != none;
         s = world_.shapes.shapes[s].next) {
        const auto position = std::lower_bound(near.begin(), near.end(), s);
        const bool known = position != near.end() && *position == s;
        if (!known && !world_.shapes.shapes[s].trigger) near.insert(position, s);
    }
}

void CcdCandidates::tidy(std::uint32_t body, std::vector<std::uint32_t>& near) const {
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::erase_if(near, [&](std::uint32_t s) {
        return world_.shapes.shapes[s].body == body || world_.shapes.shapes[s].trigger;
    });
}

void CcdCandidates::note_fast() {
    if (!swept_.empty()) return;
    const std::size_t moving = world_.bodies.ids.alive_count() - world_.bodies.statics.size();
    some_slow_ = moving > fast_.size();
    std::vector<std::uint32_t> bodies;
    for (const std::uint32_t i : fast_) bodies.push_back(world_.bodies.awake[i].body);
    swept_.set_all(bodies, [&](std::uint32_t body) {
        const BodyCold& cold = world_.bodies.cold[body];
        ASSERT(cold.at < previous_.size() && previous_[cold.at].body == body);
        const Vec3 from = previous_[cold.at].center, to = world_.bodies.awake[cold.at].center;
        return grow({min(from, to), max(from, to)}, cold.radius + tuning::swept_margin);
    });
}

}  // namespace jostle::physics
