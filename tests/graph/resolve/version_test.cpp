#include "graph/resolve/version.h"

#include <algorithm>

#include "tests/graph/resolve/stage_fixture.h"

namespace weft::test {
namespace {

class VersionTest : public StageTest {
 protected:
    VersionTest() { x = add_image("x"); }

    VersionedGraph run() {
        Suspects all = suspects();
        return version({input_, values, shapes, expansion}, {shapes.resources, bound, {}}, std::move(all),
                       reporter);
    }
    static std::vector<PassId> producers(const UseDecl& use) {
        std::vector<PassId> ids;
        for (const VersionSource& source : use.sources) ids.push_back(source.producer);
        return ids;
    }

    ResourceId x = kNoId;
    ResolveInput input_ = input();
};

TEST_F(VersionTest, AReadSeesTheWriteWhateverTheirNames) {
    const PassId read = add_pass("a_read");
    const PassId write = add_pass("b_write");
    add_use(read, "src", x, Access::sampled_read);
    add_use(write, "dst", x, Access::storage_write);
    const VersionedGraph found = run();
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(producers(found.passes[read].uses[0]), std::vector<PassId>{write});
    ASSERT_EQ(found.edges.size(), 1u);
    EXPECT_EQ(found.edges[0].from, write);
    EXPECT_EQ(found.edges[0].to, read);
    EXPECT_EQ(found.edges[0].kind, EdgeKind::raw);
}

TEST_F(VersionTest, AWriteInPlaceReadsTheVersionBeforeIt) {
    const PassId change = add_pass("a_change");
    const PassId make = add_pass("b_make");
    add_use(change, "dst", x, Access::storage_write);
    add_use(make, "dst", x, Access::storage_write);
    bound[change].ports[0].rank = WriteRank::in_place;
    const VersionedGraph found = run();
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(found.passes[change].uses[0].access, Access::storage_read_write);
    EXPECT_EQ(producers(found.passes[change].uses[0]), std::vector<PassId>{make});
    EXPECT_EQ(found.passes[make].uses[0].access, Access::storage_write);
}

TEST_F(VersionTest, WritersWithoutAnOrderAreAFault) {
    add_use(add_pass("a"), "dst", x, Access::storage_write);
    add_use(add_pass("b"), "dst", x, Access::storage_write);
    (void)run();
    ASSERT_EQ(codes(), "W111");
    EXPECT_EQ(errors.front().message,
              "passes \"a\" and \"b\" both write \"x\", but nothing determines their order");
}

TEST_F(VersionTest, AfterOrdersWriters) {
    describe_pass("a").after = {"b"};
    const PassId a = add_pass("a");
    const PassId b = add_pass("b");
    for (const PassId pass : {a, b}) add_use(pass, "dst", x, Access::storage_write);
    const VersionedGraph found = run();
    EXPECT_EQ(codes(), "");
    for (const EdgeDecl& edge : found.edges) EXPECT_EQ(edge.from, b);
    EXPECT_EQ(found.edges.size(), 2u) << "after and write after write";
}

TEST_F(VersionTest, APinnedReadComesBeforeTheNextWrite) {
    const PassId change = add_pass("a_change");
    const PassId make = add_pass("b_make");
    const PassId read = add_pass("c_read");
    add_use(change, "dst", x, Access::storage_write);
    add_use(make, "dst", x, Access::storage_write);
    add_use(read, "src", x, Access::sampled_read);
    bound[change].ports[0].rank = WriteRank::in_place;
    bound[read].ports[0].pins = {make};
    const VersionedGraph found = run();
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(producers(found.passes[read].uses[0]), std::vector<PassId>{make});
    const bool war = std::ranges::any_of(found.edges, [&](const EdgeDecl& e) {
        return e.from == read && e.to == change && e.kind == EdgeKind::war;
    });
    EXPECT_TRUE(war);
}

TEST_F(VersionTest, AReadThatNoPassWritesIsAFaultUnlessAWriterIsSuspect) {
    add_use(add_pass("read"), "src", x, Access::sampled_read);
    shapes.suspects.writers[x] = 1;
    (void)run();
    EXPECT_EQ(codes(), "");
    shapes.suspects.writers[x] = 0;
    (void)run();
    EXPECT_EQ(codes(), "W110");
}

TEST_F(VersionTest, PassesThatWaitForEachOtherAreACycle) {
    const ResourceId y = add_image("y");
    const PassId a = add_pass("a");
    const PassId b = add_pass("b");
    add_use(a, "src", y, Access::sampled_read);
    add_use(a, "dst", x, Access::storage_write);
    add_use(b, "src", x, Access::sampled_read);
    add_use(b, "dst", y, Access::storage_write);
    (void)run();
    ASSERT_EQ(codes(), "W150");
    EXPECT_EQ(errors.front().message, "dependency cycle: a (reads y) -> b (reads x) -> a");
}

TEST_F(VersionTest, EachMipHasVersionsOfItsOwn) {
    shapes.resources[x].mips = 2;
    const PassId one = add_pass("one");
    const PassId two = add_pass("two");
    const PassId read = add_pass("z_read");
    add_use(one, "dst", x, Access::storage_write).range.mip = 0;
    add_use(two, "dst", x, Access::storage_write).range.mip = 1;
    add_use(read, "src", x, Access::sampled_read).range.mips = 2;
    const VersionedGraph found = run();
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(producers(found.passes[read].uses[0]), (std::vector<PassId>{one, two}));
}

}  // namespace
}  // namespace weft::test
