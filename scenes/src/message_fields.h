// SPDX-License-Identifier: MIT
//
// Two visitors of the table of joint kinds (jostle/physics/joint_fields.h): from a message and into
// one, whose fields are found by the table's names. So a new field needs its line in scene.proto
// and none here; without that line both throw std::logic_error, which a test sees first.
//
// What a message lacks keeps its value, where the message can tell (messages and what is
// `optional`); else it is 0. A limit is on when it is there. A motor lies flat (motor_speed,
// motor_max_torque) and is on when its speed is there. What is off is not written, nor is a spring
// of 0 hertz that a message without one would lack, nor an axis that is locked.
#pragma once

#include <string>
#include <vector>

#include "jostle/physics/joint_fields.h"
#include "scenes/src/field_reader.h"

namespace google::protobuf {
class Message;
}

namespace jostle::scenes {

class MessageFieldReader {
public:
    MessageFieldReader(FieldReader& in, std::string path, const google::protobuf::Message& from)
        : in_(in), path_(std::move(path)), from_(from) {}
    // Of the message in a field; the field's name joins the path.
    MessageFieldReader inside(const char* name) const;

    void number(const char* name, double& value, double low, double high);
    void ordered(const char* lower_name, double& lower, const char* upper_name, double& upper,
                 double low, double high);
    void vector(const char* name, physics::Vec3& value, double limit);
    void flag(const char* name, bool& value);
    void later(const char* name, double& value, double low, double high, int) {
        number(name, value, low, high);
    }
    void drive(const char* name, physics::RotationDrive& drive);
    void points(const char* name, std::vector<physics::Vec3>& points, std::size_t least,
                std::size_t most, double limit);
    void limit(const char* name, physics::JointLimit& limit, double low, double high);
    void motor(const char* name, auto& motor) {
        motor = {};
        MessageFieldReader fields(in_, path_, from_);
        fields.prefix_ = prefix_ + name + "_";
        motor.enabled = !fields.lacks("speed");
        if (motor.enabled) physics::visit_motor(fields, motor);
    }
    void spring(const char* name, physics::JointSpring& spring);
    void axis(const char* name, physics::JointAxis& axis, double low, double high);

private:
    bool lacks(const char* name) const;
    std::string path_of(const char* name) const { return path_ + "." + prefix_ + name; }

    FieldReader& in_;
    std::string path_, prefix_ = {};  // of a message; of names in it
    const google::protobuf::Message& from_;
};

class MessageFieldWriter {
public:
    explicit MessageFieldWriter(google::protobuf::Message& to) : to_(to) {}
    // Into the message in a field, which is there from now on.
    MessageFieldWriter inside(const char* name) const;

    void number(const char* name, double value, double low, double high);
    void ordered(const char* lower_name, double lower, const char* upper_name, double upper,
                 double low, double high);
    void vector(const char* name, physics::Vec3 value, double limit);
    void flag(const char* name, bool value);
    void later(const char* name, double value, double low, double high, int) {
        number(name, value, low, high);
    }
    void drive(const char* name, const physics::RotationDrive& drive);
    void points(const char* name, const std::vector<physics::Vec3>& points, std::size_t least,
                std::size_t most, double limit);
    void limit(const char* name, const physics::JointLimit& limit, double low, double high);
    void motor(const char* name, const auto& motor) {
        if (!motor.enabled) return;
        MessageFieldWriter fields(to_);
        fields.prefix_ = prefix_ + name + "_";
        physics::visit_motor(fields, motor);
    }
    void spring(const char* name, const physics::JointSpring& spring);
    void axis(const char* name, const physics::JointAxis& axis, double low, double high);

private:
    google::protobuf::Message& to_;
    std::string prefix_ = {};
};

}  // namespace jostle::scenes
