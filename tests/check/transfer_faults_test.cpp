// Tests queue family ownership transfers of an image: the checker must accept those of the compiler, and must
// report an acquire barrier that matches no release barrier.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/graph/samples/graph_builder.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

// Returns a plan in which passes on a compute queue write both mips of an image. If `one_reader` is true, one
// pass on the graphics queue reads both mips; otherwise each mip has its own reader.
FramePlan family_transfer(bool one_reader) {
    GraphBuilder b;
    const ResourceId image = b.image("image", Format::r32u, 16, 2);
    for (uint32_t mip = 0; mip < 2; ++mip)
        b.compute("make" + std::to_string(mip), {{"dst", image, Access::storage_write, one_cell(mip), kNoId}})
            .queue = QueueKind::compute;
    for (uint32_t mip = 0; mip < (one_reader ? 1u : 2u); ++mip) {
        const ResourceId target = b.image("target" + std::to_string(mip));
        const SubresourceRange range = one_reader ? b.resource(image).whole() : one_cell(mip);
        b.pass("draw" + std::to_string(mip), PassKind::fullscreen,
               {{"src", image, Access::sampled_read, range, 0},
                {"dst", target, Access::color_write, {}, kNoId}});
        b.pass("read" + std::to_string(mip), PassKind::readback,
               {{"src", target, Access::copy_read, {}, kNoId}});
    }
    const ResolvedGraph graph = b.build();
    CompileOptions options;
    options.queues = {{QueueKind::graphics, 0}, {QueueKind::compute, 1}};
    return compile(graph, content_needs(graph, 1), options);
}

bool has_c360(const FramePlan& plan) {
    const Diagnostics faults = check_plan(plan);
    return std::any_of(faults.begin(), faults.end(), [](const Diagnostic& d) { return d.code == "C360"; });
}

TEST(TransferFaults, NoneHoweverManyPassesWriteAndRead) {
    for (const bool one_reader : {true, false}) {
        const Diagnostics faults = check_plan(family_transfer(one_reader));
        EXPECT_TRUE(faults.empty()) << to_text(faults);
    }
}

TEST(TransferFaults, HalvesOfOtherRanges) {
    FramePlan plan = family_transfer(true);
    for (PassStep& step : plan.barriers.steps) {
        const auto is_half = [](const BarrierDecl& b) { return b.src_family != b.dst_family; };
        if (std::count_if(step.barriers.begin(), step.barriers.end(), is_half) != 2) continue;
        // Replaces both acquire barriers by a single one for both mips, which matches neither of the two
        // release barriers.
        const auto first = std::find_if(step.barriers.begin(), step.barriers.end(), is_half);
        BarrierDecl both = *first;
        std::erase_if(step.barriers, is_half);
        both.range.mip = 0;
        both.range.mips = 2;
        step.barriers.push_back(both);
        EXPECT_TRUE(has_c360(plan));
        return;
    }
    FAIL() << "the reader does not acquire two mips from two passes";
}

}  // namespace
}  // namespace weft::test
