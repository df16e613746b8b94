#include "viewer/output/diagnostic_pages.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

#include "viewer/files/files.h"

namespace weft::viewer {
namespace {

constexpr uint64_t kMostPage_bytes = 4u << 20;

// Removes Markdown from a text: a link becomes the text between its brackets. The backquotes around code, the
// backslashes of escapes, and spaces at both ends of the text are removed.
std::string without_markup(const std::string& text) {
    std::string plain;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '`' || text[i] == '[') continue;
        if (text[i] == '\\' && i + 1 < text.size() &&
            std::ispunct(static_cast<unsigned char>(text[i + 1])) != 0)
            ++i;
        if (text.compare(i, 2, "](") == 0)
            i = std::min(text.find(')', i), text.size() - 1);
        else
            plain += text[i];
    }
    const size_t begin = plain.find_first_not_of(' '), end = plain.find_last_not_of(' ');
    return begin == std::string::npos ? "" : plain.substr(begin, end - begin + 1);
}

// Splits a row of a Markdown table: "| a | b |" gives "a" and "b". An escaped "\|" does not end a cell.
std::vector<std::string> cells_of(const std::string& row) {
    std::vector<std::string> cells;
    std::string cell;
    for (size_t i = 1; i < row.size(); ++i) {
        if (row[i] == '|' && row[i - 1] != '\\') {
            cells.push_back(without_markup(cell));
            cell.clear();
        } else {
            cell += row[i];
        }
    }
    return cells;
}

bool is_code(const std::string& text) {
    return text.size() == 4 && std::isupper(static_cast<unsigned char>(text[0])) != 0 &&
           std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

std::map<std::string, DiagnosticPage> diagnostic_pages() {
    const std::string file = (shipped_root() / "docs" / "diagnostics.md").string();
    std::map<std::string, DiagnosticPage> pages;
    std::istringstream lines(read_file(file, kMostPage_bytes).value_or(""));
    std::string section;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("#")) section = without_markup(line.substr(line.find_first_not_of('#')));
        if (!line.starts_with("| ")) continue;
        const std::vector<std::string> cells = cells_of(line);
        if (cells.size() < 2 || !is_code(cells[0])) continue;
        pages.try_emplace(cells[0], DiagnosticPage{cells[1], cells.size() > 2 ? cells[2] : "", section});
    }
    return pages;
}

}  // namespace weft::viewer
