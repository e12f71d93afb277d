// SPDX-License-Identifier: MIT
//
// Contacts of ropes with each other and with themselves: links are capsules.
//
// A force on a node moves the whole strand, so contacts are solved with the compliance of the
// strands and not with the masses of nodes: in each Newton iteration of the strands, the blocks of
// the inverse of their matrices between touching nodes couple the contacts of all of them.
// Projected Gauss-Seidel finds their forces (G. Daviet et al., "A hybrid iterative solver for
// robustly capturing Coulomb friction in hair dynamics", 2011). A contact keeps two points apart
// along the normal at the start of the sub-step, so that its forces conserve momentum and, without
// friction, angular momentum.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/vec3.h"
#include "modules/rope/src/strand.h"
#include "modules/rope/src/strand_compliance.h"

namespace jostle::modules::rope_detail {

struct Rope;

class RopeContacts final : public StrandCoupling {
public:
    // Before a step: the links that may touch each other. `obstacles` are ropes at rest.
    void begin_step(std::span<Rope* const> ropes, std::span<Rope* const> obstacles, double dt,
                    physics::Vec3 gravity);
    bool empty() const { return candidates_.empty(); }
    // No contacts in the rest of the step.
    void forget() { candidates_.clear(), contacts_.clear(); }
    // Number of parts of h seconds in which links near each other move by less than a radius.
    int parts_of(double h, int least);
    // Before the strands of a sub-step are solved. Returns whether any links are near each other.
    bool begin_substep(double h);
    bool couple(std::span<StrandJob> jobs) override;
    // After that: saves the contacts.
    void end_substep();

private:
    // A link of a rope of this step.
    struct Link {
        std::uint32_t rope = 0, link = 0;
    };
    struct Candidate {
        Link a, b;        // the rope of a moves and saves the contact
        double most = 0;  // m, greatest distance that the contact demands
    };
    // A node on which a contact acts, and its place in the compliance of the strand.
    struct End {
        std::uint32_t rope = 0, node = 0, slot = 0;
        double weight = 0;
    };
    struct Contact {
        Link a, b;
        double at_a = 0, at_b = 0;  // along the links
        physics::Vec3 normal = {};  // unit, from b to a
        double distance = 0;        // m, that it demands
        double gap = 0;             // m, at the start of the sub-step; negative: overlap
        double wanted = 0;          // m, least gap at its end; above the gap: recovers an overlap
        physics::Vec3 apart = {};   // m, from the point of b to that of a, likewise
        double friction = 0;        // coefficient
        bool is_double = false;     // of that of the next link
        physics::Vec3 force = {};   // on a, times h^2, kg m
        // Of the current iteration.
        bool active = false;
        std::array<End, 4> ends = {};
        std::uint32_t ends_count = 0;
        physics::Vec3 moved = {};     // m, without changes of the forces
        physics::Mat3 response = {};  // 1/kg
        physics::Vec3 tangents[2] = {};
        double sticking[3] = {};                // inverse of the response across the normal
        double normal_step = 0, slip_step = 0;  // kg
        physics::Vec3 before = {};              // the force at the start of the iteration
        std::size_t columns[2] = {};
    };
    // Two attachments at the same place.
    struct Meeting {
        Link a, b;  // nodes
        double apart = 0;
    };
    struct StrandResponse {
        std::vector<std::uint32_t> nodes;
        StrandCompliance compliance;
        std::vector<physics::Vec3> moved;  // m, by changes of the forces, per node of `nodes`
    };

    void find_meetings();
    void find_candidates(double reach);
    bool may_touch(const Candidate& pair) const;
    double most_distance(const Candidate& pair) const;
    Candidate ordered(Link a, Link b) const;
    double relative_speed(const Candidate& pair) const;
    void find_contacts();
    bool place(Contact& contact, double most) const;
    bool is_at_next(const Contact& contact) const;
    physics::Vec3 apart(const Contact& contact) const;
    physics::Vec3 displaced(const Contact& contact, std::span<const StrandJob> jobs) const;
    bool limit_recovery(std::span<const StrandJob> jobs);
    void activate(std::span<const StrandJob> jobs);
    void add_response(Contact& contact);
    void solve();
    double update(Contact& contact);
    void apply(Contact& contact, physics::Vec3 change);

    double h_ = 0;
    double speed_ = 0;          // m/s, greatest relative speed of links near each other
    std::vector<Rope*> ropes_;  // those that move, then the obstacles
    std::size_t moving_ = 0;
    std::vector<Meeting> meetings_;
    std::vector<Candidate> candidates_;
    std::vector<Contact> contacts_;
    std::vector<StrandResponse> responses_;  // per rope that moves
    std::vector<physics::Mat3> columns_;
};

}  // namespace jostle::modules::rope_detail
