// SPDX-License-Identifier: MIT
#include "scenes/src/message_fields.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <stdexcept>

namespace jostle::scenes {

using namespace physics;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

namespace {

const FieldDescriptor* find_field(const Message& message, const std::string& name) {
    if (const auto* field = message.GetDescriptor()->FindFieldByName(name)) return field;
    throw std::logic_error(message.GetTypeName() + " has no field " + name +
                           "; add it to scene.proto");
}

const FieldDescriptor* find_field(const Message& message, const std::string& name,
                                  FieldDescriptor::CppType type) {
    const FieldDescriptor* field = find_field(message, name);
    if (field->cpp_type() == type && !field->is_repeated()) return field;
    throw std::logic_error(field->full_name() + " must be a " + FieldDescriptor::CppTypeName(type) +
                           ", the type used by the solver");
}

constexpr auto number_type = FieldDescriptor::CPPTYPE_DOUBLE;
constexpr auto flag_type = FieldDescriptor::CPPTYPE_BOOL;
constexpr auto message_type = FieldDescriptor::CPPTYPE_MESSAGE;

}  // namespace

bool MessageFieldReader::lacks(const char* name) const {
    const FieldDescriptor* field = find_field(from_, prefix_ + name);
    return field->has_presence() && !from_.GetReflection()->HasField(from_, field);
}

MessageFieldReader MessageFieldReader::inside(const char* name) const {
    const auto* field = find_field(from_, prefix_ + name, message_type);
    return {in_, path_of(name), from_.GetReflection()->GetMessage(from_, field)};
}

void MessageFieldReader::number(const char* name, double& value, double low, double high) {
    const auto* field = find_field(from_, prefix_ + name, number_type);
    if (lacks(name)) return;
    value = in_.number(path_of(name), from_.GetReflection()->GetDouble(from_, field), low, high);
}

void MessageFieldReader::ordered(const char* lower_name, double& lower, const char* upper_name,
                                 double& upper, double low, double high) {
    number(lower_name, lower, low, high);
    number(upper_name, upper, low, high);
    if (upper < lower)
        in_.report_error(path_of(upper_name), "is less than " + prefix_ + lower_name);
}

void MessageFieldReader::vector(const char* name, Vec3& value, double limit) {
    MessageFieldReader fields = inside(name);
    if (lacks(name)) return;
    fields.number("x", value.x, -limit, limit);
    fields.number("y", value.y, -limit, limit);
    fields.number("z", value.z, -limit, limit);
}

void MessageFieldReader::flag(const char* name, bool& value) {
    const auto* field = find_field(from_, prefix_ + name, flag_type);
    if (!lacks(name)) value = from_.GetReflection()->GetBool(from_, field);
}

void MessageFieldReader::points(const char* name, std::vector<Vec3>& points, std::size_t least,
                                std::size_t most, double limit) {
    const FieldDescriptor* field = find_field(from_, prefix_ + name);
    const auto* reflection = from_.GetReflection();
    const auto count = static_cast<std::size_t>(reflection->FieldSize(from_, field));
    if (count < least || count > most)
        return in_.report_error(path_of(name),
                                "has " + std::to_string(count) + " points; it must have " +
                                    std::to_string(least) + " to " + std::to_string(most));
    points.assign(count, {});
    for (std::size_t k = 0; k < count; k++) {
        MessageFieldReader point(in_, path_of(name) + "[" + std::to_string(k) + "]",
                                 reflection->GetRepeatedMessage(from_, field, static_cast<int>(k)));
        point.number("x", points[k].x, -limit, limit);
        point.number("y", points[k].y, -limit, limit);
        point.number("z", points[k].z, -limit, limit);
    }
}

void MessageFieldReader::drive(const char* name, RotationDrive& drive) {
    MessageFieldReader fields = inside(name);
    if (lacks(name)) return;
    fields.spring("spring", drive.spring);
    fields.number("max_torque", drive.max_torque, 0, 1e12);
    MessageFieldReader target = fields.inside("target");
    if (fields.lacks("target")) return;
    target.number("x", drive.target.x, -1, 1);
    target.number("y", drive.target.y, -1, 1);
    target.number("z", drive.target.z, -1, 1);
    target.number("w", drive.target.w, -1, 1);
    if (norm_squared(drive.target) < 1e-6)
        in_.report_error(fields.path_of("target"), "is not a rotation");
}

void MessageFieldReader::limit(const char* name, JointLimit& limit, double low, double high) {
    limit = {};
    MessageFieldReader fields = inside(name);
    if (lacks(name)) return;
    limit.enabled = true;
    visit_limit(fields, limit, low, high);
    if (limit.lower > limit.upper)
        in_.report_error(fields.path_of("lower"), "is greater than the upper limit");
}

void MessageFieldReader::spring(const char* name, JointSpring& spring) {
    MessageFieldReader fields = inside(name);
    if (!lacks(name)) visit_spring(fields, spring);
}

void MessageFieldReader::axis(const char* name, JointAxis& axis, double low, double high) {
    axis = {};
    MessageFieldReader fields = inside(name);
    if (!lacks(name)) visit_axis(fields, axis, low, high);
}

MessageFieldWriter MessageFieldWriter::inside(const char* name) const {
    const auto* field = find_field(to_, prefix_ + name, message_type);
    return MessageFieldWriter(*to_.GetReflection()->MutableMessage(&to_, field));
}

void MessageFieldWriter::number(const char* name, double value, double, double) {
    to_.GetReflection()->SetDouble(&to_, find_field(to_, prefix_ + name, number_type), value);
}

void MessageFieldWriter::ordered(const char* lower_name, double lower, const char* upper_name,
                                 double upper, double low, double high) {
    number(lower_name, lower, low, high);
    number(upper_name, upper, low, high);
}

void MessageFieldWriter::vector(const char* name, Vec3 value, double limit) {
    MessageFieldWriter fields = inside(name);
    fields.number("x", value.x, -limit, limit);
    fields.number("y", value.y, -limit, limit);
    fields.number("z", value.z, -limit, limit);
}

void MessageFieldWriter::flag(const char* name, bool value) {
    to_.GetReflection()->SetBool(&to_, find_field(to_, prefix_ + name, flag_type), value);
}

void MessageFieldWriter::points(const char* name, const std::vector<Vec3>& points, std::size_t,
                                std::size_t, double limit) {
    const FieldDescriptor* field = find_field(to_, prefix_ + name);
    for (const Vec3 point : points) {
        MessageFieldWriter to(*to_.GetReflection()->AddMessage(&to_, field));
        to.number("x", point.x, -limit, limit);
        to.number("y", point.y, -limit, limit);
        to.number("z", point.z, -limit, limit);
    }
}

void MessageFieldWriter::drive(const char* name, const RotationDrive& drive) {
    if (!(drive.spring.hertz > 0)) return;
    MessageFieldWriter fields = inside(name);
    fields.spring("spring", drive.spring);
    fields.number("max_torque", drive.max_torque, 0, 1e12);
    MessageFieldWriter target = fields.inside("target");
    target.number("x", drive.target.x, -1, 1);
    target.number("y", drive.target.y, -1, 1);
    target.number("z", drive.target.z, -1, 1);
    target.number("w", drive.target.w, -1, 1);
}

void MessageFieldWriter::limit(const char* name, const JointLimit& limit, double low, double high) {
    if (!limit.enabled) return;
    MessageFieldWriter fields = inside(name);
    visit_limit(fields, limit, low, high);
}

void MessageFieldWriter::spring(const char* name, const JointSpring& spring) {
    if (!(spring.hertz > 0)) return;
    MessageFieldWriter fields = inside(name);
    visit_spring(fields, spring);
}

void MessageFieldWriter::axis(const char* name, const JointAxis& axis, double low, double high) {
    if (!axis.free) return;
    MessageFieldWriter fields = inside(name);
    visit_axis(fields, axis, low, high);
}

}  // namespace jostle::scenes
