// SPDX-License-Identifier: MIT
#include "modules/rope/src/rope_checks.h"

#include <sstream>
#include <string>

namespace jostle::modules::rope_detail {

using namespace physics;

namespace {

std::string text(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

Status out_of_range(const std::string& name, double value, double low, double high) {
    return Error{ErrorCode::invalid_argument, name + ": " + text(value) +
                                                  " is out of range; must be between " + text(low) +
                                                  " and " + text(high)};
}

Status check_number(const std::string& name, double value, double low, double high) {
    if (value >= low && value <= high) return {};
    return out_of_range(name, value, low, high);
}

Status check_vector(const std::string& name, Vec3 value) {
    const char* axes[] = {".x", ".y", ".z"};
    for (int axis = 0; axis < 3; axis++)
        if (Status s =
                check_number(name + axes[axis], value[axis], -coordinate_max, coordinate_max);
            !s.ok())
            return s;
    return {};
}

Status check_points(const RopeDef& def) {
    if (Status s = check_number("number of points", static_cast<double>(def.points.size()), 2,
                                RopeDef::points_max);
        !s.ok())
        return s;
    double line = 0;
    for (std::size_t k = 0; k < def.points.size(); k++) {
        if (Status s = check_vector("points[" + std::to_string(k) + "]", def.points[k]); !s.ok())
            return s;
        if (k > 0) line += length(def.points[k] - def.points[k - 1]);
    }
    if (line > 1e-3 * def.links) return {};
    return Error{ErrorCode::invalid_argument,
                 "points: the line is " + text(line) + " m long; must be more than 1 mm per link"};
}

}  // namespace

Status check(const RopeDef& def) {
    const Status checks[] = {
        check_number("links", def.links, 1, RopeDef::links_max),
        check_points(def),
        check_number("length", def.length, 0, 1e5),
        check_number("radius", def.radius, 1e-4, 10),
        check_number("mass_per_length", def.mass_per_length, 1e-6, 1e6),
        check_number("stretch_stiffness", def.stretch_stiffness, 1, 1e12),
        check_number("bending_stiffness", def.bending_stiffness, 0, 1e9),
        check_number("damping", def.damping, 0, 1e4),
        check_number("friction", def.friction, 0, 10),
        check_number("breaking_load", def.breaking_load, 0, 1e12),
        check_number("substeps", def.substeps, 1, 64),
    };
    for (const Status& s : checks)
        if (!s.ok()) return s;
    if (def.length > 0 && def.length < 1e-3 * def.links)
        return Error{ErrorCode::invalid_argument,
                     "length: " + text(def.length) + " m is less than 1 mm per link"};
    return {};
}

Status check(const RopeAttachment& attachment, std::size_t links) {
    if (Status s = check_number("node", attachment.node, 0, static_cast<double>(links)); !s.ok())
        return s;
    if (Status s = check_vector("point", attachment.point); !s.ok()) return s;
    if (Status s = check_vector("direction", attachment.direction); !s.ok()) return s;
    if (attachment.direction == Vec3{}) return {};
    if (attachment.node != 0 && attachment.node != links)
        return Error{ErrorCode::invalid_argument,
                     "direction: node " + std::to_string(attachment.node) +
                         " is not an end; must be zero except at node 0 and node " +
                         std::to_string(links)};
    if (length(attachment.direction) > 1e-6) return {};
    return Error{ErrorCode::invalid_argument, "direction: the length " +
                                                  text(length(attachment.direction)) +
                                                  " is too small; must be more than 1e-6"};
}

}  // namespace jostle::modules::rope_detail
