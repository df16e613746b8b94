#include "viewer/schema/schema_names.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "graph/parse/expression.h"
#include "graph/parse/reference.h"
#include "graph/syntax/merge.h"
#include "graph/syntax/read_graph.h"
#include "shader/compile/glsl_compile.h"
#include "viewer/files/files.h"
#include "weft/registry.h"
#include "weft/shader/compile_shader.h"

namespace weft::viewer {
namespace {

namespace fs = std::filesystem;
constexpr uint32_t kBoundSet = 1;
constexpr int kMostFolders = 3;  // Number of levels of folders that are searched below a start folder.
// At most this number of files and folders are examined below each start folder, because the graph may be in
// a large folder.
constexpr size_t kMostFiles = 10'000;

ShaderRoots shader_roots(const SchemaOptions& options) {
    const fs::path shipped = shipped_root() / "shaders";
    ShaderRoots roots{{fs::absolute(options.file).parent_path(), shipped},
                      shipped / "include",
                      shader_cache(),
                      find_shader_worker(),
                      options.limits.shader};
    roots.allowed.assign(options.graph_path.begin(), options.graph_path.end());
    return roots;
}

// Returns true for an identifier such as "raw", and for identifiers that are joined by "::", such as
// "glass::raw".
bool is_part_name(std::string_view name) {
    for (size_t end = name.find(kInGroup); end != std::string_view::npos; end = name.find(kInGroup)) {
        if (!is_identifier(name.substr(0, end))) return false;
        name.remove_prefix(end + kInGroup.size());
    }
    return is_identifier(name);
}

bool is_hidden(const fs::path& path) {
    return path.filename().string().starts_with(".");
}

void add_shader(const fs::path& root, const fs::path& file, GraphNames& names) {
    const fs::path name = file.lexically_relative(root);
    if (file.extension() == ".comp") names.compute_shaders.insert(name.generic_string());
    if (file.extension() == ".frag") names.fullscreen_shaders.insert(name.generic_string());
    if (file.extension() == ".vert" && file.stem() == file.parent_path().filename())
        names.raster_shaders.insert(name.parent_path().generic_string());
}

void list_shaders(const fs::path& root, GraphNames& names) {
    std::error_code error;
    fs::recursive_directory_iterator at(root, fs::directory_options::skip_permission_denied, error);
    size_t seen = 0;
    for (; !error && at != fs::recursive_directory_iterator() && seen < kMostFiles;
         at.increment(error), ++seen) {
        if (at.depth() >= kMostFolders || is_hidden(at->path())) at.disable_recursion_pending();
        if (at->is_regular_file(error)) add_shader(root, at->path(), names);
    }
}

std::string text_of(const JsonNode& node, std::string_view key) {
    const JsonNode* value = node.find(key);
    return value != nullptr && value->kind == JsonKind::string ? value->string : "";
}

std::set<std::string> keys_of(const JsonNode& node, std::string_view section) {
    std::set<std::string> keys;
    if (const JsonNode* value = node.find(section))
        for (const JsonMember& member : value->members)
            if (is_part_name(member.key)) keys.insert(member.key);
    return keys;
}

class NameGatherer {
 public:
    explicit NameGatherer(const SchemaOptions& options)
        : roots_(shader_roots(options)), compiler_(roots_), custom_(registered_passes()) {
        for (const fs::path& root : roots_.roots) list_shaders(root, names_);
    }

    void add(const JsonDoc& document) {
        const JsonNode& root = document.root;
        sources_ = &document.sources;
        names_.resources.merge(keys_of(root, "resources"));
        names_.params.merge(keys_of(root, "params"));
        names_.views.insert({"camera", "sun"});
        names_.views.merge(keys_of(root, "views"));
        if (const JsonNode* imports = root.find("imports"))
            for (const JsonMember& import : imports->members)
                if (is_identifier(import.key))
                    names_of_kind(text_of(import.value, "kind")).insert(import.key);
        names_.pass_names.merge(keys_of(root, "passes"));
        add_passes(root, names_.passes);
        if (const JsonNode* groups = root.find("groups"))
            for (const JsonMember& group : groups->members)
                if (is_part_name(group.key)) add_group(group);
    }

    GraphNames take(const std::vector<std::string>& tiers) {
        names_.tiers.insert(tiers.begin(), tiers.end());
        return std::move(names_);
    }

 private:
    std::set<std::string>& names_of_kind(const std::string& import_kind) {
        if (import_kind == "drawlist") return names_.draw_lists;
        if (import_kind == "views") return names_.views;
        return import_kind == "turns" ? names_.turns : names_.resources;
    }

    void add_passes(const JsonNode& owner, std::map<std::string, PassNames>& passes) {
        if (const JsonNode* section = owner.find("passes"))
            for (const JsonMember& pass : section->members)
                if (is_part_name(pass.key)) add_pass(pass.value, passes[pass.key]);
    }

    void add_group(const JsonMember& group) {
        for (const auto& [section, names] :
             {std::pair{"resources", &names_.resources}, std::pair{"passes", &names_.pass_names}})
            for (const std::string& name : keys_of(group.value, section))
                names->insert({name, name_in_group(group.key, name)});
        add_passes(group.value, names_.groups[group.key]);
    }

    void add_pass(const JsonNode& node, PassNames& pass) {
        pass.attachments.merge(keys_of(node, "out"));
        const std::string type = text_of(node, "type");
        const auto custom = custom_.find(type);
        if (custom != custom_.end()) return add_custom(custom->second, pass);
        const ShaderProgram* program = compiled(type, node.find("shader"));
        if (program == nullptr)
            pass.is_open = true;
        else
            add_interface(program->interface, pass);
    }

    static void add_custom(const PassType& type, PassNames& pass) {
        for (const PortDecl& port : type.ports) (port.is_output ? pass.out : pass.in).emplace(port.name);
        for (const ParamDecl& param : type.params) pass.params.emplace(param.name);
    }

    static void add_interface(const ShaderInterface& interface, PassNames& pass) {
        for (const ShaderBinding& binding : interface.bindings) {
            if (binding.set != kBoundSet || binding.name == "Params") continue;
            if (binding.reads) pass.in.insert(binding.name);
            if (binding.writes) pass.out.insert(binding.name);
        }
        for (const StageVariable& output : interface.fragment_outputs) pass.out.insert(output.name);
        for (const BlockMember& member : interface.params.members) pass.params.insert(member.name);
        for (const SpecConstant& constant : interface.spec_constants)
            if (!constant.name.starts_with("HAS_")) pass.constants.insert(constant.name);
    }

    // Returns the compiled program of a shader, or null if the shader does not exist or does not compile.
    // Also returns null if passes of `type` have no shader. Compiles each shader only once.
    const ShaderProgram* compiled(const std::string& type, const JsonNode* shader) {
        std::optional<ProgramKind> kind;
        if (type == "compute") kind = ProgramKind::compute;
        if (type == "fullscreen") kind = ProgramKind::fullscreen;
        if (type == "raster") kind = ProgramKind::raster;
        if (!kind || shader == nullptr || shader->string.empty()) return nullptr;
        // The shader is searched first in the folder of the file that names it.
        const fs::path file(sources_->files.at(shader->loc.file).path);
        ShaderRoots roots = roots_;
        roots.roots.insert(roots.roots.begin(), fs::absolute(file).parent_path());
        const auto [program, is_new] =
            programs_.try_emplace({type, shader->string, roots.roots.front().string()});
        if (is_new) {
            Result<ShaderProgram> made = compile_shader(shader->string, *kind, roots, compiler_);
            if (made) program->second = std::move(*made);
        }
        return program->second ? &*program->second : nullptr;
    }

    ShaderRoots roots_;
    shader::StageCompiler compiler_;
    PassCatalog custom_;
    const SourceMap* sources_ = nullptr;  // The files of the document whose names are being added.
    // Key: type of the pass, name of the shader, and folder of the file that names the shader.
    std::map<std::array<std::string, 3>, std::optional<ShaderProgram>> programs_;
    GraphNames names_;
};

}  // namespace

Result<GraphNames> gather_names(const SchemaOptions& options) {
    Result<JsonDoc> document =
        read_graph(options.file, reader_up_to(options.limits.graph.json_bytes),
                   {(shipped_root() / "graphs").string(), options.limits.graph, options.graph_path});
    if (!document) return document.take_errors();
    const std::vector<std::string> tiers = tier_names(*document);
    NameGatherer gatherer(options);
    const Result<JsonDoc> plain = merge(*document);
    gatherer.add(plain ? *plain : *document);
    for (const std::string& tier : tiers)
        if (const Result<JsonDoc> merged = merge(*document, tier)) gatherer.add(*merged);
    return gatherer.take(tiers);
}

}  // namespace weft::viewer
