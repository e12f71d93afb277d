// SPDX-License-Identifier: MIT
#include "bench/accuracy/accuracy_engine_kinds.h"

#include <ode/ode.h>

#include <cmath>
#include <cstdarg>
#include <utility>
#include <vector>

#include "bench/accuracy/accuracy_bodies.h"

namespace jostle::bench::accuracy {
namespace {

constexpr int contacts_per_pair = 4;

// The direct solver reports a lost pivot and continues; the error of the run shows the
// consequences.
void drop_message(int, const char*, va_list) {}

struct OdeQuaternion {
    dQuaternion values;  // w first
    explicit OdeQuaternion(Quat q) : values{q.w, q.x, q.y, q.z} {}
};

Vec3 from(const dReal* v) {
    return {v[0], v[1], v[2]};
}

struct GeomMaker {
    dSpaceID space;

    dGeomID operator()(const physics::Sphere& sphere) const {
        return dCreateSphere(space, sphere.radius);
    }
    dGeomID operator()(const physics::Box& box) const {
        const Vec3 sides = box.half_extents * 2;
        return dCreateBox(space, sides.x, sides.y, sides.z);
    }
    dGeomID operator()(const physics::Cylinder& cylinder) const {
        return dCreateCylinder(space, cylinder.radius, 2 * cylinder.half_length);
    }
    dGeomID operator()(const physics::Capsule& c) const {
        return dCreateCapsule(space, c.radius, 2 * c.half_length);
    }
    dGeomID operator()(const OtherShape&) const { return nullptr; }
    dGeomID operator()(const physics::Plane& plane) const {
        return dCreatePlane(space, plane.normal.x, plane.normal.y, plane.normal.z, 0);
    }
    dGeomID operator()(const HullPoints&) const { return nullptr; }
};

// ODE's cylinders and capsules are along z, those of the benchmark along y.
Quat geom_rotation(const Body& body) {
    return std::holds_alternative<physics::Cylinder>(*body.shape) ||
                   std::holds_alternative<physics::Capsule>(*body.shape)
               ? physics::from_axis_angle({1, 0, 0}, -0.5 * physics::pi)
               : Quat{};
}

class OdeAccuracyEngine final : public Engine {
public:
    OdeAccuracyEngine() {
        dInitODE2(0);
        dSetMessageHandler(drop_message);
        dRandSetSeed(0);  // QuickStep shuffles its rows; the seed makes runs repeatable
        world_ = dWorldCreate();
        space_ = dHashSpaceCreate(nullptr);
        contacts_ = dJointGroupCreate(0);
    }
    ~OdeAccuracyEngine() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
        dCloseODE();
    }
    OdeAccuracyEngine(const OdeAccuracyEngine&) = delete;
    OdeAccuracyEngine& operator=(const OdeAccuracyEngine&) = delete;

    Status build(const Scene& scene, const std::string& mode) override {
        if (scene.continuous) return Error{.message = "ode has no continuous collision detection"};
        quick_ = mode.starts_with("quick");
        if (quick_) dWorldSetQuickStepNumIterations(world_, std::stoi(mode.substr(5)));
        const Vec3 gravity = scene.gravity;
        dWorldSetGravity(world_, gravity.x, gravity.y, gravity.z);
        dWorldSetAutoDisableFlag(world_, 0);
        friction_ = scene.friction;
        restitution_ = scene.restitution;
        pull_ = scene.central_pull;
        mutual_pull_ = scene.mutual_pull;
        damping_ = scene.damping;
        for (const Body& body : scene.bodies)
            if (auto status = add_body(body); !status) return status;
        for (const Joint& joint : scene.joints) {
            if (joint.misaligned_anchor_b)
                return Error{.message = "misaligned joints are not implemented for ode"};
            add_joint(joint);
        }
        return {};
    }

    void step(double dt) override {
        if (dt != last_dt_) tune(dt);
        if (pull_ > 0)
            for (const dBodyID body : bodies_) {
                const Vec3 at = from(dBodyGetPosition(body));
                dMass mass;
                dBodyGetMass(body, &mass);
                const Vec3 force = at * (-pull_ * mass.mass / std::pow(length(at), 3));
                dBodyAddForce(body, force.x, force.y, force.z);
            }
        if (mutual_pull_ > 0) pull_each_other();
        dSpaceCollide(space_, this, &OdeAccuracyEngine::on_pair);
        if (quick_)
            dWorldQuickStep(world_, dt);
        else
            dWorldStep(world_, dt);
        dJointGroupEmpty(contacts_);
    }

    BodyState state(int body) const override {
        const dBodyID id = bodies_[static_cast<std::size_t>(body)];
        if (id == nullptr) return {};
        const dReal* q = dBodyGetQuaternion(id);
        return {from(dBodyGetPosition(id)),
                {q[1], q[2], q[3], q[0]},
                from(dBodyGetLinearVel(id)),
                from(dBodyGetAngularVel(id))};
    }

    void set_damping(double rate) override {
        damping_ = rate;
        last_dt_ = 0;
    }

    void set_velocity(int body, Vec3 v) override {
        dBodySetLinearVel(bodies_[static_cast<std::size_t>(body)], v.x, v.y, v.z);
    }

private:
    void pull_each_other() {
        std::vector<Vec3> at;
        std::vector<double> masses;
        for (const dBodyID body : bodies_) {
            dMass mass;
            dBodyGetMass(body, &mass);
            at.push_back(from(dBodyGetPosition(body)));
            masses.push_back(mass.mass);
        }
        const std::vector<Vec3> forces = mutual_forces(masses, at, mutual_pull_);
        for (std::size_t k = 0; k < bodies_.size(); k++)
            dBodyAddForce(bodies_[k], forces[k].x, forces[k].y, forces[k].z);
    }

    static void on_pair(void* self, dGeomID a, dGeomID b) {
        static_cast<OdeAccuracyEngine*>(self)->collide(a, b);
    }

    void collide(dGeomID a, dGeomID b) {
        const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
        if (!body_a && !body_b) return;
        if (body_a && body_b && dAreConnectedExcluding(body_a, body_b, dJointTypeContact)) return;
        dContact found[contacts_per_pair];
        const int count = dCollide(a, b, contacts_per_pair, &found[0].geom, sizeof(dContact));
        for (int k = 0; k < count; k++) {
            found[k].surface.mode = dContactApprox1;  // otherwise mu is a force
            found[k].surface.mu = friction_;
            if (restitution_ > 0) {
                found[k].surface.mode |= dContactBounce;
                found[k].surface.bounce = restitution_;
                found[k].surface.bounce_vel = 0;
            }
            dJointAttach(dJointCreateContact(world_, contacts_, &found[k]), body_a, body_b);
        }
    }

    Status add_body(const Body& body) {
        dGeomID geom = nullptr;
        if (body.shape) {
            geom = std::visit(GeomMaker{space_}, *body.shape);
            if (!geom) return Error{.message = "ode's hulls do not collide with each other"};
        }
        if (body.motion == Motion::fixed) {
            bodies_.push_back(nullptr);
            if (!geom || std::holds_alternative<physics::Plane>(*body.shape)) return {};
            const auto& [at, rotation] = body.pose;
            dGeomSetPosition(geom, at.x, at.y, at.z);
            dGeomSetQuaternion(geom, OdeQuaternion(rotation * geom_rotation(body)).values);
            return {};
        }
        const dBodyID id = dBodyCreate(world_);
        bodies_.push_back(id);
        dMass mass;
        dMassSetParameters(&mass, body.mass, 0, 0, 0, body.inertia.x, body.inertia.y,
                           body.inertia.z, 0, 0, 0);
        dBodySetMass(id, &mass);
        const Vec3 at = body.pose.position, v = body.velocity, w = body.spin;
        dBodySetPosition(id, at.x, at.y, at.z);
        dBodySetQuaternion(id, OdeQuaternion(body.pose.rotation).values);
        dBodySetLinearVel(id, v.x, v.y, v.z);
        dBodySetAngularVel(id, w.x, w.y, w.z);
        if (body.motion == Motion::kinematic) dBodySetKinematic(id);
        if (geom) {
            dGeomSetBody(geom, id);
            dGeomSetOffsetQuaternion(geom, OdeQuaternion(geom_rotation(body)).values);
        }
        return {};
    }

    void add_joint(const Joint& joint) {
        const dBodyID a = joint.a == ground ? nullptr : bodies_[static_cast<std::size_t>(joint.a)];
        const dBodyID b = bodies_[static_cast<std::size_t>(joint.b)];
        const Vec3 at = joint.anchor, end = joint.anchor_b, axis = joint.axis;
        dJointID id = nullptr;
        switch (joint.kind) {
            case JointKind::ball:
                id = dJointCreateBall(world_, nullptr);
                dJointAttach(id, a, b);
                dJointSetBallAnchor(id, at.x, at.y, at.z);
                return;
            case JointKind::hinge:
                return add_hinge(joint, a, b);
            case JointKind::slider:
                id = dJointCreateSlider(world_, nullptr);
                dJointAttach(id, a, b);
                dJointSetSliderAxis(id, axis.x, axis.y, axis.z);
                return;
            case JointKind::fixed:
                id = dJointCreateFixed(world_, nullptr);
                dJointAttach(id, a, b);
                dJointSetFixed(id);
                return;
            case JointKind::rod:
            case JointKind::spring:
                id = dJointCreateDBall(world_, nullptr);
                dJointAttach(id, a, b);
                dJointSetDBallAnchor1(id, at.x, at.y, at.z);
                dJointSetDBallAnchor2(id, end.x, end.y, end.z);
                if (joint.kind == JointKind::rod) return;
                dJointSetDBallDistance(id, joint.rest_length);
                springs_.emplace_back(id, joint);
                return;
        }
    }

    // ODE's hinge angle is that of a relative to b, but that of b relative to the ground.
    void add_hinge(const Joint& joint, dBodyID a, dBodyID b) {
        const Vec3 at = joint.anchor, axis = joint.axis;
        const dJointID id = dJointCreateHinge(world_, nullptr);
        dJointAttach(id, a, b);
        dJointSetHingeAnchor(id, at.x, at.y, at.z);
        dJointSetHingeAxis(id, axis.x, axis.y, axis.z);
        if (joint.limit) {
            const Limit limit = *joint.limit;
            dJointSetHingeParam(id, dParamLoStop, a ? -limit.upper : limit.lower);
            dJointSetHingeParam(id, dParamHiStop, a ? -limit.lower : limit.upper);
        }
        if (!joint.motor) return;
        dJointSetHingeParam(id, dParamVel, a ? -joint.motor->speed : joint.motor->speed);
        dJointSetHingeParam(id, dParamFMax, joint.motor->max_torque);
    }

    // Parameters that depend on the step: velocity damping, and springs as described in the manual.
    void tune(double dt) {
        last_dt_ = dt;
        dWorldSetLinearDampingThreshold(world_, 0);
        dWorldSetAngularDampingThreshold(world_, 0);
        for (const dBodyID body : bodies_) {
            if (!body) continue;
            dBodySetLinearDamping(body, 1 - std::exp(-damping_ * dt));
            dBodySetAngularDamping(body, 1 - std::exp(-damping_ * dt));
        }
        for (const auto& [id, joint] : springs_) {
            const double firm = dt * joint.stiffness + joint.damping;
            dJointSetDBallParam(id, dParamERP, dt * joint.stiffness / firm);
            dJointSetDBallParam(id, dParamCFM, 1 / firm);
        }
    }

    dWorldID world_ = nullptr;
    dSpaceID space_ = nullptr;
    dJointGroupID contacts_ = nullptr;
    bool quick_ = true;
    double friction_ = 0, restitution_ = 0, pull_ = 0, mutual_pull_ = 0, damping_ = 0;
    double last_dt_ = 0;
    std::vector<dBodyID> bodies_;  // null: fixed
    std::vector<std::pair<dJointID, Joint>> springs_;
};

}  // namespace

std::unique_ptr<Engine> make_ode_accuracy_engine() {
    return std::make_unique<OdeAccuracyEngine>();
}

}  // namespace jostle::bench::accuracy
