// SPDX-License-Identifier: MIT
#include "bench/accuracy/accuracy_engine_kinds.h"

#include <box2d/box2d.h>

#include <cmath>
#include <utility>
#include <vector>

namespace jostle::bench::accuracy {
namespace {

constexpr int position_iterations = 3;

float single(double value) {
    return static_cast<float>(value);
}

// The x and y axes of Box2D are the x and z axes of the scene. A rotation from x to y is one about
// -y.
b2Vec2 flat(Vec3 v) {
    return {single(v.x), single(v.z)};
}

Vec3 upright(const b2Vec2& v) {
    return {static_cast<double>(v.x), 0, static_cast<double>(v.y)};
}

float angle_of(Quat q) {
    const Vec3 x = rotate(q, {1, 0, 0});
    return single(std::atan2(x.z, x.x));
}

class Box2dAccuracyEngine final : public Engine {
public:
    Status build(const Scene& scene, const std::string& mode) override {
        if (scene.central_pull > 0 || scene.mutual_pull > 0)
            return Error{.message = "force laws are not implemented for box2d"};
        if (!scene.planar) return Error{.message = "box2d supports planar scenes only"};
        iterations_ = std::stoi(mode.substr(3));
        world_.SetGravity(flat(scene.gravity));
        world_.SetAllowSleeping(false);
        for (const Body& body : scene.bodies)
            if (auto status = add_body(scene, body); !status) return status;
        for (const Joint& joint : scene.joints) add_joint(joint);
        return {};
    }

    void step(double dt) override { world_.Step(single(dt), iterations_, position_iterations); }

    BodyState state(int body) const override {
        const b2Body& now = *bodies_[static_cast<std::size_t>(body)];
        const double angle = static_cast<double>(now.GetAngle());
        return {upright(now.GetWorldCenter()),
                {0, -std::sin(0.5 * angle), 0, std::cos(0.5 * angle)},
                upright(now.GetLinearVelocity()),
                {0, -static_cast<double>(now.GetAngularVelocity()), 0}};
    }

    void set_damping(double rate) override {
        for (b2Body* body : bodies_) {
            body->SetLinearDamping(single(rate));
            body->SetAngularDamping(single(rate));
        }
    }

    void set_velocity(int body, Vec3 velocity) override {
        bodies_[static_cast<std::size_t>(body)]->SetLinearVelocity(flat(velocity));
    }

private:
    Status add_body(const Scene& scene, const Body& body) {
        b2BodyDef def;
        def.type = body.motion == Motion::free        ? b2_dynamicBody
                   : body.motion == Motion::kinematic ? b2_kinematicBody
                                                      : b2_staticBody;
        def.position = flat(body.pose.position);
        def.angle = angle_of(body.pose.rotation);
        def.linearVelocity = flat(body.velocity);
        def.angularVelocity = single(-body.spin.y);
        def.linearDamping = def.angularDamping = single(scene.damping);
        def.bullet = scene.continuous;
        b2Body* made = world_.CreateBody(&def);
        bodies_.push_back(made);
        if (body.shape)
            if (auto status = add_shape(scene, *body.shape, *made); !status) return status;
        b2MassData mass;
        mass.mass = single(body.mass);
        mass.center.SetZero();
        mass.I = single(body.inertia.y);
        if (body.motion == Motion::free) made->SetMassData(&mass);
        return {};
    }

    static Status add_shape(const Scene& scene, const Shape& shape, b2Body& body) {
        b2FixtureDef fixture;
        fixture.density = 1;
        fixture.friction = single(scene.friction);  // the geometric mean of the two
        fixture.restitution = single(scene.restitution);
        fixture.restitutionThreshold = 0;
        b2CircleShape circle;
        b2PolygonShape polygon;
        if (const auto* sphere = std::get_if<physics::Sphere>(&shape)) {
            circle.m_radius = single(sphere->radius);
            fixture.shape = &circle;
        } else if (const auto* box = std::get_if<physics::Box>(&shape)) {
            polygon.SetAsBox(single(box->half_extents.x), single(box->half_extents.z));
            fixture.shape = &polygon;
        } else if (std::holds_alternative<physics::Plane>(shape)) {
            polygon.SetAsBox(1000, 10, {0, -10}, 0);
            fixture.shape = &polygon;
        } else {
            return Error{.message = "box2d supports balls, boxes and planes only"};
        }
        body.CreateFixture(&fixture);
        return {};
    }

    b2Body* end(int body) {
        if (body != ground) return bodies_[static_cast<std::size_t>(body)];
        if (!ground_) {
            const b2BodyDef def;
            ground_ = world_.CreateBody(&def);
        }
        return ground_;
    }

    void add_joint(const Joint& joint) {
        b2Body *a = end(joint.a), *b = end(joint.b);
        const b2Vec2 at = flat(joint.anchor);
        switch (joint.kind) {
            case JointKind::ball:
            case JointKind::hinge:
                return add_revolute(joint, a, b);
            case JointKind::slider: {
                b2PrismaticJointDef def;
                def.Initialize(a, b, at, flat(joint.axis));
                world_.CreateJoint(&def);
                return;
            }
            case JointKind::fixed: {
                b2WeldJointDef def;
                def.Initialize(a, b, at);
                world_.CreateJoint(&def);
                return;
            }
            case JointKind::rod:
            case JointKind::spring: {
                b2DistanceJointDef def;
                def.Initialize(a, b, at, flat(joint.anchor_b));
                if (joint.kind == JointKind::spring) {
                    def.length = single(joint.rest_length);
                    def.minLength = 0;
                    def.maxLength = 1e6F;
                    def.stiffness = single(joint.stiffness);
                    def.damping = single(joint.damping);
                }
                world_.CreateJoint(&def);
                return;
            }
        }
    }

    void add_revolute(const Joint& joint, b2Body* a, b2Body* b) {
        b2RevoluteJointDef def;
        def.Initialize(a, b, flat(joint.anchor));
        const float sense = joint.axis.y < 0 ? 1 : -1;
        if (joint.limit) {
            def.enableLimit = true;
            const Limit limit = *joint.limit;
            def.lowerAngle = single(sense > 0 ? limit.lower : -limit.upper);
            def.upperAngle = single(sense > 0 ? limit.upper : -limit.lower);
        }
        if (joint.motor) {
            def.enableMotor = true;
            def.motorSpeed = sense * single(joint.motor->speed);
            def.maxMotorTorque = single(joint.motor->max_torque);
        }
        world_.CreateJoint(&def);
    }

    b2World world_{{0, 0}};
    int iterations_ = 8;
    std::vector<b2Body*> bodies_;
    b2Body* ground_ = nullptr;
};

}  // namespace

std::unique_ptr<Engine> make_box2d_accuracy_engine() {
    return std::make_unique<Box2dAccuracyEngine>();
}

}  // namespace jostle::bench::accuracy
