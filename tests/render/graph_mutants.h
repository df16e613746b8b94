// The shipped graphs' texts, changed as a slip of the hand would: keys misspelt, values swapped, passes
// dropped, numbers out of range, braces and quotes cut, names exchanged, lines doubled. One seed, one mutant.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "weft/source.h"

namespace weft::test {

struct Mutant {
    uint32_t seed = 0;
    std::string root;  // the graph that is loaded, below the source folder: "graphs/taa.json"
    std::string file;  // the one that was changed: the graph, or one that it includes
    std::string text;  // of `file`
    std::string how;   // what was done
};

class GraphMutants {
 public:
    GraphMutants();

    [[nodiscard]] Mutant make(uint32_t seed) const;
    // Reads the mutant's text in place of its file, all others as they are.
    [[nodiscard]] static FileReader reader_of(const Mutant& mutant);
    [[nodiscard]] static std::string path_of(const std::string& file);
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

 private:
    std::vector<std::string> files_;            // of all shipped graphs
    std::map<std::string, std::string> texts_;  // by file
    std::vector<std::string> values_;           // strings that stand somewhere in them, with their quotes
};

}  // namespace weft::test
