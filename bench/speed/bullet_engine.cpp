// SPDX-License-Identifier: MIT
#include "speed/bullet_engine.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "speed/portable_scene.h"

namespace jostle::bench {
namespace {

using physics::Quat;
using physics::Transform;
using physics::Vec3;
using scenes::SceneBody;
using scenes::SceneDescription;
using scenes::SceneJoint;

btScalar scalar(double value) {
    return static_cast<btScalar>(value);
}

btVector3 vector(Vec3 v) {
    return {scalar(v.x), scalar(v.y), scalar(v.z)};
}

btTransform transform(const Transform& t) {
    const Quat q = t.rotation;
    const btQuaternion turned(scalar(q.x), scalar(q.y), scalar(q.z), scalar(q.w));
    return btTransform(turned.normalized(), vector(t.position));
}

std::unique_ptr<btCollisionShape> make_shape(const physics::Sphere& sphere) {
    return std::make_unique<btSphereShape>(scalar(sphere.radius));
}

std::unique_ptr<btCollisionShape> make_shape(const physics::Capsule& capsule) {
    return std::make_unique<btCapsuleShape>(scalar(capsule.radius),
                                            scalar(2 * capsule.half_length));
}

std::unique_ptr<btCollisionShape> make_shape(const physics::Box& box) {
    return std::make_unique<btBoxShape>(vector(box.half_extents));
}

// In the world; its x, y and z axes are the columns.
btTransform world_frame(Vec3 origin, Vec3 x, Vec3 y, Vec3 z) {
    const btVector3 cx = vector(x), cy = vector(y), cz = vector(z);
    return btTransform(
        btMatrix3x3(cx.x(), cy.x(), cz.x(), cx.y(), cy.y(), cz.y(), cx.z(), cy.z(), cz.z()),
        vector(origin));
}

std::unique_ptr<btTypedConstraint> make_constraint(const JointAxes& axes,
                                                   const physics::JointKind& kind, btRigidBody& a,
                                                   btRigidBody& b) {
    const btTransform to_a = a.getWorldTransform().inverse();
    const btTransform to_b = b.getWorldTransform().inverse();
    if (const auto* shoulder = std::get_if<physics::ConeTwistJoint>(&kind)) {
        const btTransform frame = world_frame(axes.anchor, axes.x, axes.z, cross(axes.x, axes.z));
        auto cone = std::make_unique<btConeTwistConstraint>(a, b, to_a * frame, to_b * frame);
        const btScalar swing = scalar(shoulder->swing);
        cone->setLimit(swing, swing,
                       scalar(std::max(-shoulder->twist.lower, shoulder->twist.upper)));
        return cone;
    }
    if (const auto* jostle_hinge = std::get_if<physics::HingeJoint>(&kind)) {
        const btTransform frame = world_frame(axes.anchor, axes.x, axes.y, axes.z);
        auto hinge = std::make_unique<btHingeConstraint>(a, b, to_a * frame, to_b * frame);
        // Bullet's hinge angle is that of a against b.
        const physics::JointLimit& limit = jostle_hinge->limit;
        hinge->setLimit(scalar(-limit.upper), scalar(-limit.lower));
        return hinge;
    }
    const btVector3 anchor = vector(axes.anchor);
    return std::make_unique<btPoint2PointConstraint>(a, b, to_a * anchor, to_b * anchor);
}

class BulletEngine final : public Engine {
public:
    ~BulletEngine() override {
        for (const auto& constraint : constraints_) world_.removeConstraint(constraint.get());
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }

    physics::Status init(const SceneDescription& scene) override {
        if (auto status = check_portable(scene); !status) return status;
        step_seconds_ = 1 / scene.hz;
        world_.setGravity(vector(scene.world.gravity));
        for (const SceneBody& body : scene.bodies) add_body(body, scene.world.sleeping);
        for (const SceneJoint& joint : scene.joints) {
            constraints_.push_back(make_constraint(axes_of(scene, joint), joint.joint.kind,
                                                   *bodies_[joint.body_a], *bodies_[joint.body_b]));
            world_.addConstraint(constraints_.back().get(), true);
        }
        return {};
    }

    void step() override { world_.stepSimulation(scalar(step_seconds_), 0); }

    Transform pose(std::uint32_t body) const override {
        const btTransform& t = bodies_[body]->getWorldTransform();
        const btVector3& at = t.getOrigin();
        const btQuaternion q = t.getRotation();
        return {{at.x(), at.y(), at.z()}, {q.x(), q.y(), q.z(), q.w()}};
    }

    Vec3 velocity(std::uint32_t body) const override {
        const btVector3& v = bodies_[body]->getLinearVelocity();
        return {v.x(), v.y(), v.z()};
    }

    void set_velocity(std::uint32_t body, Vec3 linear) override {
        bodies_[body]->activate();
        bodies_[body]->setLinearVelocity(vector(linear));
    }

    int awake() const override {
        return static_cast<int>(std::ranges::count_if(
            bodies_, [](const auto& body) { return !body->isStaticObject() && body->isActive(); }));
    }

private:
    // Bodies of one geometry share a shape, as Bullet's manual asks for.
    btCollisionShape* shape_of(const Primitive& primitive) {
        for (const auto& [known, shape] : shapes_)
            if (known == primitive) return shape.get();
        shapes_.emplace_back(
            primitive, std::visit([](const auto& shape) { return make_shape(shape); }, primitive));
        return shapes_.back().second.get();
    }

    void add_body(const SceneBody& body, bool sleep) {
        const physics::BodyDef& def = body.body;
        const Primitive primitive = primitive_of(body);
        const SolidMass solid = is_static(body) ? SolidMass{} : solid_mass(body);
        btRigidBody::btRigidBodyConstructionInfo info(scalar(solid.mass), nullptr,
                                                      shape_of(primitive), vector(solid.inertia));
        info.m_startWorldTransform = transform(def.pose);
        // Bullet multiplies the two.
        info.m_friction = scalar(std::sqrt(body.shapes[0].material.friction));
        info.m_restitution = 0;
        info.m_linearDamping = scalar(def.linear_damping);
        info.m_angularDamping = scalar(def.angular_damping);
        auto rigid = std::make_unique<btRigidBody>(info);
        rigid->setLinearVelocity(vector(def.linear_velocity));
        rigid->setAngularVelocity(vector(def.angular_velocity));
        if (!sleep && !is_static(body)) rigid->setActivationState(DISABLE_DEACTIVATION);
        // Sweeps must be asked for: whoever would pass its own width in a step is swept.
        if (const auto* sphere = std::get_if<physics::Sphere>(&primitive);
            sphere && length(def.linear_velocity) * step_seconds_ > 2 * sphere->radius) {
            rigid->setCcdMotionThreshold(scalar(0.75 * sphere->radius));
            rigid->setCcdSweptSphereRadius(scalar(0.5 * sphere->radius));
        }
        if (collides(body))
            world_.addRigidBody(rigid.get());
        else
            world_.addRigidBody(rigid.get(), btBroadphaseProxy::DefaultFilter, 0);
        bodies_.push_back(std::move(rigid));
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broad_phase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
    double step_seconds_ = 0;
    std::vector<std::pair<Primitive, std::unique_ptr<btCollisionShape>>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> constraints_;
};

}  // namespace

std::unique_ptr<Engine> make_bullet_engine() {
    return std::make_unique<BulletEngine>();
}

}  // namespace jostle::bench
