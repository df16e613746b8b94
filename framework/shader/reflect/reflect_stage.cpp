#include "shader/reflect/reflect_stage.h"

#include <exception>
#include <utility>

#include "shader/reflect/reflector.h"

namespace weft::shader {

namespace {

constexpr size_t kHeaderWords = 5;

// True for a capability that only devices with tables of textures have.
bool is_for_tables(uint32_t capability) {
    return capability == SpvCapabilityRuntimeDescriptorArray || capability == SpvCapabilityShaderNonUniform ||
           capability == SpvCapabilitySampledImageArrayNonUniformIndexing;
}

}  // namespace

Reflector::Reflector(ShaderStage stage, const std::vector<uint32_t>& spirv, InterfaceFaults& faults)
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

Reflector::~Reflector() {
    if (context_ != nullptr) spvc_context_destroy(context_);
}

void Reflector::fault(std::string subject, std::string message, std::string help) {
    faults_.push_back({"W206", result_.stage, std::move(subject), std::move(message), std::move(help)});
}

StageReflection Reflector::run() {
    if (!list_resources()) {
        const char* reason =
            context_ == nullptr ? "out of memory" : spvc_context_get_last_error_string(context_);
        fault({}, std::string("the interface of the shader cannot be read from its SPIR-V: ") + reason,
              "simplify the shader");
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

std::span<const spvc_reflected_resource> Reflector::of_type(spvc_resource_type type) const {
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
        // The constants that glslang creates for local_size_x_id have no name. They are skipped, because a
        // pass cannot set the local size.
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
                      "\" is a block, a struct or a type without 32-bit numbers, which stages cannot pass on",
                  "pass variables of float, int, uint, their vectors or matrices between stages");
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
    if (result_.stage == ShaderStage::vertex) {
        spvc_compiler_update_active_builtins(compiler_);
        result_.writes_point_size = spvc_compiler_has_active_builtin(compiler_, SpvBuiltInPointSize,
                                                                     SpvStorageClassOutput) == SPVC_TRUE;
    }
    // If specialisation constants set the work group size (LocalSizeId), SPIRV-Cross returns the size for the
    // default values of the constants.
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
        if (opcode == SpvOpCapability && words > 1 && is_for_tables(spirv_[at + 1]))
            result_.needs_texture_tables = true;
        at += words;
    }
}

StageReflection reflect_stage(ShaderStage stage, const std::vector<uint32_t>& spirv,
                              InterfaceFaults& faults) {
    // Catch exceptions here: some functions of SPIRV-Cross throw exceptions although its interface is C.
    try {
        return Reflector(stage, spirv, faults).run();
    } catch (const std::exception& error) {
        faults.push_back(
            {"W206",
             stage,
             {},
             std::string("the interface of the shader cannot be read from its SPIR-V: ") + error.what(),
             "simplify the shader"});
        StageReflection nothing;
        nothing.stage = stage;
        return nothing;
    }
}

}  // namespace weft::shader
