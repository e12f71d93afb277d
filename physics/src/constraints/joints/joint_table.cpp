// SPDX-License-Identifier: MIT
#include "constraints/joints/joint_table.h"

#include "jostle/physics/tuning.h"

namespace jostle::physics {
namespace {

template <class Kind>
struct Functions;
template <>
struct Functions<BallJoint> {
    static constexpr auto warm_start = warm_start_ball;
    static constexpr auto solve = solve_ball;
    static constexpr auto load = load_of_ball;
};
template <>
struct Functions<HingeJoint> {
    static constexpr auto warm_start = warm_start_hinge;
    static constexpr auto solve = solve_hinge;
    static constexpr auto load = load_of_hinge;
};
template <>
struct Functions<ConeTwistJoint> {
    static constexpr auto warm_start = warm_start_cone_twist;
    static constexpr auto solve = solve_cone_twist;
    static constexpr auto load = load_of_cone_twist;
};
template <>
struct Functions<FixedJoint> {
    static constexpr auto warm_start = warm_start_fixed;
    static constexpr auto solve = solve_fixed;
    static constexpr auto load = load_of_fixed;
};
template <>
struct Functions<DistanceJoint> {
    static constexpr auto warm_start = warm_start_distance;
    static constexpr auto solve = solve_distance;
    static constexpr auto load = load_of_distance;
};

}  // namespace

namespace {

// The joint's impulses in world axes while somebody works on them.
class InWorld {
public:
    InWorld(const JointPair& pair, Joint& joint) : joint_(joint), turn_(pair.carrier) {
        for (Vec3* v : {&joint.point, &joint.turn, &joint.drive}) *v = rotate(turn_, *v);
    }
    ~InWorld() {
        for (Vec3* v : {&joint_.point, &joint_.turn, &joint_.drive}) *v = inverse_rotate(turn_, *v);
    }
    InWorld(const InWorld&) = delete;
    InWorld& operator=(const InWorld&) = delete;

private:
    Joint& joint_;
    Quat turn_;
};

}  // namespace

void warm_start(JointPair& pair, Joint& joint) {
    const InWorld scope(pair, joint);
    std::visit(
        [&](const auto& kind) {
            Functions<std::decay_t<decltype(kind)>>::warm_start(pair, kind, joint);
        },
        joint.kind);
}

void solve(JointPair& pair, const JointStep& step, Joint& joint) {
    const InWorld scope(pair, joint);
    std::visit(
        [&](const auto& kind) {
            Functions<std::decay_t<decltype(kind)>>::solve(pair, step, kind, joint);
        },
        joint.kind);
}

JointLoad load_of(const JointPair& pair, const Joint& kept) {
    Joint joint = kept;
    const InWorld scope(pair, joint);
    return std::visit(
        [&](const auto& kind) {
            return Functions<std::decay_t<decltype(kind)>>::load(pair, kind, joint);
        },
        joint.kind);
}

JointStep joint_step(double h, bool relax) {
    return {h, 1 / h, soft(tuning::joint_stiffness / h, tuning::joint_damping_ratio, h), relax};
}

const char* kind_name(const JointKind& kind) {
    static constexpr const char* names[joint_kinds] = {"ball", "hinge", "cone-twist", "fixed",
                                                       "distance"};
    return names[kind.index()];
}

}  // namespace jostle::physics
