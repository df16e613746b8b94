#include "shader/glsl_compile.h"

#include <glslang/Include/intermediate.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <memory>
#include <utility>

#include "shader/glsl_log.h"

namespace weft::shader {

namespace {

constexpr int kGlslVersion = 460;
constexpr size_t kMaxIncludeDepth = 32;
constexpr size_t kMaxIncludes = 1000;
constexpr const char* kPortSet = "1";
// Raise when the options below change what the same text compiles to.
constexpr int kOptionsRevision = 1;

// glslang wants this once a process; the static ties it to the first compilation, whichever thread does it.
void start_glslang() {
    struct Process {
        Process() { glslang::InitializeProcess(); }
        ~Process() { glslang::FinalizeProcess(); }
        Process(const Process&) = delete;
        Process& operator=(const Process&) = delete;
    };
    static const Process process;
}

class RootedIncluder final : public glslang::TShader::Includer {
 public:
    explicit RootedIncluder(SourceReader& reader) : reader_(reader) {}

    IncludeResult* includeLocal(const char* name, const char* includer, size_t depth) override {
        return include(name, includer, depth, true);
    }
    IncludeResult* includeSystem(const char* name, const char* includer, size_t depth) override {
        return include(name, includer, depth, false);
    }
    void releaseInclude(IncludeResult* result) override { std::unique_ptr<IncludeResult>(result).reset(); }

 private:
    // glslang asks "beside" first and then again without; an empty name with a text is its form of failure.
    IncludeResult* include(const std::string& name, const char* includer, size_t depth, bool beside) {
        if (depth > kMaxIncludeDepth) return fail("includes nest deeper than 32");
        if (includes_ >= kMaxIncludes) return fail("more than 1000 includes");
        const SourceLookup lookup = reader_.read_include(name, includer, beside);
        if (lookup.source == nullptr) return fail(lookup.reason);
        ++includes_;
        return std::make_unique<IncludeResult>(lookup.source->name, lookup.source->text.data(),
                                               lookup.source->text.size(), nullptr)
            .release();
    }

    IncludeResult* fail(std::string reason) {
        reason_ = std::move(reason);
        return std::make_unique<IncludeResult>(std::string(), reason_.data(), reason_.size(), nullptr)
            .release();
    }

    SourceReader& reader_;
    std::string reason_;
    size_t includes_ = 0;
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
    shader.setPreamble("#extension GL_GOOGLE_include_directive : require\n");
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    shader.setResourceSetBinding({kPortSet});
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
    options.generateDebugInfo = true;  // reflection and validation messages live on the names
    options.disableOptimizer = true;
    spv::SpvBuildLogger logger;  // what it would say, spirv-val says better
    std::vector<uint32_t> words;
    glslang::GlslangToSpv(intermediate, words, &logger, &options);
    return words;
}

}  // namespace

Result<CompiledStage> compile_stage(ShaderStage stage, const SourceText& source, SourceReader& reader) {
    start_glslang();
    const EShLanguage language = to_glslang(stage);
    const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgDebugInfo |
                                                   EShMsgSuppressWarnings);
    const char* text = source.text.data();
    const char* name = source.name.c_str();
    const int length = static_cast<int>(source.text.size());

    glslang::TShader shader(language);
    shader.setStringsWithLengthsAndNames(&text, &length, &name, 1);
    set_up(shader, language);
    RootedIncluder includer(reader);
    if (!shader.parse(GetDefaultResources(), kGlslVersion, false, messages, includer)) {
        return parse_glsl_log(shader.getInfoLog(), reader, source);
    }
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages)) return parse_glsl_log(program.getInfoLog(), reader, source);
    std::set<std::string> unplaced = unplaced_variables(*program.getIntermediate(language));
    if (!program.mapIO()) return parse_glsl_log(program.getInfoLog(), reader, source);
    return CompiledStage{stage, &source, to_spirv(*program.getIntermediate(language)), std::move(unplaced)};
}

std::string compiler_version() {
    const glslang::Version version = glslang::GetVersion();
    return "glslang " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
           std::to_string(version.patch) + version.flavor + " generator " +
           std::to_string(glslang::GetSpirvGeneratorVersion()) + " options " +
           std::to_string(kOptionsRevision);
}

}  // namespace weft::shader
