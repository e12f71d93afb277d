// SPDX-License-Identifier: MIT
#include "jostle/modules/curl_noise.h"

#include <cmath>
#include <type_traits>

namespace jostle::modules {

using namespace physics;

namespace {

// Root mean square of one octave of one lattice: sqrt of the mean over the cell of sum |grad W x A
// + W b|^2, with b uniform in a cube of half width 1.
constexpr double rms_of_lattice = 0.604819899;
// The same for the flow in the plane z = 0 of the potential along z.
constexpr double rms_of_planar_lattice = 0.360608253369;

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

    // The hash of a plane of corners, which the corners of a cell share.
    std::uint64_t plane(std::uint64_t x) const {
        return mixed((x & mask) * 0x9e3779b97f4a7c15ULL + key);
    }
    Vec3 flow_of(std::uint64_t plane, std::uint64_t y, std::uint64_t z) const {
        const std::uint64_t h =
            mixed(plane + (y & mask) * 0xc2b2ae3d27d4eb4fULL + (z & mask) * 0x165667b19e3779f9ULL);
        return {centered(h), centered(h >> 21), centered(h >> 42)};
    }
};

// One axis: the weights of both corners, their derivatives, and the position from each corner.
struct Blend {
    double weight[2], slope[2], from[2];
    double curvature;  // second derivative of weight[1]

    explicit Blend(double t) : from{t, t - 1} {
        const double rest = 1 - t;
        weight[1] = t * t * t * (10 + t * (6 * t - 15));
        weight[0] = 1 - weight[1];
        slope[1] = 30 * t * t * rest * rest;
        slope[0] = -slope[1];
        curvature = 60 * t * rest * (1 - 2 * t);
    }
    double bend(std::uint64_t k) const { return k == 1 ? curvature : -curvature; }
};

std::uint64_t corner(double coordinate) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(coordinate));
}

// A corner of a cell: its indices, the position from it, the weight W and its gradient.
struct Corner {
    std::uint64_t i, j, l;
    Vec3 from, gradient;
    double weight;

    // A_c = b x (p - c) / 2
    Vec3 potential(Vec3 b) const { return cross(b, from) * 0.5; }
    Vec3 flow(Vec3 b) const { return cross(gradient, potential(b)) + b * weight; }
};

// The geometry of a cell, which the lattices of all times share.
struct Cell {
    std::uint64_t x0, y0, z0;
    Blend x, y, z;
    Corner corners[8];

    explicit Cell(Vec3 p) : Cell(p, {std::floor(p.x), std::floor(p.y), std::floor(p.z)}) {}

    // Calls visit(corner, b) for the corners and their flows.
    template <class Visit>
    void each_corner(const Lattice& lattice, int count, Visit&& visit) const {
        const std::uint64_t planes[2] = {lattice.plane(x0), lattice.plane(x0 + 1)};
        for (int k = 0; k < count; k++) {
            const Corner& c = corners[k];
            visit(c, lattice.flow_of(planes[c.i], y0 + c.j, z0 + c.l));
        }
    }
    // Columns of the second derivatives of the weight.
    Mat3 hessian(const Corner& c) const {
        const double xy = x.slope[c.i] * y.slope[c.j] * z.weight[c.l];
        const double xz = x.slope[c.i] * y.weight[c.j] * z.slope[c.l];
        const double yz = x.weight[c.i] * y.slope[c.j] * z.slope[c.l];
        return {{x.bend(c.i) * y.weight[c.j] * z.weight[c.l], xy, xz},
                {xy, x.weight[c.i] * y.bend(c.j) * z.weight[c.l], yz},
                {xz, yz, x.weight[c.i] * y.weight[c.j] * z.bend(c.l)}};
    }

private:
    Cell(Vec3 p, Vec3 low)
        : x0(corner(low.x)),
          y0(corner(low.y)),
          z0(corner(low.z)),
          x(p.x - low.x),
          y(p.y - low.y),
          z(p.z - low.z) {
        for (std::uint64_t k = 0; k < 8; k++) {
            const std::uint64_t i = k & 1, j = (k >> 1) & 1, l = k >> 2;
            const double yz = y.weight[j] * z.weight[l];
            corners[k] = {i,
                          j,
                          l,
                          {x.from[i], y.from[j], z.from[l]},
                          {x.slope[i] * yz, x.weight[i] * y.slope[j] * z.weight[l],
                           x.weight[i] * y.weight[j] * z.slope[l]},
                          x.weight[i] * yz};
        }
    }
};

// Each kind of sample: the value in a cell, and the sum over octaves. `rms`: of one octave.
struct FlowKind {
    using Value = Vec3;
    static constexpr double rms = rms_of_lattice;

    static Vec3 in_cell(const Cell& cell, const Lattice& lattice) {
        Vec3 sum;
        cell.each_corner(lattice, 8, [&](const Corner& c, Vec3 b) { sum += c.flow(b); });
        return sum;
    }
    static void add(Vec3& sum, const Vec3& value, double weight, double) { sum += value * weight; }
};

struct SampleKind {
    using Value = CurlNoiseSample;
    static constexpr double rms = rms_of_lattice;

    static Value in_cell(const Cell& cell, const Lattice& lattice) {
        Value sum;
        cell.each_corner(lattice, 8, [&](const Corner& c, Vec3 b) {
            sum.flow += c.flow(b);
            sum.potential += c.potential(b) * c.weight;
        });
        return sum;
    }
    // The potential of an octave with `size` times the eddies gives the same flow if it is larger
    // by the same factor.
    static void add(Value& sum, const Value& value, double weight, double size) {
        sum.flow += value.flow * weight;
        sum.potential += value.potential * (weight * size);
    }
};

struct GradientKind {
    using Value = Mat3;
    static constexpr double rms = rms_of_lattice;

    // d(grad W x A_c + W b) = d(grad W) x A_c + grad W x (b x d) / 2 + dW b, along each axis d.
    static Mat3 in_cell(const Cell& cell, const Lattice& lattice) {
        Mat3 sum = diagonal({0, 0, 0});
        cell.each_corner(lattice, 8, [&](const Corner& c, Vec3 b) {
            const Mat3 second = cell.hessian(c);
            const auto along = [&](Vec3 axis, Vec3 bend) {
                return cross(bend, c.potential(b)) + cross(c.gradient, cross(b, axis)) * 0.5 +
                       b * dot(c.gradient, axis);
            };
            sum = sum + Mat3{along({1, 0, 0}, second.x), along({0, 1, 0}, second.y),
                             along({0, 0, 1}, second.z)};
        });
        return sum;
    }
    static void add(Mat3& sum, const Mat3& value, double weight, double size) {
        sum = sum + value * (weight / size);
    }
};

// The potential along z in the plane z = 0, where only the four corners of the plane count.
struct PlanarKind {
    using Value = CurlNoiseSample;
    static constexpr double rms = rms_of_planar_lattice;

    static Value in_cell(const Cell& cell, const Lattice& lattice) {
        Value sum;
        // At z = 0 the first four corners have z weights of 1 with a slope of 0.
        cell.each_corner(lattice, 4, [&](const Corner& c, Vec3 b) {
            const double potential = (b.x * c.from.y - b.y * c.from.x) * 0.5;
            // The curl of a potential along z: (dA/dy, -dA/dx).
            sum.flow += Vec3{c.gradient.y * potential + c.weight * b.x * 0.5,
                             c.weight * b.y * 0.5 - c.gradient.x * potential, 0};
            sum.potential.z += c.weight * potential;
        });
        return sum;
    }
    static void add(Value& sum, const Value& value, double weight, double size) {
        SampleKind::add(sum, value, weight, size);
    }
};

// Blends the lattices of two consecutive time intervals.
template <class Kind>
typename Kind::Value octave(const CurlNoise& noise, std::uint64_t number, std::uint64_t mask,
                            Vec3 p, double time) {
    const double interval = std::floor(time);
    const double t = Blend(time - interval).weight[1];
    const SinCos weight = sin_cos(0.5 * pi * t);
    const std::uint64_t key = mixed((std::uint64_t{noise.seed} << 8) + number);
    const Cell cell(p);
    typename Kind::Value value = {};
    if constexpr (std::is_same_v<typename Kind::Value, Mat3>) value = diagonal({0, 0, 0});
    Kind::add(value, Kind::in_cell(cell, {key + mixed(corner(interval) + 1), mask}), weight.cos, 1);
    if (weight.sin != 0)
        Kind::add(value, Kind::in_cell(cell, {key + mixed(corner(interval) + 2), mask}), weight.sin,
                  1);
    return value;
}

template <class Kind>
typename Kind::Value sum_of_octaves(const CurlNoise& noise, Vec3 point, double time) {
    constexpr double gain = 0.79370052598409973738;  // 2^(-1/3)
    constexpr double faster = 1.58740105196819947475;
    double weight = 1, squares = 0, size = 1;
    std::uint64_t mask = noise.period == 0 ? ~std::uint64_t{0} : noise.period - 1;
    typename Kind::Value sum = {};
    if constexpr (std::is_same_v<typename Kind::Value, Mat3>) sum = diagonal({0, 0, 0});
    for (std::uint32_t n = 0; n < noise.octaves; n++) {
        Kind::add(sum, octave<Kind>(noise, n, mask, point, time), weight, size);
        squares += weight * weight;
        weight *= gain;
        point *= 2;
        size *= 0.5;
        time *= faster;
        mask = 2 * mask + 1;
    }
    typename Kind::Value scaled = {};
    if constexpr (std::is_same_v<typename Kind::Value, Mat3>) scaled = diagonal({0, 0, 0});
    Kind::add(scaled, sum, 1 / (Kind::rms * square_root(squares)), 1);
    return scaled;
}

}  // namespace

Vec3 curl_noise(const CurlNoise& noise, Vec3 point, double time) {
    return sum_of_octaves<FlowKind>(noise, point, time);
}

CurlNoiseSample curl_noise_sample(const CurlNoise& noise, Vec3 point, double time) {
    return sum_of_octaves<SampleKind>(noise, point, time);
}

Mat3 curl_noise_gradient(const CurlNoise& noise, Vec3 point, double time) {
    return sum_of_octaves<GradientKind>(noise, point, time);
}

CurlNoiseSample planar_curl_noise(const CurlNoise& noise, Vec3 point, double time) {
    return sum_of_octaves<PlanarKind>(noise, {point.x, point.y, 0}, time);
}

}  // namespace jostle::modules
