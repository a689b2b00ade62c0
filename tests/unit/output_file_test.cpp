#include "skydrop/core/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <climits>
#include <csignal>

#include "skydrop/core/file.h"
#include "support/as_nobody.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::core {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
 protected:
  // Everything in the folder, temporary files included.
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), {}));
  }
  static mode_t modeOf(const fs::path& file) {
    struct stat status {};
    EXPECT_EQ(::lstat(file.c_str(), &status), 0) << file;
    return status.st_mode;
  }
  std::string refusal(const fs::path& path) {
    return test::refusalOf<DataError>([&] { OutputFile{path}; });
  }
  std::string cannotWrite(const fs::path& path, const char* reason) {
    return path.string() + ": cannot write: " + reason;
  }

  test::TemporaryFolder folder;
};

// A pipe's end to read from that never waits.
class Reader {
 public:
  explicit Reader(const fs::path& pipe)
      : descriptor_(::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~Reader() { ::close(descriptor_); }
  std::string read() const {
    char text[4096];
    const ssize_t count = ::read(descriptor_, text, sizeof text);
    return count > 0 ? std::string(text, static_cast<std::size_t>(count)) : "";
  }

 private:
  int descriptor_;
};

TEST_F(OutputFileTest, openingLeavesEverythingAsItWasAndWritingReplaces) {
  const fs::path old = folder.write("old", "old content"), fresh = folder.path() / "fresh";
  OutputFile toOld(old), toFresh(fresh);
  EXPECT_EQ(readTextFile(old), "old content");
  EXPECT_FALSE(fs::exists(fresh));
  EXPECT_EQ(entries(), 1u);
  for (const char* text : {"a long first text", "second"}) {
    toOld.write(text);
    toFresh.write(text);
    EXPECT_EQ(readTextFile(old), text);
    EXPECT_EQ(readTextFile(fresh), text);
  }
  EXPECT_EQ(entries(), 2u);
}

TEST_F(OutputFileTest, whatCannotBeWrittenIsRefusedByThePathAskedFor) {
  const fs::path file = folder.write("file", "x"), loop = folder.path() / "loop";
  fs::create_symlink(loop, loop);
  fs::create_symlink(folder.path() / "nowhere" / "a", folder.path() / "astray");
  const std::string tooLong(NAME_MAX + 1, 'n');
  EXPECT_EQ(refusal("/nonexistent/a.md"), cannotWrite("/nonexistent/a.md", "No such file or directory"));
  EXPECT_EQ(refusal(folder.path()), cannotWrite(folder.path(), "is a folder"));
  EXPECT_EQ(refusal(folder.path() / "new/"), cannotWrite(folder.path() / "new/", "is a folder"));
  EXPECT_EQ(refusal(file / "inner"), cannotWrite(file / "inner", "Not a directory"));
  EXPECT_EQ(refusal(loop), cannotWrite(loop, "Too many levels of symbolic links"));
  EXPECT_EQ(refusal(folder.path() / "astray"),
            cannotWrite(folder.path() / "astray", "No such file or directory"));
  EXPECT_EQ(refusal(folder.path() / tooLong), cannotWrite(folder.path() / tooLong, "File name too long"));
  EXPECT_EQ(refusal("/proc/a"), cannotWrite("/proc/a", "No such file or directory"));
  EXPECT_EQ(refusal("/dev/fd/917"), cannotWrite("/dev/fd/917", "No such file or directory"));
  EXPECT_NE(refusal(""), "");
}

TEST_F(OutputFileTest, theLongestNameIsWritten) {
  // A temporary name made by adding to it would not fit.
  const fs::path file = folder.path() / std::string(NAME_MAX, 'n');
  for (const char* text : {"first", "second"}) {
    OutputFile(file).write(text);
    EXPECT_EQ(readTextFile(file), text);
  }
}

TEST_F(OutputFileTest, symbolicLinksStayAndTheirTargetsAreReplaced) {
  // Chains, relative ones, and one whose target is missing yet.
  fs::create_directory(folder.path() / "inner");
  const fs::path target = folder.write("inner/target", "old"), link = folder.path() / "link",
                 chain = folder.path() / "chain", fresh = folder.path() / "fresh";
  fs::create_symlink("inner/target", link);
  fs::create_symlink("link", chain);
  fs::create_symlink("inner/fresh", fresh);
  OutputFile(chain).write("new");
  OutputFile(fresh).write("made");
  EXPECT_TRUE(fs::is_symlink(link) && fs::is_symlink(chain) && fs::is_symlink(fresh));
  EXPECT_EQ(readTextFile(target), "new");
  EXPECT_EQ(readTextFile(folder.path() / "inner" / "fresh"), "made");
}

TEST_F(OutputFileTest, permissionsAreKept) {
  const fs::path file = folder.write("file", "old");
  for (const mode_t mode : {0600u, 0644u, 0660u, 0755u}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    OutputFile(file).write("new");
    EXPECT_EQ(modeOf(file) & 07777, mode);
  }
  const mode_t before = ::umask(027);
  OutputFile(folder.path() / "fresh").write("x");
  ::umask(before);
  EXPECT_EQ(modeOf(folder.path() / "fresh") & 07777, 0640u);
}

TEST_F(OutputFileTest, theOwnerIsKeptWhereTheSystemAllows) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root gives files away";
  const fs::path file = folder.write("file", "old");
  ASSERT_EQ(::chown(file.c_str(), 1234, 2345), 0);
  OutputFile(file).write("new");
  struct stat status {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 1234u);
  EXPECT_EQ(status.st_gid, 2345u);
}

TEST_F(OutputFileTest, otherHardLinksKeepTheOldContent) {
  // Backups made of hard links rely on it.
  const fs::path file = folder.write("file", "old"), other = folder.path() / "other";
  fs::create_hard_link(file, other);
  OutputFile(file).write("new");
  EXPECT_EQ(readTextFile(file), "new");
  EXPECT_EQ(readTextFile(other), "old");
}

TEST_F(OutputFileTest, aReadOnlyFileIsRefusedAndAReadOnlyFolderIsWrittenInto) {
  // The file's own permission decides, not that of its folder.
  const fs::path locked = folder.write("locked", "old"), free = folder.write("free", "a long old content");
  ASSERT_EQ(::chmod(locked.c_str(), 0444), 0);
  ASSERT_EQ(::chmod(free.c_str(), 0666), 0);
  ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
  {
    const test::AsNobody nobody;
    EXPECT_EQ(refusal(locked), cannotWrite(locked, "Permission denied"));
  }
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  {
    const test::AsNobody nobody;
    EXPECT_EQ(refusal(folder.path() / "fresh"), cannotWrite(folder.path() / "fresh", "Permission denied"));
    OutputFile out(free);
    EXPECT_EQ(readTextFile(free), "a long old content");
    for (const char* text : {"short", "and something longer than that"}) {
      out.write(text);
      EXPECT_EQ(readTextFile(free), text);
    }
    out.append("again");
    out.append(" and more");
    EXPECT_EQ(readTextFile(free), "again and more");
  }
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
  EXPECT_EQ(entries(), 2u);
}

TEST_F(OutputFileTest, aFileOfAnotherOwnerInASharedFolderIsWrittenInPlace) {
  // In a sticky folder (/tmp) a file may be written that may not be replaced.
  if (::geteuid() != 0) GTEST_SKIP() << "needs two users";
  const fs::path file = folder.write("file", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0666), 0);
  ASSERT_EQ(::chmod(folder.path().c_str(), 01777), 0);
  {
    const test::AsNobody nobody;
    OutputFile(file).write("new");
  }
  EXPECT_EQ(readTextFile(file), "new");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, aDeviceStaysADevice) {
  const fs::path null = folder.path() / "mynull";
  if (::mknod(null.c_str(), S_IFCHR | 0666, 0x103) != 0) GTEST_SKIP() << "may not make devices";
  OutputFile(null).write("x");
  EXPECT_TRUE(S_ISCHR(modeOf(null)));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, aFullDeviceIsAnError) {
  OutputFile full("/dev/full");
  EXPECT_TRUE(full.isStream());
  EXPECT_EQ(test::refusalOf<DataError>([&] { full.write("x"); }),
            cannotWrite("/dev/full", "No space left on device"));
}

TEST_F(OutputFileTest, aNamedPipeIsWrittenToOnceItHasAReader) {
  // Without one it is refused: to wait could be for ever. It stays a pipe, and is open from the start, so
  // that its reader sees one stream.
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(refusal(pipe), cannotWrite(pipe, "nobody reads from this pipe"));
  {
    const Reader reader(pipe);
    OutputFile out(pipe);
    out.write("one ");
    out.append("two");
    EXPECT_EQ(reader.read(), "one two");
  }
  EXPECT_TRUE(S_ISFIFO(modeOf(pipe)));
}

TEST_F(OutputFileTest, aPipeWhoseReaderLeftIsAnError) {
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  auto* before = std::signal(SIGPIPE, SIG_IGN);
  auto reader = std::make_unique<Reader>(pipe);
  OutputFile out(pipe);
  reader.reset();
  EXPECT_EQ(test::refusalOf<DataError>([&] { out.write("x"); }), cannotWrite(pipe, "Broken pipe"));
  std::signal(SIGPIPE, before);
}

TEST_F(OutputFileTest, descriptorsOfTheProgramAreWrittenToAsTheyAre) {
  // By every name, also where their file could not be opened again, as that of another user's terminal or
  // pipe; a file is added to where the descriptor stands, and a link to one is followed.
  int ends[2];
  ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
  const std::string number = std::to_string(ends[1]);
  const fs::path link = folder.path() / "link";
  fs::create_symlink("/dev/fd/" + number, link);
  for (const fs::path& path : {fs::path("/dev/fd/" + number), fs::path("/proc/self/fd/" + number),
                               fs::path("/proc/" + std::to_string(::getpid()) + "/fd/" + number), link}) {
    OutputFile(path).write("x");
    char text[8];
    EXPECT_EQ(::read(ends[0], text, sizeof text), 1) << path;
  }
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(refusal("/dev/fd/" + std::to_string(ends[0])),
            cannotWrite("/dev/fd/" + std::to_string(ends[0]), "Bad file descriptor"))
      << "it is open for reading only";
  ::close(ends[0]);
  ::close(ends[1]);

  const fs::path file = folder.write("file", "");
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_EQ(::write(descriptor, "before ", 7), 7);
  OutputFile("/dev/fd/" + std::to_string(descriptor)).write("after");
  ::close(descriptor);
  EXPECT_EQ(readTextFile(file), "before after");
}

TEST_F(OutputFileTest, aDashIsStandardOutput) {
  OutputFile out("-");
  EXPECT_TRUE(out.isStandardOutput());
  EXPECT_TRUE(OutputFile("/dev/stdout").isStandardOutput());
  EXPECT_EQ(out.path(), "standard output");
}

TEST_F(OutputFileTest, whatGrowsIsOnTheDiskAfterEachAddition) {
  // The old content stands until there is a new one.
  const fs::path file = folder.write("file", "old");
  OutputFile out(file);
  EXPECT_EQ(readTextFile(file), "old");
  out.append("one\n");
  EXPECT_EQ(readTextFile(file), "one\n");
  out.append("two\n");
  EXPECT_EQ(readTextFile(file), "one\ntwo\n");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, aFullDiskKeepsTheOldContentAndWholeAdditions) {
  // A limit on the size of files fills up as a disk does.
  const fs::path file = folder.write("file", "old"), growing = folder.path() / "growing";
  auto* before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  const rlimit small{100, old.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  OutputFile out(growing);
  out.append(std::string(60, 'a'));
  const std::string refusals =
      test::refusalOf<DataError>([&] { out.append(std::string(60, 'b')); }) +
      test::refusalOf<DataError>([&] { OutputFile(file).write(std::string(200, 'c')); });
  out.append(std::string(40, 'd'));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
  std::signal(SIGXFSZ, before);
  EXPECT_EQ(refusals, cannotWrite(growing, "File too large") + cannotWrite(file, "File too large"));
  EXPECT_EQ(readTextFile(file), "old");
  EXPECT_EQ(readTextFile(growing), std::string(60, 'a') + std::string(40, 'd'));
  EXPECT_EQ(entries(), 2u);
}

TEST_F(OutputFileTest, foldersAreJudgedWithoutBeingMade) {
  const fs::path file = folder.write("file", "x");
  const auto refusalOf = [](const fs::path& path) {
    return test::refusalOf<DataError>([&] { requireFolder(path); });
  };
  EXPECT_EQ(refusalOf(folder.path()), "");
  EXPECT_EQ(refusalOf(folder.path() / "new" / "inner/"), "");
  EXPECT_EQ(refusalOf(file), file.string() + ": cannot make the folder: File exists");
  EXPECT_EQ(refusalOf(file / "inner"),
            (file / "inner").string() + ": cannot make the folder: Not a directory");
  EXPECT_NE(refusalOf("/proc/skydrop"), "");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, filesSetAsideNeverReplaceOneAnother) {
  for (const char* name : {"a.bad", "a.bad2", "a.bad3"}) {
    EXPECT_EQ(setAside(folder.write("a", name)), folder.path() / name);
  }
  for (const char* name : {"a.bad", "a.bad2", "a.bad3"}) EXPECT_EQ(readTextFile(folder.path() / name), name);
  EXPECT_EQ(entries(), 3u);
  EXPECT_THROW(setAside(folder.path() / "a"), DataError);
}

}  // namespace
}  // namespace skydrop::core
