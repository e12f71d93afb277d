// SPDX-License-Identifier: MIT
#include "jostle/scenes/shape_message.h"

#include "jostle/modules/convex_decomposition.h"
#include "jostle/physics/compound.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/limits.h"
#include "jostle/physics/mesh.h"
#include "jostle/v1/scene.pb.h"
#include "scenes/src/shape_reader.h"

namespace jostle::scenes {

using namespace physics;

namespace {

std::vector<Vec3> points_of(FieldReader& in, const std::string& path,
                            const google::protobuf::RepeatedPtrField<v1::Vec3>& points) {
    std::vector<Vec3> out;
    out.reserve(static_cast<std::size_t>(points.size()));
    for (int i = 0; i < points.size() && !in.failed(); i++)
        out.push_back(in.vector(path + "[" + std::to_string(i) + "]", points[i], max_shape_size));
    return out;
}

// Returns the result of a builder, or reports its error. Errors of builders begin with the kind of
// the shape ("hull: it has 3 points"), which is already part of the path.
template <class Shape, class Data>
std::optional<Geometry> built(FieldReader& in, const std::string& path,
                              const Result<std::shared_ptr<const Data>>& made) {
    if (made.ok()) return Shape{*made};
    const std::string& why = made.error().message;
    const std::size_t kind = why.find(": ");
    in.report_error(path, kind == std::string::npos ? why : why.substr(kind + 2));
    return std::nullopt;
}

std::optional<Geometry> read_hull(FieldReader& in, const std::string& path, const v1::Hull& m) {
    const std::vector<Vec3> points = points_of(in, path + ".points", m.points());
    if (in.failed()) return std::nullopt;
    auto hull = build_hull(points);
    // Only corners are written. The order of faces depends on points that are not corners. The hull
    // is therefore built from its corners only, so that it is the same when it is read again.
    if (hull.ok() && (*hull)->vertices.size() < points.size()) hull = build_hull((*hull)->vertices);
    return built<Hull>(in, path, hull);
}

std::optional<Geometry> read_mesh(FieldReader& in, const std::string& path, const v1::Mesh& m) {
    const std::vector<Vec3> vertices = points_of(in, path + ".vertices", m.vertices());
    if (m.indices_size() % 3 != 0)
        in.report_error(path + ".indices", "has " + std::to_string(m.indices_size()) +
                                               " entries; it must have 3 per triangle");
    if (in.failed()) return std::nullopt;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (int i = 0; i < m.indices_size(); i += 3)
        triangles.push_back({m.indices(i), m.indices(i + 1), m.indices(i + 2)});
    return built<Mesh>(in, path, build_mesh(vertices, triangles));
}

// Hulls that contain a closed mesh. The scene chooses the allowed volume error; the limits below
// bound the computing time.
std::optional<Geometry> read_solid(FieldReader& in, const std::string& path, const v1::Solid& m) {
    constexpr int triangles_max = 20000;
    constexpr double hulls_max = 128;
    const std::vector<Vec3> vertices = points_of(in, path + ".mesh.vertices", m.mesh().vertices());
    if (m.mesh().indices_size() > 3 * triangles_max)
        in.report_error(path + ".mesh.indices",
                        "has " + std::to_string(m.mesh().indices_size() / 3) +
                            " triangles; it must have at most " + std::to_string(triangles_max));
    modules::convex_decomposition::Options options;
    if (m.parts_max() != 0)
        options.hulls_max =
            static_cast<int>(in.number(path + ".parts_max", m.parts_max(), 1, hulls_max));
    if (m.has_excess()) options.max_volume_error = in.number(path + ".excess", m.excess(), 0, 10);
    if (in.failed()) return std::nullopt;
    const std::vector<std::uint32_t> indices(m.mesh().indices().begin(), m.mesh().indices().end());
    const auto parts = modules::convex_decomposition::decompose(vertices, indices, options);
    if (!parts.ok()) {
        in.report_error(path, parts.error().message);
        return std::nullopt;
    }
    std::vector<CompoundChild> children;
    for (const auto& part : parts->parts) children.push_back({Hull{part}, {}});
    return built<Compound>(in, path, build_compound(std::move(children)));
}

std::optional<Geometry> read_height_field(FieldReader& in, const std::string& path,
                                          const v1::HeightField& m) {
    HeightGrid grid{.columns = m.columns(),
                    .rows = m.rows(),
                    .spacing_x = in.size(path + ".spacing_x", m.spacing_x()),
                    .spacing_z = in.size(path + ".spacing_z", m.spacing_z()),
                    .heights = {m.heights().begin(), m.heights().end()},
                    .holes = {}};
    if (in.failed()) return std::nullopt;
    for (double& h : grid.heights) h += 0.0;  // avoids -0, as in FieldReader::number()
    if (m.holes_size() > 0 && grid.columns >= 2 && grid.rows >= 2 &&
        grid.columns <= max_height_samples && grid.rows <= max_height_samples &&
        std::size_t{grid.columns} * grid.rows <= max_height_samples) {
        grid.holes.assign(std::size_t{grid.columns - 1} * (grid.rows - 1), 0);
        for (int i = 0; i < m.holes_size(); i++) {
            if (m.holes(i) >= grid.holes.size()) {
                in.report_error(path + ".holes[" + std::to_string(i) + "]",
                                "is " + std::to_string(m.holes(i)) + "; there are " +
                                    std::to_string(grid.holes.size()) + " cells");
                return std::nullopt;
            }
            grid.holes[m.holes(i)] = 1;
        }
    }
    return built<HeightField>(in, path, build_height_field(std::move(grid)));
}

std::optional<Geometry> read_compound(FieldReader& in, const std::string& path,
                                      const v1::Compound& m) {
    std::vector<CompoundChild> children;
    for (int i = 0; i < m.children_size() && !in.failed(); i++) {
        const std::string at = path + ".children[" + std::to_string(i) + "]";
        const v1::Shape& child = m.children(i);
        if (child.kind_case() == v1::Shape::kCompound) {
            in.report_error(at, "is a compound inside a compound; list its children directly");
            break;
        }
        if (child.kind_case() == v1::Shape::kSolid) {
            in.report_error(at,
                            "is a solid inside a compound; make it a separate shape of the body");
            break;
        }
        const auto geometry = read_geometry(in, at, child);
        if (!geometry) break;
        children.push_back(
            {*geometry,
             {in.vector(at + ".position", child.position(), max_shape_size),
              in.rotation(at + ".rotation", child.has_rotation(), child.rotation())}});
    }
    if (in.failed()) return std::nullopt;
    return built<Compound>(in, path, build_compound(std::move(children)));
}

Combine rule_of(FieldReader& in, const std::string& path, v1::Combine rule, Combine fallback) {
    switch (rule) {
        case v1::COMBINE_UNSPECIFIED:
            return fallback;
        case v1::COMBINE_AVERAGE:
            return Combine::average;
        case v1::COMBINE_GEOMETRIC_MEAN:
            return Combine::geometric_mean;
        case v1::COMBINE_MINIMUM:
            return Combine::minimum;
        case v1::COMBINE_MULTIPLY:
            return Combine::multiply;
        case v1::COMBINE_MAXIMUM:
            return Combine::maximum;
        default:
            in.report_error(path, "is not a valid combine rule");
    }
    return fallback;
}

v1::Combine to_message(Combine rule) {
    switch (rule) {
        case Combine::average:
            return v1::COMBINE_AVERAGE;
        case Combine::geometric_mean:
            return v1::COMBINE_GEOMETRIC_MEAN;
        case Combine::minimum:
            return v1::COMBINE_MINIMUM;
        case Combine::multiply:
            return v1::COMBINE_MULTIPLY;
        case Combine::maximum:
            break;
    }
    return v1::COMBINE_MAXIMUM;
}

Material read_tls_material(FieldReader& in, const std::string& path, const v1::Shape& m) {
    Material out;
    if (m.has_friction()) out.friction = in.number(path + ".friction", m.friction(), 0, 100);
    if (m.has_restitution())
        out.restitution = in.number(path + ".restitution", m.restitution(), 0, 1);
    if (m.has_rolling_friction())
        out.rolling_friction = in.number(path + ".rolling_friction", m.rolling_friction(), 0, 100);
    if (m.has_torsional_friction())
        out.torsional_friction =
            in.number(path + ".torsional_friction", m.torsional_friction(), 0, 100);
    out.surface_velocity =
        in.vector(path + ".surface_velocity", m.surface_velocity(), limits::max_speed);
    out.friction_rule = rule_of(in, path + ".friction_rule", m.friction_rule(), out.friction_rule);
    out.restitution_rule =
        rule_of(in, path + ".restitution_rule", m.restitution_rule(), out.restitution_rule);
    return out;
}

void put_points(google::protobuf::RepeatedPtrField<v1::Vec3>& to, const std::vector<Vec3>& from) {
    for (const Vec3 p : from) set(*to.Add(), p);
}

struct WriteGeometry {
    v1::Shape& to;

    void operator()(const Sphere& s) const { to.mutable_sphere()->set_radius(s.radius); }
    void operator()(const Capsule& c) const {
        to.mutable_capsule()->set_radius(c.radius);
        to.mutable_capsule()->set_half_length(c.half_length);
    }
    void operator()(const Box& b) const {
        set(*to.mutable_box()->mutable_half_extents(), b.half_extents);
    }
    void operator()(const Plane& p) const { set(*to.mutable_plane()->mutable_normal(), p.normal); }
    void operator()(const Cylinder& c) const {
        to.mutable_cylinder()->set_radius(c.radius);
        to.mutable_cylinder()->set_half_length(c.half_length);
    }
    void operator()(const Cone& c) const {
        to.mutable_cone()->set_radius(c.radius);
        to.mutable_cone()->set_half_length(c.half_length);
    }
    void operator()(const Hull& h) const {
        put_points(*to.mutable_hull()->mutable_points(), h.data->vertices);
    }
    void operator()(const Mesh& m) const {
        v1::Mesh& out = *to.mutable_mesh();
        put_points(*out.mutable_vertices(), m.data->vertices);
        for (const auto& t : m.data->triangles)
            for (const std::uint32_t corner : t) out.add_indices(corner);
    }
    void operator()(const HeightField& f) const {
        v1::HeightField& out = *to.mutable_height_field();
        const HeightGrid& grid = *f.data;
        out.set_columns(grid.columns);
        out.set_rows(grid.rows);
        out.set_spacing_x(grid.spacing_x);
        out.set_spacing_z(grid.spacing_z);
        for (const double h : grid.heights) out.add_heights(h);
        for (std::uint32_t cell = 0; cell < grid.holes.size(); cell++)
            if (grid.holes[cell] != 0) out.add_holes(cell);
    }
    void operator()(const Compound& c) const {
        v1::Compound& out = *to.mutable_compound();
        for (const CompoundChild& child : c.data->children)
            write_geometry(*out.add_children(), child.geometry, child.pose);
    }
};

}  // namespace

std::optional<Geometry> read_geometry(FieldReader& in, const std::string& path,
                                      const v1::Shape& m) {
    switch (m.kind_case()) {
        case v1::Shape::kSphere:
            return Sphere{in.size(path + ".sphere.radius", m.sphere().radius())};
        case v1::Shape::kCapsule:
            return Capsule{in.size(path + ".capsule.radius", m.capsule().radius()),
                           in.size(path + ".capsule.half_length", m.capsule().half_length())};
        case v1::Shape::kBox: {
            const std::string at = path + ".box.half_extents";
            const v1::Vec3& h = m.box().half_extents();
            return Box{
                {in.size(at + ".x", h.x()), in.size(at + ".y", h.y()), in.size(at + ".z", h.z())}};
        }
        case v1::Shape::kPlane: {
            if (!m.plane().has_normal()) return Plane{};
            const Vec3 n = in.vector(path + ".plane.normal", m.plane().normal(), 1e6);
            if (length(n) < 1e-6)
                in.report_error(path + ".plane.normal", "is zero; it must have a direction");
            return Plane{n};
        }
        case v1::Shape::kCylinder:
            return Cylinder{in.size(path + ".cylinder.radius", m.cylinder().radius()),
                            in.size(path + ".cylinder.half_length", m.cylinder().half_length())};
        case v1::Shape::kCone:
            return Cone{in.size(path + ".cone.radius", m.cone().radius()),
                        in.size(path + ".cone.half_length", m.cone().half_length())};
        case v1::Shape::kHull:
            return read_hull(in, path + ".hull", m.hull());
        case v1::Shape::kMesh:
            return read_mesh(in, path + ".mesh", m.mesh());
        case v1::Shape::kHeightField:
            return read_height_field(in, path + ".height_field", m.height_field());
        case v1::Shape::kSolid:
            return read_solid(in, path + ".solid", m.solid());
        case v1::Shape::kCompound:
            return read_compound(in, path + ".compound", m.compound());
        case v1::Shape::kGeometry:
            in.report_error(path + ".geometry",
                            "refers to a shape of a play stream; specify the shape itself");
            return std::nullopt;
        case v1::Shape::KIND_NOT_SET:
            break;
    }
    in.report_error(
        path,
        "has no kind; it must have one of sphere, capsule, box, plane, cylinder, cone, hull, mesh, "
        "height_field, compound, solid");
    return std::nullopt;
}

ShapeDef read_shape(FieldReader& in, const std::string& path, const v1::Shape& m) {
    ShapeDef def;
    if (const auto g = read_geometry(in, path, m)) def.geometry = *g;
    def.pose = {in.vector(path + ".position", m.position(), max_shape_size),
                in.rotation(path + ".rotation", m.has_rotation(), m.rotation())};
    if (m.has_density())
        def.density = in.number(path + ".density", m.density(), 1e-3, limits::max_density);
    if (m.has_mass())
        def.mass = in.number(path + ".mass", m.mass(), limits::min_mass, limits::max_mass);
    def.material = read_tls_material(in, path, m);
    if (m.filter().has_category()) def.filter.category = m.filter().category();
    if (m.filter().has_mask()) def.filter.mask = m.filter().mask();
    def.filter.group = m.filter().group();
    def.trigger = m.trigger();
    def.report_stays = m.report_stays();
    return def;
}

Result<ShapeDef> shape_from_message(const v1::Shape& message, const std::string& path) {
    FieldReader in;
    // The decomposition may take seconds.
    if (message.kind_case() == v1::Shape::kSolid)
        return Error{ErrorCode::invalid_argument,
                     path + ".solid: is allowed only in scenes; use a hull or a compound"};
    ShapeDef def = read_shape(in, path, message);
    if (in.failed())
        return Error{ErrorCode::invalid_argument,
                     in.errors().front().path + ": " + in.errors().front().what};
    return def;
}

void write_geometry(v1::Shape& out, const Geometry& geometry, const Transform& pose) {
    std::visit(WriteGeometry{out}, geometry);
    if (!(pose.position == Vec3{})) set(*out.mutable_position(), pose.position);
    if (!(pose.rotation == Quat{})) set(*out.mutable_rotation(), pose.rotation);
}

void write_contact_properties(v1::Shape& out, const ShapeDef& def) {
    const ShapeDef plain;
    const Material& m = def.material;
    if (m.friction != plain.material.friction) out.set_friction(m.friction);
    if (m.restitution != plain.material.restitution) out.set_restitution(m.restitution);
    if (m.rolling_friction != 0) out.set_rolling_friction(m.rolling_friction);
    if (m.torsional_friction != 0) out.set_torsional_friction(m.torsional_friction);
    if (!(m.surface_velocity == Vec3{})) set(*out.mutable_surface_velocity(), m.surface_velocity);
    if (m.friction_rule != plain.material.friction_rule)
        out.set_friction_rule(to_message(m.friction_rule));
    if (m.restitution_rule != plain.material.restitution_rule)
        out.set_restitution_rule(to_message(m.restitution_rule));
    if (def.filter.category != plain.filter.category)
        out.mutable_filter()->set_category(def.filter.category);
    if (def.filter.mask != plain.filter.mask) out.mutable_filter()->set_mask(def.filter.mask);
    if (def.filter.group != 0) out.mutable_filter()->set_group(def.filter.group);
    if (def.trigger) out.set_trigger(true);
}

void write_shape(v1::Shape& out, const ShapeDef& def) {
    write_geometry(out, def.geometry, def.pose);
    write_contact_properties(out, def);
    out.set_density(def.density);
    if (def.mass > 0) out.set_mass(def.mass);
    out.set_friction(def.material.friction);
    out.set_restitution(def.material.restitution);
    if (def.report_stays) out.set_report_stays(true);
}

std::string shape_bytes(const ShapeDef& def) {
    v1::Shape message;
    write_shape(message, def);
    return message.SerializeAsString();
}

Result<ShapeDef> shape_from_bytes(std::string_view bytes, const std::string& path) {
    v1::Shape message;
    if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
        return Error{ErrorCode::corrupt_data, path + ": not a valid jostle.v1.Shape message"};
    return shape_from_message(message, path);
}

}  // namespace jostle::scenes
