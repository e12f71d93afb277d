// SPDX-License-Identifier: MIT
#include "bench/accuracy/bullet_tree_engine.h"

#include <btBulletDynamicsCommon.h>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>

#include <utility>
#include <vector>

#include "bench/accuracy/accuracy_bodies.h"

namespace jostle::bench::accuracy {
namespace {

constexpr int iterations = 50;       // of loop constraints and motors
constexpr double no_maximum = 1e30;  // Bullet's default is 100 rad/s and 1000 N s
constexpr int the_base = -1;         // Bullet's index of the base

btVector3 to_bullet(Vec3 v) {
    return {v.x, v.y, v.z};
}

btQuaternion to_bullet(Quat q) {
    return btQuaternion(q.x, q.y, q.z, q.w).normalized();
}

Vec3 from_bullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

Transform pose_in(const Scene& scene, int body) {
    return body == ground ? Transform{} : scene.bodies[static_cast<std::size_t>(body)].pose;
}

// Links are numbered so that parents precede their children.
std::vector<int> parents_first(const BodyTree& tree) {
    std::vector<int> order;
    std::vector<bool> placed(tree.nodes.size());
    while (order.size() < tree.nodes.size())
        for (std::size_t k = 0; k < tree.nodes.size(); k++) {
            const int parent = tree.nodes[k].parent;
            if (placed[k] || (parent != ground && !placed[static_cast<std::size_t>(parent)]))
                continue;
            placed[k] = true;
            order.push_back(static_cast<int>(k));
        }
    return order;
}

Status check(const Scene& scene, const BodyTree& tree) {
    for (const Body& body : scene.bodies)
        if (body.shape || body.motion != Motion::free)
            return Error{.message = "bullet's trees support no contacts"};
    for (const BodyTree::Node& node : tree.nodes)
        if (!node.joint) return Error{.message = "bullet's trees support jointed bodies only"};
    for (const Joint& joint : scene.joints)
        if (joint.kind == JointKind::rod || joint.kind == JointKind::spring ||
            joint.misaligned_anchor_b)
            return Error{.message = "bullet's trees support no rods, springs or misaligned joints"};
    return {};
}

class BulletTreeEngine final : public Engine {
public:
    ~BulletTreeEngine() override {
        if (!world_) return;
        for (const auto& constraint : constraints_)
            world_->removeMultiBodyConstraint(constraint.get());
        for (const auto& collider : colliders_) world_->removeCollisionObject(collider.get());
        if (tree_) world_->removeMultiBody(tree_.get());
    }

    Status build(const Scene& scene, const std::string& mode) override {
        const BodyTree tree = tree_of(scene);
        if (auto status = check(scene, tree); !status) return status;
        world_ = std::make_unique<btMultiBodyDynamicsWorld>(&dispatcher_, &broad_phase_, &solver_,
                                                            &configuration_);
        world_->setGravity(to_bullet(scene.gravity));
        world_->getSolverInfo().m_numIterations = iterations;
        const int links = static_cast<int>(scene.bodies.size());
        tree_ = std::make_unique<btMultiBody>(links, 0, btVector3(0, 0, 0), true, false);
        link_of_.resize(scene.bodies.size());
        const std::vector<int> order = parents_first(tree);
        for (int link = 0; link < links; link++) {
            const int body = order[static_cast<std::size_t>(link)];
            link_of_[static_cast<std::size_t>(body)] = link;
            add_link(scene, tree, body, link);
        }
        tree_->finalizeMultiDof();
        tree_->useRK4Integration(mode == "mb-rk4");
        tree_->setLinearDamping(0);
        tree_->setAngularDamping(0);
        tree_->setMaxCoordinateVelocity(no_maximum);
        tree_->setMaxAppliedImpulse(no_maximum);
        for (std::size_t body = 0; body < scene.bodies.size(); body++)
            set_rate(scene, tree, static_cast<int>(body));
        world_->addMultiBody(tree_.get());
        // Bullet builds islands from colliders: without a collider nothing is constrained.
        for (int link = the_base; link < links; link++) add_collider(link);
        for (std::size_t body = 0; body < scene.bodies.size(); body++)
            add_drives(*tree.nodes[body].joint, link_of_[body]);
        for (const Joint& loop : tree.loops) close(scene, loop);
        for (const Body& body : scene.bodies) {
            masses_.push_back(body.mass);
            inertias_.push_back(body.inertia);
        }
        set_damping(scene.damping);
        refresh();
        return {};
    }

    void step(double dt) override {
        for (const auto& [motor, torque] : motors_) motor->setMaxAppliedImpulse(torque * dt);
        if (damping_ > 0) slow_down();
        world_->stepSimulation(dt, 0);
        fresh_ = false;
    }

    BodyState state(int body) const override {
        if (!fresh_) refresh();
        const int link = link_of_[static_cast<std::size_t>(body)];
        const btTransform& pose = tree_->getLink(link).m_cachedWorldTransform;
        const btQuaternion q = pose.getRotation();
        const auto at = static_cast<std::size_t>(link) + 1;
        return {from_bullet(pose.getOrigin()),
                {q.x(), q.y(), q.z(), q.w()},
                from_bullet(pose.getBasis() * velocities_[at]),
                from_bullet(pose.getBasis() * spins_[at])};
    }

    void set_damping(double rate) override { damping_ = rate; }
    void set_velocity(int, Vec3) override {}  // no driven bodies are created

private:
    // Updates poses and velocities of all links, in their own axes.
    void refresh() const {
        btAlignedObjectArray<btQuaternion> rotations;
        btAlignedObjectArray<btVector3> origins;
        tree_->forwardKinematics(rotations, origins);
        const auto count = static_cast<std::size_t>(tree_->getNumLinks()) + 1;
        spins_.resize(count);
        velocities_.resize(count);
        tree_->compTreeLinkVelocities(spins_.data(), velocities_.data());
        fresh_ = true;
    }

    void add_link(const Scene& scene, const BodyTree& tree, int body, int link) {
        const BodyTree::Node& node = tree.nodes[static_cast<std::size_t>(body)];
        const Body& description = scene.bodies[static_cast<std::size_t>(body)];
        const Transform above = pose_in(scene, node.parent);
        const int parent =
            node.parent == ground ? the_base : link_of_[static_cast<std::size_t>(node.parent)];
        const btVector3 inertia = to_bullet(description.inertia);
        const btQuaternion turn = to_bullet(conjugate(description.pose.rotation) * above.rotation);
        const btVector3 axis =
            to_bullet(inverse_rotate(description.pose.rotation, node.joint->axis));
        const btVector3 to_pivot = to_bullet(apply_inverse(above, node.joint->anchor));
        const btVector3 to_center = -to_bullet(apply_inverse(description.pose, node.joint->anchor));
        switch (node.joint->kind) {
            case JointKind::hinge:
                tree_->setupRevolute(link, description.mass, inertia, parent, turn, axis, to_pivot,
                                     to_center, true);
                return;
            case JointKind::slider:
                tree_->setupPrismatic(link, description.mass, inertia, parent, turn, axis, to_pivot,
                                      to_center, true);
                return;
            case JointKind::fixed:
                tree_->setupFixed(link, description.mass, inertia, parent, turn, to_pivot,
                                  to_center);
                return;
            default:
                tree_->setupSpherical(link, description.mass, inertia, parent, turn, to_pivot,
                                      to_center, true);
        }
    }

    // The joint's own velocity: that of the body relative to its parent.
    void set_rate(const Scene& scene, const BodyTree& tree, int body) {
        const BodyTree::Node& node = tree.nodes[static_cast<std::size_t>(body)];
        const Body& description = scene.bodies[static_cast<std::size_t>(body)];
        Vec3 spin = description.spin, velocity = description.velocity;
        if (node.parent != ground) {
            spin -= scene.bodies[static_cast<std::size_t>(node.parent)].spin;
            velocity -= scene.bodies[static_cast<std::size_t>(node.parent)].velocity;
        }
        const int link = link_of_[static_cast<std::size_t>(body)];
        const Vec3 local = inverse_rotate(description.pose.rotation, spin);
        const double ball[3] = {local.x, local.y, local.z};
        const double hinge[1] = {dot(node.joint->axis, spin)};
        const double slider[1] = {dot(node.joint->axis, velocity)};
        if (node.joint->kind == JointKind::ball) tree_->setJointVelMultiDof(link, ball);
        if (node.joint->kind == JointKind::hinge) tree_->setJointVelMultiDof(link, hinge);
        if (node.joint->kind == JointKind::slider) tree_->setJointVelMultiDof(link, slider);
    }

    void add_collider(int link) {
        auto collider = std::make_unique<btMultiBodyLinkCollider>(tree_.get(), link);
        collider->setCollisionShape(&nothing_);
        collider->setActivationState(DISABLE_DEACTIVATION);
        world_->addCollisionObject(collider.get(), btBroadphaseProxy::DefaultFilter, 0);
        if (link == the_base)
            tree_->setBaseCollider(collider.get());
        else
            tree_->getLink(link).m_collider = collider.get();
        colliders_.push_back(std::move(collider));
    }

    void add(std::unique_ptr<btMultiBodyConstraint> constraint) {
        constraint->finalizeMultiDof();
        world_->addMultiBodyConstraint(constraint.get());
        constraints_.push_back(std::move(constraint));
    }

    void add_drives(const Joint& joint, int link) {
        if (joint.limit)
            add(std::make_unique<btMultiBodyJointLimitConstraint>(
                tree_.get(), link, joint.limit->lower, joint.limit->upper));
        if (!joint.motor) return;
        auto motor = std::make_unique<btMultiBodyJointMotor>(tree_.get(), link, joint.motor->speed,
                                                             joint.motor->max_torque);
        motors_.emplace_back(motor.get(), joint.motor->max_torque);
        add(std::move(motor));
    }

    // A hinge that closes a planar loop of hinges needs only a point constraint.
    void close(const Scene& scene, const Joint& loop) {
        const auto link = [&](int body) {
            return body == ground ? the_base : link_of_[static_cast<std::size_t>(body)];
        };
        auto point = std::make_unique<btMultiBodyPoint2Point>(
            tree_.get(), link(loop.a), tree_.get(), link(loop.b),
            to_bullet(apply_inverse(pose_in(scene, loop.a), loop.anchor)),
            to_bullet(apply_inverse(pose_in(scene, loop.b), loop.anchor)));
        point->setMaxAppliedImpulse(no_maximum);
        add(std::move(point));
    }

    // Bullet's own damping is not proportional to the velocity.
    void slow_down() {
        for (std::size_t body = 0; body < link_of_.size(); body++) {
            const BodyState now = state(static_cast<int>(body));
            const Vec3 local = scaled(inverse_rotate(now.rotation, now.spin), inertias_[body]);
            tree_->addLinkForce(link_of_[body],
                                to_bullet(now.velocity * (-damping_ * masses_[body])));
            tree_->addLinkTorque(link_of_[body],
                                 to_bullet(rotate(now.rotation, local) * -damping_));
        }
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broad_phase_;
    btMultiBodyConstraintSolver solver_;
    btSphereShape nothing_{0.01};
    std::unique_ptr<btMultiBodyDynamicsWorld> world_;
    std::unique_ptr<btMultiBody> tree_;
    std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
    std::vector<std::unique_ptr<btMultiBodyConstraint>> constraints_;
    std::vector<std::pair<btMultiBodyJointMotor*, double>> motors_;
    std::vector<int> link_of_;  // by body
    std::vector<double> masses_;
    std::vector<Vec3> inertias_;
    double damping_ = 0;
    mutable bool fresh_ = false;
    mutable std::vector<btVector3> spins_, velocities_;  // the base first
};

}  // namespace

std::unique_ptr<Engine> make_bullet_tree_engine() {
    return std::make_unique<BulletTreeEngine>();
}

}  // namespace jostle::bench::accuracy
