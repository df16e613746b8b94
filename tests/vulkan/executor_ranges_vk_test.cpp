// Purpose: tests passes that use ranges of buffers. Random passes fill, change, move, clear and copy ranges
// of two buffers, and the results are compared with those of a loop on the CPU.
#include <random>

#include "tests/vulkan/executor_fixture.h"
#include "weft/check/check_plan.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr uint32_t kPieceWords = 64;  // 256 bytes: an offset that every device allows.
constexpr uint32_t kPieces = 6;

// A range of one of the two buffers, in pieces.
struct Part {
    uint32_t buffer = 0;
    uint32_t first = 0;
    uint32_t count = 1;
    [[nodiscard]] uint32_t begin() const { return first * kPieceWords; }
    [[nodiscard]] uint32_t words() const { return count * kPieceWords; }
    [[nodiscard]] SubresourceRange range() const { return {0, 1, first, count, aspect::kColor}; }
};

class ExecutorRangesVk : public ExecutorTest {
 protected:
    void make_shaders() {
        write_shader("fill.comp", R"(
            layout(local_size_x = 64) in;
            writeonly buffer Words { uint words[]; } dst;
            layout(push_constant) uniform Params { uint seed; } params;
            void main() {
                const uint i = gl_GlobalInvocationID.x, n = uint(dst.words.length());
                if (i < n) dst.words[i] = params.seed + i + n * 1000u;
            })");
        write_shader("change.comp", R"(
            layout(local_size_x = 64) in;
            buffer Words { uint words[]; } dst;
            layout(push_constant) uniform Params { uint seed; } params;
            void main() {
                const uint i = gl_GlobalInvocationID.x;
                if (i < uint(dst.words.length())) dst.words[i] = dst.words[i] * 3u + params.seed + i;
            })");
        write_shader("move.comp", R"(
            layout(local_size_x = 64) in;
            readonly buffer From { uint words[]; } src;
            writeonly buffer Words { uint words[]; } dst;
            layout(push_constant) uniform Params { uint seed; } params;
            void main() {
                const uint i = gl_GlobalInvocationID.x;
                if (i < uint(dst.words.length()))
                    dst.words[i] = src.words[i % uint(src.words.length())] ^ params.seed;
            })");
    }

    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    Part part() {
        const uint32_t first = below(kPieces);
        return {below(2), first, 1 + below(kPieces - first)};
    }

    PassDecl& compute(GraphBuilder& builder, const char* shader, const std::vector<test::BuilderUse>& uses,
                      const Part& target, uint32_t seed) {
        PassDecl& pass = builder.compute(name(), uses);
        use_shader(pass, shader, ProgramKind::compute);
        pass.groups = {target.count, 1, 1};
        ParamWrite write;
        write.member = "seed";
        write.scalar = ScalarType::u32;
        write.value[0] = seed;
        pass.params = {write};
        if (below(2) == 0) pass.queue = QueueKind::compute;
        return pass;
    }
    std::string name() {
        return std::string(1, static_cast<char>('a' + below(26))) + std::to_string(names_++);
    }

    // Adds a random pass to the graph, and does the same work on the CPU.
    void add_pass(GraphBuilder& builder) {
        const Part to = part();
        const uint32_t seed = below(1u << 20), kind = below(5);
        std::vector<uint32_t>& words = words_[to.buffer];
        const test::BuilderUse dst{"dst", ids_[to.buffer], Access::storage_write, to.range(), kNoId};
        if (kind == 0) {
            compute(builder, "fill.comp", {dst}, to, seed);
            for (uint32_t i = 0; i < to.words(); ++i) words[to.begin() + i] = seed + i + to.words() * 1000;
        } else if (kind == 1) {
            compute(builder, "change.comp",
                    {{"dst", ids_[to.buffer], Access::storage_read_write, to.range(), kNoId}}, to, seed);
            for (uint32_t i = 0; i < to.words(); ++i)
                words[to.begin() + i] = words[to.begin() + i] * 3 + seed + i;
        } else if (kind == 2) {
            builder
                .pass(name(), PassKind::clear,
                      {{"dst", ids_[to.buffer], Access::clear_write, to.range(), kNoId}})
                .clear = {static_cast<float>(seed), 0, 0, 0};
            for (uint32_t i = 0; i < to.words(); ++i) words[to.begin() + i] = seed;
        } else {
            add_move(builder, to, seed, kind == 3);
        }
    }

    // Adds a pass that reads a range of the other buffer: a copy, or a compute pass.
    void add_move(GraphBuilder& builder, const Part& to, uint32_t seed, bool copies) {
        Part from{1 - to.buffer, 0, to.count};
        from.first = below(kPieces - to.count + 1);
        const ResourceId source = ids_[from.buffer], target = ids_[to.buffer];
        if (copies) {
            PassDecl& pass = builder.pass(name(), PassKind::copy,
                                          {{"src", source, Access::copy_read, from.range(), kNoId},
                                           {"dst", target, Access::copy_write, to.range(), kNoId}});
            if (below(2) == 0) pass.queue = QueueKind::transfer;
        } else {
            compute(builder, "move.comp",
                    {{"src", source, Access::storage_read, from.range(), kNoId},
                     {"dst", target, Access::storage_write, to.range(), kNoId}},
                    to, seed);
        }
        for (uint32_t i = 0; i < to.words(); ++i)
            words_[to.buffer][to.begin() + i] = words_[from.buffer][from.begin() + i] ^ (copies ? 0 : seed);
    }

    void expect_words(const ReadbackData& data, const Part& from) {
        const std::vector<uint32_t> found = values_of<uint32_t>(data);
        const auto begin = words_[from.buffer].begin() + from.begin();
        EXPECT_EQ(found, (std::vector<uint32_t>(begin, begin + from.words()))) << data.pass;
    }

    void run(uint32_t seed, uint32_t queues) {
        random_.seed(seed);
        GraphBuilder builder;
        for (uint32_t b = 0; b < 2; ++b) {
            ids_[b] = builder.buffer(b == 0 ? "one" : "two", uint64_t{kPieces} * kPieceWords * 4);
            std::vector<uint64_t> cuts;
            for (uint32_t p = 1; p < kPieces; ++p) cuts.push_back(uint64_t{p} * kPieceWords * 4);
            builder.cut(ids_[b], cuts);
            words_[b].assign(size_t{kPieces} * kPieceWords, b + 5);
            builder
                .pass(b == 0 ? "wipe0" : "wipe1", PassKind::clear,
                      {{"dst", ids_[b], Access::clear_write, {}, kNoId}})
                .clear = {static_cast<float>(b + 5), 0, 0, 0};
        }
        for (uint32_t i = 0; i < 14; ++i) add_pass(builder);
        const Part some = part();
        const Part reads[] = {{0, 0, kPieces}, {1, 0, kPieces}, some};
        for (uint32_t i = 0; i < 3; ++i)
            builder.pass("read" + std::to_string(i), PassKind::readback,
                         {{"src", ids_[reads[i].buffer], Access::copy_read, reads[i].range(), kNoId}});
        const ResolvedGraph graph = builder.build();
        DeviceProfile profile;
        profile.queue_families = {
            {QueueKind::graphics, 1}, {QueueKind::compute, 1}, {QueueKind::transfer, 1}};
        CompileOptions options;
        options.queues = logical_queues(profile, queues);
        FramePlan plan = compile(graph, query_memory_needs(device(), graph), options);
        const Diagnostics faults = check_plan(plan);
        ASSERT_TRUE(faults.empty()) << to_text(faults);
        const auto executor = executor_for(input_for(std::move(plan)));
        ASSERT_NE(executor, nullptr);
        const std::vector<ReadbackData> read = run_frames(*executor, 2);
        ASSERT_EQ(read.size(), 6u);
        for (const ReadbackData& data : read) expect_words(data, reads[data.pass.back() - '0']);
        EXPECT_EQ(device().messages().count(), 0u);
    }

 private:
    std::mt19937 random_;
    ResourceId ids_[2];
    std::vector<uint32_t> words_[2];
    uint32_t names_ = 0;
};

TEST_F(ExecutorRangesVk, random_ranges_give_the_words_of_the_cpu) {
    make_shaders();
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 100 : 12;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        run(seed, seed % 2 == 0 ? 1 : 3);
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace weft::vk
