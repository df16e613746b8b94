#include "shader/compile/shader_cache.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <system_error>

#include "shader/compile/content_hash.h"
#include "shader/compile/sealed_file.h"
#include "shader/worker/glsl_run.h"
#include "shader/worker/payload.h"

namespace weft::shader {

namespace fs = std::filesystem;

namespace {

constexpr uint64_t kMaxModules = 3;

fs::path file_named(const fs::path& folder, uint64_t hash, const char* extension) {
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
    return folder / (std::string(digits.data()) + extension);
}

fs::path manifest_file(const std::string& reference, ProgramKind kind, const ShaderRoots& roots) {
    ContentHash hash;
    hash.add(compiler_version());
    hash.add(reference);
    hash.add(static_cast<uint64_t>(kind));
    std::error_code error;
    for (const fs::path& root : roots.roots)
        hash.add(fs::absolute(root.empty() ? fs::path(".") : root, error).generic_string());
    hash.add(fs::absolute(roots.include_root, error).generic_string());
    return file_named(roots.cache_dir, hash.value(), ".manifest");
}

fs::path words_file(uint64_t content_hash, const ShaderRoots& roots) {
    return file_named(roots.cache_dir, content_hash, ".spirv");
}

std::string pack_manifest(const SourceReader& reader) {
    PayloadWriter writer;
    writer.number(reader.probes().size());
    for (const SourceProbe& probe : reader.probes()) {
        writer.number(probe.root);
        writer.text(probe.relative);
        writer.number(probe.present ? 1 : 0);
        writer.number(probe.text_hash);
    }
    return writer.payload();
}

// Returns true if every file that the manifest lists is unchanged. The function reads the files with
// `reader`. So if it returns true, `reader` has read the same texts as a compilation would read.
bool still_so(const std::string& manifest, SourceReader& reader) {
    PayloadReader payload(manifest);
    const auto count = payload.number();
    for (uint64_t i = 0; count && i < *count; ++i) {
        const auto root = payload.number();
        const auto relative = payload.text();
        const auto present = payload.number();
        const auto text_hash = payload.number();
        if (!text_hash) return false;
        if (!reader.still_so({*root, std::string(*relative), *present == 1, *text_hash})) return false;
    }
    return count.has_value() && payload.at_end();
}

std::string pack_words(const ShaderProgram& program) {
    PayloadWriter writer;
    writer.number(program.content_hash);
    writer.number(program.modules.size());
    for (const ShaderModule& module : program.modules) {
        writer.number(static_cast<uint64_t>(module.stage));
        std::string bytes;
        for (const uint32_t word : module.spirv) {
            for (uint32_t i = 0; i < 4; ++i)
                bytes += static_cast<char>(static_cast<uint8_t>(word >> (8 * i)));
        }
        writer.text(bytes);
    }
    return writer.payload();
}

std::optional<ShaderModule> unpack_module(PayloadReader& payload) {
    const auto stage = payload.number();
    const auto bytes = payload.text();
    if (!bytes || *stage > static_cast<uint64_t>(ShaderStage::compute) || bytes->size() % 4 != 0) return {};
    ShaderModule module;
    module.stage = static_cast<ShaderStage>(*stage);
    module.spirv.resize(bytes->size() / 4);
    for (size_t i = 0; i < bytes->size(); ++i) {
        module.spirv[i / 4] |= uint32_t{static_cast<uint8_t>((*bytes)[i])} << (8 * (i % 4));
    }
    return module;
}

}  // namespace

uint64_t content_hash_of(const std::string& reference, ProgramKind kind, const SourceReader& reader) {
    ContentHash hash;
    hash.add(compiler_version());
    hash.add(reference);
    hash.add(static_cast<uint64_t>(kind));
    std::vector<const SourceText*> sources = reader.sources();
    std::ranges::sort(sources, {}, &SourceText::name);
    for (const SourceText* source : sources) {
        hash.add(source->name);
        hash.add(source->text);
    }
    return hash.value();
}

std::optional<ShaderProgram> load_cached(const std::string& reference, ProgramKind kind,
                                         const ShaderRoots& roots, SourceReader& reader) {
    if (roots.cache_dir.empty()) return std::nullopt;
    const auto manifest = read_sealed(manifest_file(reference, kind, roots));
    if (!manifest || !still_so(*manifest, reader)) return std::nullopt;

    ShaderProgram program;
    program.reference = reference;
    program.content_hash = content_hash_of(reference, kind, reader);
    const auto words = read_sealed(words_file(program.content_hash, roots));
    if (!words) return std::nullopt;
    PayloadReader payload(*words);
    const auto stored_hash = payload.number();
    const auto count = payload.number();
    if (stored_hash != program.content_hash || !count || *count == 0 || *count > kMaxModules)
        return std::nullopt;
    for (uint64_t i = 0; i < *count; ++i) {
        auto module = unpack_module(payload);
        if (!module) return std::nullopt;
        program.modules.push_back(std::move(*module));
    }
    return program;
}

void store_cached(const ShaderProgram& program, ProgramKind kind, const ShaderRoots& roots,
                  const SourceReader& reader) {
    if (roots.cache_dir.empty()) return;
    write_sealed(words_file(program.content_hash, roots), pack_words(program));
    write_sealed(manifest_file(program.reference, kind, roots), pack_manifest(reader));
}

}  // namespace weft::shader
