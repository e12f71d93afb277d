// SPDX-License-Identifier: MIT
#include "modules/fields/src/curl_noise.h"

#include <cmath>

namespace jostle::modules::fields_detail {

using namespace physics;

namespace {

// Root mean square of one octave of one lattice: sqrt of the mean over the cell of sum |grad W x A
// + W b|^2, with b uniform in a cube of half width 1.
constexpr double rms_of_lattice = 0.604819899;

// The finalizer of MurmurHash3 (A. Appleby, public domain).
std::uint64_t mixed(std::uint64_t h) {
    h ^= h >> 33;
    h *= 0xff51afd7ed558ccdULL;
    h ^= h >> 33;
    h *= 0xc4ceb9fe1a85ec53ULL;
    return h ^ (h >> 33);
}

// Maps 21 bits to a number in (-1, 1), symmetric about 0.
double centered(std::uint64_t bits) {
    return (static_cast<double>(bits & 0x1fffff) - 1048575.5) * (1 / 1048576.0);
}

struct Lattice {
    std::uint64_t key;   // of seed, octave and time interval
    std::uint64_t mask;  // of corners: the period minus 1

    Vec3 flow_of(std::uint64_t x, std::uint64_t y, std::uint64_t z) const {
        const std::uint64_t h =
            mixed(mixed((x & mask) * 0x9e3779b97f4a7c15ULL + key) +
                  (y & mask) * 0xc2b2ae3d27d4eb4fULL + (z & mask) * 0x165667b19e3779f9ULL);
        return {centered(h), centered(h >> 21), centered(h >> 42)};
    }
};

// One axis: the weights of both corners and their derivatives.
struct Blend {
    double weight[2], slope[2], from[2];

    explicit Blend(double t) : from{t, t - 1} {
        const double rest = 1 - t;
        weight[1] = t * t * t * (10 + t * (6 * t - 15));
        weight[0] = 1 - weight[1];
        slope[1] = 30 * t * t * rest * rest;
        slope[0] = -slope[1];
    }
};

std::uint64_t corner(double coordinate) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(coordinate));
}

struct Cell {
    Vec3 low;
    Blend x, y, z;

    explicit Cell(Vec3 p)
        : low{std::floor(p.x), std::floor(p.y), std::floor(p.z)},
          x(p.x - low.x),
          y(p.y - low.y),
          z(p.z - low.z) {}

    Vec3 flow(const Lattice& lattice) const {
        Vec3 sum;
        for (std::uint64_t k = 0; k < 8; k++) {
            const std::uint64_t i = k & 1, j = (k >> 1) & 1, l = k >> 2;
            const Vec3 b = lattice.flow_of(corner(low.x) + i, corner(low.y) + j, corner(low.z) + l);
            const double yz = y.weight[j] * z.weight[l];
            const Vec3 gradient{x.slope[i] * yz, x.weight[i] * y.slope[j] * z.weight[l],
                                x.weight[i] * y.weight[j] * z.slope[l]};
            const Vec3 potential = cross(b, {x.from[i], y.from[j], z.from[l]}) * 0.5;
            sum += cross(gradient, potential) + b * (x.weight[i] * yz);
        }
        return sum;
    }
};

Vec3 octave(const CurlNoise& noise, std::uint64_t number, std::uint64_t mask, Vec3 p, double time) {
    const double interval = std::floor(time);
    const double t = Blend(time - interval).weight[1];
    const SinCos weight = sin_cos(0.5 * pi * t);
    const std::uint64_t key = mixed((std::uint64_t{noise.seed} << 8) + number);
    const Cell cell(p);
    Vec3 flow = cell.flow({key + mixed(corner(interval) + 1), mask}) * weight.cos;
    if (weight.sin != 0) flow += cell.flow({key + mixed(corner(interval) + 2), mask}) * weight.sin;
    return flow;
}

}  // namespace

Vec3 curl_noise(const CurlNoise& noise, Vec3 point, double time) {
    constexpr double gain = 0.79370052598409973738;  // 2^(-1/3)
    constexpr double faster = 1.58740105196819947475;
    double weight = 1, squares = 0;
    std::uint64_t mask = noise.period == 0 ? ~std::uint64_t{0} : noise.period - 1;
    Vec3 sum;
    for (std::uint32_t n = 0; n < noise.octaves; n++) {
        sum += octave(noise, n, mask, point, time) * weight;
        squares += weight * weight;
        weight *= gain;
        point *= 2;
        time *= faster;
        mask = 2 * mask + 1;
    }
    return sum * (1 / (rms_of_lattice * square_root(squares)));
}

}  // namespace jostle::modules::fields_detail
