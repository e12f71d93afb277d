// SPDX-License-Identifier: MIT
//
// Which shapes a body under way may meet: those in the trees, the planes, and those of all bodies
// that were fast in this step, by their ways. Part of solve_continuous: reads the world, writes
// itself alone. One thread at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/stages/continuous/swept_aabb_tree.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

class CcdCandidates {
public:
    // `before`: bodies before the step, by awake index. `fast`: awake indices of the fast bodies.
    // Both outlive this.
    CcdCandidates(const WorldState& world, const std::vector<BodyWarm>& previous,
                  const std::vector<std::uint32_t>& fast)
        : world_(world), previous_(previous), fast_(fast) {}

    // All shapes that may be in the box of a body's way, in order and once each: of two that are
    // met at the same moment the first counts.
    void find(std::uint32_t body, const Aabb& swept_box, std::vector<std::uint32_t>& near);
    // The body goes this way from now on.
    void set_swept_aabb(std::uint32_t body, const Aabb& swept_box);
    // Calls visit(body) for the bodies whose ways cross a box, in no order.
    template <class Visit>
    void for_each_swept(const Aabb& box, Visit&& visit) const {
        swept_.query(box, visit);
    }
    // Puts a body's shapes into an ordered list, if they are not in it yet.
    void insert(std::uint32_t body, std::vector<std::uint32_t>& near) const;
    // Orders a list, and takes out the body's own shapes and triggers.
    void tidy(std::uint32_t body, std::vector<std::uint32_t>& near) const;

private:
    void note_fast();  // once, when first needed

    const WorldState& world_;
    const std::vector<BodyWarm>& previous_;
    const std::vector<std::uint32_t>& fast_;
    SweptAabbTree swept_;
    bool some_slow_ = true;             // not all that may move were fast
    std::vector<std::uint32_t> found_;  // scratch
};

}  // namespace jostle::physics
