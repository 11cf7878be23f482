// Gives a target the files that are named, or that lie in the folders that are: the inputs that
// once were findings, and those that a search begins with. The program fails as the target does.
//
//   fuzz_NAME [--mutations COUNT SEED] FILE|FOLDER ...
//
// With mutations also so many changes of those files, as chance makes them: a search where there is
// no libFuzzer. The input that is tried lies in FOLDER/input of the folder that is printed first.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "fuzz/target.h"

namespace fs = std::filesystem;

namespace {

void run(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

std::vector<fs::path> files_of(const std::vector<std::string>& words) {
  std::vector<fs::path> files;
  for (const std::string& word : words) {
    if (!fs::is_directory(word)) {
      files.emplace_back(word);
      continue;
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(word)) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

std::string mutated(std::string input, std::mt19937_64& random) {
  for (std::size_t k = 1 + random() % 6; k > 0; --k) {
    const std::size_t at = random() % (input.size() + 1);
    const char byte = static_cast<char>(random());
    switch (random() % 4) {
      case 0:
        input.insert(at, 1 + random() % 5, byte);
        break;
      case 1:
        input.erase(at, random() % 8);
        break;
      default:
        if (at < input.size()) input[at] = byte;
    }
  }
  return input;
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::string> words(arguments + 1, arguments + count);
  std::size_t mutations = 0;
  std::mt19937_64 random;
  if (words.size() > 2 && words[0] == "--mutations") {
    mutations = std::stoul(words[1]);
    random.seed(std::stoul(words[2]));
    words.erase(words.begin(), words.begin() + 3);
    std::printf("%s\n", lsos::test::scratch_folder().c_str());
    std::fflush(stdout);
  }
  std::vector<std::string> inputs;
  for (const fs::path& file : files_of(words)) {
    std::ifstream in(file, std::ios::binary);
    if (!in.is_open()) {
      std::fprintf(stderr, "%s: cannot be read\n", file.c_str());
      return 1;
    }
    inputs.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    std::fprintf(stderr, "%s\n", file.c_str());  // the last one is the finding
    run(inputs.back());
  }
  if (inputs.empty()) return 1;
  for (std::size_t k = 0; k < mutations; ++k) {
    const std::string input = mutated(inputs[random() % inputs.size()], random);
    lsos::test::write_scratch("input", input);
    run(input);
  }
  std::printf("%zu inputs\n", inputs.size() + mutations);
  return 0;
}
