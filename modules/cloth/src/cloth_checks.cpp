// SPDX-License-Identifier: MIT
#include "modules/cloth/src/cloth_checks.h"

#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace jostle::modules::cloth_detail {

using namespace physics;

namespace {

std::string text(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

Error invalid(std::string message) {
    return Error{ErrorCode::invalid_argument, std::move(message)};
}

Status check_number(const std::string& name, double value, double low, double high) {
    if (value >= low && value <= high) return {};
    return invalid(name + ": " + text(value) + " is out of range; must be between " + text(low) +
                   " and " + text(high));
}

Status check_vector(const std::string& name, Vec3 value, double most = coordinate_max) {
    const char* axes[] = {".x", ".y", ".z"};
    for (int axis = 0; axis < 3; axis++)
        if (Status s = check_number(name + axes[axis], value[axis], -most, most); !s.ok()) return s;
    return {};
}

Status check_grid(const ClothGrid& grid) {
    const Status checks[] = {
        check_number("grid.rows", grid.rows, 2, 1000),
        check_number("grid.columns", grid.columns, 2, 1000),
        check_number("grid.rows * grid.columns", double{1} * grid.rows * grid.columns, 4,
                     ClothDef::vertices_max),
        check_vector("grid.origin", grid.origin),
        check_vector("grid.across", grid.across),
        check_vector("grid.down", grid.down),
        check_number("grid.width", grid.width, 0, 1e5),
        check_number("grid.height", grid.height, 0, 1e5),
    };
    for (const Status& s : checks)
        if (!s.ok()) return s;
    const double across = length(grid.across), down = length(grid.down);
    if (!(length(cross(grid.across, grid.down)) > 1e-3 * across * down))
        return invalid("grid.across and grid.down are parallel or zero; they must span an area");
    const double du = (grid.width > 0 ? grid.width : across) / (grid.columns - 1);
    const double dv = (grid.height > 0 ? grid.height : down) / (grid.rows - 1);
    if (du < 1e-3 || dv < 1e-3)
        return invalid("grid: the vertices are " + text(du < dv ? du : dv) +
                       " m apart at rest; must be at least 1 mm");
    if (du > 100 * dv || dv > 100 * du)
        return invalid("grid: the cells are more than 100 times as long as wide");
    return {};
}

Status check_mesh(const ClothDef& def) {
    if (Status s = check_number("number of vertices", static_cast<double>(def.vertices.size()), 3,
                                ClothDef::vertices_max);
        !s.ok())
        return s;
    if (def.triangles.size() % 3 != 0 || def.triangles.size() > 6 * def.vertices.size() + 6)
        return invalid("triangles: " + std::to_string(def.triangles.size()) +
                       " indices; must be a multiple of 3 and at most 6 per vertex");
    for (std::size_t k = 0; k < def.vertices.size(); k++)
        if (Status s = check_vector("vertices[" + std::to_string(k) + "]", def.vertices[k]);
            !s.ok())
            return s;
    std::vector<bool> used(def.vertices.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t k = 0; k < def.triangles.size(); k += 3) {
        const std::string name = "triangle " + std::to_string(k / 3);
        for (std::size_t i = 0; i < 3; i++)
            if (def.triangles[k + i] >= def.vertices.size())
                return invalid(name + ": vertex " + std::to_string(def.triangles[k + i]) +
                               " does not exist");
        const Vec3 a = def.vertices[def.triangles[k]], b = def.vertices[def.triangles[k + 1]],
                   c = def.vertices[def.triangles[k + 2]];
        const double longest = std::max(length(b - a), std::max(length(c - a), length(c - b)));
        const double height = longest > 0 ? length(cross(b - a, c - a)) / longest : 0;
        if (!(height >= 1e-4) || height < 0.01 * longest)
            return invalid(name +
                           ": is degenerate; its height must be at least 0.1 mm and 1 % of "
                           "its longest edge");
        for (std::size_t i = 0; i < 3; i++) {
            const std::uint32_t v = def.triangles[k + i], w = def.triangles[k + (i + 1) % 3];
            used[v] = true;
            if (++edges[{std::min(v, w), std::max(v, w)}] > 2)
                return invalid(name + ": its edge " + std::to_string(v) + "-" + std::to_string(w) +
                               " has more than two triangles");
        }
    }
    for (std::size_t k = 0; k < used.size(); k++)
        if (!used[k]) return invalid("vertices[" + std::to_string(k) + "]: has no triangle");
    return {};
}

}  // namespace

Status check(const ClothDef& def) {
    if (Status s = def.triangles.empty() ? check_grid(def.grid) : check_mesh(def); !s.ok())
        return s;
    if (def.triangles.empty() && !def.vertices.empty())
        return invalid("vertices: a mesh needs triangles");
    const Status checks[] = {
        check_number("mass_per_area", def.mass_per_area, 1e-4, 1e4),
        check_number("stretch_stiffness", def.stretch_stiffness, 1, 1e7),
        check_number("shear_stiffness", def.shear_stiffness, 0, 1e7),
        check_number("bending_stiffness", def.bending_stiffness, 0, 1e4),
        check_number("damping", def.damping, 0, 1e4),
        check_number("drag", def.drag, 0, 100),
        check_vector("wind", def.wind, speed_max),
        check_vector("gust", def.gust, speed_max),
        check_number("gust_period", def.gust_period, 1e-3, 1e12),
        check_number("thickness", def.thickness, 1e-4, 1),
        check_number("friction", def.friction, 0, 10),
        check_number("breaking_load", def.breaking_load, 0, 1e12),
        check_number("substeps", def.substeps, 1, 64),
    };
    for (const Status& s : checks)
        if (!s.ok()) return s;
    return {};
}

Status check(const ClothAttachment& attachment, std::size_t vertices) {
    if (attachment.vertex >= vertices)
        return check_number("vertex", attachment.vertex, 0, static_cast<double>(vertices) - 1);
    return check_vector("point", attachment.point);
}

}  // namespace jostle::modules::cloth_detail
