#include "viewer/pictures/picture_sequence.h"

#include <filesystem>
#include <optional>

namespace weft::viewer {
namespace {

// The text before and after the number of a picture.
struct Pattern {
    std::string before;
    std::string after;
    size_t digits = 1;  // The number is filled with zeros to this width.
    int numbers = 0;    // How often the pattern contains the number.
};

// Returns nullopt if a % begins neither a number nor %%.
std::optional<Pattern> parse(const std::string& text) {
    Pattern pattern;
    for (size_t i = 0; i < text.size(); ++i) {
        std::string& part = pattern.numbers == 0 ? pattern.before : pattern.after;
        if (text[i] != '%') {
            part += text[i];
            continue;
        }
        const std::string rest = text.substr(i + 1, 3);
        const bool is_filled =
            rest.size() == 3 && rest[0] == '0' && rest[1] >= '1' && rest[1] <= '9' && rest[2] == 'd';
        if (rest.starts_with('%')) {
            part += '%';
            ++i;
        } else if (rest.starts_with('d') || is_filled) {
            if (is_filled) pattern.digits = static_cast<size_t>(rest[1] - '0');
            ++pattern.numbers;
            i += is_filled ? 3 : 1;
        } else {
            return std::nullopt;
        }
    }
    return pattern;
}

// Returns the name with %04d before the extension, as a proposal.
std::string with_number(const std::string& name) {
    const std::filesystem::path path(name);
    std::string stem;
    for (const char c : path.stem().string())
        if (c != '%') stem += c;
    return (path.parent_path() / (stem + "%04d" + path.extension().string())).string();
}

}  // namespace

Result<std::vector<std::string>> picture_sequence(const std::string& pattern, uint32_t first, uint32_t last) {
    const std::optional<Pattern> parsed = parse(pattern);
    const bool fits = parsed && (parsed->numbers == 1 || (parsed->numbers == 0 && first == last));
    if (!fits) {
        Diagnostic d;
        d.code = "X524";
        d.message = "the frames " + std::to_string(first) + " to " + std::to_string(last) +
                    " need a file each, but \"" + pattern +
                    "\" does not contain the number of the frame exactly once";
        d.help = {"write %d or %04d for the number in the name, for example -o " + with_number(pattern)};
        return Diagnostics{d};
    }
    std::vector<std::string> files;
    for (uint32_t frame = first; frame <= last; ++frame) {
        std::string number = parsed->numbers == 0 ? "" : std::to_string(frame);
        if (parsed->numbers > 0 && number.size() < parsed->digits)
            number.insert(0, parsed->digits - number.size(), '0');
        files.push_back(parsed->before + number + parsed->after);
    }
    return files;
}

}  // namespace weft::viewer
