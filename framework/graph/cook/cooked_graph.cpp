#include "weft/cooked_graph.h"

#include <cstring>
#include <utility>

#include <xxhash.h>

#include "graph/cook/byte_fields.h"
#include "graph/diagnostics/make_error.h"

namespace weft {
namespace {

struct CookedHeader {
    std::array<char, 8> magic{'W', 'E', 'F', 'T', 'C', 'O', 'O', 'K'};
    uint64_t layout = 0;   // Hash of the names and sizes of all fields.
    uint64_t content = 0;  // Hash of the bytes after the header.
};

// The parts of a cooked graph. The programs are in the order of their names.
struct CookedParts {
    ResolvedGraph graph;
    std::vector<ShaderProgram> programs;
};

template <class V>
void visit_parts(V& v, const CookedParts& parts) {
    v("graph", parts.graph), v("frames", parts.graph.frames), v("programs", parts.programs);
}

uint64_t layout_hash() {
    LayoutText layout;
    visit_parts(layout, CookedParts{});
    return XXH3_64bits(layout.text.data(), layout.text.size());
}

Diagnostic cooked_error(const std::string& name, const std::string& message, const std::string& help) {
    return make_error("V427", "\"" + name + "\" " + message, {help});
}

}  // namespace

std::vector<std::byte> cook(const ResolvedGraph& graph, const ShaderCatalog& shaders) {
    CookedParts parts{graph, {}};
    for (const auto& [reference, program] : shaders) parts.programs.push_back(program);
    ByteWriter writer;
    visit_parts(writer, parts);
    CookedHeader header;
    header.layout = layout_hash();
    header.content = XXH3_64bits(writer.bytes().data(), writer.bytes().size());
    std::vector<std::byte> bytes(sizeof header);
    std::memcpy(bytes.data(), &header, sizeof header);
    bytes.insert(bytes.end(), writer.bytes().begin(), writer.bytes().end());
    return bytes;
}

Result<CookedGraph> read_cooked(std::span<const std::byte> bytes, const std::string& name) {
    CookedHeader header;
    const CookedHeader wanted;
    if (bytes.size() >= sizeof header) std::memcpy(&header, bytes.data(), sizeof header);
    if (bytes.size() < sizeof header || header.magic != wanted.magic)
        return cooked_error(name, "is not a cooked graph", "make the file with cook()");
    if (header.layout != layout_hash())
        return cooked_error(name, "was cooked by another version of Weft",
                            "cook the graph again with the version of the program that reads it");
    const std::span<const std::byte> content = bytes.subspan(sizeof header);
    CookedParts parts;
    ByteFieldReader reader(content);
    if (header.content == XXH3_64bits(content.data(), content.size())) visit_parts(reader, parts);
    if (!reader.complete())
        return cooked_error(name, "is damaged: its content does not match its hash", "copy the file again");
    CookedGraph cooked{std::move(parts.graph), {}};
    for (ShaderProgram& program : parts.programs)
        cooked.shaders.emplace(program.reference, std::move(program));
    return cooked;
}

}  // namespace weft
