#include "weft/shader/compile_shader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "shader/compile/glsl_compile.h"
#include "shader/compile/link_stages.h"
#include "shader/compile/shader_cache.h"
#include "shader/compile/shader_sources.h"
#include "shader/gate/spirv_gate.h"
#include "shader/gate/validate_spirv.h"
#include "shader/reflect/interface_merge.h"
#include "shader/reflect/local_size.h"
#include "shader/shader_memory.h"

namespace weft {

namespace fs = std::filesystem;
using namespace shader;

namespace {

constexpr const char* kFullscreenVertex = "fullscreen.vert";

struct StageFile {
    ShaderStage stage = ShaderStage::compute;
    std::string path;
    bool shared = false;  // True for a file of shaders/include, such as fullscreen.vert.
};

// File extension of the shader for each ProgramKind. The extension is empty for a raster program, because it
// has two files, whose names come from stage_files().
constexpr std::array kExtensions{".comp", ".frag", ""};
static_assert(kExtensions.size() == static_cast<size_t>(ProgramKind::raster) + 1);

std::string extension_of(ProgramKind kind) {
    return kExtensions.at(static_cast<size_t>(kind));
}

std::vector<StageFile> stage_files(const std::string& reference, ProgramKind kind) {
    const std::string inner = reference + "/" + fs::path(reference).filename().string();
    switch (kind) {
        case ProgramKind::compute:
            return {{ShaderStage::compute, reference, false}};
        case ProgramKind::fullscreen:
            return {{ShaderStage::vertex, kFullscreenVertex, true},
                    {ShaderStage::fragment, reference, false}};
        case ProgramKind::raster:
            return {{ShaderStage::vertex, inner + ".vert", false},
                    {ShaderStage::fragment, inner + ".frag", false}};
    }
    return {};
}

// Returns the references to existing shaders of this kind, for "did you mean ...?".
std::vector<std::string> known_references(ProgramKind kind, const SourceReader& reader) {
    if (kind != ProgramKind::raster) return reader.known_references(extension_of(kind));
    std::vector<std::string> folders;
    for (const std::string& file : reader.known_references(".vert")) {
        const fs::path path(file);
        if (path.parent_path().filename() == path.stem())
            folders.push_back(path.parent_path().generic_string());
    }
    return folders;
}

Diagnostic not_found(const std::string& reference, ProgramKind kind, const StageFile& file,
                     const std::string& reason, const ShaderRoots& roots, const SourceReader& reader) {
    Diagnostic diagnostic;
    diagnostic.code = "W201";
    diagnostic.message = "shader \"" + reference + "\" not found: " + file.path + ": " + reason;
    std::string places;
    for (const fs::path& root : roots.roots) {
        places +=
            (places.empty() ? "" : ", then ") + (root.empty() ? std::string(".") : root.generic_string());
    }
    if (file.shared) {
        // The file is one of the files in the folder shaders/include of Weft. It was not found, so
        // `include_root` is not this folder.
        diagnostic.help.push_back("\"" + roots.include_root.parent_path().generic_string() +
                                  "\" is not the folder shaders/ of Weft: name this folder in "
                                  "LoadSettings::shader_root");
        return diagnostic;
    }
    diagnostic.help.push_back(places.empty() ? "give the program a shader folder; it has none"
                                             : "put the file into a shader folder; weft looked in " + places);
    const std::string near = did_you_mean_text(reference, known_references(kind, reader));
    if (!near.empty()) diagnostic.help.push_back(near);
    return diagnostic;
}

// Returns an error if the reference has the wrong file extension. The extension determines the stage of the
// shader.
std::optional<Diagnostic> wrong_extension(const std::string& reference, ProgramKind kind,
                                          const SourceReader& reader) {
    const std::string wanted = extension_of(kind);
    const std::string found = fs::path(reference).extension().string();
    if (found == wanted || reference.empty()) return std::nullopt;
    Diagnostic diagnostic;
    diagnostic.code = "W201";
    if (kind == ProgramKind::raster) {
        diagnostic.message = "the name of a raster shader has no extension, found \"" + reference + "\"";
        diagnostic.help.emplace_back(
            "write for example \"gbuffer\", which means the two files gbuffer/gbuffer.vert and "
            "gbuffer/gbuffer.frag");
    } else {
        diagnostic.message = std::string("a ") + (kind == ProgramKind::compute ? "compute" : "fullscreen") +
                             " shader needs the extension " + wanted + ", found \"" + reference + "\"";
        diagnostic.help.push_back("use .comp for compute passes, .frag for fullscreen passes");
    }
    const std::string near = did_you_mean_text(reference, known_references(kind, reader));
    if (!near.empty()) diagnostic.help.push_back(near);
    return diagnostic;
}

Result<std::vector<CompiledStage>> compile_stages(const std::string& reference, ProgramKind kind,
                                                  const ShaderRoots& roots, SourceReader& reader,
                                                  StageCompiler& compiler) {
    if (auto diagnostic = wrong_extension(reference, kind, reader)) return std::move(*diagnostic);
    Diagnostics errors;
    std::vector<CompiledStage> stages;
    for (const StageFile& file : stage_files(reference, kind)) {
        const SourceLookup lookup =
            file.shared ? reader.read_shared(file.path) : reader.read_reference(file.path);
        if (lookup.source == nullptr) {
            errors.push_back(not_found(reference, kind, file, lookup.reason, roots, reader));
            continue;
        }
        auto stage = compiler.compile(file.stage, *lookup.source, reader);
        if (stage) {
            stages.push_back(std::move(*stage));
        } else {
            std::ranges::move(stage.take_errors(), std::back_inserter(errors));
        }
    }
    if (!errors.empty()) return errors;
    return stages;
}

void report(const InterfaceFaults& faults, const std::vector<CompiledStage>& stages,
            const SourceReader& reader, Diagnostics& errors) {
    for (const InterfaceFault& fault : faults) {
        const auto stage = std::ranges::find(stages, fault.stage, &CompiledStage::stage);
        const SourceText* source = stage == stages.end() ? nullptr : stage->source;
        FoundWord found{find_declaration(fault.subject, source, reader.sources()),
                        static_cast<uint32_t>(fault.subject.size())};
        if (fault.subject.empty()) found = find_words(fault.words, source, reader.sources());
        // If the source has no GLSL word that leads to the rejected capability, search for words that start
        // with "spirv_". They belong to GL_EXT_spirv_intrinsics, which can request any capability.
        if (found.position.line == 0 && fault.code == "W208")
            found = find_words("spirv_*", source, reader.sources());
        Diagnostic diagnostic = diagnostic_at(found.position, fault.code, fault.message);
        if (found.position.line > 0) diagnostic.length = found.length;
        diagnostic.help.push_back(fault.help);
        errors.push_back(std::move(diagnostic));
    }
}

Diagnostics invalid_modules(const std::vector<CompiledStage>& stages) {
    Diagnostics errors;
    for (const CompiledStage& stage : stages) {
        const auto fault = spirv_fault(stage.spirv);
        if (!fault) continue;
        Diagnostic diagnostic = diagnostic_at(
            {stage.source, 0, 0}, "W204", "the compiled shader is not valid SPIR-V for Vulkan: " + *fault);
        diagnostic.help.emplace_back("rewrite the construct that the message names");
        errors.push_back(std::move(diagnostic));
    }
    return errors;
}

Result<ShaderProgram> build_program(const std::string& reference, ProgramKind kind, const ShaderRoots& roots,
                                    StageCompiler& compiler, SourceReader& reader) {
    auto compiled = compile_stages(reference, kind, roots, reader, compiler);
    if (!compiled) return compiled.take_errors();
    std::vector<CompiledStage>& stages = *compiled;

    InterfaceFaults faults;
    Diagnostics errors;
    for (const CompiledStage& stage : stages)
        std::ranges::move(gate_faults(stage.stage, stage.spirv, {roots.target, roots.limits}),
                          std::back_inserter(faults));
    report(faults, stages, reader, errors);
    if (!errors.empty()) return errors;
    link_stages(stages, faults);
    report(faults, stages, reader, errors);
    if (!errors.empty()) return errors;
    if (errors = invalid_modules(stages); !errors.empty()) return errors;

    ShaderProgram program;
    program.reference = reference;
    program.content_hash = content_hash_of(reference, kind, reader);
    for (CompiledStage& stage : stages) program.modules.push_back({stage.stage, std::move(stage.spirv)});
    program.interface = reflect_program(program.modules, faults);
    report(faults, stages, reader, errors);
    if (!errors.empty()) return errors;
    store_cached(program, kind, roots, reader);
    return program;
}

// Loads a program from the cache. Cache files are not trusted, so their modules must pass the same checks as
// newly compiled modules.
std::optional<ShaderProgram> cached_program(const std::string& reference, ProgramKind kind,
                                            const ShaderRoots& roots, SourceReader& reader) {
    auto program = load_cached(reference, kind, roots, reader);
    if (!program) return std::nullopt;
    // If a module from the cache is rejected, the shader is compiled again, because only a compilation knows
    // the line of the error.
    const auto refused = [&](const ShaderModule& module) {
        return spirv_fault(module.spirv).has_value() ||
               !gate_faults(module.stage, module.spirv, {roots.target, roots.limits}).empty();
    };
    if (std::ranges::any_of(program->modules, refused)) return std::nullopt;
    InterfaceFaults faults;
    program->interface = reflect_program(program->modules, faults);
    if (!faults.empty()) return std::nullopt;
    return program;
}

}  // namespace

Result<ShaderProgram> compile_shader(const std::string& reference, ProgramKind kind,
                                     const ShaderRoots& roots) {
    StageCompiler compiler(roots);
    return compile_shader(reference, kind, roots, compiler);
}

Result<ShaderProgram> compile_shader(const std::string& reference, ProgramKind kind, const ShaderRoots& roots,
                                     StageCompiler& compiler, ShaderMemory* memory) {
    if (memory != nullptr)
        if (const ShaderProgram* known = memory->find(reference, kind, roots)) return *known;
    const auto keep = [&](ShaderProgram* program, const SourceReader& reader) {
        if (program != nullptr && kind == ProgramKind::compute)
            program->interface.states_local_size = states_local_size(reader.sources());
        if (memory == nullptr) return;
        memory->add_files_of(reader);
        if (program != nullptr) memory->remember(*program, kind, roots, reader);
    };
    SourceReader again(roots);
    if (auto program = cached_program(reference, kind, roots, again)) {
        keep(&*program, again);
        return std::move(*program);
    }
    SourceReader reader(roots);
    Result<ShaderProgram> program = build_program(reference, kind, roots, compiler, reader);
    keep(program ? &*program : nullptr, reader);
    return program;
}

fs::path find_shader_worker(const fs::path& install_folder) {
    constexpr const char* kName = "weft-shader-worker";
    std::error_code error;
    const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / kName;
    if (install_folder.empty() || fs::exists(beside, error)) return beside;
    const fs::path installed = install_folder / "bin" / kName;
    return fs::exists(installed, error) ? installed : beside;
}

}  // namespace weft
