// SPDX-License-Identifier: MIT
#include "physics/src/world/joint_checks.h"

#include "physics/src/foundation/messages.h"
#include "physics/src/world/checks.h"

namespace jostle::physics {

std::string JointCheck::path_of(const char* field) const {
    return (parent_ != nullptr ? parent_->path_of(name_) : name_) + "." + field;
}

void JointCheck::number(const char* name, double value, double low, double high) {
    if (!status_.ok() || (value >= low && value <= high)) return;
    status_ = check_range(path_of(name).c_str(), value, low, high);
}

void JointCheck::ordered(const char* lower_name, double lower, const char* upper_name, double upper,
                         double low, double high) {
    number(lower_name, lower, low, high);
    number(upper_name, upper, lower, high);
}

void JointCheck::vector(const char* name, Vec3 value, double limit) {
    if (status_.ok()) status_ = check_vector(path_of(name).c_str(), value, limit);
}

void JointCheck::points(const char* name, const std::vector<Vec3>& points, std::size_t least,
                        std::size_t most, double limit) {
    const std::string path = path_of(name);
    if (status_.ok() && (points.size() < least || points.size() > most))
        status_ = invalid_argument(path + " has " + std::to_string(points.size()) +
                                   " points; it must have " + std::to_string(least) + " to " +
                                   std::to_string(most));
    for (std::size_t k = 0; k < points.size() && status_.ok(); k++) {
        const std::string which = "[" + std::to_string(k) + "]";
        vector((name + which).c_str(), points[k], limit);
        if (status_.ok() && k > 0 && length(points[k] - points[k - 1]) < 1e-6)
            status_ = invalid_argument(path + which +
                                       " coincides with the previous point; remove one of them");
    }
}

void JointCheck::drive(const char* name, const RotationDrive& drive) {
    JointCheck inside(*this, name);
    inside.spring("spring", drive.spring);
    inside.number("max_torque", drive.max_torque, 0, 1e12);
    if (inside.status_.ok() && !check_pose("target", {{}, drive.target}).ok())
        inside.status_ = check_pose(inside.path_of("target").c_str(), {{}, drive.target});
    merge_status(inside);
}

void JointCheck::limit(const char* name, const JointLimit& limit, double low, double high) {
    JointCheck inside(*this, name);
    visit_limit(inside, limit, low, high);
    if (inside.status_.ok() && limit.lower > limit.upper)
        inside.status_ =
            invalid_argument(inside.path_of("lower") + " is above " + inside.path_of("upper") +
                             "; lower must not exceed upper");
    merge_status(inside);
}

void JointCheck::spring(const char* name, const JointSpring& spring) {
    JointCheck inside(*this, name);
    visit_spring(inside, spring);
    merge_status(inside);
}

void JointCheck::axis(const char* name, const JointAxis& axis, double low, double high) {
    JointCheck inside(*this, name);
    visit_axis(inside, axis, low, high);
    const bool moves = axis.limit.enabled || axis.spring.hertz > 0 || axis.motor.enabled;
    if (inside.status_.ok() && !axis.free && (moves || axis.friction > 0))
        inside.status_ =
            invalid_argument(path_of(name) +
                             " is locked and has a limit, spring, motor or friction; make it "
                             "free or remove them");
    merge_status(inside);
}

Status check_kind(const JointKind& kind) {
    return std::visit(
        []<class Kind>(const Kind& joint) {
            JointCheck check(JointFields<Kind>::name);
            JointFields<Kind>::visit(check, joint);
            return check.status();
        },
        kind);
}

}  // namespace jostle::physics
