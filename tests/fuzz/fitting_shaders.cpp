#include "tests/fuzz/fitting_shaders.h"

#include <algorithm>

namespace weft::fuzz {
namespace {

// Generates pseudo-random numbers: each call of below() returns a number from 0 to `count` - 1.
class Choices {
 public:
    explicit Choices(uint64_t seed) : state_(seed) {}
    uint32_t below(uint32_t count) {
        // The constants are those of Knuth's MMIX generator.
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<uint32_t>(state_ >> 33) % count;
    }

 private:
    uint64_t state_;
};

const ResourceDesc* resource_of(const GraphDesc& graph, const PortDesc& port) {
    const auto found = graph.resources.find(port.ref.name);
    return found == graph.resources.end() ? nullptr : &found->second;
}

void set_shape(const ResourceDesc& resource, ShaderBinding& binding) {
    switch (resource.image_kind) {
        case ImageKind::d3:
            binding.dim = ImageDim::d3;
            break;
        case ImageKind::cube:
        case ImageKind::cube_array:
            binding.dim = ImageDim::cube;
            break;
        default:
            binding.dim = ImageDim::d2;
    }
    binding.multisampled = !resource.samples.empty() && resource.samples.text != "1";
    binding.arrayed = !resource.layers.empty() && binding.dim == ImageDim::d2;
    if (resource.formats.empty()) return;
    if (const std::optional<Format> format = format_from_name(resource.formats.front()))
        binding.numeric = format_info(*format).numeric;
}

ShaderBinding binding_for(const GraphDesc& graph, const PortDesc& port, bool output, Choices& choices) {
    ShaderBinding binding;
    binding.name = port.port;
    binding.set = 1;
    const ResourceDesc* resource = resource_of(graph, port);
    const auto import = graph.imports.find(port.ref.name);
    const bool is_buffer =
        resource ? resource->is_buffer : import != graph.imports.end() && import->second.kind == "buffer";
    if (resource) set_shape(*resource, binding);
    const bool table = resource ? !resource->textures.empty()
                                : import != graph.imports.end() && import->second.kind == "textures";
    binding.is_array = binding.is_runtime_array = table && choices.below(24) != 0;
    const bool stored = output || choices.below(24) == 0;
    binding.kind = is_buffer ? BindingKind::storage_buffer
                   : stored  ? BindingKind::storage_image
                             : BindingKind::sampled_image;
    binding.writes = output;
    binding.reads = !output || choices.below(24) == 0;
    if (binding.kind == BindingKind::storage_image && binding.reads && resource && !resource->formats.empty())
        binding.storage_format = format_from_name(resource->formats.front()).value_or(Format::undefined);
    return binding;
}

void add_binding(ShaderInterface& interface, ShaderBinding binding, ShaderStageMask stages) {
    for (ShaderBinding& known : interface.bindings) {
        if (known.name != binding.name) continue;
        known.writes |= binding.writes;
        known.reads |= binding.reads;
        known.kind = binding.kind;
        return;
    }
    binding.stages = stages;
    binding.binding = static_cast<uint32_t>(interface.bindings.size());
    interface.bindings.push_back(std::move(binding));
}

// The constants of the view, which the vertex stage reads.
ShaderBinding view_block() {
    ShaderBinding binding;
    binding.name = "ViewBlock";
    binding.binding = kViewBinding;
    binding.kind = BindingKind::uniform_buffer;
    binding.stages = stage_bit(ShaderStage::vertex);
    return binding;
}

void add_params(const PassDesc& pass, ShaderInterface& interface) {
    for (const ParamValueDesc& value : pass.params) {
        BlockMember member;
        member.name = value.name;
        member.rows = static_cast<uint8_t>(std::clamp<size_t>(value.components.size(), 1, 4));
        member.size_bytes = 4u * member.rows;
        member.offset_bytes = interface.params.size_bytes;
        interface.params.size_bytes += 16;
        interface.params.members.push_back(std::move(member));
    }
    interface.has_params = !pass.params.empty();
    interface.params.push_constants = interface.params.size_bytes <= 128;
    interface.params.stages = interface.stages;
}

void add_constants(const PassDesc& pass, ShaderInterface& interface) {
    for (const ParamValueDesc& value : pass.constants)
        interface.spec_constants.push_back({value.name, 0, ScalarType::f32, 0});
    for (const PortDesc& port : pass.in)
        if (port.optional)
            interface.spec_constants.push_back({"HAS_" + port.port, 0, ScalarType::boolean, 0});
    std::ranges::sort(interface.spec_constants, {}, &SpecConstant::name);
    for (size_t i = 0; i < interface.spec_constants.size(); ++i)
        interface.spec_constants[i].id = static_cast<uint32_t>(i);
}

ShaderProgram fitting_shader(const GraphDesc& graph, const PassDesc& pass, Choices& choices) {
    ShaderProgram program;
    program.reference = pass.shader;
    program.modules.resize(1);
    ShaderInterface& interface = program.interface;
    const bool draws = pass.type != "compute";
    const ShaderStageMask stages = stage_bit(draws ? ShaderStage::fragment : ShaderStage::compute);
    interface.stages = draws ? stages | stage_bit(ShaderStage::vertex) : stages;
    interface.local_size = {8, 8, 1};
    for (const PortDesc& port : pass.in)
        add_binding(interface, binding_for(graph, port, false, choices), stages);
    if (draws && !pass.view.empty() && choices.below(8) != 0) interface.bindings.push_back(view_block());
    for (const PortDesc& port : pass.out) {
        if (draws)
            interface.fragment_outputs.push_back(
                {port.port, static_cast<uint32_t>(interface.fragment_outputs.size()), ScalarType::f32, 4});
        else
            add_binding(interface, binding_for(graph, port, true, choices), stages);
    }
    interface.needs_texture_tables =
        std::ranges::any_of(interface.bindings, &ShaderBinding::is_runtime_array);
    add_params(pass, interface);
    add_constants(pass, interface);
    return program;
}

}  // namespace

ShaderCatalog fitting_shaders(const GraphDesc& graph, uint64_t choices) {
    Choices chosen(choices);
    ShaderCatalog catalog;
    for (const auto& [name, pass] : graph.passes)
        if (!pass.shader.empty()) catalog.emplace(pass.shader, fitting_shader(graph, pass, chosen));
    return catalog;
}

}  // namespace weft::fuzz
