// Purpose: changes the text of shipped graphs as a typing mistake would: misspelt keys, swapped values,
// removed members, numbers out of range, missing braces and quotes, swapped names, duplicated lines. Each
// seed gives one changed text (a mutant).
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "weft/file_reader.h"

namespace weft::test {

struct Mutant {
    uint32_t seed = 0;
    // The graph to load, relative to the source folder, such as "graphs/taa.json".
    std::string root;
    // The changed file: the graph itself, or a file that it includes.
    std::string file;
    // The changed text of `file`.
    std::string text;
    // Description of the change, such as "key misspelt".
    std::string how;
};

class GraphMutants {
 public:
    GraphMutants();

    [[nodiscard]] Mutant make(uint32_t seed) const;
    // Returns a reader that gives the mutant's text for the changed file. All other files are read from disk.
    [[nodiscard]] static FileReader reader_of(const Mutant& mutant);
    [[nodiscard]] static std::string path_of(const std::string& file);
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

 private:
    // All shipped graphs and docs/examples/ink.json, relative to the source folder.
    std::vector<std::string> files_;
    // The text of each of these files. The key is the entry of `files_`.
    std::map<std::string, std::string> texts_;
    // All keys and string values that occur in these files, including their quotes.
    std::vector<std::string> values_;
};

}  // namespace weft::test
