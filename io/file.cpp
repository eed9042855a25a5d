// Whole files in and out.
// SPDX-License-Identifier: MIT
#include "io/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <system_error>
#include <vector>

namespace kiri {

namespace {

std::string reasonOf(int code) { return std::generic_category().message(code); }

std::string folderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

/// Where a chain of links ends, so that writing replaces the file and not the link.
std::string targetOf(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), std::free);
  return real ? real.get() : path;
}

bool writeAll(int handle, const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::write(handle, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

Error unwritable(const std::string& path, int code) {
  std::string sentence = "cannot write " + path + ": ";
  struct stat folder = {};
  if (code == ENOENT && ::stat(folderOf(path).c_str(), &folder) != 0) {
    sentence += "there is no folder " + folderOf(path) + "; make it first";
  } else {
    sentence += reasonOf(code);
  }
  return {ErrorCode::Unwritable, sentence};
}

Status writeDirectly(const std::string& path, const std::string& bytes) {
  const int handle = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (handle < 0) return unwritable(path, errno);
  const bool isWritten = writeAll(handle, bytes);
  const int code = errno;
  ::close(handle);
  if (!isWritten) return unwritable(path, code);
  return std::monostate{};
}

/// The permissions that the finished file shall have: those of the file it replaces, or what the
/// user's mask allows.
mode_t modeFor(const struct stat* old) {
  if (old != nullptr) return old->st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

void syncFolder(const std::string& folder) {
  const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) return;
  ::fsync(handle);
  ::close(handle);
}

}  // namespace

Result<std::string> readStream(std::istream& in, const std::string& name, std::size_t limit) {
  std::string out;
  std::vector<char> buffer(std::size_t{1} << 16);
  while (in) {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    out.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
    if (out.size() > limit) {
      return Error{ErrorCode::BadFile, name + " has more than " + std::to_string(limit >> 20) +
                                           " MB; is this the right file?"};
    }
  }
  if (in.bad()) return Error{ErrorCode::BadFile, "reading " + name + " broke off"};
  return out;
}

Result<std::string> readFile(const std::string& path, std::size_t limit) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) {
    const int code = errno;
    return Error{
        ErrorCode::BadFile,
        "cannot read " + path + ": " + (code == ENOENT ? "there is no such file" : reasonOf(code))};
  }
  if (S_ISDIR(status.st_mode)) {
    return Error{ErrorCode::BadFile, "cannot read " + path + ": it is a folder, not a file"};
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) return Error{ErrorCode::BadFile, "cannot read " + path + ": " + reasonOf(errno)};
  return readStream(in, path, limit);
}

Status writeFile(const std::string& path, const std::string& bytes) {
  const std::string target = targetOf(path);
  struct stat old = {};
  const bool isThere = ::stat(target.c_str(), &old) == 0;
  if (isThere && S_ISDIR(old.st_mode)) {
    return Error{ErrorCode::Unwritable,
                 "cannot write " + path + ": it is a folder; name a file in it"};
  }
  if (isThere && !S_ISREG(old.st_mode)) return writeDirectly(target, bytes);

  std::string temporary = target + ".XXXXXX";
  const int handle = ::mkstemp(temporary.data());
  if (handle < 0) return unwritable(path, errno);
  bool isWritten = writeAll(handle, bytes) &&
                   ::fchmod(handle, modeFor(isThere ? &old : nullptr)) == 0 && ::fsync(handle) == 0;
  int code = errno;
  ::close(handle);
  if (isWritten && std::rename(temporary.c_str(), target.c_str()) != 0) {
    isWritten = false;
    code = errno;
  }
  if (!isWritten) {
    ::unlink(temporary.c_str());
    return unwritable(path, code);
  }
  syncFolder(folderOf(target));
  return std::monostate{};
}

}  // namespace kiri
