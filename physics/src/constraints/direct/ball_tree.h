// SPDX-License-Identifier: MIT
//
// The steps of a group (direct_group.h) in which every joint holds a point and nothing else, as in
// chains and ropes, and no joint closes a loop. They solve the same equations as rattle_step.cpp
// and energy_step.cpp, in records of less than half the size and with half the passes over them.
// A step that fails leaves its start, and the group takes it in its own ways.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/constraints/direct/direct_body.h"
#include "physics/src/constraints/direct/direct_joint.h"
#include "physics/src/constraints/direct/joint_system_blocks.h"
#include "physics/src/constraints/direct/symmetric_mat3.h"

namespace jostle::physics {

class BallTree {
public:
    // The matrix of the group: its pattern, and memory for its values and unknowns.
    struct System {
        BlockLdl& matrix;
        std::span<const JointSystemBlock> blocks;
        std::span<double> unknowns;

        Vec3 get(int row) const {
            const double* const at = &unknowns[as_index(row)];
            return {at[0], at[1], at[2]};
        }
        void set(int row, Vec3 to) {
            double* const at = &unknowns[as_index(row)];
            at[0] = to.x, at[1] = to.y, at[2] = to.z;
        }
    };
    struct Limits {
        double reach;        // m: characteristic length of the group
        double swing;        // rad that the fastest oscillation advances in a RATTLE step
        int parts;           // largest number of RATTLE steps in place of one step
        bool keeps_energy;   // nothing takes energy on purpose
        double energy;       // relative change of the energy in RATTLE steps
        double energy_gain;  // in an energy-momentum step
    };
    struct Count {
        int rattle_steps = 0, energy_steps = 0, factors = 0, solves = 0;
    };

    // Bodies that cannot be pushed must be at rest.
    void load(std::span<const DirectBody> bodies, std::span<const DirectJoint> joints,
              const BlockLdl& matrix);
    // Writes the state of the bodies, and forces and impulses of the joints.
    void store(std::span<DirectBody> bodies, std::span<DirectJoint> joints);
    bool is_loaded() const { return loaded_; }

    // Advances by h seconds. Returns false, and leaves the state unchanged, if the step has to be
    // taken in another way.
    bool step(double h, const Limits& limits, System system);
    // Since the last call.
    Count take_count();

private:
    // An error below this multiple of the tolerance is accepted if it does not shrink further.
    static constexpr double accepted_errors = 30;

    struct Body {
        // Constant.
        double mass, inverse_mass;  // zero for bodies that joints cannot push
        Vec3 moments, inverse_moments, force, torque;
        double linear_damping, angular_damping;
        // State.
        Vec3 x, p, l;
        Quat q;
        SymmetricMat3 inverse_inertia;
        Vec3 v, w;  // at the last commit, or at the start of an energy-momentum step
        // The end of the current attempt.
        Vec3 x1;
        Quat q1;
        Mat3 axes1;
        // Of joint forces against rotation of the body, N m / rad; over an energy-momentum step,
        // N m s / rad.
        SymmetricMat3 stiffness;
        // Of an energy-momentum step (direct_body.h).
        Vec3 mean_w, sum, twist, residual, spin_correction;
        SymmetricMat3 inertia, response;
    };
    struct Joint {
        int a, b, row;          // row: of its first unknown
        Vec3 arm_a, arm_b;      // constant, principal axes
        Vec3 at_a, at_b;        // the arms in the world
        Vec3 lever_a, lever_b;  // to the middle of the gap
        Vec3 end_a, end_b;      // the arms at the end of the attempt
        Vec3 apart;             // at that end
        Vec3 impulse, force, force_sum;
    };
    struct Saved {
        Vec3 x, p, l;
        Quat q;
    };
    struct SavedJoint {
        Vec3 force, force_sum;
    };
    struct Books {
        double kinetic = 0, total = 0;  // J
        double power = 0;               // W: half of the power of the torques
    };

    void save();
    void restore();

    // ---- the state ----
    void measure_state();
    void measure_bodies();
    void add_stiffness(const Joint& joint, Vec3 force, Vec3 arm_a, Vec3 arm_b);
    bool keeps_energy(const Books& before, double h, double tolerance, double gain,
                      double loss) const;

    // ---- common to both kinds of steps ----
    void assemble(System& system, double linear, SymmetricMat3 Body::*response);
    void factor_here(System& system);  // at the current state, unless already factored
    void solve(System& system);
    void damp(Body& body, double time);
    void push(const Joint& joint, Vec3 impulse);
    double measure(Joint& joint, double largest);
    void commit(Body& body);
    // The joint forces: the impulses of the step, or those of the projection, over time.
    enum class Forces : std::uint8_t { of_step, of_projection };
    void project_velocities(System& system, double h, Forces forces, bool last);

    // ---- RATTLE ----
    bool step_rattle(System& system, double h, double tolerance, bool last);
    bool solve_positions(System& system, double h, double tolerance);
    double drift(double h);

    // ---- ball_tree_energy.cpp ----
    bool step_energy(System& system, double h, double tolerance, double reach);
    void begin_energy_step(double h);
    double residual_of(double h, bool stiffness_too);
    void correct(System& system, double h, bool again);

    std::vector<Body> bodies_;
    std::vector<Joint> joints_;
    std::vector<Saved> saved_;
    std::vector<SavedJoint> saved_joints_;
    Books books_;
    double stiffest_ = 0;   // rad/s: upper bound of the oscillation rates at the current state
    double gap_ = 0;        // m, at the current state
    double start_gap_ = 0;  // m, at the start of the step
    // Of all bodies: sum of force^2 / mass, of the weights, and of the masses.
    double push_ = 0, weight_ = 0, mass_ = 0;
    // Most bodies have the same damping.
    double damping_ = 0, damping_time_ = 0, damping_factor_ = 1;
    bool loaded_ = false, measured_ = false, factored_ = false;
    bool damped_ = false;  // some body is
    Count count_;
};

}  // namespace jostle::physics
