// SPDX-License-Identifier: MIT
#include "clients/cpp/prediction/wasm/predictor_api.h"

#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "clients/cpp/prediction/src/prediction_engine.h"
#include "clients/cpp/prediction/wasm/shape_encoding.h"
#include "jostle/modules/controlled_entity_state.h"

using namespace jostle;
using namespace jostle::client;
using physics::BodyType;
using physics::ShapeDef;
using physics::Vec3;

struct JostlePredictor {
    struct Known {
        BodyUpdate about;
        bool requested = false;
        std::optional<std::vector<ShapeDef>> shapes;  // hulls and meshes are built once
    };

    PredictionEngine engine{{}};
    std::map<std::uint32_t, Known> known;
    std::vector<double> numbers;
    std::vector<BodyUpdate> told;
    std::map<std::uint32_t, Velocity> motions;  // of the next frame
    ControlUpdate drive;
    std::vector<std::uint32_t> drive_words;
    std::uint32_t unusable = 0;

    const std::optional<std::vector<ShapeDef>>& shapes_of(std::uint32_t entity) {
        Known& body = known.at(entity);
        if (!std::exchange(body.requested, true)) {
            jostle_predictor_request_shapes(this, entity);
            unusable += body.shapes ? 0 : 1;
        }
        return body.shapes;
    }
};

namespace {

constexpr std::uint32_t longest_tag = 32;
constexpr std::uint32_t numbers_max = 1u << 24;
constexpr std::size_t numbers_per_body = 9, numbers_per_drawn = 8, numbers_per_motion = 7;

bool has(const JostlePredictor& p, std::size_t bodies, std::size_t each) {
    return bodies <= p.numbers.size() / each;
}

bool is_entity(double number) {
    return number >= 1 && number <= 4294967295.0;
}

snapshot::Pose pose_at(const double* n) {
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5], n[6]}};
}

void action(JostlePredictor* p, std::uint32_t sequence, std::uint32_t tick, InputAction what) {
    p->engine.add_action(sequence, tick, std::move(what));
}

}  // namespace

JostlePredictor* jostle_predictor_create() {
    return new JostlePredictor;
}

void jostle_predictor_destroy(JostlePredictor* p) {
    delete p;
}

double* jostle_predictor_buffer(JostlePredictor* p, uint32_t count) {
    if (count > numbers_max) return nullptr;
    p->numbers.resize(count);
    return p->numbers.data();
}

void jostle_predictor_begin(JostlePredictor* p, double tick_hz, double x, double y, double z,
                            uint32_t substeps) {
    p->drive = {};
    p->known.clear();
    p->unusable = 0;
    p->engine.follow(0);
    p->engine.begin({x, y, z}, tick_hz, static_cast<int>(substeps < 65 ? substeps : 0));
}

void jostle_predictor_add_body(JostlePredictor* p, uint32_t entity, uint32_t type, double mass) {
    const BodyType kind = type == 2   ? BodyType::dynamic
                          : type == 1 ? BodyType::kinematic
                                      : BodyType::static_body;
    p->known.insert_or_assign(
        entity, JostlePredictor::Known{{.entity = entity, .type = kind, .mass = mass}, false, {}});
}

void jostle_predictor_set_body(JostlePredictor* p, uint32_t entity, double linear_damping,
                               double angular_damping, double gravity_scale, uint32_t locks,
                               uint32_t moved_by) {
    const auto body = p->known.find(entity);
    if (body == p->known.end()) return;
    BodyUpdate& about = body->second.about;
    about.linear_damping = linear_damping;
    about.angular_damping = angular_damping;
    about.gravity_scale = gravity_scale;
    about.locks = static_cast<physics::AxisLocks>(locks & 63);
    about.controllable = (moved_by & 1) != 0;
    about.jointed = (moved_by & 2) != 0;
}

void jostle_predictor_remove_body(JostlePredictor* p, uint32_t entity) {
    p->known.erase(entity);
}

uint32_t jostle_predictor_set_shapes(JostlePredictor* p, uint32_t entity, uint32_t count) {
    const auto body = p->known.find(entity);
    if (body == p->known.end() || !has(*p, count, 1)) return 0;
    body->second.requested = true;
    body->second.shapes = decode_shapes(std::span(p->numbers).first(count));
    return body->second.shapes ? 1 : 0;
}

void jostle_predictor_follow(JostlePredictor* p, uint32_t entity) {
    p->engine.follow(entity);
}

void jostle_predictor_push(JostlePredictor* p, uint32_t sequence, uint32_t tick, uint32_t entity,
                           double x, double y, double z) {
    action(p, sequence, tick, Push{entity, {x, y, z}, std::nullopt});
}

void jostle_predictor_push_at(JostlePredictor* p, uint32_t sequence, uint32_t tick, uint32_t entity,
                              double x, double y, double z, double point_x, double point_y,
                              double point_z) {
    action(p, sequence, tick, Push{entity, {x, y, z}, Vec3{point_x, point_y, point_z}});
}

void jostle_predictor_grab(JostlePredictor* p, uint32_t sequence, uint32_t tick, uint32_t entity,
                           double x, double y, double z) {
    action(p, sequence, tick, Grab{entity, {x, y, z}});
}

void jostle_predictor_drag(JostlePredictor* p, uint32_t sequence, uint32_t tick, double x, double y,
                           double z) {
    action(p, sequence, tick, Drag{{x, y, z}});
}

void jostle_predictor_release(JostlePredictor* p, uint32_t sequence, uint32_t tick) {
    action(p, sequence, tick, Release{});
}

void jostle_predictor_steer(JostlePredictor* p, uint32_t sequence, uint32_t tick, uint32_t axes,
                            uint32_t buttons) {
    physics::Controls controls;
    if (axes > controls.axes.size() || !has(*p, axes, 1)) return;
    for (std::size_t k = 0; k < axes; k++) {
        if (!(p->numbers[k] >= -1 && p->numbers[k] <= 1)) return;
        controls.axes[k] = p->numbers[k];
    }
    controls.buttons = buttons;
    action(p, sequence, tick, Steer{controls});
}

void jostle_predictor_result(JostlePredictor* p, uint32_t sequence, uint32_t tick,
                             uint32_t applied) {
    p->engine.on_result(sequence, tick, applied != 0);
}

uint32_t jostle_predictor_velocities(JostlePredictor* p, uint32_t bodies) {
    p->motions.clear();
    if (!has(*p, bodies, numbers_per_motion)) return 0;
    std::map<std::uint32_t, Velocity> motions;
    for (std::size_t k = 0; k < bodies; k++) {
        const double* n = p->numbers.data() + k * numbers_per_motion;
        if (!is_entity(n[0])) return 0;
        for (std::size_t v = 1; v < numbers_per_motion; v++)
            if (!(n[v] >= -2147483648.0 && n[v] < 2147483648.0)) return 0;
        motions[static_cast<std::uint32_t>(n[0])] = {Vec3{n[1], n[2], n[3]} * (1 / velocity_units),
                                                     Vec3{n[4], n[5], n[6]} * (1 / velocity_units)};
    }
    p->motions = std::move(motions);
    return 1;
}

uint32_t jostle_predictor_control(JostlePredictor* p, uint32_t entity, uint32_t tick,
                                  uint32_t letters, uint32_t words) {
    p->drive = {};
    if (letters > longest_tag || words > modules::controlled_entity_words_max) return 0;
    if (!has(*p, letters + words, 1)) return 0;
    std::string module;
    p->drive_words.clear();
    for (std::size_t k = 0; k < letters + words; k++) {
        const double n = p->numbers[k];
        if (!(n >= 0 && n <= (k < letters ? 127 : 4294967295.0))) return 0;
        if (k < letters)
            module.push_back(static_cast<char>(n));
        else
            p->drive_words.push_back(static_cast<std::uint32_t>(n));
    }
    p->drive = {entity, tick, std::move(module), p->drive_words};
    return 1;
}

uint32_t jostle_predictor_frame(JostlePredictor* p, uint32_t number, uint32_t bodies) {
    const std::map<std::uint32_t, Velocity> motions = std::exchange(p->motions, {});
    if (!has(*p, bodies, numbers_per_body)) return 0;
    p->told.clear();
    for (std::size_t k = 0; k < bodies; k++) {
        const double* n = p->numbers.data() + k * numbers_per_body;
        const auto entity = is_entity(n[0]) ? static_cast<std::uint32_t>(n[0]) : 0;
        const auto about = p->known.find(entity);
        if (about == p->known.end()) continue;
        if (!p->told.empty() && p->told.back().entity >= entity) return 0;
        const auto motion = motions.find(entity);
        BodyUpdate& body = p->told.emplace_back(about->second.about);
        body.pose = to_transform(pose_at(n + 1));
        body.at_rest = n[8] != 0;
        if (motion != motions.end()) body.velocity = motion->second;
    }
    p->engine.on_frame({.number = number,
                        .bodies = p->told,
                        .shapes_of = [p](auto entity) { return p->shapes_of(entity); },
                        .control = p->drive});
    return 1;
}

uint32_t jostle_predictor_predicted(JostlePredictor* p) {
    const std::vector<std::uint32_t> drawn = p->engine.predicted_entities();
    p->numbers.assign(drawn.begin(), drawn.end());
    return static_cast<uint32_t>(drawn.size());
}

uint32_t jostle_predictor_sample(JostlePredictor* p, double position, double now_us,
                                 uint32_t bodies) {
    if (!has(*p, bodies, numbers_per_drawn)) return 0;
    if (!(now_us >= 0 && now_us < 9e15 && position >= 0 && position < 4294967295.0)) return 0;
    std::vector<SmoothPose> poses;
    for (std::size_t k = 0; k < bodies; k++) {
        const double* n = p->numbers.data() + k * numbers_per_drawn;
        if (!is_entity(n[0])) return 0;
        poses.push_back({static_cast<std::uint32_t>(n[0]), pose_at(n + 1)});
    }
    poses = p->engine.sample(position, static_cast<std::int64_t>(now_us), std::move(poses));
    double* n = p->numbers.data();
    for (const SmoothPose& drawn : poses) {
        *n++ = drawn.entity;
        for (const double c : drawn.pose.position) *n++ = c;
        for (const double c : drawn.pose.rotation) *n++ = c;
    }
    return bodies;
}

double jostle_predictor_stat(const JostlePredictor* p, uint32_t which) {
    const PredictorStats& stats = p->engine.stats();
    const double figures[] = {static_cast<double>(stats.frames),
                              static_cast<double>(stats.corrections),
                              static_cast<double>(stats.steps),
                              stats.last_error_m,
                              static_cast<double>(p->engine.bodies()),
                              static_cast<double>(p->unusable),
                              static_cast<double>(stats.control_updates),
                              static_cast<double>(stats.control_corrections),
                              stats.last_control_error_m};
    return which < std::size(figures) ? figures[which] : 0;
}
