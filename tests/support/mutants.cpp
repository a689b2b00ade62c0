#include "support/mutants.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

#include "skydrop/core/hash.h"

namespace skydrop::test {
namespace {

constexpr std::array<std::string_view, 10> kNumbers = {
    "0", "-1", "4294967296", "99999999999999999999", "1e999", "-1e-999", "0.5", "nan", "00", "1000000"};

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_{seed, 0} {}

  std::string mutant(std::string bytes) {
    switch (below(5)) {
      case 0:
        for (std::size_t n = 1 + below(4); n > 0; --n)
          bytes[below(bytes.size())] = static_cast<char>(below(256));
        break;
      case 1:
        setWord(bytes);
        break;
      case 2:
        bytes.erase(below(bytes.size()), 1 + below(16));
        break;
      case 3: {
        const std::string piece = bytes.substr(below(bytes.size()), 1 + below(64));
        bytes.insert(below(bytes.size()), piece);
        break;
      }
      default:
        setNumber(bytes);
    }
    return bytes;
  }

 private:
  std::size_t below(std::size_t limit) {
    return static_cast<std::size_t>(random_.next() % std::max<std::size_t>(limit, 1));
  }

  void setWord(std::string& bytes) {
    if (bytes.size() < 4) return;
    const std::size_t at = below(bytes.size() - 3);
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, 4);
    const std::uint32_t values[] = {
        0,          1,        0x7fffffff, 0x80000000, 0xffffffff,
        0x7fc00000, word + 1, word - 1,   word * 2,   static_cast<std::uint32_t>(bytes.size())};
    word = values[below(std::size(values))];
    std::memcpy(bytes.data() + at, &word, 4);
  }

  void setNumber(std::string& bytes) {
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size()));
    const auto first = std::find_if(from, bytes.end(), isDigit);
    const auto last = std::find_if_not(first, bytes.end(), isDigit);
    bytes.replace(first, last, kNumbers[below(kNumbers.size())]);
  }

  core::RandomStream random_;
};

}  // namespace

void forEachMutant(const std::string& good, int rounds, const std::function<void(const std::string&)>& use) {
  const std::size_t step = std::max<std::size_t>(good.size() / 24, 1);
  for (std::size_t size = 0; size < good.size(); size += step) use(good.substr(0, size));
  Mutator mutator(good.size());
  for (int round = 0; round < rounds && !good.empty(); ++round) use(mutator.mutant(good));
}

std::string writePlainly(const std::filesystem::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
  return file.string();
}

}  // namespace skydrop::test
