#include "tests/graph/report/html/markup_reader.h"

#include <cctype>
#include <regex>

namespace weft::test {
namespace {

class Reader {
 public:
    explicit Reader(const std::string& text) : text_(text) {}

    ReadPage read() {
        constexpr std::string_view kType = "<!DOCTYPE html>";
        if (text_.compare(0, kType.size(), kType) != 0) return failed("no DOCTYPE");
        at_ = kType.size();
        while (at_ < text_.size() && page_.fault.empty()) text_[at_] == '<' ? tag() : words();
        if (page_.fault.empty() && !open_.empty())
            return failed("left open: " + page_.elements[open_.back()].tag);
        return page_;
    }

 private:
    ReadPage& failed(const std::string& what) {
        page_.fault = what + " at byte " + std::to_string(at_) + ": " + text_.substr(at_, 60);
        return page_;
    }

    void words() {
        const size_t end = std::min(text_.find('<', at_), text_.size());
        const std::string words = text_.substr(at_, end - at_);
        if (!escaped_well(words)) failed("a bare & or >");
        if (open_.empty() && words.find_first_not_of(" \n") != std::string::npos) failed("text outside");
        if (!open_.empty()) page_.elements[open_.back()].text += words;
        at_ = end;
    }

    static bool escaped_well(const std::string& words) {
        static const std::regex kEntity("&(amp|lt|gt|quot|#39);");
        return std::regex_replace(words, kEntity, "").find_first_of("&<>") == std::string::npos;
    }

    void tag() {
        const size_t end = text_.find('>', at_);
        if (end == std::string::npos) return void(failed("a tag without end"));
        std::string inside = text_.substr(at_ + 1, end - at_ - 1);
        if (inside[0] == '/') return close(inside.substr(1), end);
        const bool empty = inside.back() == '/';
        if (empty) inside.pop_back();
        ReadElement element;
        size_t i = 0;
        while (i < inside.size() && std::isalnum(static_cast<unsigned char>(inside[i])))
            element.tag += inside[i++];
        static const std::regex kAttribute(R"re(\s+([a-zA-Z:-]+)="([^"<]*)")re");
        std::string rest = inside.substr(i);
        for (std::smatch m; std::regex_search(rest, m, kAttribute, std::regex_constants::match_continuous);) {
            if (!element.attributes.emplace(m[1], m[2]).second) failed("an attribute twice");
            if (!escaped_well(m[2])) failed("an attribute with a bare &");
            rest = m.suffix();
        }
        if (rest.find_first_not_of(' ') != std::string::npos || element.tag.empty())
            return void(failed("no tag"));
        const bool raw = element.tag == "style" || element.tag == "script";
        page_.elements.push_back(std::move(element));
        at_ = end + 1;
        if (!empty) open_.push_back(page_.elements.size() - 1);
        if (raw) at_ = std::min(text_.find("</" + page_.elements.back().tag + ">", at_), text_.size());
    }

    void close(const std::string& name, size_t end) {
        if (open_.empty() || page_.elements[open_.back()].tag != name) return void(failed("closes nothing"));
        open_.pop_back();
        at_ = end + 1;
    }

    const std::string& text_;
    size_t at_ = 0;
    ReadPage page_;
    std::vector<size_t> open_;
};

}  // namespace

ReadPage read_markup(const std::string& text) {
    return Reader(text).read();
}

}  // namespace weft::test
