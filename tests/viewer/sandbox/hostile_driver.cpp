// A fake Vulkan driver that behaves like malicious code. When it is loaded, it attempts operations, most of
// which the sandbox must refuse. It prints one line with "done" or "refused" for each operation. The
// environment variable WEFT_HOSTILE_FOLDER names the folder that the driver attacks. Without this variable,
// the driver does nothing.
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

void say(const char* what, bool done) {
    std::fprintf(stderr, "hostile: %s %s\n", what, done ? "done" : "refused");
}

bool opens(const std::string& path, int flags) {
    const int file = open(path.c_str(), flags, 0600);
    if (file >= 0) close(file);
    return file >= 0;
}

bool connects(int family, int type) {
    const int made = socket(family, type, 0);
    if (made >= 0) close(made);
    return made >= 0;
}

bool sends_to_others() {
    int pair[2];
    if (socketpair(AF_UNIX, SOCK_DGRAM, 0, pair) != 0) return false;
    close(pair[0]);
    close(pair[1]);
    return true;
}

// Attempts to make another process the owner of a pipe. The kernel sends signals to the owner of a descriptor
// when the descriptor becomes ready.
bool owns_signals_of(pid_t process) {
    int pair[2];
    if (pipe(pair) != 0) return false;
    const bool done = fcntl(pair[0], F_SETOWN, process) == 0 && fcntl(pair[0], F_SETSIG, SIGCONT) == 0;
    close(pair[0]);
    close(pair[1]);
    return done;
}

bool writes_to_descriptor(const char* number) {
    return number != nullptr && write(std::atoi(number), "x", 1) == 1;
}

// Starts a child process that sleeps for ten minutes, so that it outlives the driver's process. The child
// closes its file descriptors, so that no caller waits for the end of its output.
void leave_behind() {
    const pid_t child = fork();
    if (child == 0) {
        for (int file = 0; file < 16; ++file) close(file);
        sleep(600);
        _exit(0);
    }
    std::fprintf(stderr, "hostile: left %d behind\n", child);
}

__attribute__((constructor)) void attack() {
    const char* folder = std::getenv("WEFT_HOSTILE_FOLDER");
    if (folder == nullptr) return;
    const std::string outside = folder;
    say("reads a file", opens(outside + "/secret.txt", O_RDONLY));
    say("reads /etc/passwd", opens("/etc/passwd", O_RDONLY));
    say("lists the folder", opens(outside, O_RDONLY | O_DIRECTORY));
    say("makes a file", opens(outside + "/new.txt", O_WRONLY | O_CREAT));
    say("truncates a file", truncate((outside + "/victim.txt").c_str(), 0) == 0);
    say("removes a file", unlink((outside + "/victim.txt").c_str()) == 0);
    say("changes rights", chmod((outside + "/secret.txt").c_str(), 0666) == 0);
    say("makes a network socket", connects(AF_INET, SOCK_STREAM));
    say("makes a local socket", connects(AF_UNIX, SOCK_STREAM));
    say("makes a datagram pair", sends_to_others());
    say("signals its parent", kill(getppid(), SIGCONT) == 0);
    say("owns signals of its parent", owns_signals_of(getppid()));
    say("writes to a file left open", writes_to_descriptor(std::getenv("WEFT_HOSTILE_DESCRIPTOR")));
    if (std::getenv("WEFT_HOSTILE_CHILD") != nullptr) leave_behind();
    // PTRACE_SEIZE does not stop the parent, and the trace ends with this process.
    say("traces its parent", ptrace(PTRACE_SEIZE, getppid(), nullptr, nullptr) == 0);
    say("makes memory that runs", mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC,
                                       MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED);
    if (std::getenv("WEFT_HOSTILE_CRASH") != nullptr) std::abort();
}

}  // namespace
