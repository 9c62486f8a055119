// A file appears whole or not at all, and nothing is left behind.
#include "image/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/error.h"
#include "files.h"
#include "support/paths.h"

namespace umbral {
namespace {

namespace fs = std::filesystem;
using test::bytes_of, test::files_in, test::message_of;
using testing::HasSubstr;

void write(const fs::path& path, const std::string& text) {
  AtomicFile file(path.string());
  file.write(text);
  file.commit();
}

TEST(AtomicFile, AppearsOnCommitOnly) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory.path() / "a";
  {
    AtomicFile file(path.string());
    file.write(std::string("hello"));
    EXPECT_FALSE(fs::exists(path));
    file.commit();
    EXPECT_EQ(bytes_of(path), "hello");
  }
  EXPECT_EQ(files_in(directory.path()), 1u);
}

TEST(AtomicFile, WithoutCommitTheOldContentStays) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory.path() / "a";
  write(path, "old");
  {
    AtomicFile file(path.string());
    file.write(std::string("new"));
  }
  EXPECT_EQ(bytes_of(path), "old");
  EXPECT_EQ(files_in(directory.path()), 1u);
}

TEST(AtomicFile, SeeksAndOverwrites) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory.path() / "a";
  AtomicFile file(path.string());
  file.write(std::string("0123456789"));
  file.seek(2);
  file.write(std::string("ab"));
  EXPECT_EQ(file.position(), 4u);
  file.commit();
  EXPECT_EQ(bytes_of(path), "01ab456789");
}

TEST(AtomicFile, RelativeNamesAndLongNamesWork) {
  const test::TemporaryDirectory directory;
  const fs::path before = fs::current_path();
  fs::current_path(directory.path());
  write("plain", "x");
  fs::current_path(before);
  EXPECT_EQ(bytes_of(directory.path() / "plain"), "x");
  const fs::path longest = directory.path() / std::string(255, 'n');
  write(longest, "y");
  EXPECT_EQ(bytes_of(longest), "y");
}

TEST(AtomicFile, WritesThroughALink) {
  const test::TemporaryDirectory directory;
  write(directory.path() / "target", "old");
  fs::create_symlink("target", directory.path() / "link");
  write(directory.path() / "link", "new");
  EXPECT_TRUE(fs::is_symlink(directory.path() / "link"));
  EXPECT_EQ(bytes_of(directory.path() / "target"), "new");
}

TEST(AtomicFile, RefusesWhatCannotBeReplaced) {
  const test::TemporaryDirectory directory;
  const std::string base = directory.path().string();
  const auto refusal = [](const std::string& path) {
    return message_of<OutputError>([&] { AtomicFile file(path); });
  };
  EXPECT_EQ(refusal(base + "/none/a"),
            "cannot write '" + base + "/none/a': there is no directory '" + base + "/none'");
  EXPECT_EQ(refusal(base), "cannot write '" + base + "': it is a directory");
  EXPECT_EQ(refusal(base + "/"), "cannot write '" + base + "/': it does not name a file");
  EXPECT_EQ(refusal(""), "cannot write '': it does not name a file");
  EXPECT_EQ(refusal("/dev/null"), "cannot write '/dev/null': it is not a regular file");
  write(base + "/file", "x");
  EXPECT_THAT(refusal(base + "/file/a"), HasSubstr("cannot write '" + base + "/file/a': "));
  EXPECT_THAT(refusal(base + "/" + std::string(256, 'n')), HasSubstr("File name too long"));
  EXPECT_EQ(files_in(base), 1u);
}

TEST(AtomicFile, RefusesAnUnwritableDirectoryAndFile) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const test::TemporaryDirectory directory;
  const fs::path locked = directory.path() / "locked";
  write(locked, "x");
  ::chmod(locked.c_str(), 0400);
  EXPECT_THAT(message_of<OutputError>([&] { AtomicFile file(locked.string()); }),
              HasSubstr("it is write-protected"));
  ::chmod(directory.path().c_str(), 0500);
  const std::string inside = (directory.path() / "a").string();
  EXPECT_THAT(message_of<OutputError>([&] { AtomicFile file(inside); }), HasSubstr("Permission denied"));
  ::chmod(directory.path().c_str(), 0700);
}

// 4096 bytes stay in the buffer of the stream until it is closed: that is where the disk turns out to be
// full.
TEST(AtomicFile, AFullDiskIsNoticedHoweverLate) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory.path() / "a";
  for (const std::size_t size : {1001u, 4000u, 100'000u}) {
    const test::FileSizeLimit limit(1000);
    const std::string message = message_of<OutputError>([&] { write(path, std::string(size, 'x')); });
    EXPECT_EQ(message, "cannot write '" + path.string() + "': File too large") << size;
    EXPECT_EQ(files_in(directory.path()), 0u) << size;
  }
}

TEST(AtomicFile, AnErrorThatWasSwallowedFailsTheCommit) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory.path() / "a";
  {
    AtomicFile file(path.string());
    {
      const test::FileSizeLimit limit(1000);
      EXPECT_THROW(file.write(std::string(100'000, 'x')), OutputError);
    }
    EXPECT_THROW(file.commit(), OutputError);
  }
  EXPECT_EQ(files_in(directory.path()), 0u);
}

}  // namespace
}  // namespace umbral
