// Tests with randomly changed graph files: each file either parses, or gives errors at lines and columns that
// exist in the file.
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <random>
#include <sstream>

#include "tests/graph/samples/full_graph.h"
#include "tests/graph/samples/marked_graph.h"

namespace weft::test {
namespace {

constexpr uint32_t kSeed = 20240611;
constexpr int kMutants = 2000;

std::string read_graph_file(const std::string& path) {
    std::ifstream file(std::string(WEFT_SOURCE_DIR) + "/" + path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void change_letter(std::string& text, size_t from, char letter) {
    const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0; };
    const auto it = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(), is_letter);
    if (it != text.end()) *it = letter;
}

// Makes one or two random edits in the text of a graph. Half of the edits only replace a letter, so that the
// file remains valid JSON and the later checks are tested too.
std::string mutate(std::string text, std::mt19937& random) {
    constexpr std::string_view kLetters = "aeinotxyz012789";
    constexpr std::string_view kLikely = "{}[]\",:/*\\ \n0123.-+@e_";
    const auto below = [&](size_t n) { return static_cast<size_t>(random() % std::max<size_t>(n, 1)); };
    for (size_t edits = 1 + below(2); edits > 0; --edits) {
        const size_t at = below(text.size());
        const size_t count = 1 + below(12);
        const size_t kind = below(12);
        if (kind == 0) text[at] = static_cast<char>(random() & 0xFF);
        if (kind == 1) text[at] = kLikely[below(kLikely.size())];
        if (kind == 2) text.erase(at, count);
        if (kind == 3) text.insert(at, text.substr(at, count));
        if (kind == 4) text.insert(at, text.substr(below(text.size()), count));
        if (kind == 5) text.resize(std::max<size_t>(at, 1));
        if (kind > 5) change_letter(text, at, kLetters[below(kLetters.size())]);
        if (text.empty()) text.assign(1, ' ');
    }
    return text;
}

void expect_located(const Diagnostic& error, const std::string& text) {
    EXPECT_EQ(error.file, "graph.json");
    EXPECT_FALSE(error.code.empty());
    const auto lines = static_cast<uint32_t>(std::count(text.begin(), text.end(), '\n')) + 1;
    ASSERT_GE(error.line, 1u) << to_text(error);
    ASSERT_LE(error.line, lines) << to_text(error);
    std::istringstream stream(text);
    std::string line;
    for (uint32_t i = 0; i < error.line; ++i) {
        // At the end of the file, getline would otherwise leave the previous line in `line`.
        line.clear();
        std::getline(stream, line);
    }
    EXPECT_GE(error.column, 1u) << to_text(error);
    EXPECT_LE(error.column, line.size() + 1) << to_text(error);
    EXPECT_FALSE(error.help.empty()) << to_text(error);
}

void check_mutants(const std::string& original) {
    const Result<GraphDesc> whole = parse_text(original);
    ASSERT_TRUE(whole.ok()) << to_text(whole.errors());
    std::mt19937 random(kSeed);
    int faulty = 0;
    for (int i = 0; i < kMutants && !::testing::Test::HasFailure(); ++i) {
        // With each failure, gtest prints the number `i` of the mutant.
        SCOPED_TRACE(i);
        const std::string text = mutate(original, random);
        const Result<GraphDesc> result = parse_text(text);
        if (result.ok()) continue;
        ++faulty;
        ASSERT_FALSE(result.errors().empty());
        for (const Diagnostic& error : result.errors()) expect_located(error, text);
    }
    std::printf("seed %u: %d of %d mutants are wrong\n", kSeed, faulty, kMutants);
    EXPECT_GT(faulty, kMutants / 2) << "the mutations are too tame to prove anything";
}

TEST(ParseMutants, OfAShippedModule) {
    check_mutants(read_graph_file("graphs/modules/reflections.json"));
}
TEST(ParseMutants, OfAGraphWithEveryKey) {
    check_mutants(kFullGraph);
}

}  // namespace
}  // namespace weft::test
