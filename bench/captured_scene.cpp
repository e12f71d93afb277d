// SPDX-License-Identifier: MIT
#include "bench/captured_scene.h"

#include <algorithm>

#include "bench/measure.h"
#include "jostle/scenes/catalog.h"
#include "jostle/snapshot/quantize.h"

namespace jostle::bench {
namespace {

Error unknown_scene(const std::string& name) {
    std::string message =
        "unknown scene \"" + name + "\"" + scenes::scene_suggestion(name) + "; must be one of";
    for (const auto& entry : scenes::catalog()) message += " " + std::string(entry.name);
    return {ErrorCode::not_found, message};
}

snapshot::QuantizedFrame quantized(std::uint32_t tick,
                                   const std::vector<physics::BodyState>& bodies,
                                   const snapshot::QuantSpec& spec) {
    snapshot::QuantizedFrame frame{.frame = tick, .entities = {}};
    frame.entities.reserve(bodies.size());
    for (const physics::BodyState& body : bodies) {
        const auto& [p, q] = body.pose;
        frame.entities.push_back(snapshot::quantize(
            body.id.index + 1, {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}}, !body.awake, spec));
    }
    return frame;
}

}  // namespace

Result<scenes::SceneDescription> find_scene_or_suggest(const std::string& name) {
    auto scene = scenes::find_scene(name);
    if (!scene) return unknown_scene(name);
    return *std::move(scene);
}

Result<CapturedScene> capture_scene(const std::string& name, double seconds,
                                    const snapshot::QuantSpec& spec) {
    const auto scene = find_scene_or_suggest(name);
    if (!scene.ok()) return scene.error();
    auto built = scenes::build_scene(*scene);
    if (!built) return Error{built.error().code, name + ": " + built.error().message};
    CapturedScene recorded{.frames = {}, .hz = scene->hz};
    std::vector<physics::BodyState> bodies;
    double spent = 0;
    std::size_t count = 0;
    const auto ticks = static_cast<std::uint32_t>(seconds * scene->hz);
    for (std::uint32_t tick = 1; tick <= ticks; tick++) {
        if (const auto status = built->world.step(1 / scene->hz); !status)
            return Error{status.error().code, name + ": " + status.error().message};
        built->world.copy_bodies(bodies);
        const double began = cpu_seconds();
        recorded.frames.push_back(quantized(tick, bodies, spec));
        spent += cpu_seconds() - began;
        count += bodies.size();
    }
    recorded.quantize_ns_per_body =
        spent * 1e9 / static_cast<double>(std::max<std::size_t>(count, 1));
    return recorded;
}

std::size_t count_moving(const snapshot::QuantizedFrame& now,
                         const snapshot::QuantizedFrame& base) {
    std::size_t moving = 0;
    for (std::size_t i = 0; i < now.entities.size(); i++)
        moving += snapshot::same_pose(now.entities[i], base.entities[i]) ? 0 : 1;
    return moving;
}

}  // namespace jostle::bench
