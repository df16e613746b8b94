// Purpose: writes HTML and SVG as text. Every tag is closed and all text is escaped. So the page is also
// well-formed XML, except for text from raw().
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace weft {

struct Attribute {
    Attribute(const char* its_name, std::string its_value) : name(its_name), value(std::move(its_value)) {}
    Attribute(const char* its_name, const char* its_value) : name(its_name), value(its_value) {}
    Attribute(const char* its_name, int64_t number) : name(its_name), value(std::to_string(number)) {}
    const char* name;
    std::string value;
};

// Returns the text escaped for use between tags and in quoted attributes. These become U+FFFD: control
// characters except newline and tab, the code points U+FFFE and U+FFFF, and bytes that are not valid UTF-8.
[[nodiscard]] std::string escaped(std::string_view text);

class Markup {
 public:
    using Attributes = std::vector<Attribute>;

    void open(const char* tag, const Attributes& attributes = {});
    void close();  // Closes the innermost open tag.
    void empty(const char* tag, const Attributes& attributes = {});
    void leaf(const char* tag, const Attributes& attributes, std::string_view text);
    void text(std::string_view text) { text_ += escaped(text); }
    void raw(std::string_view markup) { text_ += markup; }
    void line() { text_ += '\n'; }

    // Returns the whole text written so far. All tags must be closed.
    [[nodiscard]] std::string take();

 private:
    void tag(const char* name, const Attributes& attributes, const char* end);

    std::string text_;
    std::vector<const char*> open_;
};

}  // namespace weft
