// SPDX-License-Identifier: MIT
#include "world/query_source.h"

#include "jostle/physics/world.h"
#include "state/world_state.h"

namespace jostle::physics {
namespace {

QueryShape shape_at(const WorldState& world, std::uint32_t index) {
    const ShapeRecord& s = world.shapes.shapes[index];
    return {placed(s, warm_of(world, s.body)), shape_id(world, index), body_id(world, s.body),
            s.filter, s.trigger};
}

class LiveSource final : public QuerySource {
public:
    explicit LiveSource(const WorldState& world) : world_(world) {}
    std::uint64_t step() const override { return world_.steps; }
    QueryShape shape(std::uint32_t index) const override { return shape_at(world_, index); }
    const BroadPhaseIndex& fixed() const override { return *world_.shapes.statics; }
    const BroadPhaseIndex& moving() const override { return *world_.shapes.moving; }
    const std::vector<std::uint32_t>& planes() const override { return world_.shapes.planes; }

private:
    const WorldState& world_;
};

// Owns all that it shows; geometry that is shared stays shared.
class CopiedSource final : public QuerySource {
public:
    explicit CopiedSource(const WorldState& world)
        : step_(world.steps), planes_(world.shapes.planes) {
        const std::uint32_t count = world.shapes.ids.size();
        shapes_.resize(count);
        geometry_.resize(count);
        for (std::uint32_t i = 0; i < count; i++) {
            if (!world.shapes.ids.alive(i)) continue;
            geometry_[i] = world.shapes.shapes[i].geometry;
            shapes_[i] = shape_at(world, i);
            shapes_[i].placed.geometry = &geometry_[i];
        }
        fixed_ = world.shapes.statics->clone();
        moving_ = world.shapes.moving->clone();
        fixed_->flush();
        moving_->flush();
    }
    std::uint64_t step() const override { return step_; }
    QueryShape shape(std::uint32_t index) const override { return shapes_[index]; }
    const BroadPhaseIndex& fixed() const override { return *fixed_; }
    const BroadPhaseIndex& moving() const override { return *moving_; }
    const std::vector<std::uint32_t>& planes() const override { return planes_; }

private:
    std::uint64_t step_;
    std::vector<std::uint32_t> planes_;
    std::vector<Geometry> geometry_;
    std::vector<QueryShape> shapes_;
    std::unique_ptr<BroadPhaseIndex> fixed_, moving_;
};

}  // namespace

Queries World::queries() const {
    return Queries(std::make_shared<const LiveSource>(*state_));
}

Queries World::query_frame() const {
    return Queries(std::make_shared<const CopiedSource>(*state_));
}

}  // namespace jostle::physics
