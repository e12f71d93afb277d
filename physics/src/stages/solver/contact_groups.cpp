// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/contact_groups.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
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

// The bodies of a component by height, which manifolds connect.
struct Component {
    std::span<const Member> members;
    const std::vector<int>& place;  // by hot index, the body's index in `members`
};

// The members such that those that touch are close to each other: reverse Cuthill-McKee (1969),
// from a member that is far from the lowest one.
std::vector<int> find_order(WorldState& world, const Component& component) {
    const std::size_t count = component.members.size();
    std::vector<std::vector<int>> neighbours(count);
    for (std::size_t own = 0; own < count; own++)
        for_each_lane(world, component.members[own].hot,
                      [&](const Contact& c, const ContactLaneRef& at) {
                          if (pair_kind_of(c.colour) != PairKind::dynamic) return;
                          const std::size_t a = first_body(at), b = second_body(at);
                          const std::size_t other = a == component.members[own].hot ? b : a;
                          neighbours[own].push_back(component.place[other]);
                      });
    for (std::vector<int>& of : neighbours) std::sort(of.begin(), of.end());
    const auto degree = [&](int member) {
        return neighbours[static_cast<std::size_t>(member)].size();
    };
    std::vector<int> order;
    int start = 0;
    for (int pass = 0; pass < 3; pass++) {
        std::vector<bool> reached(count, false);
        order.assign(1, start);
        reached[static_cast<std::size_t>(start)] = true;
        for (std::size_t next = 0; next < order.size(); next++) {
            const std::size_t first = order.size();
            for (const int other : neighbours[static_cast<std::size_t>(order[next])]) {
                if (reached[static_cast<std::size_t>(other)]) continue;
                reached[static_cast<std::size_t>(other)] = true;
                order.push_back(other);
            }
            std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.end(),
                             [&](int x, int y) { return degree(x) < degree(y); });
        }
        start = order.back();
    }
    ASSERT(order.size() == count);
    std::reverse(order.begin(), order.end());
    return order;
}

// Work that a group may use in a step. The share does not depend on how tasks are formed, so it is
// the same for any number of threads.
std::int64_t max_work_of(const StepContext& step, std::size_t bodies) {
    const std::int64_t share = tuning::max_direct_step_work * static_cast<std::int64_t>(bodies) /
                               step.world.profile.bodies_direct;
    return std::min(share, tuning::max_group_work);
}

void set_group(StepContext& step, const Component& component, ContactGroup& group) {
    SolverBodies& records = step.scratch.solver.hot;
    const std::vector<int> order = find_order(step.world, component);
    std::vector<int> position(order.size());
    std::vector<SolverBody*> bodies;
    for (std::size_t k = 0; k < order.size(); k++) {
        position[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
        bodies.push_back(&records[component.members[static_cast<std::size_t>(order[k])].hot]);
    }
    // In a stack the load of a contact is all that is higher than its lower body.
    std::vector<double> load(order.size() + 1, 0);
    for (std::size_t k = order.size(); k-- > 0;)
        load[k] = load[k + 1] + 1 / double{records[component.members[k].hot].inverse_mass};
    std::vector<ManifoldOfGroup> manifolds;
    for (std::size_t own = 0; own < component.members.size(); own++) {
        const std::uint32_t hot = component.members[own].hot;
        for_each_lane(step.world, hot, [&](const Contact& c, const ContactLaneRef& at) {
            if (first_body(at) != hot) return;  // seen from the other body
            ManifoldOfGroup manifold{.lane_ref = at, .a = position[own], .load = load[own]};
            const PairKind kind = pair_kind_of(c.colour);
            if (kind == PairKind::dynamic) {
                const auto other = static_cast<std::size_t>(component.place[second_body(at)]);
                manifold.b = position[other];
                manifold.load = load[std::min(own, other) + 1];
            }
            if (kind == PairKind::kinematic) manifold.mover = &records[second_body(at)];
            ASSERT(manifold.a >= 0 && manifold.a != manifold.b);
            manifolds.push_back(manifold);
        });
    }
    group.set(std::move(bodies), std::move(manifolds), max_work_of(step, component.members.size()));
}

}  // namespace

void find_contact_groups(StepContext& step, std::span<const std::uint32_t> bodies,
                         ContactGroups& groups) {
    WorldState& world = step.world;
    const Vec3 up = -world.def.gravity;
    std::vector<int> place(step.scratch.solver.hot.size(), -1);
    std::vector<Member> members;
    for (const std::uint32_t hot : bodies) {
        place[hot] = static_cast<int>(members.size());
        members.push_back({hot, -1, dot(up, world.bodies.awake[hot - 1].center)});
    }
    const auto count = static_cast<std::size_t>(find_components(world, members, place));
    // From the lowest to the highest.
    std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
        if (a.component != b.component) return a.component < b.component;
        return a.height != b.height ? a.height < b.height : a.hot < b.hot;
    });
    if (groups.all.size() < count) groups.all.resize(count);
    groups.used = count;
    groups.lowest.resize(count);
    groups.passes = groups.unsolved = 0;
    std::size_t begin = 0;
    for (std::size_t k = 0; k < count; k++) {
        std::size_t end = begin;
        while (end < members.size() && members[end].component == static_cast<int>(k)) {
            place[members[end].hot] = static_cast<int>(end - begin);
            end++;
        }
        ASSERT(end > begin);
        groups.lowest[k] = members[begin].hot;
        set_group(step, {std::span(members).subspan(begin, end - begin), place}, groups.all[k]);
        begin = end;
    }
}

}  // namespace jostle::physics
