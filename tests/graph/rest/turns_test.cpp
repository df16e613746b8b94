#include "graph/rest/turns.h"

#include <gtest/gtest.h>

#include <string>

namespace weft::test {
namespace {

GroupDecl group(uint32_t rounds, uint32_t per_frame, uint32_t warm_up = GroupDecl::kAll) {
    return {.name = "g", .rounds = rounds, .per_frame = per_frame, .warm_up = warm_up};
}

// Returns rounds that have run. `since` has the frame in which each of them began to wait.
std::vector<AwakeRound> waiting(const std::vector<uint64_t>& since) {
    std::vector<AwakeRound> rounds;
    for (const uint64_t frame : since) rounds.push_back({static_cast<uint32_t>(rounds.size()), true, frame});
    return rounds;
}

std::vector<AwakeRound> never_run(uint32_t count) {
    std::vector<AwakeRound> rounds;
    for (uint32_t round = 0; round < count; ++round) rounds.push_back({round, false, 0});
    return rounds;
}

// Returns the rounds, such as "2 0", and the number of ignored entries, such as " dropped 1".
std::string turns(const GroupDecl& group, const std::vector<AwakeRound>& awake,
                  const std::vector<uint32_t>* list = nullptr) {
    const TurnChoice choice = choose_turns(group, awake, list);
    std::string text;
    for (const uint32_t round : choice.rounds) text += (text.empty() ? "" : " ") + std::to_string(round);
    return text + (choice.dropped == 0 ? "" : " dropped " + std::to_string(choice.dropped));
}

std::string listed(const GroupDecl& group, const std::vector<AwakeRound>& awake,
                   const std::vector<uint32_t>& list) {
    return turns(group, awake, &list);
}

TEST(Turns, TheLongestWaitingComesFirst) {
    EXPECT_EQ(turns(group(4, 2), waiting({5, 3, 4, 3})), "1 3");
    EXPECT_EQ(turns(group(4, 1), waiting({3, 3, 3, 2})), "3");
    EXPECT_EQ(turns(group(4, 9), waiting({5, 3, 4, 3})), "1 3 2 0") << "all of them have a turn";
    EXPECT_EQ(turns(group(4, GroupDecl::kAll), {}), "");
}

TEST(Turns, PerFrameNoneMeansNone) {
    EXPECT_EQ(turns(group(3, 0), waiting({1, 1, 1})), "");
    EXPECT_EQ(listed(group(3, 0), waiting({1, 1, 1}), {2}), " dropped 1");
    EXPECT_EQ(turns(group(3, 0, 0), never_run(3)), "");
    EXPECT_EQ(turns(group(3, 0, 1), never_run(3)), "0") << "the rounds warm up all the same";
}

TEST(Turns, RoundsThatHaveNeverRunComeFirst) {
    std::vector<AwakeRound> awake = waiting({1, 2, 3});
    awake[2].has_run = false;
    EXPECT_EQ(turns(group(3, 1, 1), awake), "2");
    EXPECT_EQ(turns(group(3, 2, 1), awake), "2 0");
}

TEST(Turns, WarmUpLimitsTheRoundsOfAFrame) {
    EXPECT_EQ(turns(group(4, 1), never_run(4)), "0 1 2 3") << "without warmUp, all run in the first frame";
    EXPECT_EQ(turns(group(4, 1, 2), never_run(4)), "0 1");
    EXPECT_EQ(turns(group(4, 3, 2), never_run(4)), "0 1 2") << "the higher number counts";
    EXPECT_EQ(turns(group(4, 1, 3), waiting({1, 1, 1, 1})), "0") << "the group has warmed up";
}

TEST(Turns, AListGivesTheRoundsAndTheirOrder) {
    EXPECT_EQ(listed(group(4, GroupDecl::kAll), waiting({1, 1, 1, 1}), {3, 0}), "3 0");
    EXPECT_EQ(listed(group(4, 2), waiting({1, 1, 1, 1}), {}), "") << "an empty list gives no turns";
}

TEST(Turns, EntriesThatDoNotCountAreDropped) {
    EXPECT_EQ(listed(group(3, GroupDecl::kAll), waiting({1, 1, 1}), {2, 2, 9, 0}), "2 0 dropped 2");
    EXPECT_EQ(listed(group(3, 1), waiting({1, 1, 1}), {2, 0, 1}), "2 dropped 2");
    EXPECT_EQ(listed(group(3, 1), waiting({1, 1, 1}), {7, 1}), "1 dropped 1")
        << "a round that does not exist takes no place";
}

TEST(Turns, RestingRoundsOfAListAreSkipped) {
    const std::vector<AwakeRound> awake{{0, true, 1}, {2, true, 1}};
    EXPECT_EQ(listed(group(3, GroupDecl::kAll), awake, {1, 2, 0}), "2 0");
    EXPECT_EQ(listed(group(3, GroupDecl::kAll), awake, {1}), "");
}

TEST(Turns, RoundsThatHaveNeverRunNeedNoList) {
    std::vector<AwakeRound> awake = waiting({1, 1, 1});
    awake[1].has_run = awake[2].has_run = false;
    EXPECT_EQ(listed(group(3, 1), awake, {0}), "1 2 0");
    EXPECT_EQ(listed(group(3, 1, 1), awake, {0}), "1 0");
    EXPECT_EQ(listed(group(3, 1, 0), awake, {0}), "0");
    EXPECT_EQ(listed(group(3, 2, 1), awake, {1, 2}), "1 2") << "no round runs twice";
}

}  // namespace
}  // namespace weft::test
