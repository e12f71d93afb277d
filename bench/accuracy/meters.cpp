// SPDX-License-Identifier: MIT
#include "bench/accuracy/meters.h"

#include <utility>

#include "bench/accuracy/accuracy_bodies.h"

namespace jostle::bench::accuracy {
namespace {

class TrackMeter final : public Meter {
public:
    TrackMeter(const Scene& scene, int body, PointInTime truth, double length, double gap_length)
        : gaps_(scene),
          body_(body),
          truth_(std::move(truth)),
          length_(length),
          gap_length_(gap_length) {}

    void sample(double t, const Engine& engine) override {
        distance_.add(length_squared(engine.state(body_).position - truth_(t)));
        gaps_.sample(engine);
    }
    Errors errors() const override {
        return {distance_.value() / length_, gaps_.most() / gap_length_};
    }

private:
    GapMeter gaps_;
    Rms distance_;
    int body_;
    PointInTime truth_;
    double length_, gap_length_;
};

class LastMeter final : public Meter {
public:
    explicit LastMeter(LastError error) : error_(std::move(error)) {}
    void sample(double t, const Engine& engine) override { errors_ = error_(t, engine); }
    Errors errors() const override { return errors_; }

private:
    LastError error_;
    Errors errors_;
};

class RestMeter final : public Meter {
public:
    RestMeter(const Scene& scene, When when) : scene_(scene), when_(when) {}

    void sample(double, const Engine& engine) override {
        if (when_ == When::at_end) most_ = {};
        for (std::size_t k = 0; k < scene_.bodies.size(); k++) {
            if (scene_.bodies[k].motion != Motion::free) continue;
            Vec3 moved =
                engine.state(static_cast<int>(k)).position - scene_.bodies[k].pose.position;
            most_.primary = std::max(most_.primary, length(moved));
            moved.z = 0;
            most_.secondary = std::max(most_.secondary, length(moved));
        }
    }
    Errors errors() const override { return most_; }

private:
    Scene scene_;
    When when_;
    Errors most_;
};

}  // namespace

GapMeter::GapMeter(const Scene& scene) {
    for (const Joint& joint : scene.joints) {
        if (joint.kind == JointKind::slider || joint.kind == JointKind::spring || joint.other)
            continue;
        const Vec3 end_b = joint.kind == JointKind::rod ? joint.anchor_b : joint.anchor;
        pairs_.push_back({{joint.a, apply_inverse(pose_of(scene, joint.a), joint.anchor)},
                          {joint.b, apply_inverse(pose_of(scene, joint.b), end_b)},
                          length(end_b - joint.anchor)});
    }
}

Vec3 GapMeter::place(const Engine& engine, const End& end) {
    if (end.body == ground) return end.local;
    const BodyState body = engine.state(end.body);
    return body.position + rotate(body.rotation, end.local);
}

void GapMeter::sample(const Engine& engine) {
    for (const Pair& pair : pairs_) {
        const double apart = length(place(engine, pair.a) - place(engine, pair.b));
        most_ = std::max(most_, std::abs(apart - pair.distance));
    }
}

std::unique_ptr<Meter> track_meter(const Scene& scene, int body, PointInTime truth, double length,
                                   double gap_length) {
    return std::make_unique<TrackMeter>(scene, body, std::move(truth), length, gap_length);
}

std::unique_ptr<Meter> last_meter(LastError error) {
    return std::make_unique<LastMeter>(std::move(error));
}

std::unique_ptr<Meter> rest_meter(const Scene& scene, When when) {
    return std::make_unique<RestMeter>(scene, when);
}

double energy(const Scene& scene, const Engine& engine) {
    double sum = 0;
    for (std::size_t k = 0; k < scene.bodies.size(); k++) {
        const Body& body = scene.bodies[k];
        if (body.motion != Motion::free) continue;
        const BodyState now = engine.state(static_cast<int>(k));
        sum += kinetic_energy(body, now.rotation, now.velocity, now.spin) -
               body.mass * dot(scene.gravity, now.position);
    }
    return sum;
}

}  // namespace jostle::bench::accuracy
