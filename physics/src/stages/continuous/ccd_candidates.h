// SPDX-License-Identifier: MIT
//
// Finds the shapes that a moving body may hit: shapes in the trees, planes, and the shapes of all
// bodies that were fast in this step, by their swept boxes. Part of solve_continuous. Reads the
// world, writes only itself. Not thread-safe.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/stages/continuous/swept_aabb_tree.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

class CcdCandidates {
public:
    // `previous`: bodies before the step, by awake index. `fast`: awake indices of the fast bodies.
    // Both must outlive this object.
    CcdCandidates(const WorldState& world, const std::vector<BodyWarm>& previous,
                  const std::vector<std::uint32_t>& fast)
        : world_(world), previous_(previous), fast_(fast) {}

    // Finds all shapes that may overlap a body's swept box, sorted and without duplicates. If two
    // are hit at the same time, the first one counts.
    void find(std::uint32_t body, const Aabb& swept_box, std::vector<std::uint32_t>& near);
    // Replaces the swept box of a body.
    void set_swept_aabb(std::uint32_t body, const Aabb& swept_box);
    // Calls visit(body) for the bodies whose swept boxes overlap a box, in no particular order.
    template <class Visit>
    void for_each_swept(const Aabb& box, Visit&& visit) const {
        swept_.query(box, visit);
    }
    // Inserts a body's shapes into a sorted list without duplicates.
    void insert(std::uint32_t body, std::vector<std::uint32_t>& near) const;
    // Sorts a list and removes the body's own shapes and triggers.
    void tidy(std::uint32_t body, std::vector<std::uint32_t>& near) const;

private:
    void note_fast();  // runs once, on first use

    const WorldState& world_;
    const std::vector<BodyWarm>& previous_;
    const std::vector<std::uint32_t>& fast_;
    SweptAabbTree swept_;
    bool some_slow_ = true;             // some movable bodies were not fast
    std::vector<std::uint32_t> found_;  // scratch memory
};

}  // namespace jostle::physics
