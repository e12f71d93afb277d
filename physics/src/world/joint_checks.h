// SPDX-License-Identifier: MIT
//
// Checks the parameters of a joint against the ranges of the field table
// (jostle/physics/joint_fields.h).
#pragma once

#include <string>

#include "jostle/physics/joint_fields.h"
#include "jostle/physics/result.h"

namespace jostle::physics {

// Returns an error that names the field by its path: "hinge.motor.speed".
Status check_kind(const JointKind& kind);

// Visitor of the field table that records the first error.
class JointCheck {
public:
    explicit JointCheck(const char* kind) : name_(kind) {}
    // Checks a nested struct of `parent`, which must outlive this object.
    JointCheck(const JointCheck& parent, const char* name) : parent_(&parent), name_(name) {}
    JointCheck(const JointCheck&) = delete;
    JointCheck& operator=(const JointCheck&) = delete;
    const Status& status() const { return status_; }

    void number(const char* name, double value, double low, double high);
    void ordered(const char* lower_name, double lower, const char* upper_name, double upper,
                 double low, double high);
    void vector(const char* name, Vec3 value, double limit);
    void flag(const char*, bool) {}
    void later(const char* name, double value, double low, double high, int) {
        number(name, value, low, high);
    }
    void drive(const char* name, const RotationDrive& drive);
    void points(const char* name, const std::vector<Vec3>& points, std::size_t least,
                std::size_t most, double limit);
    void limit(const char* name, const JointLimit& limit, double low, double high);
    template <class Motor>
    void motor(const char* name, const Motor& motor) {
        JointCheck inside(*this, name);
        visit_motor(inside, motor);
        merge_status(inside);
    }
    void spring(const char* name, const JointSpring& spring);
    void axis(const char* name, const JointAxis& axis, double low, double high);

private:
    // Builds the path only for an error, because thousands of joints may be set per step.
    std::string path_of(const char* field) const;
    void merge_status(const JointCheck& part) {
        if (status_.ok()) status_ = part.status_;
    }

    const JointCheck* parent_ = nullptr;
    const char* name_;
    Status status_;
};

}  // namespace jostle::physics
