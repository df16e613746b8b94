#include "graph/resolve/bind/check_array.h"

#include <array>

#include "graph/diagnostics/quantity_text.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"

namespace weft {
namespace {

std::string each_port_text(const PassBinding& pass, const UseDecl& use) {
    return "port " + quote(use.port) + " of pass " + quote(pass.draft.decl.name);
}

const char* part_name(EachPart each) {
    return each == EachPart::mip ? "mip" : "layer";
}

struct ImageLimit {
    BindingKind kind;
    const char* what;
    const char* name;
    uint32_t DeviceProfile::*value;
};
constexpr std::array kImageLimits{
    ImageLimit{BindingKind::sampled_image, "sampled images", "maxSampledImagesPerStage",
               &DeviceProfile::max_sampled_images_per_stage},
    ImageLimit{BindingKind::storage_image, "storage images", "maxStorageImagesPerStage",
               &DeviceProfile::max_storage_images_per_stage},
};

// Returns the number of descriptors of one kind in a stage.
uint64_t count_images(const ShaderInterface& shader, BindingKind kind, ShaderStageMask stage) {
    uint64_t count = 0;
    for (const ShaderBinding& binding : shader.bindings)
        if (binding.kind == kind && (binding.stages & stage) != 0) count += binding.count;
    return count;
}

}  // namespace

bool check_array(PassBinding& pass, const UseDecl& use, const PortDraft& port, const ShaderBinding& binding) {
    const std::string shader = quote(pass.draft.desc->shader);
    const bool buffer =
        binding.kind == BindingKind::uniform_buffer || binding.kind == BindingKind::storage_buffer;
    if (buffer && binding.is_array) {
        Diagnostic& d = pass.error(
            use.loc, "W173", each_port_text(pass, use) + " is an array of descriptors in shader " + shader);
        add_help(d, "use one buffer with an array in it, or one port for each buffer");
        return false;
    }
    if (binding.is_runtime_array) {
        // The resource has an error, so it is unknown whether the resource is a table.
        if (pass.declared.shapes.suspects.shapes[use.resource]) {
            pass.suspects.passes[pass.id] = 1;
            return false;
        }
        Diagnostic& d = pass.error(use.loc, "W232",
                                   each_port_text(pass, use) + " is an array without a size in shader " +
                                       shader + ", but " + quote(pass.declared.resource_name(use.resource)) +
                                       " is no table of textures");
        add_help(d,
                 "bind a table: an import of the kind \"textures\", or a resource with the key \"textures\"");
        return false;
    }
    if (use.each == EachPart::none && !binding.is_array) return true;
    if (use.each == EachPart::none) {
        Diagnostic& d = pass.error(use.loc, "W196",
                                   each_port_text(pass, use) + " is an array of descriptors in shader " +
                                       shader + ", but has no \"each\"");
        add_help(d,
                 "add \"each\": \"mip\" or \"each\": \"layer\": then each element of the array is one mip "
                 "or layer of the image");
        return false;
    }
    if (!binding.is_array) {
        report_no_array(pass, use, port);
        return false;
    }
    const uint32_t wanted = element_count(use);
    if (wanted <= binding.count) return true;
    const std::string part = part_name(use.each);
    Diagnostic& d = pass.error(use.loc, "W196",
                               each_port_text(pass, use) + " has " + count_text(wanted, part) +
                                   ", but the array in shader " + shader + " has " +
                                   count_text(binding.count, "element"));
    add_help(d, "declare the array with at least " + count_text(wanted, "element") + ": " + binding.name +
                    "[" + std::to_string(wanted) + "], or select fewer " + part + "s");
    return false;
}

void report_no_array(PassBinding& pass, const UseDecl& use, const PortDraft& port) {
    const bool image = port.binding != nullptr && (port.binding->kind == BindingKind::sampled_image ||
                                                   port.binding->kind == BindingKind::storage_image);
    const std::string what =
        image                     ? "is not an array in shader " + quote(pass.draft.desc->shader)
        : port.binding != nullptr ? "is a buffer, which has no mips or layers"
        : has_shader(pass.draft.decl.kind)
            ? "is not an image that the shader samples, loads or stores"
            : "belongs to a " + pass.draft.decl.type + " pass, which has no arrays of descriptors";
    Diagnostic& d = pass.error(port.desc->each_loc.line != 0 ? port.desc->each_loc : use.loc, "W196",
                               each_port_text(pass, use) + " has \"each\", but " + what);
    if (image)
        add_help(d, "declare an array in the shader: " + port.binding->name + "[" +
                        std::to_string(element_count(use)) + "], or remove \"each\"");
    else
        add_help(d, "remove \"each\"");
}

void check_image_count(PassBinding& pass) {
    const ShaderInterface& shader = *pass.draft.shader;
    const SourceLoc loc =
        pass.draft.desc->shader_loc.line != 0 ? pass.draft.desc->shader_loc : pass.draft.decl.loc;
    for (const ImageLimit& limit : kImageLimits)
        for (const ShaderStage stage : {ShaderStage::vertex, ShaderStage::fragment, ShaderStage::compute}) {
            const uint64_t count = count_images(shader, limit.kind, stage_bit(stage));
            const uint32_t most = pass.declared.input.profile.*limit.value;
            if (count <= most) continue;
            Diagnostic& d =
                pass.error(loc, "W197",
                           "shader " + quote(pass.draft.desc->shader) + " has " + std::to_string(count) +
                               " " + limit.what + " in one stage; the device allows at most " +
                               std::to_string(most) + " (" + limit.name + ")");
            add_help(d,
                     "use an image with layers instead of several images, make the arrays shorter, or "
                     "divide the pass");
        }
}

}  // namespace weft
