// SPDX-License-Identifier: MIT
#include "bench/network/precise_frames.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "bench/captured_scene.h"
#include "bench/measure.h"
#include "jostle/scenes/catalog.h"
#include "jostle/snapshot/frame_codec.h"

namespace jostle::bench {
namespace {

using snapshot::Pose;

struct TrueFrame {
    snapshot::QuantizedFrame quantized;
    std::vector<Pose> poses;
};

// Angle of the rotation between two rotations; that of a scene may not have unit length.
double angle_between(const std::array<double, 4>& a, const std::array<double, 4>& b) {
    double same = 0, opposite = 0, length = 0;
    for (std::size_t k = 0; k < 4; k++) length += b[k] * b[k];
    for (std::size_t k = 0; k < 4; k++) {
        const double unit = b[k] / std::sqrt(length);
        same += (a[k] - unit) * (a[k] - unit);
        opposite += (a[k] + unit) * (a[k] + unit);
    }
    return 4 * std::asin(std::sqrt(std::min(same, opposite)) / 2);
}

void measure_errors(PreciseResult& result, const snapshot::QuantizedFrame& decoded,
                    const std::vector<Pose>& truth, const snapshot::QuantSpec& spec) {
    for (std::size_t i = 0; i < truth.size(); i++) {
        const Pose pose = snapshot::dequantize(decoded.entities[i], spec);
        double squared = 0;
        for (std::size_t k = 0; k < 3; k++) {
            const double off = pose.position[k] - truth[i].position[k];
            squared += off * off;
        }
        result.position_error_m = std::max(result.position_error_m, std::sqrt(squared));
        result.rotation_error_rad =
            std::max(result.rotation_error_rad, angle_between(pose.rotation, truth[i].rotation));
    }
}

// Quantizes a frame that follows `sent`, the frames before it with the newest first.
TrueFrame next_frame(std::uint32_t tick, const std::vector<physics::BodyState>& bodies,
                     const std::deque<TrueFrame>& sent, const PreciseFrames& settings,
                     const snapshot::QuantSpec& spec, std::uint32_t stride) {
    TrueFrame frame;
    frame.quantized.frame = tick;
    for (std::size_t i = 0; i < bodies.size(); i++) {
        const auto& [p, q] = bodies[i].pose;
        const Pose pose{{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}};
        snapshot::SentMotion motion;
        motion.spacing = {stride, stride, stride};
        if (!sent.empty()) {
            motion.last = &sent[0].quantized.entities[i];
            motion.last_pose = &sent[0].poses[i];
        }
        if (sent.size() > 1) motion.before_last = &sent[1].quantized.entities[i];
        const std::uint32_t id = bodies[i].id.index + 1;
        const bool at_rest = !bodies[i].awake;
        frame.quantized.entities.push_back(
            settings.precision.is_set()
                ? snapshot::quantize_within(settings.precision, id, pose, at_rest, motion, spec)
                : snapshot::quantize(id, pose, at_rest, spec));
        frame.poses.push_back(pose);
    }
    return frame;
}

Status check_precision(const PreciseResult& result, const PreciseFrames& settings) {
    // The error of the arithmetic itself.
    constexpr double rounding = 1e-9;
    if (!settings.precision.is_set() ||
        (result.position_error_m <= settings.precision.position_m + rounding &&
         result.rotation_error_rad <= settings.precision.rotation_rad + rounding))
        return {};
    return Error{ErrorCode::corrupt_data,
                 settings.scene + ": a decoded pose exceeds the precision"};
}

}  // namespace

Result<PreciseResult> measure_precise_frames(const PreciseFrames& settings) {
    auto scene = find_scene_or_suggest(settings.scene);
    if (!scene.ok()) return scene.error();
    auto built = scenes::build_scene(*scene);
    if (!built) return Error{built.error().code, settings.scene + ": " + built.error().message};
    const snapshot::QuantSpec spec = snapshot::quant_spec_for(settings.precision);
    const auto stride = static_cast<std::uint32_t>(std::lround(scene->hz / settings.updates_hz));
    const auto first = static_cast<std::uint32_t>(settings.settle_seconds * scene->hz);
    const auto last = first + static_cast<std::uint32_t>(settings.seconds * scene->hz);
    PreciseResult result;
    std::deque<TrueFrame> sent;  // the newest first; at most three
    std::vector<physics::BodyState> bodies;
    for (std::uint32_t tick = 1; tick <= last; tick++) {
        if (const auto status = built->world.step(1 / scene->hz); !status)
            return Error{status.error().code, settings.scene + ": " + status.error().message};
        if (tick % stride != 0 || tick + 3 * stride < first) continue;
        built->world.copy_bodies(bodies);
        const double began = cpu_seconds();
        TrueFrame frame = next_frame(tick, bodies, sent, settings, spec, stride);
        if (sent.size() == 3 && tick > first) {
            const snapshot::Baselines baselines{&sent[0].quantized, &sent[1].quantized,
                                                &sent[2].quantized};
            const auto packed =
                snapshot::encode_frame(frame.quantized, baselines, spec, snapshot::newest_codec);
            const double encoded = cpu_seconds();
            const auto decoded =
                snapshot::decode_frame(tick, packed, baselines, spec,
                                       snapshot::default_entities_max, snapshot::newest_codec);
            result.decode_us += 1e6 * (cpu_seconds() - encoded);
            result.encode_us += 1e6 * (encoded - began);
            if (!decoded.ok() || *decoded != frame.quantized)
                return Error{ErrorCode::corrupt_data,
                             settings.scene + ": a decoded frame differs from the original"};
            result.bytes.push_back(static_cast<double>(packed.size()));
            result.moving += static_cast<double>(count_moving(frame.quantized, sent[0].quantized));
            measure_errors(result, *decoded, frame.poses, spec);
        }
        sent.push_front(std::move(frame));
        if (sent.size() > 3) sent.pop_back();
    }
    if (result.bytes.empty()) return result;
    const auto frames = static_cast<double>(result.bytes.size());
    result.moving /= frames;
    result.encode_us /= frames;
    result.decode_us /= frames;
    if (Status s = check_precision(result, settings); !s.ok()) return s.error();
    return result;
}

}  // namespace jostle::bench
