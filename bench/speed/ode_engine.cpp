// SPDX-License-Identifier: MIT
#include "speed/ode_engine.h"

#include <ode/ode.h>

#include <algorithm>
#include <vector>

namespace jostle::bench {
namespace {

using physics::Quat;
using physics::Transform;
using physics::Vec3;

constexpr int contacts_per_pair = 4;

struct OdeQuaternion {
    dQuaternion values;  // w first

    explicit OdeQuaternion(Quat q) : values{q.w, q.x, q.y, q.z} {}
};

dGeomID make_geom(const physics::Sphere& sphere) {
    return dCreateSphere(nullptr, sphere.radius);
}

dGeomID make_geom(const physics::Capsule& capsule) {
    return dCreateCapsule(nullptr, capsule.radius, 2 * capsule.half_length);
}

dGeomID make_geom(const physics::Box& box) {
    const Vec3 sides = box.half_extents * 2;
    return dCreateBox(nullptr, sides.x, sides.y, sides.z);
}

dMass ode_mass(const Form& form) {
    const SolidMass solid = solid_mass(form);
    dMass mass;
    dMassSetParameters(&mass, solid.mass, 0, 0, 0, solid.inertia.x, solid.inertia.y,
                       solid.inertia.z, 0, 0, 0);
    return mass;
}

// ODE's capsules lie along z, the scenes' along y.
Quat geom_rotation(const Form& form) {
    return std::holds_alternative<physics::Capsule>(form)
               ? physics::from_axis_angle({1, 0, 0}, -0.5 * physics::pi)
               : Quat{};
}

class OdeEngine final : public Engine {
public:
    OdeEngine() {
        dInitODE2(0);
        dRandSetSeed(0);  // QuickStep shuffles its rows; each run shuffles alike
        world_ = dWorldCreate();
        space_ = dHashSpaceCreate(nullptr);
        contacts_ = dJointGroupCreate(0);
    }

    ~OdeEngine() override {
        dJointGroupDestroy(contacts_);
        for (const dGeomID geom : loose_geoms_) dGeomDestroy(geom);
        dSpaceDestroy(space_);  // and the geoms in it
        dWorldDestroy(world_);
        dCloseODE();
    }

    OdeEngine(const OdeEngine&) = delete;
    OdeEngine& operator=(const OdeEngine&) = delete;

    physics::Status init(const SceneDescription& scene, int, bool sleep) override {
        scene_ = &scene;
        dWorldSetGravity(world_, gravity.x, gravity.y, gravity.z);
        // A fraction of the velocity a step, where the scenes have one a second.
        dWorldSetDamping(world_, damping * step_seconds, damping * step_seconds);
        dWorldSetLinearDampingThreshold(world_, 0);
        dWorldSetAngularDampingThreshold(world_, 0);
        dWorldSetAutoDisableFlag(world_, sleep ? 1 : 0);
        for (const SceneBody& body : scene.bodies) add_body(body);
        for (const SceneJoint& joint : scene.joints) {
            // Whom a joint keeps from colliding ODE knows by their bodies, and a fixed one has
            // none.
            for (const std::uint32_t end : {joint.a, joint.b})
                if (scene.bodies[end].fixed && scene.bodies[end].collides)
                    return physics::Error{.message = "ode: a joint to a fixed body that collides"};
            add_joint(joint);
        }
        return {};
    }

    void step() override {
        dSpaceCollide(space_, this, &OdeEngine::on_pair);
        dWorldQuickStep(world_, step_seconds);
        dJointGroupEmpty(contacts_);
    }

    Transform pose(std::uint32_t body) const override {
        const dBodyID id = bodies_[body];
        if (id == nullptr) return scene_->bodies[body].pose;
        const dReal *at = dBodyGetPosition(id), *q = dBodyGetQuaternion(id);
        return {{at[0], at[1], at[2]}, {q[1], q[2], q[3], q[0]}};
    }

    Vec3 velocity(std::uint32_t body) const override {
        if (bodies_[body] == nullptr) return {};
        const dReal* v = dBodyGetLinearVel(bodies_[body]);
        return {v[0], v[1], v[2]};
    }

    void set_velocity(std::uint32_t body, Vec3 linear) override {
        dBodyEnable(bodies_[body]);
        dBodySetLinearVel(bodies_[body], linear.x, linear.y, linear.z);
    }

    int awake() const override {
        return static_cast<int>(std::ranges::count_if(bodies_, is_awake));
    }

private:
    static void on_pair(void* self, dGeomID a, dGeomID b) {
        static_cast<OdeEngine*>(self)->collide(a, b);
    }

    static bool is_awake(dBodyID body) { return body != nullptr && dBodyIsEnabled(body) != 0; }

    void collide(dGeomID a, dGeomID b) {
        const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
        if (!is_awake(body_a) && !is_awake(body_b)) return;
        if (body_a && body_b && dAreConnectedExcluding(body_a, body_b, dJointTypeContact)) return;
        dContact found[contacts_per_pair];
        const int count = dCollide(a, b, contacts_per_pair, &found[0].geom, sizeof(dContact));
        for (int k = 0; k < count; k++) {
            found[k].surface.mode = dContactApprox1;  // or mu would be a force
            found[k].surface.mu = pair_friction;
            dJointAttach(dJointCreateContact(world_, contacts_, &found[k]), body_a, body_b);
        }
    }

    // A fixed body is none at all in ODE, only a geom.
    void add_body(const SceneBody& body) {
        const dGeomID geom = std::visit([](const auto& f) { return make_geom(f); }, body.form);
        if (body.collides)
            dSpaceAdd(space_, geom);
        else
            loose_geoms_.push_back(geom);
        bodies_.push_back(body.fixed ? nullptr : add_moving(body, geom));
        if (!body.fixed) return;
        const Vec3 at = body.pose.position;
        dGeomSetPosition(geom, at.x, at.y, at.z);
        dGeomSetQuaternion(geom,
                           OdeQuaternion(body.pose.rotation * geom_rotation(body.form)).values);
    }

    dBodyID add_moving(const SceneBody& body, dGeomID geom) {
        const dBodyID id = dBodyCreate(world_);
        const dMass mass = ode_mass(body.form);
        dBodySetMass(id, &mass);
        dGeomSetBody(geom, id);
        dGeomSetOffsetQuaternion(geom, OdeQuaternion(geom_rotation(body.form)).values);
        const Vec3 at = body.pose.position, v = body.velocity;
        dBodySetPosition(id, at.x, at.y, at.z);
        dBodySetQuaternion(id, OdeQuaternion(body.pose.rotation).values);
        dBodySetLinearVel(id, v.x, v.y, v.z);
        return id;
    }

    void add_joint(const SceneJoint& joint) {
        const Vec3 at = joint.anchor;
        if (joint.kind == SceneJointKind::hinge) return add_hinge(joint);
        const dJointID ball = dJointCreateBall(world_, nullptr);
        dJointAttach(ball, bodies_[joint.a], bodies_[joint.b]);
        dJointSetBallAnchor(ball, at.x, at.y, at.z);
        if (joint.kind == SceneJointKind::cone_twist) add_swing_limits(joint);
    }

    void add_hinge(const SceneJoint& joint) {
        const Vec3 at = joint.anchor, axis = joint.axis;
        const dJointID hinge = dJointCreateHinge(world_, nullptr);
        dJointAttach(hinge, bodies_[joint.a], bodies_[joint.b]);
        dJointSetHingeAnchor(hinge, at.x, at.y, at.z);
        dJointSetHingeAxis(hinge, axis.x, axis.y, axis.z);
        // ODE's hinge angle is that of a against b.
        dJointSetHingeParam(hinge, dParamLoStop, -joint.upper);
        dJointSetHingeParam(hinge, dParamHiStop, -joint.lower);
    }

    // Euler angles: two swings, the first about a's own normal, then the twist about b's own axis.
    // In this order the twist does not change where the arm points.
    void add_swing_limits(const SceneJoint& joint) {
        const dJointID motor = dJointCreateAMotor(world_, nullptr);
        dJointAttach(motor, bodies_[joint.a], bodies_[joint.b]);
        dJointSetAMotorMode(motor, dAMotorEuler);
        dJointSetAMotorAxis(motor, 0, 1, joint.normal.x, joint.normal.y, joint.normal.z);
        dJointSetAMotorAxis(motor, 2, 2, joint.axis.x, joint.axis.y, joint.axis.z);
        const double twist = std::max(-joint.lower, joint.upper);
        dJointSetAMotorParam(motor, dParamLoStop, -joint.swing);
        dJointSetAMotorParam(motor, dParamHiStop, joint.swing);
        dJointSetAMotorParam(motor, dParamLoStop2, -joint.swing);
        dJointSetAMotorParam(motor, dParamHiStop2, joint.swing);
        dJointSetAMotorParam(motor, dParamLoStop3, -twist);
        dJointSetAMotorParam(motor, dParamHiStop3, twist);
    }

    const SceneDescription* scene_ = nullptr;
    dWorldID world_ = nullptr;
    dSpaceID space_ = nullptr;
    dJointGroupID contacts_ = nullptr;
    std::vector<dBodyID> bodies_;       // null: fixed
    std::vector<dGeomID> loose_geoms_;  // in no space: these collide with nothing
};

}  // namespace

std::unique_ptr<Engine> make_ode_engine() {
    return std::make_unique<OdeEngine>();
}

}  // namespace jostle::bench
