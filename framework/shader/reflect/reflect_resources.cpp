// Reflects the resources of a shader stage: images, buffers and the parameter block.
#include <optional>
#include <utility>

#include "shader/reflect/reflector.h"
#include "shader/reflect/sampled_images.h"
#include "shader/reflect/used_ranges.h"

namespace weft::shader {

namespace {

constexpr const char* kParamsBlock = "Params";
constexpr uint32_t kMaxSet = 3;

}  // namespace

void Reflector::refuse_foreign_kinds() {
    const std::pair<spvc_resource_type, const char*> kinds[] = {
        {SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, "a texture without its sampler"},
        {SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, "a sampler without its texture"},
        {SPVC_RESOURCE_TYPE_SUBPASS_INPUT, "a subpass input"},
        {SPVC_RESOURCE_TYPE_ATOMIC_COUNTER, "an atomic counter"},
        {SPVC_RESOURCE_TYPE_ACCELERATION_STRUCTURE, "an acceleration structure"},
    };
    for (const auto& [type, what] : kinds) {
        for (const auto& resource : of_type(type)) {
            const std::string name = name_of(resource);
            fault(name, "\"" + name + "\" is " + what + ", which a pass cannot bind",
                  "use a combined sampler (such as sampler2D), an image (such as image2D), a uniform block "
                  "or a buffer block");
        }
    }
}

ReflectedBinding Reflector::start_binding(const spvc_reflected_resource& resource, BindingKind kind) {
    ReflectedBinding reflected;
    ShaderBinding& binding = reflected.binding;
    binding.name = name_of(resource);
    binding.kind = kind;
    binding.stages = stage_bit(result_.stage);
    binding.set = spvc_compiler_get_decoration(compiler_, resource.id, SpvDecorationDescriptorSet);
    binding.binding = spvc_compiler_get_decoration(compiler_, resource.id, SpvDecorationBinding);
    reflected.used = used_.contains(resource.id);
    reflected.set_word = word_of(resource.id, SpvDecorationDescriptorSet);
    reflected.binding_word = word_of(resource.id, SpvDecorationBinding);
    if (binding.set > kMaxSet) {
        fault(binding.name,
              "\"" + binding.name + "\" is in descriptor set " + std::to_string(binding.set) +
                  "; wanted a set of 0 to 3",
              "remove `set`: Weft then binds \"" + binding.name + "\" as a port of the pass, in set 1");
    }
    bool is_runtime = false;
    const spvc_type type = spvc_compiler_get_type_handle(compiler_, resource.type_id);
    const uint32_t count = array_count(compiler_, type, is_runtime);
    binding.count = count == 0 ? 1 : count;
    // spirv-val has refused arrays of arrays.
    binding.is_array = spvc_type_get_num_array_dimensions(type) > 0;
    if (binding.is_array && !is_runtime && spvc_type_array_dimension_is_literal(type, 0) == SPVC_FALSE)
        fault(binding.name,
              "\"" + binding.name + "\" is an array of descriptors whose size is a specialisation constant",
              "declare the size of the array as a number or an ordinary const");
    binding.is_runtime_array = is_runtime;
    if (is_runtime && (kind != BindingKind::sampled_image || binding.set != kPortSet)) {
        fault(binding.name, "\"" + binding.name + "\" is an array of descriptors without a size",
              kind == BindingKind::sampled_image
                  ? "remove `set`: then the array is a table of textures, which is a port of the pass"
                  : "declare the size of the array; only tables of textures (sampler2D) need no size");
    }
    return reflected;
}

void Reflector::describe_image(ReflectedBinding& reflected, spvc_type type) {
    ShaderBinding& binding = reflected.binding;
    const SpvDim spirv_dim = spvc_type_get_image_dimension(type);
    if (const auto dim = to_dim(spirv_dim)) {
        binding.dim = *dim;
    } else {
        fault(
            binding.name,
            "\"" + binding.name + "\" is a texel buffer or another kind of image that a graph cannot declare",
            "use a buffer block, or a 1D, 2D, 3D or cube image");
    }
    binding.arrayed = spvc_type_get_image_arrayed(type) == SPVC_TRUE;
    binding.multisampled = spvc_type_get_image_multisampled(type) == SPVC_TRUE;
    binding.shadow = spvc_type_get_image_is_depth(type) == SPVC_TRUE;
    const spvc_type sampled =
        spvc_compiler_get_type_handle(compiler_, spvc_type_get_image_sampled_type(type));
    const spvc_basetype base = spvc_type_get_basetype(sampled);
    binding.numeric = binding.shadow                 ? NumericClass::depth
                      : base == SPVC_BASETYPE_INT32  ? NumericClass::sint
                      : base == SPVC_BASETYPE_UINT32 ? NumericClass::uint
                                                     : NumericClass::float_like;
}

// Finds out whether the shader can read the resource, and whether it can write it. The GLSL qualifier
// `writeonly` becomes NonReadable in SPIR-V, and `readonly` becomes NonWritable. For a block, SPIRV-Cross
// reports one of these decorations only if all members of the block have the decoration.
void Reflector::describe_access(ShaderBinding& binding, spvc_variable_id id, bool is_buffer) {
    bool non_readable = spvc_compiler_has_decoration(compiler_, id, SpvDecorationNonReadable) == SPVC_TRUE;
    bool non_writable = spvc_compiler_has_decoration(compiler_, id, SpvDecorationNonWritable) == SPVC_TRUE;
    const SpvDecoration* decorations = nullptr;
    size_t count = 0;
    if (is_buffer &&
        spvc_compiler_get_buffer_block_decorations(compiler_, id, &decorations, &count) == SPVC_SUCCESS) {
        for (const SpvDecoration decoration : std::span(decorations, count)) {
            non_readable = non_readable || decoration == SpvDecorationNonReadable;
            non_writable = non_writable || decoration == SpvDecorationNonWritable;
        }
    }
    binding.reads = !non_readable;
    binding.writes = !non_writable;
    // Writing in the vertex stage needs the device feature vertexPipelineStoresAndAtomics. SPIR-V has no
    // capability for this feature, so the SPIR-V gate cannot reject the shader. Weft does not enable the
    // feature on any device.
    if (binding.writes && result_.stage == ShaderStage::vertex && used_.contains(id))
        fault(binding.name, "the vertex stage can write to \"" + binding.name + "\"",
              "declare \"" + binding.name + "\" as `readonly`, or write in a fragment or compute stage");
}

void Reflector::reflect_images() {
    const std::set<SpvId> filtered = filtered_images(spirv_);
    for (const auto& resource : of_type(SPVC_RESOURCE_TYPE_SAMPLED_IMAGE)) {
        ReflectedBinding reflected = start_binding(resource, BindingKind::sampled_image);
        reflected.binding.filters = filtered.contains(resource.id);
        describe_image(reflected, spvc_compiler_get_type_handle(compiler_, resource.base_type_id));
        result_.bindings.push_back(std::move(reflected));
    }
    for (const auto& resource : of_type(SPVC_RESOURCE_TYPE_STORAGE_IMAGE)) {
        ReflectedBinding reflected = start_binding(resource, BindingKind::storage_image);
        const spvc_type type = spvc_compiler_get_type_handle(compiler_, resource.base_type_id);
        describe_image(reflected, type);
        describe_access(reflected.binding, resource.id, false);
        const SpvImageFormat format = spvc_type_get_image_storage_format(type);
        reflected.binding.storage_format = to_format(format);
        if (format != SpvImageFormatUnknown && reflected.binding.storage_format == Format::undefined) {
            fault(reflected.binding.name,
                  "\"" + reflected.binding.name + "\" has a storage format that a graph cannot declare",
                  "use the layout qualifier of a format that graphs support, for example rgba16f");
        }
        result_.bindings.push_back(std::move(reflected));
    }
}

std::vector<BlockMember> Reflector::members_of(const spvc_reflected_resource& block) {
    std::vector<std::string> foreign;
    std::vector<BlockMember> members = block_members(compiler_, block.base_type_id, foreign);
    for (const std::string& name : foreign) {
        fault(name.substr(name.rfind('.') + 1),
              "\"" + name + "\" has a type that Weft does not support in blocks",
              "use float, int, uint, bool, their vectors and matrices, or structs and arrays of these types");
    }
    return members;
}

uint32_t Reflector::size_of(const spvc_reflected_resource& block) const {
    size_t size = 0;
    const spvc_type type = spvc_compiler_get_type_handle(compiler_, block.base_type_id);
    spvc_compiler_get_declared_struct_size(compiler_, type, &size);
    return static_cast<uint32_t>(size);
}

void Reflector::reflect_buffers() {
    const std::pair<spvc_resource_type, BindingKind> kinds[] = {
        {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, BindingKind::uniform_buffer},
        {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, BindingKind::storage_buffer},
    };
    for (const auto& [type, kind] : kinds) {
        for (const auto& resource : of_type(type)) {
            ReflectedBinding reflected = start_binding(resource, kind);
            reflected.binding.members = members_of(resource);
            reflected.binding.block_bytes = size_of(resource);
            if (kind == BindingKind::storage_buffer) describe_access(reflected.binding, resource.id, true);
            if (kind == BindingKind::uniform_buffer && reflected.binding.set == 0 && reflected.used)
                add_frame_ranges(reflected.binding, resource.id);
            reflected.is_params =
                kind == BindingKind::uniform_buffer &&
                std::string(spvc_compiler_get_name(compiler_, resource.base_type_id)) == kParamsBlock;
            if (reflected.is_params && reflected.binding.set != kPortSet) {
                fault(kParamsBlock,
                      "the block Params is in descriptor set " + std::to_string(reflected.binding.set) +
                          "; wanted set 1",
                      "remove `set` from the block");
            }
            result_.bindings.push_back(std::move(reflected));
        }
    }
}

void Reflector::add_frame_ranges(const ShaderBinding& block, spvc_variable_id id) {
    for (FrameRange range : used_ranges(spirv_, id, block.members, block.block_bytes)) {
        range.binding = block.binding;
        result_.frame_ranges.push_back(range);
    }
}

void Reflector::reflect_push_constants() {
    for (const auto& resource : of_type(SPVC_RESOURCE_TYPE_PUSH_CONSTANT)) {
        const std::string block = spvc_compiler_get_name(compiler_, resource.base_type_id);
        if (block != kParamsBlock) {
            fault(block, "the push constant block is named \"" + block + "\"; wanted \"Params\"",
                  "rename the block to Params; each member gets the pass parameter of the same name");
            continue;
        }
        if (!used_.contains(resource.id)) continue;
        ParamsBlock params;
        params.push_constants = true;
        params.size_bytes = size_of(resource);
        params.stages = stage_bit(result_.stage);
        params.members = members_of(resource);
        result_.push_constants = std::move(params);
    }
}

}  // namespace weft::shader
