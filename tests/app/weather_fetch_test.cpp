// Weather from services, against a server on this machine that answers well and badly.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/forecast/kept_answers.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"
#include "support/weather_server.h"

namespace skydrop::forecast {
namespace {

class WeatherFetch : public test::WeatherServerTest {
 protected:
  std::string refusal(const std::string& path) const {
    return test::refusalOf<core::DataError>([&] { fetch(at(path), {}, limits()); });
  }
};

TEST_F(WeatherFetch, anAnswerArrivesPlainPackedRedirectedAndAfterFailures) {
  const std::string answer = core::readTextFile(test::sourceDir() + kAnswer);
  for (const char* path : {"/good", "/gzip", "/once", "/recovers"})
    EXPECT_EQ(fetch(at(path), {}, limits()).body, answer) << path;
}

TEST_F(WeatherFetch, whatTheServerDoesWrongIsOneLineThatNamesIt) {
  const std::pair<const char*, const char*> wrongs[] = {{"/short", ""},
                                                        {"/stalls", "3 attempts"},
                                                        {"/silent", "3 attempts"},
                                                        {"/endless", "more than 1048576 bytes"},
                                                        {"/bomb", "more than 1048576 bytes"},
                                                        {"/notgzip", ""},
                                                        {"/circle", "redirects"},
                                                        {"/away", ""},
                                                        {"/busy", "status 429 (3 attempts)"},
                                                        {"/error", "status 500 (3 attempts)"},
                                                        {"/refuses", "status 400"},
                                                        {"/nothttp", ""},
                                                        {"/none", "status 404"}};
  for (const auto& [path, what] : wrongs) {
    const auto begin = std::chrono::steady_clock::now();
    const std::string line = refusal(path);
    EXPECT_TRUE(test::isOneLineAbout(line, std::string("127.0.0.1:") + port_ + path)) << path << ": " << line;
    EXPECT_NE(line.find(what), std::string::npos) << line;
    EXPECT_EQ(line.find("latitude"), std::string::npos) << line;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20)) << path;
  }
  FetchRequest nobody = at("/good");
  nobody.url = "http://127.0.0.1:1/";
  EXPECT_TRUE(test::isOneLineAbout(test::refusalOf<core::DataError>([&] { fetch(nobody, {}, limits()); }),
                                   "127.0.0.1:1"));
}

TEST_F(WeatherFetch, whatIsNoWeatherIsNotKept) {
  const sky::Instant now = sky::parseInstant("2026-06-21T12:00Z");
  for (const char* path : {"/cut", "/garbage"}) {
    const std::string line =
        test::refusalOf<core::DataError>([&] { renew(folder_.path() / "kept", at(path), now, limits()); });
    EXPECT_TRUE(test::isOneLineAbout(line, path)) << line;
    EXPECT_FALSE(keptAnswer(folder_.path() / "kept", at(path)));
  }
}

TEST_F(WeatherFetch, whatIsTheNewestIsNotSentTwice) {
  const std::filesystem::path kept = folder_.path() / "kept";
  const sky::Instant first = sky::parseInstant("2026-06-21T12:00Z"),
                     later = sky::parseInstant("2026-06-21T15:00Z");
  const KeptAnswer answer = renew(kept, at("/tagged"), first, limits());
  EXPECT_EQ(answer.validators.etag, "\"v1\"");
  EXPECT_EQ(keptAnswer(kept, at("/tagged"))->fetched, first);
  const KeptAnswer again = renew(kept, at("/tagged"), later, limits());
  EXPECT_EQ(again.file, answer.file);
  EXPECT_EQ(keptAnswer(kept, at("/tagged"))->fetched, later) << "it is known to be the newest since then";
  EXPECT_EQ(core::readTextFile(again.file), core::readTextFile(test::sourceDir() + kAnswer));
  // What was damaged is fetched whole.
  core::writeFileAtomically(again.file, std::string_view("{}"));
  EXPECT_FALSE(keptAnswer(kept, at("/tagged")));
  renew(kept, at("/tagged"), later, limits());
  EXPECT_EQ(core::readTextFile(again.file), core::readTextFile(test::sourceDir() + kAnswer));
  // And what is there stays when the server fails.
  FetchRequest failing = at("/tagged");
  server_.reset();
  EXPECT_NE(test::refusalOf<core::DataError>([&] { renew(kept, failing, later, limits()); }), "");
  EXPECT_TRUE(keptAnswer(kept, failing));
}

TEST_F(WeatherFetch, theKeyIsInNoMessage) {
  FetchRequest request = at("/error");
  request.provider = Provider::meteoblue;
  request.key = "s3cretK3y";
  const std::string line = test::refusalOf<core::DataError>([&] { fetch(request, {}, limits()); });
  EXPECT_NE(line, "");
  EXPECT_EQ(line.find("s3cret"), std::string::npos) << line;
  request.key = "with space&x=1";
  const std::string odd = test::refusalOf<core::RangeError>([&] { addressOf(request); });
  EXPECT_EQ(odd, "meteoblue needs a key of letters and digits");
}

TEST(WeatherKey, aKeyFileIsReadByItsOwnerAlone) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("key", "abc123\n");
  ::chmod(file.c_str(), 0644);
  EXPECT_TRUE(test::isOneLineAbout(test::refusalOf<core::DataError>([&] { readKey(file); }),
                                   "may be read by others than its owner"));
  ::chmod(file.c_str(), 0600);
  EXPECT_EQ(readKey(file), "abc123");
  const std::string odd = folder.write("odd", "!hidden words\n");
  ::chmod(odd.c_str(), 0600);
  const std::string line = test::refusalOf<core::DataError>([&] { readKey(odd); });
  EXPECT_EQ(line.find("hidden"), std::string::npos) << line;
  unsetenv("SKYDROP_METEOBLUE_KEY");
  EXPECT_NE(test::refusalOf<core::DataError>([&] { readKey(std::nullopt); }), "");
  setenv("SKYDROP_METEOBLUE_KEY", "fromEnvironment1", 1);
  EXPECT_EQ(readKey(std::nullopt), "fromEnvironment1");
  unsetenv("SKYDROP_METEOBLUE_KEY");
}

TEST(WeatherAddress, onlySafeAddressesAreAsked) {
  FetchRequest request;
  EXPECT_TRUE(addressOf(request).starts_with("https://api.open-meteo.com/v1/forecast?"));
  for (const char* url : {"http://api.open-meteo.com/", "ftp://127.0.0.1/", "file:///etc/passwd",
                          "http://127.0.0.1.example.com/", "http://127.0.0.1@example.com/", "https://a@b.c/",
                          "https://a.b/c?d=e", "https://a.b/c d"}) {
    request.url = url;
    EXPECT_NE(test::refusalOf<core::RangeError>([&] { addressOf(request); }), "") << url;
  }
  request.url = "";
  request.provider = Provider::metar;
  request.station = "LSZB&x";
  EXPECT_NE(test::refusalOf<core::RangeError>([&] { addressOf(request); }), "");
}

}  // namespace
}  // namespace skydrop::forecast
