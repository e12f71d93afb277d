// SPDX-License-Identifier: MIT
//
// A loose octree (Ulrich, "Loose Octrees", Game Programming Gems, 2000): cubes that are halved in
// each direction. A box belongs to the one cube that contains its centre and is no smaller than its
// longest side. It therefore extends beyond the cube by at most half the cube's side, and queries
// treat cubes as if they were twice as large. A cube is divided only when it contains many boxes.
#pragma once

#include <array>

#include "physics/src/collision/broadphase/broad_phase_index.h"

namespace jostle::bench {

class LooseOctree final : public physics::BroadPhaseIndex {
public:
    std::int32_t insert(const physics::Aabb& box, std::uint32_t item,
                        std::uint32_t category) override;
    void remove(std::int32_t handle) override;
    void move(std::int32_t handle, const physics::Aabb& box) override;
    void query(const physics::Aabb& box, std::uint32_t mask,
               std::vector<std::uint32_t>& found) const override;
    void cast_ray(physics::Vec3 origin, physics::Vec3 motion, std::uint32_t mask,
                  const RayVisit& visit) const override;
    std::unique_ptr<physics::BroadPhaseIndex> clone() const override;
    void assign(const physics::BroadPhaseIndex& other) override;
    void cells(std::vector<physics::Aabb>& out) const override;

private:
    static constexpr std::int32_t none = -1;

    struct Entry {
        physics::Aabb box;
        std::uint32_t item = 0, category = 0;
        std::int32_t handle = none;
    };
    struct Cube {
        physics::Vec3 low;
        double side = 0;             // m, a power of two
        std::int32_t parent = none;  // the next free cube while on the free list
        std::int32_t count = 0;      // of boxes in it and in its descendants
        bool divided = false;        // boxes that fit into a child are stored there
        std::array<std::int32_t, 8> child{none, none, none, none, none, none, none, none};
        std::vector<Entry> entries;
    };
    struct Slot {
        // index in entries; on the free list: the next free handle
        std::int32_t cube = none, at = 0;
    };

    Cube& cube(std::int32_t i) { return cubes_[static_cast<std::size_t>(i)]; }
    const Cube& cube(std::int32_t i) const { return cubes_[static_cast<std::size_t>(i)]; }
    Slot& slot(std::int32_t handle) { return slots_[static_cast<std::size_t>(handle)]; }
    static physics::Aabb loose(const Cube& cube);
    static bool belongs(const Cube& cube, const physics::Aabb& box);
    std::int32_t new_cube(physics::Vec3 low, double side, std::int32_t parent);
    void grow_root(const physics::Aabb& box);
    void insert_into(const Entry& entry, std::int32_t from);
    void add_to(std::int32_t at, const Entry& entry);
    void divide(std::int32_t at);
    std::int32_t child_for(std::int32_t at, const physics::Aabb& box);
    void remove_from(std::int32_t handle);
    void query_below(std::int32_t at, const physics::Aabb& box, std::uint32_t mask,
                     std::vector<std::uint32_t>& found) const;
    struct Ray {
        physics::Vec3 origin, motion;
        std::uint32_t mask;
        const RayVisit* visit;
    };
    double cast_below(std::int32_t at, const Ray& ray, double limit) const;

    std::vector<Cube> cubes_;
    std::vector<Slot> slots_;  // by handle
    std::int32_t root_ = none, free_cube_ = none, free_handle_ = none;
};

}  // namespace jostle::bench
