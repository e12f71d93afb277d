// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/contact_groups.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"

namespace jostle::physics {
namespace {

// A dynamic body of the task.
struct Member {
    std::uint32_t hot = 0;
    int component = -1;  // of bodies that manifolds connect
    double height = 0;   // m
};

// Calls visit(contact, lane) for each manifold of the body of a hot index.
template <class Visit>
void for_each_lane(WorldState& world, std::uint32_t hot, Visit&& visit) {
    const std::uint32_t body = world.bodies.awake[hot - 1].body;
    for_each_manifold(world.contacts, world.bodies.cold[body], [&](std::uint32_t index) {
        const Contact& c = world.contacts.contacts[index];
        if (c.colour_set != asleep_set) visit(c, lane_ref_of(world.graph, c));
    });
}

std::size_t first_body(const ContactLaneRef& at) {
    return static_cast<std::size_t>(at.block->a[at.lane]);
}
std::size_t second_body(const ContactLaneRef& at) {
    return static_cast<std::size_t>(at.block->b[at.lane]);
}

// Numbers the connected components of the bodies. `place`: by hot index, the body's index in
// `members`.
int find_components(WorldState& world, std::vector<Member>& members,
                    const std::vector<int>& place) {
    int count = 0;
    std::vector<std::size_t> stack;
    for (std::size_t seed = 0; seed < members.size(); seed++) {
        if (members[seed].component >= 0) continue;
        members[seed].component = count;
        stack.assign(1, seed);
        while (!stack.empty()) {
            const std::size_t own = stack.back();
            stack.pop_back();
            for_each_lane(world, members[own].hot, [&](const Contact& c, const ContactLaneRef& at) {
                if (pair_kind_of(c.colour) != PairKind::dynamic) return;
                for (const std::size_t hot : {first_body(at), second_body(at)}) {
                    ASSERT(hot < place.size() && place[hot] >= 0);
                    const auto other = static_cast<std::size_t>(place[hot]);
                    if (members[other].component >= 0) continue;
                    members[other].component = count;
                    stack.push_back(other);
                }
            });
        }
        count++;
    }
    return count;
}

void set_group(StepContext& step, std::span<const Member> members, const std::vector<int>& place,
               ContactGroup& group) {
    SolverBodies& records = step.scratch.solver.hot;
    std::vector<SolverBody*> bodies;
    std::vector<ManifoldOfGroup> manifolds;
    for (const Member& own : members) {
        bodies.push_back(&records[own.hot]);
        for_each_lane(step.world, own.hot, [&](const Contact& c, const ContactLaneRef& at) {
            if (first_body(at) != own.hot) return;  // seen from the other body
            ManifoldOfGroup manifold{at, place[own.hot]};
            const PairKind kind = pair_kind_of(c.colour);
            if (kind == PairKind::dynamic) manifold.b = place[second_body(at)];
            if (kind == PairKind::kinematic) manifold.mover = &records[second_body(at)];
            ASSERT(manifold.a >= 0 && manifold.a != manifold.b);
            manifolds.push_back(manifold);
        });
    }
    group.set(std::move(bodies), std::move(manifolds));
}

}  // namespace

void find_contact_groups(StepContext& step, const SolverTask& task, ContactGroups& groups) {
    WorldState& world = step.world;
    const Vec3 up = -world.def.gravity;
    std::vector<int> place(step.scratch.solver.hot.size(), -1);
    std::vector<Member> members;
    for (const std::uint32_t hot : step.scratch.solver.bodies.of(task.first, task.last)) {
        place[hot] = static_cast<int>(members.size());
        members.push_back({hot, -1, dot(up, world.bodies.awake[hot - 1].center)});
    }
    const auto count = static_cast<std::size_t>(find_components(world, members, place));
    // From the lowest to the highest: bodies that touch are close to each other in this order.
    std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
        if (a.component != b.component) return a.component < b.component;
        return a.height != b.height ? a.height < b.height : a.hot < b.hot;
    });
    if (groups.all.size() < count) groups.all.resize(count);
    groups.used = count;
    groups.passes = groups.unsolved = 0;
    std::size_t begin = 0;
    for (std::size_t k = 0; k < count; k++) {
        std::size_t end = begin;
        while (end < members.size() && members[end].component == static_cast<int>(k)) {
            place[members[end].hot] = static_cast<int>(end - begin);
            end++;
        }
        ASSERT(end > begin);
        set_group(step, std::span(members).subspan(begin, end - begin), place, groups.all[k]);
        begin = end;
    }
}

}  // namespace jostle::physics
