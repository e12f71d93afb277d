// SPDX-License-Identifier: MIT
//
// Direct solver for the contacts of a small group of bodies. Sweeps over the contacts pass an
// impulse on by about the ratio of the masses, so a heavy body sinks into the light ones that carry
// it. Here all contacts of a group are solved together (interior_point.h), with the same rows as
// the sweeps: points, friction at the centre of the manifold, torsion, rolling resistance.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/constraint_graph/solver_body.h"
#include "physics/src/constraints/contact_group/group_problem.h"
#include "physics/src/constraints/contact_group/interior_point.h"
#include "physics/src/constraints/contact_group/skyline_cholesky.h"
#include "physics/src/constraints/contact_settings.h"

namespace jostle::physics {

struct ManifoldOfGroup {
    ContactLaneRef lane_ref;
    int a = 0, b = -1;                  // bodies of the group; b: -1 if contacts do not move it
    const SolverBody* mover = nullptr;  // the second body if it is kinematic
    double load = 0;                    // kg, estimate of what lies on the contact
};

// Not thread-safe; different groups are independent.
class ContactGroup {
public:
    // `bodies`: in an order in which bodies that touch are close to each other; distinct, and none
    // of them immovable. The velocities of the bodies are those without contacts. `max_work`: about
    // the products of two 6 x 6 blocks after which no solution is looked for, either.
    void set(std::vector<SolverBody*> bodies, std::vector<ManifoldOfGroup> contacts,
             std::int64_t max_work);

    // Before the bodies move: gaps close at most, and overlaps are pushed out. Returns whether a
    // solution was found. Otherwise the bodies have the velocities of the impulses of the pass
    // before, from which sweeps can start; of no impulses if those would add energy. After
    // max_unsolved passes without a solution none is looked for until the next set().
    bool solve(const ContactSettings& settings) { return run(settings, false); }
    // The same after they moved, without push-out.
    bool relax(const ContactSettings& settings) { return run(settings, true); }
    // Whether a pass since set() found no solution.
    bool missed() const { return missed_; }
    // Products of blocks since set().
    std::int64_t work() const { return work_; }
    // Writes the last solution again, after a pass that changed it. Nothing if there is none.
    void store() const;

private:
    // Square root of the inverse mass of a body.
    struct RootMass {
        double linear[3];
        double angular[9];  // C with C C^T = the inverse inertia, row by row
    };

    static constexpr int max_unsolved = 2;

    bool run(const ContactSettings& settings, bool relaxing);
    bool find_solution(double tolerance);
    void load_bodies();
    void load_manifold(const ContactSettings& settings, const ManifoldOfGroup& manifold,
                       bool relaxing);
    GroupRow& add_row(const ManifoldOfGroup& manifold, Vec3 direction, Vec3 turn_a, Vec3 turn_b);
    void add_disc(int first, int size, double factor);
    bool start_adds_energy(double usual_speed);
    void store_velocities() const;
    void store_impulses() const;

    std::vector<SolverBody*> bodies_;
    std::vector<ManifoldOfGroup> manifolds_;
    SkylineCholesky matrix_;
    GroupProblem problem_;
    InteriorPoint solver_;
    std::vector<RootMass> roots_;
    std::vector<double> free_;  // six per body: velocities without contacts
    std::vector<double> y_, velocity_;
    std::vector<double> start_;     // impulses before the pass
    std::vector<double> impulses_;  // of all rows; empty if the last pass found no solution
    int unsolved_ = 0;              // passes since set()
    bool missed_ = false;
    std::int64_t work_ = 0, max_work_ = 0;
};

}  // namespace jostle::physics
