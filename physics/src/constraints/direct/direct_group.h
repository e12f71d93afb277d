// SPDX-License-Identifier: MIT
//
// A group of bodies connected by joints and without contacts. A direct factorisation solves all
// joints simultaneously; at the end of each step they hold to rounding or to the tolerance.
//
// Three kinds of steps, all of second order in h and exact in angular momentum:
//   RATTLE (H. C. Andersen, 1983; E. Hairer, Ch. Lubich, G. Wanner, "Geometric numerical
//     integration", VII.1): symplectic; used while the fastest oscillation that the joint forces
//     can cause advances by at most 0.7 rad in h;
//   five RATTLE steps composed to fourth order (M. Suzuki, 1990), if nothing is damped or limited;
//   energy-momentum (J. C. Simo, K. K. Wong, 1991; O. Gonzalez, 1996): bounded for any stiffness.
// A step that does not converge, or that changes the energy (energy_guard.cpp), is taken in the
// next of these ways and then halved. A step that cannot be halved further is solved for velocities
// alone, which cannot fail.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "physics/src/constraints/direct/ball_tree.h"
#include "physics/src/constraints/direct/direct_body.h"
#include "physics/src/constraints/direct/direct_joint.h"
#include "physics/src/constraints/direct/joint_net.h"
#include "physics/src/constraints/direct/joint_system_blocks.h"

namespace jostle::physics {

// External forces on the bodies as a function of position and time.
class ExternalForces {
public:
    virtual ~ExternalForces() = default;
    // Writes the force and torque of each body: means over h from `from` seconds after the start of
    // the step, at the body's predicted position `lookahead` seconds after its current state.
    virtual void push(std::vector<DirectBody>& bodies, double from, double h, double lookahead) = 0;
};

class DirectGroup {
public:
    std::vector<DirectBody> bodies;
    std::vector<DirectJoint> joints;
    ExternalForces* outside = nullptr;  // if null, the forces of the bodies are constant
    // Takes no shorter steps of its own accord, which could be those of twice as many sub-steps:
    // for estimating their error.
    bool is_trial = false;
    // Takes half of the sub-steps, but at least four, if it is large and its steps are not
    // composed: its errors are of second order and far smaller than those of contacts. Takes a
    // quarter, but at least two, while the bodies of a group of 64 joints turn slowly.
    bool may_take_fewer_steps = false;

    // Counters since prepare(), for the profile and for tests.
    struct Count {
        int compositions = 0, rattle_steps = 0, energy_steps = 0, halvings = 0, last_resorts = 0;
        int factors = 0, solves = 0, skipped_rows = 0;
    };

    // Call after bodies and joints are set. Analyses their pattern unless it is unchanged. Returns
    // false, and the group is then unusable, if a factorisation would take more than `max_work`
    // multiplications.
    bool prepare(std::int64_t max_work = std::numeric_limits<std::int64_t>::max());
    // Advances by dt seconds in about `substeps` sub-steps.
    void advance(double dt, int substeps);
    const Count& count() const { return count_; }

    struct HoldTolerance {
        double gap, angle;  // m, rad: smaller errors need no change
        double left;        // m: largest error that a change may leave
    };
    // Changes p and l so that the bodies, moving and turning straight on for h, end where the
    // joints hold and no limit is exceeded. Returns false if nothing is changed. Uses the current
    // inverse inertia, which need not be along the axes. Springs and motors must be absent.
    bool hold_joints(double h, const HoldTolerance& tolerance);
    // The largest error at the current state, m: rotations and angles beyond limits are scaled with
    // the length of the group.
    double joint_error();

private:
    struct SavedBody {
        Vec3 x, p, l;
        Quat q;
    };
    struct SavedJoint {
        Vec3 force_sum, torque_sum;
        double force[DirectJoint::max_rows];
        double travels[2] = {};  // of the ends of a gear; parameter of a curve
    };
    struct SavedFreeAxis {
        int at_limit, actuation;
    };
    struct Saved {
        std::vector<SavedBody> bodies;
        std::vector<SavedJoint> joints;
        std::vector<SavedFreeAxis> free_axes;
    };

    // A row of a joint as it acts on one body.
    struct RowPart {
        Vec3 linear, angular;
    };

    // ---- direct_pattern.cpp ----
    void list_what_acts();
    bool find_pattern(std::int64_t max_work);
    void assemble(double linear, const Mat3 DirectBody::*response);
    RowPart row_part(const DirectJoint& joint, int row, int body) const;
    void assemble_gears(const JointSystemBlock& block, double linear,
                        const Mat3 DirectBody::*response);
    void assemble_hub_block(const DirectJoint& joint, const JointHubBlock& coupling,
                            double* block) const;
    void assemble_hubs(double linear, const Mat3 DirectBody::*response);
    void solve();  // right_side_ in, unknowns out
    void regularize(double compliance);
    double min_response(const DirectJoint& joint) const;
    void drop_locked();
    void soften(double h);  // spring rows in the energy-momentum step or at velocity level

    // ---- direct_group.cpp ----
    void step(double h, int depth);
    int most_parts() const;  // RATTLE steps in place of one step
    bool is_ball_tree() const;
    bool step_ball_tree(double h);
    void store_ball_tree();
    int parts_of(double dt, int substeps);
    bool compose(double h);
    bool compose_parts(double h);
    double fastest_turn() const;  // rad/s
    double tolerance(double h) const;
    void save(int depth);
    void restore(int depth);
    void resort_to_velocities(double h);

    // ---- energy_guard.cpp ----
    struct EnergyBooks {
        double kinetic = 0, total = 0;  // J; total: with the potential of the external forces
        double twist = 0;               // W: half of the power of the external torques
        bool closed = true;             // no other body or field does work
        bool exact = false;             // nothing takes energy on purpose
    };
    EnergyBooks open_books() const;
    struct EnergyBounds {
        double gain, loss;  // relative to the kinetic energy
    };
    // Whether a step of h seconds since `before` kept the energy within bounds.
    bool keeps_energy(const EnergyBooks& before, double h, EnergyBounds bounds) const;
    void remove_gain(const EnergyBooks& before, double h);
    double work_of_axes() const;
    double work_of_errors(double h) const;

    // ---- common to all steps: direct_system.cpp ----
    // Forces, springs, actuation between its steps, and damping, for half a step of h.
    void kick(double h, bool second);
    void damp(double time);
    void write_all_vectors();
    void factor_here();  // at the current state, unless already factored
    void push_gear(const DirectJoint& joint, double impulse);
    void record_gear(DirectJoint& joint, double impulse);
    void push(const DirectJoint& joint, const double* impulse);
    void act(DirectJoint& joint, const double* impulse);
    void record(DirectJoint& joint, const double* impulse);
    double measure_all(double h);
    double error_of_holding() const;
    bool set_targets(double h);  // true if part of the error is left for later steps
    void commit();
    // Projects velocities onto the joint constraints. `bias`: error correction rate, 1/s. If
    // `save_forces`, the multipliers divided by h become the joint forces.
    void project_velocities(double h, double bias, bool save_forces = true);

    // ---- direct_bounds.cpp ----
    void apply_impulse(DirectJoint& joint, const FreeAxis& free_axis, double impulse);
    void set_springs();
    void damp_springs();
    void soften_springs(double h);
    void set_row(DirectJoint& joint, int row);
    void set_bounds(double h);
    bool enforce_bounds(DirectJoint& joint, const double* value, double scale, double time,
                        bool at_velocities = false);
    bool reach_limits(double h, double time);
    bool is_overrun_or_hit(std::uint64_t limits, double tolerance) const;
    std::uint64_t active_limits() const;
    bool meets_bend(double h) const;

    // ---- hold_joints.cpp ----
    bool exceeds_limits(double tolerance) const;
    void release_all();

    // ---- one file each ----
    bool step_rattle(double h, double tolerance);
    void drift_all(double h);
    bool solve_positions(double h, double tolerance);
    bool step_energy(double h, double tolerance);
    void begin_energy_step(double h);
    void add_known_pushes(double h);
    void stiffen_gear(const DirectJoint& joint, double force);
    void add_gear_impulse(const DirectJoint& joint, double linear, double angular);
    double residual_of(double h, bool stiffness_too);
    void correct(double h, bool again);
    bool solve_energy_positions(double h, double tolerance);
    double stiffest();  // rad/s: upper bound of the oscillation rates

    // Energy changes that count as a failure. Whips lose what the energy-momentum step does not
    // resolve.
    static constexpr EnergyBounds composed_bounds{1e-4, 1e-4}, rattle_bounds{0.01, 0.01},
        energy_step_bounds{1e-3, 1e300};
    // Compliance of a dependent row relative to its own response. Loops often have dependent rows;
    // the compliance selects the smallest of their possible forces. Newton's method removes its
    // error. The mean vectors of the energy-momentum step hide the dependence to second order in h.
    static constexpr double loop_compliance = 1e-7, mean_loop_compliance = 3e-4;
    // In the velocity fallback, which takes several rounds instead.
    static constexpr double proximal = 1e-4;
    static constexpr int proximal_rounds = 3;
    // Joints of a group whose tolerances are those of contacts: it takes the steps of ball trees,
    // and few of them while it turns slowly. Smaller groups are exact.
    static constexpr std::size_t min_coarse_joints = 64;
    // Maximum number of retries of a step after a limit or a motor maximum was reached.
    static constexpr int bound_rounds = 4;

    BallTree balls_;  // takes the steps of a ball tree, and holds its state while it does
    BlockLdl matrix_;
    std::vector<JointSystemBlock> system_blocks_,
        gear_blocks_;  // gear_blocks_: one of the two joints is a gear
    JointHubs hubs_;
    std::vector<int> pattern_;  // bodies and rows of each joint for which the pattern is valid
    std::vector<double> right_side_;    // indexed by the matrix's rows
    std::vector<Vec3> previous_guess_;  // momenta
    std::vector<Saved> saved_;          // indexed by depth
    bool factored_ = false;
    // Features of the group in addition to rigid joints.
    bool smooth_ = true;   // no damping, limits or actuation
    bool damped_ = false;  // bodies or springs have damping
    bool sprung_ = false;
    bool damped_springs_ = false;
    bool actuated_ = false;   // by motors or friction
    bool limited_ = false;    // some free axes have limits
    bool bounded_ = false;    // limits, actuation or dampers change with the impulses
    bool locked_ = false;     // bodies have locked axes
    bool ball_tree_ = false;  // the group has ball joints only, and no loop
    bool straight_ = false;   // bodies keep their spin instead of their angular momentum
    bool energy_ = false;     // the current step is an energy-momentum step
    double spring_rate_ = 0;  // rad/s: upper bound of the spring rates
    double step_ = 0;         // s: length of the current step, for springs
    double time_ = 0;         // s since the start of advance()
    int halvings_ = 0;        // initial number of halvings of a step
    bool resorting_ = false;  // velocity fallback for the rest of the advance
    bool looped_ = false;     // some joints close loops
    bool curved_ = false;     // some joints hold a body on a curve
    bool net_ = false;        // so many do that it is nearly singular as soon as it bends
    double reach_ = 0;        // m: characteristic length of the group
    Count count_;
};

}  // namespace jostle::physics
