// SPDX-License-Identifier: MIT
#include "physics/src/constraints/joints/path_curve.h"

#include <cmath>

#include "jostle/base/check.h"
#include "jostle/physics/quat.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

struct Jet {
    Vec3 position, first, second;  // derivatives with respect to the parameter
};

int pieces_of(const PathJoint& path) {
    return static_cast<int>(path.points.size()) - (path.closed ? 0 : 1);
}

// An open path is mirrored beyond its first and last point.
Vec3 point_of(const PathJoint& path, int k) {
    const int count = static_cast<int>(path.points.size());
    ASSERT(count >= 2);
    const auto at = [&](int i) { return path.points[static_cast<std::size_t>(i)]; };
    if (path.closed) return at((k % count + count) % count);
    if (k < 0) return at(0) * 2 - at(1);
    if (k >= count) return at(count - 1) * 2 - at(count - 2);
    return at(k);
}

Jet jet_of(const PathJoint& path, int piece, double t) {
    const Vec3 p1 = point_of(path, piece), p2 = point_of(path, piece + 1);
    if (!path.smooth) return {p1 + (p2 - p1) * t, p2 - p1, {}};
    const Vec3 p0 = point_of(path, piece - 1), p3 = point_of(path, piece + 2);
    const Vec3 c1 = (p2 - p0) * 0.5, c2 = p0 - p1 * 2.5 + p2 * 2 - p3 * 0.5,
               c3 = (p1 - p2) * 1.5 + (p3 - p0) * 0.5;
    return {p1 + (c1 + (c2 + c3 * t) * t) * t, c1 + (c2 * 2 + c3 * (3 * t)) * t,
            c2 * 2 + c3 * (6 * t)};
}

struct Parameter {
    int piece;
    double t;
};
Parameter split(const PathJoint& path, double at) {
    const int pieces = pieces_of(path);
    if (path.closed) at -= pieces * std::floor(at / pieces);
    const double whole = std::floor(at);
    int piece = static_cast<int>(maximum(0, minimum(whole, pieces - 1)));
    ASSERT(piece >= 0 && piece < pieces);
    return {piece, maximum(0, minimum(at - piece, 1))};
}
// Length of a piece up to t, by Gauss-Legendre quadrature with five points per quarter.
double length_up_to(const PathJoint& path, int piece, double t) {
    if (!path.smooth) return t * length(point_of(path, piece + 1) - point_of(path, piece));
    constexpr double nodes[] = {0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                                -0.9061798459386640};
    constexpr double weights[] = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                                  0.2369268850561891, 0.2369268850561891};
    double sum = 0;
    const double half = t / 8;
    for (int quarter = 0; quarter < 4; quarter++)
        for (int k = 0; k < 5; k++)
            sum += weights[k] *
                   length(jet_of(path, piece, half * (2 * quarter + 1 + nodes[k])).first) * half;
    return sum;
}

// The tangent of the curve. If the derivative vanishes at a parameter, which unusual points can
// cause, the direction of the chord.
Vec3 tangent_of(const PathJoint& path, int piece, const Jet& jet) {
    const double speed = length(jet.first);
    if (speed > 1e-9) return jet.first * (1 / speed);
    return normalized(point_of(path, piece + 1) - point_of(path, piece));
}

Quat facing(Vec3 x, Vec3 toward) {
    Vec3 y = toward - x * dot(x, toward);
    if (length(y) < 1e-9) y = cross(x, absolute(x.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0});
    y = normalized(y);
    ASSERT(is_unit(x, 1e-5) && is_unit(y));
    const Vec3 z = cross(x, y);
    // From a matrix with columns x, y, z (Shepperd, 1978): divides by the largest of the four.
    const double trace = x.x + y.y + z.z;
    const double sizes[] = {trace, x.x, y.y, z.z};
    int largest = 0;
    for (int k = 1; k < 4; k++)
        if (sizes[k] > sizes[largest]) largest = k;
    const Quat q = largest == 0   ? Quat{y.z - z.y, z.x - x.z, x.y - y.x, 1 + trace}
                   : largest == 1 ? Quat{1 + x.x - y.y - z.z, x.y + y.x, z.x + x.z, y.z - z.y}
                   : largest == 2 ? Quat{x.y + y.x, 1 + y.y - x.x - z.z, y.z + z.y, z.x - x.z}
                                  : Quat{z.x + x.z, y.z + z.y, 1 + z.z - x.x - y.y, x.y - y.x};
    return normalized(q);
}

double distance2_at(const PathJoint& path, double at, Vec3 point) {
    const Parameter p = split(path, at);
    return length_squared(jet_of(path, p.piece, p.t).position - point);
}

// Newton's method on the derivative of the squared distance. Steps that increase the distance are
// halved.
double nearest_parameter(const PathJoint& path, Vec3 point, double guess) {
    double at = parameter_within(path, guess);
    ASSERT(at >= 0 && at <= pieces_of(path));
    double best = distance2_at(path, at, point);
    for (int round = 0; round < 32; round++) {
        const Parameter p = split(path, at);
        const Jet jet = jet_of(path, p.piece, p.t);
        const Vec3 apart = jet.position - point;
        const double slope = dot(apart, jet.first), speed2 = length_squared(jet.first);
        const double bend = speed2 + dot(apart, jet.second);
        double step = -slope / (bend > 0.25 * speed2 ? bend : maximum(speed2, 1e-12));
        step = maximum(-1, minimum(step, 1));
        bool better = false;
        for (int halving = 0; halving < 20 && !better; halving++, step *= 0.5) {
            const double next = parameter_within(path, at + step);
            const double distance = distance2_at(path, next, point);
            if (distance < best) {
                better = true;
                best = distance;
                at = next;
                break;
            }
        }
        if (!better || absolute(step) < 1e-12) break;
    }
    return at;
}

}  // namespace

double parameter_within(const PathJoint& path, double at) {
    const int pieces = pieces_of(path);
    if (path.closed) return at - pieces * std::floor(at / pieces);
    return maximum(0, minimum(at, pieces));
}

PathPoint path_point_at(const PathJoint& path, double at) {
    const Parameter p = split(path, at);
    const Jet jet = jet_of(path, p.piece, p.t);
    const Vec3 tangent = tangent_of(path, p.piece, jet);
    const double speed = length(jet.first);
    PathPoint path_point{.at = p.piece + p.t, .position = jet.position, .rotation = {}};
    path_point.rotation = facing(tangent, jet.second);
    if (speed > 1e-9)
        path_point.curvature = length(cross(jet.first, jet.second)) / (speed * speed * speed);
    for (int piece = 0; piece < p.piece; piece++) path_point.travel += length_up_to(path, piece, 1);
    path_point.travel += length_up_to(path, p.piece, p.t);
    return path_point;
}

PathPoint nearest_path_point(const PathJoint& path, Vec3 point, double guess) {
    return path_point_at(path, nearest_parameter(path, point, guess));
}

PathPoint nearest_path_point(const PathJoint& path, Vec3 point) {
    double best = 0, nearest = distance2_at(path, 0, point);
    for (int k = 1; k <= pieces_of(path) * 8; k++) {
        const double at = k / 8.0, distance = distance2_at(path, at, point);
        if (distance < nearest) nearest = distance, best = at;
    }
    return nearest_path_point(path, point, best);
}

double parameter_step(const PathJoint& path, double previous, double at) {
    const double pieces = pieces_of(path), step = at - previous;
    return path.closed ? step - pieces * std::floor(step / pieces + 0.5) : step;
}

CurvePoint curve_point_at(const PathJoint& path, double at) {
    const Parameter p = split(path, at);
    const Jet jet = jet_of(path, p.piece, p.t);
    const double speed = length(jet.first);
    return {jet.position, tangent_of(path, p.piece, jet),
            speed > 1e-9 ? length(cross(jet.first, jet.second)) / (speed * speed * speed) : 0};
}

double path_speed_at(const PathJoint& path, double at) {
    const Parameter p = split(path, at);
    return maximum(1e-9, length(jet_of(path, p.piece, p.t).first));
}

double curvature_jumps(const PathJoint& path, double from, double to) {
    constexpr double kink = 1e300;
    const double first = std::floor(minimum(from, to)) + 1, last = std::floor(maximum(from, to));
    if (!path.smooth) return first <= last ? kink : 0;
    double sum = 0;
    for (double knot = first; knot <= last && knot < first + pieces_of(path); knot++) {
        const double at = parameter_within(path, knot);
        const int piece = static_cast<int>(at);
        if (!path.closed && (piece == 0 || piece >= pieces_of(path))) continue;
        const Jet before = jet_of(path, piece - 1, 1), after = jet_of(path, piece, 0);
        const double speed2 = length_squared(after.first);
        if (speed2 < 1e-18) return kink;
        // Both pieces have the same derivative at the point.
        const Vec3 bend = cross(after.first, after.second - before.second);
        sum += length(bend) / (speed2 * square_root(speed2));
    }
    return sum;
}

double follow_path(const PathJoint& path, Vec3 point, double guess) {
    return guess + parameter_step(path, guess, nearest_parameter(path, point, guess));
}

std::vector<double> piece_travels(const PathJoint& path) {
    std::vector<double> travels{0};
    for (int piece = 0; piece < pieces_of(path); piece++)
        travels.push_back(travels.back() + length_up_to(path, piece, 1));
    return travels;
}

double travel_at(const PathJoint& path, const std::vector<double>& travels, double at) {
    const Parameter p = split(path, at);
    const double laps = path.closed ? std::floor(at / pieces_of(path)) : 0;
    ASSERT(travels.size() == static_cast<std::size_t>(pieces_of(path)) + 1);
    return laps * travels.back() + travels[static_cast<std::size_t>(p.piece)] +
           length_up_to(path, p.piece, p.t);
}

double length_of(const PathJoint& path) {
    double sum = 0;
    for (int piece = 0; piece < pieces_of(path); piece++) sum += length_up_to(path, piece, 1);
    return sum;
}

}  // namespace jostle::physics
