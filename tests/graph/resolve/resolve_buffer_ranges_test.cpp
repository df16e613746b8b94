// Tests references to elements of buffers: the pieces of the buffers, the versions of the pieces, and the
// errors of such references.
#include <array>

#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveBufferRanges : public ResolveTest {
 protected:
    ResolveBufferRanges() {
        shaders["make.comp"] = compute({buffer("dst", false, true)});
        shaders["move.comp"] = compute({buffer("src", true, false), buffer("dst", false, true)});
        shaders["change.comp"] = compute({buffer("dst", true, true)});
    }

    // A graph with the buffer "x" of 256 words, the buffer "y" of 64 words, and the given passes.
    static std::string graph(const std::string& passes, const std::string& more = "") {
        return R"j("resources": {"x": {"buffer": "u32", "count": 256)j" + more +
               R"j(}, "y": {"buffer": "u32", "count": 64}}, "passes": {)j" + passes + "}";
    }
    static std::string make(const char* name, const std::string& ref, const char* more = "") {
        return "\"" + std::string(name) +
               R"j(": {"type": "compute", "shader": "make.comp", "groups": 1, "out": {"dst": ")j" + ref +
               "\"}" + more + "}";
    }
    static std::string read(const char* name, const std::string& ref) {
        return "\"" + std::string(name) + R"j(": {"type": "readback", "in": {"src": ")j" + ref + "\"}}";
    }
};

constexpr SubresourceRange pieces(uint32_t first, uint32_t count) {
    return {0, 1, first, count, aspect::kColor};
}

TEST_F(ResolveBufferRanges, a_buffer_without_ranges_is_one_piece) {
    const ResolvedGraph g = good(graph(make("a", "x") + "," + read("r", "x")));
    EXPECT_TRUE(resource_in(g, "x").cuts_bytes.empty());
    EXPECT_EQ(use(g, "a", "dst").range, pieces(0, 1));
    EXPECT_FALSE(use(g, "a", "dst").bytes.has_value());
}

TEST_F(ResolveBufferRanges, ranges_cut_the_buffer_where_they_begin_and_end) {
    const ResolvedGraph g =
        good(graph(make("a", "x.range(0..63)") + "," + make("b", "x.range(128..191)") + "," +
                   make("c", "x.range(64..127)") + "," + make("d", "x.range(192..255)") + "," +
                   read("r", "x.range(100..149)") + "," + read("s", "x")));
    const ResourceDecl& x = resource_in(g, "x");
    EXPECT_EQ(x.cuts_bytes, (std::vector<uint64_t>{256, 400, 512, 600, 768}));
    EXPECT_EQ(x.whole(), pieces(0, 6));
    EXPECT_EQ(use(g, "a", "dst").range, pieces(0, 1));
    EXPECT_EQ(use(g, "b", "dst").range, pieces(3, 2));
    EXPECT_EQ(use(g, "r", "src").range, pieces(2, 2));
    EXPECT_EQ(use(g, "r", "src").bytes, (ByteRange{400, 200}));
    EXPECT_EQ(use(g, "s", "src").range, pieces(0, 6));
    EXPECT_EQ(range_text(x, use(g, "r", "src").range), ".range(100..149)");
    EXPECT_EQ(range_text(x, pieces(0, 1)), ".range(0..63)");
}

TEST_F(ResolveBufferRanges, disjoint_ranges_are_independent_and_overlapping_ones_are_ordered) {
    const ResolvedGraph g = good(graph(
        make("a", "x.range(0..63)") + "," + make("b", "x.range(64..255)") + R"j(,
        "c": {"type": "compute", "shader": "change.comp", "groups": 1, "out": {"dst": "x.range(0..127)"}},)j" +
        read("low", "x@a.range(5)") + "," + read("high", "x.range(128..140)") + "," + read("all", "x")));
    EXPECT_FALSE(has_edge(g, "a", "b", EdgeKind::waw));
    EXPECT_FALSE(has_edge(g, "b", "a", EdgeKind::waw));
    EXPECT_TRUE(has_edge(g, "a", "c", EdgeKind::waw));
    EXPECT_TRUE(has_edge(g, "b", "c", EdgeKind::waw));
    EXPECT_EQ(seen(g, "low", "src"), "a");
    EXPECT_EQ(seen(g, "high", "src"), "b");
    EXPECT_TRUE(has_edge(g, "low", "c", EdgeKind::war));
    EXPECT_FALSE(has_edge(g, "high", "c", EdgeKind::war));
    EXPECT_TRUE(has_edge(g, "c", "all", EdgeKind::raw));
}

// Compares the order of all pairs of passes that write random ranges with the overlaps of these ranges, which
// the test computes word by word.
TEST_F(ResolveBufferRanges, passes_share_an_edge_only_if_their_words_overlap) {
    uint32_t state = 1;
    const auto below = [&](uint32_t n) {
        state = state * 1664525u + 1013904223u;
        return (state >> 16) % n;
    };
    for (uint32_t round = 0; round < 30; ++round) {
        constexpr uint32_t kWriters = 5;
        std::array<std::pair<uint32_t, uint32_t>, kWriters> spans;
        std::string writers, after;
        for (uint32_t i = 0; i < kWriters; ++i) {
            const uint32_t first = below(4), last = first + below(4 - first);
            spans[i] = {first, last};
            const std::string name(1, static_cast<char>('a' + i));
            if (i > 0) writers += ",";
            writers +=
                make(name.c_str(),
                     "x.range(" + std::to_string(first * 64) + ".." + std::to_string(last * 64 + 63) + ")",
                     (after.empty() ? "" : (", \"after\": [" + after + "]").c_str()));
            after += (after.empty() ? "\"" : ", \"") + name + "\"";
        }
        const ResolvedGraph g = good(graph(writers));
        ASSERT_EQ(g.passes.size(), kWriters);
        for (uint32_t i = 0; i < kWriters; ++i)
            for (uint32_t j = i + 1; j < kWriters; ++j) {
                uint32_t shared = 0, hidden = 0;
                for (uint32_t part = 0; part < 4; ++part) {
                    const auto in = [&](uint32_t k) {
                        return part >= spans[k].first && part <= spans[k].second;
                    };
                    if (!in(i) || !in(j)) continue;
                    ++shared;
                    bool between = false;
                    for (uint32_t k = i + 1; k < j; ++k) between |= in(k);
                    hidden += between ? 1 : 0;
                }
                const char a[] = {static_cast<char>('a' + i), 0}, b[] = {static_cast<char>('a' + j), 0};
                if (shared > hidden) {
                    EXPECT_TRUE(has_edge(g, a, b, EdgeKind::waw)) << a << b << round;
                }
                if (shared == 0) {
                    EXPECT_FALSE(has_edge(g, a, b, EdgeKind::waw)) << a << b << round;
                }
            }
    }
}

TEST_F(ResolveBufferRanges, the_iterations_of_a_repeat_write_one_part_each) {
    const ResolvedGraph g = good(graph(R"j("a": {"type": "compute", "shader": "make.comp", "groups": 1,
        "repeat": {"i": "0..3"}, "out": {"dst": "x.range(64*i..64*i+63)"}},)j" +
                                       read("r", "x")));
    EXPECT_EQ(resource_in(g, "x").cuts_bytes, (std::vector<uint64_t>{256, 512, 768}));
    EXPECT_EQ(g.edges.size(), 4u);
    EXPECT_EQ(use(g, "r", "src").sources.size(), 4u);
}

TEST_F(ResolveBufferRanges, all_ages_of_a_history_have_the_same_pieces) {
    const ResolvedGraph g = good(graph(make("a", "x.range(0..63)") + "," + make("b", "x.range(64..255)") +
                                           R"j(,
        "m": {"type": "compute", "shader": "move.comp", "groups": 1, "in": {"src": "x[-1].range(128..191)"},
              "out": {"dst": "y"}},)j" + read("r", "y"),
                                       R"j(, "history": 1)j"));
    EXPECT_EQ(resource_in(g, "x").cuts_bytes, (std::vector<uint64_t>{256, 512, 768}));
    EXPECT_EQ(resource_in(g, "x[-1]").cuts_bytes, resource_in(g, "x").cuts_bytes);
    EXPECT_EQ(use(g, "m", "src").range, pieces(2, 1));
}

TEST_F(ResolveBufferRanges, copies_compare_the_sizes_of_the_ranges) {
    const ResolvedGraph g = good(graph(make("a", "x") + R"j(,
        "c": {"type": "copy", "in": {"src": "x.range(10..73)"}, "out": {"dst": "y"}},)j" +
                                       read("r", "y")));
    EXPECT_EQ(use(g, "c", "src").bytes, (ByteRange{40, 256}));
    const Diagnostic d = bad(graph(make("a", "x") + R"j(,
        "c": {"type": "copy", "in": {"src": "x.range(10..72)"}, "out": {"dst": "y"}},)j" +
                                   read("r", "y")));
    EXPECT_EQ(d.code, "W183");
    EXPECT_NE(d.message.find("252 bytes and 256 bytes"), std::string::npos) << d.message;
}

TEST_F(ResolveBufferRanges, an_unwritten_part_cannot_be_read) {
    const Diagnostic d = bad(graph(make("a", "x.range(0..63)") + "," + read("r", "x.range(0..64)")));
    EXPECT_EQ(d.code, "W110");
    EXPECT_NE(d.message.find("x.range(64)"), std::string::npos) << d.message;
}

TEST_F(ResolveBufferRanges, wrong_ranges_are_reported) {
    EXPECT_EQ(bad(graph(make("a", "x.range(192..256)"))).code, "W105");
    EXPECT_EQ(bad(graph(make("a", "x.range(64..63)"))).code, "W105");
    EXPECT_EQ(bad(graph(make("a", "x.range(0.5)"))).code, "W105");
    EXPECT_EQ(bad(graph(make("a", "x.mip(0)"))).code, "W105");
    EXPECT_EQ(bad(graph(make("a", "x.range(0).range(1)"))).code, "W106");
    EXPECT_EQ(bad(graph(R"j("a": {"type": "readback", "in": ["instances.range(0)"]})j") +
                  R"j(, "imports": {"instances": "buffer"})j")
                  .code,
              "W105");
    const Diagnostic image = bad(R"j("resources": {"i": "rgba8"}, "passes": {
        "c": {"type": "clear", "out": ["i.range(0..3)"]}})j");
    EXPECT_EQ(image.code, "W105");
    EXPECT_NE(image.message.find("is an image"), std::string::npos) << image.message;
}

TEST_F(ResolveBufferRanges, a_shader_reads_at_aligned_offsets_only) {
    profile.storage_offset_alignment_bytes = 64;
    const Diagnostic d = bad(graph(make("a", "x.range(20..40)")));
    EXPECT_EQ(d.code, "W194");
    EXPECT_NE(d.message.find("multiple of 64 bytes"), std::string::npos) << d.message;
    EXPECT_NE(d.help.front().find("element 16 or 32"), std::string::npos) << d.help.front();
    EXPECT_TRUE(run(graph(make("a", "x.range(32..40)"))).ok());
}

TEST_F(ResolveBufferRanges, a_block_must_fit_the_range) {
    shaders["make.comp"].interface.bindings.front().block_bytes = 64;
    const Diagnostic d = bad(graph(make("a", "x.range(64..78)")));
    EXPECT_EQ(d.code, "W166");
    EXPECT_NE(d.message.find("60"), std::string::npos) << d.message;
}

TEST_F(ResolveBufferRanges, the_number_of_pieces_is_limited) {
    const Result<ResolvedGraph> graph_of_pieces = run(graph(R"j("a": {"type": "clear",
        "repeat": {"i": "0..4095"}, "out": ["big.range(i)"]})j") +
                                                      R"j(,
        "consts": {"unused": 1})j");
    EXPECT_FALSE(graph_of_pieces.ok());
    const Diagnostic d = bad(R"j("resources": {"big": {"buffer": "u32", "count": 4096}},
        "passes": {"a": {"type": "clear", "repeat": {"i": "0..2047"}, "out": ["big.range(2*i)"]}})j");
    EXPECT_EQ(d.code, "W125");
    EXPECT_NE(d.message.find("4096 pieces"), std::string::npos) << d.message;
}

TEST_F(ResolveBufferRanges, an_error_in_a_range_hides_its_consequences) {
    EXPECT_EQ(bad(graph(make("a", "x.range(0..999)") + "," + read("r", "x.range(0..63)"))).code, "W105");
}

}  // namespace
}  // namespace weft::test
