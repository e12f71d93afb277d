// SPDX-License-Identifier: MIT
//
// Bodies that joints tie together and nothing touches, moved together: all joints are solved at
// once, by a direct factorisation, and hold at the end of each step to rounding or the tolerance.
//
// Three kinds of steps, all of second order in h and exact in angular momentum:
//   RATTLE (H. C. Andersen, 1983; E. Hairer, Ch. Lubich, G. Wanner, "Geometric numerical
//     integration", VII.1): symplectic; while the fastest swing that the joints' forces can cause
//     turns by no more than 0.7 rad in h;
//   five of those put together to fourth order (M. Suzuki, 1990), where nothing is lost or limited;
//   energy-momentum (J. C. Simo, K. K. Wong, 1991; O. Gonzalez, 1996): bounded however stiff.
// A step that does not converge is halved; one that will not be halved further is solved for
// velocities alone, which cannot fail.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "physics/src/constraints/direct/block_ldl.h"
#include "physics/src/constraints/direct/direct_body.h"
#include "physics/src/constraints/direct/direct_joint.h"
#include "physics/src/constraints/direct/joint_system_blocks.h"

namespace jostle::physics {

// What pushes bodies from outside by where and when they are.
class ExternalForces {
public:
    virtual ~ExternalForces() = default;
    // Writes each body's force and torque: means over h from `from` seconds after the step's begin,
    // at where the body is `ahead` seconds later than it says.
    virtual void push(std::vector<DirectBody>& bodies, double from, double h, double lookahead) = 0;
};

class DirectGroup {
public:
    std::vector<DirectBody> bodies;
    std::vector<DirectJoint> joints;
    ExternalForces* outside = nullptr;  // else the bodies' forces are constant

    // What happened since prepare(), for the profile and for tests.
    struct Count {
        int compositions = 0, rattle_steps = 0, energy_steps = 0, halvings = 0, last_resorts = 0;
        int factors = 0, solves = 0, skipped_rows = 0;
    };

    // Once bodies and joints are there: their pattern, unless it is that of before. False, and of
    // no use, if a factor would take more multiplications than `max_work`.
    bool prepare(std::int64_t max_work = std::numeric_limits<std::int64_t>::max());
    // By dt, in about so many sub-steps.
    void advance(double dt, int substeps);
    const Count& count() const { return count_; }

private:
    struct SavedBody {
        Vec3 x, p, l;
        Quat q;
    };
    struct SavedJoint {
        Vec3 force_sum, torque_sum;
        double force[DirectJoint::max_rows];
    };
    struct SavedFreeAxis {
        int at_limit, actuation;
    };
    struct Saved {
        std::vector<SavedBody> bodies;
        std::vector<SavedJoint> joints;
        std::vector<SavedFreeAxis> free_axes;
    };

    // ---- direct_pattern.cpp ----
    void list_what_acts();
    bool find_pattern(std::int64_t max_work);
    void assemble(double linear, const Mat3 DirectBody::*response);
    void regularize();
    double min_response(const DirectJoint& joint) const;
    void drop_locked();
    void soften(double h);  // the rows of springs, in the energy-momentum step or at velocities

    // ---- direct_group.cpp ----
    void step(double h, int depth);
    int parts_of(double dt, int substeps);
    bool compose(double h);
    bool has_burst(double h, const Saved& before);
    double fastest_turn() const;  // rad/s
    double tolerance(double h) const;
    void save(int depth);
    void restore(int depth);
    void resort_to_velocities(double h);

    // ---- what all steps share: direct_system.cpp ----
    // Forces, springs, what grips without holding, and damping, for half a step of h.
    void kick(double h, bool second);
    void damp(double time);
    void write_all_vectors();
    void factor_here();  // at the state, unless it is there
    void push(const DirectJoint& joint, const double* impulse);
    void act(DirectJoint& joint, const double* impulse);
    void record(DirectJoint& joint, const double* impulse);
    double measure_all(double h);
    double error_of_holding() const;
    bool set_targets(double h);  // true if something is left for later steps
    void commit();
    // Velocities to what joints allow. `bias`: 1/s, of errors to take away at once. The multipliers
    // over h are kept as the joints' forces if `save_forces`.
    void project_velocities(double h, double bias, bool save_forces = true);

    // ---- direct_bounds.cpp ----
    void give(DirectJoint& joint, const FreeAxis& free_axis, double impulse);
    void set_springs();
    void damp_springs();
    void soften_springs(double h);
    void set_row(DirectJoint& joint, int row);
    void set_bounds(double h);
    bool enforce_bounds(DirectJoint& joint, const double* value, double scale, double time,
                        bool at_velocities = false);
    bool reach_limits(double h, double time);
    bool is_on_limit() const;

    // ---- one file each ----
    bool step_rattle(double h, double tolerance);
    bool solve_positions(double h, double tolerance);
    bool step_energy(double h, double tolerance);
    void begin_energy_step(double h);
    void add_known_pushes(double h);
    double residual_of(double h, bool stiffness_too);
    void correct(double h, bool again);
    bool solve_energy_positions(double h, double tolerance);
    double stiffest();  // rad/s: no swing is faster

    // Part of a row's own response by which it gives way in a group of dependent rows, and rounds.
    static constexpr double proximal = 1e-4;
    static constexpr int proximal_rounds = 3;
    // How often a step is taken again because a limit or a motor's most was met.
    static constexpr int bound_rounds = 4;

    BlockLdl matrix_;
    std::vector<JointSystemBlock> system_blocks_;
    std::vector<int> pattern_;          // bodies and rows of each joint, of which the pattern is
    std::vector<double> right_side_;    // by the matrix's rows
    std::vector<Vec3> previous_guess_;  // momenta
    std::vector<Saved> saved_;          // by depth
    bool factored_ = false;
    // What there is, beside joints that hold.
    bool smooth_ = true;   // neither damping nor limits nor what grips
    bool damped_ = false;  // bodies or springs are
    bool sprung_ = false;  // ... and what of that is damped:
    bool damped_springs_ = false;
    bool actuated_ = false;    // by motors or friction
    bool limited_ = false;     // some ways are
    bool locked_ = false;      // axes of bodies are
    bool energy_ = false;      // the step under way is an energy-momentum one
    double spring_rate_ = 0;   // rad/s: no spring swings faster
    double step_ = 0;          // s: of the step under way, for springs
    double time_ = 0;          // s since advance() began
    int halvings_ = 0;         // at which a step is begun
    bool resorting_ = false;   // for the rest of the advance
    bool looped_ = false;      // there are more joints than bodies that they push
    bool degenerate_ = false;  // rows of the advance depend on others, all but or altogether
    double reach_ = 0;         // m: a length of the group's
    Count count_;
};

}  // namespace jostle::physics
