// SPDX-License-Identifier: MIT
#include "physics/src/collision/broadphase/broad_phase.h"

#include "physics/src/collision/broadphase/dynamic_tree.h"
#include "physics/src/collision/broadphase/sort_and_sweep.h"
#include "physics/src/collision/broadphase/uniform_grid.h"

namespace jostle::physics {
namespace {

class TreeIndex final : public BroadPhaseIndex {
public:
    std::int32_t insert(const Aabb& box, std::uint32_t item, std::uint32_t category) override {
        return tree_.insert(box, item, category);
    }
    void remove(std::int32_t handle) override { tree_.remove(handle); }
    void move(std::int32_t handle, const Aabb& box) override { tree_.move(handle, box); }
    void move_all(std::span<const Move> moves) override {
        // Moving one leaf costs as much as building eight leaves of a new tree. A new tree also
        // answers queries faster.
        if (moves.size() * 8 < static_cast<std::size_t>(tree_.leaf_count()))
            return BroadPhaseIndex::move_all(moves);
        for (const Move& m : moves) tree_.change(m.handle, m.box);
        tree_.rebuild();
    }
    void query(const Aabb& box, std::uint32_t mask,
               std::vector<std::uint32_t>& found) const override {
        tree_.query(box, mask, [&](std::uint32_t item) { found.push_back(item); });
    }
    void cast_ray(Vec3 origin, Vec3 motion, std::uint32_t mask,
                  const RayVisit& visit) const override {
        tree_.cast_ray(origin, motion, mask, visit);
    }
    std::unique_ptr<BroadPhaseIndex> clone() const override {
        return std::make_unique<TreeIndex>(*this);
    }
    void assign(const BroadPhaseIndex& other) override {
        *this = static_cast<const TreeIndex&>(other);
    }
    void cells(std::vector<Aabb>& out) const override {
        tree_.for_each_branch([&](const Aabb& box, int) { out.push_back(box); });
    }

private:
    DynamicTree tree_;
};

}  // namespace

std::unique_ptr<BroadPhaseIndex> make_broad_phase(BroadPhase kind) {
    switch (kind) {
        case BroadPhase::sort_and_sweep:
            return std::make_unique<SortAndSweep>();
        case BroadPhase::uniform_grid:
            return std::make_unique<UniformGrid>();
        case BroadPhase::dynamic_tree:
            break;
    }
    return std::make_unique<TreeIndex>();
}

}  // namespace jostle::physics
