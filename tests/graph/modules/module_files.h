// Helpers for tests of modules: graph files in memory, with the marks "$$" before expected errors.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/parse/parse.h"
#include "graph/syntax/merge.h"
#include "graph/syntax/read_graph.h"
#include "tests/graph/samples/marked_graph.h"

namespace weft::test {

// The texts of graph files by path. "main.json" is the graph.
using ModuleFiles = std::map<std::string, std::string>;

inline Result<JsonDoc> read_modules(const ModuleFiles& files,
                                    const std::vector<std::string>& graph_path = {}) {
    const FileReader reader = [&](const std::string& path) {
        const auto it = files.find(path);
        return it == files.end() ? std::nullopt : std::optional<std::string>(it->second);
    };
    return read_graph("main.json", reader, {"shipped", {}, graph_path});
}

inline Result<GraphDesc> load_modules(const ModuleFiles& files, const std::string& tier = "",
                                      const std::vector<std::string>& graph_path = {}) {
    Result<JsonDoc> document = read_modules(files, graph_path);
    if (!document) return document.take_errors();
    Result<JsonDoc> merged = merge(std::move(*document), tier);
    if (!merged) return merged.take_errors();
    return parse(*merged);
}

// Expects exactly one error, at the only mark "$$" of the files.
inline void expect_module_fault(const ModuleFiles& marked, const std::string& code,
                                const std::string& message, const std::string& help) {
    ModuleFiles files;
    std::string expected;
    for (const auto& [name, text] : marked) {
        const MarkedText found = unmark(text);
        files[name] = found.text;
        for (const std::string& place : found.places)
            expected += name + place.substr(std::string("graph.json").size());
    }
    const Result<GraphDesc> graph = load_modules(files);
    ASSERT_FALSE(graph.ok()) << "no fault found";
    ASSERT_EQ(graph.errors().size(), 1u) << to_text(graph.errors());
    const Diagnostic& fault = graph.errors().front();
    EXPECT_EQ(fault.code, code) << to_text(fault);
    EXPECT_EQ(place(fault), expected) << to_text(fault);
    EXPECT_NE(fault.message.find(message), std::string::npos) << to_text(fault);
    EXPECT_NE(joined_help(fault).find(help), std::string::npos) << to_text(fault);
}

// The keys of a map, separated by spaces.
template <class Map>
std::string keys_text(const Map& map) {
    std::string text;
    for (const auto& [key, unused] : map) text += (text.empty() ? "" : " ") + key;
    return text;
}

// The names in an expression, separated by spaces.
inline std::string names_in(const Expr& expression) {
    std::string text;
    for (const ExprNode& node : expression.postfix)
        if (!node.name.empty()) text += (text.empty() ? "" : " ") + node.name;
    return text;
}

}  // namespace weft::test
