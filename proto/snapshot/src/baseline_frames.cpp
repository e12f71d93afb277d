// SPDX-License-Identifier: MIT
#include "jostle/snapshot/baseline_frames.h"

#include <string>

namespace jostle::snapshot {
namespace {

constexpr std::uint32_t no_baseline = 255, same_distance = 0;

}  // namespace

BaselineFrames predictable(std::uint32_t frame, const BaselineFrames& baselines,
                           const QuantSpec& spec) {
    constexpr std::int32_t exact_at_any_spacing = 511;
    constexpr std::uint32_t ratio_max = 50;
    if (baselines.baseline2 == 0 || spec.rotation_component <= exact_at_any_spacing ||
        frame - baselines.baseline <= ratio_max * (baselines.baseline - baselines.baseline2))
        return baselines;
    return {.baseline = baselines.baseline};
}

std::uint32_t encode_baseline_frames(std::uint32_t frame, const BaselineFrames& baselines) {
    if (baselines.baseline == 0) return 0;
    const std::uint32_t first = frame - baselines.baseline;
    const auto later = [](std::uint32_t from, std::uint32_t to, std::uint32_t usual) {
        if (to == 0) return no_baseline;
        return from - to == usual ? same_distance : from - to;
    };
    const std::uint32_t second = later(baselines.baseline, baselines.baseline2, first);
    if (baselines.baseline2 == 0) return first | second << 8;
    return first | second << 8 |
           later(baselines.baseline2, baselines.baseline3, baselines.baseline - baselines.baseline2)
               << 16;
}

Result<BaselineFrames> decode_baseline_frames(std::uint32_t frame, std::uint32_t code) {
    const auto refuse = [&](const char* reason) {
        return Error{ErrorCode::corrupt_data, "frame " + std::to_string(frame) + ": baselines " +
                                                  std::to_string(code) + reason};
    };
    BaselineFrames baselines;
    if (code == 0) return baselines;
    std::uint32_t distance = code & 255, second = code >> 8 & 255, third = code >> 16;
    if (distance == same_distance || distance == no_baseline || third > no_baseline)
        return refuse(" have a distance out of range; must be 1 to 254");
    if (distance >= frame) return refuse(" are before the first frame");
    baselines.baseline = frame - distance;
    if (second == no_baseline) {
        if (third != 0) return refuse(" have baseline3 without baseline2");
        return baselines;
    }
    distance = second == same_distance ? distance : second;
    if (distance >= baselines.baseline) return refuse(" are before the first frame");
    baselines.baseline2 = baselines.baseline - distance;
    if (third == no_baseline) return baselines;
    distance = third == same_distance ? distance : third;
    if (distance >= baselines.baseline2) return refuse(" are before the first frame");
    baselines.baseline3 = baselines.baseline2 - distance;
    return baselines;
}

}  // namespace jostle::snapshot
