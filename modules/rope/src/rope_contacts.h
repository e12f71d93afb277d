// SPDX-License-Identifier: MIT
//
// Contacts of ropes with each other and with themselves: links are capsules.
//
// The impulse of a contact acts in two ways. That of the last sub-step is a force in the next one,
// which the strands solve with their tensions. What is then still wrong with the relative velocity
// is corrected at the nodes, and the correction joins the impulse: sequential impulses with warm
// starting (E. Catto, "Iterative dynamics with temporal coherence", 2005), of which each iteration
// of a resting contact is a sub-step.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/vec3.h"

namespace jostle::modules::rope_detail {

struct Rope;

class RopeContacts {
public:
    // Before a step: the links that may touch each other. `obstacles` are ropes at rest.
    void begin_step(std::span<Rope* const> ropes, std::span<Rope* const> obstacles, double dt,
                    physics::Vec3 gravity);
    bool empty() const { return candidates_.empty(); }
    // No contacts in the rest of the step.
    void forget() { candidates_.clear(), contacts_.clear(); }
    // Before the strands of a sub-step are solved: adds the impulses of the last one as forces.
    void push_as_before(double h);
    // After that: corrects the velocities and positions of the nodes, and saves the contacts.
    void resolve(double h);

private:
    // A link of a rope of this step.
    struct Link {
        std::uint32_t rope = 0, link = 0;
    };
    struct Candidate {
        Link a, b;  // the rope of a moves and saves the contact
    };
    struct Contact {
        Link a, b;
        double at_a = 0, at_b = 0;  // along the links
        physics::Vec3 normal = {};  // unit, from b to a
        double gap = 0;             // m, at the start of the sub-step; negative: overlap
        double friction = 0;        // coefficient
        double mass = 0;            // kg, effective, of the nodes alone
        double impulse = 0;         // N s
        physics::Vec3 slip = {};    // N s, of friction
    };

    void find_candidates(double reach);
    bool may_touch(const Candidate& pair) const;
    Candidate ordered(Link a, Link b) const;
    void find_contacts();
    bool place(Contact& contact) const;
    double inverse_mass(Link link, std::uint32_t end) const;
    physics::Vec3 velocity(const Contact& contact) const;
    void kick(const Contact& contact, physics::Vec3 impulse, double h);
    void kick(Link link, double at, physics::Vec3 impulse, double h);
    void save();

    std::vector<Rope*> ropes_;  // those that move, then the obstacles
    std::size_t moving_ = 0;
    std::vector<Candidate> candidates_;
    std::vector<Contact> contacts_;
};

}  // namespace jostle::modules::rope_detail
