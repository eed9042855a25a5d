// A program that runs beside ours and reads what we send it.
// SPDX-License-Identifier: MIT
#include "render/film/child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

namespace kiri {

namespace {

std::string reasonOf(int code) { return std::generic_category().message(code); }

/// What the child gets: its end of the socket, no output, the file for what it says, signals as a
/// fresh program has them, and a process group of its own.
class SpawnSetting {
 public:
  SpawnSetting(int input, int said) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, said, STDERR_FILENO);
    ::posix_spawnattr_init(&attributes_);
    sigset_t signals;
    ::sigemptyset(&signals);
    ::posix_spawnattr_setsigmask(&attributes_, &signals);
    for (const int signal : {SIGPIPE, SIGINT, SIGTERM}) ::sigaddset(&signals, signal);
    ::posix_spawnattr_setsigdefault(&attributes_, &signals);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  SpawnSetting(const SpawnSetting&) = delete;
  SpawnSetting& operator=(const SpawnSetting&) = delete;
  ~SpawnSetting() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::posix_spawnattr_destroy(&attributes_);
  }

  int spawn(pid_t* process, std::vector<char*> words) const {
    return ::posix_spawnp(process, words[0], &actions_, &attributes_, words.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_ = {};
  posix_spawnattr_t attributes_ = {};
};

}  // namespace

Result<Child> Child::start(const std::vector<std::string>& words) {
  const std::string& name = words[0];
  const auto fail = [&](int code) {
    return Error{ErrorCode::Unwritable, "cannot start " + name + ": " + reasonOf(code), {}};
  };
  // A socket and not a pipe: writing to a reader that is gone can then be told not to raise a
  // signal.
  int ends[2] = {-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return fail(errno);
  constexpr suseconds_t kPatience = 200000;
  const timeval patience{0, kPatience};
  ::setsockopt(ends[1], SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  const int said = ::memfd_create("said", MFD_CLOEXEC);
  if (said < 0) {
    const int code = errno;
    ::close(ends[0]);
    ::close(ends[1]);
    return fail(code);
  }
  Child child(-1, ends[1], said, name);
  std::vector<std::string> copies = words;
  std::vector<char*> pointers;
  for (std::string& word : copies) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t process = -1;
  const int code = SpawnSetting(ends[0], said).spawn(&process, pointers);
  ::close(ends[0]);
  if (code == ENOENT) {
    return Error{ErrorCode::NotFound, "there is no program " + name + " in PATH", {}};
  }
  if (code != 0) return fail(code);
  child.process_ = process;
  return child;
}

Child::Child(Child&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      input_(std::exchange(other.input_, -1)),
      said_(std::exchange(other.said_, -1)),
      name_(std::move(other.name_)) {}

Child& Child::operator=(Child&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(input_, other.input_);
  std::swap(said_, other.said_);
  std::swap(name_, other.name_);
  return *this;
}

Child::~Child() {
  kill();
  closeInput();
  if (said_ >= 0) ::close(said_);
}

void Child::closeInput() {
  if (input_ >= 0) ::close(input_);
  input_ = -1;
}

void Child::kill() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
}

Status Child::send(const void* bytes, std::size_t count, const Progress& progress) {
  const char* at = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = ::send(input_, at, count, MSG_NOSIGNAL);
    const bool isSlow = sent < 0 && (errno == EINTR || errno == EAGAIN || errno == EWOULDBLOCK);
    if (isSlow && !goesOn(progress, 1)) {
      kill();
      return Error{ErrorCode::Cancelled, "stopped", {}};
    }
    if (isSlow) continue;
    if (sent <= 0) {
      const Status end = finish();
      return end.isOk() ? Error{ErrorCode::Unwritable, name_ + " stopped before the end", {}}
                        : end.error();
    }
    at += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return std::monostate{};
}

Status Child::finish(const Progress& progress) {
  closeInput();
  int status = 0;
  while (process_ >= 0) {
    const pid_t ended = ::waitpid(process_, &status, WNOHANG);
    if (ended == process_ || (ended < 0 && errno != EINTR)) {
      process_ = -1;
      break;
    }
    if (!goesOn(progress, 1)) {
      kill();
      return Error{ErrorCode::Cancelled, "stopped", {}};
    }
    constexpr useconds_t kPause = 5000;
    ::usleep(kPause);
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return std::monostate{};
  return failure(status);
}

Error Child::failure(int status) {
  std::string message = name_ + " failed";
  if (WIFSIGNALED(status)) message += ", ended by signal " + std::to_string(WTERMSIG(status));
  const std::string words = lastWords();
  return {ErrorCode::Unwritable, message + (words.empty() ? "" : ": " + words), {}};
}

/// The last lines of what it said, on one line.
std::string Child::lastWords() const {
  constexpr off_t kMost = 600;
  const off_t size = ::lseek(said_, 0, SEEK_END);
  if (size <= 0) return "";
  std::string text(static_cast<std::size_t>(std::min(size, kMost)), '\0');
  const ssize_t count = ::pread(said_, text.data(), text.size(), size - std::min(size, kMost));
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  if (size > kMost) text.erase(0, text.find('\n') + 1);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string("; ") : std::string(1, c);
  return out;
}

}  // namespace kiri
