#include "shader/worker/glsl_run.h"

#include <glslang/Include/intermediate.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <memory>
#include <utility>

namespace weft::shader {

namespace {

constexpr int kGlslVersion = 460;
constexpr const char* kPortSetText = "1";
// This number is part of the cache key. Increase it if you change the options below and the same GLSL then
// gives different SPIR-V.
constexpr int kOptionsRevision = 1;

// Initialises glslang at the first call, once per process. Initialising a static variable is thread-safe.
void start_glslang() {
    struct Process {
        Process() { glslang::InitializeProcess(); }
        ~Process() { glslang::FinalizeProcess(); }
        Process(const Process&) = delete;
        Process& operator=(const Process&) = delete;
    };
    static const Process process;
}

class Includer final : public glslang::TShader::Includer {
 public:
    explicit Includer(const IncludeReader& reader) : reader_(reader) {}

    IncludeResult* includeLocal(const char* name, const char* includer, size_t depth) override {
        return include({name, includer, depth, true});
    }
    IncludeResult* includeSystem(const char* name, const char* includer, size_t depth) override {
        return include({name, includer, depth, false});
    }
    void releaseInclude(IncludeResult* result) override {
        if (result == nullptr) return;
        std::unique_ptr<std::string>(static_cast<std::string*>(result->userData)).reset();
        std::unique_ptr<IncludeResult>(result).reset();
    }

 private:
    // Answers an include request of glslang. An empty name tells glslang that the file was not found; the
    // text is then the reason.
    IncludeResult* include(const IncludeRequest& request) {
        IncludeAnswer answer = reader_(request);
        auto text = std::make_unique<std::string>(std::move(answer.text));
        auto result = std::make_unique<IncludeResult>(answer.found ? answer.name : std::string(),
                                                      text->data(), text->size(), text.get());
        static_cast<void>(text.release());  // `result` owns the text now; releaseInclude() frees it.
        return result.release();
    }

    const IncludeReader& reader_;
};

EShLanguage to_glslang(ShaderStage stage) {
    switch (stage) {
        case ShaderStage::vertex:
            return EShLangVertex;
        case ShaderStage::fragment:
            return EShLangFragment;
        case ShaderStage::compute:
            return EShLangCompute;
    }
    return EShLangCompute;
}

void set_up(glslang::TShader& shader, EShLanguage language) {
    shader.setPreamble(
        "#extension GL_GOOGLE_include_directive : require\n"
        "#extension GL_EXT_control_flow_attributes : require\n");
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    shader.setResourceSetBinding({kPortSetText});
    shader.setAutoMapBindings(true);
    shader.setAutoMapLocations(true);
}

std::set<std::string> unplaced_variables(const glslang::TIntermediate& intermediate) {
    std::set<std::string> names;
    const glslang::TIntermAggregate* objects = intermediate.findLinkerObjects();
    if (objects == nullptr) return names;
    for (TIntermNode* node : objects->getSequence()) {
        const glslang::TIntermSymbol* symbol = node->getAsSymbolNode();
        if (symbol == nullptr) continue;
        const glslang::TQualifier& qualifier = symbol->getType().getQualifier();
        const bool crosses_stages = qualifier.isPipeInput() || qualifier.isPipeOutput();
        if (crosses_stages && qualifier.builtIn == glslang::EbvNone && !qualifier.hasLocation()) {
            names.emplace(symbol->getName().c_str());
        }
    }
    return names;
}

std::vector<uint32_t> to_spirv(const glslang::TIntermediate& intermediate) {
    glslang::SpvOptions options;
    options.generateDebugInfo = true;  // The names in the SPIR-V are needed for reflection and messages.
    options.disableOptimizer = true;
    // The messages of this logger are ignored, because spirv-val reports the same errors more clearly.
    spv::SpvBuildLogger logger;
    std::vector<uint32_t> words;
    glslang::GlslangToSpv(intermediate, words, &logger, &options);
    return words;
}

}  // namespace

GlslOutcome run_glslang(ShaderStage stage, const std::string& name, const std::string& text,
                        const IncludeReader& includes) {
    start_glslang();
    const EShLanguage language = to_glslang(stage);
    const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgDebugInfo |
                                                   EShMsgSuppressWarnings);
    const char* source = text.data();
    const char* source_name = name.c_str();
    const int length = static_cast<int>(text.size());

    glslang::TShader shader(language);
    shader.setStringsWithLengthsAndNames(&source, &length, &source_name, 1);
    set_up(shader, language);
    Includer includer(includes);
    if (!shader.parse(GetDefaultResources(), kGlslVersion, false, messages, includer)) {
        return {false, {}, {}, shader.getInfoLog()};
    }
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages)) return {false, {}, {}, program.getInfoLog()};
    std::set<std::string> unplaced = unplaced_variables(*program.getIntermediate(language));
    if (!program.mapIO()) return {false, {}, {}, program.getInfoLog()};
    return {true, to_spirv(*program.getIntermediate(language)), std::move(unplaced), {}};
}

std::string compiler_version() {
    const glslang::Version version = glslang::GetVersion();
    return "glslang " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
           std::to_string(version.patch) + version.flavor + " generator " +
           std::to_string(glslang::GetSpirvGeneratorVersion()) + " options " +
           std::to_string(kOptionsRevision);
}

}  // namespace weft::shader
