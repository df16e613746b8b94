// Purpose: the names of the parts of modules. Inside of its own files, a module writes short names such as
// "cull". In the merged document, the names of all parts are full names such as "glass::cull". A name
// belongs to the module of the file that contains the name.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "weft/result.h"
#include "weft/source.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// The kinds of names. Two things of different kinds may have the same name. value: parameters, constants and
// sizes. resource: also imports. view: lists of views.
enum class NameKind : uint8_t { value, resource, view, pass };
inline constexpr size_t kNameKinds = 4;

// Replaces the short names of all parts that a file of a module declares by full names. Removes the parts
// that "with" replaces by parts of the including graph. Also removes the keys that have a meaning only if the
// file is run itself.
void qualify_names(JsonNode& root, const ModuleInstance& module);

class ModuleNames {
 public:
    // `merged` is the document after all files were merged. Keeps a reference to its list of modules.
    explicit ModuleNames(const JsonDoc& merged);

    // Returns the full name of the thing that `name` means in a file. A name that the module does not know
    // gets the prefix of the module, so that it never means a part of the including graph by accident.
    [[nodiscard]] std::string full_name(NameKind kind, std::string_view name, SourceLoc place) const;
    // Returns the full name of an import: the name that "with" gives, or `name` itself.
    [[nodiscard]] std::string import_name(std::string_view name, SourceLoc place) const;
    // Returns the name without the name of its module: "cull" for "glass::cull". If modules are nested, the
    // longest name of a module at the beginning is removed.
    [[nodiscard]] std::string_view own_part(std::string_view full) const;
    // Returns the name of the module of a part: "glass" for "glass::cull"; empty for a part of the graph.
    [[nodiscard]] std::string_view module_of(std::string_view full) const;
    // Returns the full names of all modules.
    [[nodiscard]] std::vector<std::string> names() const {
        return {module_names_.begin(), module_names_.end()};
    }
    // A port of a module is a name that "with" replaces by a name of the including module. Returns the full
    // name of the parameter, constant or size that replaces the port. `module` is the module with the port.
    [[nodiscard]] std::string target_value(const ModuleInstance& module, const PortTarget& target) const;

    // Returns the kind of the part that `name` means in the module. If there is a part of the kind `wanted`
    // with this name, returns `wanted`. Returns nullopt if no part has this name, or if the program provides
    // it.
    [[nodiscard]] std::optional<NameKind> kind_of(uint32_t module, std::string_view name,
                                                  NameKind wanted) const;

    // Checks the ports of all modules. For each port, "with" must give a name that the including graph has,
    // or the module must declare the port itself. Errors: W239 a module has the name of a group, W240 a port
    // has no target.
    void check(const JsonDoc& merged, Diagnostics& errors) const;

 private:
    using NameSet = std::set<std::string, std::less<>>;

    [[nodiscard]] bool has(NameKind kind, std::string_view name) const;
    [[nodiscard]] std::string look_up(NameKind kind, uint32_t module, std::string_view name) const;
    [[nodiscard]] bool is_declared(uint32_t module, std::string_view name) const;
    [[nodiscard]] uint32_t child(uint32_t module, std::string_view name) const;
    [[nodiscard]] uint32_t module_at(SourceLoc place) const;
    [[nodiscard]] Diagnostic without_target(const JsonDoc& merged, uint32_t module, const std::string& port,
                                            const ModulePort& desc) const;
    [[nodiscard]] Diagnostic unknown_target(const JsonDoc& merged, uint32_t module,
                                            const PortTarget& target) const;

    const std::vector<ModuleInstance>& modules_;
    const std::vector<uint32_t>& module_of_file_;
    std::array<NameSet, kNameKinds> declared_;
    NameSet imports_, module_names_;
};

}  // namespace weft
