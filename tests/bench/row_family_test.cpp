// SPDX-License-Identifier: MIT
//
// Families of the accuracy benchmark: reproducible draws, and a scene of each family.
#include "bench/accuracy/row_family.h"

#include <gtest/gtest.h>

#include <set>

#include "bench/accuracy/accuracy_engine_kinds.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/run_row.h"

namespace {

using namespace jostle::bench::accuracy;

RowFamily family_of_three_parameters() {
    return {.name = "test",
            .tolerances = {1},
            .parameters = {{.name = "shape", .choices = {"box", "ball", "can"}},
                           {"ratio", 0.01, 100, Parameter::Scale::logarithmic},
                           {"count", 2, 5, Parameter::Scale::whole}},
            .drawn = 0};
}

std::vector<std::string> abouts(const std::vector<Experiment>& members) {
    std::vector<std::string> texts;
    for (const Experiment& member : members) texts.push_back(member.about);
    return texts;
}

TEST(RowFamily, draws_are_reproducible_and_independent_of_their_number) {
    const RowFamily family = family_of_three_parameters();
    const auto few = abouts(drawn_members(family, 3, 7)),
               many = abouts(drawn_members(family, 9, 7));
    EXPECT_EQ(few, std::vector(many.begin(), many.begin() + 3));
    EXPECT_NE(few, abouts(drawn_members(family, 3, 8)));
    EXPECT_EQ(drawn_members(family, 2, 7)[1].name, "test-s7-2");
}

TEST(RowFamily, draws_stay_in_range_and_cover_choices_and_whole_numbers) {
    RowFamily family = family_of_three_parameters();
    std::multiset<std::string> shapes;
    std::set<int> counts;
    int below_one = 0;
    family.start = [&](const Values& v, double) -> ExperimentRun {
        shapes.insert(v.choice("shape"));
        counts.insert(v.whole("count"));
        EXPECT_GE(v["ratio"], 0.01);
        EXPECT_LE(v["ratio"], 100);
        below_one += v["ratio"] < 1;
        return {};
    };
    for (const Experiment& member : drawn_members(family, 60, 1)) (void)member.start(0);
    for (const char* shape : {"box", "ball", "can"}) EXPECT_EQ(shapes.count(shape), 20u);
    EXPECT_EQ(counts, (std::set<int>{2, 3, 4, 5}));
    EXPECT_NEAR(below_one, 30, 12);
}

TEST(RowFamily, examples_precede_drawn_members) {
    RowFamily family = family_of_three_parameters();
    family.about = "a test";
    family.examples = {{1, 0.5, 3}};
    family.drawn = 2;
    const auto members = members_of(family);
    ASSERT_EQ(members.size(), 3u);
    EXPECT_EQ(members[0].name, "test-1");
    EXPECT_EQ(members[0].about, "a test: shape ball, ratio 0.5, count 3");
    EXPECT_EQ(members[0].family, "test");
}

TEST(RowFamily, names_are_unique_and_members_are_experiments) {
    std::set<std::string> names;
    for (const RowFamily& family : all_families()) {
        EXPECT_TRUE(names.insert(family.name).second) << family.name;
        EXPECT_EQ(find_experiment(family.name), nullptr) << "a scene has the name of a family";
        const Experiment* first = find_experiment(family.name + "-1");
        ASSERT_NE(first, nullptr) << family.name;
        EXPECT_EQ(first->family, family.name);
    }
    EXPECT_EQ(find_family("slide")->name, "slide");
    EXPECT_EQ(find_family("q9"), nullptr);
}

TEST(RowFamily, one_other_member_of_each_family_runs) {
    const EngineKind& jostle = engine_kinds()[0];
    for (const RowFamily& family : all_families()) {
        const Row row =
            run_row(drawn_members(family, 1, 5)[0], jostle, jostle.modes[0], 60, Timing::none);
        EXPECT_TRUE(row.usable()) << family.name << ": " << row.failed << row.unsupported;
    }
}

// A closed form that is wrong would not be approached.
TEST(RowFamily, sliding_bodies_approach_their_closed_forms) {
    const EngineKind& jostle = engine_kinds()[0];
    for (const char* name : {"slide-1", "belt-1", "roll-1", "land-1", "swing-1"}) {
        const Experiment& member = *find_experiment(name);
        EXPECT_LT(run_row(member, jostle, "sub16", 480, Timing::none).error, 2e-3) << name;
    }
}

TEST(RowFamily, peers_lack_features_of_jostle_alone) {
    const EngineKind* bullet = find_engine_kind("bullet");
    if (!bullet->make) GTEST_SKIP() << "not built in";
    const auto row = [&](const char* name) {
        return run_row(*find_experiment(name), *bullet, bullet->modes[0], 60, Timing::none);
    };
    EXPECT_EQ(row("gate-1").unsupported, "triggers are not implemented for the peers");
    EXPECT_EQ(row("carousel-1").unsupported,
              "rotating driven bodies are not implemented for the peers");
    EXPECT_TRUE(row("graded-1").usable());
}

}  // namespace
