// SPDX-License-Identifier: MIT
#include "jostle/modules/turbulence.h"

#include "modules/fields/src/curl_noise.h"

namespace jostle::modules {

using namespace physics;

Vec3 flow_at(const Turbulence& t, Vec3 point, double time) {
    if (t.speed == 0) return t.wind;
    const fields_detail::CurlNoise noise{.seed = t.seed, .octaves = t.octaves};
    return t.wind +
           fields_detail::curl_noise(noise, point * (1 / t.scale), time * t.rate) * t.speed;
}

}  // namespace jostle::modules
