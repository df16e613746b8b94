// Helpers for tests of error messages: a faulty graph file has "$$" before each expected error, so that the
// tests need not count columns.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "graph/parse/parse.h"
#include "graph/syntax/merge.h"

namespace weft::test {

struct FaultCase {
    const char* name;
    // Text of the graph, with "$$" before each fault.
    std::string text;
    // Expected diagnostic codes, one for each "$$" in `text`, in the same order.
    std::vector<std::string> codes;
    // Text that the message of the first error must contain.
    std::string message;
    // Text that the help of the first error must contain.
    std::string help = "";
};

struct MarkedText {
    std::string text;
    // Places of the marks "$$", as "graph.json:line:column".
    std::vector<std::string> places;
};

inline MarkedText unmark(const std::string& marked) {
    MarkedText out;
    size_t line = 1, column = 1;
    for (size_t i = 0; i < marked.size(); ++i) {
        if (marked.compare(i, 2, "$$") == 0) {
            out.places.push_back("graph.json:" + std::to_string(line) + ":" + std::to_string(column));
            ++i;
            continue;
        }
        out.text += marked[i];
        column = marked[i] == '\n' ? 1 : column + 1;
        line += marked[i] == '\n' ? 1 : 0;
    }
    return out;
}

inline Result<JsonDoc> read_text(const std::string& text) {
    return read_json("graph.json", [&](const std::string&) { return std::optional<std::string>(text); });
}

inline Result<GraphDesc> parse_text(const std::string& text) {
    Result<JsonDoc> document = read_text(text);
    if (!document) return document.take_errors();
    Result<JsonDoc> merged = merge(std::move(document).value());
    if (!merged) return merged.take_errors();
    return parse(*merged);
}

// Returns the value of an expression that consists of a single number, and -1 for any other expression.
inline double number_of(const Expr& expression) {
    return expression.postfix.size() == 1 ? expression.postfix.front().number : -1;
}

inline std::string place(const Diagnostic& error) {
    return error.file + ":" + std::to_string(error.line) + ":" + std::to_string(error.column);
}

inline std::string joined_help(const Diagnostic& error) {
    std::string text;
    for (const std::string& help : error.help) text += help + "\n";
    return text;
}

inline void expect_faults(const FaultCase& fault, const MarkedText& marked, const Diagnostics& errors) {
    std::vector<std::string> codes, places;
    for (const Diagnostic& error : errors) {
        codes.push_back(error.code);
        places.push_back(place(error));
        EXPECT_FALSE(error.help.empty()) << "no remedy: " << to_text(error);
    }
    EXPECT_EQ(codes, fault.codes) << to_text(errors);
    EXPECT_EQ(places, marked.places) << to_text(errors);
    EXPECT_NE(errors.front().message.find(fault.message), std::string::npos) << to_text(errors);
    EXPECT_NE(joined_help(errors.front()).find(fault.help), std::string::npos) << to_text(errors);
}

inline void check_parse_fault(const FaultCase& fault) {
    const MarkedText marked = unmark(fault.text);
    const Result<GraphDesc> result = parse_text(marked.text);
    ASSERT_FALSE(result.ok()) << "no fault found in " << fault.name;
    expect_faults(fault, marked, result.errors());
}

inline void PrintTo(const FaultCase& fault, std::ostream* out) {
    *out << fault.text;
}

inline std::string case_name(const ::testing::TestParamInfo<FaultCase>& info) {
    return info.param.name;
}

}  // namespace weft::test
