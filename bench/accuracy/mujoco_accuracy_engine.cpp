// SPDX-License-Identifier: MIT
#include "bench/accuracy/accuracy_engine_kinds.h"

#include <mujoco/mujoco.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/mujoco_model.h"

namespace jostle::bench::accuracy {
namespace {

// MuJoCo terminates the program on errors, and would write errors and warnings to a file in the
// working directory.
void end_on_error(const char* message) {
    std::fprintf(stderr, "jostle-bench: mujoco: %s\n", message);
    _exit(1);
}
void ignore_warning(const char*) {}

Vec3 from(const mjtNum* v) {
    return {v[0], v[1], v[2]};
}

// The force laws of a scene, for MuJoCo's force callback, which runs in each stage of a step and
// has no reference to a world.
thread_local double central_pull = 0, mutual_pull = 0;

void pull_bodies(const mjModel* model, mjData* data) {
    std::vector<Vec3> at;
    std::vector<double> masses;
    for (int k = 1; k < model->nbody; k++) {
        at.push_back(from(data->xipos + 3 * k));
        masses.push_back(model->body_mass[k]);
    }
    const std::vector<Vec3> mutual = mutual_forces(masses, at, mutual_pull);
    for (std::size_t k = 0; k < at.size(); k++) {
        const double distance = length(at[k]);
        Vec3 sum = mutual[k];
        if (central_pull > 0)
            sum -= at[k] * (central_pull * masses[k] / (distance * distance * distance));
        const mjtNum force[3] = {sum.x, sum.y, sum.z}, torque[3] = {0, 0, 0};
        const mjtNum point[3] = {at[k].x, at[k].y, at[k].z};
        mj_applyFT(model, data, force, torque, point, static_cast<int>(k) + 1, data->qfrc_passive);
    }
}

class MujocoAccuracyEngine final : public Engine {
public:
    MujocoAccuracyEngine() {
        mju_user_error = end_on_error;
        mju_user_warning = ignore_warning;
    }
    ~MujocoAccuracyEngine() override {
        mjcb_passive = nullptr;
        if (data_) mj_deleteData(data_);
        if (model_) mj_deleteModel(model_);
    }
    MujocoAccuracyEngine(const MujocoAccuracyEngine&) = delete;
    MujocoAccuracyEngine& operator=(const MujocoAccuracyEngine&) = delete;

    Status build(const Scene& scene, const std::string& mode) override {
        const BodyTree tree = tree_of(scene);
        auto xml = mujoco_xml(scene, tree, mode);
        if (!xml) return xml.error();
        if (auto status = load(*xml); !status) return status;
        for (std::size_t k = 0; k < scene.bodies.size(); k++)
            bodies_.push_back(mj_name2id(model_, mjOBJ_BODY, ("b" + std::to_string(k)).c_str()));
        set_velocities(scene, tree);
        int motor = 0;  // in the order of the bodies in the file
        for (const BodyTree::Node& node : tree.nodes)
            if (node.joint && node.joint->motor) data_->ctrl[motor++] = node.joint->motor->speed;
        hard_ = mode.ends_with("-hard");
        damping_ = scene.damping;
        central_pull = scene.central_pull;
        mutual_pull = scene.mutual_pull;
        mjcb_passive = central_pull > 0 || mutual_pull > 0 ? pull_bodies : nullptr;
        return {};
    }

    void step(double dt) override {
        if (dt != model_->opt.timestep) set_step(dt);
        if (damping_ > 0) slow_down();
        mj_step(model_, data_);
        fresh_ = false;
    }

    BodyState state(int body) const override {
        if (!fresh_) {  // after a step, derived poses are those of its start
            mj_kinematics(model_, data_);
            mj_comPos(model_, data_);
            mj_comVel(model_, data_);
            fresh_ = true;
        }
        const int id = bodies_[static_cast<std::size_t>(body)];
        const mjtNum* q = data_->xquat + 4 * id;
        mjtNum velocity[6];  // angular velocity first
        mj_objectVelocity(model_, data_, mjOBJ_BODY, id, velocity, 0);
        return {from(data_->xpos + 3 * id),
                {q[1], q[2], q[3], q[0]},
                from(velocity + 3),
                from(velocity)};
    }

    void set_damping(double rate) override {
        damping_ = rate;
        mju_zero(data_->xfrc_applied, 6 * model_->nbody);
    }

    void set_velocity(int, Vec3) override {}  // no driven bodies are created

    // MuJoCo resets the state if a number is not finite.
    std::string failure() const override {
        for (const int warning :
             {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC, mjWARN_CNSTRFULL, mjWARN_CONTACTFULL})
            if (data_->warning[warning].number > 0) return mju_warningText(warning, 0);
        return {};
    }

private:
    Status load(const std::string& xml) {
        const auto files = std::make_unique<mjVFS>();
        mj_defaultVFS(files.get());
        mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(xml.size()));
        std::memcpy(files->filedata[0], xml.data(), xml.size());
        char error[512] = "";
        model_ = mj_loadXML("scene.xml", files.get(), error, sizeof error);
        mj_deleteVFS(files.get());
        if (!model_) return Error{.message = std::string("mujoco: ") + error};
        data_ = mj_makeData(model_);
        return {};
    }

    void set_velocities(const Scene& scene, const BodyTree& tree) {
        for (std::size_t k = 0; k < scene.bodies.size(); k++) {
            const int joint = model_->body_jntadr[bodies_[k]];
            if (joint < 0) continue;
            const Body& body = scene.bodies[k];
            mjtNum* rates = data_->qvel + model_->jnt_dofadr[joint];
            const int parent = tree.nodes[k].parent;
            Vec3 v = body.velocity, w = body.spin;
            if (parent != ground) {
                v = v - scene.bodies[static_cast<std::size_t>(parent)].velocity;
                w = w - scene.bodies[static_cast<std::size_t>(parent)].spin;
            }
            const Vec3 local = inverse_rotate(body.pose.rotation, w);
            const int type = model_->jnt_type[joint];
            const auto write = [&](mjtNum* to, Vec3 from_vector) {
                for (int i = 0; i < 3; i++) to[i] = from_vector[i];
            };
            if (type == mjJNT_FREE) {
                write(rates, v);
                write(rates + 3, local);
            } else if (type == mjJNT_BALL) {
                write(rates, local);
            } else if (type == mjJNT_HINGE) {
                rates[0] = dot(tree.nodes[k].joint->axis, w);
            } else {
                rates[0] = dot(tree.nodes[k].joint->axis, v);
            }
        }
    }

    void set_step(double dt) {
        model_->opt.timestep = dt;
        if (!hard_) return;
        for (int k = 0; k < model_->ngeom; k++) model_->geom_solref[mjNREF * k] = 2 * dt;
        for (int k = 0; k < model_->njnt; k++) model_->jnt_solref[mjNREF * k] = 2 * dt;
        for (int k = 0; k < model_->neq; k++) model_->eq_solref[mjNREF * k] = 2 * dt;
    }

    void slow_down() {
        for (std::size_t k = 0; k < bodies_.size(); k++) {
            const BodyState now = state(static_cast<int>(k));
            const int id = bodies_[k];
            const Vec3 force = now.velocity * (-damping_ * model_->body_mass[id]);
            const mjtNum* moments = model_->body_inertia + 3 * id;
            const Vec3 local = inverse_rotate(now.rotation, now.spin);
            const Vec3 torque = rotate(now.rotation, scaled(local, from(moments))) * -damping_;
            for (int i = 0; i < 3; i++) {
                data_->xfrc_applied[6 * id + i] = force[i];
                data_->xfrc_applied[6 * id + 3 + i] = torque[i];
            }
        }
    }

    mjModel* model_ = nullptr;
    mjData* data_ = nullptr;
    std::vector<int> bodies_;  // MuJoCo's ids
    bool hard_ = false;
    double damping_ = 0;
    mutable bool fresh_ = false;
};

}  // namespace

std::unique_ptr<Engine> make_mujoco_accuracy_engine() {
    return std::make_unique<MujocoAccuracyEngine>();
}

}  // namespace jostle::bench::accuracy
