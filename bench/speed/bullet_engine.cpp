// SPDX-License-Identifier: MIT
#include "bench/speed/engine_kinds.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bench/speed/portable_scene.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"

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

// Centre of mass and principal axes of a body, in the body frame.
struct Principal {
    btTransform frame;
    btVector3 inertia;
};

Principal principal_of(const SolidMass& solid) {
    const physics::Mat3& m = solid.inertia;
    btMatrix3x3 inertia(scalar(m.x.x), scalar(m.y.x), scalar(m.z.x), scalar(m.x.y), scalar(m.y.y),
                        scalar(m.z.y), scalar(m.x.z), scalar(m.y.z), scalar(m.z.z));
    btMatrix3x3 axes;
    inertia.diagonalize(axes, scalar(1e-6), 20);
    return {btTransform(axes, vector(solid.center)), {inertia[0][0], inertia[1][1], inertia[2][2]}};
}

// A frame in world space whose columns are the x, y and z axes.
btTransform world_frame(Vec3 origin, Vec3 x, Vec3 y, Vec3 z) {
    const btVector3 cx = vector(x), cy = vector(y), cz = vector(z);
    return btTransform(
        btMatrix3x3(cx.x(), cy.x(), cz.x(), cx.y(), cy.y(), cz.y(), cx.z(), cy.z(), cz.z()),
        vector(origin));
}

std::unique_ptr<btTypedConstraint> make_constraint(const JointAxes& axes,
                                                   const physics::JointKind& kind, btRigidBody& a,
                                                   btRigidBody& b, double step_seconds) {
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
        // Bullet's hinge angle is that of a relative to b.
        const physics::JointLimit& limit = jostle_hinge->limit;
        if (limit.enabled) hinge->setLimit(scalar(-limit.upper), scalar(-limit.lower));
        const physics::JointMotor& motor = jostle_hinge->motor;
        if (motor.enabled)
            hinge->enableAngularMotor(true, scalar(-motor.speed),
                                      scalar(motor.max_torque * step_seconds));
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
        const auto masses = solid_masses(scene);
        if (!masses) return masses.error();
        for (std::size_t k = 0; k < scene.bodies.size(); k++)
            add_body(scene.bodies[k], (*masses)[k], scene.world.sleeping);
        for (const SceneJoint& joint : scene.joints) {
            constraints_.push_back(make_constraint(axes_of(scene, joint), joint.joint.kind,
                                                   *bodies_[joint.body_a], *bodies_[joint.body_b],
                                                   step_seconds_));
            world_.addConstraint(constraints_.back().get(), true);
        }
        return {};
    }

    void step() override {
        for (btRigidBody* body : driven_) {
            btTransform next;
            btTransformUtil::integrateTransform(
                body->getWorldTransform(), body->getLinearVelocity(), body->getAngularVelocity(),
                scalar(step_seconds_), next);
            body->setWorldTransform(next);
        }
        world_.stepSimulation(scalar(step_seconds_), 0);
    }

    Transform pose(std::uint32_t body) const override {
        const btTransform t = bodies_[body]->getWorldTransform() * frames_[body].inverse();
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
        return static_cast<int>(std::ranges::count_if(bodies_, [](const auto& body) {
            return !body->isStaticOrKinematicObject() && body->isActive();
        }));
    }

private:
    // Bodies with the same geometry share a shape, as Bullet's manual recommends. A hull is stored
    // in the frame that all bodies with this shape have.
    btCollisionShape* shape_of(const Primitive& primitive, const btTransform& frame) {
        for (const auto& [known, shape] : shapes_)
            if (known == primitive) return shape.get();
        shapes_.emplace_back(primitive, nullptr);
        std::unique_ptr<btCollisionShape>& made = shapes_.back().second;
        if (const auto* hull = std::get_if<physics::Hull>(&primitive)) {
            auto convex = std::make_unique<btConvexHullShape>();
            const btTransform into = frame.inverse();
            for (const Vec3& v : hull->data->vertices) convex->addPoint(into * vector(v), false);
            convex->recalcLocalAabb();
            made = std::move(convex);
        } else if (const auto* mesh = std::get_if<physics::Mesh>(&primitive)) {
            auto triangles = std::make_unique<btTriangleMesh>();
            const auto& at = mesh->data->vertices;
            for (const auto& corner : mesh->data->triangles)
                triangles->addTriangle(vector(at[corner[0]]), vector(at[corner[1]]),
                                       vector(at[corner[2]]));
            made = std::make_unique<btBvhTriangleMeshShape>(triangles.get(), true);
            meshes_.push_back(std::move(triangles));
        } else {
            made = std::visit(
                []<class Shape>(const Shape& shape) -> std::unique_ptr<btCollisionShape> {
                    if constexpr (requires { make_shape(shape); })
                        return make_shape(shape);
                    else
                        return nullptr;
                },
                primitive);
        }
        return made.get();
    }

    // A single hull is stored relative to its centre of mass; other parts with an offset become a
    // compound shape.
    btCollisionShape* shape_of(const std::vector<Part>& parts, const btTransform& frame) {
        const bool is_hull = std::holds_alternative<physics::Hull>(parts[0].shape);
        if (parts.size() == 1 && parts[0].pose == Transform{} &&
            (is_hull || frame == btTransform::getIdentity()))
            return shape_of(parts[0].shape, frame);
        auto compound = std::make_unique<btCompoundShape>();
        for (const Part& part : parts)
            compound->addChildShape(frame.inverse() * transform(part.pose),
                                    shape_of(part.shape, btTransform::getIdentity()));
        compounds_.push_back(std::move(compound));
        return compounds_.back().get();
    }

    void add_body(const SceneBody& body, const SolidMass& solid, bool sleep) {
        const physics::BodyDef& def = body.body;
        const std::vector<Part> parts = parts_of(body);
        // For a single centred primitive, the principal axes are those of the body.
        const bool is_plain = parts.size() == 1 && parts[0].pose == Transform{} &&
                              !std::holds_alternative<physics::Hull>(parts[0].shape);
        Principal principal{
            btTransform::getIdentity(),
            {scalar(solid.inertia.x.x), scalar(solid.inertia.y.y), scalar(solid.inertia.z.z)}};
        if (is_dynamic(body) && !is_plain) principal = principal_of(solid);
        frames_.push_back(principal.frame);
        btRigidBody::btRigidBodyConstructionInfo info(
            scalar(solid.mass), nullptr, shape_of(parts, principal.frame), principal.inertia);
        info.m_startWorldTransform = transform(def.pose) * principal.frame;
        // Bullet multiplies the friction of the two bodies.
        info.m_friction = scalar(std::sqrt(body.shapes[0].material.friction));
        info.m_restitution = 0;
        info.m_linearDamping = scalar(def.linear_damping);
        info.m_angularDamping = scalar(def.angular_damping);
        auto rigid = std::make_unique<btRigidBody>(info);
        if (!is_dynamic(body) && !is_static(body)) {
            rigid->setCollisionFlags(rigid->getCollisionFlags() |
                                     btCollisionObject::CF_KINEMATIC_OBJECT);
            driven_.push_back(rigid.get());
        }
        rigid->setLinearVelocity(vector(def.linear_velocity));
        rigid->setAngularVelocity(vector(def.angular_velocity));
        if ((!sleep && is_dynamic(body)) || rigid->isKinematicObject())
            rigid->setActivationState(DISABLE_DEACTIVATION);
        sweep_if_fast(*rigid, parts, def.linear_velocity);
        if (collides(body))
            world_.addRigidBody(rigid.get());
        else
            world_.addRigidBody(rigid.get(), btBroadphaseProxy::DefaultFilter, 0);
        bodies_.push_back(std::move(rigid));
    }

    // Bullet requires explicit continuous collision detection: enable it for bodies that move
    // farther than their own width in a step.
    void sweep_if_fast(btRigidBody& rigid, const std::vector<Part>& parts, Vec3 velocity) const {
        double radius = 0;  // of the inscribed ball
        if (const auto* sphere = std::get_if<physics::Sphere>(&parts[0].shape))
            radius = sphere->radius;
        if (const auto* box = std::get_if<physics::Box>(&parts[0].shape))
            radius = std::min({box->half_extents.x, box->half_extents.y, box->half_extents.z});
        if (parts.size() != 1 || radius == 0 || length(velocity) * step_seconds_ <= 2 * radius)
            return;
        rigid.setCcdMotionThreshold(scalar(0.75 * radius));
        rigid.setCcdSweptSphereRadius(scalar(0.5 * radius));
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broad_phase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
    double step_seconds_ = 0;
    std::vector<std::pair<Primitive, std::unique_ptr<btCollisionShape>>> shapes_;
    std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
    std::vector<std::unique_ptr<btCompoundShape>> compounds_;
    std::vector<btTransform> frames_;  // centre of mass and axes of each body, in the body frame
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<btRigidBody*> driven_;  // kinematic
    std::vector<std::unique_ptr<btTypedConstraint>> constraints_;
};

}  // namespace

std::unique_ptr<Engine> make_bullet_engine() {
    return std::make_unique<BulletEngine>();
}

}  // namespace jostle::bench
