#include "viewer/output/sarif.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "graph/diagnostics/utf8.h"
#include "viewer/files/files.h"
#include "viewer/output/diagnostic_pages.h"

namespace weft::viewer {
namespace {

using Json = nlohmann::ordered_json;
constexpr uint64_t kMostSource_bytes = 64u << 20;

// Converts a path to a URI as in RFC 3986. All bytes except letters and digits of ASCII and "-._~/" are
// written as %XX. An absolute path becomes a file URI.
std::string uri_of(const std::string& path) {
    constexpr std::string_view kHex = "0123456789ABCDEF", kPlain = "-._~/";
    std::string uri = path.starts_with('/') ? "file://" : "";
    for (const char c : path) {
        const auto byte = static_cast<uint8_t>(c);
        const bool letter = (byte | 0x20) >= 'a' && (byte | 0x20) <= 'z';
        if (letter || (byte >= '0' && byte <= '9') || kPlain.find(c) != std::string_view::npos)
            uri += c;
        else
            uri.append("%").append(1, kHex[byte >> 4]).append(1, kHex[byte & 15]);
    }
    return uri;
}

// Returns the number of UTF-16 code units in the first `bytes` bytes of a line. Each byte of invalid UTF-8
// counts as one unit, and so does each byte beyond the end of the line.
uint32_t utf16_units(std::string_view line, size_t bytes) {
    uint32_t units = 0;
    const size_t inside = std::min(bytes, line.size());
    std::string_view rest = line.substr(0, inside);
    while (!rest.empty()) {
        const Utf8 next = first_code_point(rest);
        units += next.code_point >= 0x10000 ? 2 : 1;
        rest.remove_prefix(std::max<size_t>(1, next.length));
    }
    return units + static_cast<uint32_t>(bytes - inside);
}

// Returns lines of source files and keeps the files in memory. The notes of a diagnostic need this, because a
// note contains the number of its source line, but not the text of the line.
class SourceLines {
 public:
    std::string line(const std::string& file, uint32_t number) {
        const auto [it, added] = texts_.try_emplace(file);
        if (added) it->second = read_file(file, kMostSource_bytes).value_or("");
        std::istringstream lines(it->second);
        std::string text;
        for (uint32_t i = 0; i < number; ++i)
            if (!std::getline(lines, text)) return "";
        return text;
    }

 private:
    std::map<std::string, std::string> texts_;
};

struct Place {
    std::string file;
    uint32_t line = 0;    // Counted from 1; 0: the place is the whole file.
    uint32_t column = 0;  // In bytes, counted from 1; 0: the place is the whole line.
    uint32_t length = 1;  // In bytes.
};

Json physical_location(const Place& place, const std::string& source_line) {
    Json location = {{"artifactLocation", {{"uri", uri_of(place.file)}}}};
    if (place.line == 0) return location;
    Json region = {{"startLine", place.line}};
    if (place.column > 0) {
        const size_t begin = place.column - 1, end = begin + std::max(1u, place.length);
        region["startColumn"] = utf16_units(source_line, begin) + 1;
        region["endColumn"] = utf16_units(source_line, end) + 1;
    }
    location["region"] = std::move(region);
    return location;
}

Json location_of(const Diagnostic& d) {
    Json location = Json::object();
    if (!d.file.empty())
        location["physicalLocation"] = physical_location({d.file, d.line, d.column, d.length}, d.source_line);
    if (!d.pointer.empty())
        location["logicalLocations"] = Json::array({{{"name", d.pointer.substr(d.pointer.rfind('/') + 1)},
                                                     {"fullyQualifiedName", d.pointer},
                                                     {"kind", "property"}}});
    return location;
}

std::string message_of(const Diagnostic& d) {
    std::string text = d.message;
    if (!d.tier.empty()) text += " (tier \"" + d.tier + "\")";
    for (const std::string& help : d.help) text += "\nhelp: " + help;
    return text;
}

Json notes_of(const Diagnostic& d, SourceLines& sources) {
    Json related = Json::array();
    for (const Note& note : d.notes) {
        Json location = {{"id", related.size()}, {"message", {{"text", note.message}}}};
        if (!note.file.empty())
            location["physicalLocation"] =
                physical_location({note.file, note.line, note.column, 1},
                                  note.line > 0 ? sources.line(note.file, note.line) : "");
        related.push_back(std::move(location));
    }
    return related;
}

const char* level_of(const Diagnostic& d) {
    return d.severity == Severity::error ? "error" : "warning";
}

// Returns one SARIF rule for each diagnostic code that occurs, sorted by code. Writes the position of each
// code in this list to `index`. Diagnostics without a code get no rule.
Json rules_of(const Diagnostics& diagnostics, std::map<std::string, size_t>& index) {
    const std::map<std::string, DiagnosticPage> pages = diagnostic_pages();
    std::map<std::string, const char*> levels;
    for (const Diagnostic& d : diagnostics)
        if (!d.code.empty()) levels.try_emplace(d.code, level_of(d));
    Json rules = Json::array();
    for (const auto& [code, level] : levels) {
        index[code] = rules.size();
        Json rule = {{"id", code}};
        if (const auto page = pages.find(code); page != pages.end()) {
            rule["shortDescription"] = {{"text", page->second.what}};
            // The rule has no helpUri, because the page is a local file and the log may be read on another
            // machine.
            rule["help"] = {{"text", page->second.remedy + (page->second.remedy.empty() ? "" : "\n") +
                                         "docs/diagnostics.md, section \"" + page->second.section + "\""}};
        }
        rule["defaultConfiguration"] = {{"level", level}};
        rules.push_back(std::move(rule));
    }
    return rules;
}

Json result_of(const Diagnostic& d, const std::map<std::string, size_t>& index, SourceLines& sources) {
    Json result = Json::object();
    if (!d.code.empty()) {
        result["ruleId"] = d.code;
        result["ruleIndex"] = index.at(d.code);
    }
    result["level"] = level_of(d);
    result["message"] = {{"text", message_of(d)}};
    if (Json location = location_of(d); !location.empty())
        result["locations"] = Json::array({std::move(location)});
    if (!d.notes.empty()) result["relatedLocations"] = notes_of(d, sources);
    if (!d.tier.empty()) result["properties"] = {{"tier", d.tier}};
    return result;
}

}  // namespace

std::string sarif_log(const Diagnostics& diagnostics) {
    std::map<std::string, size_t> index;
    SourceLines sources;
    Json rules = rules_of(diagnostics, index), results = Json::array();
    for (const Diagnostic& d : diagnostics) results.push_back(result_of(d, index, sources));
    const Json driver = {
        {"name", "weft"}, {"version", "0.1.0"}, {"semanticVersion", "0.1.0"}, {"rules", std::move(rules)}};
    const Json run = {{"tool", {{"driver", driver}}},
                      {"columnKind", "utf16CodeUnits"},
                      {"invocations", Json::array({{{"executionSuccessful", true}}})},
                      {"results", std::move(results)}};
    const Json log = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                      {"version", "2.1.0"},
                      {"runs", Json::array({run})}};
    return log.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace weft::viewer
