// SPDX-License-Identifier: MIT
#include "server/world/pose_list.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

std::vector<EntityPose> standing(std::size_t count) {
    std::vector<EntityPose> poses;
    for (std::size_t i = 0; i < count; i++)
        poses.push_back({.id = static_cast<EntityId>(2 * i + 1),
                         .awake = true,
                         .pose = {{static_cast<double>(i), 0, 0}, {}}});
    return poses;
}

TEST(PoseList, indexes_entities_across_blocks) {
    for (const std::size_t count : {0, 1, 127, 128, 129, 1000}) {
        const PoseList list(standing(count));
        ASSERT_EQ(list.size(), count);
        EXPECT_EQ(list.blocks().size(), (count + 127) / 128);
        std::size_t seen = 0;
        for (const EntityPose& pose : list) EXPECT_EQ(pose.id, 2 * seen++ + 1);
        EXPECT_EQ(seen, count);
        if (count > 0) {
            EXPECT_EQ(list.back().id, 2 * count - 1);
        }
    }
}

TEST(PoseList, one_moving_entity_copies_one_block) {
    PoseEditor editor;
    editor.assign(standing(1000));
    bool changed = false;
    const PoseList before = editor.take(changed);
    EXPECT_TRUE(changed);
    editor.set(500, {{500, 7, 0}, {}}, true);
    const PoseList after = editor.take(changed);
    EXPECT_TRUE(changed);
    EXPECT_EQ(before[500].pose.position.y, 0) << "who holds the old one still sees it";
    EXPECT_EQ(after[500].pose.position.y, 7);
    int shared = 0;
    for (std::size_t b = 0; b < 8; b++) shared += before.blocks()[b] == after.blocks()[b];
    EXPECT_EQ(shared, 7);
}

TEST(PoseList, setting_equal_pose_changes_nothing) {
    PoseEditor editor;
    editor.assign(standing(300));
    bool changed = false;
    const PoseList before = editor.take(changed);
    editor.set(7, {{7, 0, 0}, {}}, true);
    EXPECT_EQ(editor.take(changed).blocks(), before.blocks());
    EXPECT_FALSE(changed);
    editor.set(7, {{7, 0, 0}, {}}, false);
    EXPECT_NE(editor.take(changed).blocks(), before.blocks()) << "it fell asleep";
    EXPECT_TRUE(changed);
}

}  // namespace
}  // namespace jostle::server
