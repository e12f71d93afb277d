// SPDX-License-Identifier: MIT
#include "bench/broadphase/loose_octree.h"

#include <algorithm>

namespace jostle::bench {

using physics::Aabb;
using physics::maximum;
using physics::Vec3;

namespace {

constexpr std::size_t crowded_cube = 16;  // boxes in a cube above which it is divided
constexpr double side_min = 0x1p-6;       // m
// A box fits into a cube if it is slightly smaller; the margin covers the rounding of its centre.
constexpr double fill = 0.999;

Vec3 center_of(const Aabb& box) {
    return (box.low + box.high) * 0.5;
}
double longest_side(const Aabb& box) {
    const Vec3 d = box.high - box.low;
    return maximum(d.x, maximum(d.y, d.z));
}
int octant(Vec3 low, double half, Vec3 p) {
    return (p.x >= low.x + half ? 1 : 0) + (p.y >= low.y + half ? 2 : 0) +
           (p.z >= low.z + half ? 4 : 0);
}
Vec3 corner_of(Vec3 low, double half, int octant) {
    return low + Vec3{(octant & 1) != 0 ? half : 0, (octant & 2) != 0 ? half : 0,
                      (octant & 4) != 0 ? half : 0};
}

}  // namespace

Aabb LooseOctree::loose(const Cube& c) {
    return physics::grow({c.low, c.low + Vec3{c.side, c.side, c.side}}, 0.5 * c.side);
}

bool LooseOctree::belongs(const Cube& c, const Aabb& box) {
    const Vec3 p = center_of(box);
    for (int k = 0; k < 3; k++)
        if (p[k] < c.low[k] || p[k] >= c.low[k] + c.side) return false;
    return longest_side(box) <= fill * c.side;
}

std::int32_t LooseOctree::new_cube(Vec3 low, double side, std::int32_t parent) {
    std::int32_t i = free_cube_;
    if (i == none) {
        i = static_cast<std::int32_t>(cubes_.size());
        cubes_.emplace_back();
    } else {
        free_cube_ = cube(i).parent;
        std::vector<Entry> room = std::move(cube(i).entries);
        cube(i) = {};
        cube(i).entries = std::move(room);
    }
    cube(i).low = low;
    cube(i).side = side;
    cube(i).parent = parent;
    return i;
}

// Doubles the root toward the box until the box belongs in it.
void LooseOctree::grow_root(const Aabb& box) {
    const Vec3 p = center_of(box);
    if (root_ == none) {
        double side = 1;
        while (longest_side(box) > fill * side) side *= 2;
        root_ = new_cube(p - Vec3{side, side, side} * 0.5, side, none);
    }
    while (!belongs(cube(root_), box)) {
        const Cube old = cube(root_);
        int octant = 0;  // of the old root in the new one
        Vec3 low = old.low;
        for (int k = 0; k < 3; k++)
            if (p[k] < old.low[k]) {
                octant |= 1 << k;
                low[k] -= old.side;
            }
        const std::int32_t root = new_cube(low, 2 * old.side, none);
        cube(root).count = old.count;
        cube(root).divided = true;
        cube(root).child[static_cast<std::size_t>(octant)] = root_;
        cube(root_).parent = root;
        root_ = root;
    }
}

// The child cube for the box; none if the box is too large for it.
std::int32_t LooseOctree::child_for(std::int32_t at, const Aabb& box) {
    const double half = 0.5 * cube(at).side;
    if (half < side_min || longest_side(box) > fill * half) return none;
    const int k = octant(cube(at).low, half, center_of(box));
    const auto slot = static_cast<std::size_t>(k);
    if (cube(at).child[slot] == none) {
        const std::int32_t made = new_cube(corner_of(cube(at).low, half, k), half, at);
        cube(at).child[slot] = made;
    }
    return cube(at).child[slot];
}

void LooseOctree::add_to(std::int32_t at, const Entry& entry) {
    slot(entry.handle) = {at, static_cast<std::int32_t>(cube(at).entries.size())};
    cube(at).entries.push_back(entry);
}

void LooseOctree::divide(std::int32_t at) {
    std::vector<Entry> all = std::move(cube(at).entries);
    cube(at).entries.clear();
    cube(at).divided = true;
    for (const Entry& entry : all) {
        const std::int32_t below = child_for(at, entry.box);
        if (below == none) {
            add_to(at, entry);
            continue;
        }
        cube(below).count++;
        add_to(below, entry);
    }
}

// `from` contains the box and has already counted it.
void LooseOctree::insert_into(const Entry& entry, std::int32_t from) {
    std::int32_t at = from;
    for (;;) {
        if (!cube(at).divided && cube(at).entries.size() >= crowded_cube) divide(at);
        const std::int32_t below = cube(at).divided ? child_for(at, entry.box) : none;
        if (below == none) break;
        at = below;
        cube(at).count++;
    }
    add_to(at, entry);
}

// Does not change the counts.
void LooseOctree::remove_from(std::int32_t handle) {
    const Slot where = slot(handle);
    std::vector<Entry>& entries = cube(where.cube).entries;
    const auto at = static_cast<std::size_t>(where.at);
    entries[at] = entries.back();
    entries.pop_back();
    if (at < entries.size()) slot(entries[at].handle).at = where.at;
}

std::int32_t LooseOctree::insert(const Aabb& box, std::uint32_t item, std::uint32_t category) {
    std::int32_t handle = free_handle_;
    if (handle == none) {
        handle = static_cast<std::int32_t>(slots_.size());
        slots_.emplace_back();
    } else {
        free_handle_ = slot(handle).at;
    }
    grow_root(box);
    cube(root_).count++;
    insert_into({box, item, category, handle}, root_);
    return handle;
}

void LooseOctree::remove(std::int32_t handle) {
    std::int32_t at = slot(handle).cube;
    remove_from(handle);
    slot(handle) = {none, free_handle_};
    free_handle_ = handle;
    // Frees the cubes that are now empty, including their descendants.
    while (at != none) {
        const std::int32_t parent = cube(at).parent;
        if (--cube(at).count == 0) {
            if (parent != none)
                std::replace(cube(parent).child.begin(), cube(parent).child.end(), at, none);
            else
                root_ = none;
            cube(at).parent = free_cube_;
            free_cube_ = at;
        }
        at = parent;
    }
}

void LooseOctree::move(std::int32_t handle, const Aabb& box) {
    const Slot where = slot(handle);
    Entry entry = cube(where.cube).entries[static_cast<std::size_t>(where.at)];
    if (belongs(cube(where.cube), box)) {
        // The box stays in its cube, even if a child would fit: moving it down would gain little.
        cube(where.cube).entries[static_cast<std::size_t>(where.at)].box = box;
        return;
    }
    entry.box = box;
    remove_from(handle);
    // Ascends to the first cube that the box belongs in, then descends from there.
    std::int32_t at = where.cube;
    while (at != none && !belongs(cube(at), box)) {
        const std::int32_t parent = cube(at).parent;
        if (--cube(at).count == 0 && parent != none) {
            std::replace(cube(parent).child.begin(), cube(parent).child.end(), at, none);
            cube(at).parent = free_cube_;
            free_cube_ = at;
        }
        at = parent;
    }
    if (at == none) {
        grow_root(box);
        cube(root_).count++;
        at = root_;
    }
    insert_into(entry, at);
}

void LooseOctree::query(const Aabb& box, std::uint32_t mask,
                        std::vector<std::uint32_t>& found) const {
    if (root_ != none) query_below(root_, box, mask, found);
}

void LooseOctree::query_below(std::int32_t at, const Aabb& box, std::uint32_t mask,
                              std::vector<std::uint32_t>& found) const {
    const Cube& c = cube(at);
    for (const Entry& e : c.entries)
        if ((e.category & mask) != 0 && overlap(e.box, box)) found.push_back(e.item);
    if (!c.divided) return;
    for (const std::int32_t below : c.child)
        if (below != none && overlap(loose(cube(below)), box)) query_below(below, box, mask, found);
}

void LooseOctree::cast_ray(Vec3 origin, Vec3 motion, std::uint32_t mask,
                           const RayVisit& visit) const {
    if (root_ != none) cast_below(root_, {origin, motion, mask, &visit}, 1);
}

// Nearer cubes first. Returns the new limit.
double LooseOctree::cast_below(std::int32_t at, const Ray& ray, double limit) const {
    const Cube& c = cube(at);
    for (const Entry& e : c.entries)
        if ((e.category & ray.mask) != 0 &&
            physics::ray_enters(e.box, ray.origin, ray.motion, limit) <= limit)
            limit = (*ray.visit)(e.item, limit);
    if (!c.divided) return limit;
    struct Entered {
        double fraction;
        std::int32_t cube;
    };
    std::array<Entered, 8> entered;  // sorted by fraction
    std::size_t count = 0;
    for (const std::int32_t below : c.child) {
        if (below == none) continue;
        const double from = physics::ray_enters(loose(cube(below)), ray.origin, ray.motion, limit);
        if (from > limit) continue;
        std::size_t k = count++;
        for (; k > 0 && entered[k - 1].fraction > from; k--) entered[k] = entered[k - 1];
        entered[k] = {from, below};
    }
    for (std::size_t k = 0; k < count; k++)
        if (entered[k].fraction <= limit) limit = cast_below(entered[k].cube, ray, limit);
    return limit;
}

std::unique_ptr<physics::BroadPhaseIndex> LooseOctree::clone() const {
    return std::make_unique<LooseOctree>(*this);
}

void LooseOctree::assign(const BroadPhaseIndex& other) {
    *this = static_cast<const LooseOctree&>(other);
}

void LooseOctree::cells(std::vector<Aabb>& out) const {
    std::vector<std::int32_t> stack;
    if (root_ != none) stack.push_back(root_);
    while (!stack.empty()) {
        const Cube& c = cube(stack.back());
        stack.pop_back();
        if (!c.entries.empty()) out.push_back(loose(c));
        for (const std::int32_t below : c.child)
            if (below != none) stack.push_back(below);
    }
}

}  // namespace jostle::bench
