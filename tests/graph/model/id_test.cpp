// Tests that the C++ compiler rejects one type of id (such as ResourceId) where another type (such as PassId)
// is needed.
#include "weft/id.h"

#include <gtest/gtest.h>

#include <concepts>
#include <type_traits>
#include <vector>

#include "weft/plan.h"

namespace weft {
namespace {

template <class A, class B>
concept Comparable = requires(A a, B b) {
    a == b;
};

static_assert(!std::is_constructible_v<PassId, ResourceId>);
static_assert(!std::is_constructible_v<ResourceId, QueueIndex>);
static_assert(!std::is_assignable_v<PassId&, ResourceId>);
static_assert(!std::is_convertible_v<uint32_t, PassId>);
static_assert(!Comparable<PassId, ResourceId>);
static_assert(std::is_constructible_v<PassId, uint32_t>);
static_assert(std::is_convertible_v<PassId, uint32_t>);
static_assert(Comparable<PassId, PassId>);
static_assert(Comparable<PassId, uint32_t>);

TEST(Id, IsNoneUntilItIsSet) {
    EXPECT_EQ(PassId(), kNoId);
    EXPECT_EQ(uint32_t{PassId()}, UINT32_MAX);
    EXPECT_NE(PassId(0), kNoId);
}

TEST(Id, IsAnIndexOfVectors) {
    const std::vector<int> squares{0, 1, 4, 9};
    int sum = 0;
    for (PassId id(0); id < squares.size(); ++id) sum += squares[id];
    EXPECT_EQ(sum, 14);
    EXPECT_LT(PassId(1), PassId(2));
    EXPECT_LT(PassId(7), kNoId);
}

}  // namespace
}  // namespace weft
