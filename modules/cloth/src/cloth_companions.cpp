// SPDX-License-Identifier: MIT
#include "modules/cloth/src/cloth_companions.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/scalar.h"
#include "modules/cloth/src/cloth_contacts.h"
#include "modules/cloth/src/cloth_step.h"

namespace jostle::modules::cloth_detail {

using namespace physics;

namespace {

// Where a cloth may be in the step.
struct Reach {
    Cloth* cloth = nullptr;
    double margin = 0;  // m, around its vertices
    Aabb box = {};
};

class Companions {
public:
    Companions(std::span<const std::unique_ptr<Cloth>> cloths, double dt, Vec3 gravity) {
        for (const auto& cloth : cloths) {
            if (!cloth->def.collide_cloths) continue;
            const double speed = cloth->awake ? greatest_speed(cloth->sheet) : 0;
            const double fall = cloth->awake ? dt * length(gravity) : 0;
            add(*cloth, cloth->def.thickness + dt * (speed + fall));
        }
    }
    void run() {
        find_pairs();
        wake_touched();
        group();
    }

private:
    void add(Cloth& cloth, double margin) {
        Reach reach{&cloth, margin, {cloth.sheet.position(0), cloth.sheet.position(0)}};
        for (std::size_t k = 1; k < cloth.sheet.size(); k++) {
            reach.box.low = min(reach.box.low, cloth.sheet.position(k));
            reach.box.high = max(reach.box.high, cloth.sheet.position(k));
        }
        const Vec3 more{margin, margin, margin};
        reach.box = {reach.box.low - more, reach.box.high + more};
        reaches_.push_back(reach);
    }

    // Whether a vertex is in the box of the other cloth, above a speed.
    static bool reaches_into(const Reach& reach, const Reach& other, double speed) {
        const Sheet& sheet = reach.cloth->sheet;
        const Vec3 more{reach.margin, reach.margin, reach.margin};
        const Aabb box{other.box.low - more, other.box.high + more};
        for (std::size_t k = 0; k < sheet.size(); k++)
            if (contains(box, sheet.position(k)) &&
                length_squared(sheet.velocity(k)) >= speed * speed)
                return true;
        return false;
    }
    static bool contains(const Aabb& box, Vec3 p) {
        return p.x >= box.low.x && p.y >= box.low.y && p.z >= box.low.z && p.x <= box.high.x &&
               p.y <= box.high.y && p.z <= box.high.z;
    }

    void find_pairs() {
        for (std::uint32_t a = 0; a < reaches_.size(); a++)
            for (std::uint32_t b = a + 1; b < reaches_.size(); b++) {
                if (!reaches_[a].cloth->awake && !reaches_[b].cloth->awake) continue;
                if (!overlap(reaches_[a].box, reaches_[b].box)) continue;
                pairs_.push_back({a, b});
            }
    }

    void wake_touched() {
        for (bool any = true; any;) {
            any = false;
            for (const auto& [a, b] : pairs_) {
                const Reach &x = reaches_[a], &y = reaches_[b];
                if (x.cloth->awake == y.cloth->awake) continue;
                const Reach &moving = x.cloth->awake ? x : y, &resting = x.cloth->awake ? y : x;
                if (!reaches_into(moving, resting, CarriedBodies::rest_speed)) continue;
                wake(*resting.cloth);
                any = true;
            }
        }
    }

    void group() {
        leaders_.resize(reaches_.size());
        for (std::uint32_t k = 0; k < leaders_.size(); k++) leaders_[k] = k;
        for (const auto& [a, b] : pairs_) {
            if (!reaches_[a].cloth->awake || !reaches_[b].cloth->awake) continue;
            const std::uint32_t x = leader_of(a), y = leader_of(b);
            leaders_[std::max(x, y)] = std::min(x, y);
        }
        for (std::uint32_t k = 0; k < leaders_.size(); k++) {
            const std::uint32_t leader = leader_of(k);
            if (leader == k) continue;
            reaches_[k].cloth->leader = reaches_[leader].cloth;
            reaches_[leader].cloth->companions.push_back(reaches_[k].cloth);
        }
        for (const auto& [a, b] : pairs_) {
            if (reaches_[a].cloth->awake == reaches_[b].cloth->awake) continue;
            const bool first = reaches_[a].cloth->awake;
            std::vector<Cloth*>& obstacles = reaches_[leader_of(first ? a : b)].cloth->obstacles;
            obstacles.push_back(reaches_[first ? b : a].cloth);
        }
        for (const Reach& reach : reaches_) {
            std::vector<Cloth*>& obstacles = reach.cloth->obstacles;
            std::ranges::sort(obstacles, {}, &Cloth::key);
            obstacles.erase(std::unique(obstacles.begin(), obstacles.end()), obstacles.end());
        }
    }
    std::uint32_t leader_of(std::uint32_t k) const {
        while (leaders_[k] != k) k = leaders_[k];
        return k;
    }

    std::vector<Reach> reaches_;  // by key
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
    std::vector<std::uint32_t> leaders_;
};

}  // namespace

void find_companions(std::span<const std::unique_ptr<Cloth>> cloths, double dt, Vec3 gravity) {
    if (cloths.size() > 1) Companions(cloths, dt, gravity).run();
}

void forget_companion(std::span<const std::unique_ptr<Cloth>> cloths, const Cloth& removed) {
    for (const auto& cloth : cloths) {
        if (cloth->leader == &removed) cloth->leader = nullptr;
        std::erase(cloth->companions, &removed);
        std::erase(cloth->obstacles, &removed);
    }
}

}  // namespace jostle::modules::cloth_detail
