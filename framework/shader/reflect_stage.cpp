#include "shader/reflect_stage.h"

#include <set>
#include <span>
#include <utility>

#include "shader/interface_types.h"

namespace weft::shader {

namespace {

constexpr const char* kParamsBlock = "Params";
constexpr uint32_t kPortSet = 1;
constexpr uint32_t kMaxSet = 3;
constexpr size_t kHeaderWords = 5;

using Resources = std::span<const spvc_reflected_resource>;

class Reflector {
 public:
    Reflector(ShaderStage stage, const std::vector<uint32_t>& spirv, InterfaceFaults& faults)
        : spirv_(spirv), faults_(faults) {
        result_.stage = stage;
        spvc_parsed_ir ir = nullptr;
        if (spvc_context_create(&context_) != SPVC_SUCCESS) return;
        if (spvc_context_parse_spirv(context_, spirv.data(), spirv.size(), &ir) != SPVC_SUCCESS) return;
        spvc_compiler compiler = nullptr;
        const spvc_result made = spvc_context_create_compiler(context_, SPVC_BACKEND_NONE, ir,
                                                              SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler);
        if (made == SPVC_SUCCESS) compiler_ = compiler;
    }
    ~Reflector() {
        if (context_ != nullptr) spvc_context_destroy(context_);
    }
    Reflector(const Reflector&) = delete;
    Reflector& operator=(const Reflector&) = delete;

    StageReflection run();

 private:
    [[nodiscard]] bool list_resources();
    [[nodiscard]] Resources of_type(spvc_resource_type type) const;
    void refuse_foreign_kinds();
    void reflect_images();
    void reflect_buffers();
    void reflect_push_constants();
    void reflect_spec_constants();
    void reflect_variables(spvc_resource_type type, std::vector<ReflectedVariable>& variables);
    void reflect_execution();
    void scan_instructions();

    [[nodiscard]] ReflectedBinding start_binding(const spvc_reflected_resource& resource, BindingKind kind);
    void describe_image(ReflectedBinding& reflected, spvc_type type);
    void describe_access(ShaderBinding& binding, spvc_variable_id id, bool is_buffer);
    [[nodiscard]] std::vector<BlockMember> members_of(const spvc_reflected_resource& block);
    [[nodiscard]] uint32_t size_of(const spvc_reflected_resource& block) const;
    [[nodiscard]] std::string name_of(const spvc_reflected_resource& resource) const;
    [[nodiscard]] WordIndex word_of(spvc_variable_id id, SpvDecoration decoration) const;
    void fault(std::string subject, std::string message, std::string help);

    const std::vector<uint32_t>& spirv_;
    InterfaceFaults& faults_;
    StageReflection result_;
    spvc_context context_ = nullptr;
    spvc_compiler compiler_ = nullptr;
    spvc_resources resources_ = nullptr;
    std::set<SpvId> used_;
};

void Reflector::fault(std::string subject, std::string message, std::string help) {
    faults_.push_back({"W206", result_.stage, std::move(subject), std::move(message), std::move(help)});
}

StageReflection Reflector::run() {
    if (!list_resources()) {
        const char* reason =
            context_ == nullptr ? "out of memory" : spvc_context_get_last_error_string(context_);
        fault({}, std::string("the shader's SPIR-V cannot be reflected: ") + reason, "simplify the shader");
        return std::move(result_);
    }
    refuse_foreign_kinds();
    reflect_images();
    reflect_buffers();
    reflect_push_constants();
    reflect_spec_constants();
    reflect_variables(SPVC_RESOURCE_TYPE_STAGE_INPUT, result_.inputs);
    reflect_variables(SPVC_RESOURCE_TYPE_STAGE_OUTPUT, result_.outputs);
    reflect_execution();
    scan_instructions();
    return std::move(result_);
}

bool Reflector::list_resources() {
    if (compiler_ == nullptr) return false;
    if (spvc_compiler_create_shader_resources(compiler_, &resources_) != SPVC_SUCCESS) return false;
    spvc_set active = nullptr;
    spvc_resources used = nullptr;
    if (spvc_compiler_get_active_interface_variables(compiler_, &active) != SPVC_SUCCESS) return false;
    if (spvc_compiler_create_shader_resources_for_active_variables(compiler_, &used, active) !=
        SPVC_SUCCESS) {
        return false;
    }
    for (int type = SPVC_RESOURCE_TYPE_UNIFORM_BUFFER; type <= SPVC_RESOURCE_TYPE_ACCELERATION_STRUCTURE;
         ++type) {
        const spvc_reflected_resource* list = nullptr;
        size_t count = 0;
        spvc_resources_get_resource_list_for_type(used, static_cast<spvc_resource_type>(type), &list, &count);
        for (const auto& resource : std::span(list, count)) used_.insert(resource.id);
    }
    return true;
}

Resources Reflector::of_type(spvc_resource_type type) const {
    const spvc_reflected_resource* list = nullptr;
    size_t count = 0;
    spvc_resources_get_resource_list_for_type(resources_, type, &list, &count);
    return {list, count};
}

std::string Reflector::name_of(const spvc_reflected_resource& resource) const {
    const std::string instance = spvc_compiler_get_name(compiler_, resource.id);
    return instance.empty() ? std::string(spvc_compiler_get_name(compiler_, resource.base_type_id))
                            : instance;
}

WordIndex Reflector::word_of(spvc_variable_id id, SpvDecoration decoration) const {
    unsigned word = 0;
    if (spvc_compiler_get_binary_offset_for_decoration(compiler_, id, decoration, &word) == SPVC_FALSE)
        return {};
    return word;
}

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
            fault(name, "\"" + name + "\" is " + what + ", which no pass can bind",
                  "use sampler2D and its kin, image2D and its kin, uniform blocks and buffer blocks");
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
              "\"" + binding.name + "\" is in set " + std::to_string(binding.set) + ", but there are 4",
              "leave the set out: ports of the pass go to set 1");
    }
    bool is_runtime = false;
    const uint32_t count =
        array_count(compiler_, spvc_compiler_get_type_handle(compiler_, resource.type_id), is_runtime);
    binding.count = count == 0 ? 1 : count;
    if (is_runtime) {
        fault(binding.name, "\"" + binding.name + "\" is an array of descriptors without a size",
              "give the array a size");
    }
    return reflected;
}

void Reflector::describe_image(ReflectedBinding& reflected, spvc_type type) {
    ShaderBinding& binding = reflected.binding;
    const SpvDim spirv_dim = spvc_type_get_image_dimension(type);
    if (const auto dim = to_dim(spirv_dim)) {
        binding.dim = *dim;
    } else {
        fault(binding.name,
              "\"" + binding.name + "\" is a texel buffer or another image that graphs do not have",
              "use a buffer block, or an image of one, two or three dimensions or a cube");
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

// NonReadable is GLSL's writeonly, NonWritable its readonly. In blocks they count when every member has them.
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
}

void Reflector::reflect_images() {
    for (const auto& resource : of_type(SPVC_RESOURCE_TYPE_SAMPLED_IMAGE)) {
        ReflectedBinding reflected = start_binding(resource, BindingKind::sampled_image);
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
                  "\"" + reflected.binding.name + "\" has a storage format that graphs do not have",
                  "use the layout qualifier of a format that graphs can name, for example rgba16f");
        }
        result_.bindings.push_back(std::move(reflected));
    }
}

std::vector<BlockMember> Reflector::members_of(const spvc_reflected_resource& block) {
    std::vector<std::string> foreign;
    std::vector<BlockMember> members = block_members(compiler_, block.base_type_id, foreign);
    for (const std::string& name : foreign) {
        fault(name.substr(name.rfind('.') + 1),
              "\"" + name + "\" has a type that blocks cannot share with C++",
              "use float, int, uint, bool, their vectors and matrices, and structs and arrays of these");
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
            reflected.is_params =
                kind == BindingKind::uniform_buffer &&
                std::string(spvc_compiler_get_name(compiler_, resource.base_type_id)) == kParamsBlock;
            if (reflected.is_params && reflected.binding.set != kPortSet) {
                fault(kParamsBlock, "the block Params is in set " + std::to_string(reflected.binding.set),
                      "leave its set out: parameters of a pass go to set 1");
            }
            result_.bindings.push_back(std::move(reflected));
        }
    }
}

void Reflector::reflect_push_constants() {
    for (const auto& resource : of_type(SPVC_RESOURCE_TYPE_PUSH_CONSTANT)) {
        const std::string block = spvc_compiler_get_name(compiler_, resource.base_type_id);
        if (block != kParamsBlock) {
            fault(block, "the push constant block is named \"" + block + "\"",
                  "name it Params: its members are matched by name to the parameters of the pass");
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

void Reflector::reflect_spec_constants() {
    const spvc_specialization_constant* list = nullptr;
    size_t count = 0;
    spvc_compiler_get_specialization_constants(compiler_, &list, &count);
    for (const auto& constant : std::span(list, count)) {
        const spvc_constant value = spvc_compiler_get_constant_handle(compiler_, constant.id);
        const spvc_type type = spvc_compiler_get_type_handle(compiler_, spvc_constant_get_type(value));
        SpecConstant spec;
        spec.name = spvc_compiler_get_name(compiler_, constant.id);
        spec.id = constant.constant_id;
        spec.default_bits = spvc_constant_get_scalar_u32(value, 0, 0);
        // The constants of local_size_x_id have no name of their own; the size is not a variant of the
        // shader.
        if (spec.name.empty()) continue;
        if (const auto scalar = to_scalar(spvc_type_get_basetype(type))) {
            spec.type = *scalar;
            result_.spec_constants.push_back(std::move(spec));
        } else {
            fault(spec.name, "the specialisation constant \"" + spec.name + "\" is not 32 bits wide",
                  "use bool, int, uint or float");
        }
    }
}

void Reflector::reflect_variables(spvc_resource_type type, std::vector<ReflectedVariable>& variables) {
    for (const auto& resource : of_type(type)) {
        const spvc_type spirv_type = spvc_compiler_get_type_handle(compiler_, resource.type_id);
        ReflectedVariable reflected;
        reflected.variable.name = name_of(resource);
        const auto scalar = to_scalar(spvc_type_get_basetype(spirv_type));
        if (!scalar) {
            fault(reflected.variable.name,
                  "\"" + reflected.variable.name +
                      "\" passes a block, a struct or another type than 32-bit numbers",
                  "pass plain variables between stages: float, int, uint, their vectors and matrices");
            continue;
        }
        bool is_runtime = false;
        reflected.variable.scalar = *scalar;
        reflected.variable.components = static_cast<uint8_t>(spvc_type_get_vector_size(spirv_type));
        reflected.variable.location =
            spvc_compiler_get_decoration(compiler_, resource.id, SpvDecorationLocation);
        reflected.component = spvc_compiler_get_decoration(compiler_, resource.id, SpvDecorationComponent);
        reflected.columns = spvc_type_get_columns(spirv_type);
        reflected.array_count = array_count(compiler_, spirv_type, is_runtime);
        reflected.used = used_.contains(resource.id);
        reflected.location_word = word_of(resource.id, SpvDecorationLocation);
        variables.push_back(std::move(reflected));
    }
}

void Reflector::reflect_execution() {
    const SpvExecutionMode* modes = nullptr;
    size_t count = 0;
    spvc_compiler_get_execution_modes(compiler_, &modes, &count);
    for (const SpvExecutionMode mode : std::span(modes, count)) {
        if (mode == SpvExecutionModeDepthReplacing) result_.writes_depth = true;
    }
    // Asked for LocalSize, SPIRV-Cross gives numbers for LocalSizeId too, those of the defaults.
    for (unsigned i = 0; i < 3 && result_.stage == ShaderStage::compute; ++i) {
        result_.local_size[i] =
            spvc_compiler_get_execution_mode_argument_by_index(compiler_, SpvExecutionModeLocalSize, i);
    }
}

void Reflector::scan_instructions() {
    for (size_t at = kHeaderWords; at < spirv_.size();) {
        const uint32_t opcode = spirv_[at] & 0xffffu;
        const uint32_t words = spirv_[at] >> 16;
        if (words == 0) return;
        if (opcode == SpvOpKill || opcode == SpvOpTerminateInvocation ||
            opcode == SpvOpDemoteToHelperInvocation) {
            result_.discards = true;
        }
        at += words;
    }
}

}  // namespace

StageReflection reflect_stage(ShaderStage stage, const std::vector<uint32_t>& spirv,
                              InterfaceFaults& faults) {
    return Reflector(stage, spirv, faults).run();
}

}  // namespace weft::shader
