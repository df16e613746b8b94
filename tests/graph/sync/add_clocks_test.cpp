#include <gtest/gtest.h>

#include <array>

#include "graph/sync/synchronize.h"
#include "tests/graph/samples/hand_made.h"

namespace weft::test {
namespace {

// Returns the clocks for two queues. rows[p][q] is 1 + the latest position on queue q that surely runs before
// position p, or 0 if there is none.
ClockTable clock_table(const std::vector<std::array<uint32_t, 2>>& rows) {
    ClockTable table{2, {}};
    for (const std::array<uint32_t, 2>& row : rows)
        table.values.insert(table.values.end(), row.begin(), row.end());
    return table;
}

// Returns a schedule with positions 0 and 2 on queue 0, and positions 1 and 3 on queue 1.
Schedule alternating() {
    Schedule order;
    order.order = {0, 1, 2, 3};
    order.position = {0, 1, 2, 3};
    order.queue = {0, 1, 0, 1};
    order.queues = two_queues();
    return order;
}

TEST(AddClocks, AQueueKnowsItsOwnPastAndNoOther) {
    EXPECT_EQ(add_clocks(alternating(), {}).clocks, (clock_table({{0, 0}, {0, 0}, {1, 0}, {0, 2}})));
}

TEST(AddClocks, ADependencyHandsOnAllThatItsSourceKnows) {
    // Position 1 waits for 0, and position 2 waits for 1. So position 2 comes after position 1 of queue 1,
    // and position 3 comes after position 0 of queue 0.
    const Schedule order = add_clocks(alternating(), {{0, 1, false, kNoId}, {1, 2, false, kNoId}});
    EXPECT_EQ(order.clocks, (clock_table({{0, 0}, {1, 0}, {1, 2}, {1, 2}})));
    // Position 3 waits for 2, and 2 comes after 0 on the same queue. So position 3 comes after 0 and 2.
    EXPECT_EQ(add_clocks(alternating(), {{2, 3, false, kNoId}}).clocks,
              (clock_table({{0, 0}, {0, 0}, {1, 0}, {3, 2}})));
}

TEST(AddClocks, TheFrameBeforeAndTheEndOfTheFrameAreNoPositions) {
    const Schedule order = add_clocks(alternating(), {{3, 0, true, kNoId}, {3, 4, false, kNoId}});
    EXPECT_EQ(order.clocks, (clock_table({{0, 0}, {0, 0}, {1, 0}, {0, 2}})));
}

TEST(AddClocks, NothingElseOfTheScheduleChanges) {
    const Schedule before = alternating(), after = add_clocks(before, {{0, 1, false, kNoId}});
    EXPECT_EQ(after.order, before.order);
    EXPECT_EQ(after.position, before.position);
    EXPECT_EQ(after.queue, before.queue);
    EXPECT_EQ(after.queues, before.queues);
}

}  // namespace
}  // namespace weft::test
