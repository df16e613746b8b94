#include "viewer/output/output.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <span>

#include "file/file_target.h"
#include "file/write_file.h"
#include "viewer/output/report.h"

namespace weft::viewer {
namespace {

ExitCode outcome(const Status& status, ExitCode code = ExitCode::ok) {
    if (status) return code;
    report(status.errors());
    return exit_code_for(status.errors());
}

// Returns the canonical path of the regular file to which `path` leads; the file need not exist yet. Returns
// an empty path for a pipe, a device or a folder. The caller ignores empty paths, because several outputs may
// use the same pipe or terminal.
std::filesystem::path plain_file(const std::string& path) {
    const FileTarget target = find_target(path);
    if (path.empty() || target.error != 0 || target.kind != TargetKind::file) return {};
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(target.path, error);
    return error ? std::filesystem::path() : std::filesystem::weakly_canonical(whole, error);
}

Status expect_own_file(const std::string& path, std::span<const std::string> others, const char* what) {
    const std::filesystem::path file = plain_file(path);
    for (const std::string& other : others) {
        if (file.empty() || file != plain_file(other)) continue;
        Diagnostic d;
        d.code = "X510";
        d.file = path;
        d.message = std::string("the file cannot be written: it is ") + what;
        d.help = {"choose another file for the output"};
        return d;
    }
    return Unit{};
}

}  // namespace

void prepare_output() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    // If the parent process closed standard streams, replace them by /dev/null. open() returns the lowest
    // free descriptor number, so the loop fills all free numbers up to 2. /dev/null is opened read-only, so
    // that writing to stdout or stderr still fails as on a closed stream.
    int descriptor = 0;
    while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = open("/dev/null", O_RDONLY);
    if (descriptor > STDERR_FILENO) close(descriptor);
}

ExitCode check_outputs(const std::vector<std::string>& paths, const std::vector<std::string>& inputs) {
    ExitCode code = ExitCode::ok;
    for (size_t i = 0; i < paths.size(); ++i) {
        if (paths[i].empty()) continue;
        code = outcome(check_writable(paths[i]), code);
        code = outcome(expect_own_file(paths[i], inputs, "also an input of this command"), code);
        code = outcome(
            expect_own_file(paths[i], std::span(paths).first(i), "also another output of this command"),
            code);
    }
    return code;
}

ExitCode print_data(std::string_view data, ExitCode code) {
    return outcome(write_stdout(data), code);
}

ExitCode output_data(const std::string& path, std::string_view data) {
    return path.empty() ? print_data(data) : outcome(write_file(path, data));
}

}  // namespace weft::viewer
