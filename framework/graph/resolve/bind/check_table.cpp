#include "graph/resolve/bind/check_table.h"

#include <algorithm>

#include "graph/diagnostics/quantity_text.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"

namespace weft {
namespace {

constexpr const char* kOtherWays =
    "use a draw list, whose materials Weft binds in descriptor set 2, use an array with a size and only "
    "constants as its index, or choose another device";

uint32_t count_textures(const PassBinding& pass, const UseDecl& use) {
    return pass.declared.shapes.resources[use.resource].textures;
}

std::string table_port_text(const PassBinding& pass, const std::string& port) {
    return "port " + quote(port) + " of pass " + quote(pass.draft.decl.name);
}

bool report_misuse(PassBinding& pass, const UseDecl& use, const std::string& fault, const std::string& help) {
    Diagnostic& d = pass.error(use.loc, "W232",
                               table_port_text(pass, use.port) + " is " +
                                   quote(pass.declared.resource_name(use.resource)) +
                                   ", a table of textures, but " + fault);
    add_help(d, help);
    return false;
}

// Returns the array of textures that messages about tables name, preferably an array without a size. Returns
// null if the shader has no array of textures.
const ShaderBinding* find_array(const ShaderInterface& shader) {
    const auto find = [&](auto&& matches) {
        const auto found = std::ranges::find_if(shader.bindings, [&](const ShaderBinding& b) {
            return b.set == kPortSet && b.kind == BindingKind::sampled_image && matches(b);
        });
        return found == shader.bindings.end() ? nullptr : &*found;
    };
    const ShaderBinding* table = find([](const ShaderBinding& b) { return b.is_runtime_array; });
    return table != nullptr ? table : find([](const ShaderBinding& b) { return b.is_array; });
}

SourceLoc port_loc(const PassBinding& pass, const ShaderBinding* array) {
    for (const UseDecl& use : pass.bound.uses)
        if (array != nullptr && use.port == array->name && use.loc.line != 0) return use.loc;
    return pass.draft.desc->shader_loc.line != 0 ? pass.draft.desc->shader_loc : pass.draft.decl.loc;
}

// Returns the number of sampled images in a stage. For an array without a size, counts the textures of the
// table that is bound to the array.
uint64_t count_sampled(const PassBinding& pass, ShaderStageMask stage) {
    uint64_t count = 0;
    for (const ShaderBinding& binding : pass.draft.shader->bindings) {
        if (binding.kind != BindingKind::sampled_image || (binding.stages & stage) == 0) continue;
        const auto use = std::ranges::find_if(pass.bound.uses, [&](const UseDecl& u) {
            return binding.is_runtime_array && u.binding == binding.binding && is_table(pass, u);
        });
        count += use != pass.bound.uses.end() ? count_textures(pass, *use) : binding.count;
    }
    return count;
}

}  // namespace

bool is_table(const PassBinding& pass, const UseDecl& use) {
    return count_textures(pass, use) > 0;
}

bool check_table(PassBinding& pass, const UseDecl& use, const ShaderBinding* binding) {
    const std::string shader = "shader " + quote(pass.draft.desc->shader);
    const std::string declare = "declare it in the shader as `uniform sampler2D " + use.port + "[];`";
    if (use.is_output)
        return report_misuse(pass, use, "it is an output of the pass",
                             "passes can only sample tables: \"in\"");
    if (use.each != EachPart::none)
        return report_misuse(pass, use, "it has \"each\"",
                             "remove \"each\": the elements of the array are the textures of the table");
    if (binding == nullptr) return report_misuse(pass, use, "the port is no array in " + shader, declare);
    if (binding->kind != BindingKind::sampled_image || !binding->is_array || binding->dim != ImageDim::d2 ||
        binding->arrayed || binding->multisampled || binding->shadow)
        return report_misuse(pass, use, shader + " declares it as something else than an array of sampler2D",
                             declare);
    const uint32_t textures = count_textures(pass, use);
    if (binding->is_runtime_array || textures <= binding->count) return true;
    return report_misuse(pass, use,
                         "the array in " + shader + " has only " + count_text(binding->count, "element") +
                             " for its " + count_text(textures, "texture"),
                         "declare the array with at least " + count_text(textures, "element") + ": " +
                             binding->name + "[" + std::to_string(textures) +
                             "]. If all indices are constants, an array without a size has only the elements "
                             "up to the greatest index");
}

void refuse_tables(PassBinding& pass) {
    for (UseDecl& use : pass.bound.uses) {
        if (!is_table(pass, use)) continue;
        use.access = Access::none;
        report_misuse(
            pass, use, "passes of type " + quote(pass.draft.decl.type) + " cannot use tables",
            "only shaders of compute, fullscreen and raster passes can sample the textures of a table");
    }
}

void check_table_support(PassBinding& pass) {
    const ShaderInterface& shader = *pass.draft.shader;
    const ShaderBinding* array = find_array(shader);
    if (array == nullptr && !shader.needs_texture_tables) return;
    const DeviceProfile& profile = pass.declared.input.profile;
    const std::string where =
        array != nullptr ? table_port_text(pass, array->name) : "pass " + quote(pass.draft.decl.name);
    if (shader.needs_texture_tables && profile.texture_table == 0) {
        Diagnostic& d = pass.error(
            port_loc(pass, array), "W231",
            where + ": shader " + quote(pass.draft.desc->shader) +
                " indexes a table of textures, but the device has no tables. They need the Vulkan features "
                "runtimeDescriptorArray, shaderSampledImageArrayDynamicIndexing and "
                "shaderSampledImageArrayNonUniformIndexing");
        add_help(d, kOtherWays);
        add_help(d, "the device profile " + quote(profile.name) + " has \"textureTable\": 0");
        return;
    }
    if (array == nullptr || !array->is_runtime_array) return;
    for (const ShaderStage stage : {ShaderStage::vertex, ShaderStage::fragment, ShaderStage::compute}) {
        const uint64_t count = count_sampled(pass, stage_bit(stage));
        if (count <= profile.texture_table) continue;
        Diagnostic& d =
            pass.error(port_loc(pass, array), "W231",
                       where + ": shader " + quote(pass.draft.desc->shader) + " samples " +
                           std::to_string(count) + " textures in one stage; the device allows " +
                           std::to_string(profile.texture_table) + " in shaders with tables (textureTable)");
        add_help(d, "use fewer textures, or a draw list, whose materials Weft binds in descriptor set 2");
        return;
    }
}

}  // namespace weft
