// SPDX-License-Identifier: MIT
#include "clients/cpp/prediction/wasm/shape_encoding.h"

#include <array>
#include <cstdint>

#include "jostle/physics/compound.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"

namespace jostle::client {

using namespace physics;

namespace {

class NumberReader {
public:
    explicit NumberReader(std::span<const double> numbers) : left_(numbers) {}

    bool failed() const { return failed_; }
    bool at_end() const { return left_.empty(); }
    void fail() { failed_ = true; }

    // Returns 0 past the end or for a non-finite number.
    double next() {
        if (left_.empty() || !is_finite(left_.front())) {
            failed_ = true;
            return 0;
        }
        const double number = left_.front();
        left_ = left_.subspan(1);
        return number + 0.0;  // converts -0 to 0, like the server
    }
    // An integer from 0 to `most`.
    std::uint32_t whole(double most = 4294967295.0) {
        const double number = next();
        if (!(number >= 0 && number <= most) || number != static_cast<std::uint32_t>(number)) {
            failed_ = true;
            return 0;
        }
        return static_cast<std::uint32_t>(number);
    }
    // A count of items with at least `each` numbers.
    std::uint32_t count(std::size_t each) {
        return whole(static_cast<double>(left_.size() / each));
    }
    Vec3 vector() {
        const double x = next(), y = next(), z = next();
        return {x, y, z};
    }
    Transform pose() {
        const Vec3 position = vector();
        const double x = next(), y = next(), z = next(), w = next();
        const Quat rotation{x, y, z, w};
        const double norm = norm_squared(rotation);
        if (!(norm > 1e-6 && norm < 1e6)) failed_ = true;
        return {position, rotation};
    }
    std::vector<Vec3> points() {
        std::vector<Vec3> points(count(3));
        for (Vec3& point : points) point = vector();
        return points;
    }

private:
    std::span<const double> left_;
    bool failed_ = false;
};

struct Placed {
    Geometry geometry;
    Transform pose;
};

template <class Shape, class Data>
Geometry built(NumberReader& in, const Result<std::shared_ptr<const Data>>& made) {
    if (made.ok()) return Shape{*made};
    in.fail();
    return Box{};
}

// The order of the faces depends on points that are not vertices; the server builds hulls from
// their vertices too.
Geometry read_hull(NumberReader& in) {
    const std::vector<Vec3> points = in.points();
    auto hull = build_hull(points);
    if (hull.ok() && (*hull)->vertices.size() < points.size()) hull = build_hull((*hull)->vertices);
    return built<Hull>(in, hull);
}

Geometry read_mesh(NumberReader& in) {
    const std::vector<Vec3> vertices = in.points();
    std::vector<std::array<std::uint32_t, 3>> triangles(in.count(3));
    for (auto& triangle : triangles)
        for (std::uint32_t& corner : triangle) corner = in.whole();
    if (in.failed()) return Box{};
    return built<Mesh>(in, build_mesh(vertices, triangles));
}

Geometry read_height_field(NumberReader& in) {
    HeightGrid grid{.columns = in.whole(), .rows = in.whole()};
    grid.spacing_x = in.next();
    grid.spacing_z = in.next();
    // The list must contain all heights.
    const std::uint64_t samples = std::uint64_t{grid.columns} * grid.rows;
    if (grid.columns < 2 || grid.rows < 2 || samples > max_height_samples) in.fail();
    for (std::uint64_t k = 0; k < samples && !in.failed(); k++) grid.heights.push_back(in.next());
    const std::uint32_t holes = in.count(1);
    if (in.failed()) return Box{};
    if (holes > 0) grid.holes.assign(std::size_t{grid.columns - 1} * (grid.rows - 1), 0);
    for (std::uint32_t k = 0; k < holes; k++) {
        const std::uint32_t cell = in.whole(static_cast<double>(grid.holes.size() - 1));
        if (!in.failed()) grid.holes[cell] = 1;
    }
    return built<HeightField>(in, build_height_field(std::move(grid)));
}

Placed read_placed(NumberReader& in, bool inside = false);

Geometry read_compound(NumberReader& in) {
    constexpr std::size_t least = 9;  // kind, position and a radius
    std::vector<CompoundChild> children;
    const std::uint32_t count = in.count(least);
    for (std::uint32_t k = 0; k < count && !in.failed(); k++) {
        const Placed child = read_placed(in, true);
        children.push_back({child.geometry, child.pose});
    }
    if (in.failed()) return Box{};
    return built<Compound>(in, build_compound(std::move(children)));
}

Geometry read_geometry(NumberReader& in, std::uint32_t kind, bool inside) {
    switch (kind) {
        case 1:
            return Sphere{in.next()};
        case 2: {
            const double radius = in.next();
            return Capsule{radius, in.next()};
        }
        case 3:
            return Box{in.vector()};
        case 4:
            return Plane{in.vector()};
        case 5: {
            const double radius = in.next();
            return Cylinder{radius, in.next()};
        }
        case 6: {
            const double radius = in.next();
            return Cone{radius, in.next()};
        }
        case 7:
            return read_hull(in);
        case 8:
            return read_mesh(in);
        case 9:
            return read_height_field(in);
        case 10:
            if (!inside) return read_compound(in);
            break;
        default:
            break;
    }
    in.fail();
    return Box{};
}

Placed read_placed(NumberReader& in, bool inside) {
    const std::uint32_t kind = in.whole();
    const Transform pose = in.pose();
    return {read_geometry(in, kind, inside), pose};
}

Combine read_rule(NumberReader& in) {
    return static_cast<Combine>(in.whole(static_cast<double>(Combine::maximum)));
}

ShapeDef read_shape(NumberReader& in) {
    ShapeDef shape;
    const Placed placed = read_placed(in);
    shape.geometry = placed.geometry;
    shape.pose = placed.pose;
    Material& m = shape.material;
    m.friction = in.next();
    m.restitution = in.next();
    m.rolling_friction = in.next();
    m.torsional_friction = in.next();
    m.surface_velocity = in.vector();
    m.friction_rule = read_rule(in);
    m.restitution_rule = read_rule(in);
    shape.filter.category = in.whole();
    shape.filter.mask = in.whole();
    const double group = in.next();
    if (!(group >= -2147483648.0 && group <= 2147483647.0)) in.fail();
    if (!in.failed()) shape.filter.group = static_cast<std::int32_t>(group);
    shape.trigger = in.whole(1) == 1;
    shape.density = in.next();
    shape.mass = in.next();
    return shape;
}

}  // namespace

std::optional<std::vector<ShapeDef>> decode_shapes(std::span<const double> numbers) {
    constexpr std::size_t least = 24;  // a sphere and its material
    NumberReader in(numbers);
    std::vector<ShapeDef> shapes;
    const std::uint32_t count = in.count(least);
    for (std::uint32_t k = 0; k < count && !in.failed(); k++) shapes.push_back(read_shape(in));
    if (in.failed() || !in.at_end()) return std::nullopt;
    return shapes;
}

}  // namespace jostle::client
