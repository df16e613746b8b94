#include "weft/access.h"

#include <array>
#include <initializer_list>
#include <string_view>

#include "graph/model/access_table.h"

namespace weft {
namespace {

StageMask shader_stage_mask(ShaderStageMask stages) {
    StageMask mask = stage::kNone;
    if (stages & stage_bit(ShaderStage::vertex)) mask |= stage::kVertexShader;
    if (stages & stage_bit(ShaderStage::fragment)) mask |= stage::kFragmentShader;
    if (stages & stage_bit(ShaderStage::compute)) mask |= stage::kComputeShader;
    return mask;
}

// Returns the pipeline stages, accesses and layout for an access to an image. For buffers, access_state()
// sets the layout to undefined afterwards.
AccessState image_state(Access a, StageMask shaders, bool is_depth) {
    const AccessRow& row = access_row(a);
    const bool in_shaders = row.stages == stage::kNone && row.mask != access::kNone;
    const bool samples_depth = a == Access::sampled_read && is_depth;
    return {in_shaders ? shaders : row.stages, row.mask,
            samples_depth ? Layout::depth_read_only : row.layout};
}

// A set of accesses.
struct AccessSet {
    uint32_t bits = 0;

    constexpr AccessSet(std::initializer_list<Access> members) {
        for (const Access a : members) bits |= 1u << static_cast<uint32_t>(a);
    }
    [[nodiscard]] constexpr bool contains(Access a) const {
        return (bits >> static_cast<uint32_t>(a) & 1) != 0;
    }
};
constexpr AccessSet kOnlyWrites{Access::storage_write, Access::color_write, Access::depth_write,
                                Access::copy_write,    Access::blit_write,  Access::clear_write};
constexpr AccessSet kReadWrites{Access::storage_read_write, Access::color_read_write,
                                Access::depth_read_write};

constexpr std::array<std::string_view, stage::kCount> kStageNames{"draw_indirect",
                                                                  "vertex_input",
                                                                  "vertex_shader",
                                                                  "early_fragment_tests",
                                                                  "fragment_shader",
                                                                  "late_fragment_tests",
                                                                  "color_output",
                                                                  "compute_shader",
                                                                  "copy",
                                                                  "blit",
                                                                  "resolve",
                                                                  "clear",
                                                                  "host"};

constexpr std::array<std::string_view, access::kCount> kAccessNames{
    "indirect_read",       "index_read",    "vertex_read",    "uniform_read", "sampled_read",
    "storage_read",        "storage_write", "color_read",     "color_write",  "depth_stencil_read",
    "depth_stencil_write", "transfer_read", "transfer_write", "host_read",    "host_write"};

template <size_t N>
std::string mask_text(uint32_t mask, const std::array<std::string_view, N>& names) {
    std::string text;
    for (size_t i = 0; i < N; ++i) {
        if (!(mask & (1u << i))) continue;
        if (!text.empty()) text += "|";
        text += names[i];
    }
    return text.empty() ? "none" : text;
}

}  // namespace

AccessState access_state(Access a, ShaderStageMask shader_stages, AspectMask aspects) {
    const bool is_depth = (aspects & (aspect::kDepth | aspect::kStencil)) != 0;
    AccessState state = image_state(a, shader_stage_mask(shader_stages), is_depth);
    if (aspects == aspect::kNone) {
        state.layout = Layout::undefined;
        if (a == Access::sampled_read) state.access = access::kStorageRead;
        // A barrier for the fill of a buffer names two stages, clear and copy, because validation layers and
        // drivers disagree on which of the two stages vkCmdFillBuffer belongs to.
        if (a == Access::clear_write) state.stages |= stage::kCopy;
    }
    return state;
}

bool reads(Access a) {
    return a != Access::none && !kOnlyWrites.contains(a);
}

bool writes(Access a) {
    return kOnlyWrites.contains(a) || kReadWrites.contains(a);
}

std::string stages_text(StageMask mask) {
    return mask_text(mask, kStageNames);
}

std::string access_text(AccessMask mask) {
    return mask_text(mask, kAccessNames);
}

std::string layout_text(Layout layout) {
    constexpr std::array<const char*, 9> kNames{"undefined",        "general",         "color_attachment",
                                                "depth_attachment", "depth_read_only", "shader_read_only",
                                                "transfer_src",     "transfer_dst",    "present"};
    return kNames.at(static_cast<size_t>(layout));
}

std::string access_name(Access a) {
    constexpr std::array<const char*, 21> kNames{"none",
                                                 "indirect_read",
                                                 "index_read",
                                                 "vertex_read",
                                                 "uniform_read",
                                                 "sampled_read",
                                                 "storage_read",
                                                 "storage_write",
                                                 "storage_read_write",
                                                 "color_write",
                                                 "color_read_write",
                                                 "depth_write",
                                                 "depth_read_write",
                                                 "depth_read",
                                                 "copy_read",
                                                 "copy_write",
                                                 "blit_read",
                                                 "blit_write",
                                                 "clear_write",
                                                 "host_read",
                                                 "present"};
    return kNames.at(static_cast<size_t>(a));
}

}  // namespace weft
