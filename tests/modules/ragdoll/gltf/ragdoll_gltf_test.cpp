// SPDX-License-Identifier: MIT
//
// A skeleton of seven joints becomes a figure: positions, radii and masses of its bones; and it
// falls.
#include "jostle/modules/ragdoll_gltf.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "tests/modules/ragdoll/gltf/gltf_skeleton.h"

namespace jostle::modules {
namespace {

using namespace physics;

const Capsule& capsule_of(const RagdollBone& bone) {
    return std::get<Capsule>(bone.shapes.front().geometry);
}
GltfFigureOptions with_knees() {
    GltfFigureOptions options;
    for (const char* name : {"left shin", "right shin"})
        options.bones.push_back({.name = name,
                                 .kind = GltfBoneKind::hinge,
                                 .axis = {1, 0, 0},
                                 .lower = -0.1,
                                 .upper = 2});
    return options;
}

TEST(RagdollGltf, bones_span_joint_to_joint) {
    const GltfFigure figure = figure_from_gltf(GltfSkeleton().gltf()).value();
    const std::vector<RagdollBone>& bones = figure.def.bones;
    ASSERT_EQ(bones.size(), 7u);
    EXPECT_EQ(bones[0].name, "hips");
    EXPECT_EQ(figure.nodes[0], 1u);
    // Breadth-first: the hips, their children, then the grandchildren.
    const char* names[] = {"hips", "spine",     "left thigh", "right thigh",
                           "head", "left shin", "right shin"};
    const int parents[] = {-1, 0, 0, 0, 1, 2, 3};
    for (std::size_t k = 0; k < 7; k++) {
        EXPECT_EQ(bones[k].name, names[k]);
        EXPECT_EQ(bones[k].parent, parents[k]);
    }
    // Metres, y up: the shin of 0.5 m hangs from the knee at 0.55 m.
    EXPECT_LT(length(bones[5].rest.position - Vec3{0.1, 0.3, 0}), 1e-6);
    EXPECT_LT(length(bones[5].frame.position - Vec3{0.1, 0.55, 0}), 1e-6);
    EXPECT_LT(length(rotate(bones[5].rest.rotation, {0, 1, 0}) - Vec3{0, -1, 0}), 1e-6);
    EXPECT_LT(length(rotate(bones[2].frame.rotation, {1, 0, 0}) - Vec3{0, -1, 0}), 1e-6)
        << "the cone axis is the bone";
}

// Tubes of 6 to 15 cm, over the whole length.
TEST(RagdollGltf, bone_radius_matches_mesh_and_mass_matches_volume) {
    const GltfFigure figure = figure_from_gltf(GltfSkeleton().gltf()).value();
    const std::vector<RagdollBone>& bones = figure.def.bones;
    EXPECT_NEAR(capsule_of(bones[1]).radius, 0.15, 1e-6);
    EXPECT_NEAR(capsule_of(bones[5]).radius, 0.06, 1e-6);
    EXPECT_NEAR(capsule_of(bones[5]).half_length, 0.25 - 0.06, 1e-6);
    World world = std::move(*World::create({}));
    auto module = std::make_unique<Ragdolls>();
    Ragdolls& ragdolls = *module;
    world.add_module(std::move(module)).expect();
    const RagdollId id = ragdolls.add(world, figure.def, {}).value();
    const double volume = pi * 0.06 * 0.06 * (2 * 0.19 + 4.0 / 3 * 0.06);
    EXPECT_NEAR(world.body((*ragdolls.bodies(id))[5])->mass, 1000 * volume, 1e-3);
}

TEST(RagdollGltf, gltf_glb_and_external_buffers_give_the_same_figure) {
    const GltfSkeleton skeleton;
    const GltfFigure text = figure_from_gltf(skeleton.gltf()).value();
    const GltfFigure binary = figure_from_gltf(skeleton.glb()).value();
    const auto folder = std::filesystem::path(testing::TempDir()) / "ragdoll_gltf_test";
    std::filesystem::create_directories(folder);
    const std::vector<std::byte> bytes = skeleton.with_external_buffer();
    std::ofstream(folder / "skeleton.gltf", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    std::ofstream(folder / "skeleton.bin", std::ios::binary)
        .write(skeleton.buffer.data(), static_cast<std::streamsize>(skeleton.buffer.size()));
    const GltfFigure external = read_gltf_figure((folder / "skeleton.gltf").string()).value();
    std::filesystem::remove_all(folder);
    for (const GltfFigure* other : {&binary, &external})
        for (std::size_t k = 0; k < 7; k++) {
            EXPECT_EQ(other->def.bones[k].rest, text.def.bones[k].rest);
            EXPECT_EQ(capsule_of(other->def.bones[k]).radius, capsule_of(text.def.bones[k]).radius);
        }
}

// Knees are hinges about x; merged joints add their mesh to the parent.
TEST(RagdollGltf, options_select_the_joint_kind) {
    GltfFigureOptions options = with_knees();
    options.bones.push_back({.name = "head", .kind = GltfBoneKind::merged});
    options.bones.push_back({.name = "spine", .kind = GltfBoneKind::ball});
    options.default_bone.swing = 0.3;
    const GltfFigure figure = figure_from_gltf(GltfSkeleton().gltf(), options).value();
    const std::vector<RagdollBone>& bones = figure.def.bones;
    ASSERT_EQ(bones.size(), 6u);
    EXPECT_TRUE(std::holds_alternative<BallJoint>(bones[1].joint));
    EXPECT_NEAR(length(bones[1].rest.position - Vec3{0, 1.4, 0}), 0, 1e-6)
        << "it extends to the joint of the head, which is its tip";
    EXPECT_EQ(std::get<ConeTwistJoint>(bones[2].joint).swing, 0.3);
    const auto& knee = std::get<HingeJoint>(bones[4].joint);
    EXPECT_EQ(knee.limit, (JointLimit{true, -0.1, 2}));
    EXPECT_LT(length(rotate(bones[4].frame.rotation, {0, 0, 1}) - Vec3{1, 0, 0}), 1e-6);
    options.bones.push_back({.name = "tail"});
    EXPECT_EQ(figure_from_gltf(GltfSkeleton().gltf(), options).error().message,
              "the skin has no joint \"tail\"");
}

// It falls and sleeps, and its joints hold.
TEST(RagdollGltf, imported_figure_falls_and_sleeps) {
    const GltfFigure figure = figure_from_gltf(GltfSkeleton().glb(), with_knees()).value();
    World world = std::move(*World::create({}));
    world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).value();
    auto module = std::make_unique<Ragdolls>();
    Ragdolls& ragdolls = *module;
    world.add_module(std::move(module)).expect();
    const RagdollId id =
        ragdolls.add(world, figure.def, {.rotation = from_axis_angle({0, 0, 1}, 0.3)}).value();
    for (int k = 0; k < 1500; k++) world.step(1.0 / 60).expect();
    EXPECT_EQ(world.summary().awake_bodies, 0);
    EXPECT_LT(world.summary().max_joint_error, 1e-3);
    for (const BodyId body : *ragdolls.bodies(id))
        EXPECT_LT(world.body(body)->pose.position.y, 0.5);
}

}  // namespace
}  // namespace jostle::modules
