#include "tests/viewer/output/full_disk.h"

#include <unistd.h>

namespace weft::test {
namespace {

std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

// Returns a command that runs the shell script in its own mount namespace. For other users than root, it also
// creates a user namespace. Root needs none, and may be unable to create one.
std::vector<std::string> own_mounts(const std::string& script) {
    return {"unshare", geteuid() == 0 ? "-m" : "-rm", "sh", "-c", script};
}

}  // namespace

RunResult run_on_small_disk(const std::string& size, const std::string& script,
                            const Environment& environment) {
    const ScratchFolder disk;
    const std::string set_up = "DISK=" + quoted(disk.path().string()) + "\nmount -t tmpfs -o size=" + size +
                               " none \"$DISK\" || exit 99\n"
                               "fill_disk() { cat /dev/zero >\"$DISK/fill\" 2>/dev/null; }\n";
    return run_program(own_mounts(set_up + script), environment);
}

bool can_mount() {
    return run_on_small_disk("64k", "exit 0").exit_code == 0;
}

RunResult run_without_privileges(const std::string& script) {
    std::vector<std::string> words{"sh", "-c", script};
    if (geteuid() == 0) words.insert(words.begin(), {"setpriv", "--bounding-set=-all", "--inh-caps=-all"});
    return run_program(words);
}

std::string weft_in_shell(const std::vector<std::string>& arguments) {
    std::string text = quoted(WEFT_PROGRAM);
    for (const std::string& argument : arguments) text += " " + quoted(argument);
    return text;
}

}  // namespace weft::test
