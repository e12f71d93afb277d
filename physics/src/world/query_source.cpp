// SPDX-License-Identifier: MIT
#include "physics/src/world/query_source.h"

#include <algorithm>
#include <string>
#include <utility>

#include "jostle/physics/world.h"
#include "physics/src/collision/broadphase/dynamic_tree.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/state/world_state.h"
#include "physics/src/world/checks.h"

namespace jostle::physics {
namespace {

QueryShape shape_at(const ShapedBodies& stores, std::uint32_t index) {
    const ShapeRecord& s = stores.shapes.shapes[index];
    return {transformed_shape(s, warm_of(stores, s.body)), shape_id(stores.shapes, index),
            body_id(stores.bodies, s.body), s.filter, s.trigger};
}

// Base of sources with the two broad phases of a world.
class IndexedSource : public QuerySource {
public:
    void query(const Aabb& box, std::uint32_t categories,
               std::vector<std::uint32_t>& found) const override {
        fixed().query(box, categories, found);
        moving().query(box, categories, found);
    }
    void cast_ray(Vec3 origin, Vec3 motion, std::uint32_t categories,
                  const BroadPhaseIndex::RayVisit& visit) const override {
        fixed().cast_ray(origin, motion, categories, visit);
        moving().cast_ray(origin, motion, categories, visit);
    }

private:
    virtual const BroadPhaseIndex& fixed() const = 0;
    virtual const BroadPhaseIndex& moving() const = 0;
};

class LiveSource final : public IndexedSource {
public:
    explicit LiveSource(const WorldState& world) : world_(world) {}
    std::uint64_t step() const override { return world_.steps; }
    QueryShape shape(std::uint32_t index) const override { return shape_at(world_, index); }
    std::optional<QueryShape> find(ShapeId id) const override {
        if (!world_.shapes.ids.alive(id.index) || shape_id(world_.shapes, id.index) != id)
            return std::nullopt;
        return shape_at(world_, id.index);
    }
    const std::vector<std::uint32_t>& planes() const override { return world_.shapes.planes; }

private:
    const BroadPhaseIndex& fixed() const override { return *world_.shapes.statics; }
    const BroadPhaseIndex& moving() const override { return *world_.shapes.moving; }

    const WorldState& world_;
};

// Owns its data; shared geometry remains shared.
class CopiedSource final : public IndexedSource {
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
            shapes_[i].transformed_shape.geometry = &geometry_[i];
        }
        fixed_ = world.shapes.statics->clone();
        moving_ = world.shapes.moving->clone();
        fixed_->flush();
        moving_->flush();
    }
    std::uint64_t step() const override { return step_; }
    QueryShape shape(std::uint32_t index) const override { return shapes_[index]; }
    std::optional<QueryShape> find(ShapeId id) const override {
        if (id.index >= shapes_.size() || is_null(id) || shapes_[id.index].shape != id)
            return std::nullopt;
        return shapes_[id.index];
    }
    const std::vector<std::uint32_t>& planes() const override { return planes_; }

private:
    const BroadPhaseIndex& fixed() const override { return *fixed_; }
    const BroadPhaseIndex& moving() const override { return *moving_; }

    std::uint64_t step_;
    std::vector<std::uint32_t> planes_;
    std::vector<Geometry> geometry_;
    std::vector<QueryShape> shapes_;
    std::unique_ptr<BroadPhaseIndex> fixed_, moving_;
};

// A subset of the shapes of another source at other poses.
class OverridePoseSource final : public QuerySource {
public:
    OverridePoseSource(std::shared_ptr<const QuerySource> of,
                       std::vector<ShapePlacement> placements)
        : of_(std::move(of)) {
        std::ranges::sort(placements, {}, &ShapePlacement::shape);
        shapes_.reserve(placements.size());
        for (const ShapePlacement& placement : placements) {
            std::optional<QueryShape> shape = of_->find(placement.shape);
            if (!shape) continue;
            const auto number = static_cast<std::uint32_t>(shapes_.size());
            shape->transformed_shape =
                transformed_shape(*shape->transformed_shape.geometry, placement.pose);
            shapes_.push_back(*shape);
            if (kind_of(*shape->transformed_shape.geometry) == ShapeKind::plane)
                planes_.push_back(number);
            else
                tree_.add(bounds_of(shape->transformed_shape), number, shape->filter.category);
        }
        tree_.rebuild();
    }
    std::uint64_t step() const override { return of_->step(); }
    QueryShape shape(std::uint32_t number) const override { return shapes_[number]; }
    std::optional<QueryShape> find(ShapeId id) const override {
        const auto at = std::ranges::lower_bound(shapes_, id, {}, &QueryShape::shape);
        if (at == shapes_.end() || at->shape != id) return std::nullopt;
        return *at;
    }
    void query(const Aabb& box, std::uint32_t categories,
               std::vector<std::uint32_t>& found) const override {
        tree_.query(box, categories, [&](std::uint32_t number) { found.push_back(number); });
    }
    void cast_ray(Vec3 origin, Vec3 motion, std::uint32_t categories,
                  const BroadPhaseIndex::RayVisit& visit) const override {
        tree_.cast_ray(origin, motion, categories, visit);
    }
    const std::vector<std::uint32_t>& planes() const override { return planes_; }

private:
    std::shared_ptr<const QuerySource> of_;  // owns the geometry
    std::vector<QueryShape> shapes_;         // sorted by id
    std::vector<std::uint32_t> planes_;
    DynamicTree tree_;
};

}  // namespace

Queries World::queries() const {
    return Queries(std::make_shared<const LiveSource>(*state_));
}

Queries World::query_frame() const {
    return Queries(std::make_shared<const CopiedSource>(*state_));
}

Result<Queries> Queries::with_shapes_at(std::vector<ShapePlacement> shapes) const {
    for (std::size_t k = 0; k < shapes.size(); k++) {
        if (const Status s = check_pose("pose", shapes[k].pose); !s.ok())
            return Error{s.error().code, "shapes[" + std::to_string(k) + "]." + s.error().message};
        shapes[k].pose.rotation = unit(shapes[k].pose.rotation);
    }
    return Queries(std::make_shared<const OverridePoseSource>(source_, std::move(shapes)));
}

}  // namespace jostle::physics
