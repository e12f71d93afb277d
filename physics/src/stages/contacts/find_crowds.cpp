// SPDX-License-Identifier: MIT
#include "stages/contacts/find_crowds.h"

#include <utility>
#include <vector>

#include "foundation/check.h"
#include "foundation/tuning.h"
#include "stages/step_scratch.h"
#include "state/contact_constraints.h"

namespace jostle::physics {
namespace {

constexpr std::uint32_t alone = 0xffffffff;

// Of two bodies it is plain who meets whom first.
constexpr int least_crowd = 3;

bool is_member(const BodyCold& cold) {
    return cold.type == BodyType::dynamic && cold.set == BodySet::awake && !cold.asleep_in_place;
}

// The crowd that one has become part of.
std::uint32_t find(std::vector<Crowd>& crowds, std::uint32_t crowd) {
    while (crowds[crowd].part_of != crowd) {
        crowds[crowd].part_of = crowds[crowds[crowd].part_of].part_of;
        crowd = crowds[crowd].part_of;
    }
    return crowd;
}

std::uint32_t crowd_with(ContactScratch& scratch, const BodyCold& cold) {
    std::uint32_t& crowd = scratch.crowd_of[cold.at];
    if (crowd == alone) {
        crowd = static_cast<std::uint32_t>(scratch.crowds.size());
        scratch.crowds.push_back(
            {.part_of = crowd,
             .bodies = 1,
             .walled = scratch.crowd_noise > tuning::restitution_speed &&
                       scratch.had_contacts[cold.at] != 0});
    }
    return find(scratch.crowds, crowd);
}

void join(ContactScratch& scratch, const BodyCold& a, const BodyCold& b, double closing) {
    if (!is_member(a) && !is_member(b)) return;
    std::uint32_t crowd = crowd_with(scratch, is_member(a) ? a : b);
    const bool both = is_member(a) && is_member(b);
    if (both) {
        std::uint32_t other = crowd_with(scratch, b);
        if (other < crowd) std::swap(crowd, other);
        if (other != crowd) {
            Crowd &into = scratch.crowds[crowd], &gone = scratch.crowds[other];
            gone.part_of = crowd;
            into.bodies += gone.bodies;
            into.walled |= gone.walled;
            into.fastest = maximum(into.fastest, gone.fastest);
        }
    }
    scratch.crowds[crowd].walled |= !both;
    scratch.crowds[crowd].fastest = maximum(scratch.crowds[crowd].fastest, closing);
}

// What is so near that it may be struck within the step belongs to the crowd, wherever it goes now.
void join_neighbours(const StepContext& step, ContactScratch& scratch) {
    const WorldState& world = step.world;
    struct Member {
        std::uint32_t awake;
        double way;  // m: how far the fastest of its crowd come in the step
    };
    std::vector<Member> members;  // before anybody else joins: the order says nothing
    for (std::uint32_t awake = 0; awake < scratch.crowd_of.size(); awake++)
        if (const std::uint32_t crowd = scratch.crowd_of[awake]; crowd != alone)
            members.push_back(
                {awake, scratch.crowds[find(scratch.crowds, crowd)].fastest * step.dt});
    for (const auto& [awake, way] : members) {
        const std::uint32_t body = world.bodies.awake[awake].body;
        const BodyCold& cold = world.bodies.cold[body];
        for_each_contact(world.contacts, cold, [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            const std::uint32_t other = c.body_a == body ? c.body_b : c.body_a;
            const BodyCold& cold_other = world.bodies.cold[other];
            if (c.parent != none || !is_member(cold_other)) return;
            const double reach = (cold.inner_radius + cold_other.inner_radius) + way;
            const Vec3 apart = warm_of(world, other).center - world.bodies.awake[awake].center;
            if (length_squared(apart) < reach * reach) join(scratch, cold, cold_other, 0);
        });
    }
}

}  // namespace

void find_crowds(StepContext& step) {
    const WorldState& world = step.world;
    ContactScratch& scratch = step.scratch.contacts;
    scratch.crowds.clear();
    scratch.crowd_of.clear();
    bool any = false;
    for (const ContactCheck& check : scratch.checks) any |= check.bounces;
    if (!any) return;
    const double falls = 2 * length(world.def.gravity) * step.dt;
    scratch.crowd_noise = maximum(tuning::restitution_speed, falls);
    scratch.crowd_of.assign(world.bodies.awake.size(), alone);
    for (const ContactCheck& check : scratch.checks) {
        if (!check.bounces) continue;
        const Contact& c = world.contacts.contacts[check.contact];
        join(scratch, world.bodies.cold[c.body_a], world.bodies.cold[c.body_b], check.closing);
    }
    join_neighbours(step, scratch);
    for (std::uint32_t& crowd : scratch.crowd_of)
        if (crowd != alone) crowd = find(scratch.crowds, crowd);
}

bool bounces_in_crowd(const ContactScratch& scratch, const BodyCold& a, const BodyCold& b,
                      double restitution) {
    if (scratch.crowds.empty() || restitution >= 1) return false;
    for (const BodyCold* cold : {&a, &b}) {
        if (!is_member(*cold)) continue;
        if (cold->at >= scratch.crowd_of.size() || scratch.crowd_of[cold->at] == alone) continue;
        const Crowd& crowd = scratch.crowds[scratch.crowd_of[cold->at]];
        if (crowd.bodies < least_crowd || !crowd.walled) continue;
        double left = crowd.fastest;
        for (int k = 0; k < 2 * crowd.bodies; k++) {
            left *= restitution;
            if (left < scratch.crowd_noise) return true;
        }
    }
    return false;
}

}  // namespace jostle::physics
