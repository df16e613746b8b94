// Purpose: reads JSON with comments and trailing commas. Every value and key knows its place in the file.
// Limits: GraphLimits for bytes, depth, values and strings. Errors: W001 syntax, W002 no such file, W003
// duplicate key (all are reported), W004 too large or too deep, W005 not UTF-8; each with line, column and a
// remedy. Source: RFC 8259, plus // and /* */ comments and a comma after the last value.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weft/file_reader.h"
#include "weft/limits.h"
#include "weft/result.h"
#include "weft/source.h"

namespace weft {

enum class JsonKind : uint8_t { null, boolean, number, string, array, object };

struct JsonMember;

struct JsonNode {
    JsonKind kind = JsonKind::null;
    bool boolean = false;
    double number = 0;
    std::string string;               // The text of a string. For a number, its exact text in the file.
    std::vector<JsonNode> items;      // The elements of an array.
    std::vector<JsonMember> members;  // The members of an object, in the order of the file.
    // Place of the whole token, including quotes. For an object or array: place of the opening brace or
    // bracket.
    SourceLoc loc;

    [[nodiscard]] const JsonNode* find(std::string_view key) const;
};

struct JsonMember {
    std::string key;
    SourceLoc key_loc;
    JsonNode value;
};

// A file that another file includes.
struct IncludedJson {
    uint32_t file = 0;  // The file: an index into SourceMap::files.
    JsonNode root;
};

// A port of a module: a name in the section "ports" of its file.
struct ModulePort {
    std::string description;  // Empty if the module gives none.
    SourceLoc loc;
};

// A name of the including graph that replaces a port of a module. The key "with" of the include gives this
// name.
struct PortTarget {
    std::string name;
    SourceLoc port_loc, loc;  // Places of the name of the port and of the name that replaces it.
};

// An instance of a module: a file that was included with "as", together with the files that this file
// includes without "as". The graph itself is the first element of JsonDoc::modules; its name is empty.
struct ModuleInstance {
    std::string name;     // The full name, for example "glass", or "glass::inner" inside of "glass".
    uint32_t parent = 0;  // The instance that includes this one: an index into JsonDoc::modules.
    uint32_t file = 0;    // The included file: an index into SourceMap::files.
    SourceLoc as_loc;     // Place of the value of "as".
    std::map<std::string, ModulePort> ports = {};
    std::map<std::string, PortTarget> with = {};
};

struct JsonDoc {
    JsonNode root;
    SourceMap sources;  // The files that were read. The first file contains `root`.
    // The included files in the order in which they are merged. `root` is merged last and has priority over
    // them.
    std::vector<IncludedJson> included;
    // The graph and the instances of modules. If a file is part of several instances, SourceMap::files
    // contains it once for each of them. Empty: there are no instances.
    std::vector<ModuleInstance> modules = {};
    // For each file of SourceMap::files: the instance that it belongs to, an index into `modules`.
    std::vector<uint32_t> module_of_file = {};
};

// Reads the file `path` with `reader`. Returns the error W002 if the file does not exist.
[[nodiscard]] Result<JsonDoc> read_json(const std::string& path, const FileReader& reader,
                                        const GraphLimits& limits = {});
[[nodiscard]] const char* json_kind_name(JsonKind kind);
// Adds a file to `sources` and parses its text. `includer` is the place of the "include" that names the file,
// if there is one.
[[nodiscard]] Result<JsonNode> read_json_file(SourceMap& sources, const std::string& path, std::string text,
                                              const GraphLimits& limits, SourceLoc includer = {});
// Returns the JSON pointer (RFC 6901) of the value or key at a place in a file; empty if there is none.
[[nodiscard]] std::string pointer_at(const JsonDoc& document, const std::string& file, uint32_t line,
                                     uint32_t column);

}  // namespace weft
