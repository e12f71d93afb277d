// SPDX-License-Identifier: MIT
#include "jostle/scenes/scene_file.h"

#include <google/protobuf/util/json_util.h>

#include <cstdio>
#include <fstream>
#include <iterator>

#include "jostle/physics/tuning.h"
#include "jostle/scenes/catalog.h"
#include "jostle/v1/scene.pb.h"
#include "json_place.h"
#include "scene_json.h"

namespace jostle::scenes {

using namespace physics;

namespace {

constexpr std::size_t bodies_max = 200000;  // after repeats
constexpr std::size_t shapes_max = 64;      // of one body
// A short file may ask for much: what repeats multiply is bounded as a whole.
constexpr std::size_t all_shapes_max = 400000;
constexpr std::size_t name_bytes_max = 64;
constexpr std::size_t description_bytes_max = 1000;
constexpr std::uint32_t repeat_max = 100000;
constexpr std::size_t file_bytes_max = 64u << 20;

// The first fault found while a message is read, with the path of its field.
struct Fault {
    std::string path, what;
};

std::string text_of(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.9g", x);
    return buffer;
}

// Reads one message, noting the first fault. What comes after a fault is read as well and thrown
// away.
class Reader {
public:
    const std::optional<Fault>& fault() const { return fault_; }

    SceneDescription scene(const v1::Scene& m) {
        SceneDescription out{.name = m.name(), .description = m.description()};
        if (m.name().empty() || m.name().size() > name_bytes_max)
            note("name", "must be a text of 1 to 64 bytes");
        if (m.description().size() > description_bytes_max)
            note("description", "must be a text of at most 1000 bytes");
        world(out, m.world());
        for (int i = 0; i < m.bodies_size() && !fault_; i++)
            body(out, m.bodies(i), "bodies[" + std::to_string(i) + "]");
        return out;
    }

private:
    void note(const std::string& path, std::string what) {
        if (!fault_) fault_ = {path, std::move(what)};
    }
    double number(const std::string& path, double x, double low, double high) {
        if (!(low <= x && x <= high))
            note(path, text_of(x) + " is out of range; it must be from " + text_of(low) + " to " +
                           text_of(high));
        return x;
    }
    Vec3 vector(const std::string& path, const v1::Vec3& v, double limit) {
        return {number(path + ".x", v.x(), -limit, limit),
                number(path + ".y", v.y(), -limit, limit),
                number(path + ".z", v.z(), -limit, limit)};
    }
    Quat rotation(const std::string& path, bool given, const v1::Quat& m) {
        if (!given) return {};
        const Quat q{m.x(), m.y(), m.z(), m.w()};
        const double norm = norm_squared(q);
        if (!is_finite(norm) || norm < 1e-6 || norm > 1e6)
            note(path, "is no rotation; give x, y, z, w of a unit quaternion");
        return q;
    }
    double size(const std::string& path, double x) {
        return number(path, x, min_shape_size, max_shape_size);
    }

    void world(SceneDescription& out, const v1::WorldSettings& m) {
        if (m.has_gravity()) out.world.gravity = vector("world.gravity", m.gravity(), 1000);
        if (m.has_substeps())
            out.world.substeps =
                static_cast<int>(number("world.substeps", m.substeps(), 1, tuning::max_substeps));
        if (m.has_hz()) out.hz = number("world.hz", m.hz(), 4, 1000);
        if (m.has_sleeping()) out.world.sleeping = m.sleeping();
    }

    std::optional<Geometry> geometry(const std::string& path, const v1::Shape& m) {
        switch (m.kind_case()) {
            case v1::Shape::kSphere:
                return Sphere{size(path + ".sphere.radius", m.sphere().radius())};
            case v1::Shape::kCapsule:
                return Capsule{size(path + ".capsule.radius", m.capsule().radius()),
                               size(path + ".capsule.half_length", m.capsule().half_length())};
            case v1::Shape::kBox: {
                const std::string at = path + ".box.half_extents";
                const v1::Vec3& h = m.box().half_extents();
                return Box{
                    {size(at + ".x", h.x()), size(at + ".y", h.y()), size(at + ".z", h.z())}};
            }
            case v1::Shape::kPlane: {
                if (!m.plane().has_normal()) return Plane{};
                const Vec3 n = vector(path + ".plane.normal", m.plane().normal(), 1e6);
                if (length(n) < 1e-6)
                    note(path + ".plane.normal", "is zero; it must have a direction");
                return Plane{n};
            }
            case v1::Shape::KIND_NOT_SET:
                break;
        }
        note(path, "has no kind; give one of sphere, capsule, box, plane");
        return std::nullopt;
    }

    void shape(SceneBody& out, const v1::Shape& m, const std::string& path) {
        ShapeDef def;
        if (const auto g = geometry(path, m)) def.geometry = *g;
        def.pose = {vector(path + ".position", m.position(), max_shape_size),
                    rotation(path + ".rotation", m.has_rotation(), m.rotation())};
        if (m.has_density())
            def.density = number(path + ".density", m.density(), 1e-3, tuning::max_density);
        if (m.has_friction())
            def.material.friction = number(path + ".friction", m.friction(), 0, 100);
        if (m.has_restitution())
            def.material.restitution = number(path + ".restitution", m.restitution(), 0, 1);
        if (m.has_plane() && out.body.type != BodyType::fixed)
            note(path + ".plane", "is infinite; only a body of type BODY_TYPE_FIXED may have one");
        out.shapes.push_back(def);
    }

    void body(SceneDescription& scene, const v1::Body& m, const std::string& path) {
        if (m.name().size() > name_bytes_max)
            return note(path + ".name", "must be a text of at most 64 bytes");
        SceneBody out{.name = m.name(), .body = {}, .shapes = {}, .color = {}};
        switch (m.type()) {
            case v1::BODY_TYPE_FIXED:
                out.body.type = BodyType::fixed;
                break;
            case v1::BODY_TYPE_KINEMATIC:
                out.body.type = BodyType::kinematic;
                break;
            case v1::BODY_TYPE_UNSPECIFIED:
            case v1::BODY_TYPE_DYNAMIC:
                break;
            default:
                note(path + ".type", "is not a body type");
        }
        BodyDef& b = out.body;
        b.pose = {vector(path + ".position", m.position(), tuning::max_coordinate),
                  rotation(path + ".rotation", m.has_rotation(), m.rotation())};
        b.linear_velocity =
            vector(path + ".linear_velocity", m.linear_velocity(), tuning::max_speed);
        b.angular_velocity =
            vector(path + ".angular_velocity", m.angular_velocity(), tuning::max_speed);
        const bool moves = !(b.linear_velocity == Vec3{}) || !(b.angular_velocity == Vec3{});
        if (b.type == BodyType::fixed && moves)
            note(path + ".type",
                 "is BODY_TYPE_FIXED but the body has a velocity; use BODY_TYPE_KINEMATIC");
        if (m.has_linear_damping())
            b.linear_damping = number(path + ".linear_damping", m.linear_damping(), 0, 1e4);
        if (m.has_angular_damping())
            b.angular_damping = number(path + ".angular_damping", m.angular_damping(), 0, 1e4);
        if (m.has_gravity_scale())
            b.gravity_scale = number(path + ".gravity_scale", m.gravity_scale(), -1e3, 1e3);
        if (m.has_may_sleep()) b.may_sleep = m.may_sleep();
        if (m.has_color())
            out.color = static_cast<std::uint32_t>(number(path + ".color", m.color(), 0, 0xffffff));
        if (m.shapes_size() == 0)
            note(path + ".shapes", "is empty; give the body at least one shape");
        if (static_cast<std::size_t>(m.shapes_size()) > shapes_max)
            note(path + ".shapes", "has more than " + std::to_string(shapes_max) + " shapes");
        for (int i = 0; i < m.shapes_size() && !fault_; i++)
            shape(out, m.shapes(i), path + ".shapes[" + std::to_string(i) + "]");
        add_copies(scene, out, m, path);
    }

    // Each repeat multiplies what there is so far.
    void add_copies(SceneDescription& scene, const SceneBody& body, const v1::Body& m,
                    const std::string& path) {
        std::vector<Vec3> offsets{{}};
        for (int i = 0; i < m.repeat_size() && !fault_; i++) {
            const std::string at = path + ".repeat[" + std::to_string(i) + "]";
            const auto count =
                static_cast<std::size_t>(number(at + ".count", m.repeat(i).count(), 1, repeat_max));
            const Vec3 step = vector(at + ".offset", m.repeat(i).offset(), 1e6);
            if (fault_) return;
            if (offsets.size() * count > bodies_max)
                return note(at + ".count",
                            "makes more than " + std::to_string(bodies_max) + " bodies");
            std::vector<Vec3> all;
            all.reserve(offsets.size() * count);
            for (std::size_t k = 0; k < count; k++)
                for (const Vec3 offset : offsets)
                    all.push_back(offset + step * static_cast<double>(k));
            offsets = std::move(all);
        }
        if (fault_) return;
        if (scene.bodies.size() + offsets.size() > bodies_max)
            return note(path, "makes more than " + std::to_string(bodies_max) + " bodies in all");
        shapes_ += offsets.size() * body.shapes.size();
        if (shapes_ > all_shapes_max)
            return note(path,
                        "makes more than " + std::to_string(all_shapes_max) + " shapes in all");
        for (const Vec3 offset : offsets) {
            scene.bodies.push_back(body);
            scene.bodies.back().body.pose.position += offset;
        }
    }

    std::size_t shapes_ = 0;  // after repeats
    std::optional<Fault> fault_;
};

Error invalid(std::string message) {
    return {ErrorCode::invalid_argument, std::move(message)};
}

v1::Vec3 to_message(Vec3 v) {
    v1::Vec3 out;
    out.set_x(v.x);
    out.set_y(v.y);
    out.set_z(v.z);
    return out;
}
v1::Quat to_message(Quat q) {
    v1::Quat out;
    out.set_x(q.x);
    out.set_y(q.y);
    out.set_z(q.z);
    out.set_w(q.w);
    return out;
}

void write_shape(v1::Shape& out, const ShapeDef& def) {
    if (const auto* sphere = std::get_if<Sphere>(&def.geometry))
        out.mutable_sphere()->set_radius(sphere->radius);
    if (const auto* capsule = std::get_if<Capsule>(&def.geometry)) {
        out.mutable_capsule()->set_radius(capsule->radius);
        out.mutable_capsule()->set_half_length(capsule->half_length);
    }
    if (const auto* box = std::get_if<Box>(&def.geometry))
        *out.mutable_box()->mutable_half_extents() = to_message(box->half_extents);
    if (const auto* plane = std::get_if<Plane>(&def.geometry))
        *out.mutable_plane()->mutable_normal() = to_message(plane->normal);
    if (!(def.pose.position == Vec3{})) *out.mutable_position() = to_message(def.pose.position);
    if (!(def.pose.rotation == Quat{})) *out.mutable_rotation() = to_message(def.pose.rotation);
    out.set_density(def.density);
    out.set_friction(def.material.friction);
    out.set_restitution(def.material.restitution);
}

void write_body(v1::Body& out, const SceneBody& body) {
    const BodyDef& b = body.body;
    out.set_name(body.name);
    out.set_type(b.type == BodyType::fixed       ? v1::BODY_TYPE_FIXED
                 : b.type == BodyType::kinematic ? v1::BODY_TYPE_KINEMATIC
                                                 : v1::BODY_TYPE_DYNAMIC);
    *out.mutable_position() = to_message(b.pose.position);
    if (!(b.pose.rotation == Quat{})) *out.mutable_rotation() = to_message(b.pose.rotation);
    if (!(b.linear_velocity == Vec3{}))
        *out.mutable_linear_velocity() = to_message(b.linear_velocity);
    if (!(b.angular_velocity == Vec3{}))
        *out.mutable_angular_velocity() = to_message(b.angular_velocity);
    if (b.linear_damping != 0) out.set_linear_damping(b.linear_damping);
    if (b.angular_damping != 0) out.set_angular_damping(b.angular_damping);
    if (b.gravity_scale != 1) out.set_gravity_scale(b.gravity_scale);
    if (!b.may_sleep) out.set_may_sleep(false);
    if (body.color) out.set_color(*body.color);
    for (const ShapeDef& def : body.shapes) write_shape(*out.add_shapes(), def);
}

}  // namespace

Result<SceneDescription> from_message(const v1::Scene& message) {
    Reader reader;
    SceneDescription scene = reader.scene(message);
    if (reader.fault()) return invalid(reader.fault()->path + ": " + reader.fault()->what);
    return scene;
}

Result<SceneDescription> read_scene_json(std::string_view text) {
    // The mark that some editors put before UTF-8 text.
    if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
    if (const auto fault = find_json_fault(text, *v1::Scene::descriptor())) return invalid(*fault);
    v1::Scene message;
    const auto parsed =
        google::protobuf::util::JsonStringToMessage({text.data(), text.size()}, &message);
    if (!parsed.ok()) return invalid(std::string(parsed.message()));
    Reader reader;
    SceneDescription scene = reader.scene(message);
    if (!reader.fault()) return scene;
    const int line = line_of(text, place_of(reader.fault()->path));
    return invalid((line > 0 ? "line " + std::to_string(line) + ": " : std::string()) +
                   reader.fault()->path + ": " + reader.fault()->what);
}

Result<SceneDescription> read_scene_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) return Error{ErrorCode::not_found, "cannot read the scene file " + path};
    std::string text;
    char buffer[65536];
    while (in.read(buffer, sizeof buffer) || in.gcount() > 0) {
        text.append(buffer, static_cast<std::size_t>(in.gcount()));
        if (text.size() > file_bytes_max)
            return invalid(path + ": larger than 64 MiB; that is no scene");
    }
    if (in.bad() || !in.eof())
        return Error{ErrorCode::not_found, "cannot read the scene file " + path};
    Result<SceneDescription> scene = read_scene_json(text);
    if (!scene.ok()) return Error{scene.error().code, path + ": " + scene.error().message};
    return scene;
}

v1::Scene to_message(const SceneDescription& scene) {
    v1::Scene out;
    out.set_name(scene.name);
    out.set_description(scene.description);
    *out.mutable_world()->mutable_gravity() = to_message(scene.world.gravity);
    out.mutable_world()->set_substeps(static_cast<std::uint32_t>(scene.world.substeps));
    out.mutable_world()->set_hz(scene.hz);
    out.mutable_world()->set_sleeping(scene.world.sleeping);
    for (const SceneBody& body : scene.bodies) write_body(*out.add_bodies(), body);
    return out;
}

std::string write_scene_json(const SceneDescription& scene) {
    google::protobuf::util::JsonPrintOptions options;
    options.add_whitespace = true;
    options.preserve_proto_field_names = true;
    std::string text;
    const auto written =
        google::protobuf::util::MessageToJsonString(to_message(scene), &text, options);
    return written.ok() ? text : std::string();
}

Result<SceneDescription> load_scene(const std::string& name_or_path) {
    if (auto scene = find_scene(name_or_path)) return std::move(*scene);
    const bool looks_like_path =
        name_or_path.find('/') != std::string::npos || name_or_path.find('.') != std::string::npos;
    if (looks_like_path) return read_scene_file(name_or_path);
    std::string names;
    for (const CatalogEntry& entry : catalog())
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    return Error{ErrorCode::not_found, "there is no scene \"" + name_or_path + "\"; there are " +
                                           names + ", or give the path of a scene file"};
}

}  // namespace jostle::scenes
