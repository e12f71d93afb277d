// SPDX-License-Identifier: MIT
//
// Contacts of ropes with each other and with themselves: links are capsules.
//
// Each contact is a spring with the impulse of the last sub-step as its preload (an augmented
// Lagrangian), so it needs no more stiffness than m / h^2: resting contacts find their impulse in a
// few sub-steps. Friction likewise. The forces are part of the iterations of the strands, equal and
// opposite at the current iterate. Their derivative couples nodes that are far apart along a
// strand; twice its blocks of each link bounds it (|a - b|^2 <= 2 |a|^2 + 2 |b|^2), so the
// iterations of the strands remain those of a band matrix and converge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/vec3.h"
#include "modules/rope/src/strand.h"

namespace jostle::modules::rope_detail {

struct Rope;

class RopeContacts final : public LinkForces {
public:
    // Before a step: the links that may touch each other. `obstacles` are ropes at rest.
    void begin_step(std::span<Rope* const> ropes, std::span<Rope* const> obstacles, double dt,
                    physics::Vec3 gravity);
    bool empty() const { return candidates_.empty(); }
    // No contacts in the rest of the step.
    void forget() { candidates_.clear(), contacts_.clear(); }
    // Before the strands of a sub-step are solved.
    void begin_substep(double h);
    void add_to(const Strand& strand, StrandScratch& rows) const override;
    // After that: saves the contacts.
    void end_substep();

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
        double gap = 0;            // m, at the start of the sub-step; negative: overlap
        physics::Vec3 apart = {};  // m, from the point of b to that of a, likewise
        double wanted = 0;         // m, least gap at its end
        double friction = 0;       // coefficient
        double stiffness = 0;      // kg, of the spring times h^2
        double preload = 0;        // kg m, along the normal, times h^2
        physics::Vec3 drag = {};   // kg m, of friction, times h^2
    };

    void find_candidates(double reach);
    bool may_touch(const Candidate& pair) const;
    Candidate ordered(Link a, Link b) const;
    void find_contacts();
    bool place(Contact& contact) const;
    double node_response(Link link, std::uint32_t end) const;
    physics::Vec3 apart(const Contact& contact) const;
    // On a, times h^2, at the current positions; `stiffness` bounds its derivative.
    physics::Vec3 force(const Contact& contact, Symmetric3& stiffness, double& normal,
                        physics::Vec3& drag) const;

    double h_ = 0;
    std::vector<Rope*> ropes_;  // those that move, then the obstacles
    std::size_t moving_ = 0;
    std::vector<Candidate> candidates_;
    std::vector<Contact> contacts_;
};

}  // namespace jostle::modules::rope_detail
