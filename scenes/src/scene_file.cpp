// SPDX-License-Identifier: MIT
#include "jostle/scenes/scene_file.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/type_resolver.h>
#include <google/protobuf/util/type_resolver_util.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

#include "jostle/physics/limits.h"
#include "jostle/scenes/catalog.h"
#include "jostle/scenes/locks_message.h"
#include "jostle/scenes/shape_message.h"
#include "jostle/v1/scene.pb.h"
#include "scenes/src/joint_message.h"
#include "scenes/src/json_path.h"
#include "scenes/src/module_message.h"
#include "scenes/src/scene_json.h"
#include "scenes/src/shape_reader.h"

namespace jostle::scenes {

using namespace physics;

namespace {

constexpr std::size_t bodies_max = 200000;  // after repeats
constexpr std::size_t shapes_max = 64;      // of one body
// A short file can create many shapes by repeats, so their total is limited.
constexpr std::size_t all_shapes_max = 400000;
constexpr std::size_t name_bytes_max = 64;
constexpr std::size_t description_bytes_max = 1000;
constexpr std::uint32_t repeat_max = 100000;
constexpr std::size_t file_bytes_max = 64u << 20;
constexpr double view_length_min = 0.01;  // m

// Reads one message and stores its errors.
class Reader : public FieldReader {
public:
    SceneDescription scene(const v1::Scene& m) {
        SceneDescription out{.name = m.name(), .description = m.description()};
        if (m.name().empty() || m.name().size() > name_bytes_max)
            report_error("name", "must be a string of 1 to 64 bytes");
        if (m.description().size() > description_bytes_max)
            report_error("description", "must be a string of at most 1000 bytes");
        world(out, m.world());
        if (m.has_view()) out.view = view(m.view());
        const auto each = [&](int count, const auto& read) {
            for (int i = 0; i < count && !full(); i++) {
                begin_item();
                read(i, "[" + std::to_string(i) + "]");
            }
        };
        each(m.bodies_size(),
             [&](int i, const std::string& at) { body(out, m.bodies(i), "bodies" + at); });
        // Joints and modules name bodies, of which those with errors are missing.
        if (!errors().empty()) return out;
        each(m.joints_size(), [&](int i, const std::string& at) {
            read_joint(*this, out, "joints" + at, m.joints(i));
        });
        each(m.modules_size(), [&](int i, const std::string& at) {
            read_module(*this, out, "modules" + at, m.modules(i));
        });
        return out;
    }

private:
    void world(SceneDescription& out, const v1::WorldSettings& m) {
        if (m.has_gravity()) out.world.gravity = vector("world.gravity", m.gravity(), 1000);
        if (m.has_substeps())
            out.world.substeps =
                static_cast<int>(number("world.substeps", m.substeps(), 1, limits::max_substeps));
        if (m.has_hz()) out.hz = number("world.hz", m.hz(), 4, 1000);
        if (m.has_sleeping()) out.world.sleeping = m.sleeping();
        if (m.has_continuous()) out.world.continuous = m.continuous();
        out.world.planar = m.planar();
        out.world.broad_phase = broad_phase(m.broad_phase());
        if (m.has_hit_speed())
            out.world.hit_speed = number("world.hit_speed", m.hit_speed(), 0, 1e6);
        if (m.tolerance() != 0)
            out.world.tolerance = number("world.tolerance", m.tolerance(), 1e-9, 1e3);
        out.world.substep_budget = m.substep_budget();
        out.world.step_budget = m.step_budget();
        if (m.has_precision()) {
            const v1::Precision& precision = m.precision();
            out.precision.position =
                number("world.precision.position", precision.position(), 1e-4, 1);
            out.precision.rotation =
                number("world.precision.rotation", precision.rotation(), 2e-4, 0.5);
            if (precision.far_factor() != 0)
                out.precision.far_factor =
                    number("world.precision.far_factor", precision.far_factor(), 1, 1000);
        }
        if (const auto solver = read_solver(*this, "world.joint_solver", m.joint_solver()))
            out.world.joint_solver = *solver;
    }

    SceneView view(const v1::View& m) {
        SceneView out{vector("view.eye", m.eye(), limits::max_coordinate),
                      vector("view.target", m.target(), limits::max_coordinate)};
        if (length(out.target - out.eye) < view_length_min)
            report_error("view.target", "must be at least 0.01 m from view.eye");
        if (m.field_of_view() != 0)
            out.field_of_view = number("view.field_of_view", m.field_of_view(), 0.1, 2.5);
        return out;
    }

    BroadPhase broad_phase(v1::BroadPhase kind) {
        switch (kind) {
            case v1::BROAD_PHASE_UNSPECIFIED:
            case v1::BROAD_PHASE_DYNAMIC_TREE:
                return BroadPhase::dynamic_tree;
            case v1::BROAD_PHASE_SORT_AND_SWEEP:
                return BroadPhase::sort_and_sweep;
            case v1::BROAD_PHASE_UNIFORM_GRID:
                return BroadPhase::uniform_grid;
            default:
                report_error("world.broad_phase", "is not a valid broad phase");
        }
        return BroadPhase::dynamic_tree;
    }

    void shape(SceneBody& out, const v1::Shape& m, const std::string& path) {
        const ShapeDef def = read_shape(*this, path, m);
        const bool surface = m.has_mesh() || m.has_height_field();
        if (m.has_plane() && out.body.type != BodyType::static_body)
            report_error(path + ".plane",
                         "is infinite; only a body of type BODY_TYPE_STATIC may have a plane");
        if (surface && out.body.type == BodyType::dynamic)
            report_error(path,
                         "is a surface without mass; use hulls or a compound for a dynamic body");
        out.shapes.push_back(def);
    }

    void body(SceneDescription& scene, const v1::Body& m, const std::string& path) {
        const std::size_t errors_before = errors().size();
        if (m.name().size() > name_bytes_max)
            report_error(path + ".name", "must be a string of at most 64 bytes");
        SceneBody out{.name = m.name(), .body = {}, .shapes = {}, .color = {}};
        switch (m.type()) {
            case v1::BODY_TYPE_STATIC:
                out.body.type = BodyType::static_body;
                break;
            case v1::BODY_TYPE_KINEMATIC:
                out.body.type = BodyType::kinematic;
                break;
            case v1::BODY_TYPE_UNSPECIFIED:
            case v1::BODY_TYPE_DYNAMIC:
                break;
            default:
                report_error(path + ".type", "is not a body type");
        }
        BodyDef& b = out.body;
        b.pose = {vector(path + ".position", m.position(), limits::max_coordinate),
                  rotation(path + ".rotation", m.has_rotation(), m.rotation())};
        b.linear_velocity =
            vector(path + ".linear_velocity", m.linear_velocity(), limits::max_speed);
        b.angular_velocity =
            vector(path + ".angular_velocity", m.angular_velocity(), limits::max_speed);
        const bool moves = !(b.linear_velocity == Vec3{}) || !(b.angular_velocity == Vec3{});
        if (b.type == BodyType::static_body && moves)
            report_error(
                path + ".type",
                "is BODY_TYPE_STATIC but the body has a velocity; use BODY_TYPE_KINEMATIC");
        if (m.has_linear_damping())
            b.linear_damping = number(path + ".linear_damping", m.linear_damping(), 0, 1e4);
        if (m.has_angular_damping())
            b.angular_damping = number(path + ".angular_damping", m.angular_damping(), 0, 1e4);
        if (m.has_gravity_scale())
            b.gravity_scale = number(path + ".gravity_scale", m.gravity_scale(), -1e3, 1e3);
        if (m.has_may_sleep()) b.sleep_allowed = m.may_sleep();
        if (m.has_continuous()) b.continuous = m.continuous();
        if (m.has_mass())
            b.mass = number(path + ".mass", m.mass(), limits::min_mass, limits::max_mass);
        b.locks = locks_of(m.locks());
        if (m.has_color())
            out.color = static_cast<std::uint32_t>(number(path + ".color", m.color(), 0, 0xffffff));
        if (m.shapes_size() == 0)
            report_error(path + ".shapes", "is empty; it must have at least one shape");
        if (static_cast<std::size_t>(m.shapes_size()) > shapes_max)
            report_error(path + ".shapes",
                         "has more than " + std::to_string(shapes_max) + " shapes");
        const int shapes = std::min(m.shapes_size(), static_cast<int>(shapes_max));
        for (int i = 0; i < shapes && !full(); i++) {
            begin_item();
            shape(out, m.shapes(i), path + ".shapes[" + std::to_string(i) + "]");
        }
        begin_item_at(errors_before);
        add_copies(scene, out, m, path);
    }

    // Each repeat multiplies the copies created so far.
    void add_copies(SceneDescription& scene, const SceneBody& body, const v1::Body& m,
                    const std::string& path) {
        std::vector<Vec3> offsets{{}};
        for (int i = 0; i < m.repeat_size() && !failed(); i++) {
            const std::string at = path + ".repeat[" + std::to_string(i) + "]";
            const auto count =
                static_cast<std::size_t>(number(at + ".count", m.repeat(i).count(), 1, repeat_max));
            const Vec3 step = vector(at + ".offset", m.repeat(i).offset(), 1e6);
            if (failed()) return;
            if (offsets.size() * count > bodies_max)
                return report_error(at + ".count",
                                    "creates more than " + std::to_string(bodies_max) + " bodies");
            std::vector<Vec3> all;
            all.reserve(offsets.size() * count);
            for (std::size_t k = 0; k < count; k++)
                for (const Vec3 offset : offsets)
                    all.push_back(offset + step * static_cast<double>(k));
            offsets = std::move(all);
        }
        if (failed()) return;
        if (scene.bodies.size() + offsets.size() > bodies_max)
            return report_error(
                path, "creates more than " + std::to_string(bodies_max) + " bodies in total");
        shapes_ += offsets.size() * body.shapes.size();
        if (shapes_ > all_shapes_max)
            return report_error(
                path, "creates more than " + std::to_string(all_shapes_max) + " shapes in total");
        for (const Vec3 offset : offsets) {
            scene.bodies.push_back(body);
            scene.bodies.back().body.pose.position += offset;
        }
    }

    std::size_t shapes_ = 0;  // after repeats
};

void write_body(v1::Body& out, const SceneBody& body) {
    const BodyDef& b = body.body;
    out.set_name(body.name);
    out.set_type(b.type == BodyType::static_body ? v1::BODY_TYPE_STATIC
                 : b.type == BodyType::kinematic ? v1::BODY_TYPE_KINEMATIC
                                                 : v1::BODY_TYPE_DYNAMIC);
    set(*out.mutable_position(), b.pose.position);
    if (!(b.pose.rotation == Quat{})) set(*out.mutable_rotation(), b.pose.rotation);
    if (!(b.linear_velocity == Vec3{})) set(*out.mutable_linear_velocity(), b.linear_velocity);
    if (!(b.angular_velocity == Vec3{})) set(*out.mutable_angular_velocity(), b.angular_velocity);
    if (b.linear_damping != 0) out.set_linear_damping(b.linear_damping);
    if (b.angular_damping != 0) out.set_angular_damping(b.angular_damping);
    if (b.gravity_scale != 1) out.set_gravity_scale(b.gravity_scale);
    if (!b.sleep_allowed) out.set_may_sleep(false);
    if (!b.continuous) out.set_continuous(false);
    if (b.mass > 0) out.set_mass(b.mass);
    if (b.locks != 0) *out.mutable_locks() = locks_message(b.locks);
    if (body.color) out.set_color(*body.color);
    for (const ShapeDef& def : body.shapes) write_shape(*out.add_shapes(), def);
}

}  // namespace

Result<SceneDescription> from_message(const v1::Scene& message) {
    Reader reader;
    SceneDescription scene = reader.scene(message);
    // Servers validate it.
    if (message.has_room()) scene.room = message.room().SerializeAsString();
    if (reader.errors().empty()) return scene;
    ErrorLines lines;
    for (const FieldError& error : reader.errors()) lines.add(error.path + ": " + error.what);
    return invalid_argument(lines.text());
}

Status read_json_message(std::string_view text, google::protobuf::Message& message) {
    if (const auto errors = find_json_errors(text, *message.GetDescriptor()))
        return invalid_argument(*errors);
    google::protobuf::util::JsonParseOptions options;
    options.ignore_unknown_fields = true;  // "$schema"; all others were found above
    const auto parsed =
        google::protobuf::util::JsonStringToMessage({text.data(), text.size()}, &message, options);
    return parsed.ok() ? Status{} : invalid_argument(std::string(parsed.message()));
}

std::string with_positions(std::string_view text, const std::string& parent,
                           const std::string& errors) {
    std::istringstream lines(errors);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        std::string path = line.substr(0, line.find(": "));
        // Modules have no repeats, so their index in the world is that in the text.
        if (path.starts_with("modules[")) path = path.substr(0, path.find(" '"));
        const JsonPath steps = parse_json_path(parent + path);
        const std::string position = position_of(text, steps);
        out += (out.empty() ? "" : "\n") + position + (position.empty() ? "" : parent) + line;
    }
    return out;
}

Result<SceneDescription> read_scene_json(std::string_view text) {
    // The byte order mark that some editors write before UTF-8 text.
    if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
    v1::Scene message;
    if (Status s = read_json_message(text, message); !s.ok()) return s.error();
    Result<SceneDescription> scene = from_message(message);
    if (scene.ok()) return scene;
    return invalid_argument(with_positions(text, "", scene.error().message));
}

Result<SceneDescription> read_scene_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) return Error{ErrorCode::not_found, "cannot read scene file " + path};
    std::string text;
    char buffer[65536];
    while (in.read(buffer, sizeof buffer) || in.gcount() > 0) {
        text.append(buffer, static_cast<std::size_t>(in.gcount()));
        if (text.size() > file_bytes_max)
            return invalid_argument(
                path + ": file is larger than 64 MiB, the maximum size of a scene file");
    }
    if (in.bad() || !in.eof()) return Error{ErrorCode::not_found, "cannot read scene file " + path};
    Result<SceneDescription> scene = read_scene_json(text);
    if (scene.ok()) return scene;
    std::string message = path + ": " + scene.error().message;
    for (std::size_t at = 0; (at = message.find('\n', at)) != std::string::npos; at += path.size())
        message.insert(at + 1, path + ": ");
    return Error{scene.error().code, message};
}

v1::Scene to_message(const SceneDescription& scene) {
    v1::Scene out;
    out.set_name(scene.name);
    out.set_description(scene.description);
    set(*out.mutable_world()->mutable_gravity(), scene.world.gravity);
    if (scene.world.planar) out.mutable_world()->set_planar(true);
    if (!scene.world.continuous) out.mutable_world()->set_continuous(false);
    if (scene.world.broad_phase == BroadPhase::sort_and_sweep)
        out.mutable_world()->set_broad_phase(v1::BROAD_PHASE_SORT_AND_SWEEP);
    if (scene.world.broad_phase == BroadPhase::uniform_grid)
        out.mutable_world()->set_broad_phase(v1::BROAD_PHASE_UNIFORM_GRID);
    out.mutable_world()->set_hit_speed(scene.world.hit_speed);
    if (scene.world.tolerance != 0) out.mutable_world()->set_tolerance(scene.world.tolerance);
    if (scene.world.substep_budget != 0)
        out.mutable_world()->set_substep_budget(
            static_cast<std::uint32_t>(scene.world.substep_budget));
    if (scene.world.step_budget != 0)
        out.mutable_world()->set_step_budget(static_cast<std::uint32_t>(scene.world.step_budget));
    if (scene.world.joint_solver != JointSolver::automatic)
        out.mutable_world()->set_joint_solver(message_of(scene.world.joint_solver));
    out.mutable_world()->set_substeps(static_cast<std::uint32_t>(scene.world.substeps));
    out.mutable_world()->set_hz(scene.hz);
    out.mutable_world()->set_sleeping(scene.world.sleeping);
    if (scene.precision.position != 0) {
        v1::Precision& precision = *out.mutable_world()->mutable_precision();
        precision.set_position(scene.precision.position);
        precision.set_rotation(scene.precision.rotation);
        precision.set_far_factor(scene.precision.far_factor);
    }
    if (scene.view) {
        v1::View& view = *out.mutable_view();
        set(*view.mutable_eye(), scene.view->eye);
        set(*view.mutable_target(), scene.view->target);
        view.set_field_of_view(scene.view->field_of_view);
    }
    for (const SceneBody& body : scene.bodies) write_body(*out.add_bodies(), body);
    for (const SceneJoint& joint : scene.joints) write_joint(*out.add_joints(), scene, joint);
    for (const SceneModule& module : scene.modules) write_module(*out.add_modules(), scene, module);
    if (!scene.room.empty()) out.mutable_room()->ParseFromString(scene.room);
    return out;
}

// Deterministic: the printer of protobuf writes the keys of maps in hash order.
std::string write_scene_json(const SceneDescription& scene) {
    namespace pb = google::protobuf;
    std::string bytes;
    {
        pb::io::StringOutputStream stream(&bytes);
        pb::io::CodedOutputStream out(&stream);
        out.SetSerializationDeterministic(true);
        to_message(scene).SerializeToCodedStream(&out);
    }
    pb::util::JsonPrintOptions options;
    options.add_whitespace = true;
    options.preserve_proto_field_names = true;
    const std::string types = "type.googleapis.com";
    const std::unique_ptr<pb::util::TypeResolver> resolver(
        pb::util::NewTypeResolverForDescriptorPool(types, pb::DescriptorPool::generated_pool()));
    std::string text;
    const auto written = pb::util::BinaryToJsonString(
        resolver.get(), types + "/" + v1::Scene::descriptor()->full_name(), bytes, &text, options);
    return written.ok() ? text : std::string();
}

Result<SceneDescription> load_scene(const std::string& name_or_path) {
    if (auto scene = find_scene(name_or_path)) return std::move(*scene);
    const bool looks_like_path =
        name_or_path.find('/') != std::string::npos || name_or_path.find('.') != std::string::npos;
    if (looks_like_path) return read_scene_file(name_or_path);
    const std::string near = scene_suggestion(name_or_path);
    if (!near.empty())
        return Error{ErrorCode::not_found, "unknown scene \"" + name_or_path + "\"" + near};
    std::string names;
    for (const CatalogEntry& entry : catalog())
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    return Error{ErrorCode::not_found, "unknown scene \"" + name_or_path + "\"; must be one of " +
                                           names + ", or the path of a scene file"};
}

}  // namespace jostle::scenes
