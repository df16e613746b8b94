#include "graph/model/access_table.h"

#include <array>
#include <cassert>

namespace weft {
namespace {

constexpr StageMask kDepthStages = stage::kEarlyFragmentTests | stage::kLateFragmentTests;
constexpr AccessMask kColorAccess = access::kColorRead | access::kColorWrite;
constexpr AccessMask kDepthAccess = access::kDepthStencilRead | access::kDepthStencilWrite;
constexpr AccessMask kStorageAccess = access::kStorageRead | access::kStorageWrite;
constexpr StageMask kShaderStages = stage::kNone;
constexpr UsageMask kNoUsage = 0;
constexpr UsageMask kColorUse = usage::kColorAttachment;
constexpr UsageMask kDepthUse = usage::kDepthAttachment;

// In the order of the enum. The row of sampled_read is for colour images; access_state() changes it for depth
// images and buffers.
constexpr std::array<AccessRow, 21> kAccessRows{{
    {Access::none, stage::kNone, access::kNone, Layout::undefined, kNoUsage},
    {Access::indirect_read, stage::kDrawIndirect, access::kIndirectRead, Layout::undefined, usage::kIndirect},
    {Access::index_read, stage::kVertexInput, access::kIndexRead, Layout::undefined, usage::kIndex},
    {Access::vertex_read, stage::kVertexInput, access::kVertexRead, Layout::undefined, usage::kVertex},
    {Access::uniform_read, kShaderStages, access::kUniformRead, Layout::undefined, usage::kUniform},
    {Access::sampled_read, kShaderStages, access::kSampledRead, Layout::shader_read_only, usage::kSampled},
    {Access::storage_read, kShaderStages, access::kStorageRead, Layout::general, usage::kStorage},
    {Access::storage_write, kShaderStages, access::kStorageWrite, Layout::general, usage::kStorage},
    {Access::storage_read_write, kShaderStages, kStorageAccess, Layout::general, usage::kStorage},
    {Access::color_write, stage::kColorOutput, access::kColorWrite, Layout::color_attachment, kColorUse},
    {Access::color_read_write, stage::kColorOutput, kColorAccess, Layout::color_attachment, kColorUse},
    {Access::depth_write, kDepthStages, kDepthAccess, Layout::depth_attachment, kDepthUse},
    {Access::depth_read_write, kDepthStages, kDepthAccess, Layout::depth_attachment, kDepthUse},
    {Access::depth_read, kDepthStages, access::kDepthStencilRead, Layout::depth_read_only, kDepthUse},
    {Access::copy_read, stage::kCopy, access::kTransferRead, Layout::transfer_src, usage::kTransferSrc},
    {Access::copy_write, stage::kCopy, access::kTransferWrite, Layout::transfer_dst, usage::kTransferDst},
    {Access::blit_read, stage::kBlit, access::kTransferRead, Layout::transfer_src, usage::kTransferSrc},
    {Access::blit_write, stage::kBlit, access::kTransferWrite, Layout::transfer_dst, usage::kTransferDst},
    {Access::clear_write, stage::kClear, access::kTransferWrite, Layout::transfer_dst, usage::kTransferDst},
    {Access::host_read, stage::kHost, access::kHostRead, Layout::general, kNoUsage},
    {Access::present, stage::kNone, access::kNone, Layout::present, kNoUsage},
}};

constexpr bool is_in_order() {
    for (size_t i = 0; i < kAccessRows.size(); ++i)
        if (kAccessRows[i].access != static_cast<Access>(i)) return false;
    return true;
}
static_assert(is_in_order());

}  // namespace

const AccessRow& access_row(Access a) {
    assert(static_cast<size_t>(a) < kAccessRows.size());
    return kAccessRows[static_cast<size_t>(a)];
}

}  // namespace weft
