// SPDX-License-Identifier: MIT
#include "jostle/modules/turbulence.h"

#include "jostle/modules/curl_noise.h"

namespace jostle::modules {

using namespace physics;

Vec3 flow_at(const Turbulence& t, Vec3 point, double time) {
    if (t.speed == 0) return t.wind;
    const CurlNoise noise{.seed = t.seed, .octaves = t.octaves};
    return t.wind + curl_noise(noise, point * (1 / t.scale), time * t.rate) * t.speed;
}

}  // namespace jostle::modules
