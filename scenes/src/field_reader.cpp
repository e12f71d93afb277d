// SPDX-License-Identifier: MIT
#include "scenes/src/field_reader.h"

#include <cstdio>

#include "jostle/physics/geometry.h"

namespace jostle::scenes {

using namespace physics;

namespace {

std::string text_of(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.9g", x);
    return buffer;
}

}  // namespace

void FieldReader::report_error(const std::string& path, std::string what) {
    if (!full()) errors_.push_back({path, std::move(what)});
}

double FieldReader::number(const std::string& path, double x, double low, double high) {
    if (!(low <= x && x <= high)) {
        report_error(path, text_of(x) + " is out of range; it must be from " + text_of(low) +
                               " to " + text_of(high));
        return low;
    }
    return x + 0.0;  // -0 becomes 0: in JSON, "-0.0" is negative but "-0" is not
}

Vec3 FieldReader::vector(const std::string& path, const v1::Vec3& v, double limit) {
    return {number(path + ".x", v.x(), -limit, limit), number(path + ".y", v.y(), -limit, limit),
            number(path + ".z", v.z(), -limit, limit)};
}

Quat FieldReader::rotation(const std::string& path, bool given, const v1::Quat& m) {
    if (!given) return {};
    const Quat q{m.x(), m.y(), m.z(), m.w()};
    const double norm = norm_squared(q);
    if (!is_finite(norm) || norm < 1e-6 || norm > 1e6)
        report_error(path, "is not a rotation; it must be x, y, z, w of a unit quaternion");
    return {q.x + 0.0, q.y + 0.0, q.z + 0.0, q.w + 0.0};
}

double FieldReader::size(const std::string& path, double x) {
    return number(path, x, min_shape_size, max_shape_size);
}

void set(v1::Vec3& to, Vec3 from) {
    to.set_x(from.x);
    to.set_y(from.y);
    to.set_z(from.z);
}

void set(v1::Quat& to, Quat from) {
    to.set_x(from.x);
    to.set_y(from.y);
    to.set_z(from.z);
    to.set_w(from.w);
}

}  // namespace jostle::scenes
