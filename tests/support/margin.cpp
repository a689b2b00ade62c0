#include "support/margin.h"

#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "support/paths.h"

namespace skydrop::test {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

struct Figure {
  Limit limit{};
  double figure = 0;
  double margin = kEndless;
  std::int64_t checks = 0;
  double leastLimit = kEndless, mostLimit = -kEndless;  // a limit may depend on what is measured
};

// Figures of the test that runs, by rows and line.
class Figures : public testing::EmptyTestEventListener {
 public:
  static Figures& ofThisTest() {
    static auto* figures = [] {
      auto* made = new Figures;  // GoogleTest's
      testing::UnitTest::GetInstance()->listeners().Append(made);
      return made;
    }();
    return *figures;
  }

  void note(const char* ids, const std::source_location& place, double figure, const Limit& limit,
            const char* unit) {
    const double margin = stability::marginOf(figure, limit);
    const std::scoped_lock lock(mutex_);
    Figure& row = figures_[{ids, place.line(), unit}];
    if (row.checks++ == 0 || margin < row.margin) {
      row.limit = limit;
      row.figure = figure;
      row.margin = margin;
    }
    row.leastLimit = std::min(row.leastLimit, limit.value);
    row.mostLimit = std::max(row.mostLimit, limit.value);
  }

  void noteFaults(const char* ids, const char* what) {
    const std::scoped_lock lock(mutex_);
    faults_[ids] = what;
  }

  void OnTestEnd(const testing::TestInfo& test) override {
    const std::scoped_lock lock(mutex_);
    if ((!figures_.empty() || !faults_.empty()) && !test.result()->Skipped()) write(test);
    figures_.clear();
    faults_.clear();
  }

 private:
  static void append(nlohmann::json& all, const std::string& ids, const nlohmann::json& row) {
    std::istringstream words(ids);
    for (std::string id; words >> id;) {
      all.push_back(row);
      all.back()["id"] = id;
    }
  }

  void write(const testing::TestInfo& test) const {
    nlohmann::json all = nlohmann::json::array();
    for (const auto& [key, row] : figures_) {
      nlohmann::json json = {{"unit", std::get<2>(key)}, {"sense", stability::signOf(row.limit.sense)},
                             {"figure", row.figure},     {"limit", row.limit.value},
                             {"checks", row.checks},     {"isFixed", row.leastLimit == row.mostLimit},
                             {"margin", row.margin}};  // what is endless or no number is written as null
      append(all, std::get<0>(key), json);
    }
    int failed = 0;
    for (int i = 0; i < test.result()->total_part_count(); ++i)
      failed += test.result()->GetTestPartResult(i).failed();
    for (const auto& [ids, what] : faults_)
      append(all, ids, {{"unit", what}, {"sense", "="}, {"figure", failed}, {"limit", 0}, {"isFixed", true}});
    std::string name = std::string(test.test_suite_name()) + "." + test.name();
    const std::string full = name;
    const char* backend = std::getenv("SKYDROP_TEST_BACKEND");
    if (backend) name += std::string(".") + backend;
    for (char& c : name) c = c == '/' ? '_' : c;
    const nlohmann::json file = {{"test", full}, {"backend", backend ? backend : ""}, {"figures", all}};
    std::error_code ignored;
    std::filesystem::create_directories(marginFolder(), ignored);
    std::ofstream stream(marginFolder() / (name + ".json"));
    stream << file.dump(1) << '\n';
    EXPECT_TRUE(stream.flush().good()) << "figures of " << name << " cannot be kept in " << marginFolder();
  }

  std::mutex mutex_;
  // Ids and units are literals, so that those of one line are the same pointers.
  std::map<std::tuple<const char*, std::uint_least32_t, const char*>, Figure> figures_;
  std::map<std::string, std::string> faults_;
};

}  // namespace

testing::AssertionResult holds(const char* ids, double figure, const Limit& limit, const char* unit,
                               const std::source_location& place) {
  Figures::ofThisTest().note(ids, place, figure, limit, unit);
  if (stability::keeps(figure, limit)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << ids << ": " << figure << ' ' << unit << ", must be "
                                     << stability::signOf(limit.sense) << ' ' << limit.value;
}

testing::AssertionResult holdsLive(const char* id) {
  for (const stability::LiveCheck& check : stability::liveChecksOf(id)) {
    const double figure = check.measure();
    if (!holds(check.id, figure, check.limit, check.unit)) {
      return testing::AssertionFailure()
             << id << ": " << check.what << ": " << figure << ' ' << check.unit << ", must be "
             << stability::signOf(check.limit.sense) << ' ' << check.limit.value;
    }
  }
  return testing::AssertionSuccess();
}

void noFaults(const char* ids, const char* what) { Figures::ofThisTest().noteFaults(ids, what); }

std::filesystem::path marginFolder() {
  const char* folder = std::getenv("SKYDROP_TEST_MARGINS");
  return folder ? std::filesystem::path(folder) : std::filesystem::path(binaryDir()) / "tests/margins";
}

}  // namespace skydrop::test
