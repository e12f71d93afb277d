// SPDX-License-Identifier: MIT
//
// Bullet in double precision. It is a separate library, loaded at run time
// (bullet_accuracy_library.cpp), because jostle-bench speed links Bullet in single precision with
// the same symbols.
#include <btBulletDynamicsCommon.h>

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "bench/accuracy/bullet_accuracy_library.h"
#include "bench/accuracy/bullet_tree_engine.h"

namespace jostle::bench::accuracy {
namespace {

btVector3 vector(Vec3 v) {
    return {v.x, v.y, v.z};
}

Vec3 from(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

btTransform transform(const Transform& t) {
    const Quat q = t.rotation;
    return btTransform(btQuaternion(q.x, q.y, q.z, q.w).normalized(), vector(t.position));
}

Transform pose_of(const Scene& scene, int body) {
    return body == ground ? Transform{} : scene.bodies[static_cast<std::size_t>(body)].pose;
}

// A frame in the world with the axes x, y and z.
btTransform frame_of(Vec3 origin, Vec3 x, Vec3 y, Vec3 z) {
    return btTransform(btMatrix3x3(x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z), vector(origin));
}

Vec3 any_across(Vec3 axis) {
    return normalized(cross(std::abs(axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, axis));
}

struct ShapeMaker {
    std::unique_ptr<btCollisionShape> operator()(const physics::Sphere& sphere) const {
        return std::make_unique<btSphereShape>(sphere.radius);
    }
    std::unique_ptr<btCollisionShape> operator()(const physics::Box& box) const {
        return std::make_unique<btBoxShape>(vector(box.half_extents));
    }
    std::unique_ptr<btCollisionShape> operator()(const physics::Cylinder& c) const {
        return std::make_unique<btCylinderShape>(btVector3(c.radius, c.half_length, c.radius));
    }
    std::unique_ptr<btCollisionShape> operator()(const physics::Capsule& c) const {
        return std::make_unique<btCapsuleShape>(c.radius, 2 * c.half_length);
    }
    std::unique_ptr<btCollisionShape> operator()(const OtherShape&) const { return nullptr; }
    std::unique_ptr<btCollisionShape> operator()(const physics::Plane& plane) const {
        return std::make_unique<btStaticPlaneShape>(vector(plane.normal), 0);
    }
    std::unique_ptr<btCollisionShape> operator()(const HullPoints& hull) const {
        auto shape = std::make_unique<btConvexHullShape>();
        for (const Vec3 point : hull.points) shape->addPoint(vector(point));
        shape->setMargin(0);  // the margin of a hull lies outside
        return shape;
    }
};

std::unique_ptr<btConstraintSolver> make_solver(const std::string& mode) {
    if (mode.starts_with("nncg")) return std::make_unique<btNNCGConstraintSolver>();
    return std::make_unique<btSequentialImpulseConstraintSolver>();
}

int iterations_of(const std::string& mode) {
    const std::size_t digits = mode.find_first_of("0123456789");
    return digits == std::string::npos ? 10 : std::stoi(mode.substr(digits));
}

class BulletAccuracyEngine final : public Engine {
public:
    ~BulletAccuracyEngine() override {
        for (const auto& constraint : constraints_) world_->removeConstraint(constraint.get());
        for (const auto& body : bodies_) world_->removeRigidBody(body.get());
    }

    Status build(const Scene& scene, const std::string& mode) override {
        if (mode == "dantzig")
            solver_ = std::make_unique<btMLCPSolver>(&dantzig_);
        else
            solver_ = make_solver(mode);
        world_.emplace(&dispatcher_, &broad_phase_, solver_.get(), &configuration_);
        world_->setGravity(vector(scene.gravity));
        world_->getSolverInfo().m_numIterations = iterations_of(mode);
        thin_ = mode.ends_with("-thin");
        if (thin_) world_->getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
        pull_ = scene.central_pull;
        mutual_pull_ = scene.mutual_pull;
        for (const Body& body : scene.bodies) add_body(scene, body);
        set_damping(scene.damping);
        for (const Joint& joint : scene.joints)
            if (auto status = add_joint(scene, joint); !status) return status;
        return {};
    }

    void step(double dt) override {
        for (const auto& [hinge, motor] : motors_)
            hinge->enableAngularMotor(true, -motor.speed, motor.max_torque * dt);
        for (const std::size_t k : driven_) {
            btTransform moved = bodies_[k]->getWorldTransform();
            moved.setOrigin(moved.getOrigin() + bodies_[k]->getLinearVelocity() * dt);
            bodies_[k]->setWorldTransform(moved);
        }
        if (pull_ > 0)
            for (const auto& body : bodies_) {
                const btVector3 at = body->getCenterOfMassPosition();
                const double distance = at.length();
                body->applyCentralForce(
                    at * (-pull_ / (body->getInvMass() * distance * distance * distance)));
            }
        if (mutual_pull_ > 0) pull_each_other();
        world_->stepSimulation(dt, 0);
    }

    BodyState state(int body) const override {
        const btRigidBody& rigid = *bodies_[static_cast<std::size_t>(body)];
        const btTransform& t = rigid.getCenterOfMassTransform();
        const btQuaternion q = t.getRotation();
        return {from(t.getOrigin()),
                {q.x(), q.y(), q.z(), q.w()},
                from(rigid.getLinearVelocity()),
                from(rigid.getAngularVelocity())};
    }

    // Bullet's damping is the share lost per second.
    void set_damping(double rate) override {
        const double share = 1 - std::exp(-rate);
        for (const auto& body : bodies_) body->setDamping(share, share);
    }

    void set_velocity(int body, Vec3 velocity) override {
        bodies_[static_cast<std::size_t>(body)]->setLinearVelocity(vector(velocity));
    }

private:
    void pull_each_other() {
        for (const auto& a : bodies_)
            for (const auto& b : bodies_) {
                if (a == b) continue;
                const btVector3 apart = b->getCenterOfMassPosition() - a->getCenterOfMassPosition();
                const double distance = apart.length(), masses = a->getMass() * b->getMass();
                a->applyCentralForce(apart *
                                     (mutual_pull_ * masses / (distance * distance * distance)));
            }
    }

    void add_body(const Scene& scene, const Body& body) {
        const bool free = body.motion == Motion::free;
        shapes_.push_back(body.shape ? std::visit(ShapeMaker{}, *body.shape)
                                     : std::make_unique<btSphereShape>(0.01));
        btRigidBody::btRigidBodyConstructionInfo info(free ? body.mass : 0, nullptr,
                                                      shapes_.back().get(),
                                                      free ? vector(body.inertia) : btVector3());
        info.m_startWorldTransform = transform(body.pose);
        info.m_friction = std::sqrt(scene.friction);  // Bullet multiplies the two coefficients
        info.m_restitution = std::sqrt(scene.restitution);
        auto rigid = std::make_unique<btRigidBody>(info);
        rigid->setActivationState(DISABLE_DEACTIVATION);
        if (body.motion == Motion::kinematic) {
            rigid->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
            driven_.push_back(bodies_.size());
        }
        rigid->setLinearVelocity(vector(body.velocity));
        rigid->setAngularVelocity(vector(body.spin));
        if (thin_) rigid->setContactProcessingThreshold(0);
        const auto* sphere = body.shape ? std::get_if<physics::Sphere>(&*body.shape) : nullptr;
        if (scene.continuous && sphere) {
            rigid->setCcdMotionThreshold(0.5 * sphere->radius);
            rigid->setCcdSweptSphereRadius(0.5 * sphere->radius);
        }
        if (body.shape)
            world_->addRigidBody(rigid.get());
        else
            world_->addRigidBody(rigid.get(), btBroadphaseProxy::DefaultFilter, 0);
        bodies_.push_back(std::move(rigid));
    }

    btRigidBody& rigid(int body) {
        return body == ground ? btTypedConstraint::getFixedBody()
                              : *bodies_[static_cast<std::size_t>(body)];
    }

    Status add_joint(const Scene& scene, const Joint& joint) {
        if (joint.kind == JointKind::rod) return Error{.message = "bullet does not support rods"};
        auto constraint = make_constraint(scene, joint);
        world_->addConstraint(constraint.get(), true);
        constraints_.push_back(std::move(constraint));
        return {};
    }

    std::unique_ptr<btTypedConstraint> make_constraint(const Scene& scene, const Joint& joint) {
        btRigidBody &a = rigid(joint.a), &b = rigid(joint.b);
        const btTransform to_a = transform(pose_of(scene, joint.a)).inverse();
        const btTransform to_b = transform(pose_of(scene, joint.b)).inverse();
        const Vec3 across = any_across(joint.axis), third = cross(joint.axis, across);
        const btTransform along_x = frame_of(joint.anchor, joint.axis, across, third);
        const btVector3 anchor = vector(joint.anchor);
        switch (joint.kind) {
            case JointKind::hinge: {
                const btTransform along_z = frame_of(joint.anchor, across, third, joint.axis);
                auto hinge =
                    std::make_unique<btHingeConstraint>(a, b, to_a * along_z, to_b * along_z);
                // Bullet's hinge angle is that of a relative to b.
                if (joint.limit) hinge->setLimit(-joint.limit->upper, -joint.limit->lower);
                if (joint.motor) motors_.emplace_back(hinge.get(), *joint.motor);
                return hinge;
            }
            case JointKind::slider: {
                auto slider = std::make_unique<btSliderConstraint>(a, b, to_a * along_x,
                                                                   to_b * along_x, true);
                slider->setLowerLinLimit(1);  // lower above upper: free
                slider->setUpperLinLimit(-1);
                slider->setLowerAngLimit(0);
                slider->setUpperAngLimit(0);
                return slider;
            }
            case JointKind::fixed:
                return std::make_unique<btFixedConstraint>(a, b, to_a * along_x, to_b * along_x);
            case JointKind::spring:
                return make_spring(joint, a, b, to_a, to_b);
            case JointKind::ball:
            case JointKind::rod:
                break;
        }
        const btVector3 end_b = vector(joint.misaligned_anchor_b.value_or(joint.anchor));
        return std::make_unique<btPoint2PointConstraint>(a, b, to_a * anchor, to_b * end_b);
    }

    // Along the line of the anchors at the start; all other axes are free.
    static std::unique_ptr<btTypedConstraint> make_spring(const Joint& joint, btRigidBody& a,
                                                          btRigidBody& b, const btTransform& to_a,
                                                          const btTransform& to_b) {
        const Vec3 line = normalized(joint.anchor_b - joint.anchor), across = any_across(line);
        const Vec3 third = cross(line, across);
        const btTransform at_a = frame_of(joint.anchor, line, across, third);
        const btTransform at_b = frame_of(joint.anchor_b, line, across, third);
        auto spring =
            std::make_unique<btGeneric6DofSpring2Constraint>(a, b, to_a * at_a, to_b * at_b);
        for (int k = 0; k < 6; k++) spring->setLimit(k, 1, -1);
        spring->enableSpring(0, true);
        spring->setStiffness(0, joint.stiffness);
        spring->setDamping(0, joint.damping);
        spring->setEquilibriumPoint(0, joint.rest_length);
        return spring;
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broad_phase_;
    btDantzigSolver dantzig_;
    std::unique_ptr<btConstraintSolver> solver_;
    std::optional<btDiscreteDynamicsWorld> world_;
    bool thin_ = false;
    double pull_ = 0, mutual_pull_ = 0;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> constraints_;
    std::vector<std::pair<btHingeConstraint*, Motor>> motors_;
    std::vector<std::size_t> driven_;
};

// Rigid bodies, or trees in joint coordinates, depending on the mode.
class EitherBulletEngine final : public Engine {
public:
    Status build(const Scene& scene, const std::string& mode) override {
        if (mode.starts_with("mb"))
            engine_ = make_bullet_tree_engine();
        else
            engine_ = std::make_unique<BulletAccuracyEngine>();
        return engine_->build(scene, mode);
    }
    void step(double dt) override { engine_->step(dt); }
    BodyState state(int body) const override { return engine_->state(body); }
    void set_damping(double rate) override { engine_->set_damping(rate); }
    void set_velocity(int body, Vec3 velocity) override { engine_->set_velocity(body, velocity); }
    std::string failure() const override { return engine_->failure(); }

private:
    std::unique_ptr<Engine> engine_;
};

}  // namespace
}  // namespace jostle::bench::accuracy

extern "C" jostle::bench::accuracy::Engine* make_bullet_accuracy_engine() {
    return new jostle::bench::accuracy::EitherBulletEngine;
}
