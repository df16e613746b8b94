// Tests the diagnostics of graphs. For each code (except those of kWithoutFile), tests/diagnostics/ has at
// least one failing file, and a corrected file with the suffix ".good.json". Comments in a failing file mark
// the expected diagnostics:
//   // ^ W103 is expected here               W103 in the line above, in the column of the caret
//   // the line above has the error W204     W204 in the line above, in column 1
//   // nowhere: W120                         W120 without a place in a file
//   // help: did you mean "a"?               a help of the messages contains this text
// A first line "// args: …" gives further arguments of `weft check`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <sstream>
#include <tuple>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kFolder = WEFT_SOURCE_DIR "/tests/diagnostics";
constexpr std::string_view kGood = ".good.json";
constexpr std::string_view kHelp = "// help: ";
constexpr size_t kCodeLength = 4;

// Diagnostic codes that no graph file can cause, each with the reason.
const std::map<std::string, std::string> kWithoutFile{
    {"W162", "a validation message is a fault of Weft or of the driver: plans are proved not to cause any"},
    {"W189", "a difference comes from a shader that reads more than its inputs, not from the graph file"},
    {"W193", "the program gives the views of a frame, not the graph file"},
    {"W242", "the program gives the parameters of a frame, not the graph file"},
    {"W243", "the program asks for exports, not the graph file"},
    {"W244", "the program moves instances, not the graph file"},
    {"W245", "the program offers imports and draw lists, not the graph file"},
    {"W246", "the program offers descriptor sets, not the graph file"},
    {"W247", "the program removes parts of the scene, not the graph file"},
    {"W254", "the program gives the pass types, not the graph file"},
    {"W255", "the program gives the vertex formats of its draw lists, not the graph file"},
    {"W256", "the program offers descriptor sets, not the graph file"},
    {"W177", "of files, W108 and W201 come first; a program may hand in shaders that it compiled itself"},
};

struct Place {
    std::string code;
    // File name without folders; empty for a diagnostic without a place in a file.
    std::string file;
    uint32_t line = 0;
    uint32_t column = 0;
    auto operator<=>(const Place&) const = default;
};

std::string text_of(const std::set<Place>& places) {
    std::string text;
    for (const Place& p : places)
        text += "  " + p.file + ":" + std::to_string(p.line) + ":" + std::to_string(p.column) + " " + p.code +
                "\n";
    return text.empty() ? "  none\n" : text;
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

// Returns the text of the line after `mark`, or nullopt if the line does not contain `mark`.
std::optional<std::string> after_mark(const std::string& line, std::string_view mark) {
    const size_t at = line.find(mark);
    return at == std::string::npos ? std::nullopt : std::optional(line.substr(at + mark.size()));
}

// Adds a mark for each "^ W..." in a comment line. The mark means that line `of_line` has this diagnostic in
// the caret's column.
void add_carets(const std::string& line, const std::string& file, uint32_t of_line, std::set<Place>& marks) {
    for (size_t at = line.find("^ W"); at != std::string::npos; at = line.find("^ W", at + 1))
        marks.insert({line.substr(at + 2, kCodeLength), file, of_line, static_cast<uint32_t>(at + 1)});
}

std::set<Place> marks_in(const fs::path& path) {
    std::set<Place> marks;
    std::istringstream lines(read_text(path));
    const std::string file = path.filename().string();
    // `last` is the number of the last line that is not a mark.
    uint32_t number = 0, last = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const size_t begin = line.find_first_not_of(' ');
        const bool comment = begin != std::string::npos && line.compare(begin, 2, "//") == 0;
        if (const auto codes = after_mark(line, "// nowhere: "); comment && codes)
            for (const std::string& code : words_of(*codes)) marks.insert({code, "", 0, 0});
        const auto whole = after_mark(line, "// the line above has the error ");
        if (comment && whole)
            marks.insert({*whole, file, last, 1});
        else if (comment && line.find("^ W") != std::string::npos)
            add_carets(line, file, last, marks);
        else if (!comment || !after_mark(line, kHelp))
            last = number;
    }
    return marks;
}

// Returns the texts that the help of the messages must contain.
std::vector<std::string> helps_in(const fs::path& path) {
    std::istringstream lines(read_text(path));
    std::vector<std::string> helps;
    for (std::string line; std::getline(lines, line);)
        if (const auto help = after_mark(line, kHelp)) helps.push_back(*help);
    return helps;
}

std::vector<std::string> arguments_of(const fs::path& path) {
    std::istringstream lines(read_text(path));
    std::string first;
    std::getline(lines, first);
    return words_of(after_mark(first, "// args:").value_or(""));
}

RunResult check(const fs::path& path) {
    std::vector<std::string> arguments{"check", "--json", path.filename().string()};
    for (const std::string& argument : arguments_of(path)) arguments.push_back(argument);
    return run_weft(arguments, {}, kFolder);
}

bool needs_device(const fs::path& path) {
    const std::vector<std::string> arguments = arguments_of(path);
    return std::ranges::find(arguments, "--run") != arguments.end();
}

// Returns the names of all failing files without the suffix ".json", sorted.
std::vector<std::string> failing_files() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(kFolder)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".json") && !name.ends_with(kGood))
            names.push_back(name.substr(0, name.size() - std::string_view(".json").size()));
    }
    std::ranges::sort(names);
    return names;
}

std::string code_of(const std::string& name) {
    return name.substr(0, kCodeLength);
}

class Diagnosed : public testing::TestWithParam<std::string> {
 protected:
    void SetUp() override {
        if (needs_device(failing()) && !has_device()) GTEST_SKIP() << "no Vulkan device";
    }
    static fs::path failing() { return kFolder / (GetParam() + ".json"); }
    static fs::path corrected() { return kFolder / (GetParam() + std::string(kGood)); }
};

// `weft check` must report exactly the marked diagnostics. Shaders and included files may contain marks too;
// these count if a message names the file.
TEST_P(Diagnosed, AtTheMarkedPlacesAndNowhereElse) {
    const RunResult run = check(failing());
    const Json list = Json::parse(run.out, nullptr, false);
    ASSERT_TRUE(list.is_array()) << run.text();
    std::set<Place> wanted = marks_in(failing()), found;
    bool fails = false;
    std::string helps;
    for (const Json& d : list) {
        for (const Json& help : d.at("help")) helps += help.get<std::string>() + "\n";
        const fs::path file = d.at("file").get<std::string>();
        const uint32_t line = d.at("line");
        found.insert({d.at("code"), line == 0 ? "" : file.filename().string(), line, d.at("column")});
        EXPECT_FALSE(d.at("help").empty()) << "what is to be done about " << d.at("message");
        fails = fails || d.at("severity") == "error";
        if (line > 0) wanted.merge(marks_in(file.is_absolute() ? file : kFolder / file));
    }
    EXPECT_EQ(found, wanted) << "found\n" << text_of(found) << "wanted\n" << text_of(wanted) << run.text();
    for (const std::string& help : helps_in(failing()))
        EXPECT_NE(helps.find(help), std::string::npos) << help << "\n" << run.text();
    EXPECT_EQ(list.size(), found.size()) << "one message for one cause\n" << run.text();
    const auto is_its_own = [](const Place& p) { return p.code == code_of(GetParam()); };
    EXPECT_TRUE(std::ranges::any_of(found, is_its_own)) << text_of(found);
    EXPECT_LE(run.cpu_s, kMostInputCpu_s);
    EXPECT_LE(run.max_rss_bytes, kMostInputMemory_bytes);
    const int failure = code_of(GetParam()) == "W161" ? 6 : 3;
    EXPECT_EQ(run.exit_code, fails ? failure : 0) << run.text();
}

TEST_P(Diagnosed, NotInTheCorrectedFile) {
    const RunResult run = check(corrected());
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_EQ(Json::parse(run.out, nullptr, false), Json::array()) << run.text();
}

INSTANTIATE_TEST_SUITE_P(All, Diagnosed, testing::ValuesIn(failing_files()),
                         [](const auto& row) { return row.param; });

// In docs/diagnostics.md, the row of each code must link to the code's first failing file and to the
// corrected file. The codes of kWithoutFile need no links.
TEST(DiagnosticFiles, AreThereForEveryCodeOfThePage) {
    const std::vector<std::string> files = failing_files();
    std::istringstream page(read_text(WEFT_SOURCE_DIR "/docs/diagnostics.md"));
    std::set<std::string> codes;
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with("| W") || line.size() < 2 + kCodeLength || std::isdigit(line[4]) == 0) continue;
        const std::string code = line.substr(2, kCodeLength);
        codes.insert(code);
        if (kWithoutFile.contains(code)) continue;
        const auto of_code = [&](const std::string& name) { return code_of(name) == code; };
        const auto first = std::ranges::find_if(files, of_code);
        ASSERT_NE(first, files.end()) << code << " has no failing file";
        const std::string link = "(../tests/diagnostics/" + *first;
        EXPECT_NE(line.find(link + ".json)"), std::string::npos) << line;
        EXPECT_NE(line.find(link + std::string(kGood) + ")"), std::string::npos) << line;
    }
    for (const std::string& name : files)
        EXPECT_TRUE(codes.contains(code_of(name))) << name << " is on no page";
    EXPECT_GE(codes.size(), 60u);
    std::printf("%zu codes, %zu failing files\n", codes.size(), files.size());
}

}  // namespace
}  // namespace weft::test
