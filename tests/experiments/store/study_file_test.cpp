// The study file itself: what is none, what cannot be written, what a closed one is.
// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include "experiments/store/read_only_file.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::study_file_test {

TEST(StudyFile, WhatIsNoStudyIsRefusedAndLeftAlone) {
  const TemporaryFolder folder;
  const std::string text =
      folder.write("a.txt", "a text that is long enough to be looked at").string();
  const std::string other =
      plain_database(folder / "other.sqlite", "CREATE TABLE t (x); INSERT INTO t VALUES (1)");
  const std::string marked = plain_database(
      folder / "marked.sqlite", "PRAGMA application_id = 252006675; CREATE TABLE t (x)");
  const std::vector<std::pair<std::string, std::string>> cases{
      {text, text + ": expected an Impetus study, got a file that is no SQLite database"},
      {other, other + ": expected an Impetus study, got a database of another program"},
      {marked, marked + ": expected an Impetus study, got a database of another program"}};
  for (const auto& [path, sentence] : cases) {
    const std::string before = text_of(path);
    EXPECT_EQ(open_refusal(path), sentence);
    EXPECT_EQ(read_refusal(path), sentence);
    EXPECT_EQ(text_of(path), before);
  }
}

TEST(StudyFile, AStudyOfALaterSchemaIsRefused) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  opened(path);
  plain_database(path, "PRAGMA user_version = 14");
  const std::string sentence =
      path + ": expected a study of schema version 1 to 13, got version 14, which " + kTestBuild +
      " made";
  EXPECT_EQ(open_refusal(path), sentence);
  EXPECT_EQ(read_refusal(path), sentence);
}

TEST(StudyFile, AStudyThatLacksATableOrAViewIsRefused) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  const std::string whole = path + ": expected a study that is whole, but ";
  opened(path);
  plain_database(path, "CREATE VIEW own AS SELECT 1");
  EXPECT_EQ(read_refusal(path), "accepted");  // what somebody added is in nobody's way
  EXPECT_EQ(open_refusal(path), "accepted");
  plain_database(path, "DROP VIEW rated_trial");
  EXPECT_EQ(open_refusal(path), whole + "the view rated_trial is missing");
  EXPECT_EQ(read_refusal(path), whole + "the view rated_trial is missing");
  plain_database(path, "DROP TABLE collision_truth");
  EXPECT_EQ(open_refusal(path), whole + "the table collision_truth is missing");
  StudyFile::open_as_it_is(path);
}

TEST(StudyFile, AnOlderStudyThatCannotBeBroughtToThePresentSchemaIsNamed) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "old.sqlite";
  std::filesystem::copy_file(source_file("tests/recordings/causality.sqlite"), path);
  std::filesystem::permissions(path, std::filesystem::perms::owner_write,
                               std::filesystem::perm_options::add);
  plain_database(path, "DROP TABLE collision");
  EXPECT_EQ(read_refusal(path), path.string() +
                                    ": expected an Impetus study that can be read: no such table: "
                                    "collision");
}

TEST(StudyFile, AMissingFileIsRefusedForReadingAndNotMade) {
  const TemporaryFolder folder;
  const std::string path = (folder / "none.sqlite").string();
  EXPECT_EQ(read_refusal(path), path + ": expected an Impetus study, but there is no such file");
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(open_refusal(folder / "no/folder.sqlite"),
            (folder / "no/folder.sqlite").string() +
                ": expected a file that can be written, but it cannot be: No such file or "
                "directory");
}

TEST(StudyFile, AStudyItsLogAndItsJournalAreFiles) {
  const TemporaryFolder folder;
  const std::string words =
      ": expected a file of an Impetus study, got something that is not a file";
  const std::string pipe = folder / "pipe.sqlite";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(read_refusal(pipe), pipe + words);
  EXPECT_EQ(open_refusal(pipe), pipe + words);
  EXPECT_EQ(read_refusal(folder.path()), folder.path().string() + words);
  const std::string path = folder / "a.sqlite";
  opened(path);
  for (const std::string suffix : {"-wal", "-journal"}) {
    ASSERT_EQ(mkfifo((path + suffix).c_str(), 0600), 0);
    EXPECT_EQ(read_refusal(path), path + suffix + words);
    EXPECT_EQ(open_refusal(path), path + suffix + words);
    std::filesystem::remove(path + suffix);
  }
  EXPECT_EQ(read_refusal(path), "accepted");
}

TEST(StudyFile, AProcessKilledBeforeTheSchemaWasWrittenLeavesAFileThatCanBeUsed) {
  const TemporaryFolder folder;
  const std::filesystem::path empty = folder.write("empty.sqlite", "");
  const std::filesystem::path begun =
      plain_database(folder / "begun.sqlite", "PRAGMA journal_mode = WAL");
  ASSERT_GT(std::filesystem::file_size(begun), 0U);
  for (const std::filesystem::path& path : {empty, begun}) {
    EXPECT_EQ(read_refusal(path), path.string() + ": expected an Impetus study, got an empty file");
    EXPECT_EQ(open_refusal(path), "accepted");
    EXPECT_EQ(value_of(path, "SELECT build FROM study"), kTestBuild);
  }
}

TEST(StudyFile, AReadOnlyFileIsRefusedForWritingAndCanBeRead) {
  const OpenFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  opened(path);
  std::filesystem::permissions(path, std::filesystem::perms(0444));
  EXPECT_EQ(in_child([&] {
              become_nobody();
              return open_refusal(path) + "\n" + read_refusal(path);
            }),
            path + ": expected a file that can be written, but it cannot be: Permission denied\n" +
                "accepted");
}

TEST(StudyFile, AReadOnlyFolderIsRefusedForWriting) {
  const OpenFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  const std::string fresh = (folder / "b.sqlite").string();
  opened(path);
  std::filesystem::permissions(path, std::filesystem::perms(0666));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  EXPECT_EQ(in_child([&] {
              become_nobody();
              return open_refusal(path) + "\n" + open_refusal(fresh);
            }),
            path +
                ": expected a folder that can be written, for the study's log beside it, but "
                "it cannot be: Permission denied\n" +
                fresh +
                ": expected a file that can be written, but it cannot be: Permission denied");
}

/// Leaves a change half-written that a process which died had begun, with pages of it in the file.
void die_in_a_change(const std::filesystem::path& path) {
  in_child([&] {
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
    database.exec("PRAGMA cache_size = 1; PRAGMA cache_spill = 1; BEGIN");
    database.exec("UPDATE study SET build = 'half-written'");
    database.exec("CREATE TABLE filler (text TEXT)");
    for (int row = 0; row < 200; ++row) {
      database.exec("INSERT INTO filler VALUES (hex(randomblob(500)))");
    }
    _exit(0);
    return std::string();
  });
}

TEST(StudyFile, AHalfWrittenChangeIsNeverReadAsData) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.sqlite";
  opened(path);
  die_in_a_change(path);
  const std::string journal = path + "-journal";
  ASSERT_GT(std::filesystem::file_size(journal), 0U);
  EXPECT_EQ(read_refusal(path),
            path + ": expected a study whose changes are whole, but " + journal +
                " holds one that a program left half-written; `sqlite3 " + path +
                " .tables`, where the file can be written, takes it back");
  EXPECT_EQ(open_refusal(path), "accepted");  // writing takes it back
  EXPECT_EQ(read_refusal(path), "accepted");
  EXPECT_EQ(value_of(path, "SELECT build FROM study"), kTestBuild);
}

TEST(StudyFile, TheLogOfAStudyIsFoundThroughALinkToo) {
  const OpenFolder folder;
  const OpenFolder links;
  const std::string path = folder / "a.sqlite";
  in_child([&] {  // killed: the log stays
    const StudyFile study = opened(path);
    _exit(0);
    return std::string();
  });
  ASSERT_TRUE(has_log(path));
  const std::string link = links / "b.sqlite";
  std::filesystem::create_symlink(path, link);
  EXPECT_TRUE(has_log(link));
  std::filesystem::remove(path + "-shm");
  std::filesystem::permissions(path, std::filesystem::perms(0444));
  std::filesystem::permissions(path + "-wal", std::filesystem::perms(0444));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  EXPECT_NE(in_child([&] {
              become_nobody();
              return read_refusal(link);
            }),
            "accepted");
}

TEST(StudyFile, ANewStudyIsNotMadeBesideTheLogOfAnother) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.sqlite";
  folder.write("a.sqlite-wal", "of another");
  EXPECT_EQ(open_refusal(path),
            path + ": expected nothing of an earlier study of this name, but " + path +
                "-wal is there, which would be read as a part of the new one; move it away");
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(text_of(path + "-wal"), "of another");
}

TEST(StudyFile, ASecondProcessIsRefusedWhileTheFirstHasTheFile) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  {
    const StudyFile study = opened(path);
    EXPECT_EQ(in_child([&] { return open_refusal(path); }),
              path + ": in use by another Impetus process; end that session first");
  }
  EXPECT_EQ(in_child([&] { return open_refusal(path); }), "accepted");
}

TEST(StudyFile, IsOneFileOnceClosed) {
  const TemporaryFolder folder;
  {
    EnrolledStudy at(folder / "a.sqlite");
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.save(recorded_attempts()[0]);
    writer.end("quit");
    EXPECT_TRUE(std::filesystem::exists(folder / "a.sqlite-wal"));
  }
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.push_back(entry.path().filename());
  }
  EXPECT_EQ(names, std::vector<std::string>{"a.sqlite"});
  // Bytes 18 and 19 of SQLite's header: 2 would ask every reader for a folder it may write in.
  EXPECT_EQ(text_of(folder / "a.sqlite").substr(18, 2), "\x01\x01");
}

}  // namespace impetus::study_file_test
