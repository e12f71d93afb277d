// SPDX-License-Identifier: MIT
//
// Two visitors of the table of joint kinds (jostle/physics/joint_fields.h): one reads from a
// message, the other writes to one. Fields are found by the names in the table, so a new field
// needs a line in scene.proto and no code in this file. Without that line, both throw
// std::logic_error, which a test detects.
//
// A field that is absent keeps its default, if its presence is known (messages and `optional`
// fields); otherwise it is 0. A limit is enabled if it is present. A motor is stored in flat fields
// (motor_speed, motor_max_torque) and is enabled if its speed is present. Disabled values, springs
// of 0 hertz that are the default, and locked axes are not written.
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
    // Reader of the message in a field; the field's name is appended to the path.
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
    std::string path_, prefix_ = {};  // of the message; of field names in it
    const google::protobuf::Message& from_;
};

class MessageFieldWriter {
public:
    explicit MessageFieldWriter(google::protobuf::Message& to) : to_(to) {}
    // Writer of the message in a field, which is created.
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
