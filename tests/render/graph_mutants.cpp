#include "tests/render/graph_mutants.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

namespace weft::test {
namespace {

namespace fs = std::filesystem;
using Random = std::mt19937;

enum class TokenKind : uint8_t { key, string, number, mark };

struct Token {
    TokenKind kind = TokenKind::mark;
    size_t begin = 0, end = 0;
};

size_t end_of_string(const std::string& text, size_t begin) {
    size_t end = begin + 1;
    while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text.size());
}

// Splits JSON text into tokens. The tokenizer tolerates errors, so that a text that is already damaged can be
// changed again.
std::vector<Token> tokens_of(const std::string& text) {
    std::vector<Token> tokens;
    for (size_t i = 0; i < text.size();) {
        const char c = text[i];
        size_t end = i + 1;
        if (text.compare(i, 2, "//") == 0) {
            end = std::min(text.find('\n', i), text.size());
        } else if (c == '"') {
            end = end_of_string(text, i);
            const size_t next = text.find_first_not_of(' ', end);
            const bool key = next != std::string::npos && text[next] == ':';
            tokens.push_back({key ? TokenKind::key : TokenKind::string, i, end});
        } else if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-') {
            end = std::min(text.find_first_not_of("0123456789.eE+-", i), text.size());
            tokens.push_back({TokenKind::number, i, end});
        } else if (std::string_view("{}[],:").find(c) != std::string_view::npos) {
            tokens.push_back({TokenKind::mark, i, end});
        }
        i = end;
    }
    return tokens;
}

class Mutator {
 public:
    Mutator(std::string text, Random& random, const std::vector<std::string>& values)
        : text_(std::move(text)), random_(random), values_(values) {}

    // Makes one random change and returns its description. Returns an empty string if the chosen change was
    // not possible.
    std::string edit() {
        using Edit = bool (Mutator::*)();
        struct Named {
            const char* name;
            Edit edit;
        };
        // Several entries occur more than once, so they are chosen more often. These changes usually leave
        // the file valid JSON, so that it reaches the later stages of loading.
        static constexpr std::array kEdits{Named{"key misspelt", &Mutator::misspell_key},
                                           Named{"value misspelt", &Mutator::misspell_value},
                                           Named{"values swapped", &Mutator::swap_values},
                                           Named{"values swapped", &Mutator::swap_values},
                                           Named{"keys swapped", &Mutator::swap_keys},
                                           Named{"name exchanged", &Mutator::exchange_name},
                                           Named{"name repeated", &Mutator::repeat_name},
                                           Named{"name repeated", &Mutator::repeat_name},
                                           Named{"name repeated", &Mutator::repeat_name},
                                           Named{"member dropped", &Mutator::drop_member},
                                           Named{"member dropped", &Mutator::drop_member},
                                           Named{"member dropped", &Mutator::drop_member},
                                           Named{"number changed", &Mutator::change_number},
                                           Named{"number changed", &Mutator::change_number},
                                           Named{"number changed", &Mutator::change_number},
                                           Named{"reference changed", &Mutator::change_reference},
                                           Named{"reference changed", &Mutator::change_reference},
                                           Named{"expression changed", &Mutator::change_expression},
                                           Named{"expression changed", &Mutator::change_expression},
                                           Named{"mark cut", &Mutator::cut_mark},
                                           Named{"quote cut", &Mutator::cut_quote},
                                           Named{"line doubled", &Mutator::double_line},
                                           Named{"line dropped", &Mutator::drop_line},
                                           Named{"lines swapped", &Mutator::swap_lines},
                                           Named{"other kind of value", &Mutator::change_kind},
                                           Named{"byte changed", &Mutator::change_byte}};
        tokens_ = tokens_of(text_);
        const Named& chosen = kEdits[below(kEdits.size())];
        return (this->*chosen.edit)() ? chosen.name : "";
    }

    std::string take() { return std::move(text_); }

 private:
    size_t below(size_t n) { return static_cast<size_t>(random_() % std::max<size_t>(n, 1)); }

    const Token* pick(const std::function<bool(const Token&)>& fits) {
        std::vector<const Token*> fitting;
        for (const Token& token : tokens_)
            if (fits(token)) fitting.push_back(&token);
        return fitting.empty() ? nullptr : fitting[below(fitting.size())];
    }
    const Token* pick(TokenKind kind) {
        return pick([&](const Token& t) { return t.kind == kind; });
    }
    static bool is_value(const Token& token) {
        return token.kind == TokenKind::string || token.kind == TokenKind::number;
    }

    std::string text_of(const Token& token) const {
        return text_.substr(token.begin, token.end - token.begin);
    }
    bool replace(const Token& token, const std::string& by) {
        text_.replace(token.begin, token.end - token.begin, by);
        return true;
    }

    // Removes, doubles or changes one letter of the token, or swaps two neighbouring letters.
    bool misspell(const Token* token) {
        if (token == nullptr || token->end - token->begin < 4) return false;
        std::string word = text_of(*token);
        const size_t at = 1 + below(word.size() - 2);
        switch (below(4)) {
            case 0:
                word.erase(at, 1);
                break;
            case 1:
                word.insert(at, 1, word[at]);
                break;
            case 2:
                word[at] = "aeiourstln0123"[below(14)];
                break;
            default:
                if (at + 2 < word.size()) std::swap(word[at], word[at + 1]);
        }
        return replace(*token, word);
    }
    bool misspell_key() { return misspell(pick(TokenKind::key)); }
    bool misspell_value() { return misspell(pick(TokenKind::string)); }

    bool swap_two(const Token* a, const Token* b) {
        if (a == nullptr || b == nullptr || a == b) return false;
        if (a->begin > b->begin) std::swap(a, b);
        const std::string first = text_of(*a);
        const std::string second = text_of(*b);
        return replace(*b, first) && replace(*a, second);
    }
    bool swap_values() { return swap_two(pick(is_value), pick(is_value)); }
    bool swap_keys() { return swap_two(pick(TokenKind::key), pick(TokenKind::key)); }

    // Replaces a key, string or number by a key or string that occurs in any of the unchanged files.
    bool exchange_name() {
        const Token* token = pick([](const Token& t) { return t.kind != TokenKind::mark; });
        return token != nullptr && replace(*token, values_[below(values_.size())]);
    }

    // Replaces a name by another name of the same graph: a key by a key, or a string value by a string value.
    bool repeat_name() {
        const Token* token =
            pick([](const Token& t) { return t.kind == TokenKind::key || t.kind == TokenKind::string; });
        const Token* other = token == nullptr ? nullptr : pick(token->kind);
        return other != nullptr && other != token && replace(*token, text_of(*other));
    }

    // Removes a member: the text from its key to the end of its value, with the comma after the value if
    // there is one.
    bool drop_member() {
        const Token* key = pick(TokenKind::key);
        if (key == nullptr) return false;
        size_t depth = 0;
        size_t end = key->end;
        for (const Token* t = key + 1; t != tokens_.data() + tokens_.size(); ++t) {
            const char c = text_[t->begin];
            const bool closes = t->kind == TokenKind::mark && (c == '}' || c == ']');
            if (depth == 0 && t->kind == TokenKind::mark && (c == ',' || closes)) {
                if (c == ',') end = t->end;
                break;
            }
            if (t->kind == TokenKind::mark && (c == '{' || c == '[')) ++depth;
            if (closes) --depth;
            end = t->end;
        }
        text_.erase(key->begin, end - key->begin);
        return true;
    }

    bool change_number() {
        static constexpr std::array kNumbers{"0",          "-1",    "0.5",   "1",     "2",     "3",
                                             "7",          "16",    "100",   "1000",  "4096",  "65536",
                                             "1e9",        "1e30",  "-1e30", "1e400", "0.001", "-0.5",
                                             "4294967296", "16385", "1e-30", "255",   "33"};
        const Token* token = pick(TokenKind::number);
        return token != nullptr && replace(*token, kNumbers[below(kNumbers.size())]);
    }

    bool cut_mark() {
        const Token* token = pick(TokenKind::mark);
        return token != nullptr && replace(*token, "");
    }
    bool cut_quote() {
        const Token* token =
            pick([](const Token& t) { return t.kind == TokenKind::key || t.kind == TokenKind::string; });
        if (token == nullptr) return false;
        text_.erase(below(2) == 0 ? token->begin : token->end - 1, 1);
        return true;
    }

    struct Line {
        // Offsets of the line in the text; `end` is behind the newline.
        size_t begin = 0, end = 0;
    };
    Line pick_line() {
        const size_t at = below(text_.size());
        const size_t before = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
        const size_t after = text_.find('\n', at);
        return {before == std::string::npos ? 0 : before + 1,
                after == std::string::npos ? text_.size() : after + 1};
    }
    bool double_line() {
        const Line line = pick_line();
        text_.insert(line.begin, text_.substr(line.begin, line.end - line.begin));
        return true;
    }
    bool drop_line() {
        const Line line = pick_line();
        text_.erase(line.begin, line.end - line.begin);
        return true;
    }
    bool swap_lines() {
        Line a = pick_line(), b = pick_line();
        if (a.begin == b.begin) return false;
        if (a.begin > b.begin) std::swap(a, b);
        const std::string first = text_.substr(a.begin, a.end - a.begin);
        const std::string second = text_.substr(b.begin, b.end - b.begin);
        text_.replace(b.begin, b.end - b.begin, first);
        text_.replace(a.begin, a.end - a.begin, second);
        return true;
    }

    bool change_reference() {
        static constexpr std::array kTails{".mip(0)",   ".mip(1)",  "[-1]",      "[-2]",
                                           "@tonemap",  "@glass",   ".layer(0)", ".depth",
                                           ".layer(1)", ".stencil", "@down",     ".mip(0..2)"};
        const Token* token = pick(TokenKind::string);
        if (token == nullptr) return false;
        text_.insert(token->end - 1, kTails[below(kTails.size())]);
        return true;
    }

    bool change_expression() {
        const Token* token = pick([&](const Token& t) {
            return t.kind == TokenKind::string &&
                   text_of(t).find_first_of("+-*/%(). 0123456789") != std::string::npos;
        });
        if (token == nullptr) return false;
        std::string word = text_of(*token);
        word[1 + below(std::max<size_t>(word.size(), 3) - 2)] = "+-*/%(). 0129"[below(13)];
        return replace(*token, word);
    }

    bool change_kind() {
        static constexpr std::array kValues{"7",  "\"x\"",     "null",         "true", "[]",
                                            "{}", "[1, 2, 3]", "{ \"a\": 1 }", "\"\"", "\"1..3\""};
        const Token* token = pick(is_value);
        return token != nullptr && replace(*token, kValues[below(kValues.size())]);
    }

    bool change_byte() {
        text_[below(text_.size())] = static_cast<char>(random_() & 0xFF);
        return true;
    }

    std::string text_;
    Random& random_;
    const std::vector<std::string>& values_;
    std::vector<Token> tokens_;
};

std::string read_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace

GraphMutants::GraphMutants() {
    for (const auto& entry : fs::directory_iterator(path_of("graphs")))
        if (entry.is_regular_file() && entry.path().extension() == ".json" &&
            !entry.path().stem().string().ends_with(".schema"))
            files_.push_back("graphs/" + entry.path().filename().string());
    files_.emplace_back("docs/examples/ink.json");
    std::ranges::sort(files_);
    for (const std::string& file : files_) {
        const std::string& text = texts_[file] = read_file(path_of(file));
        for (const Token& token : tokens_of(text))
            if (token.kind == TokenKind::string || token.kind == TokenKind::key)
                values_.push_back(text.substr(token.begin, token.end - token.begin));
    }
    std::ranges::sort(values_);
    values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
}

std::string GraphMutants::path_of(const std::string& file) {
    return WEFT_SOURCE_DIR "/" + file;
}

Mutant GraphMutants::make(uint32_t seed) const {
    Random random(seed);
    Mutant mutant;
    mutant.seed = seed;
    mutant.root = files_[random() % files_.size()];
    mutant.file = mutant.root;
    // The change may be in an included file instead of the graph itself. Each included file is chosen with a
    // probability of 1/4.
    for (const std::string& file : files_) {
        const std::string name = fs::path(file).filename().string();
        const bool included =
            texts_.at(mutant.root).find("\"include\": [\"" + name + "\"]") != std::string::npos;
        if (included && random() % 4 == 0) mutant.file = file;
    }
    Mutator mutator(texts_.at(mutant.file), random, values_);
    const size_t edits = random() % 4 == 0 ? 2 : 1;
    for (size_t done = 0, tries = 0; done < edits && tries < 20; ++tries) {
        const std::string how = mutator.edit();
        if (how.empty()) continue;
        mutant.how += (done == 0 ? "" : ", ") + how;
        ++done;
    }
    mutant.text = mutator.take();
    return mutant;
}

FileReader GraphMutants::reader_of(const Mutant& mutant) {
    return [path = path_of(mutant.file),
            text = mutant.text](const std::string& file) -> std::optional<std::string> {
        std::error_code error;
        if (fs::weakly_canonical(file, error) == fs::path(path)) return text;
        if (!fs::is_regular_file(file, error)) return std::nullopt;
        return read_file(file);
    };
}

}  // namespace weft::test
