#include <algorithm>
#include <array>
#include <numeric>

#include "graph/diagnostics/name_of_value.h"
#include "graph/diagnostics/quantity_text.h"
#include "graph/syntax/json_scan.h"
#include "weft/syntax/json_doc.h"

namespace weft {
namespace {

constexpr size_t kMaxDuplicatesReported = 50;

bool begins_number(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}
bool begins_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool begins_value(char c) {
    return c == '"' || c == '{' || c == '[' || begins_number(c) || begins_word(c);
}

// Parses JSON by recursive descent, so the nesting depth is limited. A syntax error stops the parser.
// Duplicate keys do not stop it; the first kMaxDuplicatesReported of them are reported.
class JsonReader {
 public:
    JsonReader(std::string_view text, uint32_t file, const GraphLimits& limits)
        : cursor_(text, file), limits_(limits) {}

    bool read(JsonNode& root) {
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (cursor_.starts_with(kByteOrderMark)) cursor_.advance(kByteOrderMark.size());
        if (!blank()) return false;
        if (cursor_.at_end())
            return syntax(cursor_.here(), "the file is empty", "write a graph: it begins with '{'");
        if (!value(root) || !blank()) return false;
        if (cursor_.at_end()) return true;
        return syntax(cursor_.here(),
                      "found '" + printable(cursor_.peek()) + "' after the end of the JSON document",
                      "remove this text, or look for an extra closing brace before it");
    }
    std::vector<JsonFault> take_faults() { return std::move(faults_); }

 private:
    bool fail(JsonFault fault) {
        faults_.push_back(std::move(fault));
        return false;
    }
    bool fail(std::optional<JsonFault> fault) { return fail(std::move(*fault)); }
    bool syntax(SourceLoc loc, std::string message, std::string help) {
        return fail(JsonFault{"W001", loc, std::move(message), std::move(help), std::nullopt, {}});
    }
    bool over(SourceLoc loc, std::string message, const std::string& help, const std::string& limit) {
        return fail(JsonFault{
            "W004", loc, std::move(message), help + ", " + raise_limit_text(limit), std::nullopt, {}});
    }
    bool blank() {
        auto fault = skip_blank(cursor_);
        return !fault || fail(std::move(fault));
    }

    bool value(JsonNode& node) {
        node.loc = cursor_.here();
        if (++values_ > limits_.json_values)
            return over(node.loc,
                        "the file contains more than " + std::to_string(limits_.json_values) + " values",
                        "split the graph into smaller graphs", "graph.jsonValues");
        const char c = cursor_.peek();
        if (c == '{') return nested(node, '}');
        if (c == '[') return nested(node, ']');
        if (c == '"') {
            node.kind = JsonKind::string;
            if (!string(node.string)) return false;
            node.loc.length = static_cast<uint32_t>(length_since(node.loc));
            return true;
        }
        if (begins_number(c)) {
            node.kind = JsonKind::number;
            if (auto fault = scan_number(cursor_, node.number, node.string)) return fail(std::move(fault));
            node.loc.length = static_cast<uint32_t>(node.string.size());
            return true;
        }
        if (begins_word(c)) return word(node);
        if (c == '\'') return syntax(node.loc, "found a single quote", "write strings with double quotes");
        return syntax(node.loc, "found '" + printable(c) + "' where a value was wanted",
                      "write a value here");
    }

    [[nodiscard]] size_t length_since(const SourceLoc& begin) const {
        return cursor_.here().column - begin.column;
    }

    bool string(std::string& out) {
        const SourceLoc loc = cursor_.here();
        auto fault = scan_string(cursor_, out);
        if (fault) return fail(std::move(fault));
        if (out.size() <= limits_.string_bytes) return true;
        return over(loc,
                    "the string has " + std::to_string(out.size()) + " bytes, more than " +
                        std::to_string(limits_.string_bytes),
                    "look for a missing quote", "graph.stringBytes");
    }

    bool word(JsonNode& node) {
        const size_t begin = cursor_.position();
        while (begins_word(cursor_.peek()) || (cursor_.peek() >= '0' && cursor_.peek() <= '9'))
            cursor_.advance();
        const std::string spelling(cursor_.from(begin));
        node.loc.length = static_cast<uint32_t>(spelling.size());
        node.kind = spelling == "null" ? JsonKind::null : JsonKind::boolean;
        node.boolean = spelling == "true";
        if (spelling == "null" || spelling == "true" || spelling == "false") return true;
        const std::string near = did_you_mean_text(spelling, {"true", "false", "null"});
        return syntax(node.loc, "found " + spelling + " where a value was wanted",
                      near.empty() ? "put text in double quotes" : near);
    }

    bool nested(JsonNode& node, char close) {
        node.kind = close == '}' ? JsonKind::object : JsonKind::array;
        if (++depth_ > limits_.json_depth)
            return over(node.loc,
                        "objects and arrays are nested more than " + std::to_string(limits_.json_depth) +
                            " levels deep",
                        "look for a missing closing bracket", "graph.jsonDepth");
        cursor_.advance();
        for (;;) {
            if (!blank()) return false;
            if (cursor_.peek() == close) break;
            if (cursor_.at_end()) return truncated(node, close);
            const bool read = close == '}' ? member(node) : value(node.items.emplace_back());
            if (!read || !separator(node, close)) return false;
        }
        cursor_.advance();
        --depth_;
        report_duplicates(node);
        return true;
    }

    bool member(JsonNode& node) {
        const SourceLoc loc = cursor_.here();
        const char c = cursor_.peek();
        if (c == ']') return mismatch(node, '}');
        if (c == '\'') return syntax(loc, "found a single quote", "write keys with double quotes");
        if (begins_word(c)) return syntax(loc, "found a key without quotes", "put the key in double quotes");
        if (c != '"')
            return syntax(loc, "found '" + printable(c) + "' where a key was wanted",
                          c == ',' ? "remove one of the two commas" : "write \"key\": value");
        constexpr size_t kUsualMembers = 4;
        if (node.members.empty()) node.members.reserve(kUsualMembers);
        JsonMember& entry = node.members.emplace_back();
        entry.key_loc = loc;
        if (!string(entry.key)) return false;
        entry.key_loc.length = static_cast<uint32_t>(length_since(loc));
        if (!blank()) return false;
        if (cursor_.at_end()) return truncated(node, '}');
        if (cursor_.peek() != ':')
            return syntax(cursor_.here(), "found '" + printable(cursor_.peek()) + "' where ':' was wanted",
                          "put a ':' between the key \"" + entry.key + "\" and its value");
        cursor_.advance();
        if (!blank()) return false;
        if (cursor_.at_end()) return truncated(node, '}');
        return value(entry.value);
    }

    // Expects a comma between two values, or the closing bracket. A comma before the closing bracket is
    // allowed.
    bool separator(const JsonNode& node, char close) {
        const SourceLoc end_of_value = cursor_.here();
        if (!blank()) return false;
        const char c = cursor_.peek();
        if (c == close) return true;
        if (c == ',') {
            cursor_.advance();
            return true;
        }
        if (cursor_.at_end()) return truncated(node, close);
        if (c == '}' || c == ']') return mismatch(node, close);
        if (begins_value(c))
            return syntax(end_of_value, "a comma is missing between two values", "add a comma here");
        return syntax(cursor_.here(), "found '" + printable(c) + "' where ',' or '" + close + "' was wanted",
                      "add a comma, or close the " + opening(node));
    }

    static std::string opening(const JsonNode& node) {
        return std::string(node.kind == JsonKind::object ? "brace" : "bracket") + " opened at line " +
               std::to_string(node.loc.line);
    }
    bool unclosed(const JsonNode& node, std::string message, char close) {
        return fail(JsonFault{"W001", cursor_.here(), std::move(message),
                              "close the " + opening(node) + " with '" + close + "'", node.loc,
                              "opened here"});
    }
    bool truncated(const JsonNode& node, char close) {
        return unclosed(
            node, std::string("the file ends inside ") + (close == '}' ? "an object" : "an array"), close);
    }
    bool mismatch(const JsonNode& node, char close) {
        return unclosed(node, std::string("found '") + cursor_.peek() + "' where '" + close + "' was wanted",
                        close);
    }

    // Returns true if two members have the same key. It compares all pairs, so it is for small objects.
    static bool has_duplicate(const std::vector<JsonMember>& members) {
        for (size_t i = 1; i < members.size(); ++i)
            for (size_t k = 0; k < i; ++k)
                if (members[i].key == members[k].key) return true;
        return false;
    }

    void report_duplicates(const JsonNode& node) {
        constexpr size_t kSmall = 8;
        if (node.members.size() <= kSmall && !has_duplicate(node.members)) return;
        std::vector<size_t> order(node.members.size());
        std::iota(order.begin(), order.end(), size_t{0});
        const auto key = [&](size_t i) -> const std::string& { return node.members[i].key; };
        std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return key(a) < key(b); });
        for (size_t i = 1, first = 0; i < order.size(); ++i) {
            if (key(order[i]) != key(order[first])) {
                first = i;
            } else if (++duplicates_ <= kMaxDuplicatesReported) {
                const JsonMember& again = node.members[order[i]];
                faults_.push_back({"W003", again.key_loc,
                                   "the key \"" + again.key + "\" occurs twice in this object",
                                   "remove one of the two, or rename one", node.members[order[first]].key_loc,
                                   "first written here"});
            }
        }
    }

    JsonCursor cursor_;
    const GraphLimits& limits_;
    size_t depth_ = 0;
    size_t values_ = 0;
    size_t duplicates_ = 0;
    std::vector<JsonFault> faults_;
};

Diagnostic to_diagnostic(const JsonFault& fault, const SourceMap& sources) {
    Diagnostic error = sources.error(fault.loc, fault.code, fault.message);
    if (error.source_line.size() > kMaxExcerptBytes) error.source_line.clear();
    error.help.push_back(fault.help);
    if (fault.note_loc)
        error.notes.push_back({error.file, fault.note_loc->line, fault.note_loc->column, fault.note});
    return error;
}

Diagnostic file_error(const std::string& path, std::string code, std::string message, std::string help) {
    Diagnostic error;
    error.code = std::move(code);
    error.message = std::move(message);
    error.file = path;
    error.help.push_back(std::move(help));
    return error;
}

}  // namespace

const JsonNode* JsonNode::find(std::string_view key) const {
    const auto it =
        std::find_if(members.begin(), members.end(), [&](const JsonMember& m) { return m.key == key; });
    return it == members.end() ? nullptr : &it->value;
}

const char* json_kind_name(JsonKind kind) {
    return name_of_value(kind, std::array{"null", "true or false", "number", "string", "array", "object"});
}

Result<JsonNode> read_json_file(SourceMap& sources, const std::string& path, std::string text,
                                const GraphLimits& limits, SourceLoc includer) {
    if (text.size() > limits.json_bytes)
        return file_error(path, "W004", "the file has more than " + limit_bytes_text(limits.json_bytes),
                          "check that this file is a graph, " + raise_limit_text("graph.jsonBytes"));
    const uint32_t index = sources.add_file(path, std::move(text), includer);
    const std::string_view source = sources.files.back().text;
    JsonNode root;
    std::vector<JsonFault> faults;
    if (auto fault = check_utf8(source)) {
        fault->loc.file = index;
        faults.push_back(std::move(*fault));
    } else {
        JsonReader json(source, index, limits);
        json.read(root);
        faults = json.take_faults();
    }
    if (faults.empty()) return root;
    const auto before = [](const JsonFault& a, const JsonFault& b) {
        return std::pair(a.loc.line, a.loc.column) < std::pair(b.loc.line, b.loc.column);
    };
    std::stable_sort(faults.begin(), faults.end(), before);
    Diagnostics errors;
    for (const JsonFault& fault : faults) errors.push_back(to_diagnostic(fault, sources));
    return errors;
}

Result<JsonDoc> read_json(const std::string& path, const FileReader& reader, const GraphLimits& limits) {
    std::optional<std::string> text = reader(path);
    if (!text)
        return file_error(path, "W002", "the file \"" + path + "\" does not exist or cannot be read",
                          "check the path; a relative path is relative to the current folder");
    JsonDoc doc;
    Result<JsonNode> root = read_json_file(doc.sources, path, std::move(*text), limits);
    if (!root) return root.take_errors();
    doc.root = std::move(*root);
    return doc;
}

}  // namespace weft
